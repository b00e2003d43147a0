// SPDX-License-Identifier: LGPL-2.1-or-later
// Rollers in every gap of the imported sprocket and of a generated one: the smooth surface over the
// facets against the exact arcs, near the seats and all around the teeth.

#include <chaindrive/mesh/generate/sprocket.h>
#include <chaindrive/mesh/import/import.h>
#include <chaindrive/mesh/mass.h>
#include <chaindrive/mesh/surface/facet_surface.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <random>

using namespace chaindrive;
using dealii::Point;

namespace
{
void compare(const mesh::Part &part, const drive::ToothForm &form)
{
  const mesh::FacetSurface               surface(part, mesh::tooth_flanks);
  std::mt19937                           generator(1);
  std::uniform_real_distribution<double> any(-1., 1.);

  double       seated = 0., around = 0., normal = 0., hinted = 0.;
  unsigned int n_missed = 0, facet = mesh::Projection::no_facet;
  for (unsigned int i = 0; i < 6000; ++i)
    {
      // the first third within 0.3 mm of where a seated roller has its centre
      const bool     near  = i % 3 == 0;
      const double   gap   = 2. * dealii::numbers::PI * (i % form.teeth) / form.teeth;
      const double   angle = gap + any(generator) * (near ? 0.3e-3 / 0.038 : 0.21);
      const double   r     = near ? 0.5 * form.pitch_diameter + 0.3e-3 * any(generator) :
                                    0.5 * form.outside_diameter + 6e-3 * any(generator);
      const Point<3> p(r * std::cos(angle), r * std::sin(angle), 3.5e-3 * any(generator));
      const auto     exact = form.closest_point({p[0], p[1]});
      if (exact.distance < -0.5e-3 || exact.distance > 9e-3)
        continue;
      const auto found = surface.closest_point(p, 10e-3);
      const auto again = surface.closest_point(p, 10e-3, facet);
      facet            = found.facet;
      if (!found.found)
        {
          ++n_missed;
          continue;
        }
      const double error       = std::abs(found.distance - exact.distance);
      (near ? seated : around) = std::max(near ? seated : around, error);
      hinted                   = std::max(hinted, std::abs(again.distance - found.distance));
      // where two sides are equally near, either normal is right
      const double turn =
          std::hypot(found.normal[0] - exact.normal[0], found.normal[1] - exact.normal[1]);
      if (turn < 0.1)
        normal = std::max(normal, turn);
    }
  std::cout << part.name << ": " << surface.n_facets() << " facets, missed " << n_missed
            << "\n  seated: error below 1 nm " << (seated < 1e-9 ? "yes" : "no") << ", elsewhere "
            << (around < 1e-9 ? "yes" : "no") << ", normal below 1e-4 "
            << (normal < 1e-4 ? "yes" : "no") << ", the same with a hint "
            << (hinted < 1e-15 ? "yes" : "no") << '\n';
}
} // namespace

int main()
{
  const auto            chain = drive::make_chain(parameters::Chain());
  parameters::Sprockets sprockets;
  sprockets.driver().outside_diameter = 81.8e-3;
  const auto form                     = drive::make_tooth_form(15, chain, sprockets, 0);

  const auto imported =
      mesh::import_sprocket(SOURCE_DIR "/../../meshes/sprocket-15.msh", form, 7600.);
  const auto solid = drive::sprocket_solid(form, 25e-3, 7.2e-3, 7600.);
  std::cout << std::fixed << std::setprecision(4) << "imported: mass "
            << imported.meshed.mass / solid.mass << " of the solid's, inertia "
            << imported.meshed.inertia[2][2] / solid.inertia[2][2] << '\n';
  compare(imported, form);
  compare(mesh::make_sprocket(form, {25e-3, 33e-3, 7.2e-3}, 7600., 0), form);

  sprockets.tooth_form = parameters::StandardForm::ansi;
  sprockets.driver().outside_diameter.reset();
  const auto ansi = drive::make_tooth_form(15, chain, sprockets, 0);
  compare(mesh::make_sprocket(ansi, {25e-3, 33e-3, 7.2e-3}, 7600., 2), ansi);
}
