// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/output/directory.h>
#include <chaindrive/utilities/errors.h>

#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <regex>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace fs = std::filesystem;

namespace chaindrive::output
{
namespace
{
/// Removes the plain files of @p directory whose whole name matches @p names.
void remove_files(const fs::path &directory, const std::regex &names)
{
  std::error_code       error;
  std::vector<fs::path> found; // first collected: removing while iterating may skip entries
  for (const auto &entry : fs::directory_iterator(directory, error))
    if (entry.is_regular_file(error) && std::regex_match(entry.path().filename().string(), names))
      found.push_back(entry.path());
  for (const fs::path &file : found)
    if (!fs::remove(file, error) && error)
      throw InputError("Cannot replace the earlier result '" + file.string() +
                       "': " + error.message() + ".");
}
} // namespace

void prepare_directory(const std::string &path, const bool resumes)
{
  const std::string refusal = "The output directory '" + path + "' cannot be used: ";

  // The first component that is no directory explains more than the system's "Not a directory".
  fs::path        part;
  std::error_code error;
  for (const fs::path &component : fs::path(path))
    {
      part /= component;
      if (fs::exists(part, error) && !fs::is_directory(part, error))
        throw InputError(refusal + "'" + part.string() + "' is a file, not a directory.");
    }
  fs::create_directories(path, error);
  if (error)
    throw InputError(refusal + error.message() + ".");

  // Permissions are best asked by doing: access() knows nothing of read-only or full disks.
  const std::string trial      = (fs::path(path) / "summary.json.part").string();
  const int         descriptor = ::open(trial.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor < 0)
    throw InputError(refusal + std::generic_category().message(errno) + ".");
  ::close(descriptor);

  const std::string ending = resumes ? "\\.part" : "(\\.part)?";
  remove_files(
      path,
      std::regex("(histories(-[0-9]+)?\\.h5|histories_[a-z0-9_]+\\.csv|(bodies|bars)\\.pvd|"
                 "checkpoint-[0-9]+\\.ckpt|summary\\.json)" +
                 ending));
  remove_files(fs::path(path) / "fields",
               std::regex("(bodies|bars)_[0-9]+(\\.[0-9]+)?\\.p?vtu" + ending));
}
} // namespace chaindrive::output
