// SPDX-License-Identifier: LGPL-2.1-or-later
// Scenes with reduced bodies: which bodies they are, that masses are those of their nodes, also of
// halves; that contact is that of full; which parts have a basis; and which teeth deflect.
#include "../support/decided.h"
#include "../support/scenes.h"

#include <chaindrive/mesh/mass.h>
#include <chaindrive/mesh/nodes.h>
#include <chaindrive/reduction/basis.h>
#include <chaindrive/utilities/errors.h>

#include <numeric>

using namespace test;
using scene::Motion;

namespace
{
Parameters drive_of(const std::string &fidelity)
{
  Parameters p;
  p.model.fidelity        = fidelity;
  p.model.stiffness_from  = parameters::StiffnessFrom::dimensions;
  p.mesh.refinement       = 1;
  p.output.field_interval = 0.;
  return p;
}

scene::Scene build(const Parameters &p)
{
  // no mode is needed here but a name
  return scene_of(p, [](const mesh::Part &) {
    reduction::Basis basis;
    basis.omega = {1.};
    return std::make_shared<const reduction::Basis>(basis);
  });
}

void show(const std::string &what, const scene::Scene &scene)
{
  std::map<Motion, unsigned int> number;
  for (const scene::Body &body : scene.bodies)
    ++number[body.motion];
  std::cout << what << ": rigid " << number[Motion::rigid] << ", reduced "
            << number[Motion::reduced] << ", elastic " << number[Motion::elastic] << ", bases "
            << scene.bases.size() << (scene.half ? ", half" : "") << '\n';
  for (const scene::BoreFamily &bores : scene.bores)
    std::cout << "  " << bores.name << (bores.elastic ? ", nodes: " : ", points: ")
              << bores.pairs.size() << '\n';
  for (const scene::ToothFamily &teeth : scene.teeth)
    std::cout << "  " << teeth.name << (teeth.elastic ? ", nodes: " : ", points: ")
              << teeth.slaves.size() << '\n';
}

/// Largest relative difference between bodies and sums over their nodes.
double error_of_masses(const scene::Scene &scene)
{
  double largest = 0.;
  for (const scene::Body &body : scene.bodies)
    if (body.motion == Motion::reduced)
      {
        const mesh::Part &part = *scene.parts.at(body.part());
        const mesh::Nodes nodes(part);
        const double      whole = part.half ? 2. : 1.;
        double            mass = 0., about_z = 0.;
        for (unsigned int n = 0; n < nodes.size(); ++n)
          {
            const dealii::Point<3> &x = nodes.position[n];
            mass += whole * nodes.mass[n];
            about_z += whole * nodes.mass[n] * (x[0] * x[0] + x[1] * x[1]);
          }
        largest = std::max(
            {largest, std::abs(body.mass / mass - 1.), std::abs(body.inertia[2] / about_z - 1.)});
      }
  return largest;
}

/// The stiffness of teeth as a whole under the rollers of each family, and per area that of the
/// contact with those that deform.
void show_teeth(const std::string &what, const Parameters &p)
{
  std::cout << what << ": teeth, kN/mm";
  const scene::Scene scene = build(p);
  for (const scene::ToothFamily &teeth : scene.teeth)
    std::cout << ' ' << 1e-6 * teeth.tooth_stiffness;
  std::cout << ", contact, N/mm3" << std::setprecision(4);
  for (const scene::ToothFamily &teeth : scene.teeth)
    if (teeth.elastic)
      std::cout << ' ' << 1e-9 * teeth.law.stiffness;
  std::cout << (scene.effects.is_on(model::Effect::tooth_compliance) ? ", on\n" : ", off\n");
}

void check_teeth()
{
  using parameters::Switch;
  Parameters p              = drive_of("reduced");
  p.contact.tooth_stiffness = 3e8;
  p.model.half              = parameters::SymmetryModel::no;
  show_teeth("reduced, without penalty", p); // a penalty has half of the compliance
  p.contact.enforcement = parameters::Enforcement::penalty;
  show_teeth("reduced", p);
  p.model.half = parameters::SymmetryModel::yes;
  show_teeth("halves", p);
  p.model.half               = parameters::SymmetryModel::automatic;
  p.effects.tooth_compliance = Switch::off;
  show_teeth("switched off", p);
  p.effects.tooth_compliance = Switch::automatic;
  p.model.elastic_links      = parameters::ElasticLinks::region_of_interest;
  p.output.window_start      = 28e-3;
  show_teeth("reduced rollers, then rigid ones", p);
  p.model.elastic_links              = parameters::ElasticLinks::all;
  p.model.fidelity                   = "full";
  p.drive.sprockets.driven().elastic = Switch::off;
  p.model.half                       = parameters::SymmetryModel::no;
  show_teeth("full, rigid driven sprocket", p);
  p.effects.tooth_compliance = Switch::on;
  show_teeth("switched on", p);
  p.contact.tooth_stiffness.reset();
  ratio("from dimensions, against the half-space of a tooth",
        0.5 * build(p).teeth[1].tooth_stiffness, // half of the compliance is that of the surface
        0.25 * dealii::numbers::PI * p.material.plane_modulus() *
            drive::make_drive(p).chain.roller_length);
  p.contact.tooth_stiffness = 1e5;
  try
    {
      build(p);
    }
  catch (const InputError &error)
    {
      std::cout << error.what() << '\n';
    }
}
} // namespace

int main()
{
  Parameters         p       = drive_of("reduced");
  const scene::Scene reduced = build(p), full = build(drive_of("full"));
  show("reduced, all outputs", reduced);
  std::cout << "error of masses below 1e-12: " << (error_of_masses(reduced) < 1e-12) << '\n';
  ratio("stiffness of contact in joints over that of full",
        reduced.bores[0].law.stiffness,
        full.bores[0].law.stiffness,
        9);

  p.output.quantities     = {parameters::QuantityGroup::engagements};
  const scene::Scene half = build(p);
  show("reduced, engagements only", half);
  std::cout << "error of masses below 1e-12: " << (error_of_masses(half) < 1e-12) << '\n';

  p.model.elastic_links = parameters::ElasticLinks::region_of_interest;
  p.output.window_start = 28e-3;
  show("reduced among rigid ones", build(p));

  p.model.fidelity    = "full";
  p.model.other_links = parameters::OtherLinks::reduced;
  show("elastic among reduced ones", build(p));
  check_teeth();
}
