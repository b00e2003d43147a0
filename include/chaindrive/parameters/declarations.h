// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/parameter_handler.h>

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace chaindrive::parameters
{
/// Whether an entry may have another value in a run that resumes than in the run it goes on from.
enum class OnResume
{
  must_stay,
  may_change,
  must_stay_with_region_of_interest ///< with Model/Elastic links = region of interest it decides
                                    ///< which are elastic
};

/// One entry of the .prm file.
struct Entry
{
  std::string              section;       ///< path such as "Drive/Chain"
  std::string              name;          ///< such as "Pitch in mm"
  std::string              default_value; ///< as it is written in a .prm file
  std::string              allowed;       ///< the accepted values in words
  std::string              meaning;
  OnResume                 on_resume;
  std::vector<std::string> sought; ///< paths of no entries where this one may be looked for

  std::string path() const { return section + "/" + name; }
};

/// deal.II's ParameterHandler, which holds the entries, tests values and stores them in the members
/// behind the entries, with what it has no place for: which entries there are, in the order of
/// their declaration, and what may change on resuming. entries.h has the functions that declare.
class Declarations
{
public:
  /// Adds an entry to the section that is open: @p accepts and @p allowed make its pattern, @p
  /// store puts an accepted text into the member; @p form is what deal.II's parameter_gui offers a
  /// field for, the description of one of its patterns. See Entry for the other arguments.
  Entry &add(const std::string                              &name,
             const std::string                              &default_value,
             const std::string                              &allowed,
             const std::string                              &meaning,
             const std::function<bool(const std::string &)> &accepts,
             const std::function<void(const std::string &)> &store,
             const std::string                              &form = "[Anything]");

  /// Gives the member behind @p entry a value. Throws InputError when the value is not allowed:
  /// @p where (file and line, or command-line option) begins the sentence.
  void set(const Entry &entry, const std::string &value, const std::string &where);

  /// Writes all entries with their values, defaults, meanings and forms as ParameterHandler does.
  void print(std::ostream &out, dealii::ParameterHandler::OutputStyle style) const;

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
  friend class Subsection;

  dealii::ParameterHandler prm_;
  std::vector<Entry>       entries_;
  std::vector<std::string> sections_;
  std::string              open_; ///< path of the section to which entries are added
  OnResume                 on_resume_ = OnResume::must_stay; ///< of what is added to it
};

/// A subsection, open as long as this object lives. @p on_resume holds of its entries unless they
/// are told otherwise.
class Subsection
{
public:
  Subsection(Declarations      &declarations,
             const std::string &name,
             OnResume           on_resume = OnResume::must_stay);
  ~Subsection();
  Subsection(const Subsection &)            = delete;
  Subsection &operator=(const Subsection &) = delete;

private:
  Declarations     &declarations_;
  const std::string outer_;
  const OnResume    outer_on_resume_;
};
} // namespace chaindrive::parameters
