// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/parameters/entries.h>
#include <chaindrive/parameters/shaft.h>

namespace chaindrive::parameters
{
void Coupling::declare(Declarations &declarations)
{
  const Subsection section(declarations, "Coupling");
  add(declarations,
      "Stiffness in N m/rad",
      stiffness,
      unit::si,
      above(0., 1e10),
      "Of a coupling or shaft that twists between the sprocket and what is behind it: the motor, "
      "which has the speed of section Loads, or the inertia of the machine, on which the torque "
      "acts and which the wheel's inertia then is alone. rigid: they turn as one.",
      "rigid");
  add(declarations,
      "Damping in N m s/rad",
      damping,
      unit::si,
      between(0., 1e8),
      "Of a damper beside that spring. auto: of the ratio below.");
  add(declarations,
      "Damping ratio",
      damping_ratio,
      unit::si,
      between(0., 1.),
      "Where the damping is auto: of the vibration of sprocket and machine against each other, "
      "without the chain.");
  add(declarations,
      "Inertia of sprocket in kg m2",
      sprocket,
      unit::si,
      above(0., 1e6),
      "Of the sprocket and of all that is fixed to it before the coupling. auto: the sprocket "
      "alone.");
}

void Bearing::declare(Declarations &declarations)
{
  const Subsection section(declarations, "Bearing");
  add(declarations,
      "Stiffness in N/m",
      stiffness,
      unit::si,
      above(0., 1e12),
      "Of shaft, bearings and their housing against a motion of the wheel across its axis. The "
      "wheel is where its centre is given while the chain does not pull at it: its weight has "
      "bent the shaft already. rigid: the axis stands still.",
      "rigid");
  add(declarations,
      "Stiffness along y in N/m",
      stiffness_along_y,
      unit::si,
      above(0., 1e12),
      "The same along y, where the one above is along x. auto: the same.");
  add(declarations,
      "Damping in N s/m",
      damping,
      unit::si,
      between(0., 1e9),
      "Of dampers beside these springs, along x and y. auto: of the ratio below.");
  add(declarations,
      "Damping ratio",
      damping_ratio,
      unit::si,
      between(0., 1.),
      "Where the damping is auto: of the wheel on each spring, without the chain.");
  add(declarations,
      "Mass in kg",
      mass,
      unit::si,
      above(0., 1e6),
      "That moves with the wheel, its own included. auto: the sprocket alone.");
}
} // namespace chaindrive::parameters
