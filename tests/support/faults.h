// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Drives that run soundly until something is done to them.

#include "decided.h"

#include <chaindrive/drive/drive.h>
#include <chaindrive/dynamics/guard.h>
#include <chaindrive/dynamics/newmark.h>
#include <chaindrive/model/reading.h>
#include <chaindrive/utilities/ranks.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <iostream>
#include <memory>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace test
{
using namespace chaindrive;
using dynamics::System;
using Vector3 = dealii::Tensor<1, 3>;

/// The scene of a .prm file, relative to the repository.
inline scene::Scene drive_scene(const std::string &file, const std::vector<std::string> &overrides)
{
  const std::string repository = std::string(SOURCE_DIR) + "/../../";
  const Parameters  parameters = model::read_parameters(repository + file, overrides).parameters;
  return scene_of(parameters, {}, {repository});
}

inline void push(System &system, const unsigned int body, const Vector3 &force)
{
  for (unsigned int d = 0; d < 3; ++d)
    system.world.force.local_element(3 * body + d) += force[d];
}

/// Component @p d of the velocity of @p body, which moves freely, becomes @p v [m/s].
inline void
set_velocity(System &system, const unsigned int body, const unsigned int d, const double v)
{
  system.world.velocity.local_element(3 * body + d) = v;
  if (PlanarBodies *planar = system.world.planar)
    planar->slots().of(planar_velocity + d)[planar->slot_of(body)] = v;
}

/// Whether a message of the guard has the path of an entry in it.
inline bool names_an_entry(const std::string &message)
{
  static const std::regex path("(Time|Contact|Effects|Model|Elements)/[A-Z]");
  return std::regex_search(message, path);
}

/// Whether each place in a message of the guard is another.
inline bool places_differ(const std::string &message)
{
  const std::string     begin = "Where: ";
  const std::size_t     first = std::min(message.find(begin), message.size() - begin.size());
  const std::string     where = message.substr(first + begin.size());
  std::istringstream    list(where.substr(0, where.find(". ")));
  std::set<std::string> places;
  std::string           place;
  while (std::getline(list, place, ';'))
    {
      const std::size_t end = std::min(place.find(" overlaps"), place.find(": "));
      if (!places.insert(place.substr(place.find_first_not_of(' '), end)).second)
        return false;
    }
  return true;
}

/// The families of @p system that messages call @p name: of rigid bodies and of elastic ones.
inline std::vector<const contact::Family *> families_called(const std::string &name,
                                                            const System      &system)
{
  std::vector<const contact::Family *> found;
  for (const auto &family : system.contacts.families())
    if (family->name() == name)
      found.push_back(family);
  return found;
}

/// What is done to a system.
using Change = std::function<void(System &)>;

/// A drive with its guard after some sound steps.
class Drive
{
public:
  Drive(const scene::Scene &the_scene,
        const unsigned int  n_sound,
        const double        part_of_limit,
        const MPI_Comm      comm = MPI_COMM_SELF)
      : scene(the_scene)
      , system(scene, false, comm)
      , limit(system.critical_time_step())
      , guard(scene, system, 0.05, limit)
      , services(system)
      , dt(part_of_limit * limit)
  {
    for (unsigned int i = 0; i < n_sound; ++i)
      {
        system.advance_without_update(dt, system.world.time + dt); // as the time loop does
        guard.observe(system, ++step_, dt, services);
      }
  }

  /// The pair of the families called @p name with the largest force, and its family.
  std::pair<const contact::Family *, unsigned int> most_loaded(const std::string &name)
  {
    std::pair<const contact::Family *, unsigned int> found(nullptr, 0);
    double                                           largest = 0.;
    for (const contact::Family *family : families_called(name, system))
      for (unsigned int i = 0; i < family->records().size(); ++i)
        if (const double force = family->records()[i].force.norm(); force > largest)
          {
            largest = force;
            found   = {family, i};
          }
    return found;
  }

  /// System::advance() written out, with @p on_nodes before elastic bodies use up the forces on
  /// their nodes and @p on_bodies before the others do.
  void advance(const double h, const Change &on_nodes, const Change &on_bodies)
  {
    const Step step = system.make_step(h, system.world.time + h);
    dynamics::first_half(system.world, step);
    if (on_nodes)
      on_nodes(system);
    system.evaluate_and_move(h);
    PlanarBodies *planar = system.world.planar;
    if (planar != nullptr)
      planar->write_forces(system.world);
    if (on_bodies)
      on_bodies(system);
    if (planar != nullptr)
      planar->take_forces(system.world);
    dynamics::second_half(system.world, step);
    system.world.update_bodies();
    system.world.ledger.kinetic += system.world.kinetic_energy();
  }

  /// Goes on in steps @p times as large with what is wrong, for 100 steps at most. Prints whether
  /// the guard has stopped it, the same on all ranks, and whether its message has all the @p words.
  void expect_stop(const std::string              &fault,
                   const std::vector<std::string> &words,
                   const Change                   &on_bodies,
                   const Change                   &on_nodes = {},
                   const double                    times    = 1.)
  {
    std::string  message;
    double       valid_until = -1.;
    const double begin       = system.world.time;
    unsigned int n           = 0;
    for (n = 1; n <= 100 && message.empty(); ++n)
      try
        {
          if (on_nodes || on_bodies)
            advance(times * dt, on_nodes, on_bodies);
          else
            system.advance_without_update(times * dt, system.world.time + times * dt);
          guard.observe(system, ++step_, times * dt, services);
        }
      catch (const dynamics::Fault &stopped)
        {
          message     = stopped.what();
          valid_until = stopped.valid_until();
        }
    const MPI_Comm comm = system.world.communicator();
    bool           same = true;
    if (n_ranks_in(comm) > 1)
      for (const std::string &other : dealii::Utilities::MPI::all_gather(comm, message))
        same = same && other == message;
    if (rank_in(comm) != 0)
      return;
    // the digits depend on the machine
    std::ofstream("messages", std::ios::app) << fault << ", " << n - 1 << " steps:\n"
                                             << message << "\n\n";
    std::cout << fault << ": stopped within 100 steps: " << (message.empty() ? "NO" : "yes")
              << (same ? "" : ", NOT alike on all ranks") << '\n';
    for (const std::string &word : words)
      if (message.find(word) == std::string::npos)
        std::cout << "  does NOT say: " << word << '\n';
    if (!message.empty() && !names_an_entry(message))
      std::cout << "  names no entry that could be changed\n";
    if (!places_differ(message))
      std::cout << "  names a place twice\n";
    if (!(valid_until <= begin + 1e-12 && valid_until >= 0.))
      std::cout << "  holds a state after the fault for sound\n";
  }

  const scene::Scene scene;
  System             system;
  const double       limit; ///< critical time step, s
  dynamics::Guard    guard;
  dynamics::Services services;
  const double       dt; ///< s

private:
  unsigned long step_ = 0;
};
} // namespace test
