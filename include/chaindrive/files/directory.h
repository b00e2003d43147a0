// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>
#include <string>

namespace chaindrive::files
{
/// The output directory of a run. One run works in it at a time: it holds a lock on the file
/// `chaindrive.lock` there, which the system releases with the process, however that ends.
///
/// All member functions throw InputError when the directory cannot be used, with the reason.
class Directory
{
public:
  /// Nothing happens yet.
  explicit Directory(std::string path);

  /// Releases the directory to other runs.
  ~Directory();

  const std::string &path() const { return path_; }

  /// To be called before anything in the directory is read or changed. Refuses one in which another
  /// run is at work, a path with a component that is no directory, one where nothing can be written
  /// and one where a directory stands in the place of a result. Where there is none yet none is
  /// made. Returns a warning when the system has no locks there, or nothing.
  std::string claim();

  /// To be called when nothing else can be refused any more: makes the directory with its parents
  /// and removes the results of an earlier run, the files that this program writes, recognised by
  /// their exact names, and nothing else. A run that @p resumes an earlier one keeps them, but for
  /// the summary of the end, files left unfinished and, without @p csv, CSV files, which would not
  /// be continued. Returns as claim().
  std::string take_over(bool resumes = false, bool csv = true);

  /// A sentence on what is there and not of any run, if no run has been there; or nothing. Nothing
  /// of it is touched.
  std::string strangers() const;

  /// Refuses a directory where no run has been and a file of somebody stands under the name of one
  /// that a run of @p parameter_file writes.
  void spare(const std::string &parameter_file) const;

private:
  class Lock;

  std::string refusal() const;
  std::string lock();
  void        check_components() const;
  void        check_contents() const;

  std::string           path_;
  std::unique_ptr<Lock> lock_;
};

/// Whether histories of this group have a CSV file that Directory::take_over() knows.
bool is_history_group(const std::string &group);
} // namespace chaindrive::files
