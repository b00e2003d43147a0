// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/scene/build.h>
#include <chaindrive/scene/placement.h>
#include <chaindrive/scene/roller_laws.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <cmath>

namespace chaindrive::scene
{
using model::Effect;

namespace
{
double reduced_mass(const double a, const double b) { return a * b / (a + b); }
} // namespace

void add_layered_chain(const model::Model &model, const drive::Drive &drive, Scene &scene)
{
  add_chain_bodies(model, drive, std::vector<char>(scene.drive.n_joints, false), scene);
  add_rigid_joints(model, drive, scene);
  if (model.effects.is_on(Effect::fields))
    {
      if (drive.chain.has_rollers)
        scene.parts[Kind::roller] = make_roller_part(model.meshes, drive, MeshUse::picture);
      scene.parts[Kind::inner_link] = make_link_part(model.meshes, drive, true, MeshUse::picture);
      scene.parts[Kind::outer_link] = make_link_part(model.meshes, drive, false, MeshUse::picture);
    }
}

BoreFamily bores_of(const Interface interface)
{
  BoreFamily family;
  family.interface = interface;
  family.name      = parameters::text_of(interface);
  return family;
}

void add_rigid_joints(const model::Model &model, const drive::Drive &drive, Scene &scene)
{
  const drive::ChainDimensions &chain      = drive.chain;
  const DriveView              &view       = scene.drive;
  const double                  inner_mass = scene.bodies[view.links[0]].mass,
               outer_mass                  = scene.bodies[view.links[1]].mass,
               roller_mass                 = scene.bodies[view.rollers[0]].mass;
  const double bush_stiffness              = model.roller_bush_stiffness.value;
  // One bush-pin joint per pitch lies in the path of the tension; with rigid links it alone gives
  // the chain its stiffness, so plates and joint contact in series are put there.
  const double pin_stiffness = model.stiffness_per_pitch;

  BoreFamily rollers = bores_of(Interface::roller_bush), pins = bores_of(Interface::bush_pin);
  if (chain.has_rollers)
    rollers.law = make_bush_law(model.contact, bush_stiffness, roller_mass, inner_mass, scene.oval)
                      .shared_by(2);
  if (model.effects.is_on(Effect::stiffness_curves))
    {
      rollers.curve = drive.curves.roller_bush;
      pins.curve    = drive.curves.per_pitch;
    }
  pins.law = make_law(model.contact,
                      pin_stiffness,
                      reduced_mass(inner_mass, outer_mass),
                      model.contact.bush_pin_friction)
                 .shared_by(2);
  for (unsigned int k = 0; k < view.n_joints; ++k)
    {
      const Joint joint    = joint_of(k, drive, scene.drive);
      const auto  is_rigid = [&scene](const unsigned int body) {
        return !deforms(scene.bodies[body].motion);
      };
      for (const double z : axial_positions(chain.roller_length, scene.half))
        if (chain.has_rollers && is_rigid(joint.roller) && is_rigid(joint.inner))
          rollers.pairs.push_back(
              {joint.roller,
               dealii::Point<3>(),
               0.5 * chain.roller_bore,
               {joint.inner, dealii::Point<3>(joint.bush_x, 0., z), 0.5 * chain.bush_diameter, k}});
      for (const double z : axial_positions(chain.bush_length, scene.half))
        if (is_rigid(joint.inner) && is_rigid(joint.outer))
          pins.pairs.push_back(
              {joint.inner,
               dealii::Point<3>(joint.bush_x, 0., 0.),
               0.5 * chain.bush_bore,
               {joint.outer, dealii::Point<3>(joint.pin_x, 0., z), 0.5 * chain.pin_diameter, k}});
    }
  if (!rollers.pairs.empty())
    scene.notes.push_back("Roller-bush stiffness " + to_text(bush_stiffness, 4) + " N/m (" +
                          (model.roller_bush_stiffness.given ? "given" : "auto: a pressed roller") +
                          ")");
  if (!pins.pairs.empty())
    scene.notes.push_back("Bush-pin stiffness " + to_text(pin_stiffness, 4) +
                          " N/m, plates and joint contact in series");
  for (BoreFamily *family : {&rollers, &pins})
    if (!family->pairs.empty())
      scene.bores.push_back(std::move(*family));
}
} // namespace chaindrive::scene
