// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/files/data_folder.h>
#include <chaindrive/utilities/errors.h>

#include <filesystem>
#include <system_error>

namespace chaindrive::files
{
std::string data_folder(const std::string &name)
{
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path  program = fs::read_symlink("/proc/self/exe", error).parent_path();
  const fs::path  installed =
      (program / CHAINDRIVE_DATA_FROM_PROGRAM / name).lexically_normal(); // e.g. ../share
  const fs::path source = fs::path(CHAINDRIVE_SOURCE) / name;
  for (const fs::path &folder : {installed, source})
    if (fs::is_directory(folder, error))
      return folder.string();
  // who has installed a package does not know where it was built
  const std::string built_in =
      fs::is_directory(CHAINDRIVE_SOURCE, error) ? " or " + source.string() : "";
  throw InputError("There is no folder " + installed.string() + built_in +
                   ", which is a part of chaindrive: install it again.");
}
} // namespace chaindrive::files
