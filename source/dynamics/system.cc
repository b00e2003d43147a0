// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/dynamics/closed_contact.h>
#include <chaindrive/dynamics/newmark.h>
#include <chaindrive/dynamics/system.h>
#include <chaindrive/parameters/parameters.h>
#include <chaindrive/scene/scene.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::dynamics
{
System::System(const scene::Scene &scene, const bool search_every_step, const MPI_Comm comm)
    : world(scene, comm), bars(scene.bars), contacts(scene, world, search_every_step), loads(scene)
{
  // a phase that nothing in the scene calls for is not made and has no row in the table
  if (bars.size() > 0 || world.has_elastic_bodies())
    internal_force_ = timer.add("Internal force");
  integration_ = timer.add("Time integration");
  if (!contacts.families().empty())
    contact_ = timer.add("Contact algorithm");

  for (Rim &rim : world.rims)
    rim.find_seam(world.copies[rim.group]);
  contacts.refuse_overlap(world, scene.prestress);
  evaluate_forces(0.);
  close_ledger();
  world.ledger.initial = world.ledger.stored();
}

// THE STEP. Between two steps the world belongs to the instant n: frames, velocities, forces,
// moments and the ledger. Nodes of elastic bodies are ahead: positions at n+1, velocities at n-1/2.
//
// What                                  frames, v    nodes x, v     forces
// ----------------------------------------------------------------------------------------------
// advance(): from n to n+1              n    n       n+1  n-1/2     of n
//   start, before the first step only: nodes get half a kick and a whole drift
//                                       0    0       1    1/2       of 0; nodes': used up
//   kick by dt/2, rigid and hubs        n    n+1/2   n+1  n+1/2 (*) of n
//   drift by dt, rigid and hubs         n+1  n+1/2   n+1  n+1/2     of n
//     nodes that a hub holds follow it; centres of mass of elastic bodies coast
//   evaluate_forces(dt)                 n+1  n+1/2   n+2  n+3/2 (*) of n+1; nodes': used up
//   kick by dt/2, rigid and hubs        n+1  n+1     n+2  n+3/2     of n+1
//   finish: frames take the velocities of the full step; kinetic energies are booked
//
// (*) the velocities of nodes were moved to n+1/2 by evaluate_forces() of the step before.
//
// evaluate_forces(): positions at n+1, velocities half a step before, on all sides of a contact.
// "Ranks" says who adds: every rank for the batches that it owns, or the first one for all.
//
//   who                     adds to                                                       ranks
//   ----------------------------------------------------------------------------------------------
//   World::clear_resultants  force, moment, rim momenta, stored energies become zero;       all
//                            forces on nodes are zero already: advance() has used them up
//   Loads::add_forces        gravity and drag of rigid bodies, and their energies           first
//   Bars::add_forces         tension, on both bodies                                        first
//   group add_forces         nodes of rims: internal forces; hubs: what rims pull           owners
//   group place_surface      places nodes that follow rigid bodies                          first
//   fetch_ghosts             positions and velocities of nodes that others touch            message
//   contact families         nodes: contact; bodies: force and moment, of elastic ones       owners
//                            as well, where nothing but results and the guard reads it
//   send_forces              forces on ghosts go home                                       message
//   group gather_forces      moments of nodes that follow rigid bodies, on those            first
//   group advance            elastic bodies: internal forces, then nodes move to n+2, n+3/2; owners
//                            books energies, momenta and centres of mass of n+1
//   World::sum_over_ranks    sums force, moment, what was booked, frames of elastic bodies message
//   Loads::add_work          the load torque, and the work of both hubs                      all
//
// A step waits for other ranks three times: fetch_ghosts, send_forces and sum_over_ranks.

void System::evaluate_forces(const double dt)
{
  const ForceTimer force_timer{timer, internal_force_};
  world.clear_resultants();
  if (world.is_first_rank())
    loads.add_forces(world, dt);
  if (world.is_first_rank() && bars.size() > 0)
    {
      const PhaseTimer::Scope scope(timer, internal_force_);
      bars.add_forces(world, dt);
    }
  for (const auto &group : world.groups)
    group->add_forces(world, force_timer);
  if (!contacts.families().empty())
    {
      const PhaseTimer::Scope scope(timer, contact_);
      contacts.add_forces(world, dt); // from place_surface to gather_forces
    }
  else
    BodyBatches::send_forces(world.copies);
  const Step step{dt, world.time, loads.gravity(), loads.drag(), {}};
  for (const auto &group : world.groups)
    group->advance(world, step, force_timer);
  world.sum_over_ranks();
  loads.add_work(world);
}

void System::advance(const double dt, const double new_time)
{
  const PhaseTimer::Scope scope(timer, integration_);
  const Step              step = make_step(dt, new_time);
  if (!started_)
    for (const auto &group : world.groups)
      group->start(world, step, {timer, internal_force_});
  started_ = true;
  first_half(world, step);
  evaluate_forces(dt);
  second_half(world, step);
  close_ledger();
}

Step System::make_step(const double dt, const double new_time) const
{
  const load::SpeedProgram &program = loads.speed_program();
  return {dt,
          new_time,
          loads.gravity(),
          loads.drag(),
          Step::Program{program.angle(new_time),
                        program.speed(new_time - 0.5 * dt),
                        program.speed(new_time)}};
}

void System::close_ledger() { world.ledger.kinetic += world.kinetic_energy(); }

void System::serialize(const Archive &archive)
{
  archive("started", started_);
  world.serialize(archive / "world");
  bars.serialize(archive / "bars");
  contacts.serialize(archive / "contacts", world);
  loads.serialize(archive / "loads");
}

std::vector<StepLimit> System::step_limits() const
{
  std::vector<StepLimit> step_limits;
  std::vector<Spring>    springs;
  if (bars.size() > 0)
    {
      bars.add_springs(world, springs);
      step_limits.push_back({"bars", stable_step(world, springs)});
    }
  for (const auto &group : world.groups)
    if (const unsigned int g = group->elastic_copies(); g != BodyGroup::none)
      step_limits.push_back(
          {"elements of the " + world.copies[g].part->name, group->stable_step()});
  for (const auto &family : contacts.families())
    {
      springs.clear();
      family->add_springs(world, springs);
      const double limit =
          std::min(stable_step(world, springs), closed_contact_step(world, *family));
      // families of rigid and of elastic bodies share a name
      const auto same =
          std::find_if(step_limits.begin(), step_limits.end(), [&](const StepLimit &vote) {
            return vote.source == family->name();
          });
      if (same == step_limits.end())
        step_limits.push_back({family->name(), limit});
      else
        same->limit = std::min(same->limit, limit);
    }
  return step_limits;
}

double System::stable_step_limit() const
{
  std::vector<Spring> springs;
  bars.add_springs(world, springs);
  contacts.add_springs(world, springs);
  double limit = stable_step(world, springs);

  for (const auto &group : world.groups)
    limit = std::min(limit, group->stable_step());
  return closed_contact_step(world, contacts, limit);
}

std::size_t System::memory_consumption() const
{
  return world.memory_consumption() + bars.memory_consumption() + contacts.memory_consumption();
}

StepChoice choose_step(const System &system, const Parameters &parameters)
{
  const parameters::Time &time = parameters.time;
  StepChoice              choice;
  choice.step_limits   = system.step_limits();
  choice.limit         = system.stable_step_limit();
  const double largest = time.safety_factor * choice.limit;
  if (time.step)
    {
      if (*time.step > largest)
        throw InputError("Time/Step in us = " + to_text(*time.step * 1e6) +
                         " is above the stable step: at most " + to_text(largest * 1e6, 4) +
                         " us (safety factor " + to_text(time.safety_factor) + " times the limit " +
                         to_text(choice.limit * 1e6, 4) +
                         " us) is allowed; choose a smaller step or auto.");
      choice.step   = *time.step;
      choice.reason = "asked for";
      return choice;
    }
  // The fastest mode has the period pi times the limit; a fortieth of it leaves its frequency
  // 0.1 % wrong, and an impact of half its period twenty steps. With elastic bodies the fastest
  // mode is one of the mesh: what matters is slower by far.
  const double accurate =
      system.world.has_elastic_bodies() ? largest : dealii::numbers::PI * choice.limit / 40.;
  choice.step   = std::min(largest, accurate);
  choice.reason = accurate < largest ? "auto: a fortieth of the shortest period" :
                                       "auto: the stable step times the safety factor";
  return choice;
}
} // namespace chaindrive::dynamics
