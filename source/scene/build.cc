// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/import/import.h>
#include <chaindrive/mesh/sector.h>
#include <chaindrive/mesh/surface/facet_surface.h>
#include <chaindrive/mesh/surface/surface_nodes.h>
#include <chaindrive/scene/build.h>
#include <chaindrive/scene/placement.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace chaindrive::scene
{
namespace
{
/// Coefficients of effects that are off become zero: nothing downstream asks about effects again.
parameters::Loads effective_loads(const Parameters &p, const std::vector<Effect> &effects)
{
  parameters::Loads loads = p.loads;
  if (!is_on(effects, "gravity"))
    loads.gravity = 0.;
  if (!is_on(effects, "drag"))
    loads.drag = 0.;
  return loads;
}

/// Rollers whose nodes meet the flanks of @p teeth; the sprocket must be there.
void add_elastic_rollers(const Parameters   &parameters,
                         const drive::Drive &drive,
                         const Scene        &scene,
                         ToothFamily        &teeth)
{
  const mesh::Part        &roller = *scene.parts.at(Kind::roller);
  const mesh::SurfaceNodes outside(roller, mesh::Nodes(roller), mesh::roller_outside);
  double                   thickness = outside.thickness;
  const auto               sector    = scene.sectors.find(scene.bodies[teeth.sprocket].kind);
  if (sector != scene.sectors.end()) // the softer of two surfaces decides how far they may overlap
    {
      const mesh::Part &part = *sector->second->part;
      thickness              = std::max(
          thickness, mesh::SurfaceNodes(part, mesh::Nodes(part), mesh::tooth_flanks).thickness);
    }
  teeth.law =
      make_area_law(parameters, scene.effects, thickness, parameters.contact.roller_tooth_friction);
  teeth.elastic       = true;
  teeth.slave_surface = mesh::roller_outside;
  for (unsigned int k = 0; k < scene.n_joints; ++k)
    if (scene.bodies[k].motion == Motion::elastic)
      teeth.slaves.push_back({k, dealii::Point<3>(), 0.5 * drive.chain.roller_diameter, k});
}

/// The mesh of a sprocket: from @p file, or generated where somebody needs it, else null.
std::shared_ptr<const mesh::Part> sprocket_part(const Parameters               &parameters,
                                                const drive::Drive             &drive,
                                                const bool                      driver,
                                                const std::string              &file,
                                                const std::vector<std::string> &folders,
                                                const Scene                    &scene)
{
  const bool elastic = is_on(scene.effects, "elastic sprockets");
  if (!file.empty())
    {
      auto part = std::make_shared<const mesh::Part>(
          mesh::import_sprocket(mesh::find_file(file, folders),
                                driver ? drive.driver : drive.driven,
                                parameters.material.density,
                                parameters.model.half && elastic));
      if (const double width = mesh::flank_width(*part); width >= drive.chain.inner_width)
        throw InputError(
            std::string("Drive/Sprockets/") + (driver ? "Driver" : "Driven") + " mesh = " + file +
            " has teeth " + to_text(width * 1e3, 4) + " mm wide; they must be narrower than the " +
            to_text(drive.chain.inner_width * 1e3, 4) + " mm between the inner plates.");
      return part;
    }
  if (is_on(scene.effects, "fields") || elastic)
    return make_sprocket_part(parameters, drive, driver);
  return nullptr;
}

/// The only place that asks which fidelity it is; what others ask of it is in
/// parameters::Capabilities.
auto builder_of(const parameters::Fidelity fidelity)
{
  switch (fidelity)
    {
    case parameters::Fidelity::simple:
      return &add_simple_chain;
    case parameters::Fidelity::layered:
      return &add_layered_chain;
    case parameters::Fidelity::full:
      return &add_full_chain;
    }
  throw std::logic_error("a fidelity has no builder");
}

Tensor3 embed(const dealii::Tensor<1, 2> &v)
{
  Tensor3 result;
  result[0] = v[0];
  result[1] = v[1];
  return result;
}
} // namespace

bool Scene::has_elastic_bodies() const
{
  return std::any_of(bodies.begin(), bodies.end(), [](const Body &body) {
    return body.motion == Motion::elastic;
  });
}

double Scene::nominal_energy() const
{
  if (n_joints == 0) // no chain, and no sprocket that it would run on
    return 0.;
  const double pitch_radius = 0.5 * pitch / std::sin(dealii::numbers::PI / driver_teeth);
  const double speed        = pitch_radius * loads.driver_speed;
  return 0.5 * n_joints * mass_per_pitch * speed * speed;
}

ContactLaw make_law(const Parameters           &parameters,
                    const std::vector<Effect>  &effects,
                    const double                k,
                    const double                mass,
                    const std::optional<double> friction)
{
  const parameters::Contact &contact = parameters.contact;
  ContactLaw                 law;
  law.stiffness = k;
  if (is_on(effects, "contact damping"))
    law.damping = 2. * contact.damping_ratio * std::sqrt(k * mass);
  if (is_on(effects, "friction"))
    law.friction = friction.value_or(contact.friction_coefficient);
  if (law.friction > 0.)
    {
      law.tangential_stiffness = contact.tangential_ratio * k;
      law.tangential_damping   = contact.tangential_ratio * law.damping;
    }
  return law;
}

ContactLaw make_area_law(const Parameters           &parameters,
                         const std::vector<Effect>  &effects,
                         const double                thickness,
                         const std::optional<double> friction)
{
  const Material &steel = parameters.material;
  // what moves with a surface at the frequency of its penalty is half an element
  return make_law(parameters,
                  effects,
                  parameters.contact.penalty_factor * steel.bulk_modulus() / thickness,
                  0.5 * steel.density * thickness,
                  friction);
}

Scene build_scene(const Parameters               &parameters,
                  const drive::Drive             &drive,
                  const std::vector<std::string> &folders)
{
  const drive::Layout &layout = drive.layout;
  Scene                scene;
  scene.start_time      = parameters.time.start;
  scene.material        = parameters.material;
  scene.elements        = parameters.elements;
  scene.effects         = decide_effects(parameters);
  scene.loads           = effective_loads(parameters, scene.effects);
  scene.sense           = layout.sense;
  scene.at_speed        = layout.driver_speed != 0.;
  scene.n_joints        = static_cast<unsigned int>(layout.joints.size());
  scene.driver_teeth    = parameters.drive.driver_teeth;
  scene.driven_teeth    = parameters.drive.driven_teeth;
  scene.centre_distance = layout.centre_distance;
  scene.pitch           = drive.chain.loaded_pitch();
  for (const drive::Layout::Joint &joint : layout.joints)
    scene.seated.push_back(joint.tooth_gap >= 0);
  scene.span_direction      = embed(layout.tight_direction);
  scene.span_normal         = embed(layout.tight_normal);
  scene.stiffness_per_pitch = drive.stiffness_per_pitch;
  scene.notes               = drive.notes;
  if (parameters.drive.layout.centre_distance_from == parameters::CentreDistanceFrom::pretension)
    scene.prestress = parameters.drive.layout.pretension;
  if (scene.at_speed)
    scene.prestress = std::max(scene.prestress, drive.nominal_tension);
  if (scene.at_speed) // a warm start finds the load torque fully applied
    scene.torque_angle_offset = scene.loads.torque_ramp_angle;

  builder_of(parameters.model.fidelity)(parameters, drive, scene);
  add_sprockets(parameters, drive, folders, scene);
  return scene;
}

void add_sprockets(const Parameters               &parameters,
                   const drive::Drive             &drive,
                   const std::vector<std::string> &folders,
                   Scene                          &scene)
{
  const drive::Layout &layout = drive.layout;
  const double         tooth_stiffness =
      parameters.contact.roller_tooth_stiffness.value_or(drive.roller_tooth_stiffness);
  const bool   lumped      = !parameters.model.capabilities().has_clearances;
  const double roller_mass = scene.bodies.front().mass;
  const auto   n_elastic =
      std::count_if(scene.bodies.begin(),
                    scene.bodies.begin() + scene.n_joints,
                    [](const Body &roller) { return roller.motion == Motion::elastic; });
  if (n_elastic < scene.n_joints)
    scene.notes.push_back(
        "Roller-tooth stiffness " + to_text(tooth_stiffness, 4) + " N/m (" +
        (parameters.contact.roller_tooth_stiffness ? "given" :
                                                     "auto: ring and line contact in series") +
        "); a smaller value lowers impact peaks in proportion to its square root");

  for (const bool driver : {true, false})
    {
      const unsigned int body                = static_cast<unsigned int>(scene.bodies.size());
      (driver ? scene.driver : scene.driven) = body;
      const drive::ToothForm &form           = driver ? drive.driver : drive.driven;
      const std::string      &file =
          driver ? parameters.drive.sprockets.driver_mesh : parameters.drive.sprockets.driven_mesh;
      const bool elastic_rim = is_on(scene.effects, "elastic sprockets");
      const auto part        = sprocket_part(parameters, drive, driver, file, folders, scene);
      const drive::MassProperties &solid = !file.empty() ? part->meshed :
                                           driver        ? drive.driver_solid :
                                                           drive.driven_solid;

      Body sprocket;
      sprocket.kind    = driver ? Kind::driver : Kind::driven;
      sprocket.number  = 0;
      sprocket.motion  = elastic_rim ? Motion::elastic : Motion::rigid;
      sprocket.support = driver ? Support::prescribed_hub : Support::loaded_hub;
      sprocket.mass    = solid.mass;
      for (unsigned int d = 0; d < 3; ++d)
        sprocket.inertia[d] = solid.inertia[d][d];
      if (!driver)
        {
          sprocket.inertia[2] = parameters.model.driven_inertia.value_or(solid.inertia[2][2]);
          scene.notes.push_back(
              "Driven inertia " + to_text(sprocket.inertia[2], 4) + " kg m2 (" +
              (parameters.model.driven_inertia ? "given" : "auto: the sprocket alone") + ")");
        }
      sprocket.initial = placed(dealii::Point<2>(driver ? 0. : layout.centre_distance, 0.),
                                driver ? layout.driver_angle : layout.driven_angle,
                                dealii::Tensor<1, 2>(),
                                driver ? layout.driver_speed : layout.driven_speed);
      scene.bodies.push_back(sprocket);
      if (part)
        scene.parts[sprocket.kind] = part;
      if (elastic_rim)
        scene.sectors[sprocket.kind] = std::make_shared<const mesh::Sector>(*part);

      ToothFamily teeth;
      teeth.name         = std::string("roller-") + (driver ? "driver" : "driven");
      teeth.sprocket     = body;
      teeth.form         = std::make_shared<const drive::ToothForm>(form);
      teeth.teeth        = form.teeth;
      teeth.outer_radius = 0.5 * form.outside_diameter;
      const double width = file.empty() ? drive.sprocket_width : mesh::flank_width(*part);
      teeth.half_width   = 0.5 * width;
      if (!file.empty())
        {
          teeth.facets = std::make_shared<const mesh::FacetSurface>(
              elastic_rim ? *scene.sectors.at(sprocket.kind)->part : *part, mesh::tooth_flanks);
          for (const dealii::Point<3> &vertex : part->mesh->get_vertices())
            teeth.outer_radius = std::max(teeth.outer_radius, std::hypot(vertex[0], vertex[1]));
          scene.notes.push_back(teeth.name + ": flanks of the imported mesh " + file);
        }

      if (n_elastic > 0)
        {
          ToothFamily elastic = teeth;
          add_elastic_rollers(parameters, drive, scene, elastic);
          scene.teeth.push_back(std::move(elastic));
        }
      if (n_elastic == scene.n_joints)
        continue;
      const ContactLaw law = make_law(parameters,
                                      scene.effects,
                                      tooth_stiffness,
                                      roller_mass,
                                      parameters.contact.roller_tooth_friction);
      // A lumped roller touches in its middle plane. A rigid one touches at two points that give
      // its line of contact the same moment of resistance against tilting.
      const double              contact_length = std::min(drive.chain.roller_length, width);
      const std::vector<double> stations =
          lumped ? std::vector<double>{0.} : line_stations(contact_length);
      teeth.law = law.shared_by(static_cast<unsigned int>(stations.size()));
      for (unsigned int k = 0; k < scene.n_joints; ++k)
        for (const double z : stations)
          if (scene.bodies[k].motion != Motion::elastic)
            teeth.slaves.push_back(
                {k, dealii::Point<3>(0., 0., z), 0.5 * drive.chain.roller_diameter, k});
      scene.teeth.push_back(std::move(teeth));
    }
}
} // namespace chaindrive::scene
