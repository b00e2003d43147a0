// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/gauss_points.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>

namespace chaindrive::mesh
{
using dealii::Tensor;

std::array<GaussPoint, 8> gauss_points(const Corners &corners)
{
  static const dealii::FE_Q<3>   fe(1);
  static const dealii::QGauss<3> rule(2);

  const auto jacobian = [&](const dealii::Point<3> &at) { // dx_i / dxi_j
    Tensor<2, 3> j;
    for (unsigned int a = 0; a < 8; ++a)
      j += outer_product(Tensor<1, 3>(corners[a]), fe.shape_grad(a, at));
    return j;
  };
  const Tensor<2, 3> middle         = jacobian({0.5, 0.5, 0.5});
  const Tensor<2, 3> middle_inverse = invert(middle);

  std::array<GaussPoint, 8> points;
  for (unsigned int q = 0; q < 8; ++q)
    {
      const dealii::Point<3> &at      = rule.point(q);
      const Tensor<2, 3>      here    = jacobian(at);
      const Tensor<2, 3>      inverse = invert(here);
      points[q].volume                = determinant(here) * rule.weight(q);
      for (unsigned int a = 0; a < 8; ++a)
        {
          points[q].value[a]    = fe.shape_value(a, at);
          points[q].gradient[a] = fe.shape_grad(a, at) * inverse;
        }
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
