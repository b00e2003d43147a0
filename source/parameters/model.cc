// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/parameters/entries.h>
#include <chaindrive/parameters/model.h>

namespace chaindrive::parameters
{
void Model::declare(dealii::ParameterHandler &prm)
{
  const Subsection section(prm, "Model");
  add(prm,
      "Fidelity",
      fidelity,
      {"simple", "layered", "full"},
      "Which bodies the chain is made of. simple: lumped rollers joined by elastic bars, for "
      "tensions, speeds and a first look. layered: rollers, inner and outer links as rigid bodies "
      "with their clearances, for contact forces and the motion of single rollers; costs about "
      "four times as much. full: the same bodies made of elastic finite elements, for what their "
      "deformation does; costs a thousand times as much. Experimental: no preset has been "
      "validated yet.");
  add(prm,
      "Mass per pitch in g",
      mass_per_pitch,
      unit::milli,
      above(0., 1e6),
      "Mass of the chain per pitch; a catalogue's kg/m times the pitch in mm. auto: from the "
      "volumes of the parts and the density.");
  add(prm,
      "Stiffness per pitch in N/m",
      stiffness_per_pitch,
      unit::si,
      above(0., 1e13),
      "Force over elongation of one pitch in a pull test, plates and joint in series. Best taken "
      "from a test: how plates hold pin and bush changes it by a factor of five. It sets the "
      "resonance of the driven inertia on the tight span. auto: plates and joint contact, from "
      "their dimensions.");
  add(prm,
      "Driven inertia in kg m2",
      driven_inertia,
      unit::si,
      above(0., 1e9),
      "Moment of inertia of all that turns with the driven sprocket. Give it whenever a machine "
      "is coupled to it. auto: the sprocket alone.");
  add(prm,
      "Chain damping ratio",
      chain_damping_ratio,
      unit::si,
      between(0., 1.),
      "Damping of the chain's bars over the critical damping of two neighbouring lumps on their "
      "bar; simple fidelity only, since the joints' contact damps the layered chain. Default: "
      "steel structures with bolted joints have 0.5 to 3 percent.");
  add(prm,
      "Elastic sprockets",
      elastic_sprockets,
      {"auto", "on", "off"},
      "Whether the rims of the sprockets, from the hub diameter outwards, are elastic; full "
      "fidelity only. Imported sprockets are rigid. auto: on in full fidelity but for imported "
      "sprockets. off: both sprockets are rigid.");
}

void Material::declare(dealii::ParameterHandler &prm)
{
  const Subsection section(prm, "Material");
  add(prm,
      "Young's modulus in GPa",
      youngs_modulus,
      unit::giga,
      above(0., 10000.),
      "Modulus of elasticity of all parts, from which stiffnesses that are auto follow. Default: "
      "steel, as in prm/paper.");
  add(prm,
      "Poisson's ratio",
      poissons_ratio,
      unit::si,
      from_to_below(0., 0.5),
      "Lateral contraction over extension. Default: steel.");
  add(prm,
      "Density in kg/m3",
      density,
      unit::si,
      above(0., 100000.),
      "Density of all parts, from which masses and inertias that are auto follow. Default: the "
      "value of the drive in prm/paper; most steels have 7800 to 7900.");
}

void Elasticity::declare(dealii::ParameterHandler &prm)
{
  const Subsection section(prm, "Elements");
  add(prm,
      "Formulation",
      formulation,
      {"one point", "enhanced", "full"},
      "How the elastic hexahedra are integrated; full fidelity only. enhanced: one point and a "
      "stiffness against hourglassing that bends as a beam does, right with one element through a "
      "wall. one point: the hourglass stiffness of Flanagan and Belytschko, faster, for walls of "
      "three elements and more. full: 2 x 2 x 2 points, too stiff in bending where elements are "
      "flat.");
  add(prm,
      "Hourglass coefficient",
      hourglass_coefficient,
      unit::si,
      between(0., 1.),
      "Stiffness against hourglassing of one point, after Flanagan and Belytschko.");
}

void Mesh::declare(dealii::ParameterHandler &prm)
{
  const Subsection section(prm, "Mesh");
  add(prm,
      "Refinement",
      refinement,
      0,
      4,
      "How fine the meshes of the parts are; each level about halves the cells' edges. Rigid and "
      "lumped bodies need meshes for pictures only: their contact, mass and inertia are exact at "
      "every level.");
}
} // namespace chaindrive::parameters
