// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/parameters/drive.h>

#include <deal.II/base/tensor.h>

#include <optional>
#include <string>

namespace chaindrive::drive
{
/// A torsion spring with a damper between a sprocket and what is behind it.
struct Coupling
{
  double stiffness; ///< N m/rad
  double damping;   ///< N m s/rad
  double before;    ///< inertia of the sprocket and what is fixed to it, kg m2
  double behind;    ///< inertia behind the spring, kg m2; 0: a motor with a speed of its own

  /// Of the inertias on both sides against each other, without the chain, Hz:
  /// sqrt(k (1 / before + 1 / behind)) / (2 pi), the second term zero of a motor.
  double frequency() const;
};

/// Springs with dampers along x and y that hold the axis of a wheel.
struct Bearing
{
  dealii::Tensor<1, 2> stiffness; ///< N/m
  dealii::Tensor<1, 2> damping;   ///< N s/m
  double               mass;      ///< that moves with the wheel, kg

  /// Of the mass on the spring along axis @p d, without the chain, Hz: sqrt(k / m) / (2 pi).
  double frequency(unsigned int d) const;
};

/// The coupling that the entries of @p wheel ask for, empty for a rigid one. A damping that is auto
/// is 2 ratio k / omega, omega that of frequency(). Of what is given a strand has its @p share; @p
/// solid [kg m2] is the inertia of the sprocket's solid for one strand, @p behind [kg m2] the share
/// of what the shaft turns, if it is given.
/// @throws InputError for a coupling of a wheel, not the driver, without an inertia behind it.
std::optional<Coupling> make_coupling(const parameters::Sprocket  &wheel,
                                      double                       share,
                                      double                       solid,
                                      const std::optional<double> &behind);

/// The bearing that the entries of @p wheel ask for, empty for a rigid one. A damping that is auto
/// is 2 ratio sqrt(k m). Of what is given a strand has its @p share; @p solid [kg] is the mass of
/// the sprocket's solid for one strand.
/// @throws InputError for a mass below that, for a wheel on a tensioner, and for one with runout.
std::optional<Bearing> make_bearing(const parameters::Sprocket &wheel, double share, double solid);

/// Refuses (InputError) a @p bearing of the wheel @p name that the @p tension [N] in the spans
/// moves by more than half a @p pitch [m], and a @p coupling that the @p torque [N m] twists by
/// more than half a turn: there is no sense in a drive beyond that.
void refuse_soft_shaft(const std::string             &name,
                       const std::optional<Bearing>  &bearing,
                       const std::optional<Coupling> &coupling,
                       double                         tension,
                       double                         torque,
                       double                         pitch);
} // namespace chaindrive::drive
