// SPDX-License-Identifier: LGPL-2.1-or-later
// The state of a system goes through an archive in the middle of a run, and a new system goes on
// from there: the motion, the energies and the searches are bit by bit those of the run that went
// on, for each fidelity. One written by two ranks and read by one: tests/runs/resume.py.
#include "../support/archive.h"
#include "../support/decided.h"
#include "../support/reduced.h"

#include <chaindrive/utilities/archive.h>
#include <chaindrive/utilities/errors.h>

#include <map>
#include <optional>

using namespace test;

/// Every number that moves: of the world, of nodes, of the ledger.
std::vector<double> numbers_of(const dynamics::System &system)
{
  const World        &world = system.world;
  std::vector<double> numbers;
  for (const World::Vector *vector : {&world.displacement, &world.velocity, &world.force})
    numbers.insert(numbers.end(), vector->begin(), vector->end());
  for (const World::Rotation &r : world.rotations)
    numbers.insert(
        numbers.end(),
        {r.orientation.w, r.orientation.x, r.orientation.y, r.orientation.z, r.momentum[2]});
  for (const World::Hub &hub : world.hubs)
    numbers.insert(numbers.end(), {hub.angle, hub.speed});
  for (unsigned int g = 0; g < world.n_elastic_groups(); ++g)
    for (const World::Vector *vector : {&world.copies[g].position, &world.copies[g].velocity})
      numbers.insert(
          numbers.end(), vector->begin(), vector->begin() + vector->locally_owned_size());
  for (double Ledger::*term : Ledger::added)
    numbers.push_back(world.ledger.*term);
  numbers.insert(numbers.end(), {world.ledger.drive_work, world.ledger.resisting_work, world.time});
  numbers.push_back(double(system.contacts.search_statistics().searches));
  return numbers;
}

void compare(const std::string &name, const scene::Scene &scene, const double step_factor)
{
  constexpr unsigned int half = 150;
  dynamics::System       through(scene, false);
  const double           dt = step_factor * through.critical_time_step();
  Items                  items;
  for (unsigned int i = 1; i <= 2 * half; ++i)
    {
      through.advance(dt, i * dt);
      if (i == half)
        through.serialize(writer(items));
    }

  dynamics::System resumed(scene, false);
  resumed.serialize(reader(items));
  const std::vector<double> middle = numbers_of(resumed);
  for (unsigned int i = half + 1; i <= 2 * half; ++i)
    resumed.advance(dt, i * dt);

  verdict(name + ", it moved in the second half", numbers_of(through) != middle);
  verdict(name + ", contacts had something to remember", through.world.ledger.friction != 0.);
  verdict(name + ", resumed as if nothing had been, bit by bit",
          numbers_of(through) == numbers_of(resumed));

  const auto refused = [&] {
    try
      {
        dynamics::System(scene, false).serialize(reader(items));
      }
    catch (const InputError &error)
      {
        std::cout << name << ": " << error.what() << '\n';
      }
  };
  items["world/displacement"].resize(8);
  refused();
  items.erase("world/displacement");
  refused();
}

int main()
{
  Parameters parameters;
  parameters.drive.n_links                  = 22;
  parameters.drive.sprockets.driver().teeth = parameters.drive.sprockets.driven().teeth = 9;
  parameters.drive.layout.slack                                                         = 1e-4;
  parameters.model.driven_inertia                                                       = 1e-4;
  parameters.loads.resisting_torque                                                     = 20.;
  const auto build              = [&] { return scene_of(parameters); };
  parameters.drive.layout.start = parameters::Start::settled;
  compare("simple", build(), 0.25);
  parameters.model.fidelity = "layered";
  compare("layered", build(), 0.25);

  // from rest to full speed within some steps
  parameters.drive.layout.start = parameters::Start::taut;
  parameters.loads.ramp_time    = 1e-6;
  parameters.model.fidelity     = "full";
  compare("full", build(), 0.9);
  parameters.model.half = parameters::SymmetryModel::yes;
  compare("half", build(), 0.9);
  scene::Scene reduced = build();
  reduce(reduced);
  compare("half, reduced", reduced, 0.9);
}
