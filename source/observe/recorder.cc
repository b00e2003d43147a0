// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/dynamics/newmark.h>
#include <chaindrive/mesh/part.h>
#include <chaindrive/observe/recorder.h>
#include <chaindrive/utilities/checksum.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/ranks.h>
#include <chaindrive/utilities/text.h>
#include <chaindrive/version.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

namespace chaindrive::observe
{
namespace
{
constexpr const char *histories_name = "/histories";

/// At most one at every step, and one before the first.
std::size_t expected_samples(const Parameters &p, const unsigned long n_steps)
{
  const double intervals = (p.time.end - p.time.start) / p.output.history_interval;
  return static_cast<std::size_t>(std::min(intervals + 1., double(n_steps))) + 1;
}

/// The components of a unit vector as text, so that they read back exactly.
std::string axis_text(const dealii::Tensor<1, 3> &axis)
{
  return to_text(axis[0], 17) + " " + to_text(axis[1], 17) + " " + to_text(axis[2], 17);
}

double window_end(const Parameters &p) { return p.output.window_end.value_or(p.time.end); }
} // namespace

Recorder::Recorder(const scene::Scene     &scene,
                   const Parameters       &parameters,
                   const dynamics::System &system,
                   const unsigned long     n_steps,
                   const std::string      &directory,
                   const std::string      &parameter_text,
                   PhaseTimer             &timer,
                   files::Log             &log)
    : scene_(scene)
    , parameters_(parameters)
    , phase_(timer.add("Output"))
    , spans_(scene, system)
    , engagements_(scene, system)
    // a last step may end a little later than the run: a run that goes on counts all of it
    , driven_speed_(parameters.output.window_start,
                    parameters.output.window_end.value_or(std::numeric_limits<double>::infinity()))
    , driver_torque_(driven_speed_)
    , tight_tension_(driven_speed_)
    , slack_tension_(driven_speed_)
    , span_speed_(driven_speed_)
    , samples_(parameters.time.start, parameters.output.history_interval)
    , pictures_(parameters.time.start, parameters.output.field_interval)
{
  if (system.world.is_first_rank())
    {
      histories_ = std::make_unique<files::Histories>(
          directory + histories_name,
          std::vector<std::pair<std::string, std::string>>{
              {"program", std::string("chaindrive ") + version},
              {"parameters", parameter_text},
              {"parameter_hash", checksum(parameter_text)},
              {"span_direction", axis_text(scene.span_direction)},
              {"span_normal", axis_text(scene.span_normal)},
              {"axes", "driver at the origin, driven at (C, 0); z along the shafts; gravity -y"}},
          expected_samples(parameters, n_steps),
          parameters.output.csv);
      progress_ = std::make_unique<Progress>(log, parameters.time.start, parameters.time.end);
    }
  rollers_ = parameters.output.rollers;
  if (rollers_.empty())
    for (unsigned int k = 0; k < scene.n_joints; ++k)
      rollers_.push_back(k);

  link_peak_.assign(scene.n_joints, 0.);
  std::set<std::string> named; // families of rigid and of elastic bodies share a name
  for (const scene::ToothFamily &teeth : scene.teeth)
    if (named.insert(teeth.name).second)
      {
        const scene::Sprocket &sprocket = scene.sprockets.at(scene.bodies[teeth.sprocket].number);
        const unsigned int     n_gaps   = sprocket.teeth;
        teeth_.push_back({{},
                          sprocket.name(),
                          std::vector<double>(scene.n_joints, 0.),
                          std::vector<double>(scene.n_joints, 0.),
                          std::vector<double>(n_gaps, 0.),
                          std::vector<double>(n_gaps, 0.)});
        for (const contact::Family *family : system.contacts.find(teeth.name))
          teeth_.back().families.push_back(dynamic_cast<const contact::SurfaceContact *>(family));
      }
  for (const scene::BoreFamily &bores : scene.bores)
    if (named.insert(bores.name).second)
      bores_.push_back({bores.name,
                        system.contacts.find(bores.name),
                        std::vector<double>(scene.n_joints, 0.),
                        std::vector<double>(scene.n_joints, 0.)});

  for (const scene::FaceFamily &faces : scene.faces)
    faces_.push_back({faces.name, system.contacts.find(faces.name)});

  if (system.world.has_elastic_bodies())
    elastic_ =
        std::make_unique<ElasticBodies>(scene, system, parameters.output.field_interval > 0.);
  add_channels();

  if (parameters.output.field_interval > 0.)
    {
      fields_ = std::make_unique<Fields>(directory, system.world.communicator());
      for (const auto &[kind, part] : scene.parts)
        patches_.emplace(kind, PartPatches(*part->mesh, scene.sectors.count(kind) != 0));
      for (const Rim &rim : system.world.rims)
        sector_patches_.emplace(rim.group, PartPatches(*rim.sector->part->mesh));
    }
}

bool Recorder::observe(dynamics::System &system, const unsigned long, const double dt)
{
  const PhaseTimer::Scope scope(system.timer, phase_);
  system.contacts.gather_records(system.world);
  const double time          = system.world.time;
  const bool   is_first_rank = histories_ != nullptr;
  if (is_first_rank)
    {
      spans_.update(system);
      engagements_.observe(system, dt);
      keep_peaks(system);
      keep_means(system, dt);
    }

  if (samples_.due(time))
    {
      if (elastic_ != nullptr)
        look_at_elastic_bodies(system);
      if (is_first_rank)
        sample(system);
    }
  if (pictures_.due(time))
    write_fields(system);
  if (is_first_rank)
    progress_->update(time);
  return true;
}

void Recorder::serialize(const Archive &archive, const dynamics::System &system)
{
  const double time = system.world.time;
  engagements_.serialize(archive / "engagements");
  for (ToothForces &teeth : teeth_)
    {
      const Archive part = archive / teeth.name;
      part.numbers("roller", teeth.roller);
      part.numbers("roller peak", teeth.roller_peak);
      part.numbers("gap", teeth.in_gap);
      part.numbers("gap peak", teeth.in_gap_peak);
      part("overlap", teeth.overlap);
    }
  for (BoreForces &bores : bores_)
    {
      const Archive part = archive / bores.name;
      part.numbers("peak", bores.peak);
      part("overlap", bores.overlap);
    }
  for (FaceOverlap &faces : faces_)
    (archive / faces.name)("overlap", faces.overlap);
  archive.numbers("link peak", link_peak_);
  archive("tight tension of the start", tight_tension_start_);

  for (const auto &[name, mean] : {std::make_pair("driven speed", &driven_speed_),
                                   std::make_pair("driver torque", &driver_torque_),
                                   std::make_pair("tight tension", &tight_tension_),
                                   std::make_pair("slack tension", &slack_tension_),
                                   std::make_pair("span speed", &span_speed_)})
    {
      WindowMean earlier = *mean;
      archive(name, earlier);
      if (archive.reads() && !mean->go_on_from(earlier, time))
        throw InputError("its means up to " + to_text(time * 1e3) +
                         " ms belong to another window; leave Output/Window start in ms and "
                         "Window end in ms as they were");
    }

  samples_.serialize(archive / "samples", time);
  pictures_.serialize(archive / "pictures", time);
  bool has_fields = fields_ != nullptr;
  archive("has fields", has_fields);
  if (has_fields && fields_ != nullptr)
    fields_->serialize(archive / "fields");
  if (histories_ != nullptr)
    histories_->serialize(archive / "histories");
  if (progress_ != nullptr && archive.reads())
    progress_->begin_at(time);
}

void Recorder::check(const Archive &archive, const std::string &directory)
{
  files::Histories::check(directory + histories_name, archive / "histories");
}

void Recorder::keep_peaks(const dynamics::System &system)
{
  for (ToothForces &teeth : teeth_)
    teeth.look();
  for (BoreForces &bores : bores_)
    {
      std::fill(bores.joint.begin(), bores.joint.end(), 0.);
      for (const contact::Family *family : bores.families)
        for (const contact::Record &record : family->records())
          {
            bores.joint[record.joint] += record.force * record.normal;
            bores.overlap = std::max(bores.overlap, -record.gap);
          }
      for (unsigned int k = 0; k < bores.joint.size(); ++k)
        bores.peak[k] = std::max(bores.peak[k], bores.joint[k]);
    }
  for (FaceOverlap &faces : faces_)
    for (const contact::Family *family : faces.families)
      for (const contact::Record &record : family->records())
        faces.overlap = std::max(faces.overlap, -record.gap);
  const std::vector<double> &tension = spans_.link_tension();
  for (unsigned int k = 0; k < tension.size(); ++k)
    link_peak_[k] = std::max(link_peak_[k], tension[k]);

  if (system.world.time - parameters_.time.start <= 10e-3)
    tight_tension_start_ = std::max(tight_tension_start_, spans_.tight_tension);
}

void Recorder::keep_means(const dynamics::System &system, const double dt)
{
  // values at the end of the step stand for the step that led there
  const double from = system.world.time - dt;
  for (const World::Hub &hub : system.world.hubs)
    if (hub.body == scene_.with(parameters::Role::driven).body)
      driven_speed_.add(from, dt, scene_.sense * hub.speed);
  driver_torque_.add(from, dt, system.loads.driver_torque());
  tight_tension_.add(from, dt, spans_.tight_tension);
  slack_tension_.add(from, dt, spans_.slack_tension);
  span_speed_.add(from, dt, spans_.tight_speed);
}

void Recorder::sample(dynamics::System &system)
{
  dynamics::accelerations(system.world, acceleration_);
  histories_->begin_sample(system.world.time);
  for (const Source &source : sources_)
    source.fill(system, histories_->values(source.handle));
  histories_->end_sample();

  std::fill(link_peak_.begin(), link_peak_.end(), -std::numeric_limits<double>::max());
  for (ToothForces &teeth : teeth_)
    {
      std::fill(teeth.roller_peak.begin(), teeth.roller_peak.end(), 0.);
      std::fill(teeth.in_gap_peak.begin(), teeth.in_gap_peak.end(), 0.);
    }
  for (BoreForces &bores : bores_)
    std::fill(bores.peak.begin(), bores.peak.end(), 0.);
}

void Recorder::write_fields(const dynamics::System &system)
{
  const World &world = system.world;

  std::vector<dealii::Tensor<1, 3>> contact_force(world.n_bodies());
  for (const auto &family : system.contacts.families())
    for (const contact::Record &record : family->records())
      {
        contact_force[record.slave] += record.force;
        contact_force[record.master] -= record.force;
      }
  if (n_ranks_in(world.communicator()) > 1) // the first rank has all records
    contact_force = dealii::Utilities::MPI::broadcast(world.communicator(), contact_force);

  std::vector<ElasticSnapshot> elastic(world.n_bodies());
  for (unsigned int b = 0; b < world.n_bodies(); ++b)
    if (world.elastic_address[b].group != World::Address::none && world.owns(b))
      elastic[b] = elastic_->snapshot(system, world.elastic_address[b]);

  std::vector<BodySnapshot> bodies;
  for (unsigned int b = 0; b < world.n_bodies(); ++b)
    if (world.owns(b))
      bodies.push_back({&patches_.at(scene_.bodies[b].part()),
                        b,
                        scene_.bodies[b].number_in_pictures(),
                        scene_.bodies[b].initial,
                        world.frames[b],
                        contact_force[b],
                        make_array_view(elastic[b].displacement),
                        make_array_view(elastic[b].velocity),
                        {elastic[b].stress.data(), elastic[b].stress.size()}});

  std::vector<std::vector<ElasticSnapshot>> sectors;
  for (const Rim &rim : world.rims)
    {
      const BodyBatches &copies = world.copies[rim.group];
      sectors.emplace_back(copies.n_copies());
      for (unsigned int s = 0; s < copies.n_copies(); ++s)
        if (copies.owns(s))
          {
            ElasticSnapshot &sector = sectors.back()[s];
            sector                  = elastic_->snapshot(system, {rim.group, s});
            bodies.push_back({&sector_patches_.at(rim.group),
                              rim.body,
                              scene_.bodies[rim.body].number_in_pictures(),
                              copies.start[s],
                              world.frames[rim.body],
                              contact_force[rim.body],
                              make_array_view(sector.displacement),
                              make_array_view(sector.velocity),
                              {sector.stress.data(), sector.stress.size()}});
          }
    }

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
  fields_->write(world.time, bodies, bars);
}

void Recorder::close(const bool finished)
{
  progress_.reset();
  if (histories_ == nullptr)
    return;
  histories_->close();
  if (finished)
    histories_->remove_saved();
}

files::Json Recorder::summary(const dynamics::System             &system,
                              const dynamics::Guard              &guard,
                              const dynamics::StepChoice         &step,
                              const unsigned long                 n_steps,
                              const std::vector<PhaseTimer::Row> &table) const
{
  const Ledger       &ledger = system.world.ledger;
  const unsigned long missed =
      dealii::Utilities::MPI::sum(system.contacts.n_missed(), system.world.communicator());
  files::Json json;
  for (const World::Hub &hub : system.world.hubs)
    if (hub.body == scene_.with(parameters::Role::driven).body)
      json["driven_angle_end"] = scene_.sense * hub.angle;
  json["driven_speed_mean"] = driven_speed_.mean();
  json["span_speed_mean"]   = span_speed_.mean();
  json["pitch_time_mean"] =
      engagements_.mean_pitch_time(parameters_.output.window_start, window_end(parameters_));
  json["tight_tension_mean"]      = tight_tension_.mean();
  json["slack_tension_mean"]      = slack_tension_.mean();
  json["tight_tension_max_start"] = tight_tension_start_;
  json["driver_torque_mean"]      = driver_torque_.mean();
  if (system.world.has_elastic_bodies())
    json["contacts_missed"] = missed;
  json["drive_work"]           = ledger.drive_work;
  json["resisting_work"]       = ledger.resisting_work;
  json["energy_turned_over"]   = guard.energy().turned_over();
  json["energy_imbalance_max"] = nullptr; // unless there is something to compare with
  if (guard.energy().turned_over() > 0.)
    json["energy_imbalance_max"] =
        guard.energy().largest_imbalance() / guard.energy().turned_over();
  if (guard.looks())
    {
      json["momentum_imbalance_max"] = guard.largest_momentum_error();
      json["energy_jump_max"]        = guard.largest_energy_jump();
    }
  for (const ToothForces &teeth : teeth_)
    json["overlap_max"]["roller-" + teeth.name] = teeth.overlap;
  for (const BoreForces &bores : bores_)
    json["overlap_max"][bores.name] = bores.overlap;
  for (const FaceOverlap &faces : faces_)
    json["overlap_max"][faces.name] = faces.overlap;
  json["energy"]      = {{"kinetic", ledger.kinetic},
                         {"potential", ledger.potential},
                         {"bar", ledger.bar},
                         {"strain", ledger.strain},
                         {"hourglass", ledger.hourglass},
                         {"contact", ledger.contact},
                         {"friction_loss", ledger.friction},
                         {"contact_damping_loss", ledger.contact_damping},
                         {"chain_damping_loss", ledger.chain_damping},
                         {"drag_loss", ledger.drag}};
  json["stable_step"] = step.limit;
  json["step"]        = step.step;
  json["steps"]       = n_steps;
  json["searches"]    = system.contacts.search_statistics().searches;
  json["window"] = {{"start", parameters_.output.window_start}, {"end", window_end(parameters_)}};
  json["ranks"]  = n_ranks_in(system.world.communicator());
  json["wall_seconds"] = system.timer.elapsed();
  json["cpu_seconds"]  = cpu_seconds(table);

  files::Json list = files::Json::array();
  for (const Engagement &e : engagements_.found())
    list.push_back({{"sprocket", e.sprocket},
                    {"roller", e.roller},
                    {"time", e.time},
                    {"relative_speed", e.relative_speed},
                    {"normal_speed", e.normal_speed},
                    {"peak_force", e.peak_force},
                    {"impulse", e.impulse},
                    {"complete", e.complete}});
  json["engagements"] = list;
  return json;
}
} // namespace chaindrive::observe
