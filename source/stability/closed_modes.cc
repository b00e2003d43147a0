// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/stability/closed_modes.h>
#include <chaindrive/utilities/eigenvalue.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace chaindrive::stability
{
namespace
{
using NodeSprings = std::vector<dealii::SymmetricTensor<2, 3>>;

/// The springs of the nodes whose normals are at most the side's angle from @p direction, or of all
/// if it is zero; @p across: stiffness across the normals over that along them.
NodeSprings springs_of(const contact::ClosedSide  &side,
                       const double                across,
                       const dealii::Tensor<1, 3> &direction)
{
  const double least = direction.norm_square() > 0. ? std::cos(side.half_angle) : 0.;
  const auto   unit  = dealii::unit_symmetric_tensor<3>();
  NodeSprings  springs(side.stiffness.size());
  for (unsigned int n = 0; n < springs.size(); ++n)
    {
      const double k = side.stiffness[n];
      if (k == 0.)
        continue;
      if (side.normal.empty())
        springs[n] = k * unit;
      else if (const auto &e = side.normal[n]; e * direction > least - 1e-9)
        springs[n] =
            k * (across * unit + (1. - across) * dealii::symmetrize(dealii::outer_product(e, e)));
    }
  return springs;
}
} // namespace

double largest(const Matrix &matrix)
{
  return largest_eigenvalue(matrix.m(),
                            [&](auto &product, const auto &x) { matrix.vmult(product, x); });
}

Matrix added_to_modes(const ModalGroup          &bodies,
                      const contact::ClosedSide &side,
                      const scene::ContactLaw   &law)
{
  const double across = law.friction > 0. ? law.tangential_stiffness / law.stiffness : 0.;

  const bool   in_part = side.touches_in_part() && !side.normal.empty();
  Matrix       worst   = bodies.modal_matrix({});
  double       fastest = 0.;
  const Matrix free    = worst;
  for (unsigned int i = 0; i < (in_part ? n_directions : 1); ++i)
    {
      dealii::Tensor<1, 3> direction;
      if (in_part)
        {
          direction[0] = std::cos(2. * dealii::numbers::PI * i / n_directions);
          direction[1] = std::sin(2. * dealii::numbers::PI * i / n_directions);
        }
      const Matrix matrix = bodies.modal_matrix(springs_of(side, across, direction));
      const double value  = largest(matrix);
      if (value > fastest)
        {
          fastest = value;
          worst   = matrix;
        }
    }
  worst.add(-1., free);
  return worst;
}

void ModalBodies::Side::update_largest(const Matrix &of_kind,
                                       const double  factor,
                                       const double  time)
{
  if (factor > stiffness)
    {
      springs   = of_kind;
      stiffness = factor;
    }
  damping = std::max(damping, factor * time);
}

double ModalBodies::eigenvalue(const double dt) const
{
  Matrix matrix = free;
  for (const auto &[surface, side] : sides)
    matrix.add(side.stiffness + 2. / dt * side.damping, side.springs);
  return largest(matrix);
}

double ModalBodies::critical_time_step() const
{
  // a step that is too large, then ever smaller brackets: dt^2 eigenvalue(dt) grows with dt
  double low = 0., high = 2. / std::sqrt(largest(free));
  while (high - low > 1e-4 * high)
    {
      const double middle                                       = 0.5 * (low + high);
      (middle * middle * eigenvalue(middle) <= 4. ? low : high) = middle;
    }
  return low;
}
} // namespace chaindrive::stability
