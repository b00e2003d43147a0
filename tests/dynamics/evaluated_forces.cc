// SPDX-License-Identifier: LGPL-2.1-or-later
// System::evaluate_forces(), for each fidelity: nothing moves; what it finds between the halves of
// a step are bit by bit the forces of the step, on bodies, nodes and modes; again and again it
// finds the same and books nothing; and a run in which it was called before the first step goes on
// as if it had not been.
#include "../support/decided.h"
#include "../support/reduced.h"

#include <chaindrive/dynamics/newmark.h>

using namespace test;

namespace
{
using Numbers = std::vector<double>;

void append(Numbers &numbers, const World::Vector &vector)
{
  numbers.insert(numbers.end(), vector.begin(), vector.begin() + vector.locally_owned_size());
}

/// Positions and velocities of bodies, nodes and modes; not the centres of mass of bodies that
/// move by nodes, which follow from these.
Numbers motion_of(const dynamics::System &system)
{
  const World &world = system.world;
  Numbers      numbers;
  for (unsigned int b = 0; b < world.n_bodies(); ++b)
    for (unsigned int i = 3 * b; i < 3 * b + 3 && !world.is_nodal(b); ++i)
      for (const World::Vector *vector : {&world.displacement, &world.velocity})
        numbers.push_back(vector->local_element(i));
  for (unsigned int g = 0; g < world.n_nodal_groups(); ++g)
    for (const World::Vector *vector : {&world.copies[g].position, &world.copies[g].velocity})
      append(numbers, *vector);
  for (const World::Rotation &r : world.rotations)
    numbers.insert(numbers.end(), {r.orientation.w, r.orientation.z, r.momentum[2]});
  for (const World::Spin &spin : world.spins)
    numbers.push_back(spin.speed);
  for (const World::Hub &hub : world.hubs)
    numbers.insert(numbers.end(), {hub.angle, hub.speed});
  for (const ModalGroup *group : world.groups.modal())
    {
      numbers.push_back(group->modal_energy(world));
      for (unsigned int copy = 0; copy < 4; ++copy)
        for (const double q : group->amplitudes_of(world, copy))
          numbers.push_back(q);
    }
  return numbers;
}

/// Forces and moments on bodies, and with @p nodes those on nodes.
Numbers forces_of(const dynamics::System &system, const bool nodes)
{
  Numbers numbers;
  append(numbers, system.world.force);
  append(numbers, system.world.moment);
  for (unsigned int g = 0; nodes && g < system.world.n_nodal_groups(); ++g)
    append(numbers, system.world.copies[g].force);
  return numbers;
}

Numbers energies_of(const dynamics::System &system)
{
  const Ledger &ledger = system.world.ledger;
  Numbers       numbers;
  for (double Ledger::*term : Ledger::added)
    numbers.push_back(ledger.*term);
  numbers.insert(numbers.end(), {ledger.drive_work, ledger.resisting_work});
  return numbers;
}

/// Whether @p numbers are as many as @p others and all equal: none is NaN.
bool same(const Numbers &numbers, const Numbers &others)
{
  return !numbers.empty() && numbers == others;
}

void check(const std::string &name, const scene::Scene &scene, const double step_factor)
{
  dynamics::System through(scene, false), other(scene, false);
  const double     dt = step_factor * through.critical_time_step();

  const Numbers at_start = motion_of(other), energies = energies_of(other),
                forces = forces_of(other, true);
  other.evaluate_forces();
  verdict(name + ", at the start: nothing moves", same(motion_of(other), at_start));
  verdict("  the same forces again", same(forces_of(other, true), forces));
  verdict("  the same energies", same(energies_of(other), energies));

  constexpr unsigned int n = 60;
  for (unsigned int i = 1; i <= n; ++i)
    for (dynamics::System *system : {&through, &other})
      system->advance(dt, i * dt);
  verdict("  goes on as if it had not been",
          same(motion_of(other), motion_of(through)) &&
              same(energies_of(other), energies_of(through)));

  const double time = (n + 1) * dt;
  const Step   step = other.make_step(dt, time);
  dynamics::first_half(other.world, step);
  const Numbers between = motion_of(other);
  other.evaluate_forces(dt);
  verdict(name + ", within a step: nothing moves", same(motion_of(other), between));
  const Numbers found = forces_of(other, false);
  verdict("  something pulls", *std::max_element(found.begin(), found.end()) > 1.);
  for (ElasticGroup *group : other.world.groups.elastic())
    group->use_forces(other.world, step);
  dynamics::second_half(other.world, step);
  other.world.update_bodies();
  through.advance(dt, time);
  verdict("  forces on bodies are those of the step", same(found, forces_of(through, false)));
  Numbers velocities, of_step; // of what was kicked with them
  for (const auto &[system, into] :
       {std::make_pair(&other, &velocities), std::make_pair(&through, &of_step)})
    {
      append(*into, system->world.velocity);
      for (unsigned int g = 0; g < system->world.n_nodal_groups(); ++g)
        append(*into, system->world.copies[g].velocity);
      for (const ModalGroup *group : system->world.groups.modal())
        into->push_back(group->modal_energy(system->world));
    }
  // centres of mass are those of nodes: booked before their kick or with half of it
  for (unsigned int b = 0; b < other.world.n_bodies(); ++b)
    for (unsigned int d = 0; d < 3 && other.world.is_nodal(b); ++d)
      velocities[3 * b + d] = of_step[3 * b + d];
  verdict("  and so are those on nodes and modes", same(velocities, of_step));

  if (other.world.n_nodal_groups() > 0)
    return; // its nodes are a step ahead
  through.evaluate_forces();
  const Numbers first = forces_of(through, true), at_rest = energies_of(through),
                moved = motion_of(through);
  through.evaluate_forces();
  verdict(name + ", after a step: nothing moves", same(motion_of(through), moved));
  verdict("  the same forces again", same(forces_of(through, true), first));
  verdict("  the same energies", same(energies_of(through), at_rest));
}
} // namespace

int main()
{
  Parameters parameters;
  parameters.drive.n_links                  = 22;
  parameters.drive.sprockets.driver().teeth = parameters.drive.sprockets.driven().teeth = 9;
  parameters.drive.layout.slack                                                         = 1e-4;
  parameters.model.driven_inertia                                                       = 1e-4;
  parameters.loads.resisting_torque                                                     = 20.;
  parameters.loads.ramp_time                                                            = 1e-6;
  const auto build = [&] { return scene_of(parameters); };
  check("simple", build(), 0.25);
  parameters.model.fidelity = "layered";
  check("layered", build(), 0.25);
  parameters.model.fidelity = "full";
  check("full", build(), 0.9);
  parameters.model.half = parameters::SymmetryModel::yes;
  check("half", build(), 0.9);
  scene::Scene reduced = build();
  reduce(reduced);
  check("half, reduced", reduced, 0.9);
}
