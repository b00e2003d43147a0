// SPDX-License-Identifier: LGPL-2.1-or-later
// A seated roller presses on one flank of an elastic sprocket whose hub is held: the imported mesh
// deflects as the generated ones do. The load is a pressure on the exact seat, so that it is the
// same on all of them; the deflection is its work over its resultant.
#include "../support/modes.h"

#include <chaindrive/drive/solids.h>
#include <chaindrive/mesh/generate/sprocket.h>
#include <chaindrive/mesh/import/import.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <cmath>
#include <iomanip>
#include <iostream>

using namespace chaindrive;
using dealii::Point;
using dealii::Tensor;

namespace
{
/// Pressure of unit size at @p x [m] of a roller of radius @p r seated in gap 0 on the pitch circle
/// of radius @p pitch_radius: a bell 50 degrees wide, 50 degrees from the seat's bottom.
double pressure(const Point<3> &x, const double r, const double pitch_radius)
{
  constexpr double degree = dealii::numbers::PI / 180.;
  const double     dx = x[0] - pitch_radius, dy = x[1];
  const double     s = (std::atan2(dy, -dx) - 50. * degree) / (25. * degree);
  if (std::abs(s) >= 1. || std::hypot(dx, dy) > 1.1 * r)
    return 0.;
  const double c = std::cos(0.5 * dealii::numbers::PI * s);
  return c * c;
}

/// Deflection [m] per newton.
double compliance(const mesh::Part &part, const drive::ToothForm &form)
{
  const mesh::Nodes        nodes(part);
  const Material           steel;
  const element::Hexahedra reference(part, nodes, steel, element::Formulation::enhanced);
  test::LinearModel        model(reference);
  // what the rigid zone holds
  for (const auto &cell : part.mesh->active_cell_iterators())
    if (cell->material_id() == mesh::hub_zone)
      for (const unsigned int v : cell->vertex_indices())
        {
          const unsigned int node = nodes.of_vertex[cell->vertex_index(v)];
          for (unsigned int d = 0; d < 3 && node != mesh::Nodes::none; ++d)
            model.constrain(3 * node + d);
        }

  const dealii::FE_Q<3>   fe(1);
  dealii::FEFaceValues<3> values(fe,
                                 dealii::QGauss<2>(4),
                                 dealii::update_values | dealii::update_quadrature_points |
                                     dealii::update_normal_vectors | dealii::update_JxW_values);
  dealii::Vector<double>  force(3 * nodes.size());
  dealii::Tensor<1, 3>    resultant;
  for (const auto &cell : part.mesh->active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
      if (cell->face(f)->at_boundary() && cell->face(f)->boundary_id() == mesh::tooth_flanks)
        {
          values.reinit(cell, f);
          for (const unsigned int q : values.quadrature_point_indices())
            {
              const Tensor<1, 3> load =
                  -pressure(values.quadrature_point(q), 5.08e-3, 0.5 * form.pitch_diameter) *
                  values.JxW(q) * values.normal_vector(q);
              resultant += load;
              for (const unsigned int v : cell->vertex_indices())
                for (unsigned int d = 0; d < 3 && values.shape_value(v, q) != 0.; ++d)
                  force[3 * nodes.of_vertex[cell->vertex_index(v)] + d] +=
                      values.shape_value(v, q) * load[d];
            }
        }
  const dealii::Vector<double> u = model.displacements(force);
  return (force * u) / resultant.norm_square();
}
} // namespace

int main()
{
  const auto            chain = drive::make_chain(parameters::Chain());
  parameters::Sprockets sprockets;
  sprockets.driver().outside_diameter = 81.8e-3;
  const auto form                     = drive::make_tooth_form(15, chain, sprockets, 0);

  const double imported = compliance(
      mesh::import_sprocket(SOURCE_DIR "/../../meshes/sprocket-15.msh", form, 7600.), form);
  std::cout << std::fixed << std::setprecision(4) << "imported sprocket, deflection over that of\n";
  for (const unsigned int level : {0, 1, 2})
    std::cout << "  the generated one, refinement " << level << ": "
              << imported /
                     compliance(mesh::make_sprocket(form, {25e-3, 33e-3, 7.2e-3}, 7600., level),
                                form)
              << '\n';
}
