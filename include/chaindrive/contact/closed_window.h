// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/reduction/rim_modes.h>

#include <deal.II/base/numbers.h>

#include <array>
#include <vector>

namespace chaindrive::contact
{
class JointFlexibility;

/// Strips and rings of the outside of modal rollers that close together, each carried by nodes.
struct ClosedStrips
{
  struct Place
  {
    double                      angle; ///< rad
    std::array<unsigned int, 4> node;
    std::array<double, 4>       weight;
  };
  std::vector<Place>  places;
  std::vector<double> flexibility; ///< [place][place], m/N
  /// Between the outside and a node of the bore, through the wall: [place][column][ring of
  /// the whole bore], m/N.
  std::vector<double> through;
  /// What modes of a rim with inertia move a place by along its normal, by cosines and sines of
  /// RimModes: [mode][place], 1/sqrt(kg).
  std::vector<double> rim_cosine, rim_sine;
};

/// A round side of modal bodies in contact without penalty. Where a window of it is closed and what
/// it meets stands still, it holds the modes by the inverse of its own flexibility.
struct ClosedWindow
{
  unsigned int              group     = 0; ///< of the bodies in World::copies
  unsigned int              surface   = 0; ///< of their mesh
  unsigned int              n_columns = 0, n_rings = 0;
  std::vector<unsigned int> node;        ///< [ring][column], column c at the angle 2 pi c / n
  std::vector<double>       flexibility; ///< [ring][ring][columns between], m/N
  std::vector<double> across; ///< [ring]: springs of friction across the normal of a node, N/m
  double              half_angle = dealii::numbers::PI; ///< of the window, rad
  bool                in_bore    = false;               ///< or on the cylinder in it

  unsigned int first_ring = 0; ///< of the side, if not all of them are in the window

  /// Of a cylinder: what deflects on its rings and in the bore, whose window is the one before.
  const JointFlexibility *joint = nullptr;

  /// If there are any, the side closes in one of these instead of at nodes.
  std::vector<ClosedStrips> strips             = {};
  unsigned int              n_rings_of_through = 0;
  double                    across_middle = 0.; ///< one spring of friction for all of them, N/m
  /// Of the rigid body that strips meet, 1/kg: acceleration per newton at its teeth, times their
  /// number.
  double mobility = 0.;
  /// The modes of a rim with inertia on which these strips are; null: it has none.
  const reduction::RimModes *rim = nullptr;
};

/// What families of contact without penalty are besides.
class HasClosedWindows
{
public:
  virtual ~HasClosedWindows() = default;

  /// Both sides of all kinds of pairs, for the critical time step; none of those with penalty.
  virtual std::vector<ClosedWindow> closed_windows() const = 0;
};
} // namespace chaindrive::contact
