// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/parameters/catalogue.h>
#include <chaindrive/utilities/errors.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>

namespace chaindrive::parameters
{
namespace
{
/// Goes through what ParameterHandler prints of itself, which is the one place where it tells
/// names, patterns and documentation together.
void collect(const nlohmann::ordered_json &tree,
             const std::string            &section,
             std::vector<Entry>           &entries,
             std::vector<std::string>     &sections)
{
  if (!section.empty())
    sections.push_back(section);
  for (const auto &[name, node] : tree.items())
    if (node.contains("default_value"))
      entries.push_back({section,
                         name,
                         node["default_value"],
                         node["pattern_description"],
                         node["documentation"]});
    else
      collect(node, section.empty() ? name : section + "/" + name, entries, sections);
}
} // namespace

Catalogue::Catalogue(const dealii::ParameterHandler &prm)
{
  std::stringstream text;
  prm.print_parameters(
      text, dealii::ParameterHandler::JSON | dealii::ParameterHandler::KeepDeclarationOrder);
  collect(nlohmann::ordered_json::parse(text), "", entries_, sections_);
}

const Entry *Catalogue::find(const std::string &section, const std::string &name) const
{
  const auto entry = std::find_if(entries_.begin(), entries_.end(), [&](const Entry &e) {
    return e.section == section && e.name == name;
  });
  return entry == entries_.end() ? nullptr : &*entry;
}

bool Catalogue::has_section(const std::string &path) const
{
  return path.empty() || std::find(sections_.begin(), sections_.end(), path) != sections_.end();
}

std::vector<std::string> Catalogue::entry_names(const std::string &section) const
{
  std::vector<std::string> names;
  for (const Entry &entry : entries_)
    if (entry.section == section)
      names.push_back(entry.name);
  return names;
}

std::vector<std::string> Catalogue::section_names(const std::string &section) const
{
  const std::string        begin = section.empty() ? "" : section + "/";
  std::vector<std::string> names;
  for (const std::string &path : sections_)
    if (path.size() > begin.size() && path.compare(0, begin.size(), begin) == 0 &&
        path.find('/', begin.size()) == std::string::npos)
      names.push_back(path.substr(begin.size()));
  return names;
}

void set(dealii::ParameterHandler &prm,
         const Entry              &entry,
         const std::string        &value,
         const std::string        &where)
{
  const std::vector<std::string> path = dealii::Utilities::split_string_list(entry.section, '/');
  for (const std::string &name : path)
    prm.enter_subsection(name);
  bool allowed = true;
  try
    {
      prm.set(entry.name, value);
    }
  catch (const dealii::ParameterHandler::ExcValueDoesNotMatchPattern &)
    {
      allowed = false;
    }
  for (std::size_t i = 0; i < path.size(); ++i)
    prm.leave_subsection();
  if (!allowed)
    throw InputError(where + entry.path() + " = " + (value.empty() ? "(nothing)" : value) +
                     " is not allowed: it must be " + entry.allowed + ".");
}
} // namespace chaindrive::parameters
