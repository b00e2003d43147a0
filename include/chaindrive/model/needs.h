// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/parameters/run.h>

#include <array>
#include <string>

namespace chaindrive::model
{
/// What of an elastic model the quantities of a group depend on. Effects that cost nothing, such as
/// friction, clearances or gravity, are not listed: all quantities feel them, and they are on
/// wherever they can act.
struct Needs
{
  parameters::QuantityGroup group;
  bool                      links, rollers, sprockets; ///< elastic ones
  bool                      both_halves;
  const char               *reason;
};

inline constexpr std::array<Needs, 10> all_needs{
    {{parameters::QuantityGroup::speeds,
      true,
      false,
      false,
      false,
      "the driven sprocket vibrates on the stiffness of the spans, which is that of the links"},
     {parameters::QuantityGroup::tensions,
      true,
      false,
      false,
      false,
      "spans are links in series; rollers and teeth are not in their load path"},
     {parameters::QuantityGroup::tooth_forces,
      true,
      true,
      true,
      false,
      "the load distribution over the teeth depends on the compliance of links, rollers and teeth"},
     {parameters::QuantityGroup::joint_forces,
      true,
      true,
      true,
      false,
      "a bush carries the force of the tooth on its roller"},
     {parameters::QuantityGroup::roller_motion,
      true,
      true,
      true,
      false,
      "the rebound of a roller depends on the compliance of roller and tooth"},
     {parameters::QuantityGroup::engagements,
      true,
      true,
      true,
      false,
      "the peak force of an impact grows with the square root of the stiffness of roller and "
      "tooth"},
     {parameters::QuantityGroup::surface_velocity,
      true,
      true,
      true,
      false,
      "the ring of a roller vibrates when it meets a tooth"},
     {parameters::QuantityGroup::plate_stress,
      true,
      false,
      false,
      false,
      "plates carry the tension and bend"},
     {parameters::QuantityGroup::energy,
      true,
      true,
      true,
      false,
      "each has its share of the strain energy"},
     {parameters::QuantityGroup::fields,
      true,
      true,
      true,
      true,
      "field output shows whole bodies and stresses"}}};

/// The table of what needs what, in Markdown.
std::string documentation_of_needs();
} // namespace chaindrive::model
