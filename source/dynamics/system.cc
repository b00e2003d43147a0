// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/make_world.h>
#include <chaindrive/dynamics/newmark.h>
#include <chaindrive/dynamics/relaxation.h>
#include <chaindrive/dynamics/system.h>
#include <chaindrive/forces/oil_film.h>
#include <chaindrive/forces/shaft.h>
#include <chaindrive/forces/tensioner.h>
#include <chaindrive/scene/scene.h>
#include <chaindrive/utilities/ranks.h>

namespace chaindrive::dynamics
{
System::System(const scene::Scene &scene, const bool search_every_step, const MPI_Comm comm)
    : world(make_world(scene, comm))
    , bars(scene.bars)
    , contacts(scene, world, search_every_step)
    , loads(scene)
{
  // a phase that nothing in the scene calls for is not made and has no row in the table
  for (const auto &given : scene.forces)
    forces.push_back(given->clone());
  for (const scene::Tensioner &given : scene.tensioners)
    forces.push_back(std::make_unique<TensionerSpring>(given));
  for (const scene::OilFilms &given : scene.oil)
    forces.push_back(std::make_unique<OilFilm>(given));
  for (const scene::Coupling &given : scene.couplings)
    forces.push_back(std::make_unique<CouplingSpring>(scene, given));
  for (const scene::Bearing &given : scene.bearings)
    forces.push_back(std::make_unique<BearingSpring>(scene, given));
  if (bars.size() > 0 || !forces.empty() || world.n_nodal_groups() > 0)
    internal_force_ = timer.add("Internal force");
  integration_ = timer.add("Time integration");
  if (!contacts.families().empty())
    contact_ = timer.add("Contact algorithm");
  if (n_ranks_in(comm) > 1)
    timer.count_waiting();

  for (Rim &rim : world.rims)
    rim.find_seam(world.copies[rim.group]);
  publishes_ = world.planar != nullptr &&
               (!forces.empty() || contacts.reads_frames() || bars.reads_frames(world));
  if (world.planar != nullptr)
    world.planar->set_others_act(publishes_ || n_ranks_in(comm) > 1 || world.symmetry.is_active() ||
                                 !world.tied.empty()); // TiedSpins
  const bool strained = scene.at_speed && world.has_elastic_bodies();
  if (strained)
    Relaxation(scene, comm).strain(world);
  // how bodies were placed and how they strain agree within a factor
  contacts.refuse_penetration(world, (strained ? 2. : 1.) * scene.prestress, scene.start_overlap);
  evaluate_forces();
  world.ledger.initial = world.ledger.stored();
}

// THE STEP from the instant n to n+1, line by line. What stands at which instant afterwards:
// x of frames, v of bodies and frames, x and v of the nodes of elastic bodies, forces and moments.
//
//                                                     frames       nodes
//                                                     x    v       x    v      forces of
//   between two steps                                 n    n       n+1  n+1/2  n
//   advance()
//     start, once: nodes, from x and v of 0, get
//       half a kick and a whole drift by the forces
//       of the constructor's evaluate_forces()        0    0       1    1/2    0
//     kick by dt/2: rigid bodies, hubs                n    n+1/2   n+1  n+1/2  n
//     drift by dt: rigid bodies, hubs                 n+1  n+1/2   n+1  n+1/2  n
//       and nodes follow the hub that holds them; centres of mass of elastic bodies coast
//     evaluate_and_move(): all agree now, positions of n+1 and velocities half a step before;
//       when the forces on nodes are complete they
//       are used up at once, by a kick and a drift    n+1  n+1/2   n+2  n+3/2  n+1
//     kick by dt/2: rigid bodies, hubs                n+1  n+1     n+2  n+3/2  n+1
//     finish: frames take these velocities; close_ledger: and the energies theirs
//
// Reduced bodies move as rigid ones do. Their modes get the first kick in their drift, and the
// second one from evaluate_and_move(), where their energies are booked; between two steps they are
// where the frames are. Their nodes are placed for contacts, with the velocities of n+1/2, and for
// observers, who ask for it; those that nobody has read before, at the first kick as well.
//
// Frames of other elastic bodies are booked by evaluate_and_move(): their centres of mass at n+1,
// with the mean of the velocities before and after. Observers and the guard look between two steps;
// BodyBatches::position_now() gives them nodes at n.
//
// ONE EVALUATION OF THE FORCES, in this order. "Owners" are the ranks that own a batch, "readers"
// those that touch its nodes, "first" is the first rank, which does for all what is not
// distributed.
//
//   clear_resultants     force, moment, momenta of rims and stored energies become zero. Forces on
//                        nodes are zero: whoever used them up has cleared them, or
//                        clear_forces does so                                               all
//   Loads::add_forces    gravity and drag of rigid bodies, and their energies               first
//   ForceElement::add_forces  bars, springs, stops: on both bodies, and energies             first
//   groups: add_forces   rims: internal forces of nodes and their energies; the forces on
//                        held nodes go to the hub, those between sectors become means       owners
//   Contacts::add_forces
//     groups: place_surface   nodes that follow rigid bodies                                first
//                             nodes of reduced bodies                                       readers
//     fetch                   positions and velocities of other nodes of elastic bodies
//                             that other ranks touch                                        message
//     search, if it is due
//     families                forces on nodes of both sides; resultants on bodies, of
//                             elastic ones too, for results and the guard; energies         owners
//     send_forces             forces on these nodes, and halves of rims' means              message
//     groups: gather_forces   nodes that follow rigid bodies: moments on those              first
//                             nodes of reduced bodies: moments, and forces on modes         readers
//   groups: advance      elastic bodies: internal forces, then, if bodies are to move, kick and
//                        drift of the nodes;
//                        energies, momenta, centres of mass                                 owners
//                        reduced bodies: second kick of other shapes, and their energies    owners
//   sum_over_ranks       forces, moments, energies, what ranks ask of each other, frames of
//                        elastic bodies; with halves all of it doubled; forces on modes of
//                        batches whose nodes several ranks touch, and of teeth              message
//   groups: advance_shared  those modes, and those of teeth: second kick, and energies      all
//   Loads::add_work      load torque on the hub, work of both hubs                          all
//
// A step waits for other ranks at the three messages, or only at the last one if no nodes travel:
// those of reduced bodies do not. What observers send is none of it: see doc/architecture.md.

void System::evaluate(const Step &step)
{
  const ForceTimer force_timer{timer, internal_force_};
  if (forces_on_nodes_)
    world.clear_forces();
  else
    world.clear_resultants();
  forces_on_nodes_ = !step.moves;
  if (publishes_)
    world.planar->publish(world);
  if (world.is_first_rank())
    loads.add_forces(world, step.dt);
  if (world.is_first_rank() && world.planar != nullptr && world.planar->oval())
    world.planar->bend_ovals(world);
  if (world.is_first_rank() && (bars.size() > 0 || !forces.empty()))
    {
      const PhaseTimer::Scope scope(timer, internal_force_);
      bars.add_forces(world, step.dt);
      for (ForceElement *element : forces)
        element->add_forces(world, step.dt);
    }
  for (ForceGroup *group : world.groups.force())
    group->add_forces(world, force_timer);
  if (!contacts.families().empty())
    {
      const PhaseTimer::Scope scope(timer, contact_);
      contacts.add_forces(world, step.dt); // from place_surface to gather_forces
    }
  else
    world.node_exchange.send_forces(world.copies);
  for (ElasticGroup *group : world.groups.elastic())
    group->advance(world, step, force_timer);
  if (step.moves)
    {
      world.sum_over_ranks({{contacts.lost_now(), true}, {requests.asks(), false}});
      requests.conclude();
    }
  else
    world.sum_over_ranks({{contacts.lost_now(), true}});
  contacts.book_losses();
  for (SharedGroup *group : world.groups.shared())
    group->advance_shared(world, step);
  loads.add_work(world);
}

void System::evaluate_forces(const double dt)
{
  evaluate({dt, world.time, loads.gravity(), loads.drag(), nullptr, false});
  if (world.planar != nullptr && !world.planar->others_act())
    world.planar->write_forces(world);
  close_ledger();
}

void System::evaluate_and_move(const double dt)
{
  evaluate({dt, world.time, loads.gravity(), loads.drag(), nullptr, true});
}

void System::advance(const double dt, const double new_time)
{
  advance_without_update(dt, new_time);
  world.update_bodies();
}

void System::advance_without_update(const double dt, const double new_time)
{
  const PhaseTimer::Scope scope(timer, integration_);
  const Step              step = make_step(dt, new_time);
  if (!started_)
    for (NodalGroup *group : world.groups.nodal())
      group->start(world, step, {timer, internal_force_});
  started_         = true;
  forces_on_nodes_ = false;
  first_half(world, step);
  evaluate_and_move(dt);
  second_half(world, step);
  close_ledger();
}

Step System::make_step(const double dt, const double new_time)
{
  programs_.resize(world.hubs.size());
  for (std::size_t i = 0; i < programs_.size(); ++i)
    if (world.hubs[i].prescribed)
      {
        const unsigned int body = world.hubs[i].body;
        programs_[i]            = {loads.prescribed_angle(body, new_time),
                                   loads.prescribed_speed(body, new_time - 0.5 * dt),
                                   loads.prescribed_speed(body, new_time)};
      }
  return {dt, new_time, loads.gravity(), loads.drag(), programs_.data()};
}

void System::close_ledger() { world.ledger.kinetic += world.kinetic_energy(); }

void System::serialize(const Archive &archive)
{
  world.update_bodies();
  archive("started", started_);
  if (archive.reads())
    forces_on_nodes_ = false;
  world.serialize(archive / "world");
  bars.serialize(archive / "bars");
  for (std::size_t i = 0; i < forces.size(); ++i)
    forces[i]->serialize(archive / ("force element " + std::to_string(i)));
  contacts.serialize(archive / "contacts", world);
  loads.serialize(archive / "loads");
}

std::vector<stability::TimeStepLimit> System::step_limits() const
{
  return stability::step_limits(world, bars, forces, contacts);
}

double System::critical_time_step() const
{
  return stability::step_limit(world, bars, forces, contacts, loads.drag());
}

std::size_t System::memory_consumption() const
{
  return world.memory_consumption() + bars.memory_consumption() + contacts.memory_consumption();
}
} // namespace chaindrive::dynamics
