// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/plate.h>
#include <chaindrive/mesh/surface/surface_nodes.h>
#include <chaindrive/scene/build.h>
#include <chaindrive/utilities/text.h>

#include <cmath>
#include <numeric>

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

/// The nodes of an inner link's inner faces that have a tooth beside them: near the middle of the
/// link, as wide as a tooth is where the rollers are at their widest, or on the line between the
/// joints' halves where a mesh has none but these; on the side of the link's middle line on which
/// y has the sign @p inwards.
std::vector<unsigned int>
nodes_beside_tooth(const drive::ChainDimensions &chain, const mesh::Part &part, const int inwards)
{
  const mesh::Nodes nodes(part);
  const double      x = 0.4 * (chain.pitch - chain.roller_diameter),
               y      = 0.2 * drive::inner_plate(chain).waist;
  std::vector<unsigned int> found;
  for (const unsigned int node : mesh::SurfaceNodes(part, nodes, mesh::plate_inner_faces).node)
    if (const dealii::Point<3> &at = nodes.position[node];
        std::abs(at[0]) <= x && inwards * at[1] >= y)
      found.push_back(node);
  return found;
}

double thickness_at(const mesh::Part &part, const mesh::Surface side)
{
  return mesh::SurfaceNodes(part, mesh::Nodes(part), side).thickness;
}

/// The same with elastic links and rollers, whose nodes touch.
void add_elastic_roller_ends(const model::Model &model, const drive::Drive &drive, Scene &scene)
{
  const mesh::Part &inner  = *scene.parts.at(Kind::inner_link),
                   &roller = *scene.parts.at(Kind::roller);

  FaceFamily ends;
  ends.interface = Interface::roller_ends;
  ends.name      = parameters::text_of(ends.interface);
  ends.radius    = 0.5 * drive.chain.roller_diameter;
  ends.law       = make_face_law(model,
                           drive,
                           ring_area(ends.radius, 0.5 * drive.chain.roller_bore),
                           std::max(thickness_at(inner, mesh::plate_inner_faces),
                                    thickness_at(roller, mesh::roller_ends)));
  for (unsigned int k = 0; k < scene.drive.n_joints; ++k)
    {
      const Joint joint = joint_of(k, drive, scene.drive);
      ends.pairs.push_back({joint.inner,
                            joint.roller,
                            mesh::plate_inner_faces,
                            mesh::roller_ends,
                            dealii::Point<3>(joint.bush_x, 0., 0.),
                            dealii::Point<3>(),
                            k});
    }
  scene.faces.push_back(std::move(ends));
}

/// The faces with which elastic links, rollers and rigid teeth keep each other in place: their
/// nodes touch. Those of plates on plates are there.
void add_elastic_sides(const model::Model &model, const drive::Drive &drive, Scene &scene)
{
  const drive::ChainDimensions &chain = drive.chain;
  const mesh::Part             &inner = *scene.parts.at(Kind::inner_link);
  if (chain.has_rollers)
    add_elastic_roller_ends(model, drive, scene);
  for (unsigned int i = 0; i < drive.sprockets.size(); ++i)
    {
      ToothSideFamily sides = tooth_sides(drive, scene, i);
      sides.elastic         = true;
      sides.slave_surface   = mesh::plate_inner_faces;
      sides.slave_nodes     = nodes_beside_tooth(chain, inner, scene.drive.sprockets[i].sense);
      mesh::SurfaceNodes touching(inner, mesh::Nodes(inner), mesh::plate_inner_faces);
      touching.keep(sides.slave_nodes);
      sides.law = make_face_law(
          model,
          drive,
          0.5 * std::accumulate(touching.area.begin(), touching.area.end(), 0.), // of both plates
          thickness_at(inner, mesh::plate_inner_faces));
      const double radius =
          std::hypot(0.5 * chain.pitch, 0.5 * chain.inner_plate_height, 0.5 * chain.inner_width);
      sides.slaves.clear();
      for (unsigned int k = 0; k < scene.drive.n_joints; k += 2)
        sides.slaves.push_back({scene.drive.links[k], dealii::Point<3>(), radius, k});
      scene.tooth_sides.push_back(std::move(sides));
    }
}

std::string play_text(const drive::Drive &drive)
{
  const drive::ChainDimensions &c = drive.chain;
  return "play to either side: " + to_text(0.5e3 * (c.inner_width - drive.sprocket_width), 4) +
         " mm between plates and teeth, " +
         to_text(1e3 * (c.outer_plate_z - c.inner_plate_z -
                        0.5 * (c.inner_plate_thickness + c.outer_plate_thickness)),
                 4) +
         " mm between plates" +
         (c.has_rollers ? ", " + to_text(0.5e3 * (c.inner_width - c.roller_length), 4) +
                              " mm between rollers and plates" :
                          "");
}
} // namespace

double ring_area(const double outer_radius, const double inner_radius)
{
  return dealii::numbers::PI * (outer_radius * outer_radius - inner_radius * inner_radius);
}

ContactLaw make_face_law(const model::Model &model,
                         const drive::Drive &drive,
                         const double        area,
                         const double        thickness)
{
  if (!model.reduced)
    return make_area_law(model.contact, model.material, thickness, model.contact.plate_friction);
  constexpr double stiffer = 4.; // than a plate bends
  return make_law(model.contact,
                  stiffer * model.side_stiffness.value / area,
                  0.5 * model.material.density * drive.chain.inner_plate_thickness,
                  model.contact.plate_friction);
}

void add_sides(const model::Model &model, const drive::Drive &drive, Scene &scene)
{
  if (deforms(scene.bodies[scene.drive.links[0]].motion))
    {
      add_elastic_sides(model, drive, scene);
      scene.notes.push_back("Sides of plates, teeth and rollers: " + play_text(drive));
      return;
    }
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
  scene.notes.push_back(
      "Side stiffness " + to_text(k, 4) + " N/m (" +
      (model.side_stiffness.given ? "given" : "auto: an inner plate pressed in the middle") +
      "); " + play_text(drive));
}
} // namespace chaindrive::scene
