// SPDX-License-Identifier: LGPL-2.1-or-later
// Pressures in joints that pull a link whose joints have no penalty: the stress that it measures at
// its waists is what the section carries, to a percent, whichever of its sides is pressed and
// wherever along it; that of its natural modes alone is not.
#include "../support/ranges.h"
#include "../support/reduced.h"

#include <chaindrive/drive/chain.h>
#include <chaindrive/drive/plate.h>
#include <chaindrive/mesh/generate/links.h>
#include <chaindrive/observe/elastic_bodies.h>

#include <algorithm>
#include <functional>

using namespace test;

namespace
{
/// A pressure on the two sides from @p first on of a @p basis that pulls its ends apart, even in
/// the @p rings that count, N; 1 N in all.
reduction::Vector pull(const mesh::Nodes                        &nodes,
                       const reduction::Basis                   &basis,
                       const unsigned int                        first,
                       const std::function<bool(double height)> &counts)
{
  reduction::Vector force(3 * nodes.size());
  double            sum = 0.;
  for (unsigned int side = first; side < first + 2; ++side)
    {
      const reduction::RoundFlexibility &round = basis.joints[side];
      const double sign = nodes.position[round.node.front()][0] > 0. ? 1. : -1.;
      for (unsigned int i = 0; i < round.node.size(); ++i)
        {
          const double angle = 2. * dealii::numbers::PI * (i % round.n_columns) / round.n_columns;
          const double p     = std::max(0., sign * std::cos(angle));
          if (p == 0. || !counts(round.rings[i / round.n_columns]))
            continue;
          force[3 * round.node[i]] += p * std::cos(angle);
          force[3 * round.node[i] + 1] += p * std::sin(angle);
          sum += 0.5 * p * std::abs(std::cos(angle));
        }
    }
  force /= sum;
  return force;
}

void check(const std::string                       &what,
           const scene::Kind                        kind,
           const std::shared_ptr<const mesh::Part> &made,
           const double                             section)
{
  const mesh::Part &part  = *made;
  scene::Scene      scene = empty_scene();
  scene.half              = part.half;
  scene.parts[{kind}]     = made;
  reduction::BasisOptions options;
  options.modes_up_to      = 2. * dealii::numbers::PI * 120e3;
  options.orders.in_joints = options.orders.on_teeth = false;
  const reduction::Basis basis                       = basis_of(scene, part, options);
  scene.bases[{kind}] = std::make_shared<const reduction::Basis>(basis);
  observe::measure_waists(scene, MPI_COMM_SELF);
  const std::vector<double> &measure = scene.measures.at({kind})[0];
  const reduction::Vector    of_force(measure.begin(), measure.end());

  const mesh::Nodes          nodes(part);
  const observe::PlateStress plates(part, nodes, scene.material);
  const auto                 stress = [&](const reduction::Vector &u) {
    std::vector<Vector3> position;
    for (const unsigned int node : plates.nodes())
      {
        position.emplace_back(nodes.position[node]);
        for (unsigned int d = 0; d < 3; ++d)
          position.back()[d] += 1e-3 * u[3 * node + d];
      }
    return 1e3 * plates.components(position).axial;
  };
  const double share = part.half ? 1. : 0.5; // of the pull that the plate at z > 0 carries
  for (unsigned int first = 0; first < basis.joints.size(); first += 2)
    {
      const auto of = [&](const std::function<bool(double)> &counts) {
        return (of_force * pull(nodes, basis, first, counts)) * section / share;
      };
      const std::string side = mesh::surface_name(basis.joints[first].surface);
      range(what + ", " + side, of([](double) { return true; }), 0.99, 1.01);
      const double last = basis.joints[first].rings.back();
      range("  near the middle plane",
            of([last](const double z) { return std::abs(z) < 0.4 * last; }),
            0.99,
            1.01);
      const reduction::Vector force = pull(nodes, basis, first, [](double) { return true; });
      double                  sum   = 0.;
      for (unsigned int m = 0; m < basis.size(); ++m)
        sum +=
            stress(basis.modes[m]) * (basis.modes[m] * force) / (basis.omega[m] * basis.omega[m]);
      std::cout << "  of modes alone, by more than 4 % wrong: "
                << (std::abs(sum * section / share - 1.) > 0.04) << '\n';
    }
}
} // namespace

int main()
{
  const drive::ChainDimensions chain   = drive::make_chain(parameters::Chain());
  const double                 density = Material().density;
  const drive::Plate           inner = drive::inner_plate(chain), outer = drive::outer_plate(chain);
  for (const bool half : {false, true})
    {
      mesh::LinkGrid of_inner = mesh::inner_link_grid(0), of_outer = mesh::outer_link_grid(0);
      of_inner.half = of_outer.half = half;
      const std::string what        = half ? "half " : "";
      check(what + "inner link",
            scene::Kind::inner_link,
            std::make_shared<const mesh::Part>(mesh::make_inner_link(chain, density, of_inner)),
            inner.waist * inner.thickness);
      check(what + "outer link",
            scene::Kind::outer_link,
            std::make_shared<const mesh::Part>(mesh::make_outer_link(chain, density, of_outer)),
            outer.waist * outer.thickness);
    }
}
