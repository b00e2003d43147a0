// SPDX-License-Identifier: LGPL-2.1-or-later

// Mass and inertia of the solid parts of a 525 chain in g, g mm2, against an independent
// calculation, and against closed forms.

#include "compare.h"

#include <chaindrive/drive/solids.h>

#include <deal.II/base/numbers.h>

using namespace chaindrive;

int main()
{
  const double           density = 7600.;
  drive::ChainDimensions chain   = drive::make_chain(parameters::Chain());
  const auto             roller  = drive::roller_solid(chain, density);
  compare("roller, g", roller.mass * 1e3, 1.9502, 4);
  compare("roller J, g mm2", roller.inertia[2][2] * 1e9, 38.95, 2);
  compare("bush, g", drive::bush_solid(chain, density).mass * 1e3, 1.5899, 4);
  compare("pin, g", drive::pin_solid(chain, density).mass * 1e3, 1.8081, 4);

  std::cout << "== plates with hole pitch 15.875: area mm2, mass g, J g mm2, net height at the "
               "hole, waist radius, tangency angle\n";
  struct Expected
  {
    double hole, height, waist_ratio, area, mass, J, net_hole, radius, theta;
  };
  for (const Expected &e : {Expected{7.43, 15.09, 0.7, 295.78, 4.496, 411.6, 15.32, 7.504, 58.17},
                            Expected{5.24, 13.02, 0.7, 263.11, 3.999, 304.6, 15.56, 10.60, 62.35},
                            Expected{7.43, 15.09, 1.0, 331.68, 5.042, 440.3, 15.32, 0., 90.},
                            Expected{5.24, 13.02, 1.0, 296.70, 4.510, 326.0, 15.56, 0., 90.}})
    {
      const drive::Plate plate{
          15.875e-3, e.hole * 1e-3, e.height * 1e-3, e.waist_ratio * e.height * 1e-3, 2e-3};
      const auto solid = drive::plate_solid(plate, density);
      compare("area", plate.area() * 1e6, e.area, 2);
      compare("mass", solid.mass * 1e3, e.mass, 3);
      compare("J", solid.inertia[2][2] * 1e9, e.J, 1);
      compare("net section at the hole",
              plate.net_height(0.5 * plate.hole_pitch) * plate.thickness * 1e6,
              e.net_hole,
              2);
      compare("net section at mid-pitch",
              plate.net_height(0.) * plate.thickness * 1e6,
              2. * e.waist_ratio * e.height,
              2);
      compare("tangency angle", plate.tangency_angle() * 180. / dealii::numbers::PI, e.theta, 2);
      if (plate.has_waist())
        compare("waist radius", plate.waist_radius() * 1e3, e.radius, 2);
    }

  std::cout << "== links, both hole pitches 15.875\n";
  parameters::Chain nominal;
  nominal.pitch_set = parameters::PitchSet::nominal;
  chain             = drive::make_chain(nominal);
  const auto inner  = drive::inner_link_solid(chain, density);
  const auto outer  = drive::outer_link_solid(chain, density);
  compare("mass per pitch, g", (roller.mass + 0.5 * (inner.mass + outer.mass)) * 1e3, 13.843, 2);
  const auto   plate = drive::plate_solid(drive::inner_plate(chain), density);
  const auto   bush  = drive::bush_solid(chain, density);
  const double half = 0.5 * chain.inner_hole_pitch, z = chain.inner_plate_z;
  compare("inner link about z over its parts",
          inner.inertia[2][2] /
              (2. * plate.inertia[2][2] + 2. * bush.inertia[2][2] + 2. * bush.mass * half * half),
          1.,
          9);
  compare("inner link about x over its parts",
          inner.inertia[0][0] /
              (2. * plate.inertia[0][0] + 2. * plate.mass * z * z + 2. * bush.inertia[0][0]),
          1.,
          9);
  verdict("centre of mass at the origin",
          inner.centre.norm() < 1e-18 && outer.centre.norm() < 1e-18);

  std::cout << "== sprockets\n";
  parameters::Sprockets sprockets;
  sprockets.driven().outside_diameter = 219e-3;
  const drive::ToothForm form         = drive::make_tooth_form(42, chain, sprockets, 1);
  const auto             wheel        = drive::sprocket_solid(form, 25e-3, 7.2e-3, density);
  compare("mass, kg", wheel.mass, (34250.0166 - 490.8739) * 7.2 * 7.6e-6, 6);
  compare("J, 1e-2 kg m2", wheel.inertia[2][2] * 1e2, 1.025, 3);

  // moments of the exact arcs against those of a fine polygon
  const auto line = form.polyline(200);
  double     area = 0., polar = 0.;
  for (std::size_t i = 0; i < line.size(); ++i)
    {
      const auto side = drive::line_segment(line[i], line[(i + 1) % line.size()]);
      area += side.area();
      polar += side.polar_moment();
    }
  compare("area over the polygon's", form.area() / area, 1., 5);
  compare("polar moment over the polygon's", form.polar_moment() / polar, 1., 5);
}
