// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/parameters/drive.h>
#include <chaindrive/parameters/entries.h>
#include <chaindrive/parameters/old_names.h>
#include <chaindrive/parameters/sections.h>
#include <chaindrive/parameters/suggestions.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cctype>
#include <optional>

namespace chaindrive::parameters
{
namespace
{
std::string lower(std::string text)
{
  for (char &c : text)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// A name such as "Sag in mm" in two.
struct Name
{
  explicit Name(const std::string &name)
      : quantity(name.substr(0, name.rfind(" in ")))
      , unit(quantity.size() < name.size() ? name.substr(quantity.size() + 4) : "")
  {
  }
  std::string quantity, unit;
};

struct Unit
{
  const char *name;
  const char *of; ///< units of one kind can be converted
  double      si;
};

constexpr double pi      = dealii::numbers::PI;
constexpr Unit   units[] = {{"m", "length", 1.},         {"cm", "length", 1e-2},
                            {"mm", "length", 1e-3},      {"um", "length", 1e-6},
                            {"inch", "length", 0.0254},  {"in", "length", 0.0254},
                            {"s", "time", 1.},           {"ms", "time", 1e-3},
                            {"us", "time", 1e-6},        {"min", "time", 60.},
                            {"h", "time", 3600.},        {"N", "force", 1.},
                            {"kN", "force", 1e3},        {"lbf", "force", 4.4482216},
                            {"kg", "mass", 1.},          {"g", "mass", 1e-3},
                            {"W", "power", 1.},          {"kW", "power", 1e3},
                            {"hp", "power", 745.69987},  {"PS", "power", 735.49875},
                            {"Hz", "frequency", 1.},     {"kHz", "frequency", 1e3},
                            {"Pa", "stress", 1.},        {"MPa", "stress", 1e6},
                            {"GPa", "stress", 1e9},      {"N/mm2", "stress", 1e6},
                            {"N m", "torque", 1.},       {"Nm", "torque", 1.},
                            {"kN m", "torque", 1e3},     {"N mm", "torque", 1e-3},
                            {"N/m", "stiffness", 1.},    {"N/mm", "stiffness", 1e3},
                            {"kN/mm", "stiffness", 1e6}, {"rad/s", "speed", 1.},
                            {"rpm", "speed", pi / 30.},  {"1/min", "speed", pi / 30.},
                            {"kg m2", "inertia", 1.},    {"kg mm2", "inertia", 1e-6},
                            {"g mm2", "inertia", 1e-9},  {"kg/m3", "density", 1.},
                            {"g/cm3", "density", 1e3},   {"rad", "angle", 1.},
                            {"deg", "angle", pi / 180.}, {"degrees", "angle", pi / 180.},
                            {"m/s", "velocity", 1.},     {"m/s2", "acceleration", 1.},
                            {"percent", "share", 0.01},  {"%", "share", 0.01},
                            {"pitches", "pitches", 1.}};

const Unit *find_unit(const std::string &name)
{
  const auto *unit = std::find_if(
      std::begin(units), std::end(units), [&](const Unit &u) { return name == u.name; });
  return unit == std::end(units) ? nullptr : unit;
}

std::string first_sentence(const std::string &text)
{
  const std::size_t end = text.find(". ");
  return end == std::string::npos ? text : text.substr(0, end + 1);
}

/// What to write of @p entry instead of @p value in the unit @p from, for the same quantity.
std::string
converted(const Entry &entry, const std::string &shown, const Name &from, const std::string &value)
{
  const Name  to(entry.name);
  std::string question = " Did you mean '" + shown + "'?";
  if (from.unit.empty() || from.unit == to.unit)
    return question;
  const Unit *const a = find_unit(from.unit), *const b = find_unit(to.unit);
  if (to.unit.empty())
    return " There is '" + shown + "', which has no unit. " + first_sentence(entry.meaning);
  if (a == nullptr || b == nullptr || std::string(a->of) != b->of)
    return " There is '" + shown + "', which is in " + to.unit + ", not in " + from.unit +
           ", so the value differs. " + first_sentence(entry.meaning);
  const auto number = from_entry_text(value, unit::si);
  return question + (number ? " " + value + " " + from.unit + " are " +
                                  to_text(*number * a->si / b->si, 10) + " " + to.unit + "." :
                              " It is in " + to.unit + ", not in " + from.unit + ".");
}

/// Whether @p words stand in @p name, at the beginning of a word: "offset" in "Offset in mm".
bool has_word(const std::string &name, const std::string &word)
{
  for (std::size_t at = name.find(word); at != std::string::npos; at = name.find(word, at + 1))
    if (at == 0 || std::isalpha(static_cast<unsigned char>(name[at - 1])) == 0)
      return true;
  return false;
}

/// Names that are near by letters and far by meaning.
bool are_opposite(const std::string &a, const std::string &b)
{
  for (const auto &[one, other] : {std::pair<const char *, const char *>{"driver", "driven"},
                                   {"driven", "driver"},
                                   {"inner", "outer"},
                                   {"outer", "inner"}})
    if (has_word(a, one) && has_word(b, other))
      return true;
  return false;
}

std::string
list(const std::vector<std::string> &names, const std::string &before, const std::string &after)
{
  std::string text;
  for (const std::string &name : names)
    text += (text.empty() ? "" : ", ") + before + name + after;
  return text;
}

/// The entries of which the beginning was written, or that which was misspelt, by its unit or not.
std::vector<std::string> similar(const std::string &name, const std::vector<std::string> &names)
{
  std::vector<std::string> whole, quantities;
  for (const std::string &candidate : names)
    {
      if (are_opposite(lower(name), lower(candidate)))
        continue;
      whole.push_back(candidate);
      quantities.push_back(Name(candidate).quantity);
    }
  if (std::vector<std::string> begun = names_begun_with(name, whole); !begun.empty())
    return begun;
  if (const std::string nearest = nearest_name(name, whole); !nearest.empty())
    return {nearest};
  const auto at = std::find(
      quantities.begin(), quantities.end(), nearest_name(Name(name).quantity, quantities));
  if (at == quantities.end())
    return {};
  return {whole[at - quantities.begin()]};
}
} // namespace

const std::vector<NotModelled> &not_modelled()
{
  static const std::vector<NotModelled> all = {
      {{"misalignment", "skew", "axial stiffness", "lateral"},
       "shafts do not deflect along their axes, and nothing pushes the chain sideways but wheels "
       "that are out of line, by their entries Axial offset in mm and Tilt in degrees in "
       "Drive/Wheels"},
      {{"uneven strand", "load sharing", "multiplex", "duplex", "triplex"},
       "strands, see Drive/Chain/Strands, are alike and share the load equally unless wheels are "
       "out "
       "of line; what tells them apart besides is only in ratings and life"},
      {{"pin bending", "pin stiffness", "intermediate plate"},
       "pins of separate strands are rigid between these, and intermediate plates are two outer "
       "ones; see Effects/Separate strands"},
      {{"flank error", "wobble"},
       "all teeth have the same flanks and do not wobble; a sprocket of any shape can be imported, "
       "Drive/Sprockets/Driver mesh"},
      {{"driver inertia", "motor", "engine", "driver torque"},
       "the driver, or the motor behind its coupling, follows its prescribed speed, whatever the "
       "load; sections Coupling of Drive/Wheels"},
      {{"shaft tilt", "gyroscop", "bearing play", "bearing clearance", "housing"},
       "shafts stay parallel; bearings and their housings are springs without play, sections "
       "Bearing of Drive/Wheels"},
      {{"tensioner", "guide", "snubber", "rail", "slipper"},
       "nothing but the wheels of Drive/Wheels and their guides touches the chain; one wheel, or "
       "the "
       "guide of the slack span, may be a tensioner, see its entry Held by and its section Guide"},
      {{"lubric", "oil", "grease", "viscos"},
       "friction follows Coulomb's law; set Contact/Friction coefficient for the lubrication, and "
       "Contact/Oil viscosity in mPa s for the oil between rollers, bushes and teeth"},
      {{"temperature", "thermal", "heat"}, "temperatures are constant"},
      {{"wear rate", "life", "fatigue", "yield", "plastic", "strength"},
       "the material is linear elastic and neither wears nor fails during a run; the elongation "
       "of a worn chain is Drive/Chain/Elongation in percent"},
      {{"link tolerance", "tolerance", "scatter"},
       "all links are identical but for their pitches, Drive/Chain/Pitch tolerance in percent"}};
  return all;
}

namespace
{
/// What @p entry was called in earlier versions, without its section; empty if it has its name.
std::string name_before(const Entry &entry)
{
  for (const OldEntry &old : old_entries())
    if (old.path == entry.path() &&
        old.old_path.compare(0, entry.section.size() + 1, entry.section + "/") == 0)
      return old.old_path.substr(entry.section.size() + 1);
  return "";
}
/// What to do about an unknown section where plug-ins have theirs.
std::string plugin_advice()
{
  return " Such sections belong to plug-ins, which the option --plugin FILE loads: is one "
         "missing?";
}

std::string last_part(const std::string &path) { return path.substr(path.rfind('/') + 1); }

std::string enclosing(const std::string &path)
{
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? "" : path.substr(0, slash);
}

/// What to say of an entry @p name that section @p section does not have, to which @p value was to
/// be given: the entry of the same quantity in another unit, with the value converted to it; that
/// the quantity is not modelled; the entry that was probably misspelt; the entries of the section.
/// A sentence, with a blank before it; empty if there is nothing to say. @p with_paths names
/// entries by their paths.
std::string advice(const std::vector<Entry> &entries,
                   const std::string        &section,
                   const std::string        &name,
                   const std::string        &value,
                   const bool                with_paths = false)
{
  const std::string        before = with_paths ? section + "/" : "";
  const Name               from(name);
  const Entry             *elsewhere = nullptr;
  std::vector<std::string> here;
  std::vector<std::string> old_here;
  for (const Entry &entry : entries)
    {
      const bool        is_here  = entry.section == section;
      const std::string old_name = name_before(entry);
      if (is_here)
        here.push_back(entry.name);
      if (is_here && !old_name.empty())
        old_here.push_back(old_name);
      if (lower(Name(entry.name).quantity) != lower(from.quantity) &&
          lower(Name(old_name).quantity) != lower(from.quantity))
        continue;
      if (is_here)
        return converted(entry, before + entry.name, from, value);
      elsewhere = elsewhere == nullptr ? &entry : elsewhere;
    }
  if (elsewhere != nullptr)
    return converted(*elsewhere, elsewhere->path(), from, value);
  for (const NotModelled &one : not_modelled())
    for (const std::string &word : one.words)
      if (has_word(lower(name), word))
        return " That is not modelled: " + one.sentence + " (doc/not-modelled.md).";
  std::vector<std::string> names = similar(name, here);
  if (names.empty())
    for (const std::string &old_name : similar(name, old_here))
      for (const Entry &entry : entries)
        if (entry.section == section && name_before(entry) == old_name)
          names.push_back(entry.name);
  if (names.size() == 1)
    return " Did you mean '" + before + names.front() + "'?" +
           (Name(names.front()).unit == from.unit || from.unit.empty() ?
                "" :
                " It is in " + Name(names.front()).unit + ", not in " + from.unit + ".");
  if (names.size() > 1)
    return " Did you mean one of " + list(names, "'" + before, "'") + "?";
  return here.empty() ? "" : " There are: " + list(here, "", "") + ".";
}
} // namespace

std::string
unknown_section(const Declarations &declarations, const std::string &name, const std::string &outer)
{
  const std::string begin =
      (outer.empty() ? "there is" : "section " + outer + " has") + " no section '" + name + "'.";
  if (name == "Study" && outer.empty())
    return begin + " It belongs to a study, which is run by: chaindrive study FILE.prm.";
  if (is_heading_of_plugins(outer.empty() ? name : outer))
    return begin + plugin_advice();
  if (outer == "Drive/Wheels")
    return begin + " Wheels are listed by " + order_entry + ", before their sections.";
  for (const std::string &path : declarations.sections())
    if (last_part(path) == name)
      return begin + (enclosing(path).empty() ?
                          " It is a section of its own: is an 'end' missing above?" :
                          " It belongs in section " + enclosing(path) + ".");
  const std::vector<std::string> names   = declarations.section_names(outer);
  const std::string              nearest = nearest_name(name, names);
  return begin + (!nearest.empty() ? " Did you mean '" + nearest + "'?" :
                  names.empty()    ? "" :
                                     " There are: " + join(names) + ".");
}

namespace
{
/// The path of the entry that may be looked for at @p path; empty if none is.
std::string sought_at(const Declarations &declarations, const std::string &path)
{
  for (const Entry &entry : declarations.entries())
    if (std::find(entry.sought.begin(), entry.sought.end(), path) != entry.sought.end())
      return entry.path();
  return "";
}
} // namespace

std::string unknown_entry(const Declarations &declarations,
                          const std::string  &section,
                          const std::string  &name,
                          const std::string  &value)
{
  const std::string begin = section.empty() ?
                                "the entry '" + name + "' stands outside all sections." :
                                "section " + section + " has no entry '" + name + "'.";
  if (const std::string place = sought_at(declarations, section + "/" + name); !place.empty())
    return begin + " It is " + place + ".";
  for (const Entry &entry : declarations.entries())
    if (entry.name == name)
      return begin + " It belongs in section " + entry.section + ".";
  for (const OldEntry &old : old_entries())
    if (last_part(old.old_path) == name)
      return begin + " It is now called " + old.path + ".";
  return begin + advice(declarations.entries(), section, name, value);
}

std::string
advice_on_path(const Declarations &declarations, const std::string &path, const std::string &value)
{
  // the unit may contain a slash
  const std::size_t slash   = path.substr(0, path.rfind(" in ")).rfind('/');
  const bool        bare    = slash == std::string::npos;
  const std::string section = bare ? "" : path.substr(0, slash),
                    name    = path.substr(bare ? 0 : slash + 1);
  if (section.compare(0, 13, "Drive/Wheels/") == 0 && !declarations.has_section(section))
    return " There is no section '" + section + "'; wheels are listed by " + order_entry +
           ", which comes before their entries.";
  if (const std::string place = sought_at(declarations, path); !place.empty())
    return " Did you mean '" + place + "'?";
  for (const Entry &entry : declarations.entries())
    if (entry.name == name)
      return " Did you mean '" + entry.path() + "'?";
  for (const OldEntry &old : old_entries())
    if (last_part(old.old_path) == name)
      return " Did you mean '" + old.path + "', as it is now called?";
  if (!bare && !declarations.has_section(section))
    {
      if (is_heading_of_plugins(section.substr(0, section.find('/'))))
        return " There is no section '" + section + "'." + plugin_advice();
      const std::string nearest = nearest_name(section, declarations.sections());
      return " There is no section '" + section + "'" +
             (nearest.empty() ? "; chaindrive template lists all entries." :
                                "; did you mean '" + nearest + "'?");
    }
  const std::string found =
      advice(declarations.entries(), section, name, value, /*with_paths=*/true);
  return found.empty() ? " chaindrive template lists all entries." : found;
}
} // namespace chaindrive::parameters
