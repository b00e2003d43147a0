// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/chain.h>
#include <chaindrive/drive/layout.h>
#include <chaindrive/drive/tooth_form.h>
#include <chaindrive/path/curve.h>

#include <vector>

namespace chaindrive::drive
{
/// A guide that stands still beside a span.
struct Guide
{
  unsigned int span;
  path::Curve  curve;     ///< with its material on the side on which the chain is not
  double       friction;  ///< of plates on it
  double       stiffness; ///< under the plates of one joint, N/m
};

/// The guides of @p drive beside the chain of @p layout.
/// @param forms  of all sprockets
/// @throws InputError for one through which the chain runs at the start, that passes through a
/// sprocket within its root circle, for points that make no line, and where links are of finite
/// elements, @p has_nodes, which a guide would have to press one by one.
std::vector<Guide> make_guides(const parameters::Drive      &drive,
                               const ChainDimensions        &chain,
                               const std::vector<ToothForm> &forms,
                               const Layout                 &layout,
                               bool                          has_nodes);
} // namespace chaindrive::drive
