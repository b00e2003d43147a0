// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/parameters/drive.h>
#include <chaindrive/parameters/parameters.h>

#include <array>
#include <string>

namespace chaindrive::parameters
{
/// What of an elastic model the quantities of a group depend on. Effects that cost nothing, such as
/// friction, clearances or gravity, are not listed: all quantities feel them, and they are on
/// wherever they can act.
struct Needs
{
  QuantityGroup group;
  bool          links, rollers, sprockets; ///< elastic ones
  bool          both_halves;
  const char   *reason;
};

inline constexpr std::array<Needs, 10> all_needs{
    {{QuantityGroup::speeds,
      true,
      false,
      false,
      false,
      "the driven sprocket vibrates on the stiffness of the spans, which is that of the links"},
     {QuantityGroup::tensions,
      true,
      false,
      false,
      false,
      "spans are links in series; rollers and teeth are not in their load path"},
     {QuantityGroup::tooth_forces,
      true,
      true,
      true,
      false,
      "the load distribution over the teeth depends on the compliance of links, rollers and teeth"},
     {QuantityGroup::joint_forces,
      true,
      true,
      true,
      false,
      "a bush carries the force of the tooth on its roller"},
     {QuantityGroup::roller_motion,
      true,
      true,
      true,
      false,
      "the rebound of a roller depends on the compliance of roller and tooth"},
     {QuantityGroup::engagements,
      true,
      true,
      true,
      false,
      "the peak force of an impact grows with the square root of the stiffness of roller and "
      "tooth"},
     {QuantityGroup::surface_velocity,
      true,
      true,
      true,
      false,
      "the ring of a roller vibrates when it meets a tooth"},
     {QuantityGroup::plate_stress, true, false, false, false, "plates carry the tension and bend"},
     {QuantityGroup::energy, true, true, true, false, "each has its share of the strain energy"},
     {QuantityGroup::fields,
      true,
      true,
      true,
      true,
      "field output shows whole bodies and stresses"}}};

/// Something that is decided from the entries before anything is built.
struct Decision
{
  bool        on;
  std::string reason; ///< a phrase: why
};

/// Whether inner and outer links, rollers, and the rim of a sprocket of the drive are elastic.
Decision elastic_links(const Parameters &p);
Decision elastic_rollers(const Parameters &p);
Decision elastic_sprocket(const Parameters &p, const Sprocket &sprocket);

/// Whether rigid sprockets give way under elastic rollers.
Decision tooth_compliance(const Parameters &p);

/// Whether only the halves of bodies at z >= 0 are computed.
Decision half_model(const Parameters &p);

/// Whether plates bend out of their planes, and whether their faces touch.
Decision plate_bending(const Parameters &p);
Decision plate_faces(const Parameters &p);

/// Whether rollers and links of the chain, or those that do not arrive, move by few shapes.
Decision reduced_bodies(const Parameters &p);

/// Whether the walls of elastic rollers have more mass for what moves against each other in them.
Decision column_mass_scaling(const Parameters &p);

/// Time between two pictures, s; 0: none. auto is a tenth of the pitch time of the driver, or a
/// millisecond of one that stands still.
double field_interval(const Parameters &p);

/// Whether fields are written.
Decision fields(const Parameters &p);

/// Whether stresses are found from the deformation of elastic bodies.
Decision stress_recovery(const Parameters &p);

/// Whether the cylinders of a joint have play. @p choice is the entry of section Effects.
Decision clearance(const Parameters &p, Switch choice);

/// The table of what needs what, in Markdown.
std::string documentation_of_needs();
} // namespace chaindrive::parameters
