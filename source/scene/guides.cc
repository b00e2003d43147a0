// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/scene/build.h>
#include <chaindrive/utilities/text.h>

namespace chaindrive::scene
{
namespace
{
/// What the plates of a joint touch a guide with: the round ends of inner plates, the higher ones,
/// about its axis. In the simple model they are lumped with the roller and do not turn with its
/// ring. In space there is one on each side.
std::vector<SlavePoint> plates_on_guide(const drive::Drive &drive, const Scene &scene)
{
  const drive::ChainDimensions &chain  = drive.chain;
  const double                  radius = 0.5 * chain.inner_plate_height;
  const double                  half   = 0.5 * (chain.inner_width + chain.inner_plate_thickness);
  std::vector<SlavePoint>       slaves;
  for (unsigned int k = 0; k < scene.drive.n_joints; ++k)
    if (scene.drive.links.empty())
      slaves.push_back({scene.drive.rollers[k], dealii::Point<3>(), radius, k});
    else
      {
        const Joint joint = joint_of(k, drive, scene.drive);
        for (const double z : {-half, half})
          slaves.push_back({joint.inner, dealii::Point<3>(joint.bush_x, 0., z), radius, k});
      }
  return slaves;
}
} // namespace

void add_guides(const model::Model &model, const drive::Drive &drive, Scene &scene)
{
  for (const drive::Guide &guide : drive.guides)
    {
      const bool lumped = scene.drive.links.empty();
      Body       ground;
      ground.kind             = Kind::guide;
      ground.number           = guide.span;
      ground.motion           = Motion::rigid;
      ground.mount            = Mount::fixed();
      ground.mass             = 1.;
      ground.inertia[2]       = 1.;
      ground.initial.rotation = to_matrix(Quaternion());
      GuideFamily family;
      family.name       = "guide of " + scene.drive.spans[guide.span].name;
      family.body       = static_cast<unsigned int>(scene.bodies.size());
      family.curve      = std::make_shared<const path::Curve>(guide.curve);
      family.at_centres = lumped;
      const double mass = lumped ? scene.drive.mass_per_pitch : drive.inner_link_solid.mass;
      family.law =
          make_law(model.contact, guide.stiffness, mass, guide.friction).shared_by(lumped ? 1 : 2);
      family.slaves = plates_on_guide(drive, scene);
      scene.bodies.push_back(ground);
      scene.guides.push_back(std::move(family));
    }
}
} // namespace chaindrive::scene
