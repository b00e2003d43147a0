// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/files/vtu.h>
#include <chaindrive/utilities/archive.h>

#include <deal.II/base/mpi.h>

#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <string>
#include <utility>
#include <vector>

namespace chaindrive::files
{
/// Field output of one thing at several instants: `NAME.pvd` in a directory, which lists one VTU
/// file for each instant in the folder `fields` beside it; with several ranks, one of each rank and
/// a PVTU file that names them. Every failure to write is a RunError; earlier instants stay
/// readable.
class VtuSeries
{
public:
  /// Each rank of @p comm writes its part.
  VtuSeries(std::string directory, std::string name, MPI_Comm comm = MPI_COMM_SELF);

  /// Adds @p grid at @p time [s]; all ranks' grids have the same fields. Collective.
  void write(const VtuGrid &grid, double time);

  /// The list of instants.
  void serialize(const Archive &archive) { archive(name_, instants_); }

private:
  const std::string                           directory_, name_;
  MPI_Comm                                    comm_;
  std::vector<std::pair<double, std::string>> instants_; ///< time and file
  VtuPacked                                   packed_;
};
} // namespace chaindrive::files
