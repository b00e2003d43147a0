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
/// A sprocket of the drive.
struct Sprocket
{
  parameters::Role role;
  ToothForm        form;
  double           bore;         ///< diameter
  double           hub_diameter; ///< of the rigid zone
  MassProperties   solid;
  std::string      mesh; ///< a Gmsh file that takes the place of the form; empty: none
};

/// The geometry of a whole drive with what follows from it. SI units.
struct Drive
{
  ChainDimensions       chain;
  std::vector<Sprocket> sprockets; ///< in the order in which the chain runs over them
  double                sprocket_width;
  Layout                layout;

  MassProperties roller_solid, inner_link_solid, outer_link_solid;
  double         mass_per_pitch; ///< of the solids: a roller and half of either link, kg

  double stiffness_per_pitch;    ///< of the chain, given or estimated, N/m
  double roller_tooth_stiffness; ///< estimate, N/m
  double roller_bush_stiffness;  ///< estimate at the nominal tight tension, N/m
  double reference_load;         ///< at which they are estimated, N
  double nominal_tension;        ///< of the tight span: resisting torque / driven pitch radius, N

  std::vector<std::string> notes; ///< sentences for the log: choices made and values derived

  const Sprocket &with(parameters::Role role) const;
};

/// @throws InputError as make_chain(), make_tooth_form() and make_layout() do, and for a bore, hub
/// or width that does not fit the sprocket.
Drive make_drive(const Parameters &parameters);
} // namespace chaindrive::drive
