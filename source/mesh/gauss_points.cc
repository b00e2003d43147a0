// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/gauss_points.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>

namespace chaindrive::mesh
{
namespace
{
using dealii::Tensor;

/// The shape functions on the unit cell, which are the same for all cells: in the middle and at the
/// points of the rule. deal.II would find their polynomials anew at every call.
struct UnitCell
{
  using Gradients = std::array<Tensor<1, 3>, 8>;

  UnitCell()
  {
    const dealii::FE_Q<3> fe(1);
    for (unsigned int a = 0; a < 8; ++a)
      {
        in_middle[a] = fe.shape_grad(a, {0.5, 0.5, 0.5});
        for (unsigned int q = 0; q < 8; ++q)
          {
            value[q][a]    = fe.shape_value(a, rule.point(q));
            gradient[q][a] = fe.shape_grad(a, rule.point(q));
          }
      }
  }

  const dealii::QGauss<3>              rule{2};
  Gradients                            in_middle;
  std::array<std::array<double, 8>, 8> value;    ///< [point][shape function]
  std::array<Gradients, 8>             gradient; ///< [point]
};
} // namespace

std::array<GaussPoint, 8> gauss_points(const Corners &corners)
{
  static const UnitCell unit;

  const auto jacobian = [&](const UnitCell::Gradients &gradient) { // dx_i / dxi_j
    Tensor<2, 3> j;
    for (unsigned int a = 0; a < 8; ++a)
      j += outer_product(Tensor<1, 3>(corners[a]), gradient[a]);
    return j;
  };
  const Tensor<2, 3> middle         = jacobian(unit.in_middle);
  const Tensor<2, 3> middle_inverse = invert(middle);

  std::array<GaussPoint, 8> points;
  for (unsigned int q = 0; q < 8; ++q)
    {
      const dealii::Point<3> &at      = unit.rule.point(q);
      const Tensor<2, 3>      here    = jacobian(unit.gradient[q]);
      const Tensor<2, 3>      inverse = invert(here);
      points[q].volume                = determinant(here) * unit.rule.weight(q);
      points[q].value                 = unit.value[q];
      for (unsigned int a = 0; a < 8; ++a)
        points[q].gradient[a] = unit.gradient[q][a] * inverse;
      for (unsigned int d = 0; d < 3; ++d)
        points[q].incompatible[d] =
            (determinant(middle) / determinant(here) * 4. * (1. - 2. * at[d])) * middle_inverse[d];
    }
  return points;
}

std::array<double, 8> lumped_masses(const std::array<GaussPoint, 8> &points, const double density)
{
  std::array<double, 8> masses{};
  for (const GaussPoint &point : points)
    for (unsigned int a = 0; a < 8; ++a)
      masses[a] += density * point.value[a] * point.volume;
  return masses;
}
} // namespace chaindrive::mesh
