// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/chain.h>
#include <chaindrive/drive/layout.h>
#include <chaindrive/drive/solids.h>
#include <chaindrive/drive/tooth_form.h>
#include <chaindrive/parameters/parameters.h>

#include <string>
#include <vector>

namespace chaindrive::drive
{
/// The geometry of a whole drive with what follows from it. SI units.
struct Drive
{
  ChainDimensions chain;
  ToothForm       driver, driven;
  double          sprocket_width;
  double          driver_bore, driven_bore;                 ///< diameters
  double          driver_hub_diameter, driven_hub_diameter; ///< of the rigid zones
  Layout          layout;

  MassProperties roller_solid, inner_link_solid, outer_link_solid;
  MassProperties driver_solid, driven_solid;
  double         mass_per_pitch; ///< of the solids: a roller and half of either link, kg

  double stiffness_per_pitch;    ///< of the chain, given or estimated, N/m
  double roller_tooth_stiffness; ///< estimate, N/m
  double roller_bush_stiffness;  ///< estimate at the nominal tight tension, N/m
  double nominal_tension;        ///< of the tight span: resisting torque / driven pitch radius, N

  std::vector<std::string> notes; ///< sentences for the log: choices made and values derived
};

/// @throws InputError as make_chain(), make_tooth_form() and make_layout() do, and for a bore, hub
/// or width that does not fit the sprocket.
Drive make_drive(const Parameters &parameters);
} // namespace chaindrive::drive
