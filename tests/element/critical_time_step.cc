// SPDX-License-Identifier: LGPL-2.1-or-later
// The largest natural frequency of free parts by Lanczos' method against all eigenvalues by LAPACK:
// never too small, and too large by its residual at most. Small parts at 0.98 of the step 2 / omega
// stay bounded for 100,000 steps and blow up at 1.02.
#include "../support/elastic.h"

#include <chaindrive/drive/chain.h>
#include <chaindrive/mesh/generate/links.h>

#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <utility>
#include <vector>

using namespace test;

namespace
{
/// The largest natural frequency from the dense matrix M^-1/2 K M^-1/2, rad/s.
double exact_frequency(const Hexahedra &reference)
{
  dealii::SparsityPattern      pattern;
  dealii::SparseMatrix<double> matrix;
  reference.assemble(pattern, matrix);
  dealii::LAPACKFullMatrix<double> scaled(matrix.m(), matrix.m());
  for (unsigned int row = 0; row < matrix.m(); ++row)
    for (auto entry = matrix.begin(row); entry != matrix.end(row); ++entry)
      scaled(row, entry->column()) =
          entry->value() / std::sqrt(reference.mass[row / 3] * reference.mass[entry->column() / 3]);

  const double               bound = 1.01 * scaled.linfty_norm(); // Gershgorin
  dealii::Vector<double>     eigenvalues;
  dealii::FullMatrix<double> eigenvectors;
  scaled.compute_eigenvalues_symmetric(0.3 * bound, bound, 0., eigenvalues, eigenvectors);
  return std::sqrt(eigenvalues[eigenvalues.size() - 1]);
}

/// How many steps of 2 / omega times @p factor pass until any lane's energy is a thousand times the
/// energy of the start, which is that of motion in a random direction; at most @p steps.
unsigned int bounded_steps(const Hexahedra &reference, const double factor, unsigned int steps)
{
  Batch                                  batch(reference, element::best_kernels());
  std::mt19937                           random(1);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  for (int lane = 0; lane < n_lanes; ++lane)
    batch.set(batch.velocity, lane, [&](const Point<3> &, unsigned int) {
      Tensor<1, 3> v; // of about 0.3 MPa
      for (unsigned int i = 0; i < 3; ++i)
        v[i] = 0.01 * uniform(random);
      return v;
    });

  const double                dt = factor * 2. / reference.largest_frequency();
  std::array<double, n_lanes> start{};
  for (unsigned int step = 0; step < steps; ++step)
    {
      batch.step(dt);
      for (int lane = 0; lane < n_lanes; ++lane)
        {
          const double energy = batch.total_energy(lane);
          if (step == 0)
            start[lane] = energy;
          if (!(energy < 1e3 * start[lane])) // what is not a number too
            return step;
        }
    }
  return steps;
}
} // namespace

int main()
{
  const Material                                  material;
  std::vector<std::pair<std::string, mesh::Part>> parts;
  parts.emplace_back("cube", brick({1e-3, 1e-3, 1e-3}, {1, 1, 1}));
  parts.emplace_back("distorted cube", brick({1e-3, 1e-3, 1e-3}, {1, 1, 1}));
  parts.emplace_back("eight distorted cubes", brick({2e-3, 2e-3, 2e-3}, {2, 2, 2}));
  for (unsigned int p : {1, 2})
    dealii::GridTools::distort_random(0.2, *parts[p].second.mesh, /*keep_boundary*/ false, 3);
  parts.emplace_back("roller 1x24x4",
                     mesh::make_roller(drive::make_chain(parameters::Chain()),
                                       material.density,
                                       mesh::RollerGrid(1, 24, 4)));

  const double c_d = std::sqrt(
      material.youngs_modulus * (1. - material.poissons_ratio) /
      ((1. + material.poissons_ratio) * (1. - 2. * material.poissons_ratio) * material.density));
  std::cout << std::fixed << std::setprecision(4);
  for (const auto &part : parts)
    for (const Kind &kind : kinds)
      {
        const Hexahedra reference = elements_of(part.second, material, kind);
        const double    found = reference.largest_frequency(), exact = exact_frequency(reference);
        std::cout << part.first << ", " << kind.name << ": limit over 1 mm / c_d "
                  << 2. / exact * c_d / 1e-3 << "; omega found from above, within a millionth: "
                  << (found > (1. - 1e-9) * exact && found < (1. + 1e-6) * exact ? "yes" : "NO")
                  << '\n';
        // the normals of a single membrane have so little stiffness that they leave small angles
        if (reference.n_elements() <= 8 && kind.element_type != parameters::ElementType::membrane)
          std::cout << part.first << ", " << kind.name << ": bounded at 0.98 of the limit: "
                    << (bounded_steps(reference, 0.98, 100000) == 100000 ? "yes" : "NO")
                    << "; blown up at 1.02: "
                    << (bounded_steps(reference, 1.02, 2000) < 2000 ? "yes" : "NO") << '\n';
      }
}
