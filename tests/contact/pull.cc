// SPDX-License-Identifier: LGPL-2.1-or-later
// An inner and an outer link, joined by a bush on a pin, are pulled: the explicit run, with drag,
// under eight loads that rise slowly, comes to rest where the assembled stiffnesses and the contact
// are in equilibrium (support/statics.h). The bore of the first bush is held; the load acts on the
// bore of the last pin. Force and extension are compared; the stiffness per pitch, which becomes
// larger with the load as the contact widens, is for information: plates alone have 145 kN/mm with
// open holes, pins that bend and the joint are in series with them.
#include "../support/joint_statics.h"

#include <chaindrive/drive/plate.h>
#include <chaindrive/mesh/generate/links.h>

using namespace test;

namespace
{
/// One of the two links with the part of it that is held or pulled.
struct Link
{
  Link(const mesh::Part   &part,
       const mesh::Surface side,
       const double        hole_x,
       const double        bore,
       const double        at)
      : tubes(part, side), at(at)
  {
    for (unsigned int node = 0; node < tubes.reference.n_nodes(); ++node)
      {
        const Point<3> &x = tubes.reference.position[node];
        end.push_back(std::abs(std::hypot(x[0] - hole_x, x[1]) - 0.5 * bore) < 1e-9);
        n_end += end.back();
      }
    for (int lane = 0; lane < n_lanes; ++lane)
      place(lane);
  }

  void place(const unsigned int lane)
  {
    tubes.batch.set(tubes.batch.position, lane, [&](const Point<3> &x, unsigned int) {
      return x + vector(at, 0.);
    });
  }

  /// Planes of symmetry stay where they are.
  bool symmetric(const unsigned int node, const unsigned int i) const
  {
    return i > 0 && std::abs(tubes.reference.position[node][i]) < 1e-9;
  }

  /// Mean displacement of the end along x, m.
  double moved(const unsigned int lane) const
  {
    double sum = 0.;
    for (unsigned int node = 0; node < end.size(); ++node)
      if (end[node])
        sum += tubes.batch.get(tubes.batch.position, node, lane)[0] - at -
               tubes.reference.position[node][0];
    return sum / n_end;
  }

  Tubes             tubes;
  double            at; ///< x at the start, m
  std::vector<bool> end;
  unsigned int      n_end = 0;
};
} // namespace

int main()
{
  const parameters::Material material;
  const auto                 chain = drive::make_chain(parameters::Chain());
  const mesh::Part           inner_part =
                       mesh::make_inner_link(chain, material.density, mesh::inner_link_grid(0)),
                   outer_part =
                       mesh::make_outer_link(chain, material.density, mesh::outer_link_grid(0));
  const double inner_half = 0.5 * chain.inner_hole_pitch, outer_half = 0.5 * chain.outer_hole_pitch;
  Link         inner(inner_part, mesh::bush_bore_second, -inner_half, chain.bush_bore, 0.);
  Link         outer(outer_part,
             mesh::pin_outside_first,
             outer_half,
             chain.pin_bore,
             inner_half + chain.pin_clearance() + outer_half);

  const double stiffness =
      material.youngs_modulus / (0.5 * (chain.bush_diameter - chain.bush_bore));
  const auto load = [](const unsigned int lane) { return 250. * (lane + 1); }; // N

  const contact::JointTables tables(inner.tubes.grid, outer.tubes.grid);
  contact::JointBatch        joints(
      tables, {stiffness, 0., 0., 0., 0.}, *contact::joint_kernels(element::best_kernels().width));
  for (int lane = 0; lane < n_lanes; ++lane)
    joints.set_joint(lane, inner.tubes.body(lane), outer.tubes.body(lane));
  const double dt = 0.5 * 2. /
                    std::max(inner.tubes.reference.largest_frequency(),
                             outer.tubes.reference.largest_frequency());
  const double rise = 0.2e-3, drag = 1e5;
  for (double t = 0.; t < 2. * rise; t += dt)
    {
      if (joints.search_due(dt))
        joints.search(5e-6, 0.5);
      const double part = t < rise ? 0.5 - 0.5 * std::cos(PI * t / rise) : 1.;
      for (Link *link : {&inner, &outer})
        link->tubes.batch.add_internal_forces();
      joints.add_forces(t > 0. ? dt : 0., dt);
      for (Link *link : {&inner, &outer})
        {
          Batch &batch = link->tubes.batch;
          for (unsigned int node = 0; node < link->end.size(); ++node)
            for (unsigned int i = 0; i < 3; ++i)
              for (int lane = 0; lane < n_lanes; ++lane)
                {
                  double &f = batch.force[Batch::index(node, i, lane)];
                  if (link->symmetric(node, i) || (link == &inner && link->end[node]))
                    f = 0.;
                  else if (link == &outer && link->end[node] && i == 0)
                    f += part * load(lane) / link->n_end;
                }
          batch.update(dt, drag);
        }
    }
  std::array<double, n_lanes> extension{}, force{};
  for (int lane = 0; lane < n_lanes; ++lane)
    {
      extension[lane] = outer.moved(lane);
      force[lane]     = -joints.sums().force[0][lane]; // on the outer link
    }

  for (const int lane : {1, 3, 7})
    {
      inner.place(0);
      outer.place(0);
      JointAtRest joint(inner.tubes, outer.tubes, stiffness);
      Statics    &statics = joint.statics;
      for (unsigned int b = 0; b < 2; ++b)
        for (unsigned int i = statics.first[b]; i < statics.first[b + 1]; ++i)
          {
            const Link        &link = b == 0 ? inner : outer;
            const unsigned int node = (i - statics.first[b]) / 3, d = (i - statics.first[b]) % 3;
            statics.held[i] = link.symmetric(node, d) || (b == 0 && link.end[node]);
            if (b == 1 && d == 0)
              {
                statics.u[i] = 2e-6;
                if (link.end[node])
                  statics.load[i] = load(lane) / link.n_end;
              }
          }
      const bool   found = joint.solve([&](const Point<3> &x) { return x[0] > inner_half; }, 1e-6);
      const double at_rest = outer.moved(0);
      std::cout << "pull " << load(lane) << " N, at rest: " << (found ? "yes" : "NO") << std::fixed
                << std::setprecision(3) << "; of the static solution: force "
                << force[lane] / joint.force() << ", extension " << extension[lane] / at_rest
                << "; stiffness per pitch " << std::setprecision(0) << 2e-6 * load(lane) / at_rest
                << " kN/mm\n"
                << std::defaultfloat;
    }
}
