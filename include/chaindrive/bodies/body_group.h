// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/utilities/archive.h>
#include <chaindrive/utilities/timing.h>

#include <cstddef>
#include <optional>

namespace chaindrive
{
class World;

/// One step of time and what moves bodies in it besides forces that somebody adds.
struct Step
{
  double dt      = 0.; ///< s
  double time    = 0.; ///< at its end, s
  double gravity = 0.; ///< along -y, m/s2, on nodes of elastic bodies
  double drag    = 0.; ///< 1/s, likewise

  /// Motion of a prescribed hub.
  struct Program
  {
    double angle;      ///< at the end of the step, rad
    double mean_speed; ///< in its middle, rad/s
    double speed;      ///< at its end, rad/s
  };
  const Program *programs = nullptr; ///< of each of World::hubs; null: they go on as they move

  /// Otherwise ElasticGroup::advance() and SharedGroup::advance_shared() complete the forces and
  /// move nothing.
  bool moves = true;
};

/// Where the time for internal forces is counted.
struct ForceTimer
{
  PhaseTimer       &timer;
  PhaseTimer::Phase phase;
};

/// How the bodies of one kind move. World holds what others read of all bodies: frames, velocities,
/// resultant forces, and the nodes that touch. A group turns forces into motion; it may hold state
/// of its own, such as modes, and lists that in serialize(). The calls of one step, in their order,
/// are in dynamics/system.cc; they are virtual per group, never per body or node.
///
/// These are the calls that every group gets in a step; one that has nothing to do then leaves it.
/// What only some groups can do is an interface of its own, which they implement besides:
/// ForceGroup and SurfaceGroup below, ElasticGroup, NodalGroup, ModalGroup and SharedGroup in
/// elastic_group.h.
/// BodyGroups lists the groups under each of them.
class BodyGroup
{
public:
  virtual ~BodyGroup() = default;

  /// Newmark's kick: adds @p h [s] times the acceleration of the forces in @p world to velocities.
  virtual void kick(World & /*world*/, double /*h*/) {}

  /// Moves by a step with the velocities in its middle. Frames then hold positions at its end and
  /// those velocities. What follows another body is placed.
  virtual void drift(World & /*world*/, const Step & /*step*/) {}

  /// Frames take the velocities at the end of the step, after the second kick.
  virtual void finish(World & /*world*/, const Step & /*step*/) {}

  /// Kinetic energy [J] from the present velocities, if nothing has booked it before: see
  /// ElasticGroup::advance().
  virtual double kinetic_energy(const World & /*world*/) const { return 0.; }

  /// The state between two steps that World does not list.
  virtual void serialize(const Archive & /*archive*/, World & /*world*/) {}

  /// Bytes, without what World holds.
  virtual std::size_t memory_consumption() const { return 0; }
};

/// A group with forces of its own that must be there before those of contacts are: on nodes that
/// bodies of other ranks share, or on bodies of other groups.
class ForceGroup
{
public:
  virtual ~ForceGroup() = default;

  /// Adds these forces and books their energies. To be followed by NodeExchange::send_forces(),
  /// with which those on nodes travel to other ranks.
  virtual void add_forces(World &world, const ForceTimer &timer) = 0;
};

/// A group with nodes that touch but do not move by themselves: they are placed for contacts, and
/// what contacts do to them is taken to what moves them.
class SurfaceGroup
{
public:
  virtual ~SurfaceGroup() = default;

  /// Places these nodes. Their velocities belong to the instant @p earlier [s] before now, as in
  /// World::velocity_at().
  virtual void place_surface(World &world, double earlier) = 0;

  /// Takes the forces on them, which become zero, to where the group needs them.
  virtual void gather_forces(World &world) = 0;
};
} // namespace chaindrive
