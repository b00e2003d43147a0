// SPDX-License-Identifier: LGPL-2.1-or-later
// Patch test: on a mesh of distorted hexahedra positions that are a linear function of the
// reference positions give uniform stress. Interior nodes feel no force; the energy is that of the
// stress; the sum of f (x) X is -V P with the first Piola-Kirchhoff stress P. For small
// displacement gradients and for finite deformation of a turned body, eight different ones at a
// time. Those of solid-shells are walls of distorted quadrilaterals in several layers: their
// strains across the wall are taken at its edges, which a wall of varying thickness does not make
// uniform.
#include "../support/elastic.h"

#include <algorithm>
#include <numeric>
#include <vector>

using namespace test;

namespace
{
constexpr double millimetre = 1e-3;

/// Walls in three layers with the faces z = 0, 1, 2 and 3 mm, of quadrilaterals of any form.
mesh::Part walls()
{
  mesh::Part body = brick({4e-3, 3e-3, 3e-3}, {4, 3, 3});
  dealii::GridTools::transform(
      [](const Point<3> &x) {
        const double u = x[0] / millimetre, v = x[1] / millimetre;
        return Point<3>(x[0] + 0.25 * millimetre * std::sin(5. * u + 3. * v),
                        x[1] + 0.25 * millimetre * std::cos(2. * u - 7. * v),
                        x[2]);
      },
      *body.mesh);
  return body;
}

mesh::Part distorted()
{
  mesh::Part body = brick({4e-3, 3e-3, 2.5e-3}, {4, 3, 3});
  dealii::GridTools::distort_random(0.25, *body.mesh, /*keep_boundary*/ false, 3);
  return body;
}
void check(const mesh::Part &body, const Kind &kind)
{
  const Material material;

  std::vector<bool> on_boundary(body.mesh->n_vertices(), false);
  for (const auto &cell : body.mesh->active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary())
        for (const unsigned int v : face->vertex_indices())
          on_boundary[face->vertex_index(v)] = true;
  std::cout << "interior nodes: " << std::count(on_boundary.begin(), on_boundary.end(), false)
            << '\n';

  const mesh::Nodes nodes(body);
  const Hexahedra   reference =
      elements_of(body, material, kind, element::Shape::symmetric_prism, across_plate);
  const double volume =
      std::accumulate(reference.mass.begin(), reference.mass.end(), 0.) / body.density;

  for (const bool finite : {false, true})
    {
      Batch                                  batch(reference, element::best_kernels());
      std::mt19937                           random(5);
      std::uniform_real_distribution<double> uniform(-1., 1.);
      std::array<Tensor<2, 3>, n_lanes>      F;
      for (int lane = 0; lane < n_lanes; ++lane)
        {
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int j = 0; j < 3; ++j)
              F[lane][i][j] = (i == j ? 1. : 0.) + (finite ? 0.2 : 1e-3) * uniform(random);
          if (finite)
            F[lane] = turn(0.7 * lane) * F[lane];
          batch.set(
              batch.position, lane, [&](const Point<3> &x, unsigned int) { return F[lane] * x; });
        }
      batch.add_internal_forces();

      double force = 0., energy = 0., hourglass = 0., stress = 0.;
      for (int lane = 0; lane < n_lanes; ++lane)
        {
          Tensor<2, 3> strain = 0.5 * transpose(F[lane]) * F[lane];
          for (unsigned int i = 0; i < 3; ++i)
            strain[i][i] -= 0.5;
          Tensor<2, 3> S = 2. * reference.mu * strain;
          for (unsigned int i = 0; i < 3; ++i)
            S[i][i] += reference.lambda * trace(strain);
          const Tensor<2, 3> P        = F[lane] * S;
          const double       expected = 0.5 * volume * scalar_product(S, strain);

          Tensor<2, 3> sum = volume * P;
          for (unsigned int node = 0; node < reference.n_nodes(); ++node)
            {
              const Tensor<1, 3> f = batch.get(batch.force, node, lane);
              sum += outer_product(f, Tensor<1, 3>(reference.position[node]));
              if (!on_boundary[nodes.vertex[node]])
                force = std::max(force, f.norm() / (P.norm() * 1e-6)); // cells of about 1 mm2
            }
          stress    = std::max(stress, sum.norm() / (volume * P.norm()));
          energy    = std::max(energy, std::abs(batch.strain_energy(lane) / expected - 1.));
          hourglass = std::max(hourglass, batch.hourglass_energy(lane) / expected);
        }
      std::cout << kind.name << (finite ? ", finite deformation" : ", small gradients")
                << ", to 1e-10: interior forces vanish: " << (force < 1e-10 ? "yes" : "NO")
                << "; energy: " << (energy < 1e-10 ? "yes" : "NO")
                << "; no hourglass energy: " << (hourglass < 1e-10 ? "yes" : "NO")
                << "; stress: " << (stress < 1e-10 ? "yes" : "NO") << '\n';
    }
}
} // namespace

int main()
{
  for (const Kind &kind : kinds)
    check(kind.element_type == parameters::ElementType::solid ? distorted() : walls(), kind);
}
