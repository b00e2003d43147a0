// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/parameters/declarations.h>
#include <chaindrive/parameters/parameters.h>
#include <chaindrive/parameters/reader.h>
#include <chaindrive/parameters/study.h>
#include <chaindrive/parameters/writer.h>
#include <chaindrive/utilities/registry.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <ostream>
#include <sstream>

namespace chaindrive::parameters
{
namespace
{
std::vector<std::string> parts_of(const std::string &section)
{
  return dealii::Utilities::split_string_list(section, '/');
}

/// A bar would end a cell of a Markdown table.
std::string cell(const std::string &text)
{
  std::string escaped;
  for (const char c : text)
    escaped += c == '|' ? std::string("\\|") : std::string(1, c);
  return escaped;
}

/// What the loaded plug-ins have registered; nothing without any.
std::string documentation_of_plugins()
{
  std::string rows;
  for (const AnyRegistry *registry : AnyRegistry::all())
    for (const std::size_t i : registry->order())
      {
        const AnyRegistry::Entry &entry = registry->entries()[i];
        if (!entry.plugin.empty())
          rows += "| " + entry.plugin + " | " + registry->kind() + " | " + entry.about.name +
                  " | " + cell(entry.about.documentation) + " |\n";
      }
  return rows.empty() ? "" :
                        "\n## Plug-ins\n\n| Plug-in | Adds | Name | Meaning |\n"
                        "|---|---|---|---|\n" +
                            rows;
}
} // namespace

void change_section(std::ostream &out, std::vector<std::string> &open, const std::string &section)
{
  const std::vector<std::string> parts  = parts_of(section);
  const auto                     indent = [&] { return std::string(2 * open.size(), ' '); };

  const std::size_t common =
      std::mismatch(open.begin(), open.end(), parts.begin(), parts.end()).first - open.begin();
  while (open.size() > common)
    {
      open.pop_back();
      out << indent() << "end\n";
    }
  for (std::size_t i = common; i < parts.size(); ++i)
    {
      out << (i == 0 || i > common ? "" : "\n") << indent() << "subsection " << parts[i] << '\n';
      open.push_back(parts[i]);
    }
}

void write_prm(std::ostream                             &out,
               const Declarations                       &declarations,
               const std::map<std::string, std::string> &values,
               const bool                                documented)
{
  std::vector<std::string> open;
  for (const Entry &entry : declarations.entries())
    {
      if (open.empty() || parts_of(entry.section) != open)
        {
          if (!open.empty() && open.front() != parts_of(entry.section).front())
            {
              change_section(out, open, "");
              out << '\n';
            }
          change_section(out, open, entry.section);
        }
      else if (documented)
        out << '\n';

      const std::string indent(2 * open.size(), ' ');
      if (documented && entry.section != "Material" &&
          entry.meaning.find("prm/paper") != std::string::npos)
        out << indent << "# TO BE SET: the default is that of the motorcycle in prm/paper.\n";
      if (documented)
        for (const std::string &line : dealii::Utilities::break_text_into_lines(
                 entry.meaning + " Allowed: " + entry.allowed + ".", 96 - indent.size()))
          out << indent << "# " << line << '\n';
      const auto         given = values.find(entry.path());
      const std::string &value = given == values.end() ? entry.default_value : given->second;
      out << indent << "set " << entry.name << " =" << (value.empty() ? "" : " ") << value
          << (documented || value == entry.default_value ? "" :
                                                           " # default: " + entry.default_value)
          << '\n';
    }
  change_section(out, open, "");
}

void write_template(std::ostream &out)
{
  out << "# SPDX-License-Identifier: LGPL-2.1-or-later\n#\n# A roller chain drive: every entry "
         "that chaindrive knows, with its default. Entries that are\n# left out keep their "
         "defaults, so a file of your own needs only what differs.\n\n";
  Parameters   defaults;
  Declarations declarations;
  defaults.declare(declarations);
  write_prm(out, declarations, {}, true);
}

std::string parameter_documentation()
{
  Parameters   defaults, with_wheel;
  Study        study;
  Declarations usual, declarations;
  defaults.declare(usual);
  study.declare(usual);
  // sections that each further wheel has, under a name that stands for any
  with_wheel.drive.sprockets.list.push_back({"name", Role::idler, 17});
  with_wheel.declare(declarations);
  study.declare(declarations);
  std::ostringstream out;
  out << "# Parameters\n\nEvery entry of a `.prm` file, written by `chaindrive document`. Sections "
         "are\nnested (`Drive/Chain` is `subsection Chain` "
         "inside `subsection Drive`), an entry is set with\n`set Name = value`, and `#` starts a "
         "comment. The unit is part of the entry's name. Entries that\nare left out keep their "
         "defaults; with `auto` the program finds the value and states it in the\nlog. On the "
         "command line, `--set \"Section/Entry=value\"` overrides the file. Section `Study` is\n"
         "for study files only, see [prm/studies](../prm/studies/README.md). Sections called "
         "`name` "
         "are\nthose of each further wheel of `Drive/Wheels/Order of travel`.\n";
  std::string section;
  for (const Entry &with : declarations.entries())
    {
      const Entry *const as_usual = usual.find(with.section, with.name);
      if (as_usual == nullptr && with.section.find("/name") == std::string::npos)
        continue;
      const Entry &entry = as_usual == nullptr ? with : *as_usual;
      if (entry.section != section)
        out << "\n## " << entry.section
            << "\n\n| Entry | Default | Allowed | Meaning |\n|---|---|---|---|\n";
      section = entry.section;
      out << "| `" << entry.name << "` | "
          << (entry.default_value.empty() ? "(empty)" : "`" + entry.default_value + "`") << " | "
          << cell(entry.allowed) << " | " << cell(entry.meaning) << " |\n";
    }
  out << study_output_documentation();
  out << documentation_of_plugins();
  return out.str();
}
} // namespace chaindrive::parameters
