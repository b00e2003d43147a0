// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace chaindrive::parameters
{
/// One entry of the .prm file as it was declared.
struct Entry
{
  std::string section;       ///< path such as "Drive/Chain"
  std::string name;          ///< such as "Pitch in mm"
  std::string default_value; ///< as it is written in a .prm file
  std::string allowed;       ///< the accepted values in words
  std::string meaning;

  std::string path() const { return section + "/" + name; }
};

/// All declared entries in the order of declaration.
class Catalogue
{
public:
  explicit Catalogue(const dealii::ParameterHandler &prm);

  const std::vector<Entry> &entries() const { return entries_; }

  /// Paths of all sections, in order.
  const std::vector<std::string> &sections() const { return sections_; }

  /// The entry with this section and name; null if there is none.
  const Entry *find(const std::string &section, const std::string &name) const;

  bool has_section(const std::string &path) const;

  /// Names of the entries of @p section, and of the sections right inside it ("" is the file).
  std::vector<std::string> entry_names(const std::string &section) const;
  std::vector<std::string> section_names(const std::string &section) const;

private:
  std::vector<Entry>       entries_;
  std::vector<std::string> sections_;
};

/// Sets an entry in the subsection that its path names. Throws InputError when the value is not
/// allowed: @p where (file and line, or command-line option) begins the sentence.
void set(dealii::ParameterHandler &prm,
         const Entry              &entry,
         const std::string        &value,
         const std::string        &where);
} // namespace chaindrive::parameters
