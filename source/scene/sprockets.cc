// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/stiffness.h>
#include <chaindrive/files/file.h>
#include <chaindrive/mesh/import/import.h>
#include <chaindrive/mesh/sector.h>
#include <chaindrive/mesh/surface/facet_surface.h>
#include <chaindrive/mesh/surface/surface_nodes.h>
#include <chaindrive/scene/build.h>
#include <chaindrive/scene/placement.h>
#include <chaindrive/scene/roller_laws.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace chaindrive::scene
{
using model::Effect;

using parameters::Role;

namespace
{
/// The mesh of sprocket number @p i of the drive: from its file, or generated where somebody needs
/// it, else null.
std::shared_ptr<const mesh::Part> sprocket_part(const model::Model             &model,
                                                const drive::Drive             &drive,
                                                const unsigned int              i,
                                                const std::vector<std::string> &folders)
{
  const drive::Sprocket &sprocket = drive.sprockets[i];
  const bool             elastic  = model.effects.is_on(Effect::elastic_sprocket, i);
  const std::string     &file     = sprocket.mesh;
  if (!file.empty())
    {
      auto part =
          std::make_shared<const mesh::Part>(mesh::import_sprocket(files::find_file(file, folders),
                                                                   sprocket.form,
                                                                   model.material.density,
                                                                   model.meshes.half && elastic));
      if (const double width = mesh::flank_width(*part); width >= drive.chain.inner_width)
        throw InputError(
            "Drive/Sprockets/" + sprocket.in_entries + " mesh = " + file + " has teeth " +
            to_text(width * 1e3, 4) + " mm wide; they must be narrower than the " +
            to_text(drive.chain.inner_width * 1e3, 4) + " mm between the inner plates.");
      return part;
    }
  if (model.effects.is_on(Effect::fields) || elastic)
    return make_sprocket_part(
        model.meshes, drive, sprocket, elastic ? MeshUse::elastic : MeshUse::picture);
  return nullptr;
}

/// Sprocket number @p i of the drive as a body, with its mesh in @p part if it has one.
Body sprocket_body(const model::Model &model,
                   const drive::Drive &drive,
                   const unsigned int  i,
                   const mesh::Part   *part,
                   Scene              &scene)
{
  const drive::Sprocket         &sprocket = drive.sprockets[i];
  const drive::Layout::Sprocket &start    = drive.layout.sprockets[i];
  const drive::MassProperties   &solid    = sprocket.mesh.empty() ? sprocket.solid : part->meshed;
  const bool                     rim      = model.effects.is_on(Effect::elastic_sprocket, i);

  Body body;
  body.kind   = Kind::sprocket;
  body.number = i;
  body.motion = rim ? Motion::elastic : Motion::rigid;
  body.mount =
      sprocket.role == Role::driver && !sprocket.coupling ? Mount::motor() : Mount::revolute();
  body.mass = solid.mass;
  for (unsigned int d = 0; d < 3; ++d)
    body.inertia[d] = solid.inertia[d][d];
  body.inertia[2] = sprocket.coupling ? sprocket.coupling->before :
                                        sprocket.given_inertia.value_or(solid.inertia[2][2]);
  if (sprocket.role != Role::driver && !sprocket.coupling)
    scene.notes.push_back(sprocket.in_entries + " inertia " +
                          to_text(drive.strands * body.inertia[2], 4) + " kg m2 (" +
                          (sprocket.given_inertia ? "given" : "auto: the sprocket alone") + ")");
  body.initial = placed(start.centre, start.angle, dealii::Tensor<1, 2>(), start.speed);
  if (const dealii::Tensor<1, 2> &e = start.eccentricity; e != dealii::Tensor<1, 2>())
    {
      body.mount.pivot         = dealii::Point<3>(start.axis()[0], start.axis()[1], 0.);
      body.initial.velocity[0] = -start.speed * e[1];
      body.initial.velocity[1] = start.speed * e[0];
    }
  return body;
}

/// Refuses a @p sprocket with less inertia than its rim @p sector has: with less than the nodes
/// that it holds a hub could be faster than the elements are. One that is @p coupled has that of
/// the entries of its coupling.
void check_inertia(const Body         &sprocket,
                   const bool          coupled,
                   const mesh::Sector &sector,
                   const Scene        &scene)
{
  const mesh::Sector::Inertia rim = sector.inertia(mesh::Nodes(*sector.part));
  const double                all = scene.symmetry().whole(rim.free + rim.held);
  if (sprocket.mount.kind == Mount::Kind::revolute && sprocket.inertia[2] < all)
    throw InputError((coupled ? "Drive/Wheels/" + scene.drive.sprockets[sprocket.number].name +
                                    "/Coupling/Inertia of sprocket in kg m2 = " :
                                "Model/Driven inertia in kg m2 = ") +
                     to_text(sprocket.inertia[2]) +
                     " is less than that of the elastic rim of the sprocket alone, " +
                     to_text(all) +
                     "; choose a greater value, auto, or Model/Elastic sprockets = off.");
}

/// The outward side on which the chain arrives at sprocket number @p i. Where the slack span does,
/// which hangs, it is opposite the side on which the chain leaves.
Tensor3 entry_normal(const drive::Layout &layout, const unsigned int i, const DriveView &drive)
{
  const std::size_t before = (i + layout.spans.size() - 1) % layout.spans.size();
  return layout.sprockets[i].turn *
         (layout.spans[before].straight ? drive.spans[before].normal : -drive.spans[i].normal);
}

/// The flanks of @p sprocket, which is in the scene as @p body with its mesh in @p part if it has
/// one; no rollers yet.
ToothFamily make_flanks(const model::Model    &model,
                        const drive::Drive    &drive,
                        const drive::Sprocket &sprocket,
                        const unsigned int     body,
                        const mesh::Part      *part,
                        Scene                 &scene)
{
  const bool         imported = !sprocket.mesh.empty();
  const unsigned int facets   = sprocket.form.flat ? 0 : model.tooth_facets;
  ToothFamily        teeth;
  teeth.name     = name_of_teeth(sprocket.name);
  teeth.sprocket = body;
  teeth.form = std::make_shared<const drive::ToothForm>(facets > 0 ? sprocket.form.faceted(facets) :
                                                                     sprocket.form);
  if (facets > 0)
    scene.notes.push_back(teeth.name + ": teeth of " + std::to_string(facets) +
                          " chords instead of their arcs");
  teeth.teeth        = sprocket.form.teeth;
  teeth.outer_radius = 0.5 * sprocket.form.outside_diameter;
  teeth.half_width   = 0.5 * (imported                  ? mesh::flank_width(*part) :
                              sprocket.carries_plates() ? drive.chain.pin_length :
                                                          drive.sprocket_width);
  if (imported)
    {
      const auto sector = scene.sectors.find(scene.bodies[body].part());
      teeth.facets      = std::make_shared<const mesh::FacetSurface>(
          sector != scene.sectors.end() ? *sector->second->part : *part, mesh::tooth_flanks);
      for (const dealii::Point<3> &vertex : part->mesh->get_vertices())
        teeth.outer_radius = std::max(teeth.outer_radius, std::hypot(vertex[0], vertex[1]));
      scene.notes.push_back(teeth.name + ": flanks of the imported mesh " + sprocket.mesh);
    }
  return teeth;
}

/// The friction coefficient of what lies on @p sprocket.
double friction_on(const model::Model &model, const drive::Sprocket &sprocket)
{
  const double of_teeth = model.contact.roller_tooth_friction;
  return sprocket.form.flat && model.effects.is_on(Effect::friction) ?
             sprocket.flat.friction.value_or(of_teeth) :
             of_teeth;
}

/// The family of the plates that lie on a drum.
ToothFamily with_plates(const model::Model    &model,
                        const drive::Drive    &drive,
                        const drive::Sprocket &sprocket,
                        const Scene           &scene,
                        const ToothFamily     &flanks)
{
  const bool   lumped = scene.drive.links.empty();
  const double mass   = lumped ? scene.drive.mass_per_pitch : drive.inner_link_solid.mass;
  ToothFamily  plates = flanks;
  plates.law = make_law(model.contact, sprocket.flat_stiffness, mass, friction_on(model, sprocket))
                   .shared_by(lumped ? 1 : 2);
  plates.at_centres = lumped;
  plates.slaves     = plates_of_joints(drive, scene);
  return plates;
}

/// The family of the rollers that move by @p motion, whose nodes meet the flanks of @p flanks.
/// These deflect by @p tooth_stiffness [N/m] where they are rigid. @p side is that of the rollers'
/// mesh, of a chain without rollers that of the first or the second bushes of inner links.
ToothFamily with_elastic_rollers(const model::Model &model,
                                 const drive::Drive &drive,
                                 const Scene        &scene,
                                 const ToothFamily  &flanks,
                                 const double        tooth_stiffness,
                                 const double        friction,
                                 const Motion        motion,
                                 const mesh::Surface side)
{
  ToothFamily       teeth = flanks;
  const mesh::Part &roller =
      *scene.parts.at(drive.chain.has_rollers ? Kind::roller : Kind::inner_link);
  const mesh::SurfaceNodes outside(roller, mesh::Nodes(roller), side);
  double                   thickness = outside.thickness;
  const auto               sector    = scene.sectors.find(scene.bodies[teeth.sprocket].part());
  if (sector != scene.sectors.end()) // the softer of two surfaces decides how far they may overlap
    {
      const mesh::Part &part = *sector->second->part;
      thickness              = std::max(
          thickness, mesh::SurfaceNodes(part, mesh::Nodes(part), mesh::tooth_flanks).thickness);
    }
  teeth.law             = make_area_law(model.contact, model.material, thickness, friction);
  teeth.elastic         = true;
  const bool   exact    = model.effects.is_on(Effect::exact_teeth);
  const double pressure = exact ? drive::working_pressure(drive.chain, drive.reference_load) :
                                  drive::breaking_pressure,
               radius   = 0.5 * drive.chain.roller_diameter,
               length   = std::min(drive.chain.roller_length, drive.sprocket_width);
  teeth.half_angle =
      drive::largest_half_angle(radius, teeth.form->seat_radius - radius, pressure, scene.material);
  // on a flat: as in a hole so much wider that r^2 / clearance, all that counts then, is r
  teeth.half_line = drive::largest_half_angle(radius, radius, pressure, scene.material);
  if (exact)
    {
      const double q = drive.reference_load / length, seat = teeth.form->seat_radius - radius;
      teeth.largest_force      = pressure * 2. * radius * length;
      teeth.sticking_stiffness = scene.symmetry().share(
          model.contact.tangential_ratio * drive.reference_load /
          drive::conforming_contact(radius, seat, q, scene.material).approach);
    }
  const bool deflects = model.effects.is_on(Effect::tooth_compliance) &&
                        sector == scene.sectors.end() && !teeth.form->flat;
  if (deflects && exact)
    {
      // strips have what a tooth dents by themselves
      teeth.tooth_stiffness = scene.symmetry().share(tooth_stiffness);
      for (drive::PlacedStiffness &place : teeth.tooth_places)
        place.stiffness = scene.symmetry().share(place.stiffness);
      teeth.loaded_half_angle = drive::conforming_contact(radius,
                                                          teeth.form->seat_radius - radius,
                                                          drive.reference_load / length,
                                                          scene.material)
                                    .half_angle;
    }
  else if (deflects)
    {
      make_compliant(teeth,
                     tooth_stiffness,
                     radius,
                     std::min(drive.chain.roller_length, drive.sprocket_width),
                     drive.reference_load,
                     scene.material);
      teeth.tooth_stiffness = scene.symmetry().share(teeth.tooth_stiffness);
    }
  teeth.slave_surface = side;
  for (unsigned int k = 0; k < scene.drive.n_joints; ++k)
    {
      const unsigned int     body   = scene.drive.rollers[k];
      const dealii::Point<3> middle = scene.drive.roller_at(k);
      const bool             on_side =
          drive.chain.has_rollers || (middle[0] < 0.) == (side == mesh::bush_outside_first);
      if (on_side && scene.bodies[body].motion == motion)
        teeth.slaves.push_back({body, middle, radius, k});
    }
  return teeth;
}

/// The family of the inner links that move by nodes, the edges of whose plates lie on a drum, which
/// deflects under each by the stiffness of its two joints; without slaves where there are none.
ToothFamily with_plate_nodes(const model::Model    &model,
                             const drive::Drive    &drive,
                             const drive::Sprocket &sprocket,
                             const Scene           &scene,
                             const ToothFamily     &flanks)
{
  const PlateNodes nodes  = plate_nodes(model, drive, scene, friction_on(model, sprocket));
  ToothFamily      plates = flanks;
  plates.slaves           = nodes.slaves;
  plates.law              = nodes.law;
  plates.elastic          = true;
  plates.slave_surface    = mesh::plate_edges;
  plates.tooth_stiffness  = scene.symmetry().share(2. * sprocket.flat_stiffness);
  return plates;
}

/// The sides of meshes that meet teeth.
std::vector<mesh::Surface> sides_on_teeth(const drive::ChainDimensions &chain)
{
  if (chain.has_rollers)
    return {mesh::roller_outside};
  return {mesh::bush_outside_first, mesh::bush_outside_second};
}

/// The family of the other rollers, which touch at points of their axes, on sprocket number
/// @p sprocket; @p stiffness is that of a roller, N/m.
ToothFamily with_rigid_rollers(const model::Model &model,
                               const drive::Drive &drive,
                               const unsigned int  sprocket,
                               const double        stiffness,
                               const double        friction,
                               const Scene        &scene,
                               const ToothFamily  &flanks)
{
  const Body &roller = scene.bodies[scene.drive.rollers.front()];
  // A lumped roller touches in its middle plane. A rigid one touches at two points that give its
  // line of contact the same moment of resistance against tilting.
  const std::vector<double> positions =
      roller.motion == Motion::lumped ?
          std::vector<double>{0.} :
          axial_positions(std::min(drive.chain.roller_length, 2. * flanks.half_width), scene.half);
  ToothFamily teeth = flanks;
  teeth.law         = make_tooth_law(model.contact, stiffness, roller.mass, friction, scene.oval)
                  .shared_by(roller.motion == Motion::lumped ? 1 : 2);
  if (model.effects.is_on(Effect::stiffness_curves) && sprocket < drive.curves.roller_tooth.size())
    teeth.curve = drive.curves.roller_tooth[sprocket];
  for (unsigned int k = 0; k < scene.drive.n_joints; ++k)
    for (const double z : positions)
      if (const unsigned int number = scene.drive.rollers[k]; !deforms(scene.bodies[number].motion))
        {
          const dealii::Point<3> middle = scene.drive.roller_at(k);
          teeth.slaves.push_back({number,
                                  dealii::Point<3>(middle[0], middle[1], z),
                                  0.5 * drive.chain.roller_diameter,
                                  k});
        }
  return teeth;
}

/// How stiff teeth are at @p places, in words after a value; empty: there are none.
std::string over_place(const std::vector<drive::PlacedStiffness> &places)
{
  std::string text;
  for (const drive::PlacedStiffness &place : places)
    text += (text.empty() ? "; over place " : ", ") + to_text(place.stiffness, 4) + " at " +
            to_text(180. / dealii::numbers::PI * place.angle, 3) + " deg";
  return text + (text.empty() ? "" : " from the bottom of the seat");
}

/// By how much forces of impacts are too large at most without the inertia of tooth and rim, means
/// over 10 and 20 us at the end of the seat and on the flank, as finite elements found it for 15
/// teeth of 525 (doc/accuracy-and-cost.md, a roller thrown at a tooth). Sizes do not matter, but
/// how
/// @p deep the rim is from where it is rigid to its root, in pitches.
double too_hard_by(const double deep)
{
  struct Found
  {
    double deep, error;
  };
  constexpr std::array<Found, 3> found = {{{0.26, 0.037}, {0.51, 0.053}, {1.05, 0.11}}};
  if (deep <= found.front().deep)
    return found.front().error;
  for (unsigned int i = 1; i < found.size(); ++i)
    if (deep < found[i].deep)
      return found[i - 1].error + (found[i].error - found[i - 1].error) *
                                      (deep - found[i - 1].deep) /
                                      (found[i].deep - found[i - 1].deep);
  return found.back().error;
}

/// The same of a @p sprocket for rollers of a chain with this @p pitch [m], as a phrase, and what
/// helps, if the rim could have inertia.
std::string
without_inertia(const drive::Sprocket &sprocket, const double pitch, const bool could_have)
{
  const double deep = 0.5 * (sprocket.form.root_diameter - sprocket.hub_diameter) / pitch;
  return "; without inertia, so that impacts, in the mean over 10 to 20 us, are up to " +
         to_text(100. * too_hard_by(deep), 2) +
         " % too hard (from its rigid zone to its root the rim is " + to_text(deep, 2) +
         " of a pitch deep)" + (could_have ? "; Effects/Tooth inertia = on has it" : "");
}

/// Frequency up to which rims with inertia have modes, rad/s: faster ones change impacts by a
/// percent (doc/accuracy-and-cost.md, a roller thrown at a tooth); in inverse proportion to the
/// pitch [m] of small chains, as those of links and rollers.
double highest_of_rims(const double pitch)
{
  return 2. * dealii::numbers::PI * 90e3 * std::max(1., 15.875e-3 / pitch);
}

/// What is said of a @p rim with inertia, as a phrase.
std::string with_inertia(const InertRim &rim)
{
  return "; of that modes up to " +
         to_text(1e-3 / (2. * dealii::numbers::PI) * rim.modes_up_to, 4) +
         " kHz of the rim outside of its rigid zone have inertia";
}
} // namespace

void make_compliant(ToothFamily    &teeth,
                    const double    stiffness,
                    const double    radius,
                    const double    length,
                    const double    load,
                    const Material &steel)
{
  teeth.tooth_stiffness = 2. * stiffness;
  teeth.law =
      in_series(teeth.law,
                drive::foundation_of_seat(
                    radius, teeth.form->seat_radius - radius, length, load, 2. * stiffness, steel));
}

void add_sprockets(const model::Model             &model,
                   const drive::Drive             &drive,
                   const std::vector<std::string> &folders,
                   Scene                          &scene)
{
  const double stiffness  = model.roller_tooth_stiffness.value;
  const auto   any_roller = [&scene](const auto &is_so) {
    return std::any_of(scene.drive.rollers.begin(),
                       scene.drive.rollers.end(),
                       [&](const unsigned int roller) { return is_so(scene.bodies[roller]); });
  };
  const bool any_rigid = any_roller([](const Body &roller) { return !deforms(roller.motion); });
  if (any_rigid)
    scene.notes.push_back(
        "Roller-tooth stiffness " + to_text(stiffness, 4) + " N/m (" +
        (model.roller_tooth_stiffness.given ? "given" : "auto: a pressed roller") +
        "); a smaller value lowers impact peaks in proportion to its square root");

  for (unsigned int i = 0; i < drive.sprockets.size(); ++i)
    {
      const drive::Sprocket &sprocket = drive.sprockets[i];
      const auto             part     = sprocket_part(model, drive, i, folders);
      const Body             body     = sprocket_body(model, drive, i, part.get(), scene);
      const auto             number   = static_cast<unsigned int>(scene.bodies.size());
      scene.bodies.push_back(body);
      const int sense = drive.layout.sense * drive.layout.sprockets[i].turn;
      scene.drive.sprockets.push_back({sprocket.name,
                                       sprocket.title,
                                       sprocket.role,
                                       number,
                                       number,
                                       sprocket.form.teeth,
                                       sense,
                                       sprocket.form.flat ?
                                           0.5 * sprocket.form.pitch_diameter :
                                           scene.drive.pitch_radius_of(sprocket.form.teeth),
                                       entry_normal(drive.layout, i, scene.drive),
                                       sprocket.form.flat});
      scene.shafts.push_back({number, sense, sprocket.program});
      if (part)
        scene.parts[body.part()] = part;
      if (body.motion == Motion::elastic)
        {
          scene.sectors[body.part()] = std::make_shared<const mesh::Sector>(*part);
          check_inertia(body, sprocket.coupling.has_value(), *scene.sectors[body.part()], scene);
        }

      ToothFamily flanks = make_flanks(model, drive, sprocket, number, part.get(), scene);
      if (model.effects.is_on(Effect::tooth_places))
        flanks.tooth_places = sprocket.tooth_places;
      if (model.effects.is_on(Effect::tooth_inertia) && body.motion == Motion::rigid &&
          !sprocket.form.flat)
        flanks.inert_rim = {sprocket.bore,
                            sprocket.hub_diameter,
                            scene.symmetry().share(drive.sprocket_width),
                            highest_of_rims(drive.chain.pitch)};
      if (sprocket.carries_plates())
        {
          for (ToothFamily &plates :
               std::vector<ToothFamily>{with_plate_nodes(model, drive, sprocket, scene, flanks),
                                        with_plates(model, drive, sprocket, scene, flanks)})
            if (!plates.slaves.empty())
              scene.teeth.push_back(std::move(plates));
          continue;
        }
      if (model.effects.is_on(Effect::tooth_compliance) && body.motion == Motion::rigid &&
          !sprocket.form.flat)
        scene.notes.push_back(
            flanks.name + ": tooth and rim deflect under a roller by " +
            to_text(model.tooth_stiffness[i].value, 4) + " N/m (" +
            (model.tooth_stiffness[i].given ? "given" : "auto") + ")" +
            over_place(flanks.tooth_places) +
            (flanks.inert_rim ?
                 with_inertia(*flanks.inert_rim) :
                 without_inertia(sprocket, drive.chain.pitch, !flanks.tooth_places.empty())));
      for (const Motion motion : {Motion::elastic, Motion::reduced})
        if (any_roller([motion](const Body &roller) { return roller.motion == motion; }))
          for (const mesh::Surface side : sides_on_teeth(drive.chain))
            scene.teeth.push_back(with_elastic_rollers(model,
                                                       drive,
                                                       scene,
                                                       flanks,
                                                       model.tooth_stiffness[i].value,
                                                       friction_on(model, sprocket),
                                                       motion,
                                                       side));
      if (any_rigid)
        scene.teeth.push_back(
            with_rigid_rollers(model,
                               drive,
                               i,
                               sprocket.form.flat ? sprocket.flat_stiffness : stiffness,
                               friction_on(model, sprocket),
                               scene,
                               flanks));
    }
}
} // namespace chaindrive::scene
