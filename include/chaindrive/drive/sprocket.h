// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/chain.h>
#include <chaindrive/drive/programs.h>
#include <chaindrive/drive/shaft.h>
#include <chaindrive/drive/solids.h>
#include <chaindrive/drive/stiffness.h>
#include <chaindrive/drive/tooth_form.h>
#include <chaindrive/parameters/drive.h>

#include <optional>
#include <string>
#include <vector>

namespace chaindrive::drive
{
/// A sprocket of the drive.
struct Sprocket
{
  std::string           name;       ///< of histories and entries
  std::string           title;      ///< what sentences call it
  std::string           in_entries; ///< what names of entries begin with
  parameters::Role      role;
  ToothForm             form;
  double                bore;         ///< diameter
  double                hub_diameter; ///< of the rigid zone
  MassProperties        solid;
  std::string           mesh;    ///< a Gmsh file that takes the place of the form; empty: none
  ShaftProgram          program; ///< of its shaft
  std::optional<double> given_inertia = {}; ///< of all that turns with it, kg m2; of one with a
                                            ///< coupling that of what is behind
  double inertia = 0.;                      ///< of all that turns with it, what is behind its
                                            ///< coupling included, kg m2
  double mean_torque    = 0.;               ///< that resists it in operation, N m
  double largest_torque = 0.;               ///< a bound of its magnitude, before it steps, N m

  std::optional<Coupling> coupling = {}; ///< between it and what its shaft turns; empty: rigid
  std::optional<Bearing>  bearing  = {}; ///< how its axis yields; empty: it stands still

  double axial_offset   = 0.; ///< of its plane from that of the drive, m
  double tilt           = 0.; ///< of its axis, rad
  double tilt_direction = 0.; ///< to which it leans in a drive that turns counter-clockwise, rad

  parameters::Flat flat = {}; ///< in the place of teeth

  /// Whether plates lie on it, and not rollers.
  bool carries_plates() const { return form.flat && flat.runs_on == parameters::RunsOn::plates; }

  double flat_stiffness  = 0.; ///< of one joint's contact with a drum, given or auto, N/m
  double tooth_stiffness = 0.; ///< of tooth and rim under a roller, given or auto, N/m

  /// The same at places of the seat, from its bottom upwards; empty: not wanted, or not found.
  std::vector<PlacedStiffness> tooth_places = {};
};

/// Sprocket number @p number of @p sprockets but for its solid and its program. A bore of a third
/// and a hub of six tenths of the root diameter: a plain disc on a stout shaft. @p driven_inertia
/// [kg m2] is that of the driven one. One strand has this @p share of inertias that are given, and
/// of others a row of teeth. Throws InputError as make_tooth_form() and index_deviations() do.
Sprocket make_sprocket(unsigned int                 number,
                       const parameters::Sprockets &sprockets,
                       const ChainDimensions       &chain,
                       const std::optional<double> &driven_inertia,
                       double                       share = 1.);

/// Says in @p notes what was chosen for the hub of @p sprocket, which is @p given; InputError for
/// one that cannot be.
void check_hub(const Sprocket             &sprocket,
               const parameters::Sprocket &given,
               std::vector<std::string>   &notes);
} // namespace chaindrive::drive
