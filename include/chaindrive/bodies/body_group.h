// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/element/element_block.h>
#include <chaindrive/utilities/archive.h>
#include <chaindrive/utilities/timing.h>

#include <deal.II/base/array_view.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>
#include <deal.II/lac/full_matrix.h>

#include <limits>
#include <memory>
#include <optional>
#include <vector>

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

  /// Motion of the prescribed hub.
  struct Program
  {
    double angle;      ///< at the end of the step, rad
    double mean_speed; ///< in its middle, rad/s
    double speed;      ///< at its end, rad/s
  };
  std::optional<Program> program; ///< without one it goes on as it moves

  /// Otherwise BodyGroup::advance() and advance_shared() complete the forces and move nothing.
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
class BodyGroup
{
public:
  static constexpr unsigned int none = static_cast<unsigned int>(-1);

  virtual ~BodyGroup() = default;

  /// Brings what is to be a step ahead, or half a step behind, from the start to where advance()
  /// expects it. The forces of the start are in @p world, and complete on nodes. Called once.
  virtual void start(World & /*world*/, const Step & /*step*/, const ForceTimer & /*timer*/) {}

  /// Newmark's kick: adds @p h [s] times the acceleration of the forces in @p world to velocities.
  virtual void kick(World & /*world*/, double /*h*/) {}

  /// Moves by a step with the velocities in its middle. Frames then hold positions at its end and
  /// those velocities. What follows another body is placed.
  virtual void drift(World & /*world*/, const Step & /*step*/) {}

  /// Adds forces that must be there before those of contacts are. To be followed by
  /// NodeExchange::send_forces(), with which they travel to other ranks.
  virtual void add_forces(World & /*world*/, const ForceTimer & /*timer*/) {}

  /// Places the nodes that contacts see, if they are not there anyway. Their velocities belong to
  /// the instant @p earlier [s] before now, as in World::velocity_at().
  virtual void place_surface(World & /*world*/, double /*earlier*/) {}

  /// Takes the forces on those nodes to where the group needs them.
  virtual void gather_forces(World & /*world*/) {}

  /// For groups that move in one pass, while the numbers of a batch are in the cache: adds internal
  /// forces, kicks by a whole step, drifts, and books energies and momenta of the present instant
  /// and its centres of mass. With Step::moves false nothing moves, and the forces, now complete,
  /// stay on the nodes.
  virtual void advance(World & /*world*/, const Step & /*step*/, const ForceTimer & /*timer*/) {}

  /// The kick of advance() by the forces of an evaluation in which nothing moved: those on nodes
  /// become zero. Positions stay.
  virtual void use_forces(World & /*world*/, const Step & /*step*/) {}

  /// Forces on what all ranks move alike: each rank adds its own until World::sum_over_ranks()
  /// makes them the forces of all. The same numbers on each rank.
  virtual std::vector<dealii::ArrayView<double>> shared_forces(const World & /*world*/)
  {
    return {};
  }

  /// advance() of that, when these sums are there. Energies are booked on each rank, those of whole
  /// bodies.
  virtual void advance_shared(World & /*world*/, const Step & /*step*/) {}

  /// Frames take the velocities at the end of the step, after the second kick.
  virtual void finish(World & /*world*/, const Step & /*step*/) {}

  /// Kinetic energy [J] from the present velocities, if advance() has not booked it.
  virtual double kinetic_energy(const World & /*world*/) const { return 0.; }

  /// In World::copies, if its bodies have nodes that vibrate.
  virtual unsigned int elastic_copies() const { return none; }

  /// Kinetic energy [J] of shapes that this rank owns at the last advance(); shapes come to rest;
  /// and they take the amplitudes of another group of the same bodies, at rest.
  virtual double shape_energy(const World & /*world*/) const { return 0.; }
  virtual void   rest() {}

  /// The rates of the shapes of a copy are multiplied by @p share, on all ranks alike.
  virtual void slow_shapes(const World & /*world*/, unsigned int /*copy*/, double /*share*/) {}
  virtual void take_shapes(const BodyGroup & /*other*/) {}

  /// Stable step [s] of such bodies without contacts.
  virtual double stable_step() const { return std::numeric_limits<double>::infinity(); }

  /// Largest natural frequency [rad/s] of such a body when @p springs [N/m] hold each node, if it
  /// moves by nodes.
  virtual double largest_frequency(const std::vector<double> & /*springs*/) const { return 0.; }

  /// Of bodies that move by shapes: squared frequencies as a matrix in terms of rigid motions and
  /// shapes of unit mass when @p springs [N/m, body axes] hold the nodes, 1/s2. Empty for others.
  virtual dealii::FullMatrix<double>
  matrix_of_shapes(const std::vector<dealii::SymmetricTensor<2, 3>> & /*springs*/) const
  {
    return dealii::FullMatrix<double>();
  }

  /// How such bodies move @p node by unit amplitudes of their shapes and rigid motions, in the
  /// order of matrix_of_shapes(), body axes, 1/sqrt(kg). Empty for others.
  virtual std::vector<dealii::Tensor<1, 3>> motions_of(unsigned int /*node*/) const { return {}; }

  /// How many shapes such bodies have beside rigid motions.
  virtual unsigned int n_shapes() const { return 0; }

  /// The present amplitudes of the shapes of a copy of this rank, m sqrt(kg), in that order. Empty
  /// for others.
  virtual std::vector<double> amplitudes_of(const World & /*world*/, unsigned int /*copy*/) const
  {
    return {};
  }

  /// Where a node of a copy of this rank is now, m, and its velocity, m/s; of nodes that move by
  /// themselves, half a step before.
  virtual dealii::Tensor<1, 3>
  position_now(const World &world, unsigned int copy, unsigned int node) const;
  virtual dealii::Tensor<1, 3>
  velocity_now(const World &world, unsigned int copy, unsigned int node) const;

  /// Both of all nodes of a copy at once.
  virtual void nodes_now(const World                       &world,
                         unsigned int                       copy,
                         std::vector<dealii::Tensor<1, 3>> &position,
                         std::vector<dealii::Tensor<1, 3>> &velocity) const;

  /// What finds stresses in the cells of its part; empty for rigid bodies.
  virtual std::vector<std::unique_ptr<const element::StressRecovery>>
  stress_recoveries(const World & /*world*/) const
  {
    return {};
  }

  /// The state between two steps that is not in World.
  virtual void serialize(const Archive & /*archive*/, const World & /*world*/) {}

  /// Bytes, without what World holds.
  virtual std::size_t memory_consumption() const { return 0; }
};
} // namespace chaindrive
