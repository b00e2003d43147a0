// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/world.h>
#include <chaindrive/contact/contacts.h>
#include <chaindrive/dynamics/requests.h>
#include <chaindrive/forces/bars.h>
#include <chaindrive/load/loads.h>
#include <chaindrive/stability/step_limit.h>
#include <chaindrive/utilities/timing.h>

#include <vector>

namespace chaindrive::dynamics
{
/// Everything that moves and everything that pulls: evaluates the forces, and makes steps in which
/// what moves does so while its forces are found.
class System
{
public:
  /// Builds the state and its forces from @p scene, distributed over the ranks of @p comm; refuses
  /// initial penetration (InputError).
  System(const scene::Scene &scene, bool search_every_step, MPI_Comm comm = MPI_COMM_SELF);

  /// Evaluates all forces at the present state and moves nothing: on bodies, on nodes of elastic
  /// ones, and the accelerations of modes. Energies and centres of mass are those of the present
  /// positions and velocities. @p dt is the time since the last evaluation [s], in which contacts
  /// slide and dampers lose energy; with 0 nothing is lost and the same forces come out again.
  /// Nodes must be where the frames are: at the start, and after first_half(). Collective.
  void evaluate_forces(double dt = 0.);

  /// The same between the halves of a step @p dt [s], and what moves by nodes or modes moves on
  /// with its forces while its numbers are in the cache (see system.cc). Collective.
  void evaluate_and_move(double dt);

  /// One Newmark step of @p dt to the time @p new_time.
  void advance(double dt, double new_time);

  /// The same, but World::update_bodies() is left to those who read frames and the like.
  void advance_without_update(double dt, double new_time);

  /// The step that advance() makes; valid until the next call.
  Step make_step(double dt, double new_time);

  /// The limit of the step from each kind of spring alone, and that of all together [s], see
  /// stability/step_limit.h.
  std::vector<stability::TimeStepLimit> step_limits() const;
  double                                critical_time_step() const;

  /// The state between two steps, at least one after the start. Collective.
  void serialize(const Archive &archive);

  std::size_t memory_consumption() const;

  World             world;
  Bars              bars;
  ForceElements     forces; ///< others than bars, in the scene's order
  contact::Contacts contacts;
  load::Loads       loads;
  Requests          requests; ///< of ranks to each other, see Services
  PhaseTimer        timer;    ///< loads count as time integration

private:
  /// One evaluation of all forces, in which bodies move if @p step says so.
  void evaluate(const Step &step);

  /// Books the kinetic energy of rigid and lumped bodies at full steps.
  void close_ledger();

  std::vector<Step::Program> programs_;          ///< of each hub, of the last step made
  bool                       publishes_ = false; ///< frames of PlanarBodies in each evaluation
  bool                       started_   = false; ///< NodalGroup::start() has been called
  bool                       forces_on_nodes_ = false; ///< from evaluate_forces(), not used up yet

  PhaseTimer::Phase internal_force_ = PhaseTimer::rest, integration_ = PhaseTimer::rest,
                    contact_ = PhaseTimer::rest;
};
} // namespace chaindrive::dynamics
