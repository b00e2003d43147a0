// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/parameters/entries.h>
#include <chaindrive/parameters/tensioner.h>

namespace chaindrive::parameters
{
namespace
{
const std::string while_it_retracts =
    "The same while the chain pushes the wheel back. auto: as above. A greater one, with none "
    "above, is a hydraulic tensioner: oil flows in freely behind the plunger and leaks out slowly.";

/// Of the entry of a stop.
std::string at_stop(const std::string &which)
{
  return "Travel counts from where Centre in mm puts the wheel, and is positive where it takes up "
         "slack; a stop that bears 1e6 N/m at the wheel's axis begins at the " +
         which + " one. none: there is no stop.";
}

void declare_arm(Declarations &declarations, Holders &held)
{
  const Subsection section(declarations, "Arm");
  Tensioner       &arm = held.arm;
  add_point(declarations,
            "Pivot in mm",
            held.pivot,
            "About which the arm turns, x and y as in Centre in mm. An arm must have one: auto is "
            "for wheels without.");
  add(declarations,
      "Moment in N m",
      arm.preload,
      unit::si,
      between(0., 1e6),
      "With which the spring presses the wheel against the chain while its centre is where Centre "
      "in mm says.");
  add(declarations,
      "Stiffness in N m/rad",
      arm.stiffness,
      unit::si,
      between(0., 1e7),
      "By which that moment falls as the arm takes up slack.");
  add(declarations,
      "Damping in N m s/rad",
      arm.damping,
      unit::si,
      between(0., 1e6),
      "Of a damper beside the spring.");
  add(declarations,
      "Retracting damping in N m s/rad",
      arm.retracting_damping,
      unit::si,
      between(0., 1e6),
      while_it_retracts);
  add_angle(declarations,
            "Least angle in degrees",
            arm.least,
            between(-180., 180.),
            at_stop("least"),
            "none");
  add_angle(declarations,
            "Greatest angle in degrees",
            arm.most,
            between(-180., 180.),
            at_stop("greatest"),
            "none");
  add(declarations,
      "Inertia in kg m2",
      arm.inertia,
      unit::si,
      between(0., 1e6),
      "Of the arm about its pivot, without the wheel, whose mass is that of its solid. The arm's "
      "own weight is part of the moment above.");
}

void declare_slide(Declarations &declarations, Holders &held)
{
  const Subsection section(declarations, "Slide");
  Tensioner       &slide = held.slide;
  add_angle(declarations,
            "Direction in degrees",
            held.direction,
            between(-180., 180.),
            "Of the line along which the wheel moves, counter-clockwise from x. Which way along it "
            "takes up slack is found.");
  add(declarations,
      "Force in N",
      slide.preload,
      unit::si,
      between(0., 1e7),
      "With which the spring presses the wheel against the chain while its centre is where Centre "
      "in mm says.");
  add(declarations,
      "Stiffness in N/m",
      slide.stiffness,
      unit::si,
      between(0., 1e9),
      "By which that force falls as the slide takes up slack.");
  add(declarations,
      "Damping in N s/m",
      slide.damping,
      unit::si,
      between(0., 1e7),
      "Of a damper beside the spring.");
  add(declarations,
      "Retracting damping in N s/m",
      slide.retracting_damping,
      unit::si,
      between(0., 1e7),
      while_it_retracts);
  add(declarations,
      "Least travel in mm",
      slide.least,
      unit::milli,
      between(-1e4, 1e4),
      at_stop("least"),
      "none");
  add(declarations,
      "Greatest travel in mm",
      slide.most,
      unit::milli,
      between(-1e4, 1e4),
      at_stop("greatest"),
      "none");
  add(declarations,
      "Mass in g",
      slide.inertia,
      unit::milli,
      between(0., 1e7),
      "Of all that moves with the wheel, whose own mass is that of its solid.");
}
} // namespace

void Holders::declare(Declarations &declarations)
{
  add(declarations,
      "Held by",
      holder,
      "bearing: its axis stands still. arm, slide: it is a tensioner, whose axis turns about a "
      "pivot or moves along a line, pressed against the chain by the spring in section Arm or "
      "Slide; simple and layered fidelity. eccentric, slot: its axis is moved likewise until the "
      "chain has the slack, sag or pre-tension of Layout/Centre distance from, and clamped there; "
      "stops limit its travel, and springs have no meaning. One wheel of a drive, an idler with a "
      "centre of its own.");
  declare_arm(declarations, *this);
  declare_slide(declarations, *this);
}
} // namespace chaindrive::parameters
