// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/files/temporary_directory.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/first_rank.h>

#include <deal.II/base/mpi.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace chaindrive::files
{
TemporaryDirectory::TemporaryDirectory(const MPI_Comm comm) : comm_(comm)
{
  on_first_rank(comm_, [this] {
    std::error_code error;
    std::string     where = std::filesystem::temp_directory_path(error).string();
    if (const char *given = std::getenv("TMPDIR"); error && given != nullptr)
      where = given;
    path_ = where + "/chaindrive-XXXXXX";
    if (::mkdtemp(path_.data()) == nullptr)
      throw InputError("A temporary directory is needed, and none can be made in '" + where +
                       "': " + std::strerror(errno) +
                       ". Set the variable TMPDIR to a directory that can be written.");
  });
  path_ = dealii::Utilities::MPI::broadcast(comm_, path_);
}

TemporaryDirectory::~TemporaryDirectory()
{
  MPI_Barrier(comm_);
  std::error_code error;
  std::filesystem::remove_all(path_, error);
}
} // namespace chaindrive::files
