// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/world.h>
#include <chaindrive/element/reference.h>
#include <chaindrive/utilities/timing.h>

#include <deal.II/base/aligned_vector.h>

#include <memory>
#include <string>
#include <vector>

namespace chaindrive::element
{
/// All elastic bodies: internal forces, and their own half of the time integration, batch by batch
/// while its numbers are in the cache.
///
/// Leapfrog, the same scheme as dynamics/newmark.h in its one-pass form: with the forces of the
/// instant n, v_{n+1/2} = v_{n-1/2} + dt a_n and x_{n+1} = x_n + dt v_{n+1/2} follow at once.
/// Between two steps World's copies therefore hold the positions of the *next* instant and the
/// velocities half a step before it; frames, energies and the ledger belong to the present one.
class Elastic
{
public:
  Elastic(const scene::Scene &scene, const World &world);

  bool empty() const { return references_.empty(); }

  /// What moves the nodes besides contact forces and their own stiffness.
  struct Step
  {
    double dt;      ///< s
    double gravity; ///< along -y, m/s2
    double drag;    ///< 1/s
  };

  /// Brings positions and velocities from the start, where both belong to the same instant, to
  /// where advance() expects them: half a kick, a whole drift. Contact forces, and all forces on
  /// rims, are those in @p world.
  void start(World &world, const Step &step, PhaseTimer &timer);

  /// Adds the internal forces of rims to the forces in @p world, and books their energies and what
  /// they do to the hubs. To be followed by BodyBatches::send_forces(): those on nodes between two
  /// sectors travel together with those of contacts.
  void add_rim_forces(World &world, PhaseTimer &timer) const;

  /// Adds the internal forces of all other bodies to the contact forces in @p world, moves all
  /// nodes by one step, and books energies, centres of mass and their velocities at the present
  /// instant. With dt = 0 nothing moves.
  void advance(World &world, const Step &step, PhaseTimer &timer);

  /// Places what hubs hold of elastic rims where the hubs are now; call it once they have moved.
  static void follow_hubs(World &world);

  /// Makes the row of the internal forces in @p timer; call it once, before the others.
  void add_phase(PhaseTimer &timer) { internal_force_ = timer.add("Internal force"); }

  /// Position, and displacement since the start [m], at the present instant.
  dealii::Tensor<1, 3>
  position(const World &world, const World::Address &place, unsigned int node) const;
  dealii::Tensor<1, 3>
  displacement(const World &world, const World::Address &place, unsigned int node) const;

  /// Name and stable step [s] of each part alone, without contacts.
  struct Limit
  {
    std::string part;
    double      step;
  };
  const std::vector<Limit> &limits() const { return limits_; }

  const Reference &reference(const unsigned int group) const { return *references_[group]; }

  void serialize(const Archive &archive) { archive("drift", drift_); }

  std::size_t memory_consumption() const;

private:
  /// Sums over the nodes of one batch, [lane] each.
  struct Sums
  {
    double strain[n_lanes], hourglass[n_lanes], kinetic[n_lanes], first_moment[3 * n_lanes],
        momentum[3 * n_lanes];
  };

  void move(World &world, const Step &step, double kick, bool booked, PhaseTimer &timer);

  /// The same for the sectors of a rim, on which all forces are there. Gravity and drag act on no
  /// sprocket.
  void move(World &world, Rim &rim, const Step &step, double kick, bool booked) const;

  /// Adds the internal forces of one batch to those of contacts.
  void add_forces(BodyBatches     &copies,
                  const Reference &reference,
                  unsigned int     batch,
                  Sums            &sums,
                  PhaseTimer      &timer) const;

  /// Takes the forces along z from the nodes of a half part that stay in its middle plane.
  static void hold_middle_plane(BodyBatches &copies, unsigned int batch);

  /// Moves one batch by its forces, which become zero.
  void
  update(BodyBatches &copies, unsigned int batch, Sums &sums, const Step &step, double kick) const;

  void book(World             &world,
            const BodyBatches &copies,
            unsigned int       batch,
            const Sums        &sums,
            const Step        &step);

  std::vector<std::unique_ptr<Reference>> references_; ///< per elastic group of copies
  std::vector<Limit>                      limits_;
  const Kernels                          &kernels_;
  double                                  drift_          = 0.; ///< of the last move, s
  PhaseTimer::Phase                       internal_force_ = PhaseTimer::rest;
};
} // namespace chaindrive::element
