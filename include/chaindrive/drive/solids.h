// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/chain.h>
#include <chaindrive/drive/plate.h>
#include <chaindrive/drive/tooth_form.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

namespace chaindrive::drive
{
/// Mass, centre of mass and inertia tensor about that centre. SI units.
struct MassProperties
{
  double               mass = 0.; ///< kg
  dealii::Point<3>     centre;    ///< m
  dealii::Tensor<2, 3> inertia;   ///< kg m2

  /// Two bodies made one.
  MassProperties &operator+=(const MassProperties &other);

  /// The body moved by @p shift.
  MassProperties moved(const dealii::Tensor<1, 3> &shift) const;
};

/// A tube about the z axis, centred at the origin. Bore zero: a solid cylinder.
MassProperties tube(double diameter, double bore, double length, double density);

/// Parts of the chain as exact solids in their body frames, centred at the origin; links, bushes
/// and pins of a chain with ChainDimensions::link_density_factor times this density. Bushes and
/// pins have the lengths of ChainDimensions, from mid-surface to mid-surface of their plates; the
/// holes of the plates have the diameter of the bush or pin in them.
MassProperties roller_solid(const ChainDimensions &chain, double density);
MassProperties bush_solid(const ChainDimensions &chain, double density);
MassProperties pin_solid(const ChainDimensions &chain, double density);
MassProperties plate_solid(const Plate &plate, double density);

/// Two plates and two bushes.
MassProperties inner_link_solid(const ChainDimensions &chain, double density);

/// Two plates and two pins.
MassProperties outer_link_solid(const ChainDimensions &chain, double density);

/// A flat sprocket of the given width with a bore (diameter).
MassProperties sprocket_solid(const ToothForm &form, double bore, double width, double density);
} // namespace chaindrive::drive
