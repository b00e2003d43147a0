// SPDX-License-Identifier: LGPL-2.1-or-later
// An inner link that is stretched and let go, with plates that bend out of their planes and with
// plates that do not: these keep their middle surfaces where they are, become thinner as plane
// stress asks, -nu / (1 - nu) times what they gain in their plane, and lose no energy by it.
#include "../support/scenes.h"

#include <chaindrive/drive/drive.h>
#include <chaindrive/mesh/generate/links.h>
#include <chaindrive/mesh/part.h>

#include <algorithm>
#include <cmath>

using namespace test;

namespace
{
/// The two nodes on the axis of a plate's waist at z > 0, the lower one first, and those beside
/// them along x and y.
struct Waist
{
  explicit Waist(const BodyBatches &copies, const drive::ChainDimensions &chain)
  {
    const auto nearest = [&](const double x, const double y, const double z) {
      const auto distance = [&](const unsigned int n) {
        return (dealii::Tensor<1, 3>(copies.nodes.position[n]) - test::vector(x, y, z)).norm();
      };
      unsigned int best = 0;
      for (unsigned int n = 1; n < copies.n_nodes(); ++n)
        if (distance(n) < distance(best))
          best = n;
      return best;
    };
    const double z = chain.inner_plate_z, half = 0.5 * chain.inner_plate_thickness;
    inner = nearest(0., 0., z - half);
    outer = nearest(0., 0., z + half);
    for (const double sign : {-1., 1.})
      {
        along.push_back(nearest(sign * 1.5e-3, 0., z - half));
        across.push_back(nearest(0., sign * 1.5e-3, z - half));
      }
  }

  unsigned int              inner, outer;
  std::vector<unsigned int> along, across;
};

void stretch(const bool plates_bend)
{
  Parameters parameters;
  const auto drive = drive::make_drive(parameters);
  const auto part  = std::make_shared<const mesh::Part>(
      mesh::make_inner_link(drive.chain, parameters.material.density, mesh::inner_link_grid(1)));

  scene::Scene scene = empty_scene();
  scene.plates_bend  = plates_bend;
  scene.bodies.push_back(
      body(scene::Motion::elastic, scene::Mount::free(), part->meshed.mass, Vector3(), Vector3()));
  scene.bodies.back().kind             = scene::Kind::inner_link;
  scene.parts[scene::Kind::inner_link] = part;
  scene.material                       = parameters.material;
  dynamics::System system(scene, false);
  BodyBatches     &copies = system.world.copies[0];
  const Waist      waist(copies, drive.chain);
  for (unsigned int n = 0; n < copies.n_nodes(); ++n) // 0.1 % over a millisecond
    NodeView(copies.velocity)
        .set(copies.index(0, n), test::vector(1e2 * copies.nodes.position[n][0], 0.));

  const double distance_along =
      copies.nodes.position[waist.along[1]][0] - copies.nodes.position[waist.along[0]][0];
  const double distance_across =
      copies.nodes.position[waist.across[1]][1] - copies.nodes.position[waist.across[0]][1];
  double energy       = 0.; // after the first step
  double out_of_plane = 0., product = 0., square = 0., error = 0.;
  advance(system, 2000, 0.8 * system.critical_time_step(), [&] {
    const auto moved = [&](const unsigned int n) { return copies.displacement_now(0, n); };
    const auto thick =
        (moved(waist.outer) - moved(waist.inner))[2] / drive.chain.inner_plate_thickness;
    const auto plane = (moved(waist.along[1]) - moved(waist.along[0]))[0] / distance_along +
                       (moved(waist.across[1]) - moved(waist.across[0]))[1] / distance_across;
    out_of_plane =
        std::max(out_of_plane, std::abs((moved(waist.outer) + moved(waist.inner))[2]) / 2.);
    product += thick * plane;
    square += plane * plane;
    if (energy == 0.)
      energy = system.world.ledger.stored();
    error = std::max(error, std::abs(system.world.ledger.stored() - energy) / energy);
  });
  const double nu = parameters.material.poissons_ratio;
  std::cout << (plates_bend ? "plates bend" : "plates do not bend") << ":\n";
  if (plates_bend)
    verdict("  middle surfaces leave their planes by more than a micrometre", out_of_plane > 1e-6);
  else
    verdict("  middle surfaces stay in their planes but for round-off", out_of_plane < 1e-15);
  const double ratio = product / square / (-nu / (1. - nu));
  std::cout << "  thickness over that of plane stress " << std::setprecision(3) << ratio << '\n';
  verdict("  energy stays to a thousandth", error < 1e-3);
}
} // namespace

int main()
{
  stretch(true);
  stretch(false);
}
