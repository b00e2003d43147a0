// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/plate.h>
#include <chaindrive/scene/build.h>
#include <chaindrive/utilities/text.h>

#include <cmath>

// The faces with which rigid links, rollers and teeth keep each other in place across the plane of
// the drive.

namespace chaindrive::scene
{
namespace
{
double reduced_mass(const double a, const double b) { return a * b / (a + b); }

SideFamily sides_of(const Interface interface)
{
  SideFamily family;
  family.interface = interface;
  family.name      = parameters::text_of(interface);
  return family;
}

/// The inner faces of outer plates on the outer faces of inner ones: rings about the joints, for
/// each of which four points stand that have its second moments.
SideFamily plate_faces(const drive::Drive &drive, const Scene &scene)
{
  const drive::ChainDimensions &chain = drive.chain;
  const double outer_radius = 0.5 * std::min(chain.inner_plate_height, chain.outer_plate_height),
               inner_radius = 0.5 * chain.bush_diameter,
               r = std::sqrt(0.5 * (outer_radius * outer_radius + inner_radius * inner_radius)),
               inner_z = chain.inner_plate_z + 0.5 * chain.inner_plate_thickness,
               outer_z = chain.outer_plate_z - 0.5 * chain.outer_plate_thickness;
  SideFamily family    = sides_of(Interface::plate_faces);
  for (unsigned int k = 0; k < scene.drive.n_joints; ++k)
    {
      const Joint joint = joint_of(k, drive, scene.drive);
      for (const int side : {-1, 1})
        for (const auto &[x, y] : {std::make_pair(r, 0.), {0., r}, {-r, 0.}, {0., -r}})
          family.pairs.push_back(
              {joint.inner,
               side * inner_z,
               side,
               {joint.outer, dealii::Point<3>(joint.pin_x + x, y, side * outer_z), 0., k}});
    }
  return family;
}

/// The ends of rollers on the inner faces of inner plates. A roller cannot tilt between them, since
/// its bush holds it: a point on its axis stands for each end.
SideFamily roller_ends(const drive::Drive &drive, const Scene &scene)
{
  SideFamily family = sides_of(Interface::roller_ends);
  for (unsigned int k = 0; k < scene.drive.n_joints; ++k)
    {
      const Joint joint = joint_of(k, drive, scene.drive);
      for (const int side : {-1, 1})
        family.pairs.push_back({joint.inner,
                                side * 0.5 * drive.chain.inner_width,
                                -side,
                                {joint.roller,
                                 dealii::Point<3>(0., 0., side * 0.5 * drive.chain.roller_length),
                                 0.,
                                 k}});
    }
  return family;
}

/// Of inner plates, on the sides of the teeth of sprocket number @p i: points near the middle of
/// the link, where a tooth stands between its rollers, at the edge towards the wheel and at half
/// its depth.
ToothSideFamily tooth_sides(const drive::Drive &drive, const Scene &scene, const unsigned int i)
{
  const drive::ChainDimensions &chain = drive.chain;
  ToothSideFamily               family;
  family.name       = name_of_sides(drive.sprockets[i].name);
  family.sprocket   = scene.drive.sprockets[i].body;
  family.half_width = 0.5 * drive.sprocket_width;
  family.tip_radius = 0.5 * drive.sprockets[i].form.outside_diameter;
  family.relief     = drive.side_relief;
  family.radius     = drive.side_radius;
  // a tooth is that wide at least where the rollers are at their widest
  const double x    = 0.4 * (chain.pitch - chain.roller_diameter),
               edge = 0.5 * drive::inner_plate(chain).waist, z = 0.5 * chain.inner_width;
  // from the link to the wheel: to the left of the travel of a drive that turns counter-clockwise
  const int inwards = scene.drive.sprockets[i].sense;
  for (unsigned int k = 0; k < scene.drive.n_joints; k += 2)
    for (const int side : {-1, 1})
      for (const double y : {0.5 * edge, edge})
        for (const double along : {-x, x})
          family.slaves.push_back(
              {scene.drive.links[k], dealii::Point<3>(along, inwards * y, side * z), 0., k});
  return family;
}
} // namespace

void add_sides(const model::Model &model, const drive::Drive &drive, Scene &scene)
{
  const double inner = scene.bodies[scene.drive.links[0]].mass,
               outer = scene.bodies[scene.drive.links[1]].mass, k = model.side_stiffness.value;
  const auto law = [&](const double mass) {
    return make_law(model.contact, k, mass, model.contact.plate_friction);
  };
  SideFamily faces = plate_faces(drive, scene);
  faces.law        = law(reduced_mass(inner, outer)).shared_by(4);
  scene.sides.push_back(std::move(faces));
  if (drive.chain.has_rollers)
    {
      SideFamily ends = roller_ends(drive, scene);
      ends.law        = law(reduced_mass(scene.bodies[scene.drive.rollers[0]].mass, inner));
      scene.sides.push_back(std::move(ends));
    }
  for (unsigned int i = 0; i < drive.sprockets.size(); ++i)
    {
      ToothSideFamily sides = tooth_sides(drive, scene, i);
      sides.law             = law(inner).shared_by(4);
      scene.tooth_sides.push_back(std::move(sides));
    }
  const drive::ChainDimensions &c = drive.chain;
  scene.notes.push_back(
      "Side stiffness " + to_text(k, 4) + " N/m (" +
      (model.side_stiffness.given ? "given" : "auto: an inner plate pressed in the middle") +
      "); play to either side: " + to_text(0.5e3 * (c.inner_width - drive.sprocket_width), 4) +
      " mm between plates and teeth, " +
      to_text(1e3 * (c.outer_plate_z - c.inner_plate_z -
                     0.5 * (c.inner_plate_thickness + c.outer_plate_thickness)),
              4) +
      " mm between plates" +
      (c.has_rollers ? ", " + to_text(0.5e3 * (c.inner_width - c.roller_length), 4) +
                           " mm between rollers and plates" :
                       ""));
}
} // namespace chaindrive::scene
