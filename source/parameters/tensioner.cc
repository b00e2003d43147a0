// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/parameters/entries.h>
#include <chaindrive/parameters/tensioner.h>

namespace chaindrive::parameters
{
namespace
{
/// What an arm or a slide has in common: spring, damper and stops.
struct Spring
{
  Tensioner  &values;
  std::string holder, force;                       ///< in sentences
  std::string preload, stiffness, damping, travel; ///< names of entries, or their ends
  double      most_preload, most_stiffness, most_damping;
};

/// What is held: in sentences, where it is without travel, and where a stop bears.
struct Held
{
  std::string subject, reference, bears;
};

const Held &wheel()
{
  static const Held held{"wheel",
                         "its centre is where Centre in mm says",
                         "where Centre in mm puts the wheel, and is "
                         "positive where it takes up slack; a stop "
                         "that bears 1e6 N/m at the wheel's axis"};
  return held;
}

const Held &guide()
{
  static const Held held{"guide",
                         "it is where Points in mm says",
                         "where Points in mm puts the guide, and is positive "
                         "towards the chain; a stop that bears 1e6 N/m at "
                         "the middle of its line"};
  return held;
}

/// @p add_stop adds an entry of which name, member and meaning are given.
template <typename AddStop>
void declare_spring(Declarations  &declarations,
                    const Held    &held,
                    const Spring  &spring,
                    const AddStop &add_stop)
{
  Tensioner &values = spring.values;
  add(declarations,
      spring.preload,
      values.preload,
      unit::si,
      between(0., spring.most_preload),
      "With which the spring presses the " + held.subject + " against the chain while " +
          held.reference + ".");
  add(declarations,
      spring.stiffness,
      values.stiffness,
      unit::si,
      between(0., spring.most_stiffness),
      "By which that " + spring.force + " falls as the " + spring.holder + " takes up slack.");
  add(declarations,
      "Damping in " + spring.damping,
      values.damping,
      unit::si,
      between(0., spring.most_damping),
      "Of a damper beside the spring.");
  add(declarations,
      "Retracting damping in " + spring.damping,
      values.retracting_damping,
      unit::si,
      between(0., spring.most_damping),
      "The same while the chain pushes the " + held.subject +
          " back. auto: as above. A greater one, with none "
          "above, is a hydraulic tensioner: oil flows in freely behind the plunger and leaks out "
          "slowly.");
  const auto at_stop = [&held](const std::string &which) {
    return "Travel counts from " + held.bears + " begins at the " + which +
           " one. none: there is no stop.";
  };
  add_stop("Least " + spring.travel, values.least, at_stop("least"));
  add_stop("Greatest " + spring.travel, values.most, at_stop("greatest"));
}

void declare_arm(Declarations &declarations, Holders &held, const bool of_wheel)
{
  const Subsection section(declarations, "Arm");
  add_point(declarations,
            "Pivot in mm",
            held.pivot,
            std::string("About which the arm turns, x and y as in Centre in mm. An arm must have "
                        "one: auto is for ") +
                (of_wheel ? "wheels" : "guides") + " without.");
  declare_spring(declarations,
                 of_wheel ? wheel() : guide(),
                 {held.arm,
                  "arm",
                  "moment",
                  "Moment in N m",
                  "Stiffness in N m/rad",
                  "N m s/rad",
                  "angle in degrees",
                  1e6,
                  1e7,
                  1e6},
                 [&](const auto &name, auto &angle, const auto &meaning) {
                   add_angle(declarations, name, angle, between(-180., 180.), meaning, "none");
                 });
  add(declarations,
      "Inertia in kg m2",
      held.arm.inertia,
      unit::si,
      between(0., 1e6),
      of_wheel ?
          "Of the arm about its pivot, without the wheel, whose mass is that of its solid. The "
          "arm's own weight is part of the moment above." :
          "Of the arm with the guide about its pivot, above 0 where there is an arm. Their weight "
          "is part of the moment above.");
}

void declare_slide(Declarations &declarations, Holders &held, const bool of_wheel)
{
  const Subsection section(declarations, "Slide");
  add_angle(declarations,
            "Direction in degrees",
            held.direction,
            between(-180., 180.),
            of_wheel ? "Of the line along which the wheel moves, counter-clockwise from x. Which "
                       "way along it takes up slack is found." :
                       "Of the line along which the guide moves, counter-clockwise from x. Which "
                       "way along it leads to the chain is found.");
  declare_spring(declarations,
                 of_wheel ? wheel() : guide(),
                 {held.slide,
                  "slide",
                  "force",
                  "Force in N",
                  "Stiffness in N/m",
                  "N s/m",
                  "travel in mm",
                  1e7,
                  1e9,
                  1e7},
                 [&](const auto &name, auto &way, const auto &meaning) {
                   add(declarations, name, way, unit::milli, between(-1e4, 1e4), meaning, "none");
                 });
  add(declarations,
      "Mass in g",
      held.slide.inertia,
      unit::milli,
      between(0., 1e7),
      of_wheel ? "Of all that moves with the wheel, whose own mass is that of its solid." :
                 "Of the guide and all that moves with it, above 0 where there is a slide.");
}
} // namespace

void Holders::declare(Declarations &declarations)
{
  add(declarations,
      "Held by",
      holder,
      "bearing: its axis stands still. arm, slide: it is a tensioner, whose axis turns about a "
      "pivot or moves along a line, pressed against the chain by the spring in section Arm or "
      "Slide. eccentric, slot: its axis is moved likewise until the "
      "chain has the slack, sag or pre-tension of Layout/Centre distance from, and clamped there; "
      "stops limit its travel, and springs have no meaning. One wheel of a drive, an idler with a "
      "centre of its own.");
  declare_arm(declarations, *this, true);
  declare_slide(declarations, *this, true);
}

void Holders::declare_of_guide(Declarations &declarations)
{
  add_choice(declarations,
             "Held by",
             "nothing",
             {"nothing", text_of(Holder::arm), text_of(Holder::slide)},
             "nothing: the guide stands still. arm, slide: it is a tensioner, a blade that turns "
             "about a pivot or a shoe that moves along a line, pressed against the slack span by "
             "the spring in section Arm or Slide. Where Points in mm puts it, it stands clear of "
             "the straight span; the start has it in balance with the chain.",
             [this](const std::string &text) {
               holder = value_of<Holder>(text).value_or(Holder::bearing);
             });
  declare_arm(declarations, *this, false);
  declare_slide(declarations, *this, false);
}
} // namespace chaindrive::parameters
