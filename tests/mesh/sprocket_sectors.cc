// SPDX-License-Identifier: LGPL-2.1-or-later
// A sprocket's mesh is cyclic cell by cell, its profile's vertices are on the exact arcs, and its
// volume tends to the solid's. The tangent of a profile is the derivative of its points.

#include <chaindrive/mesh/generate/half_profile.h>
#include <chaindrive/mesh/generate/sprocket.h>
#include <chaindrive/mesh/mass.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>

using namespace chaindrive;
using dealii::Point;

namespace
{
std::string verdict(const double value, const double limit)
{
  return value < limit ? "yes" : std::to_string(value / limit) + " times too large";
}

/// Largest distance between a cell of any sector and the cell of sector 0 turned to it, over the
/// sprocket's radius.
double asymmetry(const mesh::Part &part)
{
  const auto        &mesh    = *part.mesh;
  const unsigned int n_cells = mesh.n_active_cells() / part.n_sectors;
  double             worst = 0., radius = 0.;
  const auto         cell_at = [&mesh](const unsigned int i) {
    return dealii::Triangulation<3>::active_cell_iterator(&mesh, 0, i);
  };
  for (unsigned int s = 0; s < part.n_sectors; ++s)
    {
      const double angle = 2. * dealii::numbers::PI * s / part.n_sectors;
      for (unsigned int c = 0; c < n_cells; ++c)
        for (unsigned int v = 0; v < 8; ++v)
          {
            const Point<3> x = cell_at(c)->vertex(v), y = cell_at(s * n_cells + c)->vertex(v);
            const Point<3> turned(std::cos(angle) * x[0] - std::sin(angle) * x[1],
                                  std::sin(angle) * x[0] + std::cos(angle) * x[1],
                                  x[2]);
            worst  = std::max(worst, turned.distance(y));
            radius = std::max(radius, y.norm());
          }
    }
  return worst / radius;
}

/// Largest difference between tangents of the profile and differences of its points by arc length,
/// except next to where two segments meet.
double wrong_tangent(const drive::ToothForm &form)
{
  const mesh::HalfProfile profile(form);
  constexpr unsigned int  n     = 500;
  const double            step  = 1e-4 * profile.length();
  double                  worst = 0.;
  std::vector<double>     joints{0.};
  for (const drive::Segment &segment : form.half_profile)
    joints.push_back(joints.back() + segment.length());
  for (unsigned int i = 0; i < n; ++i)
    {
      const double s = (i + 0.5) / n * profile.length();
      if (std::all_of(joints.begin(), joints.end(), [&](const double joint) {
            return std::abs(joint - s) > step;
          }))
        worst = std::max(
            worst,
            (profile.tangent(s) - (profile.at(s + step) - profile.at(s - step)) / (2. * step))
                .norm());
    }
  return worst;
}
} // namespace

int main()
{
  const double density = 7600.;
  const auto   chain   = drive::make_chain(parameters::Chain());
  for (const auto form_name : {parameters::StandardForm::iso_min,
                               parameters::StandardForm::iso_max,
                               parameters::StandardForm::ansi})
    for (const unsigned int z : {9, 15})
      {
        parameters::Sprockets sprockets;
        sprockets.tooth_form = form_name;
        const auto   form    = drive::make_tooth_form(z, chain, sprockets, 0);
        const double hub     = 0.6 * form.root_diameter;
        std::cout << text_of(form_name) << ", z = " << z << ": error of the volume in ppm";
        double profile_error = 0., cyclic_error = 0., mass_error = 0.;
        for (const unsigned int level : {0, 2})
          {
            const auto part = mesh::make_sprocket(form, {0.5 * hub, hub, 7.2e-3}, density, level);
            const auto volumes = mesh::component_volumes(*part.mesh);
            std::cout << ' ' << std::fixed << std::setprecision(1)
                      << 1e6 * (density * (volumes[mesh::rim] + volumes[mesh::hub_zone]) /
                                    part.exact.mass -
                                1.);
            for (const auto &face : part.mesh->active_face_iterators())
              if (face->at_boundary() && face->boundary_id() == mesh::tooth_flanks)
                for (unsigned int v = 0; v < 4; ++v)
                  profile_error = std::max(
                      profile_error,
                      std::abs(
                          form.closest_point({face->vertex(v)[0], face->vertex(v)[1]}).distance) /
                          form.pitch);
            cyclic_error = std::max(cyclic_error, asymmetry(part));
            mass_error   = std::max(mass_error, std::abs(part.meshed.mass / part.exact.mass - 1.));
          }
        std::cout << "\n  profile exact " << verdict(profile_error, 1e-12) << ", cyclic "
                  << verdict(cyclic_error, 1e-14) << ", mass exact " << verdict(mass_error, 1e-11)
                  << ", tangents " << verdict(wrong_tangent(form), 1e-6) << '\n';
      }
}
