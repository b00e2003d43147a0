// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/statics/peak_stress.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::statics
{
PeakStress peak_stress(const Piece                     &piece,
                       const ElasticPiece::Patches     &load,
                       const dealii::types::boundary_id side,
                       const Material                  &material,
                       const double                     tolerance,
                       const MPI_Comm                   comm)
{
  constexpr unsigned int    most = 12, in_a_row = 3;
  PeakStress                result;
  ElasticPiece::Refinements refinements;
  std::vector<double>       changes;
  for (unsigned int level = 0; level < most; ++level)
    {
      ElasticPiece part(piece, material, comm, refinements);
      const auto   u      = part.solve(part.loads(load).front());
      const double before = result.per_force;
      result.per_force    = part.largest_stress(u, side);
      result.n_cells      = part.n_cells();
      result.n_unknowns   = part.n_unknowns();
      if (level > 0)
        changes.push_back(std::abs(result.per_force / before - 1.));
      if (changes.size() >= in_a_row)
        {
          result.error = *std::max_element(changes.end() - in_a_row, changes.end());
          if (result.error < tolerance)
            break;
        }
      refinements.push_back(part.worst_cells(u, 0.15));
    }
  return result;
}
} // namespace chaindrive::statics
