// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/parameters/drive.h>
#include <chaindrive/parameters/entries.h>
#include <chaindrive/parameters/loads.h>

namespace chaindrive::parameters
{
void Effects::declare(Declarations &declarations, Sprockets &sprockets)
{
  const Subsection section(declarations, "Effects");
  const auto       effect =
      [&declarations](const std::string &name, Switch &member, const std::string &meaning) {
        add(declarations, name, member, meaning);
      };
  const std::string common =
      " off drops it, at no cost, without touching the coefficient; on insists on it and refuses "
      "a coefficient of zero.";
  effect("Friction",
         friction,
         "Coulomb friction of all interfaces. auto: on when a friction coefficient is not zero." +
             common);
  effect("Contact damping",
         contact_damping,
         "Damping of bodies that touch. auto: on when Contact/Damping ratio is not zero." + common);
  effect("Chain damping",
         chain_damping,
         "Damping of the chain's bars; simple fidelity only. auto: on when Model/Chain damping "
         "ratio is not zero." +
             common);
  effect("Gravity",
         gravity,
         "Weight of the chain. auto: on when Loads/Gravity in m/s2 is not zero." + common);
  effect("Drag",
         drag,
         "Resistance of air or oil to the chain. auto: on when Loads/Drag in 1/s is not zero." +
             common);
  const std::string play =
      " auto: on. off: the bore has the diameter of what turns in it, whatever "
      "Drive/Chain says; layered and full fidelity only.";
  effect("Roller-bush clearance",
         roller_bush_clearance,
         "Play of the rollers on their bushes." + play);
  effect("Bush-pin clearance",
         bush_pin_clearance,
         "Play of the pins in their bushes. Without it the holes of all links are a pitch apart: "
         "with Drive/Chain/Pitch set = standard the pitch of the taut chain stays, with the others "
         "it loses the clearance." +
             play);
  const std::string needed =
      "; full fidelity only. auto: on where one of Output/Quantities needs it (table at the end of "
      "this document). off: ";
  effect("Elastic links",
         elastic_links,
         "Deformation of inner and outer links" + needed +
             "they are rigid, and their compliance is in the joints as in layered fidelity.");
  effect("Elastic rollers",
         elastic_rollers,
         "Deformation of rollers" + needed +
             "they are rigid, and their compliance is in Contact/Roller-tooth stiffness in N/m.");
  const std::string rim =
      "Deformation of the rim of the sprocket, from the hub diameter outwards; of an imported "
      "one, of all but its physical volume hub zone. It needs elastic rollers";
  for (Sprocket &sprocket : sprockets.list)
    effect("Elastic " + sprocket.name, sprocket.elastic, rim + needed + "the sprocket is rigid.");
  effect("Tooth compliance",
         tooth_compliance,
         "Rigid sprockets give way under each elastic or reduced roller by Contact/Tooth stiffness "
         "in N/m, as a spring without mass behind the contact. auto: on in reduced fidelity, whose "
         "sprockets are rigid. off: teeth of rigid sprockets do not give way.");
  effect("Plate bending",
         plate_bending,
         "Bending of the plates out of their planes. auto: on in elastic links. off: the "
         "middle surfaces of the plates stay where they are across the chain, and the links with "
         "them; plates may still become thinner, so that their state stays one of plane stress. "
         "Bending in their planes comes with elastic links: without it nothing would be left of "
         "their deformation but that of a bar, which is simple fidelity.");
}

namespace
{
/// A quantity that another entry gives, in the unit that a designer has. What is given here is
/// converted to that entry when all are read (reader.cc), and stored nowhere else.
void add_other_form(Declarations      &declarations,
                    const std::string &name,
                    const Range       &range,
                    const std::string &meaning)
{
  declarations.add(
      name,
      "auto",
      "auto or " + range.text(),
      meaning,
      [range](const std::string &text) {
        const std::optional<double> value = from_entry_text(text, unit::si);
        return text == "auto" || (value && range.contains(*value));
      },
      [](const std::string &) {});
}
} // namespace

void Loads::declare(Declarations &declarations)
{
  const Subsection section(declarations, "Loads");
  add(declarations,
      "Driver speed in rad/s",
      driver_speed,
      unit::si,
      between(0., 1e5),
      "Speed of the driver after the ramp; 1 rad/s is 9.549 revolutions per minute. Its sense "
      "follows from Drive/Layout/Tight span. Default: 1153 rpm, a motorcycle at 50 km/h, as in "
      "prm/paper.");
  add_other_form(declarations,
                 "Driver speed in rpm",
                 between(0., 1e6),
                 "The same in revolutions per minute, in place of Driver speed in rad/s. auto: as "
                 "given there.");
  add(declarations,
      "Speed ramp",
      speed_ramp,
      "How the driver's speed grows from zero. linear: constant acceleration, which begins and "
      "ends with a jerk. cosine: half a cosine wave, which excites the drive less.");
  add(declarations,
      "Ramp time in ms",
      ramp_time,
      unit::milli,
      between(0., 1e6),
      "How long the driver takes to its full speed. A short ramp saves time and costs a "
      "transient: the tension of the start can be twice that of steady running.");
  add(declarations,
      "Resisting torque in N m",
      resisting_torque,
      unit::si,
      between(0., 1e7),
      "Torque of the load, which resists the rotation of the driven sprocket. Default: as in "
      "prm/paper.");
  add_other_form(
      declarations,
      "Power in kW",
      between(0., 1e6),
      "What the load takes at the driver's full speed, in place of Resisting torque in "
      "N m: that is the power over the mean speed of the driven sprocket. auto: as given "
      "there.");
  add(declarations,
      "Torque ramp angle in rad",
      torque_ramp_angle,
      unit::si,
      between(0., 100.),
      "Rotation of the driven sprocket over which the torque grows to its full value; before "
      "that, the load only resists in proportion to the rotation. Default: as in prm/paper.");
  add(declarations,
      "Torque step time in ms",
      torque_step_time,
      unit::milli,
      between(0., 1e9),
      "Time after the start at which the torque jumps from one step to the next to the value "
      "below: "
      "a load that is thrown off or changes sides. auto: never.");
  add(declarations,
      "Torque after step in N m",
      torque_after_step,
      unit::si,
      between(-1e7, 1e7),
      "Torque from Torque step time in ms on, whatever the rotation; below zero the load drives, "
      "and "
      "the spans change their parts. Default: none.");
  add(declarations,
      "Gravity in m/s2",
      gravity,
      unit::si,
      between(0., 1000.),
      "Acceleration of gravity, downwards along -y: the shafts lie at the same height.");
  add(declarations,
      "Drag in 1/s",
      drag,
      unit::si,
      between(0., 1e4),
      "Resisting force on every body of the chain over its mass and velocity: the time in which a "
      "chain moving freely slows down to 37 percent is its inverse. Default: none.");
}
} // namespace chaindrive::parameters
