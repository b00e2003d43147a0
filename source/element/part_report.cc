// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/element/hexahedron_stiffness.h>
#include <chaindrive/element/part_report.h>
#include <chaindrive/mesh/mass.h>
#include <chaindrive/mesh/quality.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <set>

namespace chaindrive::element
{
using dealii::Tensor;
using mesh::Corners;

namespace
{
/// Lengths between all pairs of vertices, over the first, rounded: equal for cells that differ by a
/// motion only.
std::vector<long> fingerprint(const Corners &x, const double unit, const double density)
{
  std::vector<long> key = {std::lround(density * 1e3)};
  for (unsigned int a = 0; a < 8; ++a)
    for (unsigned int b = a + 1; b < 8; ++b)
      key.push_back(std::lround((x[a] - x[b]).norm() / unit * 1e7));
  return key;
}

double area(const dealii::Triangulation<3>::active_face_iterator &face)
{
  // of the bilinear quadrilateral, by 2 x 2 Gauss points
  static const dealii::QGauss<2> quadrature(2);
  double                         sum = 0.;
  for (unsigned int q = 0; q < quadrature.size(); ++q)
    {
      const double       u = quadrature.point(q)[0], v = quadrature.point(q)[1];
      const Tensor<1, 3> x_u =
          (1. - v) * (face->vertex(1) - face->vertex(0)) + v * (face->vertex(3) - face->vertex(2));
      const Tensor<1, 3> x_v =
          (1. - u) * (face->vertex(2) - face->vertex(0)) + u * (face->vertex(3) - face->vertex(1));
      sum += dealii::cross_product_3d(x_u, x_v).norm() * quadrature.weight(q);
    }
  return sum;
}

Tensor<1, 3> relative_error(const drive::MassProperties &value, const drive::MassProperties &exact)
{
  Tensor<1, 3> error;
  for (unsigned int d = 0; d < 3; ++d)
    error[d] = value.inertia[d][d] / exact.inertia[d][d] - 1.;
  return error;
}

std::string percent(const double ratio)
{
  return to_text(std::abs(ratio) < 1e-9 ? 0. : 100. * ratio, 3) + " %";
}
} // namespace

PartReport make_report(const mesh::Part &part, const Material &material)
{
  const dealii::Triangulation<3> &mesh = *part.mesh;

  PartReport report;
  report.name            = part.name;
  report.n_cells         = mesh.n_active_cells();
  report.n_vertices      = mesh.n_used_vertices();
  report.n_elastic_cells = 0;
  report.smallest_edge   = std::numeric_limits<double>::max();
  report.scaled_jacobian = 1.;
  report.aspect_ratio    = 1.;

  double                               frequency = 0.;
  std::set<std::vector<long>>          shapes;
  std::array<bool, mesh::n_components> seen{};
  const unsigned int in_sector = mesh.n_active_cells() / part.n_sectors; // the others are alike
  for (const auto &cell : mesh.active_cell_iterators())
    {
      if (cell->active_cell_index() >= in_sector)
        break;
      const Corners x = mesh::corners_of(cell);

      report.scaled_jacobian = std::min(report.scaled_jacobian, mesh::scaled_jacobian(x));

      seen[cell->material_id()] = true;
      if (cell->material_id() == mesh::hub_zone)
        continue;
      report.n_elastic_cells += part.n_sectors;

      double shortest = std::numeric_limits<double>::max(), longest = 0.;
      for (const unsigned int l : cell->line_indices())
        {
          const double length = (cell->line(l)->vertex(0) - cell->line(l)->vertex(1)).norm();
          shortest            = std::min(shortest, length);
          longest             = std::max(longest, length);
        }
      report.smallest_edge = std::min(report.smallest_edge, shortest);
      report.aspect_ratio  = std::max(report.aspect_ratio, longest / shortest);

      const double density = part.density_of(cell->material_id());
      if (shapes.insert(fingerprint(x, 1e-3, density)).second)
        frequency = std::max(frequency, largest_frequency(x, material, density, frequency));
    }
  report.n_distinct_cells   = static_cast<unsigned int>(shapes.size());
  report.critical_time_step = 2. / frequency;

  report.exact_mass = part.exact.mass;
  for (unsigned int d = 0; d < 3; ++d)
    report.exact_inertia[d] = part.exact.inertia[d][d];
  report.mass_error   = part.meshed.mass / part.exact.mass - 1.;
  report.meshed_error = relative_error(part.meshed, part.exact);
  report.lumped_error = relative_error(mesh::lumped_properties(part), part.exact);
  for (unsigned int c = 0; c < mesh::n_components; ++c)
    if (seen[c])
      report.factors.push_back({mesh::component_name(c), part.density_factor[c]});

  std::array<PartReport::Side, mesh::n_surfaces> sides;
  for (unsigned int s = 0; s < mesh::n_surfaces; ++s)
    sides[s] = {mesh::surface_name(s), 0, 0.};
  for (const auto &face : mesh.active_face_iterators())
    if (face->at_boundary())
      {
        ++sides[face->boundary_id()].n_faces;
        sides[face->boundary_id()].area += area(face);
      }
  for (const PartReport::Side &side : sides)
    if (side.n_faces > 0)
      report.sides.push_back(side);
  return report;
}

void print(std::ostream &out, const std::vector<PartReport> &reports)
{
  const auto row = [&out](const std::string &name, const std::vector<std::string> &cells) {
    out << "  " << name << std::string(name.size() < 16 ? 16 - name.size() : 1, ' ');
    for (const std::string &cell : cells)
      out << std::setw(11) << cell;
    out << '\n';
  };
  out << "Meshes\n";
  row("",
      {"cells",
       "vertices",
       "edge (mm)",
       "Jacobian",
       "aspect",
       "mass (g)",
       "error",
       "inertia",
       "step (us)"});
  for (const PartReport &report : reports)
    {
      double inertia = 0.;
      for (unsigned int d = 0; d < 3; ++d)
        inertia = std::max(inertia, std::abs(report.lumped_error[d]));
      row(report.name,
          {std::to_string(report.n_cells),
           std::to_string(report.n_vertices),
           to_text(1e3 * report.smallest_edge, 3),
           to_text(report.scaled_jacobian, 3),
           to_text(report.aspect_ratio, 3),
           to_text(1e3 * report.exact_mass, 4),
           percent(report.mass_error),
           percent(inertia),
           to_text(1e6 * report.critical_time_step, 3)});
    }
}
} // namespace chaindrive::element
