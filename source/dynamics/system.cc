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
    : world(scene, comm)
    , bars(scene.bars)
    , elastic(scene, world)
    , contacts(scene, world, search_every_step)
    , loads(scene)
{
  // a phase that nothing in the scene calls for is not made and has no row in the table
  if (bars.size() > 0)
    internal_force_ = timer.add("Internal force");
  if (!elastic.empty())
    elastic.add_phase(timer);
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

void System::evaluate_forces(const double dt)
{
  world.clear_resultants();
  if (world.is_first_rank())
    loads.add_forces(world, dt);
  if (world.is_first_rank() && bars.size() > 0)
    {
      const PhaseTimer::Scope scope(timer, internal_force_);
      bars.add_forces(world, dt);
    }
  elastic.add_rim_forces(world, timer);
  if (!contacts.families().empty())
    {
      const PhaseTimer::Scope scope(timer, contact_);
      contacts.add_forces(world, dt);
    }
  else
    BodyBatches::send_forces(world.copies);
  if (!elastic.empty())
    elastic.advance(world, {dt, loads.gravity(), loads.drag()}, timer);
  world.sum_over_ranks();
  loads.add_work(world);
}

void System::advance(const double dt, const double new_time)
{
  const PhaseTimer::Scope scope(timer, integration_);
  if (!elastic.empty() && !elastic_started_)
    elastic.start(world, {dt, loads.gravity(), loads.drag()}, timer);
  elastic_started_ = true;
  first_half(world, &loads.speed_program(), dt, new_time);
  element::Elastic::follow_hubs(world);
  evaluate_forces(dt);
  second_half(world, &loads.speed_program(), dt);
  close_ledger();
}

void System::close_ledger() { world.ledger.kinetic += world.kinetic_energy(); }

void System::serialize(const Archive &archive)
{
  archive("elastic started", elastic_started_);
  world.serialize(archive / "world");
  bars.serialize(archive / "bars");
  elastic.serialize(archive / "elastic");
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
  for (const auto &limit : elastic.limits())
    step_limits.push_back({"elements of the " + limit.part, limit.step});
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

  for (const auto &part : elastic.limits())
    limit = std::min(limit, part.step);
  return closed_contact_step(world, elastic, contacts, limit);
}

std::size_t System::memory_consumption() const
{
  return world.memory_consumption() + bars.memory_consumption() + elastic.memory_consumption() +
         contacts.memory_consumption();
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
      system.elastic.empty() ? dealii::numbers::PI * choice.limit / 40. : largest;
  choice.step   = std::min(largest, accurate);
  choice.reason = accurate < largest ? "auto: a fortieth of the shortest period" :
                                       "auto: the stable step times the safety factor";
  return choice;
}
} // namespace chaindrive::dynamics
