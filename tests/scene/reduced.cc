// SPDX-License-Identifier: LGPL-2.1-or-later
// Scenes with reduced bodies: which bodies they are, that masses are those of their nodes, also of
// halves; that contact is that of full; and which parts have a basis.
#include "../support/scenes.h"

#include <chaindrive/mesh/mass.h>
#include <chaindrive/mesh/nodes.h>
#include <chaindrive/reduction/basis.h>
#include <chaindrive/scene/build.h>

#include <numeric>

using namespace test;
using parameters::Fidelity;
using scene::Motion;

namespace
{
Parameters drive_of(const Fidelity fidelity)
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
  // no shape is needed here but a name
  return scene::build_scene(p, drive::make_drive(p), {"."}, [](const mesh::Part &) {
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
} // namespace

int main()
{
  Parameters         p       = drive_of(Fidelity::reduced);
  const scene::Scene reduced = build(p), full = build(drive_of(Fidelity::full));
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

  p.model.elastic_links = parameters::ElasticLinks::arriving;
  p.output.window_start = 28e-3;
  show("reduced among rigid ones", build(p));

  p.model.fidelity    = Fidelity::full;
  p.model.other_links = parameters::OtherLinks::reduced;
  show("elastic among reduced ones", build(p));
}
