// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/parameters/sections.h>

#include <algorithm>
#include <optional>

namespace chaindrive::parameters
{
namespace
{
using Makers = std::map<std::string, std::function<std::unique_ptr<Section>()>>;

/// A function, so that it exists before the registrations of other sources.
Makers &makers_of_sections()
{
  static Makers makers;
  return makers;
}

std::map<std::string, Makers> &makers_of_sets()
{
  static std::map<std::string, Makers> sets;
  return sets;
}

std::string heading_of(const std::string &path) { return path.substr(0, path.find('/')); }
} // namespace

void register_section(const std::string                               &path,
                      const std::function<std::unique_ptr<Section>()> &make)
{
  makers_of_sections()[path] = make;
}

void register_section_of_set(const std::string                               &set,
                             const std::string                               &name,
                             const std::function<std::unique_ptr<Section>()> &make)
{
  makers_of_sets()[set][name] = make;
}

Sections::Sections(const std::string &set)
{
  for (const auto &[name, make] : makers_of_sets()[set])
    sections_[name] = make();
}

Sections::Sections()
{
  for (const auto &[path, make] : makers_of_sections())
    sections_[path] = make();
}

Sections::Sections(const Sections &other) { *this = other; }

Sections &Sections::operator=(const Sections &other)
{
  if (this == &other)
    return *this;
  sections_.clear();
  for (const auto &[path, section] : other.sections_)
    sections_[path] = section->clone();
  return *this;
}

void Sections::declare(Declarations &declarations)
{
  std::optional<Subsection> heading;
  std::string               open;
  for (const auto &[path, section] : sections_)
    {
      if (path.find('/') == std::string::npos)
        {
          const Subsection own(declarations, path);
          section->declare(declarations);
          continue;
        }
      if (const std::string next = heading_of(path); next != open)
        {
          heading.reset();
          heading.emplace(declarations, next);
          open = next;
        }
      const Subsection own(declarations, path.substr(open.size() + 1));
      section->declare(declarations);
    }
}

bool Sections::any_active() const
{
  return std::any_of(sections_.begin(), sections_.end(), [](const auto &section) {
    return section.second->is_active();
  });
}

std::vector<std::string> Sections::active(const std::string &heading) const
{
  std::vector<std::string> paths;
  for (const auto &[path, section] : sections_)
    if (heading_of(path) == heading && section->is_active())
      paths.push_back(path);
  return paths;
}

std::vector<std::string> Sections::inactive() const
{
  std::vector<std::string> paths;
  for (const auto &[path, section] : sections_)
    if (!section->is_active())
      paths.push_back(path);
  return paths;
}

bool is_heading_of_plugins(const std::string &name)
{
  return name == "Additions" || name == "Quantities";
}
} // namespace chaindrive::parameters
