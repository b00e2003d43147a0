// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/scene/interface.h>
#include <chaindrive/world/spring.h>
#include <chaindrive/world/world.h>

#include <vector>

namespace chaindrive::element
{
/// Massless elastic bars with dashpots between the centres of two bodies:
///
///   tension F = k (l - l0) + c l',    l = |x_second - x_first|
class Bars
{
public:
  explicit Bars(const std::vector<scene::Bar> &bars);

  /// Adds the bars' forces and books their energy; @p dt is the time since the last call [s].
  void add_forces(World &world, double dt);

  /// The bars as springs along their present axes, for the stable step.
  void add_springs(const World &world, std::vector<Spring> &springs) const;

  unsigned int                   size() const { return static_cast<unsigned int>(bars_.size()); }
  const std::vector<double>     &tension() const { return tension_; } ///< N, positive: pulled
  const std::vector<scene::Bar> &bars() const { return bars_; }

  /// Largest absolute tension of each bar since clear_peaks(), N.
  const std::vector<double> &peak() const { return peak_; }
  void                       clear_peaks() { peak_.assign(size(), 0.); }

  void exchange(const Archive &archive);

  std::size_t memory_consumption() const
  {
    return size() * (sizeof(scene::Bar) + 4 * sizeof(double));
  }

private:
  std::vector<scene::Bar> bars_;
  std::vector<double>     tension_, peak_;
  std::vector<double>     length_;  ///< at the last evaluation, m
  std::vector<double>     viscous_; ///< part of the tension, at the last evaluation, N
};
} // namespace chaindrive::element
