// SPDX-License-Identifier: LGPL-2.1-or-later
// More mass in the columns of nodes through the wall of a roller: the columns, the critical time
// step that it gives, what it does to the statics of turning and to the modes of the ring, and
// rollers in free flight that spin and ring, whose momenta and energy are those of the added mass
// too.
#include "../support/modes.h"
#include "../support/scenes.h"

#include <chaindrive/element/elastic_part.h>
#include <chaindrive/mesh/generate/links.h>
#include <chaindrive/mesh/thickness_columns.h>

using namespace test;

namespace
{
constexpr unsigned int n_layers = 3;

std::shared_ptr<const mesh::Part> make_part()
{
  const auto chain = drive::make_chain(parameters::Chain());
  return std::make_shared<const mesh::Part>(
      mesh::make_roller(chain, Material().density, mesh::RollerGrid(n_layers, 32, 4)));
}

element::ElasticPart elastic(const mesh::Part &part, const double factor)
{
  parameters::Elements elements;
  elements.selective_mass_scaling = factor;
  return {part, mesh::Nodes(part), Material(), elements};
}

/// M' node by node, from the formula.
LinearModel model_with(const mesh::Part &part, const double factor)
{
  const Hexahedra   reference(part, Material(), Formulation::enhanced);
  LinearModel       model(reference);
  const mesh::Nodes nodes(part);
  for (const auto &column : mesh::thickness_columns(part, nodes, mesh::roller_bore))
    {
      double mass = 0.;
      for (const unsigned int node : column)
        mass += nodes.mass[node];
      for (unsigned int i = 0; i + 1 < column.size(); ++i)
        for (unsigned int d = 0; d < 3; ++d)
          {
            const unsigned int a = 3 * column[i] + d, b = 3 * column[i + 1] + d;
            const double       added = factor * mass / n_layers;
            model.mass.add(a, a, added);
            model.mass.add(b, b, added);
            model.mass.add(a, b, -added);
            model.mass.add(b, a, -added);
          }
    }
  return model;
}

/// Frequency of the mode next to @p near [Hz] that is most like a ring's with @p n waves, uniform
/// along the axis.
double ring_mode(const LinearModel &model, const mesh::Part &part, const double near, const int n)
{
  const mesh::Nodes nodes(part);
  Vector<double>    ring[2]; // and turned
  for (const unsigned int turned : {0, 1})
    {
      ring[turned].reinit(model.mass.m());
      for (unsigned int node = 0; node < nodes.size(); ++node)
        {
          const Point<3> &x   = nodes.position[node];
          const double    phi = std::atan2(x[1], x[0]),
                       at     = n * phi + turned * 0.5 * dealii::numbers::PI;
          const double radial = std::cos(at), along = -std::sin(at) / n;
          ring[turned][3 * node]     = radial * std::cos(phi) - along * std::sin(phi);
          ring[turned][3 * node + 1] = radial * std::sin(phi) + along * std::cos(phi);
        }
    }
  double frequency = 0., largest = 0.;
  for (const Mode &mode : natural_modes(model, near, 8))
    if (const double alike = share(model, mode, ring[0]) + share(model, mode, ring[1]);
        alike > largest)
      {
        largest   = alike;
        frequency = mode.frequency;
      }
  return frequency;
}

scene::Scene flying(const std::shared_ptr<const mesh::Part> &part, const double factor)
{
  scene::Scene scene                    = empty_scene();
  scene.elements.selective_mass_scaling = factor;
  scene.parts[scene::Kind::roller]      = part;
  for (unsigned int k = 0; k < 9; ++k)
    {
      scene::Body roller = body(scene::Motion::elastic,
                                scene::Mount::free(),
                                part->meshed.mass,
                                Vector3(),
                                vector(0.1 + 0.02 * k, 0.3, 0.),
                                vector(4. - k, 2. + 0.5 * k, 1.));
      // spun up at once: the rings breathe
      roller.initial.angular_velocity = vector(0., 0., 40. + 600. * k);
      scene.bodies.push_back(roller);
    }
  return scene;
}

/// Angular momentum with M' about the origin, between the present instant and the next.
Vector3 angular_momentum(const BodyBatches                            &copies,
                         const std::vector<std::vector<unsigned int>> &columns,
                         const unsigned int                            copy,
                         const double                                  factor,
                         const double                                  dt)
{
  const auto velocity = [&](const unsigned int node) {
    return NodeView(copies.velocity)[copies.index(copy, node)];
  };
  const auto position = [&](const unsigned int node) {
    return copies.position_now(copy, node) + 0.5 * dt * velocity(node);
  };
  Vector3 sum;
  for (unsigned int node = 0; node < copies.n_nodes(); ++node)
    sum += copies.nodes.mass[node] * dealii::cross_product_3d(position(node), velocity(node));
  for (const auto &column : columns)
    {
      double mass = 0.;
      for (const unsigned int node : column)
        mass += copies.nodes.mass[node];
      for (unsigned int i = 0; i + 1 < column.size(); ++i)
        sum += factor * mass / n_layers *
               dealii::cross_product_3d(position(column[i + 1]) - position(column[i]),
                                        velocity(column[i + 1]) - velocity(column[i]));
    }
  return sum;
}
} // namespace

int main()
{
  const double factor  = 0.5;
  const auto   part    = make_part();
  const auto   columns = mesh::thickness_columns(*part, mesh::Nodes(*part), mesh::roller_bore);
  std::cout << columns.size() << " columns of " << columns.front().size() << " nodes\n";
  const Hexahedra   reference(*part, Material(), Formulation::enhanced);
  const LinearModel before = model_with(*part, 0.), after = model_with(*part, factor);
  const auto        scaled = elastic(*part, factor);

  Vector<double> x(after.mass.m()), y(x.size()), turning(x.size());
  for (unsigned int i = 0; i < x.size(); ++i)
    x[i] = std::sin(1. + 12.9898 * i * i);
  const mesh::Nodes nodes(*part);
  for (unsigned int n = 0; n < nodes.size(); ++n)
    {
      turning[3 * n]     = -nodes.position[n][1];
      turning[3 * n + 1] = nodes.position[n][0];
    }
  Vector<double> back = x;
  scaled.masses().solve_upper(back);
  after.mass.vmult(y, back);
  scaled.masses().solve_lower(y);
  y -= x;
  verdict("L^-1 M' L^-T is 1 to 1e-12", y.linfty_norm() < 1e-12);

  std::cout << std::fixed << std::setprecision(4);
  const double slower = scaled.largest_frequency() / elastic(*part, 0.).largest_frequency();
  std::cout << "step over that without: " << 1. / slower << '\n';
  // beta m t^2 / n^2 over m (a^2 + b^2) / 2, t the wall
  const double a = 3.76e-3, b = 5.08e-3, t = b - a;
  std::cout << "added inertia about the axis over the closed form of a round tube: "
            << scaled.masses().added(turning) / before.mass.matrix_norm_square(turning) /
                   (factor * t * t / (n_layers * n_layers) / (0.5 * (a * a + b * b)))
            << '\n';
  for (const auto &[n, near] : {std::make_pair(2, 43e3), std::make_pair(3, 110e3)})
    std::cout << "ring with " << n << " waves: frequency over that without "
              << ring_mode(after, *part, near, n) / ring_mode(before, *part, near, n) << '\n';

  double error = 0.;
  for (const double dt : {0.1e-6, 0.05e-6})
    {
      const scene::Scene scene = flying(part, factor);
      dynamics::System   system(scene, false);
      const World       &world = system.world;
      advance(system, 1, dt, []() {});
      const BodyBatches   &copies = world.copies[0];
      std::vector<Vector3> start;
      for (unsigned int copy = 0; copy < copies.n_copies(); ++copy)
        start.push_back(angular_momentum(copies, columns, copy, factor, dt));
      double worst = 0., turned = 0.;
      advance(system, static_cast<unsigned int>(std::lround(1e-4 / dt)), dt, [&]() {
        worst = std::max(worst, std::abs(world.ledger.imbalance()));
      });
      for (unsigned int copy = 0; copy < copies.n_copies(); ++copy)
        turned =
            std::max(turned,
                     (angular_momentum(copies, columns, copy, factor, dt) - start[copy]).norm() /
                         start[copy].norm());
      std::cout << "steps of " << std::setprecision(2) << dt * 1e6 << " us\n";
      verdict("  angular momentum kept to 1e-10", turned < 1e-10);
      verdict("  imbalance below 1e-6 of the energy", worst < 1e-6 * world.ledger.initial);
      if (error > 0.)
        std::cout << "  order of the imbalance in the step " << std::setprecision(1)
                  << std::log2(error / worst) << '\n';
      error = worst;
    }
}
