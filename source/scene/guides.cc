// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/surface/surface_nodes.h>
#include <chaindrive/scene/build.h>
#include <chaindrive/scene/placement.h>
#include <chaindrive/utilities/text.h>

namespace chaindrive::scene
{
std::vector<SlavePoint> plates_of_joints(const drive::Drive &drive, const Scene &scene)
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
        if (scene.bodies[joint.inner].motion == Motion::elastic)
          continue;
        for (const double z : {-half, half})
          slaves.push_back({joint.inner, dealii::Point<3>(joint.bush_x, 0., z), radius, k});
      }
  return slaves;
}

PlateNodes plate_nodes(const model::Model &model,
                       const drive::Drive &drive,
                       const Scene        &scene,
                       const double        friction)
{
  const double reach = 0.5 * (drive.chain.inner_hole_pitch + drive.chain.inner_plate_height);
  PlateNodes   nodes;
  for (unsigned int k = 0; k < scene.drive.links.size(); k += 2)
    if (const unsigned int link = scene.drive.links[k];
        scene.bodies[link].motion == Motion::elastic)
      nodes.slaves.push_back({link, dealii::Point<3>(), reach, k});
  if (nodes.slaves.empty())
    return nodes;
  const mesh::Part        &part = *scene.parts.at(Kind::inner_link);
  const mesh::SurfaceNodes edges(part, mesh::Nodes(part), mesh::plate_edges);
  nodes.law = make_area_law(model.contact, model.material, edges.thickness, friction);
  return nodes;
}

namespace
{
/// Puts the body of a guide on what presses it. An arm is one with it: its origin is at the pivot,
/// about which its inertia is, and its weight is part of the moment of its spring. A slide is a
/// body of its own, as that of a wheel, on which nothing acts but its spring and its weight.
void put_on_holder(const drive::Guide &guide, Body &body, Scene &scene)
{
  const drive::Tensioner &held = *guide.held;
  if (held.is_arm())
    {
      Tensor3 z;
      z[2]            = 1.;
      body.mount      = Mount::revolute(z, {held.pivot[0], held.pivot[1], 0.});
      body.mass       = held.inertia;
      body.inertia[2] = held.inertia;
      body.initial    = placed(held.pivot, held.sense * held.travel, {}, 0.);
    }
  const auto number = static_cast<unsigned int>(scene.bodies.size());
  scene.tensioners.push_back(
      {number, guide.span, held.is_arm() ? held.sense : 1, held.travel, held.law});
  if (held.is_arm())
    return;
  Body slide    = body;
  slide.mount   = Mount::prismatic(dealii::Point<3>(held.direction[0], held.direction[1], 0.));
  slide.mass    = held.inertia;
  slide.initial = placed(held.centre(held.travel), 0., {}, 0.);
  scene.bodies.push_back(slide);
  body.initial       = slide.initial;
  body.mount.carrier = number;
}

/// Of the inner links that move by nodes; without slaves where there are none. The guide deflects
/// under each by the stiffness of its two joints.
GuideFamily with_nodes(const model::Model &model,
                       const drive::Drive &drive,
                       const drive::Guide &guide,
                       const GuideFamily  &line,
                       const Scene        &scene)
{
  const PlateNodes nodes  = plate_nodes(model, drive, scene, guide.friction);
  GuideFamily      family = line;
  family.slaves           = nodes.slaves;
  family.law              = nodes.law;
  family.elastic          = true;
  family.stiffness        = scene.symmetry().share(2. * guide.stiffness);
  family.depth            = 0.5 * drive.chain.inner_plate_height;
  return family;
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
      if (guide.held)
        put_on_holder(guide, ground, scene);
      GuideFamily family;
      family.name       = "guide of " + scene.drive.spans[guide.span].name;
      family.body       = static_cast<unsigned int>(scene.bodies.size());
      family.curve      = std::make_shared<const path::Curve>(guide.in_frame());
      family.at_centres = lumped;
      scene.bodies.push_back(ground);
      GuideFamily nodes = with_nodes(model, drive, guide, family, scene);
      if (!nodes.slaves.empty())
        scene.guides.push_back(std::move(nodes));
      const double mass = lumped ? scene.drive.mass_per_pitch : drive.inner_link_solid.mass;
      family.law =
          make_law(model.contact, guide.stiffness, mass, guide.friction).shared_by(lumped ? 1 : 2);
      family.slaves = plates_of_joints(drive, scene);
      if (!family.slaves.empty())
        scene.guides.push_back(std::move(family));
    }
}
} // namespace chaindrive::scene
