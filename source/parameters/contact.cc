// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/parameters/contact.h>
#include <chaindrive/parameters/entries.h>

namespace chaindrive::parameters
{
void Contact::declare(Declarations &declarations)
{
  const Subsection section(declarations, "Contact");
  add(declarations,
      "Roller-tooth stiffness in N/m",
      roller_tooth_stiffness,
      unit::si,
      above(0., 1e13),
      "Force over approach of roller and tooth. For a rigid roller this is physics, not numerics: "
      "the peak force of an impact grows with its square root. auto: a roller pressed between "
      "tooth and bush, up to its centre in layered and to the bush in simple fidelity, see "
      "Model/Stiffness from.");
  add(declarations,
      "Roller-bush stiffness in N/m",
      roller_bush_stiffness,
      unit::si,
      above(0., 1e13),
      "Force over approach of roller and bush; layered fidelity only. auto: a roller "
      "pressed between tooth and bush, see Model/Stiffness from.");
  add(declarations,
      "Tooth stiffness in N/m",
      tooth_stiffness,
      unit::si,
      above(0., 1e13),
      "Force over deflection of a tooth and the rim below it under an elastic roller, if "
      "Effects/Tooth compliance is on. auto: that of the elastic rim of each sprocket, pressed "
      "near the end of the seat; see Model/Stiffness from.");
  add(declarations,
      "Damping ratio",
      damping_ratio,
      unit::si,
      between(0., 1.),
      "Damping of a contact over the critical damping of its two bodies on its spring; it acts "
      "while they touch. With 0 a roller bounces 5 to 8 times when it meets a tooth, with 0.1 "
      "three to four times. On rollers that become ovals (Effects/Oval rollers) it counts half.");
  add(declarations,
      "Friction coefficient",
      friction_coefficient,
      unit::si,
      between(0., 2.),
      "Coulomb friction of every interface not named below. Dry steel has 0.1 to 0.3, a "
      "lubricated chain 0.05 to 0.12.");
  add(declarations,
      "Roller-tooth friction",
      roller_tooth_friction,
      unit::si,
      between(0., 2.),
      "Friction coefficient between rollers and teeth. It has little effect on lumped rollers, "
      "whose rings rotate on their bushes without friction. auto: the general coefficient.");
  add(declarations,
      "Roller-bush friction",
      roller_bush_friction,
      unit::si,
      between(0., 2.),
      "Friction coefficient between rollers and bushes; layered and full fidelity only. auto: the "
      "general coefficient.");
  add(declarations,
      "Bush-pin friction",
      bush_pin_friction,
      unit::si,
      between(0., 2.),
      "Friction coefficient in the joints, where the links articulate and wear occurs; layered and "
      "full fidelity only. auto: the general coefficient.");
  add(declarations,
      "Tangential ratio",
      tangential_ratio,
      unit::si,
      above(0., 1.),
      "Tangential over normal stiffness of a sticking contact. Two elastic half-spaces have 2 (1 - "
      "nu) / (2 - nu), which is 0.82 for steel. A smaller value allows a longer time step.");
  add(declarations,
      "Enforcement",
      enforcement,
      "How elastic bodies are kept from overlapping. auto: exact where it can be, in reduced "
      "fidelity with all links elastic; the plan says so. penalty: by stiff springs, see Penalty "
      "factor. exact joints: in reduced fidelity roller and bush, and bush and pin, do not overlap "
      "at all, and their walls deflect as their meshes do, which no penalty softens. What natural "
      "modes (Reduction/Modes up to in kHz, at least 110) lack of that "
      "flexibility has no inertia; joints have no contact damping. Rollers and teeth touch by "
      "penalty. exact: rollers and rigid teeth of arcs do not overlap either; they touch in narrow "
      "strips of the teeth, wherever the nodes of the rollers' meshes are.");
  add(declarations,
      "Penalty factor",
      penalty_factor,
      unit::si,
      above(0., 100.),
      "Penalty stiffness per area between elastic bodies, over the bulk modulus divided by the "
      "thickness of the elements below the surface; full fidelity only. Numerics, not physics: a "
      "larger value reduces penetration and shortens the critical time step.");
  add(declarations,
      "Plate faces",
      plate_faces,
      "Contact between the outer faces of inner plates and the inner faces of outer plates, around "
      "the joints and between elastic links. off: plates pass through each other. auto: on where "
      "wheels are out of line, else off, since nothing pushes the chain sideways; on shows whether "
      "something does, in full fidelity only.");
  add(declarations,
      "Side stiffness in N/m",
      side_stiffness,
      unit::si,
      above(0., 1e13),
      "Force over approach of a rigid plate and what it touches with its faces: the side of a "
      "tooth, another plate, the end of a roller; where wheels are out of line. Reduced plates, "
      "which bend by themselves, have faces four times as stiff; those of full fidelity follow "
      "from Penalty factor. Side forces follow from balance and hardly depend on it. auto: an "
      "inner plate that is clamped at its bushes and pressed in the middle.");
  add(declarations,
      "Oil viscosity in mPa s",
      oil_viscosity,
      unit::milli,
      between(0., 1e5),
      "Of the oil that fills the gaps between rollers and bushes and between rollers and teeth; "
      "layered fidelity only. It is squeezed out where they come together, which softens impacts, "
      "and does not pull where they part. 0: dry. Chain oils have 30 to 200 at the temperature of "
      "a running chain.");
  add(declarations,
      "Search",
      search,
      "When the contact search is repeated. displacement: after anything has moved far enough to "
      "matter; no contact is missed. every step: only to compare with programs that do so; gives "
      "the same results more slowly.");
}
} // namespace chaindrive::parameters
