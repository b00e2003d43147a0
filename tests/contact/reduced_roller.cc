// SPDX-License-Identifier: LGPL-2.1-or-later
// A reduced roller against one of elements, at three angles of their meshes. On the bush of a link
// that is as heavy as a pitch of the chain, both hit the seat and the flank of a tooth at the speed
// of an engagement: peaks agree within 10 %, impulses within 1 %, and forces filtered to 3 us
// within 6 % of the peak, rms. Pressed by a bush, the reduced one is a little stiffer: it lacks
// dents.
#include "../support/roller_on_bush.h"

#include <algorithm>
#include <numeric>

using namespace test;

namespace
{
enum class Place
{
  seat,
  flank
};

/// Where the roller hits the tooth of a sprocket whose hub stands still.
struct Hit
{
  Vector3 centre, normal; ///< of the roller, 2 um before; out of the tooth
};

Hit hit(const drive::ToothForm &form, const double radius, const Place place)
{
  constexpr double before = 2e-6;
  if (place == Place::flank)
    {
      const auto [centre, normal] = before_flank(form, radius, before);
      return {centre, normal};
    }
  const dealii::Point<2> x(0.5 * form.root_diameter + radius + before, 0.);
  const auto             n = form.closest_point(x).normal;
  return {vector(x[0], x[1]), vector(n[0], n[1])};
}

/// A roller with its bush before a tooth, which it meets at @p speed [m/s] along -y; @p phase turns
/// it by so many columns of its mesh.
scene::Scene make_scene(const Place  place,
                        const double phase,
                        const double friction,
                        const double speed,
                        const bool   reduced)
{
  Tooth c;
  c.elastic          = false;
  scene::Scene scene = test::make_scene(c);
  const auto   chain = drive::make_chain(parameters::Chain());
  mesh_roller_and_link(scene, chain, mesh::RollerGrid(3, 32, 6), mesh::inner_link_grid(0));

  const Hit  h = hit(*scene.teeth[0].form, 0.5 * chain.roller_diameter, place);
  const auto turn =
      rotation_about_z(0.5 * dealii::numbers::PI - std::atan2(h.normal[1], h.normal[0]));
  scene.bodies[1].initial.rotation = to_matrix(turn);
  scene::Body &roller              = scene.bodies[0];
  roller.initial.position          = to_matrix(turn) * h.centre;
  roller.initial.rotation          = to_matrix(rotation_about_z(phase * dealii::numbers::PI / 16.));
  roller.initial.velocity          = vector(0., -speed);
  // it does not turn, and its bush stands where it will press
  scene.bodies.push_back(link_on_roller(chain, scene::Motion::rigid, 8.9e-3, 1., roller));

  // as in prm/paper/full.prm
  scene.teeth[0].law = {3.7e13, 3.6e6, friction, 3e13, 3e6};
  scene::BoreFamily joint;
  joint.name    = "roller-bush";
  joint.elastic = true;
  joint.law     = {9.8e13, 3.6e6, friction, 8e13, 3e6};
  joint.pairs.push_back(roller_on_bush(chain, 0, 2));
  scene.bores.push_back(joint);
  if (reduced)
    reduce(scene);
  return scene;
}

constexpr double dt = 5e-8; // s

/// Forces of the tooth along its normal after each step, N.
std::vector<double>
forces(const Place place, const double phase, const double friction, const bool reduced)
{
  dynamics::System    system(make_scene(place, phase, friction, 1.4, reduced), false);
  std::vector<double> f;
  advance(system, 2400, dt, [&]() {
    f.push_back(system.contacts.families()[0]->records()[0].force[1]);
  });
  return f;
}

std::vector<double> filtered(const std::vector<double> &f)
{
  constexpr unsigned int n = 60; // 3 us
  std::vector<double>    mean;
  for (unsigned int i = 0; i + n < f.size(); ++i)
    mean.push_back(std::accumulate(f.begin() + i, f.begin() + i + n, 0.) / n);
  return mean;
}

void compare_hits(const Place place, const double friction, const std::vector<double> &phases)
{
  const auto peak    = [](const auto &f) { return *std::max_element(f.begin(), f.end()); };
  const auto sum     = [](const auto &f) { return std::accumulate(f.begin(), f.end(), 0.); };
  double     of_peak = 0., of_impulse = 0., of_filtered = 0.;
  for (const double phase : phases)
    {
      const auto full    = forces(place, phase, friction, false),
                 reduced = forces(place, phase, friction, true);
      const auto a = filtered(full), b = filtered(reduced);
      double     square = 0.;
      for (unsigned int i = 0; i < a.size(); ++i)
        square += (a[i] - b[i]) * (a[i] - b[i]) / a.size();
      of_peak     = std::max(of_peak, std::abs(peak(reduced) / peak(full) - 1.));
      of_impulse  = std::max(of_impulse, std::abs(sum(reduced) / sum(full) - 1.));
      of_filtered = std::max(of_filtered, std::sqrt(square) / peak(a));
    }
  std::cout << (place == Place::seat ? "seat" : "flank") << ", friction " << friction
            << ": peak, impulse, filtered force differ by " << std::fixed << std::setprecision(0)
            << 100. * of_peak << ", " << 100. * of_impulse << ", " << 100. * of_filtered << " %\n"
            << std::defaultfloat;
  verdict("  within 10, 1 and 6 %", of_peak < 0.1 && of_impulse < 0.01 && of_filtered < 0.06);
}

/// How far the link comes down under a weight of 500 N in the seat, m.
double yielding(const double phase, const bool reduced)
{
  scene::Scene scene  = make_scene(Place::seat, phase, 0., 0., reduced);
  scene.loads.gravity = 500. / (8.9e-3 + 1.95e-3);
  scene.loads.drag    = 1e5;
  dynamics::System system(scene, false);
  advance(system, 4000, dt, []() {});
  return scene.bodies[2].initial.position[1] - system.world.frames[2].position[1] - 2e-6;
}
} // namespace

int main()
{
  compare_hits(Place::seat, 0., {0., 0.25, 0.5});
  compare_hits(Place::flank, 0., {0., 0.25, 0.5});
  compare_hits(Place::seat, 0.1, {0.25});
  const double full = yielding(0.25, false), reduced = yielding(0.25, true);
  std::cout << "yields to 500 N in the seat by " << std::fixed << std::setprecision(2) << 1e6 * full
            << " um, reduced by " << std::setprecision(0) << 100. * (1. - reduced / full)
            << " % less\n";
}
