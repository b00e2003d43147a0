// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/scene/build.h>
#include <chaindrive/scene/placement.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <cmath>

namespace chaindrive::scene
{
using model::Effect;

namespace
{
Body make_body(const Kind                   kind,
               const unsigned int           number,
               const drive::MassProperties &solid,
               const double                 scale,
               const Motion                 motion,
               const Frame                 &frame)
{
  Body body;
  body.kind   = kind;
  body.number = number;
  body.motion = motion;
  body.mass   = scale * solid.mass;
  for (unsigned int d = 0; d < 3; ++d)
    body.inertia[d] = scale * solid.inertia[d][d];
  body.initial = frame;
  return body;
}

/// Factor on the links' mass and inertia that gives the chain the mass per pitch asked for.
double link_mass_factor(const model::Model &model, const drive::Drive &drive)
{
  if (!model.mass_per_pitch.given)
    return 1.;
  const double links  = 0.5 * (drive.inner_link_solid.mass + drive.outer_link_solid.mass);
  const double factor = (model.mass_per_pitch.value - drive.roller_solid.mass) / links;
  if (factor <= 0.)
    throw InputError("Model/Mass per pitch in g = " + to_text(model.mass_per_pitch.value * 1e3) +
                     " leaves nothing for the links: the roller alone weighs " +
                     to_text(drive.roller_solid.mass * 1e3, 4) + " g.");
  return factor;
}

/// A link turns with the difference of its joints' velocities (zero unless the start is settled).
double link_spin(const drive::Layout &layout, const unsigned int k)
{
  const auto                &a       = layout.joints[k];
  const auto                &b       = layout.joints[(k + 1) % layout.joints.size()];
  const dealii::Tensor<1, 2> along   = b.bush - a.bush;
  const dealii::Tensor<1, 2> differs = b.velocity - a.velocity;
  return (along[0] * differs[1] - along[1] * differs[0]) / along.norm_square();
}
} // namespace

std::string source_of_mass(const drive::Drive &drive)
{
  return drive.chain.link_density_factor == 1. ? "auto: from the parts" : "auto: of catalogues";
}

double roller_spin(const drive::Drive &drive, const unsigned int k)
{
  const drive::Layout &layout   = drive.layout;
  const int            sprocket = layout.joints[k].sprocket;
  return sprocket >= 0 && drive.chain.has_rollers ? layout.sprockets[sprocket].speed :
                                                    link_spin(layout, k - k % 2);
}

void add_chain_bodies(const model::Model      &model,
                      const drive::Drive      &drive,
                      const std::vector<char> &elastic_joint,
                      Scene                   &scene)
{
  const drive::Layout &layout          = drive.layout;
  const unsigned int   n               = scene.drive.n_joints;
  const double         factor          = link_mass_factor(model, drive);
  const bool           elastic_rollers = model.effects.is_on(Effect::elastic_rollers);
  const bool           elastic_links   = model.effects.is_on(Effect::elastic_links);
  const Motion         deforming       = model.reduced ? Motion::reduced : Motion::elastic;
  const Motion         others          = model.others_reduced ? Motion::reduced : Motion::rigid;
  const auto           motion          = [&](const bool effect, const bool is_in_region) {
    return !effect ? Motion::rigid : is_in_region ? deforming : others;
  };
  scene.drive.mass_per_pitch =
      drive.roller_solid.mass +
      0.5 * factor * (drive.inner_link_solid.mass + drive.outer_link_solid.mass);
  scene.notes.push_back(
      "Mass per pitch " + to_text(scene.drive.mass_per_pitch * 1e3, 4) + " g (" +
      (model.mass_per_pitch.given ? "given: links scaled by " + to_text(factor, 4) :
                                    source_of_mass(drive)) +
      (drive.chain.has_rollers ?
           "), of which the roller " + to_text(drive.roller_solid.mass * 1e3, 4) + " g" :
           "), without rollers"));

  for (unsigned int k = 0; k < n && drive.chain.has_rollers; ++k)
    {
      const auto &joint = layout.joints[k];
      scene.drive.rollers.push_back(static_cast<unsigned int>(scene.bodies.size()));
      scene.bodies.push_back(
          make_body(Kind::roller,
                    k,
                    drive.roller_solid,
                    1.,
                    motion(elastic_rollers, elastic_joint[k]),
                    placed(joint.roller, 0., joint.velocity, roller_spin(drive, k))));
    }
  for (unsigned int k = 0; k < n; ++k)
    {
      const auto                &link = layout.links[k];
      const dealii::Tensor<1, 2> velocity =
          0.5 * (layout.joints[k].velocity + layout.joints[(k + 1) % n].velocity);
      const bool is_in_region = elastic_joint[k] && elastic_joint[(k + 1) % n];
      scene.drive.links.push_back(static_cast<unsigned int>(scene.bodies.size()));
      scene.bodies.push_back(
          make_body(link.inner ? Kind::inner_link : Kind::outer_link,
                    k,
                    link.inner ? drive.inner_link_solid : drive.outer_link_solid,
                    factor,
                    motion(elastic_links, is_in_region),
                    placed(link.centre, link.angle, velocity, link_spin(layout, k))));
    }
  if (drive.chain.has_rollers)
    return;
  for (unsigned int k = 0; k < n; ++k)
    {
      const double bush = 0.5 * (drive.chain.inner_hole_pitch + drive.links.of(k - k % 2));
      scene.drive.rollers.push_back(scene.drive.links[k - k % 2]);
      scene.drive.bushes.emplace_back(k % 2 == 0 ? -bush : bush, 0., 0.);
    }
}

Joint joint_of(const unsigned int k, const drive::Drive &drive, const DriveView &view)
{
  const unsigned int k_before = view.next(k, view.n_joints - 1);
  const unsigned int before = view.links[k_before], after = view.links[k];
  const double       bush =
      0.5 * (drive.chain.inner_hole_pitch + drive.links.of(k % 2 == 0 ? k : k_before));
  const double pin =
      0.5 * (drive.chain.outer_hole_pitch + drive.links.of(k % 2 == 0 ? k_before : k));
  // even links are inner links and start at even joints
  const unsigned int roller = view.rollers[k];
  return k % 2 == 0 ? Joint{roller, after, before, -bush, pin} :
                      Joint{roller, before, after, bush, -pin};
}
} // namespace chaindrive::scene
