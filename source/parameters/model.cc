// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/parameters/drive.h>
#include <chaindrive/parameters/entries.h>
#include <chaindrive/parameters/model.h>

namespace chaindrive::parameters
{
void Model::declare(Declarations &declarations)
{
  const Subsection section(declarations, "Model");
  add_choice(declarations,
             "Fidelity",
             fidelity,
             fidelities(),
             "Which bodies the chain is made of." + fidelities_in_words(),
             [this](const std::string &name) { fidelity = name; });
  add(declarations,
      "Symmetry model",
      half,
      "Symmetry model: computes only the halves of all bodies on one side of the chain's middle "
      "plane, which is a plane of symmetry as long as nothing pushes the chain sideways; full "
      "fidelity only. Forces, masses and energies are reported for whole bodies. Costs half as "
      "much. auto: true where links and rollers are elastic, all or those in the region of "
      "interest, plates do not touch and no fields are requested, which show whole bodies.");
  add(declarations,
      "Mass per pitch in g",
      mass_per_pitch,
      unit::milli,
      above(0., 1e6),
      "Mass of one strand of the chain per pitch; a catalogue's kg/m times the pitch in mm. auto: "
      "from Mass from.");
  add(declarations,
      "Mass from",
      mass_from,
      "Source of the mass of the chain. catalogue: the kg/m of makers' tables, where they list the "
      "chain and it has no dimensions of its own; what the solids of the model lack, such as ends "
      "of pins and bushes outside of the plates, comes to the density of plates, bushes and pins, "
      "not of rollers, by one factor that the plan names. dimensions: volumes of the parts and the "
      "density, also of chains that are not listed.");
  add(declarations,
      "Stiffness per pitch in N/m",
      stiffness_per_pitch,
      unit::si,
      above(0., 1e13),
      "Force over elongation of one pitch in a tensile test, plates and joint in series. Best "
      "taken from a test: how the plates clamp pin and bush changes it by a factor of five. It "
      "determines the resonance of the driven inertia on the tight span. In full fidelity it is "
      "that of rigid links (Elastic links = region of interest) and of the spans at a settled "
      "start. auto: from Stiffness from, at the tension required by the load.");
  add(declarations,
      "Stiffness from",
      stiffness_from,
      "Source of stiffnesses that are auto: those of a pitch, of roller and tooth, of roller and "
      "bush. parts: elastic solutions of the links, the roller and the teeth, computed in a few "
      "seconds and cached for later runs in CHAINDRIVE_CACHE, XDG_CACHE_HOME/chaindrive or "
      "~/.cache/chaindrive. dimensions: formulas, immediate; errors of 10 to 30 percent.");
  add(declarations,
      "Driven inertia in kg m2",
      driven_inertia,
      unit::si,
      above(0., 1e9),
      "Moment of inertia of everything that rotates with the driven sprocket, or of what is behind "
      "its coupling. Give it whenever a machine is coupled to it. auto: the sprocket alone.")
      .sought = {"Drive/Wheels/driven/Inertia in kg m2"};
  add(declarations,
      "Chain damping ratio",
      chain_damping_ratio,
      unit::si,
      between(0., 1.),
      "Damping of the chain's bars over the critical damping of two neighbouring lumped masses on "
      "their bar; simple fidelity only, since joint contact damps the layered chain. Default: "
      "steel structures with bolted joints have 0.5 to 3 percent.");
  add(declarations,
      "Elastic links",
      elastic_links,
      "Which links and rollers are elastic, or deform in modes in reduced fidelity, if "
      "Effects/Elastic links and Elastic rollers are on. region of interest: those that reach the "
      "driver between Output/Window start in ms and Window end in ms, and two more before and "
      "after them; all others, and both sprockets, are rigid as in layered fidelity. For the loads "
      "on single links as they engage, at a fraction of the cost.");
  add(declarations,
      "Other links",
      other_links,
      "Model of the links and rollers outside the region of interest, with Elastic links = region "
      "of interest. rigid: as in layered fidelity. reduced: as in reduced fidelity, so their "
      "joints are those of the elastic ones; costs more.");
  add(declarations,
      "Elastic sprockets",
      elastic_sprockets,
      "Both Effects/Elastic driver and Elastic driven, where they are auto. off: both sprockets "
      "are rigid. auto: as these say.");
}

void Material::declare(Declarations &declarations)
{
  const Subsection section(declarations, "Material");
  add(declarations,
      "Young's modulus in GPa",
      youngs_modulus,
      unit::giga,
      between(1e-3, 10000.),
      "Young's modulus of all parts, from which stiffnesses that are auto follow. Default: steel, "
      "as in prm/paper.");
  add(declarations,
      "Poisson's ratio",
      poissons_ratio,
      unit::si,
      from_to_below(0., 0.5),
      "Lateral contraction over axial strain. Default: steel.");
  add(declarations,
      "Density in kg/m3",
      given_density,
      unit::si,
      between(1., 100000.),
      "Density of all parts, from which masses and inertias that are auto follow. auto: 7850, of "
      "carbon steel; with the chain 525 7600, the value of the drive in prm/paper, of which that "
      "chain is.");
}

void Material::resolve(const std::string &designation)
{
  constexpr double carbon_steel = 7850.;
  density = given_density.value_or(designation == reference_chain ? chaindrive::Material().density :
                                                                    carbon_steel);
}

void Elements::declare(Declarations &declarations)
{
  const Subsection section(declarations, "Elements");
  add(declarations,
      "Formulation",
      formulation,
      "Formulation of the elastic hexahedra; full fidelity only. enhanced: one point and an "
      "hourglass stiffness that reproduces beam bending, correct with one element through a wall. "
      "one point: the hourglass stiffness of Flanagan and Belytschko, faster, for walls of three "
      "elements and more. full: 2 x 2 x 2 points, too stiff in bending where elements are flat.");
  add(declarations,
      "Hourglass coefficient",
      hourglass_coefficient,
      unit::si,
      between(1e-3, 1.),
      "Hourglass stiffness of one point, after Flanagan and Belytschko; much less than the default "
      "does not prevent hourglassing.");
  add(declarations,
      "Selective mass scaling",
      selective_mass_scaling,
      unit::si,
      between(0., 10.),
      "Selective mass scaling of elastic rollers with several elements through the thickness: mass "
      "added to through-thickness motion only, over that of an element. It allows a longer time "
      "step: with 0.5 the period of the through-thickness vibration is 1.7 times as long, the "
      "roller's inertia about its axis grows by half a percent and the frequency of its "
      "ovalisation falls by half a percent. 0: none.");
  const std::string walls =
      " solid: solid elements as in Formulation. solid-shell: solid-shells with nodes on both "
      "faces, free of locking where they are curved, flat or distorted; one through the thickness. "
      "membrane: the same with one point through the thickness, as in the paper, with only a "
      "hundredth of the bending stiffness.";
  add(declarations, "Plates", plates, "Elements of side plates." + walls);
  add(declarations, "Bushes", bushes, "Elements of bushes." + walls);
}

void Reduction::declare(Declarations &declarations)
{
  const Subsection section(declarations, "Reduction");
  add(declarations,
      "Modes up to in kHz",
      modes_up_to,
      unit::kilo,
      between(0., 1e9),
      "Reduced bodies have all natural modes of their parts up to this frequency. auto: 120 where "
      "joints have no penalty, for a pitch below 15.875 mm in inverse proportion to it, else 60.");
  add(declarations,
      "Highest frequency in kHz",
      highest,
      unit::kilo,
      above(0., 1e9),
      "Frequency cap of the attachment modes, which give reduced bodies the compliance of their "
      "parts under pressure and friction on their contact surfaces. Faster modes get this "
      "frequency, with unchanged compliance. It limits the time step.");
  add(declarations,
      "Highest frequency of links in kHz",
      fastest_of_links,
      unit::kilo,
      above(0., 1e9),
      "All modes of links that are faster, natural ones and others, get this frequency, with "
      "unchanged compliance. Motions far below it do not notice the mass that this adds, and the "
      "time step may be longer. auto: 80 where joints have no penalty, for a pitch below "
      "15.875 mm in inverse proportion to it, else no such limit.");
  add(declarations,
      "Highest frequency of rollers in kHz",
      fastest_of_rollers,
      unit::kilo,
      above(0., 1e9),
      "Natural modes of rollers that are faster get this frequency and so much less of their "
      "compliance that slow motions meet the same inertia; the rest deflects without inertia. It "
      "needs joints and teeth without penalty. The time step may be longer. auto: 90, for a pitch "
      "below 15.875 mm in inverse proportion to it.");
  add(declarations,
      "Harmonics of rollers and bushes",
      tube_order,
      1,
      12,
      "Pressures around rollers and bushes for attachment modes are cosines and sines of up to "
      "this number of waves, as long as the mesh has more than two cells per wave.");
  add(declarations, "Harmonics of pins", pin_order, 1, 12, "The same for pressures on pins.");
}

namespace
{
void declare_link(Declarations      &declarations,
                  const std::string &name,
                  const std::string &tube,
                  const std::string &without_penalty,
                  Mesh::Link        &link)
{
  const Subsection section(declarations, name);
  add(declarations, "Cells around", link.around, 8, 400, "Around each hole; a multiple of four.");
  add(declarations, "Cells through wall", link.wall, 1, 20, "Through the wall of a " + tube + ".");
  add(declarations, "Rings in plate", link.rings, 1, 40, "Between a hole and the plate's edge.");
  add(declarations,
      "Cells through plate",
      link.plate_layers,
      1,
      20,
      "Through the plate's thickness.");
  add(declarations,
      "Cells along",
      link.along,
      2,
      200,
      "Along a " + tube +
          " between the plates; even. Where joints have no penalty, auto is at least " +
          without_penalty + ".");
}
} // namespace

void Mesh::declare(Declarations &declarations)
{
  const Subsection section(declarations, "Mesh");
  add(declarations,
      "Refinement",
      refinement,
      0,
      4,
      "Refinement of the part meshes; each level about halves the cell edges. Rigid and lumped "
      "bodies need meshes for field output only: their contact, mass and inertia are exact at "
      "every level, and one cell reaches across the chain where no entry asks for more. The "
      "entries of the subsections change single numbers of cells; auto: those of the refinement.");
  {
    const Subsection roller(declarations, "Roller");
    add(declarations, "Cells through wall", roller_wall, 1, 20, "Through the wall of a roller.");
    add(declarations,
        "Cells around",
        roller_around,
        8,
        400,
        "Around a roller; a multiple of four.");
    add(declarations, "Cells along", roller_along, 2, 200, "Along a roller; even.");
  }
  declare_link(declarations,
               "Inner link",
               "bush",
               "6, and one cell on either side reaches from the roller's end to the plate",
               inner_link);
  declare_link(declarations,
               "Outer link",
               "pin",
               "8, and one cell on either side reaches from the bush's end to the plate",
               outer_link);
  {
    const Subsection sprockets(declarations, "Sprockets");
    add(declarations, "Refinement", sprocket_refinement, 0, 4, "Of generated sprockets.");
  }
}
} // namespace chaindrive::parameters
