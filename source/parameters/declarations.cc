// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/parameters/declarations.h>
#include <chaindrive/utilities/errors.h>

#include <algorithm>

namespace chaindrive::parameters
{
Entry &Declarations::add(const std::string                              &name,
                         const std::string                              &default_value,
                         const std::string                              &allowed,
                         const std::string                              &meaning,
                         const std::function<bool(const std::string &)> &accepts,
                         const std::function<void(const std::string &)> &store)
{
  entries_.push_back({open_, name, default_value, allowed, meaning, on_resume_, accepts, store});
  return entries_.back();
}

Subsection::Subsection(Declarations      &declarations,
                       const std::string &name,
                       const OnResume     on_resume)
    : declarations_(declarations)
    , outer_(declarations.open_)
    , outer_on_resume_(declarations.on_resume_)
{
  declarations.open_      = outer_.empty() ? name : outer_ + "/" + name;
  declarations.on_resume_ = on_resume;
  declarations.sections_.push_back(declarations.open_);
}

Subsection::~Subsection()
{
  declarations_.open_      = outer_;
  declarations_.on_resume_ = outer_on_resume_;
}

const Entry *Declarations::find(const std::string &section, const std::string &name) const
{
  const auto entry = std::find_if(entries_.begin(), entries_.end(), [&](const Entry &e) {
    return e.section == section && e.name == name;
  });
  return entry == entries_.end() ? nullptr : &*entry;
}

bool Declarations::has_section(const std::string &path) const
{
  return path.empty() || std::find(sections_.begin(), sections_.end(), path) != sections_.end();
}

std::vector<std::string> Declarations::entry_names(const std::string &section) const
{
  std::vector<std::string> names;
  for (const Entry &entry : entries_)
    if (entry.section == section)
      names.push_back(entry.name);
  return names;
}

std::vector<std::string> Declarations::section_names(const std::string &section) const
{
  const std::string        begin = section.empty() ? "" : section + "/";
  std::vector<std::string> names;
  for (const std::string &path : sections_)
    if (path.size() > begin.size() && path.compare(0, begin.size(), begin) == 0 &&
        path.find('/', begin.size()) == std::string::npos)
      names.push_back(path.substr(begin.size()));
  return names;
}

void set(const Entry &entry, const std::string &value, const std::string &where)
{
  if (!entry.accepts(value))
    throw InputError(where + entry.path() + " = " + (value.empty() ? "(nothing)" : value) +
                     " is not allowed: it must be " + entry.allowed + ".");
  entry.store(value);
}
} // namespace chaindrive::parameters
