// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/element/solid_shell_stiffness.h>
#include <chaindrive/observe/plate_stress.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::observe
{
using dealii::Point;
using dealii::SymmetricTensor;
using dealii::Tensor;

PlateStress::PlateStress(const mesh::Part             &part,
                         const mesh::Nodes            &nodes,
                         const Material               &material,
                         const parameters::ElementType plates)
    : material_(material), plates_(plates)
{
  const auto   in_middle = [](const Point<3> &x) { return std::abs(x[0]) < 1e-9; };
  const auto   on_axis   = [&](const Point<3> &x) { return in_middle(x) && std::abs(x[1]) < 1e-9; };
  Tensor<1, 3> along, upwards, outwards;
  double       area = 0.;
  along[0] = upwards[1] = outwards[2] = 1.;

  for (const auto &cell : part.mesh->active_cell_iterators())
    {
      const bool plate =
          cell->material_id() == mesh::inner_plate || cell->material_id() == mesh::outer_plate;
      if (!plate || cell->center()[2] < 0.)
        continue;

      // Forces between two halves of the plate: what the cells of one half exert on the nodes in
      // the middle, -V F S B. Their hourglass forces have no part in the sum, or little.
      Cell         of_section;
      Tensor<1, 3> pull;
      of_section.gradients = element::mean_gradients(mesh::corners_of(cell));
      for (unsigned int v = 0; v < 8; ++v)
        if (in_middle(cell->vertex(v)))
          pull -= cell->measure() * of_section.gradients[v];
      if (pull.norm() > 0.)
        {
          of_section.weight = (cell->center()[0] > 0. ? 0.5 : -0.5) * pull;
          for (unsigned int v = 0; v < 8; ++v)
            of_section.node[v] = place_of(nodes.of_vertex[cell->vertex_index(v)]);
          if (plates != parameters::ElementType::solid)
            of_section.wall.emplace(mesh::corners_of(cell), outwards, material, plates);
          section_.push_back(of_section);
        }

      for (const auto &face : cell->face_iterators())
        {
          std::array<Point<3>, 4> corners;
          Face                    here;
          for (unsigned int v = 0; v < 4; ++v)
            corners[v] = face->vertex(v);
          const auto add_to = [&](std::vector<Face> &faces, const Tensor<1, 3> &across) {
            for (unsigned int v = 0; v < 4; ++v)
              here.node[v] = place_of(nodes.of_vertex[face->vertex_index(v)]);
            here.gradients = element::face_gradients(corners, along, across);
            faces.push_back(here);
          };

          if (std::all_of(corners.begin(), corners.end(), in_middle))
            area += 0.5 * face->measure(); // seen from both sides
          if (!face->at_boundary())
            continue;
          if (face->boundary_id() == mesh::plate_edges &&
              std::any_of(corners.begin(), corners.end(), in_middle))
            add_to(face->center()[1] > 0. ? upper_edge_ : lower_edge_, outwards);
          else if (std::any_of(corners.begin(), corners.end(), on_axis))
            {
              if (face->boundary_id() == mesh::plate_inner_faces)
                add_to(inner_face_, upwards);
              if (face->boundary_id() == mesh::plate_outer_faces)
                add_to(outer_face_, upwards);
            }
        }
    }
  AssertThrow(!section_.empty() && !upper_edge_.empty() && !lower_edge_.empty() &&
                  !inner_face_.empty() && !outer_face_.empty(),
              dealii::ExcMessage("no plate with vertices in its middle: " + part.name));

  for (Cell &cell : section_)
    cell.weight /= area;
}

unsigned int PlateStress::place_of(const unsigned int node)
{
  const auto         found = std::find(nodes_.begin(), nodes_.end(), node);
  const unsigned int place = static_cast<unsigned int>(found - nodes_.begin());
  if (found == nodes_.end())
    nodes_.push_back(node);
  return place;
}

SymmetricTensor<2, 2> PlateStress::mean(const std::vector<Face>         &faces,
                                        const std::vector<Tensor<1, 3>> &position) const
{
  SymmetricTensor<2, 2> sum;
  for (const Face &face : faces)
    {
      std::array<Tensor<1, 3>, 4> corners;
      for (unsigned int v = 0; v < 4; ++v)
        corners[v] = position[face.node[v]];
      sum += element::face_stress(face.gradients, corners, material_);
    }
  return sum / static_cast<double>(faces.size());
}

WaistComponents PlateStress::components(const std::vector<Tensor<1, 3>> &position) const
{
  WaistComponents found{};
  for (const Cell &cell : section_)
    {
      std::array<Tensor<1, 3>, 8> corners;
      for (unsigned int v = 0; v < 8; ++v)
        corners[v] = position[cell.node[v]];
      const element::Stress s =
          cell.wall.has_value() ?
              cell.wall->mean(corners) :
              element::stress(element::deformation_gradient(cell.gradients, corners), material_);
      found.axial += (s.piola * cell.weight)[0];
    }
  const SymmetricTensor<2, 2> inner = mean(inner_face_, position);
  const SymmetricTensor<2, 2> outer = mean(outer_face_, position);
  found.in_plane = 0.5 * (mean(lower_edge_, position)[0][0] - mean(upper_edge_, position)[0][0]);
  found.out_of_plane =
      (plates_ == parameters::ElementType::membrane ? element::membrane_bending : 1.) * 0.5 *
      (outer[0][0] - inner[0][0]);
  found.middle = 0.5 * (inner + outer);
  return found;
}

WaistStress stress_of(const WaistComponents &components)
{
  const auto principal = eigenvalues(components.middle);
  return {
      components.axial, components.in_plane, components.out_of_plane, principal[0], principal[1]};
}
} // namespace chaindrive::observe
