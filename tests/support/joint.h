// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Elastic bodies with cylindrical sides, and joints of them, for the tests of contact.

#include "basics.h"
#include "elastic.h"

#include <chaindrive/contact/joints.h>

namespace test
{
using dealii::numbers::PI;

/// ring() with named sides: its bore is a roller's, its outside a bush's. z from 0 to @p length.
inline mesh::Part tube(const double                       inner,
                       const double                       outer,
                       const double                       length,
                       const std::array<unsigned int, 3> &cells)
{
  mesh::Part part = ring(inner, outer, length, cells);
  for (const auto &cell : part.mesh->active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
      if (cell->face(f)->at_boundary())
        {
          const Point<3> centre = cell->face(f)->center();
          const double   r      = std::hypot(centre[0], centre[1]);
          const bool     end    = centre[2] < 1e-9 || centre[2] > length - 1e-9;
          cell->face(f)->set_boundary_id(end                       ? mesh::roller_ends :
                                         r < 0.5 * (inner + outer) ? mesh::roller_bore :
                                                                     mesh::bush_outside_first);
        }
  return part;
}

/// A rotation about z.
inline Tensor<2, 3> turn_about_z(const double angle)
{
  Tensor<2, 3> r;
  r[0][0] = r[1][1] = std::cos(angle);
  r[1][0]           = std::sin(angle);
  r[0][1]           = -r[1][0];
  r[2][2]           = 1.;
  return r;
}

/// n_lanes copies of a tube with the grid of the side that takes part in contact.
struct Tubes
{
  Tubes(const mesh::Part           &part,
        const mesh::Surface         side,
        const element::Kernels     &kernels     = element::best_kernels(),
        const Formulation           formulation = Formulation::enhanced,
        const parameters::Material &material    = parameters::Material())
      : grid(part, side)
      , reference(part, material, formulation)
      , batch(reference, kernels)
      , offsets(contact::node_offsets(grid, mesh::Nodes(part).vertex))
  {
    for (const auto &x : reference.position)
      centre += x;
    centre /= reference.n_nodes();
  }

  contact::JointBody body(const unsigned int lane)
  {
    return {offsets.data(),
            batch.position.data() + lane,
            batch.velocity.data() + lane,
            batch.force.data() + lane};
  }

  /// Puts one copy with its centre to @p at, turned by @p rotation about it.
  void place(const unsigned int lane, const Tensor<1, 3> &at, const Tensor<2, 3> &rotation)
  {
    batch.set(batch.position, lane, [&](const Point<3> &x, unsigned int) {
      return at + rotation * (x - centre);
    });
  }

  /// Node of the reference at a place of the grid.
  unsigned int node(const unsigned int station, const unsigned int column) const
  {
    return offsets[station * grid.n_circumferential() + column] / (3 * n_lanes);
  }

  mesh::CylinderGrid        grid;
  Hexahedra                 reference;
  Batch                     batch;
  std::vector<unsigned int> offsets;
  Point<3>                  centre; ///< of the part, m
};
} // namespace test
