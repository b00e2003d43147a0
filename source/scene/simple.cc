// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/scene/build.h>
#include <chaindrive/scene/placement.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::scene
{
using model::Effect;

void add_simple_chain(const model::Model &model, const drive::Drive &drive, Scene &scene)
{
  const double mass          = model.mass_per_pitch.value;
  scene.drive.mass_per_pitch = mass;
  scene.notes.push_back("Mass per pitch " + to_text(mass * 1e3, 4) + " g (" +
                        (model.mass_per_pitch.given ? "given" : source_of_mass(drive)) +
                        "), lumped at the rollers");

  // a bush turns with its link; of a roller what turns is the ring, whatever mass of the links is
  // lumped with it
  const drive::MassProperties &ring  = drive.roller_solid;
  const bool                   spins = model.effects.is_on(Effect::friction);
  const double                 inertia =
      drive.chain.has_rollers ? ring.inertia[2][2] * std::min(1., mass / ring.mass) : 0.;
  for (unsigned int k = 0; k < scene.drive.n_joints; ++k)
    {
      const drive::Layout::Joint &joint = drive.layout.joints[k];
      Body                        roller;
      roller.kind    = Kind::roller;
      roller.number  = k;
      roller.motion  = Motion::lumped;
      roller.mass    = mass;
      roller.initial = placed(joint.roller, 0., joint.velocity, spins ? roller_spin(drive, k) : 0.);
      if (spins && drive.chain.has_rollers)
        roller.inertia[2] = inertia;
      else if (spins)
        roller.turns_with = std::array<unsigned int, 2>{{k - k % 2, scene.drive.next(k - k % 2)}};
      scene.drive.rollers.push_back(static_cast<unsigned int>(scene.bodies.size()));
      scene.bodies.push_back(roller);
    }
  if (model.effects.is_on(Effect::fields))
    scene.parts[Kind::roller] = make_roller_part(model.meshes, drive, MeshUse::picture);

  const double k = model.stiffness_per_pitch;
  // of two lumps on one bar: reduced mass m/2
  const double damping = 2. * model.chain_damping_ratio * std::sqrt(k * 0.5 * mass);
  for (unsigned int i = 0; i < scene.drive.n_joints; ++i)
    scene.bars.push_back({scene.drive.rollers[i],
                          scene.drive.rollers[scene.drive.next(i)],
                          drive.chain.loaded_pitch() + drive.links.of(i),
                          k,
                          damping});
}
} // namespace chaindrive::scene
