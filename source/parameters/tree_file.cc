// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/parameters/drive.h>
#include <chaindrive/parameters/old_names.h>
#include <chaindrive/parameters/tree_file.h>
#include <chaindrive/parameters/writer.h>
#include <chaindrive/utilities/errors.h>

#include <deal.II/base/utilities.h>

#define BOOST_BIND_GLOBAL_PLACEHOLDERS // that Boost's own parser uses them is no news
#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <sstream>

namespace chaindrive::parameters
{
namespace
{
using boost::property_tree::ptree;

/// Sections are four deep at most. Parsers call themselves for each level.
constexpr int deepest = 20;

bool ends_in(const std::string &text, const std::string &end)
{
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// Refuses what is nested so deeply that a parser would run out of stack.
void refuse_depth(const std::string &text, const std::string &file, const Form form)
{
  int depth = 0;
  for (std::size_t i = 0; i + 1 < text.size(); ++i)
    {
      const char c = text[i], next = text[i + 1];
      if (form == Form::json)
        depth += c == '{' || c == '[' ? 1 : c == '}' || c == ']' ? -1 : 0;
      else if ((c == '<' && next == '/') || (c == '/' && next == '>'))
        --depth;
      else if (c == '<' && next != '!' && next != '?')
        ++depth;
      if (depth > deepest)
        throw InputError("'" + file + "' is nested more deeply than the sections of a drive.");
    }
}

/// The name that deal.II writes for an element: `_20` is a blank.
std::string plain_name(const std::string &written)
{
  std::string name;
  for (std::size_t i = 0; i < written.size(); ++i)
    if (written[i] == '_' && i + 2 < written.size() && std::isxdigit(written[i + 1]) != 0 &&
        std::isxdigit(written[i + 2]) != 0)
      {
        name += static_cast<char>(std::stoi(written.substr(i + 1, 2), nullptr, 16));
        i += 2;
      }
    else
      name += written[i];
  return name;
}

ptree parse(const std::string &text, const std::string &file, const Form form)
{
  if (dealii::Utilities::trim(text).empty())
    throw InputError("The parameter file '" + file + "' is empty.");
  refuse_depth(text, file, form);
  const std::string  language = form == Form::xml ? "XML" : "JSON";
  std::istringstream in(text);
  ptree              tree;
  try
    {
      if (form == Form::xml)
        boost::property_tree::read_xml(in,
                                       tree,
                                       boost::property_tree::xml_parser::trim_whitespace |
                                           boost::property_tree::xml_parser::no_comments);
      else
        boost::property_tree::read_json(in, tree);
    }
  catch (const boost::property_tree::file_parser_error &error)
    {
      throw InputError(file + ", line " + std::to_string(std::max(1UL, error.line())) +
                       ": this is no " + language + ", or the file is damaged: " + error.message() +
                       ".");
    }
  if (form == Form::json)
    return tree;
  if (tree.size() != 1 || tree.front().first != "ParameterHandler")
    throw InputError("'" + file +
                     "' is XML, but no parameter file: its outermost element must be "
                     "ParameterHandler, as chaindrive template --as xml writes it.");
  return tree.front().second;
}

class TreeReader
{
public:
  TreeReader(const std::string &file, const Form form) : file_(file), form_(form) {}

  void add(const ptree &tree, const std::string &section)
  {
    for (const auto &[written, child] : tree)
      {
        const std::string name  = form_ == Form::xml ? plain_name(written) : written;
        const auto        value = child.get_child_optional("value");
        if (written == "<xmlattr>" || child.get_child_optional("alias"))
          continue;
        if (name.empty())
          throw InputError(file_ + ": " + (section.empty() ? "the file" : section) +
                           " has a list in it, where a parameter file has names and values.");
        refuse_unwritable(section.empty() ? name : section + "/" + name, name, file_ + ": ");
        if (value)
          add_setting({section, name, dealii::Utilities::trim(value->data())});
        else if (child.empty() && (form_ == Form::json || !child.data().empty()))
          add_setting({section, name, dealii::Utilities::trim(child.data())});
        else
          add(child, section.empty() ? name : section + "/" + name);
      }
  }

  std::vector<Setting> found;

private:
  void add_setting(const Setting &setting)
  {
    refuse_unwritable(setting.path(), setting.value, file_ + ": ");
    if (!paths_.insert(setting.path()).second)
      throw InputError(file_ + ": " + setting.path() + " is given twice.");
    found.push_back(setting);
  }

  const std::string    &file_;
  const Form            form_;
  std::set<std::string> paths_;
};
} // namespace

Form form_of_file(const std::string &file)
{
  return ends_in(file, ".xml") ? Form::xml : ends_in(file, ".json") ? Form::json : Form::prm;
}

std::vector<Setting> read_tree(const std::string &text, const std::string &file, const Form form)
{
  TreeReader reader(file, form);
  reader.add(parse(text, file, form), "");
  return reader.found;
}

std::string statements_of(std::vector<Setting> settings)
{
  std::ostringstream       out;
  std::vector<std::string> open;
  std::stable_partition(settings.begin(), settings.end(), [](const Setting &one) {
    return one.path() == order_entry;
  });
  for (const Setting &one : settings)
    {
      change_section(out, open, one.section);
      out << std::string(2 * open.size(), ' ') << "set " << one.name << " ="
          << (one.value.empty() ? "" : " ") << one.value << '\n';
    }
  change_section(out, open, "");
  return out.str();
}

std::string in_form(const Declarations                       &declarations,
                    const std::map<std::string, std::string> &values,
                    const Form                                form)
{
  std::ostringstream   out;
  std::vector<Setting> settings;
  for (const Entry &entry : declarations.entries())
    if (const auto given = values.find(entry.path());
        given != values.end() &&
        (given->second != entry.default_value || entry.path() == order_entry))
      settings.push_back({entry.section, entry.name, given->second});
  if (form == Form::prm)
    return "# SPDX-License-Identifier: LGPL-2.1-or-later\n\n" + statements_of(settings);
  declarations.print(
      out, form == Form::xml ? dealii::ParameterHandler::XML : dealii::ParameterHandler::JSON);
  return out.str();
}

std::string beyond_defaults(std::vector<Setting> settings,
                            const Declarations  &declarations,
                            const std::string   &file)
{
  const auto says_nothing = [&](const Setting &one) {
    const std::string now   = current_path(one.path()); // empty: it has no other name
    const std::string path  = now.empty() ? one.path() : now;
    const auto       &known = declarations.entries();
    const auto        entry = std::find_if(
        known.begin(), known.end(), [&path](const Entry &e) { return e.path() == path; });
    // the default of the order of travel is the one that was read
    return entry != known.end() ? entry->default_value == one.value && path != order_entry :
                                  one.value.empty() && declarations.has_section(path);
  };
  settings.erase(std::remove_if(settings.begin(), settings.end(), says_nothing), settings.end());
  return "# The entries of " + std::filesystem::path(file).filename().string() +
         " that are not their defaults.\n\n" + statements_of(settings);
}

void refuse_unwritable(const std::string &path, const std::string &value, const std::string &where)
{
  for (const auto &[text, what] : {std::pair<const char *, const char *>{"#", "begins a comment"},
                                   {"\n", "ends the line"},
                                   {"\r", "ends the line"}})
    if (value.find(text) != std::string::npos)
      throw InputError(where + path + " = " + value + " is not allowed: in a .prm file " +
                       (*text == '#' ? "'#' " : "a line break ") + what +
                       ", so that the run could not be repeated. Give a value or path without.");
  if (!value.empty() && value.back() == '\\')
    throw InputError(where + path + " = " + value +
                     " is not allowed: in a .prm file '\\' at the end goes on with the next line, "
                     "so that the run could not be repeated. Give a value or path without.");
}
} // namespace chaindrive::parameters
