// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/quality.h>

#include <algorithm>
#include <limits>

namespace chaindrive::mesh
{
using dealii::Tensor;

Corners corners_of(const dealii::Triangulation<3>::active_cell_iterator &cell)
{
  Corners corners;
  for (const unsigned int v : cell->vertex_indices())
    corners[v] = cell->vertex(v);
  return corners;
}

double scaled_jacobian(const Corners &corners)
{
  double worst = std::numeric_limits<double>::max();
  for (unsigned int v = 0; v < 8; ++v)
    {
      std::array<Tensor<1, 3>, 3> e;
      for (unsigned int d = 0; d < 3; ++d)
        {
          // the other end of the edge along direction d
          e[d]                = corners[v ^ (1u << d)] - corners[v];
          const double length = e[d].norm();
          if (!(length > 0.))
            return 0.; // and never the ratio of two zeros
          e[d] /= (v >> d) & 1u ? -length : length;
        }
      worst = std::min(worst, dealii::cross_product_3d(e[0], e[1]) * e[2]);
    }
  return worst;
}
} // namespace chaindrive::mesh
