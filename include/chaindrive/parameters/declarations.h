// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace chaindrive::parameters
{
/// Whether an entry may have another value in a run that resumes than in the run it goes on from.
enum class OnResume
{
  must_stay,
  may_change,
  must_stay_if_links_arrive ///< with Model/Elastic links = arriving it decides which are elastic
};

/// One entry of the .prm file and the member behind it.
struct Entry
{
  std::string section;       ///< path such as "Drive/Chain"
  std::string name;          ///< such as "Pitch in mm"
  std::string default_value; ///< as it is written in a .prm file
  std::string allowed;       ///< the accepted values in words
  std::string meaning;
  OnResume    on_resume;

  std::function<bool(const std::string &)> accepts; ///< whether a text is a value
  std::function<void(const std::string &)> store;   ///< puts an accepted text into the member

  std::string path() const { return section + "/" + name; }
};

/// All entries in the order of their declaration; entries.h has the functions that declare them.
class Declarations
{
public:
  /// Adds an entry to the section that is open. See Entry for the arguments.
  Entry &add(const std::string                              &name,
             const std::string                              &default_value,
             const std::string                              &allowed,
             const std::string                              &meaning,
             const std::function<bool(const std::string &)> &accepts,
             const std::function<void(const std::string &)> &store);

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

/// Gives the member behind @p entry a value. Throws InputError when the value is not allowed:
/// @p where (file and line, or command-line option) begins the sentence.
void set(const Entry &entry, const std::string &value, const std::string &where);
} // namespace chaindrive::parameters
