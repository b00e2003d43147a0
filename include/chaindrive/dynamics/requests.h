// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/array_view.h>

#include <array>

namespace chaindrive::dynamics
{
/// What one rank can ask of all.
enum class Request : unsigned int
{
  checkpoint, ///< that one is written
  stop,       ///< that the run ends
  alarm       ///< that all look at something wrong that only this rank can see
};

/// What ranks ask of each other at no cost: their requests travel with the sum that they form in
/// every step anyway, so that all know them one step later. Nothing in the motion depends on them.
class Requests
{
public:
  /// This rank asks in the next step.
  void ask(const Request request) { asks_[index(request)] = 1.; }

  /// Whether some rank has asked before the last step.
  bool asked(const Request request) const { return asked_[index(request)] > 0.; }

  /// What the ranks sum up in a step; conclude() then takes these sums for what has been asked, and
  /// no rank asks anything.
  dealii::ArrayView<double> asks() { return {asks_.data(), asks_.size()}; }
  void                      conclude()
  {
    asked_ = asks_;
    asks_.fill(0.);
  }

private:
  static constexpr unsigned int index(const Request request)
  {
    return static_cast<unsigned int>(request);
  }

  using Numbers = std::array<double, 3>;
  Numbers asks_{}, asked_{};
};
} // namespace chaindrive::dynamics
