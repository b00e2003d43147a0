// SPDX-License-Identifier: LGPL-2.1-or-later
// Which nodes of an elastic rim must come from other ranks: wherever a roller is and its nodes are
// when it has moved by the margin, all nodes and twins of the facets that they are projected on
// belong to the gaps that were said to be near; and few gaps are.
#include "../support/tooth.h"

#include <chaindrive/bodies/make_world.h>

#include <random>

using namespace test;

namespace
{
void check(const std::string &name, const Sprocket sprocket)
{
  Tooth tooth;
  tooth.sprocket            = sprocket;
  tooth.turned              = 0.7;
  const scene::Scene scene  = make_scene(tooth);
  World              world  = make_world(scene);
  const BodyBatches &copies = world.copies[world.rims[0].group];
  const auto         made   = contact::make_flanks(scene.teeth[0], world);
  const auto        &flanks = dynamic_cast<const contact::ElasticFlanks &>(*made);
  const double       radius = scene.teeth[0].slaves[0].radius, outer = scene.teeth[0].outer_radius;
  constexpr double   margin = 0.5e-3;

  std::vector<std::set<std::size_t>> in_gap(scene.teeth[0].teeth);
  std::set<std::size_t>              all;
  for (unsigned int gap = 0; gap < in_gap.size(); ++gap)
    for (const BodyBatches::Place &place : flanks.nodes_of_gap(gap))
      {
        in_gap[gap].insert(copies.index(place.copy, place.node));
        all.insert(copies.index(place.copy, place.node));
      }
  const mesh::SurfaceNodes side(*copies.part, copies.nodes, mesh::tooth_flanks);
  verdict(name + ": all nodes of the flanks are in gaps",
          all.size() == std::size_t(side.size()) * copies.n_copies());

  std::mt19937                           random(1);
  std::uniform_real_distribution<double> share(0., 1.);
  const auto                             within_disc = [&](const double of) {
    const double r     = of * std::sqrt(share(random)),
                 angle = 2. * dealii::numbers::PI * share(random);
    return vector(r * std::cos(angle), r * std::sin(angle));
  };
  unsigned int           found = 0, unforeseen = 0, n_gaps = 0;
  constexpr unsigned int n_rollers = 200, n_points = 50;
  for (unsigned int i = 0; i < n_rollers; ++i)
    {
      const double  angle  = 2. * dealii::numbers::PI * share(random);
      const double  from   = outer - 1.2 * radius + 3. * radius * share(random);
      const Vector3 centre = vector(from * std::cos(angle), from * std::sin(angle));
      const auto    gaps   = flanks.gaps_near(world, centre, radius, margin);
      n_gaps += gaps.size();
      std::set<std::size_t> near;
      for (const unsigned int gap : gaps)
        near.insert(in_gap[gap].begin(), in_gap[gap].end());
      for (unsigned int k = 0; k < n_points; ++k)
        {
          const bool    is_centre = k == 0; // of a rigid roller
          const Vector3 moved     = centre + within_disc(margin);
          Vector3       x         = is_centre ? moved : moved + within_disc(radius);
          x[2]                    = 4e-3 * share(random);
          contact::Surface::Projection projection;
          unsigned int                 hint = mesh::Projection::no_facet;
          flanks.project(world, x, 0., is_centre ? 2. * radius : 0.5 * radius, hint, projection);
          if (projection.weights == std::array<double, 4>())
            continue;
          ++found;
          bool foreseen = true;
          for (unsigned int n = 0; n < 4; ++n)
            foreseen = foreseen && near.count(projection.nodes[n]) == 1 &&
                       near.count(projection.twins[n]) == 1;
          unforeseen += foreseen ? 0 : 1;
        }
    }
  verdict(name + ": points have facets", 5 * found > n_rollers * n_points);
  std::cout << name << ": of whose nodes some are not near " << unforeseen << '\n';
  std::cout << name << ": gaps near, of " << in_gap.size() << ": "
            << std::round(10. * n_gaps / n_rollers) / 10. << '\n';
}
} // namespace

int main()
{
  check("arcs", Sprocket::generated);
  check("facets", Sprocket::imported);
}
