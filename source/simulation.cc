// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/chain.h>
#include <chaindrive/drive/stiffness.h>
#include <chaindrive/dynamics/relaxation.h>
#include <chaindrive/dynamics/time_loop.h>
#include <chaindrive/model/decide.h>
#include <chaindrive/observe/elastic_bodies.h>
#include <chaindrive/reduction/kept_basis.h>
#include <chaindrive/reduction/kept_rim_modes.h>
#include <chaindrive/scene/build.h>
#include <chaindrive/simulated_life.h>
#include <chaindrive/simulation.h>
#include <chaindrive/statics/part_stiffness.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/ranks.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

// READ THIS FILE FIRST. What flows through the program, in the order in which it does:
//
//   .prm -> Parameters -> Drive (with the stiffness of its parts) -> Model (every decision) ->
//   Scene
//   -> System (World, forces) -> time loop -> Summary
//
// run_command.cc puts files and the console around it.

namespace chaindrive
{
namespace
{
/// How well energy and momentum were balanced. Energies are those of all @p strands that are alike.
void add_balances(files::Json &values, const dynamics::Guard &guard, const double strands)
{
  const double turned_over       = guard.energy().turned_over();
  values["energy_turned_over"]   = strands * turned_over;
  values["energy_imbalance_max"] = nullptr; // unless there is something to compare with
  if (turned_over > 0.)
    values["energy_imbalance_max"] = guard.energy().largest_imbalance() / turned_over;
  if (guard.looks())
    {
      values["momentum_imbalance_max"] = guard.largest_momentum_error();
      values["energy_jump_max"]        = guard.largest_energy_jump();
    }
}

/// Whether means over the window tell what they are said to.
void add_validity(files::Json &values)
{
  files::Json &window = values["window"];
  window["valid"]     = nullptr; // there are none
  if (window["start"].is_number())
    window["valid"] =
        !values.contains("events") ||
        std::none_of(values["events"].begin(),
                     values["events"].end(),
                     [](const files::Json &event) { return event["in_window"].get<bool>(); });
}

/// The shift of one joint that lets it carry the force that it is placed for: Newton's method with
/// a slope from secants, which changes by a factor of two at most, since neighbours are shifted at
/// the same time, and in steps of a quarter of that, so that the round-off of forces does not grow:
/// ranks add in another order. What is less than a hundredth of the prestress tells nothing of the
/// slope.
struct ShiftOfJoint
{
  double slope;                   ///< force over shift, N/m; at the beginning about right
  double force = 0., change = 0.; ///< found last, N; of the shift after that, m
  double most = 4. * slope, least = 0.15 * slope;

  /// Corrects @p shift where @p is is found for @p wanted, in a chain with this @p prestress.
  /// Returns the error. N.
  double correct(const double is, const double wanted, const double prestress, double &shift)
  {
    if (is == 0. && force == 0.) // not elastic, or nothing touches there
      return 0.;
    const double secant = change != 0. ? (is - force) / change : 0.;
    if (secant > 0. && std::abs(is - force) > 0.01 * prestress)
      {
        const double near =
            std::clamp(secant, std::max(least, 0.5 * slope), std::min(most, 2. * slope));
        slope = std::exp2(0.25 * std::round(4. * std::log2(near)));
      }
    force  = is;
    change = (wanted - is) / slope;
    shift += change;
    return std::abs(wanted - is);
  }
};

/// The bases of the parts of @p parameters, each found once. Collective over @p comm.
scene::BasisOf
part_bases(const Parameters &parameters, const MPI_Comm comm, const Announce &announce)
{
  using Known = std::map<std::string, std::shared_ptr<const reduction::Basis>>;
  return [&parameters,
          effects = model::decide_effects(parameters),
          comm,
          announce,
          known = std::make_shared<Known>()](const mesh::Part &part) {
    auto &basis = (*known)[part.name];
    if (!basis)
      {
        statics::Cache cache(statics::Cache::usual_folder());
        basis = std::make_shared<const reduction::Basis>(reduction::kept_basis(
            part,
            parameters.material,
            parameters.elements,
            reduction::options_of(parameters.reduction,
                                  drive::make_chain(parameters.drive.chain).pitch,
                                  !effects.is_on(model::Effect::exact_joints),
                                  !effects.is_on(model::Effect::exact_teeth),
                                  effects.is_on(model::Effect::plate_faces)),
            cache,
            comm,
            announce));
      }
    return basis;
  };
}

/// scene::build_scene(), with the modes of rims that have inertia. Collective over @p comm.
scene::Scene build_scene(const model::Model             &model,
                         const drive::Drive             &drive,
                         const std::vector<std::string> &folders,
                         const scene::BasisOf           &basis_of,
                         const MPI_Comm                  comm,
                         const Announce                 &announce = {})
{
  scene::Scene   scene = scene::build_scene(model, drive, folders, basis_of);
  statics::Cache cache(statics::Cache::usual_folder());
  for (scene::ToothFamily &teeth : scene.teeth)
    if (const std::optional<scene::InertRim> &rim = teeth.inert_rim; rim && !teeth.rim_modes)
      {
        teeth.rim_modes = std::make_shared<const reduction::RimModes>(
            reduction::kept_rim_modes(*teeth.form,
                                      {rim->bore, rim->hub_diameter, rim->width},
                                      scene.material,
                                      rim->modes_up_to,
                                      cache,
                                      comm,
                                      announce));
        for (scene::ToothFamily &other : scene.teeth)
          if (other.sprocket == teeth.sprocket)
            other.rim_modes = teeth.rim_modes;
      }
  return scene;
}

/// The drive of @p parameters and the model of it. For a settled start elastic bodies are placed as
/// it suits their own joints, whose forces are found by straining them.
std::pair<drive::Drive, model::Model> decide(const Parameters               &parameters,
                                             const std::vector<std::string> &folders,
                                             const scene::BasisOf           &basis_of,
                                             const MPI_Comm                  comm,
                                             const Announce                 &announce)
{
  const model::Effects     effects   = model::decide_effects(parameters);
  const drive::StiffnessOf stiffness = statics::part_stiffness(
      model::part_stiffnesses(parameters, effects), parameters.material, comm, announce);
  drive::Drive       drive = drive::make_drive(parameters, stiffness);
  const model::Model model = model::make_model(parameters, drive, effects);
  if (!parameters.model.capabilities().is_elastic || effects.is_on(model::Effect::start_up))
    return {drive, model};
  const std::size_t n              = drive.layout.joints.size();
  const double      seat_stiffness = // roller and tooth deflect as well
      0.4 * drive::line_contact_stiffness(drive.chain.roller_length, parameters.material);
  drive::JointShifts        shifts{std::vector<double>(n, 0.), std::vector<double>(n, 0.)};
  std::vector<ShiftOfJoint> pins(n, ShiftOfJoint{2. * drive.stiffness_per_pitch}),
      seats(n, ShiftOfJoint{seat_stiffness});
  std::optional<double> critical_time_step;
  for (unsigned int i = 0; i < 6; ++i)
    {
      if (announce)
        announce("Straining the elastic bodies for a settled start, round " +
                 std::to_string(i + 1) + " of at most 6 ...");
      const scene::Scene   scene = build_scene(model, drive, folders, basis_of, comm, announce);
      dynamics::Relaxation relaxation(scene, comm, 2e-3, critical_time_step);
      const auto           forces = relaxation.joint_forces();
      critical_time_step          = relaxation.critical_time_step();
      const double prestress      = drive.layout.prestress;
      double       worst          = 0.;
      for (unsigned int k = 0; k < n; ++k)
        {
          const drive::Layout::Joint &joint = drive.layout.joints[k];
          const double                of_pin =
              pins[k].correct(forces.pin[k], joint.pin_force, prestress, shifts.pin[k]);
          const double of_seat =
              seats[k].correct(forces.seat[k], joint.seat_force, prestress, shifts.seat[k]);
          worst = std::max({worst, of_pin, of_seat});
        }
      if (worst < 0.03 * prestress)
        break;
      drive = drive::make_drive(parameters, stiffness, shifts);
    }
  return {drive, model};
}

/// What the checks of the design say of loads that chain or contacts may not stand.
std::string overload(const Parameters &parameters, const drive::Facts &facts)
{
  std::string sentences;
  for (const drive::Check &check : drive::check_design(parameters, facts))
    if (check.name == "strength" || check.name == "start")
      sentences += (sentences.empty() ? "" : " ") + check.sentence;
  return sentences;
}

/// With what observers measure in every step.
scene::Scene make_scene(const model::Model             &model,
                        const drive::Drive             &drive,
                        const std::vector<std::string> &folders,
                        const scene::BasisOf           &basis_of,
                        const MPI_Comm                  comm)
{
  scene::Scene scene = build_scene(model, drive, folders, basis_of, comm);
  if (model.output.asks_for(parameters::QuantityGroup::plate_stress))
    observe::measure_waists(scene, comm);
  return scene;
}

/// A refusal names what may be to blame: meshes with their flanks, wheels that are out of line.
std::unique_ptr<dynamics::System> make_system(const model::Model &model,
                                              const drive::Drive &drive,
                                              const scene::Scene &scene,
                                              const MPI_Comm      comm)
{
  try
    {
      return std::make_unique<dynamics::System>(scene,
                                                model.contact.search_every_step,
                                                scene.has_elastic_bodies() ? comm : MPI_COMM_SELF);
    }
  catch (const InputError &error)
    {
      std::string advice;
      for (const drive::Sprocket &sprocket : drive.sprockets)
        if (!sprocket.mesh.empty())
          advice += " The " + sprocket.title + " touches with the flanks of the mesh '" +
                    sprocket.mesh + "', which must fit as well.";
      if (model.effects.is_on(model::Effect::misalignment))
        advice += " Wheels are out of line: a smaller Axial offset in mm or Tilt in degrees, or a "
                  "greater Drive/Sprockets/Side relief in mm, lets plates clear the teeth.";
      throw InputError(error.what() + advice);
    }
}
} // namespace

Simulation::Simulation(const Parameters               &parameters,
                       const std::vector<std::string> &folders,
                       const MPI_Comm                  comm,
                       const Announce                 &announce)
    : Simulation(parameters, folders, part_bases(parameters, comm, announce), comm, announce)
{
}

Simulation::Simulation(const Parameters               &parameters,
                       const std::vector<std::string> &folders,
                       const scene::BasisOf           &basis_of,
                       const MPI_Comm                  comm,
                       const Announce                 &announce)
    : Simulation(parameters,
                 folders,
                 basis_of,
                 decide(parameters, folders, basis_of, comm, announce),
                 comm)
{
}

Simulation::Simulation(const Parameters                            &parameters,
                       const std::vector<std::string>              &folders,
                       const scene::BasisOf                        &basis_of,
                       const std::pair<drive::Drive, model::Model> &decided,
                       const MPI_Comm                               comm)
    : parameters(parameters)
    , drive(decided.first)
    , facts(drive::make_facts(parameters, drive))
    , model(decided.second)
    , scene(make_scene(model, drive, folders, basis_of, comm))
{
  if (!scene.has_elastic_bodies() && rank_in(comm) != 0)
    return;
  statics::Cache cache(statics::Cache::usual_folder());
  system_   = make_system(model, drive, scene, comm);
  step      = stability::choose_time_step(system_->world,
                                     system_->bars,
                                     system_->forces,
                                     system_->contacts,
                                     system_->loads.drag(),
                                     model.time,
                                     &cache);
  guard_    = std::make_unique<dynamics::Guard>(scene,
                                             *system_,
                                             model.time.energy_limit,
                                             step.limit,
                                             model.time.guard,
                                             overload(parameters, facts));
  recorder_ = std::make_unique<observe::Recorder>(
      scene, model, *system_, system_->timer, drive::pitches_per_resonance(facts));
}

unsigned long Simulation::n_steps() const
{
  return dynamics::n_steps(model.time.start, model.time.end, step.step);
}

unsigned long Simulation::run(const std::vector<dynamics::Observer *> &others,
                              const unsigned long                      done)
{
  std::vector<dynamics::Observer *> all = observers();
  all.insert(all.end(), others.begin(), others.end());
  done_ = dynamics::run(*system_, all, model.time.start, model.time.end, step.step, done);
  return done_;
}

drive::DesignLife Simulation::life() const
{
  return drive::design_life(facts,
                            drive.chain,
                            parameters.drive.layout.worn_chain ==
                                parameters::WornChain::shafts_kept,
                            drive.holes);
}

observe::Summary Simulation::summary() const
{
  observe::Summary summary;
  summary.phases      = observe::rows_of_all_ranks(system_->timer, communicator());
  summary.ranks       = observe::of_ranks(communicator());
  files::Json &values = summary.values;
  recorder_->summarize(values);
  add_balances(values, *guard_, scene.drive.strands);
  values["checks"]             = drive::to_json(drive::check_design(parameters, facts));
  values["drive"]              = drive::to_json(facts);
  const drive::DesignLife life = this->life();
  values["critical_time_step"] = step.limit;
  values["time_step"]          = step.step;
  values["steps"]              = done_;
  values["window"]             = window().summary(system_->world.time);
  files::Json estimates        = drive::to_json(life);
  if (values.contains("life")) // what was observed
    estimates.update(values["life"]);
  values["life"] = estimates;
  add_simulated_life(values, life, facts, model.contact.bush_pin_friction);
  values["ranks"]        = n_ranks_in(communicator());
  values["memory_peak"]  = observe::memory_peak(communicator());
  values["wall_seconds"] = system_->timer.elapsed();
  values["cpu_seconds"]  = observe::cpu_seconds(summary.phases);
  add_validity(values);
  values = observe::in_order(values);
  return summary;
}
} // namespace chaindrive
