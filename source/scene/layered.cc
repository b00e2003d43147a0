// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/scene/build.h>
#include <chaindrive/scene/placement.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <cmath>

namespace chaindrive::scene
{
namespace
{
double reduced_mass(const double a, const double b) { return a * b / (a + b); }

Body rigid_body(const Kind                   kind,
                const unsigned int           number,
                const drive::MassProperties &solid,
                const double                 scale,
                const Frame                 &frame)
{
  Body body;
  body.kind    = kind;
  body.number  = number;
  body.motion  = Motion::rigid;
  body.support = Support::none;
  body.mass    = scale * solid.mass;
  for (unsigned int d = 0; d < 3; ++d)
    body.inertia[d] = scale * solid.inertia[d][d];
  body.initial = frame;
  return body;
}

/// Factor on the links' mass and inertia that gives the chain the mass per pitch asked for.
double link_mass_factor(const Parameters &parameters, const drive::Drive &drive)
{
  if (!parameters.model.mass_per_pitch)
    return 1.;
  const double links  = 0.5 * (drive.inner_link_solid.mass + drive.outer_link_solid.mass);
  const double factor = (*parameters.model.mass_per_pitch - drive.roller_solid.mass) / links;
  if (factor <= 0.)
    throw InputError(
        "Model/Mass per pitch in g = " + to_text(*parameters.model.mass_per_pitch * 1e3) +
        " leaves nothing for the links: the roller alone weighs " +
        to_text(drive.roller_solid.mass * 1e3, 4) + " g.");
  return factor;
}

void add_bodies(const Parameters &parameters, const drive::Drive &drive, Scene &scene)
{
  const drive::Layout &layout = drive.layout;
  const unsigned int   n      = scene.n_joints;
  const double         factor = link_mass_factor(parameters, drive);
  scene.mass_per_pitch        = drive.roller_solid.mass +
                         0.5 * factor * (drive.inner_link_solid.mass + drive.outer_link_solid.mass);
  scene.notes.push_back(
      "Mass per pitch " + to_text(scene.mass_per_pitch * 1e3, 4) + " g (" +
      (parameters.model.mass_per_pitch ? "given: links scaled by " + to_text(factor, 4) :
                                         std::string("auto: from the parts")) +
      "), of which the roller " + to_text(drive.roller_solid.mass * 1e3, 4) + " g");

  // a link turns with the difference of its joints' velocities (zero unless the start is warm)
  const auto link_speed = [&](const unsigned int k) {
    const auto                &a       = layout.joints[k];
    const auto                &b       = layout.joints[(k + 1) % n];
    const dealii::Tensor<1, 2> along   = b.bush - a.bush;
    const dealii::Tensor<1, 2> differs = b.velocity - a.velocity;
    return (along[0] * differs[1] - along[1] * differs[0]) / along.norm_square();
  };

  for (unsigned int k = 0; k < n; ++k)
    {
      const auto &joint = layout.joints[k];
      double      spin  = link_speed(k % 2 == 0 ? k : k - 1); // of the inner link that carries it
      if (joint.region == drive::Layout::Region::driver)
        spin = layout.driver_speed;
      else if (joint.region == drive::Layout::Region::driven)
        spin = layout.driven_speed;
      scene.bodies.push_back(rigid_body(
          Kind::roller, k, drive.roller_solid, 1., placed(joint.roller, 0., joint.velocity, spin)));
    }
  for (unsigned int k = 0; k < n; ++k)
    {
      const auto                &link = layout.links[k];
      const dealii::Tensor<1, 2> velocity =
          0.5 * (layout.joints[k].velocity + layout.joints[(k + 1) % n].velocity);
      scene.bodies.push_back(
          rigid_body(link.inner ? Kind::inner_link : Kind::outer_link,
                     k,
                     link.inner ? drive.inner_link_solid : drive.outer_link_solid,
                     factor,
                     placed(link.centre, link.angle, velocity, link_speed(k))));
    }
}

/// At joint k meet the inner link whose bush it is and the outer link whose pin it is.
struct Joint
{
  unsigned int inner, outer;  ///< bodies
  double       bush_x, pin_x; ///< of the bush's and the pin's axis in their links' frames, m
};

Joint joint_of(const unsigned int k, const drive::Drive &drive, const unsigned int n)
{
  const double bush = 0.5 * drive.chain.inner_hole_pitch, pin = 0.5 * drive.chain.outer_hole_pitch;
  const unsigned int before = n + (k + n - 1) % n, after = n + k; // links follow the n rollers
  // even links are inner links and start at even joints
  return k % 2 == 0 ? Joint{after, before, -bush, pin} : Joint{before, after, bush, -pin};
}
} // namespace

void add_layered_chain(const Parameters &parameters, const drive::Drive &drive, Scene &scene)
{
  add_bodies(parameters, drive, scene);

  const drive::ChainDimensions &chain = drive.chain;
  const unsigned int            n     = scene.n_joints;
  const double inner_mass = scene.bodies[n].mass, outer_mass = scene.bodies[n + 1].mass;
  const double roller_mass = scene.bodies.front().mass;
  const double bush_stiffness =
      parameters.contact.roller_bush_stiffness.value_or(drive.roller_bush_stiffness);
  // One bush-pin joint per pitch lies in the path of the tension; with rigid links it alone gives
  // the chain its stiffness, so plates and joint contact in series are put there.
  const double pin_stiffness = drive.stiffness_per_pitch;
  scene.notes.push_back(
      "Roller-bush stiffness " + to_text(bush_stiffness, 4) + " N/m (" +
      (parameters.contact.roller_bush_stiffness ? "given" : "auto: conforming contact") +
      "); bush-pin " + to_text(pin_stiffness, 4) + " N/m, plates and joint contact in series");

  BoreFamily rollers, pins;
  rollers.name = "roller-bush";
  rollers.law  = make_law(parameters,
                         scene.effects,
                         bush_stiffness,
                         reduced_mass(roller_mass, inner_mass),
                         parameters.contact.roller_bush_friction)
                    .shared_by(2);
  pins.name = "bush-pin";
  pins.law  = make_law(parameters,
                      scene.effects,
                      pin_stiffness,
                      reduced_mass(inner_mass, outer_mass),
                      parameters.contact.bush_pin_friction)
                 .shared_by(2);
  for (unsigned int k = 0; k < n; ++k)
    {
      const Joint joint = joint_of(k, drive, n);
      for (const double z : line_stations(chain.roller_length))
        rollers.pairs.push_back(
            {k,
             dealii::Point<3>(),
             0.5 * chain.roller_bore,
             {joint.inner, dealii::Point<3>(joint.bush_x, 0., z), 0.5 * chain.bush_diameter, k}});
      for (const double z : line_stations(chain.bush_length))
        pins.pairs.push_back(
            {joint.inner,
             dealii::Point<3>(joint.bush_x, 0., 0.),
             0.5 * chain.bush_bore,
             {joint.outer, dealii::Point<3>(joint.pin_x, 0., z), 0.5 * chain.pin_diameter, k}});
    }
  scene.bores.push_back(std::move(rollers));
  scene.bores.push_back(std::move(pins));

  if (is_on(scene.effects, "fields"))
    {
      scene.parts[Kind::roller]     = make_roller_part(parameters, drive);
      scene.parts[Kind::inner_link] = make_link_part(parameters, drive, true);
      scene.parts[Kind::outer_link] = make_link_part(parameters, drive, false);
    }
}
} // namespace chaindrive::scene
