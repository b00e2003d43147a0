// SPDX-License-Identifier: LGPL-2.1-or-later
// The cylindrical sides of rollers and links are uniform grids on the exact cylinder, and the
// shares of their vertices add up to its area. Bushes and pins have rings where rollers and bushes
// end that bear on them, if asked for. Other sides are refused.
#include <chaindrive/mesh/generate/links.h>
#include <chaindrive/mesh/surface/cylinder_grid.h>
#include <chaindrive/utilities/errors.h>

#include <cmath>
#include <iomanip>
#include <iostream>

using namespace chaindrive;
using dealii::Point;

namespace
{
/// Prints the grid; @p length is that of the side, m.
void check(const mesh::Part &part, const mesh::Surface side, const double radius, const double x)
{
  const mesh::CylinderGrid grid(part, side);

  double area = 0., off = 0.;
  for (unsigned int s = 0; s < grid.n_rings(); ++s)
    for (unsigned int c = 0; c < grid.n_circumferential(); ++c)
      {
        area += grid.area(s, c);
        const Point<3> p = part.mesh->get_vertices()[grid.vertex_at(s, c)];
        const Point<3> expected(grid.axis[0] + grid.radius * std::cos(grid.angles[c]),
                                grid.axis[1] + grid.radius * std::sin(grid.angles[c]),
                                grid.rings[s]);
        off = std::max(off, p.distance(expected));
      }
  const double length = grid.rings.back() - grid.rings.front();
  std::cout << part.name << ", " << mesh::surface_name(side) << ": " << grid.n_circumferential()
            << " columns, " << (grid.uniform() ? "uniform" : "NOT uniform") << ", "
            << grid.n_rings() << " rings over " << 1e3 * length << " mm; radius over exact "
            << grid.radius / radius << ", axis at " << 1e3 * grid.axis[0] << ", "
            << 1e3 * std::abs(grid.axis[1]) << " mm, expected " << 1e3 * x << "; area over exact "
            << area / (2. * dealii::numbers::PI * radius * length)
            << "; vertices in their places: " << (off < 1e-12 ? "yes" : "NO") << '\n';
}
} // namespace

int main()
{
  const auto       chain  = drive::make_chain(parameters::Chain());
  const mesh::Part roller = mesh::make_roller(chain, 7600., 2),
                   inner  = mesh::make_inner_link(chain, 7600., mesh::inner_link_grid(2)),
                   outer  = mesh::make_outer_link(chain, 7600., mesh::outer_link_grid(2));
  std::cout << std::fixed << std::setprecision(6);

  check(roller, mesh::roller_bore, 0.5 * chain.roller_bore, 0.);
  check(roller, mesh::roller_outside, 0.5 * chain.roller_diameter, 0.);
  const double inner_half = 0.5 * drive::inner_plate(chain).hole_pitch,
               outer_half = 0.5 * drive::outer_plate(chain).hole_pitch;
  check(inner, mesh::bush_outside_first, 0.5 * chain.bush_diameter, -inner_half);
  check(inner, mesh::bush_outside_second, 0.5 * chain.bush_diameter, inner_half);
  check(inner, mesh::bush_bore_first, 0.5 * chain.bush_bore, -inner_half);
  check(inner, mesh::bush_bore_second, 0.5 * chain.bush_bore, inner_half);
  check(outer, mesh::pin_outside_first, 0.5 * chain.pin_diameter, -outer_half);
  check(outer, mesh::pin_outside_second, 0.5 * chain.pin_diameter, outer_half);

  for (const bool is_inner : {true, false})
    for (const bool half : {false, true})
      {
        mesh::LinkGrid cells  = is_inner ? mesh::inner_link_grid(1) : mesh::outer_link_grid(1);
        cells.half            = half;
        cells.along           = 6;
        cells.bearing_end     = is_inner ? 0.5 * chain.roller_length :
                                           0.5 * (chain.bush_length + chain.inner_plate_thickness);
        const mesh::Part part = is_inner ? mesh::make_inner_link(chain, 7600., cells) :
                                           mesh::make_outer_link(chain, 7600., cells);
        std::cout << (half ? "half " : "") << part.name << ": rings at";
        for (const double z :
             mesh::CylinderGrid(part, is_inner ? mesh::bush_outside_first : mesh::pin_outside_first)
                 .rings)
          std::cout << ' ' << 1e3 * z;
        std::cout << " mm, also at " << 1e3 * cells.bearing_end << '\n';
      }

  for (const auto &[part, side] : {std::make_pair(&roller, mesh::roller_ends),
                                   std::make_pair(&roller, mesh::pin_bore),
                                   std::make_pair(&inner, mesh::plate_edges),
                                   std::make_pair(&inner, mesh::plate_inner_faces)})
    try
      {
        const mesh::CylinderGrid grid(*part, side);
        std::cout << "ACCEPTED: " << mesh::surface_name(side) << '\n';
      }
    catch (const InputError &error)
      {
        std::cout << "refused: " << error.what() << '\n';
      }
}
