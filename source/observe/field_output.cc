// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/geometry.h>
#include <chaindrive/mesh/part.h>
#include <chaindrive/observe/field_output.h>
#include <chaindrive/utilities/gather_all.h>
#include <chaindrive/utilities/ranks.h>
#include <chaindrive/utilities/timing.h>

#include <deal.II/base/mpi.h>

#include <boost/serialization/map.hpp>
#include <boost/serialization/vector.hpp>

namespace chaindrive::observe
{
FieldOutput::Drawing::Drawing(const scene::Scene     &scene,
                              const dynamics::System &system,
                              const std::string      &directory)
    : fields(directory, system.world.communicator()), elastic(system), massless(scene, system)
{
  if (scene.strands.empty())
    strands.push_back({Spans(scene, system), make_tooth_forces(scene, system)});
  for (const scene::DriveView &strand : scene.strands)
    strands.push_back(
        {Spans(scene, strand, system), make_tooth_forces(scene, system, strand.strand)});
  for (const auto &[of, part] : scene.parts)
    parts.emplace(of, PartPatches(*part->mesh, scene.sectors.count(of) != 0));
  for (const Rim &rim : system.world.rims)
    sectors.emplace(rim.group, PartPatches(*rim.sector->part->mesh));
}

FieldOutput::FieldOutput(const scene::Scene     &scene,
                         const model::Model     &model,
                         const dynamics::System &system,
                         const std::string      &directory,
                         PhaseTimer             &timer)
    : scene_(scene), phase_(timer.add("Output")), schedule_(model.time.start, model.field_interval)
{
  if (model.field_interval > 0.)
    drawing_ = std::make_unique<Drawing>(scene, system, directory);
}

void FieldOutput::observe(const dynamics::System &system,
                          const unsigned long,
                          const double,
                          dynamics::Services &services)
{
  const PhaseTimer::Scope scope(services.timer(), phase_);
  if (!schedule_.due(system.world.time))
    return;
  services.update_bodies();
  services.gather_records();
  write(system);
}

void FieldOutput::serialize(const Archive &archive, const dynamics::System &system)
{
  schedule_.serialize(archive / "schedule", system.world.time);
  bool has_fields = drawing_ != nullptr;
  archive("has fields", has_fields);
  if (has_fields && drawing_ != nullptr)
    drawing_->fields.serialize(archive / "fields");
}

namespace
{
/// Resultant [N] on each body, on all ranks.
std::vector<dealii::Tensor<1, 3>> contact_forces(const dynamics::System &system)
{
  const World                      &world = system.world;
  std::vector<dealii::Tensor<1, 3>> contact_force(world.n_bodies());
  for (const auto &family : system.contacts.families())
    for (const contact::Record &record : family->records())
      {
        contact_force[record.slave] += record.force;
        contact_force[record.master] -= record.force;
      }
  if (n_ranks_in(world.communicator()) > 1) // the first rank has all records
    {
      const Waiting waiting;
      contact_force = dealii::Utilities::MPI::broadcast(world.communicator(), contact_force);
    }
  return contact_force;
}

/// What links and teeth of a strand carry at one instant, N.
struct Loads
{
  std::vector<double>                         tension, roller; ///< per link; of the teeth per joint
  std::map<unsigned int, std::vector<double>> gaps;            ///< of a sprocket, by its number

  template <typename BoostArchive>
  void serialize(BoostArchive &archive, unsigned int)
  {
    archive &tension &roller &gaps;
  }
};

Loads loads_of(const scene::Scene &scene, const dynamics::System &system, StrandForces &strand)
{
  Loads loads;
  strand.spans.update(system);
  loads.tension = strand.spans.link_tension();
  loads.roller.resize(scene.drive.n_joints, 0.);
  for (ToothForces &forces : strand.teeth)
    {
      forces.update();
      for (unsigned int k = 0; k < scene.drive.n_joints; ++k)
        loads.roller[k] += forces.roller[k];
      for (unsigned int s = 0; s < scene.drive.sprockets.size(); ++s)
        if (scene.drive.sprockets[s].name == forces.name)
          loads.gaps[s] = forces.in_gap;
    }
  return loads;
}

/// Of each strand, on all ranks.
std::vector<Loads> loads_of(const scene::Scene        &scene,
                            const dynamics::System    &system,
                            std::vector<StrandForces> &strands)
{
  std::vector<Loads> loads;
  if (system.world.is_first_rank()) // which has all records
    for (StrandForces &strand : strands)
      loads.push_back(loads_of(scene, system, strand));
  if (n_ranks_in(system.world.communicator()) > 1)
    {
      const Waiting waiting;
      loads = dealii::Utilities::MPI::broadcast(system.world.communicator(), loads);
    }
  return loads;
}

/// Adds to the snapshot of @p body what it carries.
void add_loads(BodySnapshot &snapshot, const scene::Body &body, const Loads &loads)
{
  const auto n = static_cast<unsigned int>(loads.tension.size());
  if (body.kind == scene::Kind::sprocket)
    {
      if (const auto gaps = loads.gaps.find(body.number); gaps != loads.gaps.end())
        {
          snapshot.gap_load = {gaps->second.data(), gaps->second.size()};
          snapshot.sprocket = &body.initial;
        }
    }
  else if (body.number >= n)
    return; // no chain
  else if (body.kind == scene::Kind::roller)
    {
      snapshot.tension =
          0.5 * (loads.tension[body.number] + loads.tension[(body.number + n - 1) % n]);
      snapshot.tooth_load = loads.roller[body.number];
    }
  else
    snapshot.tension = loads.tension[body.number];
}

/// Gives @p bodies of this rank the contact pressure on their vertices, where it is known.
/// Collective.
void add_pressures(const dynamics::System &system, std::vector<ElasticSnapshot> &bodies)
{
  const World                       &world = system.world;
  std::vector<contact::NodePressure> own;
  for (const auto &family : system.contacts.families())
    if (family->is_distributed() || world.is_first_rank())
      family->add_pressures(world, own);
  for (unsigned int b = 0; b < bodies.size(); ++b)
    bodies[b].pressure.assign(bodies[b].displacement.size(), 0.);
  for (const contact::NodePressure &at : gather_all(std::move(own), world.communicator()))
    if (world.owns(at.body) && !bodies[at.body].pressure.empty())
      {
        const auto &nodes = world.copies[world.elastic_address[at.body].group].nodes;
        bodies[at.body].pressure[nodes.vertex[at.node]] += at.pressure;
      }
}

/// Whether contacts tell of pressure.
bool know_pressure(const dynamics::System &system)
{
  for (const auto &family : system.contacts.families())
    if (family->knows_pressure())
      return true;
  return false;
}

/// What touches, of the pairs that this rank evaluates.
std::vector<PatchSnapshot> patches_of(const scene::Scene &scene, const dynamics::System &system)
{
  std::vector<PatchSnapshot> snapshots;
  for (const auto &family : system.contacts.families())
    {
      std::vector<contact::PressurePatch> patches;
      if (family->is_distributed() || system.world.is_first_rank())
        family->add_patches(system.world, patches);
      for (const contact::PressurePatch &patch : patches)
        snapshots.push_back({patch.corners,
                             patch.pressure,
                             patch.normal_force,
                             scene.bodies[patch.slave].number_in_fields(),
                             scene.bodies[patch.master].number_in_fields(),
                             patch.joint,
                             static_cast<int>(family->interface().interface)});
    }
  return snapshots;
}

/// The frame of what stands at @p z [m] in @p frame.
Frame at(const Frame &frame, const double z)
{
  if (z == 0.)
    return frame;
  Frame                      moved = frame;
  const dealii::Tensor<1, 3> arm   = z * contact::axis_of(frame, 2);
  moved.position += arm;
  moved.velocity += cross_product_3d(frame.angular_velocity, arm);
  return moved;
}

std::vector<BarSnapshot> snapshots_of_bars(const dynamics::System &system)
{
  const World             &world = system.world;
  std::vector<BarSnapshot> bars;
  for (unsigned int i = 0; i < system.bars.size(); ++i)
    {
      const scene::Bar &bar = system.bars.bars()[i];
      BarSnapshot       snapshot;
      snapshot.id = i;
      for (const unsigned int end : {0U, 1U})
        {
          const unsigned int body    = end == 0 ? bar.first : bar.second;
          const Frame       &now     = world.frames[body];
          snapshot.position[end]     = dealii::Point<3>(now.position);
          snapshot.displacement[end] = now.position - world.origin[body];
          snapshot.velocity[end]     = now.velocity;
        }
      snapshot.tension = system.bars.tension()[i];
      bars.push_back(snapshot);
    }
  return bars;
}
} // namespace

void FieldOutput::write(const dynamics::System &system)
{
  const World &world = system.world;

  const std::vector<dealii::Tensor<1, 3>> contact_force = contact_forces(system);

  const std::vector<Loads> loads = loads_of(scene_, system, drawing_->strands);

  const auto                   massless = drawing_->massless.now(system);
  std::vector<ElasticSnapshot> elastic(world.n_bodies());
  for (unsigned int b = 0; b < world.n_bodies(); ++b)
    if (world.elastic_address[b].group != World::Address::none && world.owns(b))
      {
        const auto found = massless.find(b);
        elastic[b]       = drawing_->elastic.of(
            system, world.elastic_address[b], found == massless.end() ? nullptr : &found->second);
      }

  const bool pressure = know_pressure(system);
  if (pressure)
    add_pressures(system, elastic);

  std::vector<BodySnapshot> bodies;
  for (unsigned int b = 0; b < world.n_bodies(); ++b)
    if (const auto part = drawing_->parts.find(scene_.bodies[b].part());
        world.owns(b) && part != drawing_->parts.end()) // an arm has no mesh
      for (unsigned int i = 0; i < scene_.bodies[b].parts_at.size(); ++i)
        {
          const double       z      = scene_.bodies[b].parts_at[i];
          const unsigned int strand = scene_.bodies[b].strand > 0 ? scene_.bodies[b].strand - 1 : i;
          bodies.push_back({&part->second,
                            b,
                            scene_.bodies[b].number_in_fields(),
                            at(scene_.bodies[b].initial, z),
                            at(world.frames[b], z),
                            contact_force[b],
                            make_array_view(elastic[b].displacement),
                            make_array_view(elastic[b].velocity),
                            {elastic[b].stress.data(), elastic[b].stress.size()},
                            {elastic[b].faces.data(), elastic[b].faces.size()}});
          bodies.back().pressure = {elastic[b].pressure.data(), elastic[b].pressure.size()};
          add_loads(bodies.back(), scene_.bodies[b], loads[strand]);
        }

  std::vector<std::vector<ElasticSnapshot>> sectors;
  for (const Rim &rim : world.rims)
    {
      const BodyBatches &copies = world.copies[rim.group];
      sectors.emplace_back(copies.n_copies());
      for (unsigned int s = 0; s < copies.n_copies(); ++s)
        if (copies.owns(s))
          {
            ElasticSnapshot &sector = sectors.back()[s];
            sector                  = drawing_->elastic.of(system, {rim.group, s});
            bodies.push_back({&drawing_->sectors.at(rim.group),
                              rim.body,
                              scene_.bodies[rim.body].number_in_fields(),
                              copies.start[s],
                              world.frames[rim.body],
                              contact_force[rim.body],
                              make_array_view(sector.displacement),
                              make_array_view(sector.velocity),
                              {sector.stress.data(), sector.stress.size()},
                              {sector.faces.data(), sector.faces.size()}});
            add_loads(bodies.back(), scene_.bodies[rim.body], loads.front());
          }
    }

  const std::vector<PatchSnapshot> patches = patches_of(scene_, system);
  drawing_->fields.write(
      world.time, bodies, snapshots_of_bars(system), pressure ? &patches : nullptr);
}
} // namespace chaindrive::observe
