// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/planar_bodies.h>
#include <chaindrive/forces/force_element.h>
#include <chaindrive/scene/interface.h>

#include <deal.II/base/aligned_vector.h>

#include <vector>

namespace chaindrive
{
/// Massless elastic bars with dashpots between the centres of two bodies:
///
///   tension F = k (l - l0) + c l',    l = |x_second - x_first|
class Bars : public ForceElement
{
public:
  explicit Bars(const std::vector<scene::Bar> &bars);

  std::unique_ptr<ForceElement> clone() const override { return std::make_unique<Bars>(*this); }
  std::string                   name() const override { return "bars"; }

  /// Books in Ledger::bar and Ledger::chain_damping.
  void add_forces(World &world, double dt) override;

  /// Whether add_forces() looks at frames: not where all bars are between PlanarBodies.
  bool reads_frames(const World &world) const;

  /// The bars along their present axes.
  void add_springs(const World &world, std::vector<Spring> &springs) const override;

  unsigned int                   size() const { return static_cast<unsigned int>(bars_.size()); }
  const std::vector<double>     &tension() const { return tension_; } ///< N, positive: pulled
  const std::vector<scene::Bar> &bars() const { return bars_; }

  void serialize(const Archive &archive) override;

  std::size_t memory_consumption() const
  {
    return size() * (sizeof(scene::Bar) + 3 * sizeof(double));
  }

private:
  /// Bars of which both slots of PlanarBodies grow by one from each to the next.
  struct Run
  {
    unsigned int                  first, second; ///< slots of the first one
    unsigned int                  begin, n;      ///< bars
    dealii::AlignedVector<double> numbers;       ///< [entry of PlanarBars][bar]
  };

  void add_in_plane(World &world, double dt);
  void make_runs(const PlanarBodies &bodies);

  std::vector<scene::Bar> bars_;
  std::vector<Run>        runs_;
  std::vector<double>     tension_;
  // at the last evaluation; of runs, when they were made or serialize() was called
  std::vector<double> length_;  ///< m
  std::vector<double> viscous_; ///< part of the tension, N
};
} // namespace chaindrive
