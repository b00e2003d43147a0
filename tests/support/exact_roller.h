// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Two reduced rollers between teeth and the bushes of a link, none of which have a penalty, of
// three chains.

#include "roller_on_bush.h"

#include <chaindrive/drive/stiffness.h>
#include <chaindrive/scene/build.h>
#include <chaindrive/statics/part_stiffness.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace test::exact_roller
{
enum class Place
{
  bottom, ///< of the seat
  seat,   ///< at its end, where rollers of a new chain bear: on seat and flank
  flank
};

inline const char *name(const Place place)
{
  return place == Place::bottom ? "at the bottom of the seat" :
         place == Place::seat   ? "at the end of the seat" :
                                  "on the flank";
}

/// A chain, the load [N] that it works under, and a sprocket of 15 teeth, 25 mm bore and 33 mm hub
/// for 525 and in proportion for others.
struct Size
{
  drive::ChainDimensions chain;
  double                 load;
  drive::Sprocket        sprocket;
  double                 sprocket_width;
};

inline const Size &size_of(const std::string &designation)
{
  static const std::map<std::string, double> loads = {
      {"525", 1412.}, {"06B", 565.}, {"16A", 3530.}};
  static std::map<std::string, Size> made;
  if (const auto known = made.find(designation); known != made.end())
    return known->second;
  parameters::Chain entries;
  const auto        usual = drive::make_chain(entries);
  entries.designation     = designation;
  Size         size{drive::make_chain(entries), loads.at(designation), {}, 7.2e-3};
  const double larger        = size.chain.pitch / usual.pitch;
  size.sprocket.form         = tooth_form(size.chain, larger);
  size.sprocket.bore         = larger * 25e-3;
  size.sprocket.hub_diameter = larger * 33e-3;
  size.sprocket_width *= size.chain.inner_width / usual.inner_width;
  return made.emplace(designation, size).first->second;
}

struct Case
{
  std::string                         chain     = "525";
  Place                               place     = Place::seat;
  double                              stiffness = 0.; ///< of the tooth, N/m
  std::vector<drive::PlacedStiffness> places    = {}; ///< or at places of the seat
  double                              load      = 0.; ///< N, by which the link is pressed
  double                              phase     = 0.; ///< of the roller, columns
  double                              above     = 0.; ///< the tooth at first, m
  double                              speed     = 0.; ///< towards it, m/s
  double                              friction  = 0.;
  double                              in_bore   = 0.;
  double                              spin      = 0.;   ///< rad/s
  double                              mass      = 1.;   ///< of the link, kg
  bool                                fine      = true; ///< is the link's mesh, else that of runs
  /// Modes of rollers and links are slowed to these, kHz; 0: none.
  double slowed_rollers = 0., slowed_links = 0.;
};

/// Centre of the roller at the tooth and the normal there, in the sprocket's frame.
inline std::pair<Vector3, Vector3>
touch(const drive::ToothForm &form, const double radius, const Place place)
{
  const drive::Segment &seat = form.half_profile.front();
  if (place != Place::flank)
    {
      const double angle =
          dealii::numbers::PI - (place == Place::seat ? statics::seat_end(form) : 0.);
      const auto out = vector(std::cos(angle), std::sin(angle));
      return {vector(seat.centre[0], seat.centre[1]) + (seat.radius - radius) * out, -out};
    }
  return before_flank(form, radius, 0.);
}

inline scene::Scene make(const Case &c)
{
  Tooth tooth;
  tooth.elastic      = false;
  scene::Scene scene = make_scene(tooth);
  const Size  &size  = size_of(c.chain);
  const auto  &chain = size.chain;
  mesh_roller_and_link(scene, chain, mesh::RollerGrid(3, 32, 6), {48, 2, 2, 2, 12});
  if (!c.fine)
    {
      Parameters p;
      p.drive.chain.designation            = c.chain;
      p.mesh.refinement                    = 1;
      scene.parts[scene::Kind::inner_link] = scene::make_link_part(
          {p.mesh, scene.material.density, false, true}, drive::make_drive(p), true);
    }

  scene::ToothFamily &teeth   = scene.teeth[0];
  const double        radius  = 0.5 * chain.roller_diameter;
  teeth.form                  = std::make_shared<const drive::ToothForm>(size.sprocket.form);
  teeth.outer_radius          = 0.5 * teeth.form->outside_diameter;
  teeth.half_width            = 0.5 * size.sprocket_width;
  teeth.slaves[0].radius      = radius;
  const double play           = teeth.form->seat_radius - radius;
  const auto [centre, normal] = touch(*teeth.form, radius, c.place);
  const auto turn =
      to_matrix(rotation_about_z(0.5 * dealii::numbers::PI - std::atan2(normal[1], normal[0])));
  scene.bodies[1].initial.rotation = turn;
  scene::Body &roller              = scene.bodies[0];
  roller.initial.position          = turn * (centre + c.above * normal);
  roller.initial.rotation = to_matrix(rotation_about_z(c.phase * 2. * dealii::numbers::PI / 32.));
  roller.initial.velocity = vector(0., -c.speed);
  roller.initial.angular_velocity = vector(0., 0., c.spin);
  constexpr double inertia        = 1e6; // kg m2: it does not turn
  scene.bodies.push_back(link_on_roller(chain, scene::Motion::elastic, c.mass, inertia, roller));

  // another roller before another sprocket under the other bush
  const Vector3 pitch = 2. * to_second_bush(chain);
  for (const unsigned int b : {0u, 1u})
    {
      scene.bodies.push_back(scene.bodies[b]);
      scene.bodies.back().initial.position += pitch;
    }

  // springs of friction as in prm/paper/reduced-half.prm
  teeth.law                = {3.7e13, 0., c.friction, 0., 0.};
  const double pressure    = drive::working_pressure(chain, size.load);
  teeth.half_angle         = drive::largest_half_angle(radius, play, pressure, scene.material);
  teeth.half_line          = drive::largest_half_angle(radius, radius, pressure, scene.material);
  teeth.sticking_stiffness = 1.2e8;
  teeth.tooth_stiffness    = c.stiffness;
  teeth.tooth_places       = c.places;
  teeth.loaded_half_angle =
      drive::conforming_contact(radius, play, size.load / chain.roller_length, scene.material)
          .half_angle;
  scene::BoreFamily joint;
  joint.name       = "roller-bush";
  joint.elastic    = true;
  joint.law        = {9.8e13, 0., c.in_bore, 2e13, 0.};
  joint.half_angle = drive::largest_half_angle(
      0.5 * chain.bush_diameter, bush_clearance(chain), pressure, scene.material);
  joint.pairs = {roller_on_bush(chain, 0, 2), roller_on_bush(chain, 3, 2, true)};
  scene.bores.push_back(joint);
  scene.teeth.push_back(scene.teeth.front());
  scene.teeth.back().sprocket       = 4;
  scene.teeth.back().slaves[0].body = 3;
  static std::map<std::pair<std::string, bool>, decltype(scene::Scene::bases)> known;
  scene.bases = known[{c.chain, c.fine}];
  reduction::BasisOptions options;
  options.modes_up_to = 2. * dealii::numbers::PI * 120e3 * std::max(1., 15.875e-3 / chain.pitch);
  options.orders.in_joints = options.orders.on_teeth = false;
  reduce(scene, options);
  known[{c.chain, c.fine}] = scene.bases;
  if (c.slowed_rollers > 0. || c.slowed_links > 0.)
    {
      if (c.slowed_rollers > 0.)
        options.fastest_of_rollers = 2e3 * dealii::numbers::PI * c.slowed_rollers;
      if (c.slowed_links > 0.)
        options.fastest_of_links = 2e3 * dealii::numbers::PI * c.slowed_links;
      for (auto &[part, basis] : scene.bases)
        {
          auto slowed = std::make_shared<reduction::Basis>(*basis);
          slow_down(*scene.parts.at(part), options, *slowed);
          basis = slowed;
        }
    }
  scene.bodies[2].mass    = c.mass;
  scene.bodies[2].inertia = vector(inertia, inertia, inertia);
  scene.loads.gravity     = 2. * c.load / (c.mass + 2. * scene.bodies[0].mass);
  scene.loads.drag        = c.load > 0. ? 2e4 : 0.;
  return scene;
}
} // namespace test::exact_roller
