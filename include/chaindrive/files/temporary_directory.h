// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <mpi.h>

#include <string>

namespace chaindrive::files
{
/// A directory for files that nobody needs, known to all ranks and gone with this object. It is
/// made where TMPDIR says, and nobody else can have made it. Both ends are collective.
class TemporaryDirectory
{
public:
  /// InputError when it cannot be made.
  explicit TemporaryDirectory(MPI_Comm comm);
  ~TemporaryDirectory();
  TemporaryDirectory(const TemporaryDirectory &)            = delete;
  TemporaryDirectory &operator=(const TemporaryDirectory &) = delete;

  const std::string &path() const { return path_; }

private:
  MPI_Comm    comm_;
  std::string path_;
};
} // namespace chaindrive::files
