// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/parameters/drive.h>
#include <chaindrive/parameters/entries.h>

#include <algorithm>
#include <cctype>

namespace chaindrive::parameters
{
std::string Sprocket::in_words() const { return role == Role::driver ? name : name + " sprocket"; }

std::string Sprocket::in_entries() const
{
  std::string text = name;
  text[0]          = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

Sprocket &Sprockets::driven()
{
  return *std::find_if(list.begin(), list.end(), [](const Sprocket &sprocket) {
    return sprocket.role == Role::driven;
  });
}

const Sprocket &Sprockets::driven() const { return const_cast<Sprockets *>(this)->driven(); }

void Chain::declare(Declarations &declarations)
{
  const Subsection section(declarations, "Chain");
  add_text(declarations,
           "Designation",
           designation,
           "a designation of ISO 606 (such as 08B or 12A), ANSI (such as 40 or 60) or a motorcycle "
           "chain (such as 428, 525 or 630)",
           "Size of the chain in the tables of the standards, from which all dimensions below "
           "follow unless they are given. The default is the chain of the drive in prm/paper.");
  add(declarations,
      "Strands",
      strands,
      1,
      6,
      "Strands side by side, 2 of 08B-2: they share the load equally, and one is computed with its "
      "share, unless Effects/Separate strands is on. Of all strands are torques, inertias, springs "
      "of tensioners, loads of shafts and "
      "guides, power, losses, energies and sound, in entries as in results; of one strand are "
      "masses, stiffnesses and tensions of the chain, forces in joints and on teeth. Ratings and "
      "life take the strand that pulls most, doc/theory.md, section 9. Default: a simplex chain.");
  add(declarations,
      "Rollers",
      rollers,
      "Whether rollers turn on the bushes. off: a bush chain, whose bushes meet the teeth; they "
      "are "
      "one with the inner link and slide in their seats while the joint turns, where rollers roll. "
      "auto: as the designation says; 25, 35, 04C and 06C are bush chains, all others have "
      "rollers. Bush chains of camshaft drives (6.35, 8 and 9.525 mm) are those of a roller chain "
      "of the same pitch with off and their own bush diameter.");
  add(declarations,
      "Pitch set",
      pitch_set,
      "Hole distance in the plates. standard: outer plates are shorter by the joint clearance, so "
      "that the loaded chain has its nominal pitch everywhere; correct for all chains made to a "
      "standard. nominal: inner and outer plates have the nominal pitch, so the loaded chain is "
      "longer by a radial clearance per pitch, like a worn one. paper literal: as nominal, for "
      "sprockets cut to that longer pitch by their bottom diameters (Seat centre = bottom "
      "diameter).");
  add(declarations,
      "Elongation in percent",
      elongation,
      unit::percent,
      between(0., 5.),
      "Wear: elongation of the loaded pitch relative to a new chain. Chains are usually replaced "
      "at 2 to 3 percent. Default: a new chain.");
  add(declarations,
      "Pitch tolerance in percent",
      pitch_tolerance,
      unit::percent,
      between(0., 1.),
      "Deviation of the pitch of single links from that of the chain: each has its own at random, "
      "evenly distributed between minus and plus this part of the pitch, less the mean of all "
      "inner or all outer links, so that the chain keeps its length. Simple and layered fidelity. "
      "Default: all links are the same.");
  add(declarations,
      "Pitch seed",
      pitch_seed,
      0,
      1000000000,
      "Which of the random chains of that tolerance it is: the same number is the same chain on "
      "every machine.");
  add(declarations,
      "Pitch deviations in um",
      pitch_deviations,
      unit::micro,
      between(-1000., 1000.),
      "In place of a tolerance: by how much the pitch of each link differs from that of the chain, "
      "as measured or worn, from link 0 on, an inner link that leaves joint 0 (Start phase), in "
      "the direction of travel. As many as links, or a part of them that repeats; their sum, by "
      "which the chain is longer, must not be negative. Simple and layered fidelity. Default: all "
      "links are the same.");
  const auto length = [&declarations](const std::string     &name,
                                      std::optional<double> &member,
                                      const Range           &range,
                                      const std::string     &meaning) {
    add(declarations, name, member, unit::milli, range, meaning);
  };
  const std::string listed = " auto: from the table.";
  const std::string scaled =
      " auto: from the table; where it is silent, scaled from the 525 chain by the roller "
      "diameter.";
  length("Pitch in mm", pitch, between(1e-3, 1000.), "Nominal pitch." + listed);
  length("Roller diameter in mm",
         roller_diameter,
         between(1e-3, 1000.),
         "Outside diameter of the roller, or where there are none of the bush. Give it, and the "
         "other dimensions, for a chain that no table lists." +
             listed);
  length("Roller bore in mm",
         roller_bore,
         between(1e-3, 1000.),
         "Bore of the roller; with the bush diameter it sets the clearance between the two. auto: "
         "a radial clearance of 0.045 mm.");
  length("Roller length in mm",
         roller_length,
         between(1e-3, 1000.),
         "Length of the roller, less than the inner width of the chain. auto: 0.88 of the inner "
         "width, as in the 525 chain.");
  length("Bush diameter in mm",
         bush_diameter,
         between(1e-3, 1000.),
         "Outside diameter of the bush. Of a chain without rollers it is what meets the teeth, and "
         "auto the roller diameter." +
             scaled);
  length("Bush bore in mm",
         bush_bore,
         between(1e-3, 1000.),
         "Bore of the bush; with the pin diameter it sets the joint clearance. auto: a radial "
         "clearance of 0.045 mm.");
  length("Bush length in mm",
         bush_length,
         between(1e-3, 1000.),
         "Length of the bush, from middle to middle of the inner plates: inner width and one "
         "plate's thickness together." +
             listed);
  length("Pin diameter in mm",
         pin_diameter,
         between(1e-3, 1000.),
         "Outside diameter of the pin." + scaled);
  length("Pin bore in mm",
         pin_bore,
         between(0., 1000.),
         "Bore of a hollow pin; 0 is a solid pin. auto: solid, but for the 525 chain.");
  length("Pin length in mm",
         pin_length,
         between(1e-3, 1000.),
         "Length of the pin, from middle to middle of the outer plates. auto: leaves a gap "
         "between inner and outer plates that is scaled from the 525 chain.");
  length("Inner plate height in mm",
         inner_plate_height,
         between(1e-3, 1000.),
         "Height of the inner plates at the holes. auto: from the table, or 0.95 of the pitch.");
  length("Inner plate thickness in mm",
         inner_plate_thickness,
         between(1e-3, 100.),
         "Thickness of one inner plate." + scaled);
  length("Outer plate height in mm",
         outer_plate_height,
         between(1e-3, 1000.),
         "Height of the outer plates at the holes. auto: from the table, or 0.82 of the pitch.");
  length("Outer plate thickness in mm",
         outer_plate_thickness,
         between(1e-3, 100.),
         "Thickness of one outer plate." + scaled);
  length("Transverse pitch in mm",
         transverse_pitch,
         between(1e-3, 1000.),
         "Distance of the middle planes of two strands, for Strands above 1. It counts where "
         "strands are separate (Effects/Separate strands). auto: from the table of ISO 606; where "
         "it is silent, two outer plates beside each other with the gap between inner and outer "
         "ones.");
  add(declarations,
      "Waist ratio",
      waist_ratio,
      unit::si,
      between(0.1, 1.),
      "Plate height midway between the holes over the height at the holes; 1 gives straight-sided "
      "plates. The default is estimated from pictures of chains: no standard specifies it.");
}

namespace
{
std::string of(const Sprocket &sprocket) { return sprocket.in_words() + "'s"; }
} // namespace

void Sprockets::declare(Declarations &declarations)
{
  const Subsection section(declarations, "Sprockets");
  add(declarations,
      "Tooth form",
      tooth_form,
      "Shape of the tooth gap. ISO 606 limits it by a minimum and a maximum form, between which "
      "makers are free; iso mid takes the means of seat radius, angle and flank radius. ansi is "
      "the form of ANSI B29.1. The form changes the impact peaks as much as 50 um of seat radius "
      "do. Default: the form that keeps a tip land up to the largest outside diameter.");
  add(declarations,
      "Seat centre",
      seat_centre,
      "Position of the seat of a gap. iso: the bottom of the gap is on the root circle, so a "
      "roller seated there has its centre on the pitch circle. pitch: the seat arc's centre is on "
      "the pitch circle, as in ANSI forms. bottom diameter: the bottom of the gap is on the bottom "
      "diameter below, as measured on a real sprocket.");
  const auto length = [&declarations](const std::string     &name,
                                      std::optional<double> &member,
                                      const std::string     &meaning) {
    add(declarations, name, member, unit::milli, between(1e-3, 10000.), meaning);
  };
  const std::string outside = "Diameter over the tips of the ";
  const std::string tips =
      " teeth. auto: the middle of the range of ISO 606 provided that the tooth keeps a tip land, "
      "or the value of ANSI B29.1. A value that leaves no tip land is refused.";
  const std::string bottom = ", used only with Seat centre = bottom diameter. Measure it with "
                             "pins, since it determines where the rollers sit.";
  const std::string bore   = " shaft. It affects only the inertia and the field output. auto: a "
                             "third of the root diameter.";
  const std::string hub    = " rigid zone, inside which the mesh is fixed to the shaft. auto: six "
                             "tenths of the root diameter.";
  for (Sprocket &sprocket : list)
    length(sprocket.in_entries() + " outside diameter in mm",
           sprocket.outside_diameter,
           outside + of(sprocket) + tips);
  for (Sprocket &sprocket : list)
    length(sprocket.in_entries() + " bottom diameter in mm",
           sprocket.bottom_diameter,
           "Diameter at the bottom of the " + of(sprocket) + " gaps" + bottom);
  for (Sprocket &sprocket : list)
    length(sprocket.in_entries() + " bore in mm",
           sprocket.bore,
           "Bore for the " + of(sprocket) + bore);
  for (Sprocket &sprocket : list)
    length(sprocket.in_entries() + " hub diameter in mm",
           sprocket.hub_diameter,
           "Diameter of the " + of(sprocket) + hub);
  length("Width in mm",
         width,
         "Width of the teeth of both sprockets. auto: 0.93 of the chain's inner width up to a "
         "pitch of 12.7 mm and 0.95 above, as in ISO 606.");
  const std::string relief = " of the side of a tooth, which guides plates where wheels are "
                             "out of line. auto: ";
  add(declarations,
      "Side relief in mm",
      side_relief,
      unit::milli,
      between(0., 1000.),
      "By how much either side of a tooth stands back at its tip: the height of the rounding" +
          relief + "0.13 pitches, as in ISO 606.");
  length("Side radius in mm",
         side_radius,
         "Radius of the rounding" + relief + "the pitch, as in ISO 606.");
  add(declarations,
      "Facets per tooth",
      facets,
      0,
      1000,
      "Number of chords that replace the arcs of each tooth of both sprockets, from the bottom of "
      "a gap to that of the next: the rigid faceted teeth of other programs. An even number from "
      "12 on, or 0 for the exact, smooth arcs. Teeth must be rigid. Default: smooth teeth, which "
      "are exact and cost less.");
  const std::string meshed =
      ": a Gmsh .msh file with the named surfaces that meshes/README.md lists, looked up in the "
      "parameter file's directory, then in the one the program is started in. Give it for teeth "
      "that no form above describes. "
      "Default: the mesh is made from the tooth form.";
  for (Sprocket &sprocket : list)
    add_text(declarations,
             sprocket.in_entries() + " mesh",
             sprocket.mesh,
             "a file name or nothing",
             "Mesh of the " + sprocket.in_words() + meshed);
}

void Layout::declare(Declarations &declarations)
{
  const Subsection section(declarations, "Layout");
  add(declarations,
      "Centre distance from",
      centre_distance_from,
      "Which of the four entries below determines the centre distance; the other three are not "
      "used. The plan prints the resulting distance.");
  add(declarations,
      "Centre distance in mm",
      centre_distance,
      unit::milli,
      between(1e-3, 100000.),
      "Distance of the shafts. A chain too short to be laid round them is refused with the "
      "numbers. Of more than two wheels it is that of the one which is found from the driver, and "
      "the search for others begins with it. Default: the drive in prm/paper with 0.5 mm of "
      "slack.");
  add(declarations,
      "Slack in mm",
      slack,
      unit::milli,
      between(0., 1000.),
      "Excess chain length over two straight spans, measured on the chain as laid, with its "
      "clearances taken up. More slack means less tension in the slack span and a softer start. "
      "Default: a drive adjusted almost tight.");
  add(declarations,
      "Sag in percent",
      sag,
      unit::percent,
      between(0., 10.),
      "Sag of the slack span at its middle over its length: with Start = settled in operation, "
      "otherwise as laid, before load and weight stretch the chain. Makers specify 1 to 3 percent, "
      "and less for steep or reversing drives.");
  add(declarations,
      "Pretension in N",
      pretension,
      unit::si,
      between(0., 1e6),
      "Tension at the middle of the spans at rest, the mean of the two, in place of slack: the "
      "drive starts in equilibrium with it, including the compliance of the chain on the "
      "sprockets. Keep it far below the working tension and well above the weight of a span; 0 "
      "lays both spans straight and unstressed. Start = settled keeps the centre distance found at "
      "rest.");
  add(declarations,
      "Worn chain",
      worn_chain,
      "Position of the shafts for a chain with Elongation in percent. adjusted: they have been "
      "readjusted, so slack or sag above are those of the worn chain. shafts kept: slack or sag "
      "above are those of the new chain; wear has added to its slack.");
  add(declarations,
      "Tight span",
      tight_span,
      "Which span pulls the driven sprocket. upper: both sprockets rotate counter-clockwise, the "
      "driver on the left. lower: everything is mirrored and they rotate clockwise; only gravity "
      "distinguishes the two.");
  add(declarations,
      "Start phase",
      start_phase,
      unit::si,
      from_to_below(0., 1.),
      "Rotation of the driver at the start, as a fraction of a tooth. Peak forces of single "
      "rollers depend on it by chance: average them over several phases.");
  add(declarations,
      "Start",
      start,
      "State of the chain at the start. taut: at rest, clearances taken up in the direction of "
      "pull. concentric: at rest, pins and bushes centred, so the drive first takes up the "
      "clearances and then jerks; layered fidelity only. settled: at full speed under full load, "
      "spans stretched, teeth and joints carrying their loads, in equilibrium with the load "
      "torque; saves the time of the ramp.");
}

void Drive::declare(Declarations &declarations)
{
  const Subsection section(declarations, "Drive");
  add(declarations,
      "Number of links",
      n_links,
      10,
      10000,
      "Inner plus outer links of the endless chain; even, unless it has an offset link, which only "
      "the simple fidelity has. auto: the even number whose length comes closest to Layout/Centre "
      "distance in mm; if that is given and not adjusted, or the centres of all wheels are given, "
      "the smallest that is long enough. Default: the drive in prm/paper.",
      "auto");
  add(declarations,
      "Driver teeth",
      sprockets.driver().teeth,
      9,
      500,
      "Teeth of the sprocket whose speed is prescribed. Below 17 the polygon effect grows quickly; "
      "the standard tooth forms end at 9. Default: the drive in prm/paper.")
      .sought = {"Drive/Wheels/driver/Teeth"};
  add(declarations,
      "Driven teeth",
      sprockets.driven().teeth,
      9,
      500,
      "Teeth of the sprocket that carries the load torque. Default: the drive in prm/paper.")
      .sought = {"Drive/Wheels/driven/Teeth"};
  sprockets.declare_wheels(declarations);
  chain.declare(declarations);
  sprockets.declare(declarations);
  layout.declare(declarations);
}

std::string Drive::places() const
{
  const auto &wheels = sprockets.list;
  if (std::any_of(
          wheels.begin() + 1, wheels.end(), [](const Sprocket &wheel) { return !wheel.centre; }))
    return "a centre distance of " + to_entry_text(layout.centre_distance, unit::milli) + " mm";
  const auto held = std::find_if(wheels.begin(), wheels.end(), [](const Sprocket &wheel) {
    return wheel.held.holder != Holder::bearing;
  });
  return "the centres of Drive/Wheels" +
         (held == wheels.end() ? "" : ", that of " + held->name + " without travel");
}
} // namespace chaindrive::parameters
