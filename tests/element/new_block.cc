// SPDX-License-Identifier: LGPL-2.1-or-later
// A block of elements that chaindrive does not have, made here and nowhere else: bars along the
// four diagonals of a cube, beside a hexahedron that fills it. The natural frequency of a bar alone
// is sqrt(k (1/m + 1/M)); the matrix of both blocks is the derivative of their forces; and the bars
// make the cube faster.
#include "../support/elastic.h"

#include <chaindrive/element/element_block.h>

#include <deal.II/lac/vector.h>

using namespace test;

using Blocks = std::vector<const element::ElementBlock *>;

class Bars : public element::ElementBlock
{
public:
  Bars(const double stiffness, const std::vector<Point<3>> &position) : k_(stiffness), x_(position)
  {
  }

  unsigned int n_elements() const override { return static_cast<unsigned int>(x_.size()) / 2; }

  std::vector<unsigned int> nodes_of(const unsigned int e) const override
  {
    return {e, static_cast<unsigned int>(x_.size()) - 1 - e};
  }

  void add_forces(const element::BatchState &batch) const override
  {
    for (unsigned int e = 0; e < n_elements(); ++e)
      for (int lane = 0; lane < n_lanes; ++lane)
        {
          const auto   nodes = nodes_of(e);
          Tensor<1, 3> now;
          for (unsigned int d = 0; d < 3; ++d)
            now[d] = batch.position[Batch::index(nodes[1], d, lane)] -
                     batch.position[Batch::index(nodes[0], d, lane)];
          const double stretch = now.norm() - (x_[nodes[1]] - x_[nodes[0]]).norm();
          batch.strain_energy[lane] += 0.5 * k_ * stretch * stretch;
          for (unsigned int d = 0; d < 3; ++d)
            {
              const double f = k_ * stretch * now[d] / now.norm();
              batch.force[Batch::index(nodes[0], d, lane)] += f;
              batch.force[Batch::index(nodes[1], d, lane)] -= f;
            }
        }
  }

  dealii::FullMatrix<double> element_stiffness(const unsigned int e) const override
  {
    const auto         nodes = nodes_of(e);
    const Tensor<1, 3> axis  = (x_[nodes[1]] - x_[nodes[0]]) / (x_[nodes[1]] - x_[nodes[0]]).norm();
    dealii::FullMatrix<double> k(6, 6);
    for (unsigned int r = 0; r < 6; ++r)
      for (unsigned int c = 0; c < 6; ++c)
        k(r, c) = (r / 3 == c / 3 ? k_ : -k_) * axis[r % 3] * axis[c % 3];
    return k;
  }

  std::unique_ptr<const element::StressRecovery>
  make_stress_recovery(const mesh::Part &, const mesh::Nodes &, const Material &) const override
  {
    return nullptr;
  }

  std::size_t memory_consumption() const override { return x_.size() * sizeof(Point<3>); }

private:
  double                k_;
  std::vector<Point<3>> x_;
};

int main()
{
  const Material material;
  const double   h = 1e-3, k = material.youngs_modulus * h;

  const Bars   one(k, {Point<3>(), Point<3>(h, 2. * h, 3. * h)});
  const double m = 1e-6, M = 3e-6;
  std::cout << "frequency of a bar over the closed form: " << std::setprecision(8)
            << element::largest_frequency(Blocks{&one}, {m, M}, {}) /
                   std::sqrt(k * (1. / m + 1. / M))
            << '\n';

  const mesh::Part body = brick(Point<3>(h, h, h), {1, 1, 1});
  const Hexahedra  cube(body, material, Formulation::enhanced);
  const Bars       bars(k, cube.position);

  dealii::SparsityPattern      pattern;
  dealii::SparseMatrix<double> matrix;
  element::assemble({&cube, &bars}, cube.n_nodes(), pattern, matrix);
  std::mt19937                           random(1);
  std::uniform_real_distribution<double> within(-1., 1.);
  dealii::Vector<double>                 u(24), product(24);
  for (double &value : u)
    value = within(random);
  matrix.vmult(product, u);
  Batch                     batch(cube, element::best_kernels());
  const double              small = 1e-6 * h;
  const element::BatchState state{batch.position.data(),
                                  batch.force.data(),
                                  batch.energy.data(),
                                  batch.energy.data() + n_lanes};
  for (const double sign : {1., -1.}) // of lanes 0 and 1
    batch.set(batch.position, sign > 0. ? 0 : 1, [&](const Point<3> &x, const unsigned int node) {
      Tensor<1, 3> moved = x;
      for (unsigned int d = 0; d < 3; ++d)
        moved[d] += sign * small * u[3 * node + d];
      return moved;
    });
  for (const element::ElementBlock *block :
       std::vector<const element::ElementBlock *>{&cube, &bars})
    block->add_forces(state);
  double error = 0.;
  for (unsigned int i = 0; i < 24; ++i)
    {
      const double slope = (batch.force[Batch::index(i / 3, i % 3, 1)] -
                            batch.force[Batch::index(i / 3, i % 3, 0)]) /
                           (2. * small);
      error = std::max(error, std::abs(slope - product[i]));
    }
  std::cout << "the matrix of both is the derivative of their forces to 1e-8: "
            << (error < 1e-8 * product.linfty_norm() ? "yes" : "NO") << '\n';
  std::cout << "the cube is faster with bars: "
            << (element::largest_frequency(Blocks{&cube, &bars}, cube.mass, {}) >
                        1.1 * cube.largest_frequency() ?
                    "yes" :
                    "NO")
            << '\n';
}
