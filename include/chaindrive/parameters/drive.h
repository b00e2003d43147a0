// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/parameter_handler.h>

#include <optional>
#include <string>

namespace chaindrive::parameters
{
/// Section `Drive/Chain`. An empty optional means `auto`: from the designation, or derived from it.
struct Chain
{
  std::string           designation = "525";
  std::string           pitch_set   = "standard"; ///< standard | paper literal | nominal
  double                elongation  = 0.; ///< of the loaded pitch, wear: 0.01 is one percent
  std::optional<double> pitch, roller_diameter, roller_bore, roller_length; ///< m
  std::optional<double> bush_diameter, bush_bore, bush_length;              ///< m
  std::optional<double> pin_diameter, pin_bore, pin_length;                 ///< m
  std::optional<double> inner_plate_height, inner_plate_thickness;          ///< m
  std::optional<double> outer_plate_height, outer_plate_thickness;          ///< m
  double                waist_ratio = 0.7; ///< plate height at mid-pitch / plate height

  /// Declares an entry for each member, which takes every value that is set. The object must
  /// outlive @p prm.
  void declare(dealii::ParameterHandler &prm);
};

/// Section `Drive/Sprockets`.
struct Sprockets
{
  std::string           tooth_form  = "iso min"; ///< iso min | iso mid | iso max | ansi
  std::string           seat_centre = "iso";     ///< iso | pitch | bottom diameter
  std::optional<double> driver_outside_diameter, driven_outside_diameter; ///< m
  std::optional<double> driver_bottom_diameter,
      driven_bottom_diameter;                                     ///< m, for `bottom diameter`
  std::optional<double> driver_bore, driven_bore;                 ///< m
  std::optional<double> driver_hub_diameter, driven_hub_diameter; ///< m, rigid zone
  std::optional<double> width;                                    ///< m
  std::string           driver_mesh, driven_mesh;                 ///< Gmsh files; empty: generated

  /// Declares an entry for each member, which takes every value that is set. The object must
  /// outlive @p prm.
  void declare(dealii::ParameterHandler &prm);
};

/// Section `Drive/Layout`.
struct Layout
{
  std::string centre_distance_from = "slack";  ///< given | slack | sag | pretension
  double      centre_distance      = 0.643038; ///< m, when given
  double      slack                = 0.5e-3;   ///< m, total excess length of the chain as laid
  double      sag                  = 0.01;     ///< of the slack span's length
  double      pretension           = 100.;     ///< N, in both spans
  std::string tight_span           = "upper";  ///< upper | lower
  double      start_phase          = 0.;       ///< of a driver pitch, 0 <= phase < 1
  std::string start                = "taut";   ///< taut | concentric | warm

  /// Declares an entry for each member, which takes every value that is set. The object must
  /// outlive @p prm.
  void declare(dealii::ParameterHandler &prm);
};

/// Section `Drive`: the geometry of the whole drive.
struct Drive
{
  unsigned int n_links      = 110;
  unsigned int driver_teeth = 15;
  unsigned int driven_teeth = 42;
  Chain        chain;
  Sprockets    sprockets;
  Layout       layout;

  /// Declares an entry for each member, which takes every value that is set. The object must
  /// outlive @p prm.
  void declare(dealii::ParameterHandler &prm);
};
} // namespace chaindrive::parameters
