// SPDX-License-Identifier: LGPL-2.1-or-later
// What field output shows of contacts without penalty: a roller that is pressed between a tooth and
// the bush of a link. In pieces and on nodes pressures add up to the normal forces. On a flank they
// are those of Hertz' line contact in each ring of the roller's nodes, p_0 = sqrt(q E' / (2 pi R))
// under the load q per length: each strip has its mean over this strip. In the seat peaks are those
// of a pin in a hole [Persson 1964]. A bore has the pressure of the cylinder in it. The forces that
// deflect bodies beside their modes cancel; with these deflections surfaces that overlap where
// modes alone place them lie on one another, and plates bend as the link measures by other means.
#include "../support/exact_roller.h"

#include <chaindrive/contact/contacts.h>
#include <chaindrive/observe/elastic_bodies.h>
#include <chaindrive/observe/massless_deflections.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

using namespace test;
using namespace test::exact_roller;
using dealii::numbers::PI;

namespace
{
bool with_numbers = false; ///< behind the verdicts: if there is an argument

void check(const std::string &what, const double number, const double low, const double high)
{
  if (with_numbers)
    std::cerr << what << ": " << number << '\n';
  verdict(what, number > low && number < high);
}

/// The mean of Hertz' ellipse of unit height and half width @p b over the part from @p from to
/// @p to, both from its middle.
double mean_of_ellipse(const double b, const double from, const double to)
{
  const auto integral = [b](const double x) {
    const double t = std::clamp(x / b, -1., 1.);
    return 0.5 * b * (t * std::sqrt(1. - t * t) + std::asin(t));
  };
  return (integral(to) - integral(from)) / (to - from);
}

/// What touches on one ring of the roller.
struct Ring
{
  std::vector<contact::PressurePatch> patches;
  double                              length = 0., force = 0., peak = 0.; ///< m, N, Pa

  double load() const { return force / length; } ///< N/m
};

std::vector<Ring> rings_of(const std::vector<contact::PressurePatch> &patches)
{
  std::map<long, Ring> rings; // by where they begin, nm
  for (const contact::PressurePatch &patch : patches)
    {
      Ring &ring  = rings[std::lround(1e9 * patch.corners[0][2])];
      ring.length = patch.corners[2][2] - patch.corners[0][2];
      ring.force += patch.normal_force;
      ring.peak = std::max(ring.peak, patch.pressure);
      ring.patches.push_back(patch);
    }
  std::vector<Ring> list;
  for (const auto &[z, ring] : rings)
    list.push_back(ring);
  return list;
}

/// The largest difference of a strip's pressure from Hertz' over the peak, and the largest ratio of
/// both peaks, of all rings.
std::pair<double, double> against_hertz(const scene::Scene &scene, const std::vector<Ring> &rings)
{
  const scene::ToothFamily &teeth  = scene.teeth[0];
  const double              radius = teeth.slaves[0].radius;
  const auto                flank  = std::find_if(
      teeth.form->half_profile.begin(), teeth.form->half_profile.end(), [](const auto &segment) {
        return segment.kind == drive::Segment::Kind::convex;
      });
  const double curvature = 1. / radius + 1. / flank->radius;
  const double modulus   = scene.material.plane_modulus();
  double       worst = 0., ratio = 0.;
  for (const Ring &ring : rings)
    {
      const double peak   = std::sqrt(ring.load() * modulus * curvature / (2. * PI));
      const double half   = 2. * ring.load() / (PI * peak);
      double       middle = 0.; // the normal is along y
      for (const contact::PressurePatch &patch : ring.patches)
        middle +=
            patch.normal_force / ring.force * 0.5 * (patch.corners[0][0] + patch.corners[1][0]);
      for (const contact::PressurePatch &patch : ring.patches)
        {
          const double a = patch.corners[0][0] - middle, b = patch.corners[1][0] - middle;
          const double hertz = peak * mean_of_ellipse(half, std::min(a, b), std::max(a, b));
          worst              = std::max(worst, std::abs(patch.pressure - hertz) / peak);
        }
      ratio = std::max(ratio, ring.peak / peak);
    }
  return {worst, ratio};
}

/// The largest difference of a ring's peak from Persson's, over it; not of those at the ends, where
/// the bush, which bends, presses.
double against_persson(const scene::Scene &scene, const std::vector<Ring> &rings)
{
  const double radius = scene.teeth[0].slaves[0].radius,
               play   = scene.teeth[0].form->seat_radius - radius;
  double worst        = 0.;
  for (std::size_t r = 1; r + 1 < rings.size(); ++r)
    {
      const Ring  &ring  = rings[r];
      const auto   hole  = drive::conforming_contact(radius, play, ring.load(), scene.material);
      const double ratio = ring.peak / hole.peak_pressure;
      if (with_numbers)
        std::cerr << "    ring under " << ring.load() << " N/m: peak over Persson's " << ratio
                  << '\n';
      worst = std::max(worst, std::abs(ratio - 1.));
    }
  return worst;
}

/// The sum of pressures times areas of the nodes of a cylindrical side of @p body, N; and the
/// largest pressure, Pa.
std::pair<double, double> on_side(const scene::Scene                       &scene,
                                  const World                              &world,
                                  const std::vector<contact::NodePressure> &pressures,
                                  const unsigned int                        body,
                                  const mesh::Surface                       side)
{
  const mesh::CylinderGrid       grid(*scene.parts.at(scene.bodies[body].part()), side);
  const auto                    &nodes = world.copies[world.elastic_address[body].group].nodes;
  std::map<unsigned int, double> area, sum;
  for (unsigned int v = 0; v < grid.vertex.size(); ++v)
    area[nodes.of_vertex[grid.vertex[v]]] = grid.area(v / grid.n_circumferential(), 0);
  double force = 0., largest = 0.;
  for (const contact::NodePressure &at : pressures)
    if (at.body == body && area.count(at.node) != 0)
      {
        force += at.pressure * area[at.node];
        sum[at.node] += at.pressure;
        largest = std::max(largest, sum[at.node]);
      }
  return {force, largest};
}

/// By how much bush and bore overlap where nodes of the bush touch: the largest by their modes
/// alone, and the mean size of what is left of it with all of their deflections, m.
std::pair<double, double> overlaps(const scene::Scene                       &scene,
                                   const dynamics::System                   &system,
                                   const std::vector<contact::NodePressure> &pressures)
{
  const auto               deflections = observe::MasslessDeflections(scene, system).now(system);
  const World             &world       = system.world;
  const mesh::CylinderGrid bore(*scene.parts.at(scene.bodies[0].part()), mesh::roller_bore);
  const unsigned int       columns   = bore.n_circumferential();
  const auto              &of_roller = world.copies[world.elastic_address[0].group].nodes,
             &of_link                = world.copies[world.elastic_address[2].group].nodes;
  double       largest = 0., left = 0.;
  unsigned int n = 0;
  for (const bool whole : {false, true})
    {
      const auto places_of = [&](const unsigned int body) {
        const World::Address &at = world.elastic_address[body];
        std::vector<Vector3>  position, velocity;
        world.group_of(at.group).nodes_now(world, at.copy, position, velocity);
        for (unsigned int i = 0; i < position.size(); ++i)
          {
            if (whole)
              position[i] += deflections.at(body)[i];
            position[i] = transpose(world.frames[0].rotation) *
                          (position[i] - world.frames[0].position); // about the roller
          }
        return position;
      };
      const std::vector<Vector3> roller = places_of(0), link = places_of(2);
      for (const contact::NodePressure &at : pressures)
        {
          if (at.body != 2 || of_link.position[at.node][0] > 0.)
            continue; // the bush in the other roller
          const Vector3 x   = link[at.node];
          const double  way = std::atan2(x[1], x[0]) * columns / (2. * PI);
          const auto    first =
              static_cast<unsigned int>(int(std::floor(way)) + int(columns)) % columns;
          const double part = way - std::floor(way);
          unsigned int ring = 0; // the nearest one
          for (unsigned int r = 0; r < bore.n_rings(); ++r)
            if (std::abs(bore.rings[r] - x[2]) < std::abs(bore.rings[ring] - x[2]))
              ring = r;
          const auto radius = [&](const unsigned int column) {
            const Vector3 node =
                roller[of_roller.of_vertex[bore.vertex_at(ring, column % columns)]];
            return std::hypot(node[0], node[1]);
          };
          const double overlap =
              std::hypot(x[0], x[1]) - (1. - part) * radius(first) - part * radius(first + 1);
          if (whole)
            left += std::abs(overlap);
          else
            largest = std::max(largest, overlap);
          n += whole ? 1 : 0;
        }
    }
  return {largest, left / n};
}

/// The bending stress at the waist of the link's plates in their plane, by where modes alone and
/// all deflections have its nodes, over what it measures.
std::pair<double, double> in_plane(const scene::Scene &scene, const dynamics::System &system)
{
  const World               &world = system.world;
  const World::Address      &at    = world.elastic_address[2];
  const mesh::Part          &part  = *scene.parts.at(scene.bodies[2].part());
  const mesh::Nodes          nodes(part);
  const observe::PlateStress plates(part, nodes, scene.material, scene.elements.plates);
  const auto           deflection = observe::MasslessDeflections(scene, system).now(system).at(2);
  std::vector<Vector3> position, velocity;
  world.group_of(at.group).nodes_now(world, at.copy, position, velocity);
  std::array<double, 2> found;
  for (const bool whole : {false, true})
    {
      std::vector<Vector3> of_plates;
      for (const unsigned int node : plates.nodes())
        of_plates.push_back(position[node] + (whole ? 1. : 0.) * deflection[node]);
      found[whole] = plates.components(of_plates).in_plane;
    }
  const double measured = observe::Waists(scene, system).components(system, 2).in_plane;
  if (with_numbers)
    std::cerr << "  in plane, MPa: " << 1e-6 * measured << '\n';
  return {found[0] / measured, found[1] / measured};
}

void look(const Place place, const double of_load)
{
  Case c;
  c.place            = place;
  c.phase            = 0.3;
  c.stiffness        = 3.5e8;
  c.load             = of_load;
  c.fine             = false;
  scene::Scene scene = make(c);
  observe::measure_waists(scene, MPI_COMM_SELF);
  dynamics::System system(scene, false);
  World           &world = system.world;
  const double     dt    = 0.9 * system.critical_time_step();
  advance(system, std::lround(1.5e-3 / dt), dt, []() {});

  const contact::Family
      &teeth =
          *system.contacts.find({scene::Interface::roller_teeth, scene.teeth[0].sprocket}).front(),
      &bores = *system.contacts.find(scene.bores[0].interface).front();
  std::vector<contact::PressurePatch> on_teeth, in_bores;
  teeth.add_patches(world, on_teeth);
  bores.add_patches(world, in_bores);
  std::vector<contact::NodePressure> of_teeth, of_bores;
  teeth.add_pressures(world, of_teeth);
  bores.add_pressures(world, of_bores);
  const auto sum_of = [](const std::vector<contact::PressurePatch> &patches,
                         const unsigned int                         joint) {
    double sum = 0.;
    for (const contact::PressurePatch &patch : patches)
      sum += patch.joint == joint ? patch.normal_force : 0.;
    return sum;
  };
  const double load = sum_of(on_teeth, 0), in_bore = sum_of(in_bores, 0);
  std::cout << name(place) << " under " << of_load << " N\n";
  if (with_numbers)
    std::cerr << name(place) << " under " << of_load << " N: " << load << " N, in the bore "
              << in_bore << " N\n";

  double worst = 0.;
  for (const auto *patches : {&on_teeth, &in_bores})
    for (const contact::PressurePatch &patch : *patches)
      {
        const auto  &x    = patch.corners;
        const double area = 0.5 * cross_product_3d(x[2] - x[0], x[3] - x[1]).norm();
        worst = std::max(worst, std::abs(patch.pressure * area / patch.normal_force - 1.));
      }
  Vector3 resultant; // along the lines from pieces of the tooth to the roller's axis
  for (const contact::PressurePatch &patch : on_teeth)
    if (patch.joint == 0 && patch.slave == 0)
      {
        Vector3 e = world.frames[0].position;
        for (const dealii::Point<3> &x : patch.corners)
          e -= 0.25 * Vector3(x);
        e[2] = 0.;
        resultant += patch.normal_force / e.norm() * e;
      }
  check("  forces over pressures are the areas of pieces, which are flat", worst, -1e-9, 0.01);
  check("  and sum up to the contact force",
        (resultant - teeth.records()[0].force).norm() / load,
        -1e-9,
        2e-3);
  check("  as on the nodes of the roller, to round-off",
        on_side(scene, world, of_teeth, 0, mesh::roller_outside).first / load - 1.,
        -1e-12,
        1e-12);
  std::vector<double> history(2, 0.);
  teeth.raise_pressures(history);
  bores.raise_pressures(history);
  const auto bush               = on_side(scene, world, of_bores, 2, mesh::bush_outside_first),
             bore               = on_side(scene, world, of_bores, 0, mesh::roller_bore);
  const std::vector<Ring> rings = rings_of(on_teeth);
  double                  peak  = bush.second;
  for (const Ring &ring : rings)
    peak = std::max(peak, ring.peak);
  check("  peaks are those of histories", history[0] / peak - 1., -1e-12, 1e-12);
  // columns of both are not at the same places
  check("  the bore has the peak of the bush", bore.second / bush.second, 0.75, 1.0001);
  check("  and its force", bore.first / in_bore, 0.95, 1.05);

  if (place == Place::flank)
    {
      const auto [error, ratio] = against_hertz(scene, rings);
      // under 300 N it is as wide as a strip and a half, under 1412 N as three, under 4500 N as
      // five
      const double low = of_load < 1000. ? 0.7 : of_load < 3000. ? 0.92 : 0.97;
      check("  the peak is that of Hertz but for the mean over a strip", ratio, low, 2. - low);
      check("  strips have their part of his pressure, over the peak", error, 0., 0.16);
    }
  else if (of_load > 1000.) // at least three strips touch
    check("  peaks are those of Persson", against_persson(scene, rings), 0., 0.08);

  std::vector<contact::NodeForce> forces;
  bores.add_massless_forces(world, forces);
  Vector3 sum, moment, of_bush;
  for (const contact::NodeForce &at : forces)
    {
      const auto   &nodes = world.copies[world.elastic_address[at.body].group].nodes;
      const Vector3 x     = world.frames[at.body].position +
                        world.frames[at.body].rotation * Vector3(nodes.position[at.node]);
      sum += at.force;
      moment += cross_product_3d(x, at.force);
      if (at.body == 2 && nodes.position[at.node][0] < 0.)
        of_bush += at.force;
    }
  check("  forces in joints cancel", sum.norm() / in_bore, -1., 1e-12);
  // places of both are those of undeformed bodies, and chords of the bore
  check("  and their moments", moment.norm() / (in_bore * 5e-3), -1., 2e-3);
  check("  that on the bush is the contact force",
        (of_bush - bores.records()[0].force).norm() / in_bore,
        -1.,
        2e-3);
  forces.clear();
  teeth.add_massless_forces(world, forces);
  Vector3 on_roller;
  for (const contact::NodeForce &at : forces)
    on_roller += at.force;
  check("  that on the roller is the teeth's",
        (on_roller - teeth.records()[0].force).norm() / load,
        -1.,
        2e-3);

  const auto [of_modes, of_all] = in_plane(scene, system);
  if (with_numbers)
    std::cerr << "  waist in its plane, by modes alone over measured: " << of_modes << '\n';
  check("  waists in pictures bend as links measure", of_all, 0.98, 1.02);
  check("  by modes alone they do not", of_modes, -10., 0.9);

  const auto [overlap, left] = overlaps(scene, system, of_bores);
  if (with_numbers)
    std::cerr << "  they overlap by " << 1e6 * overlap << " um, then by " << 1e6 * left << '\n';
  check("  bush and bore overlap and lie on one another when deflected", left / overlap, 0., 0.07);
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  with_numbers = argc > 1;
  for (const Place place : {Place::flank, Place::bottom})
    for (const double load : {300., 1412., 4500.})
      look(place, load);
}
