// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/files/file.h>
#include <chaindrive/files/vtu_series.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/ranks.h>
#include <chaindrive/utilities/timing.h>

#include <deal.II/base/data_out_base.h>

#include <cstdio>
#include <filesystem>
#include <utility>

namespace chaindrive::files
{
namespace
{
std::string file_name(const std::string &name, const std::size_t number, const std::string &ending)
{
  char file[64];
  std::snprintf(file, sizeof(file), "%s_%06zu%s", name.c_str(), number, ending.c_str());
  return file;
}
} // namespace

VtuSeries::VtuSeries(std::string directory, std::string name, const MPI_Comm comm)
    : directory_(std::move(directory)), name_(std::move(name)), comm_(comm)
{
}

void VtuSeries::write(const VtuGrid &grid, const double time)
{
  const unsigned int rank    = rank_in(comm_);
  const unsigned int n_ranks = n_ranks_in(comm_);
  const std::size_t  number  = instants_.size();
  const auto         piece   = [&](const unsigned int r) {
    return file_name(name_, number, n_ranks > 1 ? "." + std::to_string(r) + ".vtu" : ".vtu");
  };
  std::error_code error;
  std::filesystem::create_directories(directory_ + "/fields", error);
  if (error)
    throw RunError(write_failure(directory_ + "/fields", error.value()));
  write_file(directory_ + "/fields/" + piece(rank),
             [&](std::ostream &out) { write_vtu(out, grid, time, packed_); });
  std::string file = piece(0);
  if (n_ranks > 1)
    {
      {
        const Waiting waiting;
        MPI_Barrier(comm_);
      }
      file = file_name(name_, number, ".pvtu");
      std::vector<std::string> pieces;
      for (unsigned int r = 0; r < n_ranks; ++r)
        pieces.push_back(piece(r));
      if (rank == 0)
        write_file(directory_ + "/fields/" + file,
                   [&](std::ostream &out) { write_pvtu(out, grid, pieces); });
    }
  // what the list names exists
  instants_.emplace_back(time, "fields/" + file);
  if (rank == 0)
    write_file(directory_ + "/" + name_ + ".pvd",
               [&](std::ostream &out) { dealii::DataOutBase::write_pvd_record(out, instants_); });
}
} // namespace chaindrive::files
