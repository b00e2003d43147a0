// SPDX-License-Identifier: LGPL-2.1-or-later
// Numbers of single elastic bodies among others, from the state of a system: rollers and links that
// fly and spin, without stress and after they have been stretched along their own x axis. The
// surface node of a roller lies in its middle plane, on its outside, next to the span's normal. The
// spin of a body that moves by nodes is that at which it was started.
#include "../support/scenes.h"

#include <chaindrive/mesh/generate/links.h>
#include <chaindrive/observe/elastic_bodies.h>

using namespace test;

namespace
{
constexpr unsigned int n_bodies = 12;

scene::Scene make_scene()
{
  scene::Scene scene               = empty_scene();
  const auto   chain               = drive::make_chain(parameters::Chain());
  scene.parts[scene::Kind::roller] = std::make_shared<const mesh::Part>(
      mesh::make_roller(chain, 7600., mesh::RollerGrid(1, 24, 4)));
  scene.parts[scene::Kind::inner_link] = std::make_shared<const mesh::Part>(
      mesh::make_inner_link(chain, 7600., mesh::inner_link_grid(1)));
  scene.parts[scene::Kind::outer_link] = std::make_shared<const mesh::Part>(
      mesh::make_outer_link(chain, 7600., mesh::outer_link_grid(1)));
  scene::Span tight;
  tight.normal      = vector(0.6, 0.8, 0.);
  scene.drive.spans = {tight};
  for (unsigned int k = 0; k < n_bodies; ++k)
    {
      scene::Body flying              = body(scene::Motion::elastic,
                                scene::Mount::free(),
                                0.01,
                                vector(1e-6, 1e-6, 1e-6),
                                vector(0.1 * k, 0.3, 0.),
                                vector(4. - k, 2., 1.));
      flying.kind                     = k < 4 ? scene::Kind::roller :
                                        k < 8 ? scene::Kind::inner_link :
                                                scene::Kind::outer_link;
      flying.initial.rotation         = to_matrix(rotation_about_z(0.7 * k));
      flying.initial.angular_velocity = vector(0., 0., 40. + 60. * k);
      scene.bodies.push_back(flying);
    }
  return scene;
}

double largest(const observe::WaistStress &s)
{
  double value = 0.;
  for (const double v : {s.axial, s.in_plane, s.out_of_plane, s.principal_1, s.principal_2})
    value = std::max(value, std::abs(v));
  return value;
}
} // namespace

int main()
{
  const scene::Scene              scene = make_scene();
  dynamics::System                system(scene, false);
  const observe::ElasticSnapshots snapshots(system);
  const observe::RollerSurfaces   surfaces(scene, system);
  const observe::Waists           waists(scene, system);
  const double                    E = scene.material.youngs_modulus, radius = 5.08e-3;

  double speed = 0., across = 0., angle = 0.;
  for (unsigned int b = 0; b < 4; ++b)
    {
      const Frame  &frame = scene.bodies[b].initial;
      const Vector3 v     = surfaces.velocity(system, b) - frame.velocity;
      // the point of the surface that has this velocity
      const Vector3 arm = cross_product_3d(v, vector(0., 0., 1.)) / frame.angular_velocity[2];
      speed             = std::max(speed, std::abs(arm.norm() / radius - 1.));
      across            = std::max(across, std::abs(v[2]));
      angle             = std::max(angle, std::acos(arm * scene.drive.tight().normal / arm.norm()));
    }
  verdict("surface nodes are on the outside", speed < 1e-9 && across < 1e-12);
  verdict("and at most half a column from the normal", angle < dealii::numbers::PI / 24. + 1e-9);
  double spin = 0.;
  for (unsigned int b = 0; b < n_bodies; ++b)
    spin = std::max(
        spin,
        std::abs(observe::spin_of_nodes(system, b) / scene.bodies[b].initial.angular_velocity[2] -
                 1.));
  verdict("bodies spin as they were started", spin < 1e-9);

  const double strain = 1e-4, stress = E * strain * (1. + 0.5 * strain);
  for (const bool stretched : {false, true})
    {
      double error = 0., moved = 0., velocity = 0., waist = 0., pull = 0.;
      for (unsigned int b = 0; b < n_bodies; ++b)
        {
          const Frame          &frame  = scene.bodies[b].initial;
          const World::Address &place  = system.world.elastic_address[b];
          BodyBatches          &copies = system.world.copies[place.group];
          for (unsigned int node = 0; stretched && node < copies.n_nodes(); ++node)
            {
              // no stress across
              const double  side = std::sqrt(1. - 0.6 * (strain + 0.5 * strain * strain));
              Vector3       x    = copies.nodes.position[node];
              const Vector3 scaled =
                  frame.position +
                  frame.rotation * vector((1. + strain) * x[0], side * x[1], side * x[2]);
              for (unsigned int d = 0; d < 3; ++d)
                NodeView(copies.position).component(copies.index(place.copy, node), d) = scaled[d];
            }
          const observe::ElasticSnapshot snapshot = snapshots.of(system, place);
          for (const element::Stress &cell : snapshot.stress)
            error = std::max({error,
                              std::abs(cell.piola[0][0] - stretched * stress) / stress,
                              std::abs(cell.piola[1][1]) / stress,
                              std::abs(cell.piola[0][1]) / stress});
          const auto &vertices = copies.part->mesh->get_vertices();
          for (unsigned int v = 0; v < vertices.size(); ++v)
            {
              const Vector3 arm  = frame.rotation * Vector3(vertices[v]);
              const Vector3 turn = cross_product_3d(frame.angular_velocity, arm);
              velocity = std::max(velocity, (snapshot.velocity[v] - frame.velocity - turn).norm());
              const double along = snapshot.displacement[v] * (frame.rotation * vector(1., 0., 0.));
              moved = std::max(moved, std::abs(along - stretched * strain * vertices[v][0]));
            }
          if (b >= 4)
            {
              const observe::WaistStress s = waists.stress(system, b);
              waist                        = std::max(waist, largest(s) / stress);
              pull                         = std::max({pull,
                                                       std::abs(s.principal_1 / stress - 1.),
                                                       std::abs(s.principal_2 / stress),
                                                       std::abs(s.in_plane / stress),
                                                       std::abs(s.out_of_plane / stress)});
            }
        }
      std::cout << (stretched ? "stretched" : "as placed") << '\n';
      verdict("  stress of all cells right", error < 1e-6);
      verdict("  displacement and velocity right", moved < 1e-12 && velocity < 1e-9);
      if (stretched)
        verdict("  waists have its principal stresses and no bending", pull < 1e-6);
      else
        verdict("  waists are free of stress", waist < 1e-6);
    }
}
