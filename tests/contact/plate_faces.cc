// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces of plates. Two bars of one cross-section pressed together at rest shorten as springs in
// series: their own L / E A each, and the contact's. An inner link that flies sideways into the
// plate of an outer one, sliding and turning on it with friction: forces cancel in sum and moment,
// energy is kept but for what friction eats, momentum changes by the impulse; no contact is missed
// by the search, which gives the same motion as one at every step. Nodes that are suddenly past the
// rim of the other plate lose the energy of their springs, and it is booked.
#include "../support/scenes.h"
#include "../support/statics.h"

#include <chaindrive/bodies/make_world.h>
#include <chaindrive/contact/node_faces.h>
#include <chaindrive/mesh/generate/links.h>

using namespace test;

namespace
{
/// Nodes of a body, the first copy of its group.
template <typename Visit>
void for_each_value(World &world, const unsigned int body, const Visit &visit)
{
  const World::Address &place  = world.elastic_address[body];
  BodyBatches          &copies = world.copies[place.group];
  for (unsigned int i = 0; i < 3 * copies.n_nodes(); ++i)
    visit(i, copies, copies.index(place.copy, i / 3) + component_offset(i % 3));
}

/// A bar with the square of 1 mm between z and z + L, whose side @p surface is at z = 2 L.
std::shared_ptr<const mesh::Part>
bar(const double z, const double L, const mesh::Surface surface, const unsigned int cells)
{
  mesh::Part part = test::part([&](dealii::Triangulation<3> &mesh) {
    dealii::GridGenerator::subdivided_hyper_rectangle(
        mesh, {cells, cells, 4}, Point<3>(0., 0., z), Point<3>(1e-3, 1e-3, z + L));
  });
  for (const auto &face : part.mesh->active_face_iterators())
    if (face->at_boundary())
      face->set_boundary_id(std::abs(face->center()[2] - 2. * L) < 1e-9 ? surface :
                                                                          mesh::other_surface);
  return std::make_shared<const mesh::Part>(std::move(part));
}

/// Force [N] of the bars when the outer ends have come closer by @p approach [m], over that of
/// springs in series; with @p cells across each.
double bars(const double approach, const std::array<unsigned int, 2> &cells)
{
  constexpr double L                   = 4e-3;
  scene::Scene     scene               = empty_scene();
  scene.parts[scene::Kind::inner_link] = bar(L, L, mesh::plate_outer_faces, cells[0]);
  scene.parts[scene::Kind::outer_link] = bar(2. * L, L, mesh::plate_inner_faces, cells[1]);
  for (const scene::Kind kind : {scene::Kind::inner_link, scene::Kind::outer_link})
    {
      scene.bodies.push_back(
          body(scene::Motion::elastic, scene::Mount::free(), 1., vector(1., 1., 1.), Vector3()));
      scene.bodies.back().kind = kind;
    }
  scene::FaceFamily family;
  family.law.stiffness = 1e14;
  family.radius        = 1.;
  family.pairs         = {
              {1, 0, mesh::plate_inner_faces, mesh::plate_outer_faces, Point<3>(), Point<3>(), 0}};

  World              world = make_world(scene);
  contact::NodeFaces faces(family, world, true);
  const Hexahedra slave(*scene.parts[scene::Kind::inner_link], scene.material, Formulation::full),
      master(*scene.parts[scene::Kind::outer_link], scene.material, Formulation::full);
  Statics             statics({&slave, &master});
  std::vector<double> start(statics.size);
  for (unsigned int b = 0; b < 2; ++b)
    for_each_value(world, b, [&](const unsigned int i, BodyBatches &copies, const std::size_t at) {
      start[statics.first[b] + i] = copies.position.local_element(at);
    });
  const auto contact = [&](const Vector<double> &u, Vector<double> &f) {
    for (unsigned int b = 0; b < 2; ++b)
      for_each_value(
          world, b, [&](const unsigned int i, BodyBatches &copies, const std::size_t at) {
            copies.position.local_element(at) =
                start[statics.first[b] + i] + u[statics.first[b] + i];
            copies.force.local_element(at) = 0.;
          });
    faces.add_forces(world, 0.);
    for (unsigned int b = 0; b < 2; ++b)
      for_each_value(
          world, b, [&](const unsigned int i, BodyBatches &copies, const std::size_t at) {
            f[statics.first[b] + i] = copies.force.local_element(at);
          });
  };

  std::vector<unsigned int> touched;
  for (unsigned int b = 0; b < 2; ++b)
    {
      const Hexahedra &reference = b == 0 ? slave : master;
      for (unsigned int n = 0; n < reference.n_nodes(); ++n)
        {
          const Point<3>    &x     = reference.position[n];
          const unsigned int first = statics.first[b] + 3 * n;
          statics.held[first]      = x[0] == 0.;
          statics.held[first + 1]  = x[1] == 0.;
          statics.held[first + 2]  = std::abs(x[2] - 2. * L) > 0.99 * L;
          if (b == 1)
            statics.u[first + 2] = -approach;
          if (std::abs(x[2] - 2. * L) < 1e-9)
            for (unsigned int d = 0; d < 3; ++d)
              touched.push_back(first + d);
        }
    }
  if (statics.solve(contact, touched, 1e-6) == 0)
    std::cout << "no equilibrium\n";
  Vector<double> f(statics.size);
  contact(statics.u, f);
  const double area = 1e-6, E = scene.material.youngs_modulus;
  const double expected = approach / (2. * L / (E * area) + 1. / (family.law.stiffness * area));
  return -faces.records()[0].force[2] / expected;
}

/// An inner link and an outer one whose common joint is at the inner one's first bush; the outer
/// link is moved along z so that their plates are 5 um apart.
scene::Scene links(const double friction)
{
  scene::Scene scene                   = empty_scene();
  const auto   chain                   = drive::make_chain(parameters::Chain());
  const double rho                     = scene.material.density;
  scene.parts[scene::Kind::inner_link] = std::make_shared<const mesh::Part>(
      mesh::make_inner_link(chain, rho, mesh::inner_link_grid(1)));
  scene.parts[scene::Kind::outer_link] = std::make_shared<const mesh::Part>(
      mesh::make_outer_link(chain, rho, mesh::outer_link_grid(1)));
  const double bush = -0.5 * chain.inner_hole_pitch, pin = 0.5 * chain.outer_hole_pitch;
  const double apart = chain.outer_plate_z - 0.5 * chain.outer_plate_thickness -
                       chain.inner_plate_z - 0.5 * chain.inner_plate_thickness;

  scene.bodies = {
      body(scene::Motion::elastic,
           scene::Mount::free(),
           1.,
           vector(1., 1., 1.),
           Vector3(),
           vector(0.3, 0.2, 1.)),
      body(scene::Motion::elastic, scene::Mount::free(), 1., vector(1., 1., 1.), Vector3())};
  scene.bodies[0].kind   = scene::Kind::inner_link;
  scene.bodies[1].kind   = scene::Kind::outer_link;
  Frame &outer           = scene.bodies[1].initial;
  outer.rotation         = to_matrix(rotation_about_z(0.3));
  outer.position         = vector(bush, 0., 5e-6 - apart) - outer.rotation * vector(pin, 0., 0.);
  outer.angular_velocity = vector(0., 0., 100.);

  scene::FaceFamily family;
  family.name          = "plate faces";
  family.law.stiffness = 0.5 * scene.material.youngs_modulus / chain.inner_plate_thickness;
  family.law.friction  = friction;
  family.law.tangential_stiffness = 0.8 * family.law.stiffness;
  family.radius = 0.5 * std::min(chain.inner_plate_height, chain.outer_plate_height);
  family.pairs  = {{1,
                    0,
                    mesh::plate_inner_faces,
                    mesh::plate_outer_faces,
                    Point<3>(pin, 0., 0.),
                    Point<3>(bush, 0., 0.),
                    0}};
  scene.faces   = {family};
  return scene;
}

/// Sum over all nodes of mass times velocity.
Vector3 momentum(World &world, const unsigned int b)
{
  Vector3 sum;
  for_each_value(world, b, [&](const unsigned int i, BodyBatches &copies, const std::size_t at) {
    sum[i % 3] += copies.nodes.mass[i / 3] * copies.velocity.local_element(at);
  });
  return sum;
}

/// What happens in 60 us.
struct Outcome
{
  double        worst = 0., kinetic = 0., friction = 0.;
  Vector3       impulse, gained;
  unsigned long missed = 0;
};

Outcome fly(const double friction, const bool every_step)
{
  dynamics::System system(links(friction), every_step);
  World           &world  = system.world;
  const Vector3    before = momentum(world, 0);
  const double     dt     = 0.5 * system.critical_time_step();
  Outcome          outcome;
  outcome.kinetic = world.ledger.initial;
  advance(system, static_cast<unsigned long>(60e-6 / dt), dt, [&]() {
    outcome.impulse += dt * system.contacts.families()[0]->records()[0].force;
    outcome.worst    = std::max(outcome.worst, std::abs(world.ledger.imbalance()));
    outcome.friction = world.ledger.friction;
  });
  outcome.gained = momentum(world, 0) - before;
  outcome.missed = system.contacts.n_missed();
  return outcome;
}

/// Moves body @p b by @p u [m] from one instant to the next.
void displace(World &world, const unsigned int b, const Vector3 &u)
{
  for_each_value(world, b, [&](const unsigned int i, BodyBatches &copies, const std::size_t at) {
    copies.position.local_element(at) += u[i % 3];
  });
}

/// What happens to the energy of springs whose nodes are suddenly past the rim of the other plate;
/// and to forces across the middle plane of halves.
void check_lost(const bool every_step)
{
  const scene::Scene scene = links(0.3);
  World              world = make_world(scene);
  contact::NodeFaces faces(scene.faces[0], world, every_step);
  for (BodyBatches &copies : world.copies)
    copies.velocity = 0.;
  const auto stored = [&](const double dt) {
    world.clear_forces();
    faces.add_forces(world, dt);
    return world.ledger.contact;
  };
  stored(0.);
  displace(world, 0, vector(0., 0., 6e-6));
  const double energy = stored(1e-7), lost = world.ledger.lost();
  const double force = faces.records()[0].force[2];
  world.symmetry     = MirrorSymmetry(true);
  stored(1e-7);
  verdict("force across the middle plane of halves: none",
          std::abs(force) > 1. && faces.records()[0].force[2] == 0.);
  world.symmetry = MirrorSymmetry();
  displace(world, 0, vector(0.05, 0., 0.));
  const double rest = stored(1e-7);
  verdict("springs that lose their facets: their energy is booked as lost",
          energy > 0. && rest == 0. &&
              std::abs(world.ledger.lost() - lost - energy) < 1e-9 * energy);
  displace(world, 0, vector(-0.05, 0., -8e-6));
  const double again = stored(1e-7);
  verdict("and back above them they hold nothing",
          again == 0. && std::abs(world.ledger.lost() - lost - energy) < 1e-9 * energy);
}

void check_balance()
{
  dynamics::System system(links(0.3), true);
  World           &world = system.world;
  double           sum = 0., moment = 0., largest = 0.;
  advance(system, 600, 0.5 * system.critical_time_step(), [&]() {
    // the forces of the contact alone
    world.clear_forces();
    system.contacts.add_forces(world, 0.);
    Vector3 f, m;
    double  size = 0.;
    for (unsigned int b = 0; b < 2; ++b)
      {
        std::array<double, 3> x{}, at{};
        for_each_value(
            world, b, [&](const unsigned int i, BodyBatches &copies, const std::size_t place) {
              x[i % 3]  = copies.position.local_element(place);
              at[i % 3] = copies.force.local_element(place);
              if (i % 3 < 2)
                return;
              const Vector3 force = vector(at[0], at[1], at[2]);
              f += force;
              m += cross_product_3d(vector(x[0], x[1], x[2]), force);
              size += force.norm();
            });
      }
    world.clear_forces();
    largest = std::max(largest, size);
    sum     = std::max(sum, f.norm());
    moment  = std::max(moment, m.norm());
  });
  verdict("forces cancel in sum to 1e-12", largest > 100. && sum < 1e-12 * largest);
  verdict("and in moment", moment < 1e-12 * 0.02 * largest);
}
} // namespace

int main()
{
  ratio("force of two bars, equal meshes", bars(1e-6, {{3, 3}}), 1., 6);
  ratio("force of two bars, different meshes", bars(1e-6, {{3, 4}}), 1., 2);

  const Outcome smooth = fly(0., false), rough = fly(0.3, false), every = fly(0.3, true);
  check_balance();
  check_lost(true);
  check_lost(false);
  for (const Outcome *outcome : {&smooth, &rough})
    {
      std::cout << (outcome == &smooth ? "without friction\n" : "with friction\n");
      verdict("  imbalance below 0.5 % of the energy", outcome->worst < 5e-3 * outcome->kinetic);
      verdict("  momentum changes by the impulse to 1e-3",
              (outcome->gained - outcome->impulse).norm() < 1e-3 * outcome->impulse.norm());
      verdict("  no contact missed", outcome->missed == 0);
    }
  verdict("the same with a search at every step, to 1e-9",
          (rough.gained - every.gained).norm() < 1e-9 * every.gained.norm());
  verdict("which misses nothing either", every.missed == 0);
}
