// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/parameters/choice.h>
#include <chaindrive/parameters/declarations.h>

#include <map>
#include <string>
#include <vector>

namespace chaindrive::parameters
{
/// How a parameter file is written: as .prm, or as the trees that deal.II's ParameterHandler prints
/// and its program parameter_gui edits.
enum class Form
{
  prm,
  xml,
  json
};

template <>
inline constexpr Texts<Form, 3> texts_of<Form>{
    {{Form::prm, "prm"}, {Form::xml, "xml"}, {Form::json, "json"}}};

/// What one entry is set to.
struct Setting
{
  std::string section; ///< path such as "Drive/Chain"
  std::string name, value;

  std::string path() const { return section.empty() ? name : section + "/" + name; }
};

/// The form of @p file by the end of its name: .xml, .json, or else .prm.
Form form_of_file(const std::string &file);

/// The entries of @p text, the contents of an XML or JSON @p file, in their order. Sections are
/// elements, and so are entries, with an element `value` in them; JSON may have the value itself in
/// its place. In names of XML `_20` stands for the character with the hexadecimal code 20, as
/// deal.II writes a blank. All else that deal.II writes of an entry is passed over: default,
/// meaning and pattern are those of this program. Throws InputError, with file and line where they
/// are known, for what is damaged or no such tree, an entry given twice, and a text that a .prm
/// file cannot hold.
std::vector<Setting> read_tree(const std::string &text, const std::string &file, Form form);

/// Settings as statements of a .prm file, which wheels there are before their entries.
std::string statements_of(std::vector<Setting> settings);

/// All entries of @p declarations with their values as a tree, or as a .prm file those whose value
/// in
/// @p values, by path, is not their default.
std::string in_form(const Declarations                       &declarations,
                    const std::map<std::string, std::string> &values,
                    Form                                      form);

/// Those of @p settings, of @p file, that are not the defaults in @p declarations, as a .prm file.
/// A tree has all entries, among them those of which only one may be given.
std::string beyond_defaults(std::vector<Setting> settings,
                            const Declarations  &declarations,
                            const std::string   &file);

/// InputError, which begins with @p where, for a value of the entry @p path that a .prm file cannot
/// hold: it would be another one when parameters.prm or a study's variant.prm is read. Those of
/// .prm files never are: there they have been cut already.
void refuse_unwritable(const std::string &path, const std::string &value, const std::string &where);
} // namespace chaindrive::parameters
