// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/chain.h>
#include <chaindrive/material/material.h>

namespace chaindrive::drive
{
/// How a roller that stays round in itself becomes an oval: its two modes with two waves around,
/// u(angle) = a cos 2 angle + b sin 2 angle, by which its outside moves outwards. A force F that
/// presses on the outside at an angle does the work -F u there; one that presses on the bore from
/// within, +F bore u.
struct RollerRing
{
  double stiffness; ///< of a and b, N/m: energy stiffness (a^2 + b^2) / 2
  double mass;      ///< of a and b, kg
  double bore;      ///< by how much the bore moves outwards where the outside moves by one
};

/// Of a ring of @p inner and @p outer radius and @p length [m], long enough for plane strain: the
/// exact solution of Michell for the pressure cos 2 angle on the outside (Timoshenko and Goodier,
/// Theory of Elasticity, 43; displacements as in Barber, Elasticity, 9), with the mass by
/// Rayleigh's quotient. A thin ring has 9 pi E' I / R^3, 5/4 pi rho A R and 1.
RollerRing oval_of_ring(double inner, double outer, double length, const Material &steel);

/// Of the rollers of @p chain, which has some.
RollerRing roller_ring(const ChainDimensions &chain, const Material &steel);
} // namespace chaindrive::drive
