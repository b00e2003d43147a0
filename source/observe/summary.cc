// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/summary.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cctype>
#include <numeric>

namespace chaindrive::observe
{
files::Json cpu_seconds(const std::vector<PhaseTimer::Row> &rows)
{
  files::Json result = files::Json::object();
  double      total  = 0.;
  for (const PhaseTimer::Row &row : rows)
    {
      std::string name = row.name;
      std::transform(name.begin(), name.end(), name.begin(), [](const unsigned char c) {
        return std::isalnum(c) ? static_cast<char>(std::tolower(c)) : '_';
      });
      result[name] = row.cpu_seconds;
      total += row.cpu_seconds;
    }
  result["total"] = total;
  return result;
}

std::vector<PhaseTimer::Row> rows_of_all_ranks(const PhaseTimer &timer, const MPI_Comm comm)
{
  std::vector<PhaseTimer::Row> rows = timer.rows();
  std::vector<double>          seconds;
  seconds.reserve(rows.size());
  for (const PhaseTimer::Row &row : rows)
    seconds.push_back(row.cpu_seconds);
  dealii::Utilities::MPI::sum(seconds, comm, seconds);
  const double total = std::accumulate(seconds.begin(), seconds.end(), 0.);
  for (std::size_t i = 0; i < rows.size(); ++i)
    rows[i] = {rows[i].name, seconds[i], 100. * seconds[i] / total};
  return rows;
}
} // namespace chaindrive::observe
