// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/parameters/parameters.h>
#include <chaindrive/parameters/study.h>
#include <chaindrive/parameters/tree_file.h>

#include <functional>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

namespace chaindrive::parameters
{
/// What was read: the parameters, and what is to be said about them.
struct Input
{
  Parameters               parameters;
  std::vector<std::string> notes;    ///< harmless oddities, a sentence each, for the log
  std::vector<std::string> warnings; ///< what is most likely a mistake, a sentence each
  /// Of the file as it was read, once: it may be a pipe. Of a tree what is not the default, as
  /// .prm.
  std::string text;
  std::string resolved; ///< every entry with its value, as a .prm file
  /// "Section/Entry = value", a line for each entry that must stay when a run resumes.
  std::string fixed;
};

/// What a file says has to be completed and checked by what is decided from all entries together,
/// which this room does not know: whoever reads them says how (model/reading.h). What is empty is
/// left out.
struct Completion
{
  /// The number of links that suits the other entries of the drive, for Drive/Number of links =
  /// auto, which is refused without it.
  std::function<unsigned int(const Drive &)> n_links = {};

  /// For Output/Field interval in ms = auto, s.
  std::function<double(const Parameters &)> field_interval = {};

  /// Throws InputError for contradictions, returns notes; @p changed are the paths of the entries
  /// that were given another value than their default.
  std::function<std::vector<std::string>(const Parameters               &parameters,
                                         const std::vector<std::string> &changed)>
      check = {};
};

/// Reads the parameter file @p file, a .prm file or by the end of its name a tree (tree_file.h),
/// then applies @p overrides ("Section/Entry=value", such as
/// "Drive/Layout/Slack in mm=1") in their order, then completes and checks as @p completion says.
///
/// Throws InputError with a sentence for every mistake found, one per line: a file that cannot be
/// read, a name that does not exist (with its line and the nearest valid name), a value that is not
/// allowed (with what is), and contradictions.
Input read_parameters(const std::string              &file,
                      const std::vector<std::string> &overrides  = {},
                      const Completion               &completion = {});

/// The same for entries at hand: their values by path. Input::text is empty.
Input read_entries(const std::map<std::string, std::string> &values,
                   const Completion                         &completion = {});

/// Reads the study file @p file with the files that it includes (`include FILE`, from the folder of
/// the file that says so), then applies @p overrides as above, before them those of Study/Quick if
/// @p quick. What the variants say of the drive is checked by read_entries(), each by itself.
StudyInput
read_study(const std::string &file, const std::vector<std::string> &overrides, bool quick);

/// The drive of the parameter file @p file in another form: as an XML or JSON tree every entry with
/// its value, default, meaning and the field that it needs, as deal.II's parameter_gui reads it; as
/// .prm the entries that are not their defaults, without comments. Throws as read_parameters(), but
/// for what is wrong across entries.
std::string in_form(const std::string &file, Form form);

/// The same for entries at hand, those of two wheels: their values by path.
std::string in_form(const std::map<std::string, std::string> &values, Form form);

/// Writes a .prm file with every entry at its default, each with its meaning and allowed values.
void write_template(std::ostream &out);

/// The reference of all entries in Markdown: doc/parameters.md but for its table of needs.
std::string parameter_documentation();
} // namespace chaindrive::parameters
