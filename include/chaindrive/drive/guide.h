// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/chain.h>
#include <chaindrive/drive/layout.h>
#include <chaindrive/drive/rest.h>
#include <chaindrive/drive/tensioner.h>
#include <chaindrive/drive/tooth_form.h>
#include <chaindrive/parameters/fidelity.h>
#include <chaindrive/path/curve.h>

#include <optional>
#include <string>
#include <vector>

namespace chaindrive::drive
{
/// A guide beside a span.
struct Guide
{
  unsigned int span;
  path::Curve  curve; ///< with its material on the side on which the chain is not; without travel
  double       friction;  ///< of plates on it
  double       stiffness; ///< under the plates of one joint, N/m

  std::optional<Tensioner> held = {}; ///< what presses it against the chain; else it stands still

  /// Its line in the frame of what it is on: about the pivot of an arm, else the world's.
  path::Curve in_frame() const;

  /// Points of its line at its travel, @p per_piece in each of its pieces and the last one.
  std::vector<dealii::Point<2>> polyline(unsigned int per_piece) const;

  /// How it stands at its travel, as the tensioner of a wheel tells, with this @p slack in the
  /// chain of so many @p strands where it leans on its stop.
  std::string in_words(double slack, unsigned int strands) const;
};

/// The guides of @p drive that stand still beside the chain of @p layout.
/// @param forms  of all sprockets
/// @throws InputError for one through which the chain runs at the start, that passes through a
/// sprocket within its root circle, and for points that make no line.
std::vector<Guide> make_guides(const parameters::Drive      &drive,
                               const ChainDimensions        &chain,
                               const std::vector<ToothForm> &forms,
                               const Layout                 &layout);

/// The guide of @p drive that a spring presses against the slack span of @p layout, if there is
/// one, where it touches the chain as it is laid, or on its greatest stop.
/// @param gravity  that acts, m/s2
/// @throws InputError for one that a drive cannot have, whose points are not beside the straight
/// span, or that does not come to the chain.
std::optional<Guide> make_pressed_guide(const parameters::Drive      &drive,
                                        const ChainDimensions        &chain,
                                        const std::vector<ToothForm> &forms,
                                        const Layout                 &layout,
                                        double                        gravity);

/// The same for statics, which moves @p guide; it must live as long.
RestingGuide resting_guide(Guide &guide, const ChainDimensions &chain);

/// The tension of the span on which @p guide is at rest in @p layout, without friction, N: it
/// balances the spring with the pulls of the span's two ends. Nothing on a stop.
std::optional<double> tension_of(const Guide &guide, const Layout &layout);
} // namespace chaindrive::drive
