// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/body_batches.h>
#include <chaindrive/bodies/elastic_group.h>
#include <chaindrive/element/elastic_part.h>
#include <chaindrive/element/kernels.h>

#include <array>
#include <vector>

namespace chaindrive
{
/// The elastic bodies of one part: internal forces and the time integration, batch by batch while
/// its numbers are in the cache.
///
/// Leapfrog, the scheme of RigidBodies in its one-pass form: with the forces of the instant n,
/// v_{n+1/2} = v_{n-1/2} + dt a_n and x_{n+1} = x_n + dt v_{n+1/2} follow at once.
/// Between two steps the nodes are therefore where they will be at the *next* instant,
/// BodyBatches::ahead after the present one, with the velocities between the two; frames, energies
/// and the ledger belong to the present.
class ElasticBodies : public NodalGroup
{
public:
  /// Moves the nodes of @p world's copies number @p group.
  ElasticBodies(const scene::Scene &scene, const World &world, unsigned int group);

  void start(World &world, const Step &step, const ForceTimer &timer) override;
  void advance(World &world, const Step &step, const ForceTimer &timer) override;
  void use_forces(World &world, const Step &step) override;

  double critical_time_step() const override { return critical_time_step_; }
  double largest_frequency(const std::vector<double> &springs) const override
  {
    return part_.largest_frequency(springs);
  }

  dealii::Tensor<1, 3>
  position_now(const World &world, unsigned int copy, unsigned int node) const override;
  dealii::Tensor<1, 3>
       velocity_now(const World &world, unsigned int copy, unsigned int node) const override;
  void nodes_now(const World                       &world,
                 unsigned int                       copy,
                 std::vector<dealii::Tensor<1, 3>> &position,
                 std::vector<dealii::Tensor<1, 3>> &velocity) const override;
  std::vector<std::unique_ptr<const element::StressRecovery>>
  stress_recoveries(const World &world) const override;

  void        serialize(const Archive &archive, World &world) override;
  std::size_t memory_consumption() const override { return part_.memory_consumption(); }

protected:
  using Sums = element::BatchSums;

  /// Adds the internal forces of one batch to those of contacts, and takes those along z from the
  /// nodes of a half part that stay in its middle plane.
  void add_internal_forces(BodyBatches      &copies,
                           unsigned int      batch,
                           Sums             &sums,
                           const ForceTimer &timer) const;

  /// Moves one batch by its forces, which become zero: v += @p kick a, x += dt v. With Step::moves
  /// false all stays, forces too. Sums belong to the instant of the forces.
  void
  update(BodyBatches &copies, unsigned int batch, Sums &sums, const Step &step, double kick) const;

  /// Moves all batches of this rank by complete forces.
  void move(World &world, const Step &step, double kick) const;

private:
  void book(World             &world,
            const BodyBatches &copies,
            unsigned int       batch,
            const Sums        &sums,
            const Step        &step) const;

  /// Gives the @p frame of a link whose bushes meet teeth the direction of the line between them
  /// and its angular velocity; of other bodies frames do not turn.
  void turn(const World &world, const BodyBatches &copies, unsigned int copy, Frame &frame) const;

  element::ElasticPart                     part_;
  Material                                 material_;
  double                                   critical_time_step_; ///< s
  const element::Kernels                  &kernels_;
  std::array<std::vector<unsigned int>, 2> bushes_; ///< nodes of both, of links whose frames turn
};
} // namespace chaindrive
