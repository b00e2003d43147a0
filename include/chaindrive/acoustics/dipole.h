// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/tensor.h>

#include <vector>

namespace chaindrive::acoustics
{
/// Air at 20 degrees Celsius and 1013 hPa.
struct Air
{
  double density = 1.204; ///< kg/m3
  double speed   = 343.2; ///< of sound, m/s
};

/// Added mass of a rigid cylinder of finite length that oscillates across its axis, over the mass
/// of the air that it displaces: 1 of a long one. By its length over its diameter,
/// shortest_cylinder or more, interpolated in a table of potential flow.
constexpr double shortest_cylinder = 0.25;
double           added_mass(double length_over_diameter);

/// Strength of the dipole that a body makes per acceleration, rho V (1 + kappa), kg: the force on
/// the air and the momentum of the air that it displaces. Of a cylinder with a @p radius and a @p
/// length [m].
double dipole_mass(const Air &air, double radius, double length);

/// Equal steps in time, s.
struct Grid
{
  double      start, step;
  std::size_t size;

  double time(const std::size_t i) const { return start + step * static_cast<double>(i); }
};

/// A small body that moves and oscillates.
struct Source
{
  Grid                              grid;         ///< of the following
  std::vector<dealii::Tensor<1, 3>> position;     ///< m
  std::vector<dealii::Tensor<1, 3>> acceleration; ///< m/s2
  double                            mass;         ///< dipole_mass(), kg
};

/// Adds to @p pressure [Pa] at @p observer [m], at the times of @p grid, the sound of @p source in
/// free air,
///
///   p(t) = m/(4 pi) (1/c d/dt + 1/r) (n . a)/r at t - r/c,
///
/// a compact dipole (Pierce, Acoustics, 4-7) whose r and direction n towards the observer are those
/// of the time of emission. Nothing is added at times that are not received. Each emission is taken
/// to when it is received, and what comes is interpolated between: both grids must be fine beside
/// its periods. InputError when the source comes faster than sound.
void add_pressure(const Air                  &air,
                  const Source               &source,
                  const dealii::Tensor<1, 3> &observer,
                  const Grid                 &grid,
                  std::vector<double>        &pressure);
} // namespace chaindrive::acoustics
