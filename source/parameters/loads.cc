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
  const std::string common = " off removes it without changing the coefficient; on requires it and "
                             "refuses a coefficient of zero.";
  effect("Friction",
         friction,
         "Coulomb friction of all interfaces. auto: on when a friction coefficient is not zero." +
             common);
  effect("Contact damping",
         contact_damping,
         "Damping of contacts. auto: on when Contact/Damping ratio is not zero." + common);
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
  effect("Oil film",
         oil_film,
         "Squeeze film between rollers, bushes and teeth. auto: on when Contact/Oil viscosity in "
         "mPa s is not zero; layered fidelity only." +
             common);
  const std::string without_clearance =
      " auto: on. off: the bore has the diameter of what turns in it, whatever "
      "Drive/Chain says; layered and full fidelity only.";
  effect("Roller-bush clearance",
         roller_bush_clearance,
         "Clearance of the rollers on their bushes." + without_clearance);
  effect("Bush-pin clearance",
         bush_pin_clearance,
         "Clearance of the pins in their bushes. Without it the holes of all links are a pitch "
         "apart: with Drive/Chain/Pitch set = standard the pitch of the taut chain is unchanged, "
         "with the others it loses the clearance." +
             without_clearance);
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
         "Teeth of rigid sprockets deflect under each elastic or reduced roller with Contact/Tooth "
         "stiffness in N/m, a massless spring in series with the contact. auto: on in reduced "
         "fidelity, whose sprockets are rigid. off: teeth of rigid sprockets are rigid.");
  effect("Tooth compliance over place",
         tooth_places,
         "Where rollers and teeth touch without penalty (Contact/Enforcement = exact), teeth are "
         "softer the higher a roller bears, as elastic solutions have them at the bottom of the "
         "seat, at its end and between. auto: on with Contact/Tooth stiffness in N/m = auto and "
         "Model/Stiffness from = parts. off: they are as soft everywhere as at the end of the "
         "seat, where rollers of new chains bear.");
  effect("Tooth inertia",
         tooth_inertia,
         "Where teeth are softer the higher a roller bears (Tooth compliance over place), the rim "
         "of each sprocket from its hub diameter outwards has inertia: natural modes up to 90 kHz, "
         "faster ones for chains of a pitch below 15.875 mm, with which teeth vibrate and waves of "
         "impacts leave; what these modes do not deflect stays without inertia, so that teeth are "
         "as stiff at rest as without. auto: off. on: what doc/accuracy-and-cost.md says of it.");
  effect(
      "Plate bending",
      plate_bending,
      "Bending of the plates out of their planes. auto: on in elastic links. off: the middle "
      "surfaces of the plates, and with them the links, do not move across the chain; plates may "
      "still become thinner, so they stay in plane stress. In-plane bending is part of elastic "
      "links: without it only the deformation of a bar would be left, which is simple fidelity.");
  effect("Planar motion",
         planar_motion,
         "Rigid links and rollers move in the plane of the chain, in three degrees of freedom; "
         "simple and layered fidelity only. The results are the same to round-off, which impacts "
         "amplify, and a run takes a fraction of the time. auto: on where nothing can leave the "
         "plane. off: in space, in six.");
  effect(
      "Separate strands",
      separate_strands,
      "Each strand of a chain of several (Drive/Chain/Strands) has rollers and inner links of "
      "its own, on pins that all strands share; layered fidelity only. auto: on where wheels are "
      "out of line, which then pull strands unevenly. on: also where all wheels are in line. "
      "off: strands share the load equally, and one is computed with its share.");
  effect(
      "Oval rollers",
      oval_rollers,
      "Rigid rollers of layered fidelity become ovals where tooth and bush do not press them from "
      "both sides of their wall at the same place: a mass and a spring for each of the two modes "
      "of the ring with two waves, as large as dimensions make them. What the ring carries is not "
      "lost: Contact/Damping ratio counts half where they touch. It needs planar motion. "
      "auto: off. on: what doc/accuracy-and-cost.md says of it.");
  effect(
      "Stiffness curves",
      stiffness_curves,
      "Stiffnesses of layered fidelity that are auto follow from the elastic parts "
      "(Model/Stiffness from = parts) at every load, and that of roller and tooth at every place, "
      "too: teeth are softer above the bottom of the gap. auto: on where there are rollers, planar "
      "motion and no oil film. off: each is one number, force over approach at the tension "
      "required by the load and at the bottom of the gap.");
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

void Loads::declare(Declarations &declarations, Sprockets &sprockets)
{
  const Subsection section(declarations, "Loads");
  add(declarations,
      "Driver speed in rad/s",
      driver_speed,
      unit::si,
      between(0., 1e5),
      "Speed of the driver after the ramp; 1 rad/s is 9.549 revolutions per minute. The sense of "
      "rotation follows from Drive/Layout/Tight span. Default: 1153 rpm, a motorcycle at 50 km/h, "
      "as in prm/paper.");
  add_other_form(declarations,
                 "Driver speed in rpm",
                 between(0., 1e6),
                 "The same in revolutions per minute, in place of Driver speed in rad/s. auto: as "
                 "given there.");
  add(declarations,
      "Speed ramp",
      speed_ramp,
      "How the driver runs up from rest. linear: constant acceleration, which begins and ends with "
      "a jerk. cosine: half a cosine wave, which excites the drive less.");
  add(declarations,
      "Ramp time in ms",
      ramp_time,
      unit::milli,
      between(0., 1e6),
      "Time in which the driver reaches full speed. A short ramp saves time but causes a "
      "transient: the start-up tension can be twice that of steady running.");
  add(declarations,
      "Resisting torque in N m",
      resisting_torque,
      unit::si,
      between(0., 1e7),
      "Load torque, which resists the rotation of the driven sprocket. Default: as in prm/paper.")
      .sought = {"Loads/driven/Resisting torque in N m"};
  add_other_form(
      declarations,
      "Power in kW",
      between(0., 1e6),
      "Power of the load at the driver's full speed, in place of Resisting torque in N m, which is "
      "then the power over the mean speed of the driven sprocket. auto: as given there.");
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
      "Time after the start at which the torque jumps, within one time step, to the value below: a "
      "load that is thrown off or reversed. auto: never.");
  add(declarations,
      "Torque after step in N m",
      torque_after_step,
      unit::si,
      between(-1e7, 1e7),
      "Torque from Torque step time in ms on, whatever the rotation; below zero the load drives, "
      "and tight and slack span change places. Default: none.");
  add(declarations,
      "Gravity in m/s2",
      gravity,
      unit::si,
      between(0., 1000.),
      "Acceleration of gravity, downwards along -y: the shafts are at the same height.");
  add(declarations,
      "Drag in 1/s",
      drag,
      unit::si,
      between(0., 1e4),
      "Resisting force on every body of the chain over its mass and velocity; its inverse is the "
      "time in which a freely moving chain slows down to 37 percent. Default: none.");
  for (Sprocket &sprocket : sprockets.list)
    {
      const Subsection own(declarations, sprocket.name);
      if (sprocket.name != "driver" && sprocket.name != "driven")
        add(declarations,
            "Resisting torque in N m",
            sprocket.resisting_torque,
            unit::si,
            between(0., 1e7),
            "Load torque, which resists the rotation of this wheel; it must be driven. auto: none "
            "where it is an idler, else as Loads/Resisting torque in N m, which steps.");
      (sprocket.role == Role::driver ? sprocket.speed_terms : sprocket.torque_terms)
          .declare(declarations);
    }
}
} // namespace chaindrive::parameters
