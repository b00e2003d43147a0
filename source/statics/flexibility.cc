// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/statics/flexibility.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::statics
{
namespace
{
using Vector = ElasticPiece::Vector;

ElasticPiece::Patches patches_of(const Side &side)
{
  const auto local = [side](const dealii::Point<3> &x) {
    const double a = x[0] - side.axis[0], b = x[1] - side.axis[1];
    const double c = std::cos(side.angle), s = std::sin(side.angle);
    return dealii::Point<2>(c * a + s * b, c * b - s * a);
  };
  ElasticPiece::Patches patches;
  patches.sides  = {side.id};
  patches.n      = side.grid.n();
  patches.number = [side, local](const dealii::Point<3> &x) {
    const dealii::Point<2> at = local(x);
    // what is far off belongs to another cylinder: another tooth, another hole
    return std::abs(at.norm() - side.grid.radius) > 0.5 * side.grid.radius ?
               PatchGrid::none :
               side.grid.number(std::atan2(at[1], at[0]), x[2]);
  };
  patches.direction = [side](const dealii::Point<3> &x) {
    dealii::Tensor<1, 3> d;
    d[0] = x[0] - side.axis[0];
    d[1] = x[1] - side.axis[1];
    return (side.bore ? 1. : -1.) / d.norm() * d;
  };
  return patches;
}

/// Unit forces on the patches of all sides.
std::vector<Vector> loads_of(const ElasticPiece &part, const std::vector<Side> &sides)
{
  std::vector<Vector> all;
  for (const Side &side : sides)
    for (Vector &load : part.loads(patches_of(side)))
      all.push_back(std::move(load));
  return all;
}

/// Two newtons or so, evenly over the two rows of patches that are nearest to the line.
Vector
smooth_load(const std::vector<Vector> &loads, const unsigned int first, const PatchGrid &grid)
{
  Vector sum(loads[first]);
  sum = 0.;
  for (unsigned int a = 0; a < std::min(2U, grid.n_angles); ++a)
    for (unsigned int s = 0; s < grid.n_rings(); ++s)
      sum.add((grid.z[s + 1] - grid.z[s]) / grid.z.back(), loads[first + a * grid.n_rings() + s]);
  return sum;
}
/// The compliances under smooth loads on each of the sides, and where they make the next refinement
/// worthwhile.
std::vector<double> smooth_compliances(ElasticPiece              &part,
                                       const std::vector<Side>   &sides,
                                       ElasticPiece::Refinements &refinements)
{
  const std::vector<Vector> loads = loads_of(part, sides);
  std::vector<double>       compliances;
  Vector                    all(loads.front());
  all                = 0.;
  unsigned int first = 0;
  for (const Side &side : sides)
    {
      const Vector load = smooth_load(loads, first, side.grid);
      const Vector u    = part.solve(load);
      compliances.push_back(part.displacement(u, load));
      all += u;
      first += side.grid.n();
    }
  refinements.push_back(part.worst_cells(all, 0.15));
  return compliances;
}
} // namespace

PieceFlexibility flexibility(const Piece             &piece,
                             const std::vector<Side> &sides,
                             const Material          &material,
                             const double             tolerance,
                             const MPI_Comm           comm)
{
  PieceFlexibility              result;
  ElasticPiece::Refinements     refinements;
  std::unique_ptr<ElasticPiece> part   = std::make_unique<ElasticPiece>(piece, material, comm);
  std::vector<double>           before = smooth_compliances(*part, sides, refinements);
  for (unsigned int level = 0;; ++level)
    {
      auto       finer = std::make_unique<ElasticPiece>(piece, material, comm, refinements);
      const auto after = smooth_compliances(*finer, sides, refinements);
      result.error     = 0.;
      for (unsigned int i = 0; i < before.size(); ++i)
        result.error = std::max(result.error, std::abs(after[i] / before[i] - 1.));
      if (result.error < tolerance || level == 4)
        break;
      part   = std::move(finer);
      before = after;
    }
  result.n_cells    = part->n_cells();
  result.n_unknowns = part->n_unknowns();

  const std::vector<Vector> loads = loads_of(*part, sides);
  const unsigned int        n     = static_cast<unsigned int>(loads.size());
  result.values.reinit(n, n);
  unsigned int j = 0;
  for (const Side &side : sides)
    for (unsigned int p = 0; p < side.grid.n(); ++p, ++j)
      {
        const Vector u    = part->solve(loads[j]);
        const double area = (side.across ? 2. : 1.) * side.grid.area(p % side.grid.n_rings());
        for (unsigned int i = 0; i < n; ++i)
          result.values(i, j) = part->displacement(u, loads[i]) * area;
      }
  return result;
}
} // namespace chaindrive::statics
