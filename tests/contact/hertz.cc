// SPDX-License-Identifier: LGPL-2.1-or-later
// A solid cylinder is pressed between two rigid flats in plane strain; the nodes of its outside are
// slaves. Load against shortening as in the closed form of Hertz' line contact [Johnson, Contact
// Mechanics, section 5.6]: with the load q per length, E' = E / (1 - nu^2) and the half width
// b = sqrt(4 q R / (pi E')), centre and flat approach each other by
//
//   q (2 ln(4 R / b) - 1) / (pi E').
//
// A quarter of the cylinder, its mesh graded towards the contact; at rest, see support/statics.h.
// The penalty per area is one element's own stiffness, E over its size: what it deflects by is
// most of the error and vanishes with the size.
#include "../support/scenes.h"
#include "../support/statics.h"

#include <chaindrive/bodies/make_world.h>
#include <chaindrive/contact/node_contact.h>

using namespace test;
using dealii::numbers::PI;

namespace
{
const double R = 5.08e-3, hole = 0.02 * R, length = 0.05e-3;

/// A quarter, from the lowest point round to +x, with cells of the size @p h [m] at the contact
/// that grow by the factor @p growth from there on.
mesh::Part quarter(const double h, const double growth)
{
  const auto grown = [&](const double total) { // places from 0 to 1
    const unsigned int n = static_cast<unsigned int>(
        std::ceil(std::log(1. + total * (growth - 1.) / h) / std::log(growth)));
    std::vector<double> place;
    for (unsigned int i = 0; i <= n; ++i)
      place.push_back((std::pow(growth, i) - 1.) / (std::pow(growth, n) - 1.));
    return place;
  };
  const std::vector<double> depth = grown(R - hole), angle = grown(0.5 * PI * R);
  mesh::Part                body = part([&](dealii::Triangulation<3> &mesh) {
    dealii::GridGenerator::subdivided_hyper_rectangle(
        mesh,
        {static_cast<unsigned int>(angle.size() - 1),
         static_cast<unsigned int>(depth.size() - 1),
         1},
        Point<3>(),
        Point<3>(angle.size() - 1., depth.size() - 1., 1.),
        /*colorize*/ true);
  });
  dealii::GridTools::transform(
      [&](const Point<3> &x) {
        const double phi = 0.5 * PI * angle[std::lround(x[0])],
                     r   = R - (R - hole) * depth[std::lround(x[1])];
        return Point<3>(r * std::sin(phi), -r * std::cos(phi), length * x[2]);
      },
      *body.mesh);
  for (const auto &cell : body.mesh->active_cell_iterators())
    cell->set_material_id(mesh::roller);
  return body;
}
/// Load per length [N/m] of the quarter whose upper side has been lowered by @p approach [m].
double load_of(const double approach, const double h, const double stiffness_factor)
{
  scene::Scene scene               = empty_scene();
  const double E                   = scene.material.youngs_modulus;
  scene.parts[scene::Kind::roller] = std::make_shared<const mesh::Part>(quarter(h, 1.15));
  scene.bodies                     = {
                          body(scene::Motion::elastic, scene::Mount::free(), 1., vector(1., 1., 1.), vector(0., 0.)),
                          ground()};
  scene.bodies[1].initial.position = vector(0., -R);
  scene::ContactLaw law;
  law.stiffness = stiffness_factor * E / h; // per area
  scene::SurfaceFamily family =
      on_surface(plane(1, vector(0., 1.)), law, {{0, dealii::Point<3>(), R, 0}});
  family.elastic       = true;
  family.slave_surface = 2; // colour of the outside

  World                world  = make_world(scene);
  BodyBatches         &copies = world.copies[0];
  contact::NodeContact flat(family, world, true);
  flat.search(world, R);
  const Hexahedra reference(
      *scene.parts[scene::Kind::roller], copies.nodes, scene.material, Formulation::enhanced);
  const auto contact = [&](const Vector<double> &u, Vector<double> &c) {
    copies.force = 0.;
    for (unsigned int i = 0; i < u.size(); ++i)
      NodeView(copies.position).component(copies.index(0, i / 3), i % 3) =
          reference.position[i / 3][i % 3] + u[i];
    flat.add_forces(world, 0.);
    for (unsigned int i = 0; i < u.size(); ++i)
      c[i] = NodeView(copies.force).component(copies.index(0, i / 3), i % 3);
  };

  Statics                   statics({&reference});
  std::vector<unsigned int> touched;
  for (unsigned int node = 0; node < reference.n_nodes(); ++node)
    {
      const Point<3> &x          = reference.position[node];
      statics.u[3 * node + 1]    = -approach;
      statics.held[3 * node]     = x[0] < 1e-9;
      statics.held[3 * node + 1] = x[1] > -1e-9;
      statics.held[3 * node + 2] = true;
      if (x[1] + R < 2. * approach)
        touched.push_back(3 * node + 1);
    }
  if (statics.solve(contact, touched, 1e-9) == 0)
    std::cout << "no equilibrium\n";
  Vector<double> c(statics.size);
  contact(statics.u, c);
  return 2. * flat.records()[0].force[1] / length;
}
} // namespace

int main()
{
  const parameters::Material material;
  const double plane_strain = material.youngs_modulus / (1. - std::pow(material.poissons_ratio, 2));
  for (const double b : {0.01 * R, 0.03 * R})
    {
      const double q        = b * b * PI * plane_strain / (4. * R);
      const double approach = q * (2. * std::log(4. * R / b) - 1.) / (PI * plane_strain);
      std::cout << "half width " << b / R << " R\n";
      std::array<double, 3> error{};
      for (unsigned int level = 0; level < 3; ++level)
        {
          const double h = b / (3. * (1u << level));
          error[level]   = load_of(approach, h, 1.) / q - 1.;
          ratio("  load, cells of b / " + std::to_string(3u << level), 1. + error[level], 1., 3);
        }
      ratio("  load, the same with ten times the penalty", load_of(approach, b / 12., 10.), q, 3);
      std::cout << "  order " << std::fixed << std::setprecision(1)
                << std::log2(error[0] / error[1]) << ' ' << std::log2(error[1] / error[2])
                << std::defaultfloat << '\n';
    }
}
