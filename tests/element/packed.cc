// SPDX-License-Identifier: LGPL-2.1-or-later
// Every width of the kernels gives the forces and energies of the scalar ones, each lane its own;
// forces have no resultant and no moment; the energy's derivative is the force. The kernels for
// prisms, wherever these lie and however their vertices are numbered, do what the general ones do.
// Elements that are alike share their numbers: all 16 of a ring, two above each other if as they
// lie.
#include "../support/elastic.h"

#include <cstdlib>

using namespace test;

namespace
{
mesh::Part small_ring() { return ring(3.76e-3, 5.08e-3, 7e-3, {{1, 8, 2}}); }

/// The ring with its section bent; it stays a prism.
mesh::Part bent_ring()
{
  mesh::Part body = small_ring();
  dealii::GridTools::transform(
      [](const Point<3> &x) {
        return x + Point<3>(5e-4 * std::sin(400. * x[1]), 3e-4 * std::cos(700. * x[0]), 0.);
      },
      *body.mesh);
  return body;
}

/// The ring turned in space, with the vertices of its cells numbered from another one on.
mesh::Part turned_ring()
{
  const mesh::Part                 body = small_ring();
  std::vector<dealii::CellData<3>> cells;
  for (const auto &cell : body.mesh->active_cell_iterators())
    {
      cells.emplace_back();
      for (unsigned int v = 0; v < 8; ++v) // the local axes y, z, x
        cells.back().vertices[v] = cell->vertex_index((v << 1 & 6) | v >> 2);
    }
  std::vector<Point<3>> vertices;
  for (const Point<3> &x : body.mesh->get_vertices())
    vertices.emplace_back(turn(0.4) * x);
  return part(
      [&](dealii::Triangulation<3> &mesh) { mesh.create_triangulation(vertices, cells, {}); });
}

mesh::Part distorted_ring()
{
  mesh::Part body = small_ring();
  dealii::GridTools::distort_random(0.2, *body.mesh, false, 7);
  return body;
}

/// A turned body in each lane, with @p noise [m], moving.
void fill(Batch &batch, const double noise = 1e-6)
{
  std::mt19937                           random(1);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  for (int lane = 0; lane < n_lanes; ++lane)
    {
      const Tensor<2, 3> turned = turn(0.7 * lane);
      batch.set(batch.position, lane, [&](const Point<3> &x, unsigned int) {
        Tensor<1, 3> u = turned * x;
        for (unsigned int i = 0; i < 3; ++i)
          u[i] += noise * uniform(random);
        return u;
      });
      batch.set(batch.velocity, lane, [&](const Point<3> &, unsigned int) {
        Tensor<1, 3> v;
        v[0] = uniform(random);
        v[2] = uniform(random);
        return v;
      });
    }
}

/// Largest difference of forces and energies in parts of the largest force and of each energy.
double difference_of(const Batch &batch, const Batch &right)
{
  double largest = 0., scale = 0.;
  for (const double f : right.force)
    scale = std::max(scale, std::abs(f));
  for (unsigned int i = 0; i < right.force.size(); ++i)
    largest = std::max(largest, std::abs(batch.force[i] - right.force[i]) / scale);
  for (unsigned int i = 0; i < 2 * n_lanes; ++i)
    largest = std::max(largest,
                       std::abs(batch.energy[i] - right.energy[i]) /
                           std::max(right.energy[i % n_lanes], 1e-30));
  return largest;
}

/// Largest difference of the assembled stiffnesses in parts of the largest number.
double stiffness_difference(const Hexahedra &a, const Hexahedra &b)
{
  dealii::SparsityPattern      pattern_a, pattern_b;
  dealii::SparseMatrix<double> k_a, k_b;
  a.assemble(pattern_a, k_a);
  b.assemble(pattern_b, k_b);
  double largest = 0., scale = 0.;
  for (const auto &entry : k_b)
    {
      scale   = std::max(scale, std::abs(entry.value()));
      largest = std::max(largest, std::abs(entry.value() - k_a.el(entry.row(), entry.column())));
    }
  return largest / scale;
}
/// Largest difference between forces, made odd in the displacement, and those of the assembled
/// stiffness, in parts of the largest force.
double small_displacement_difference(const Hexahedra &reference)
{
  Batch forth(reference, *element::kernels(1)), back(reference, *element::kernels(1));
  dealii::Vector<double> u(3 * reference.n_nodes()), force(u);
  for (unsigned int i = 0; i < u.size(); ++i)
    {
      u[i] = 1e-7 * std::sin(1. + i * i);
      forth.position[i * n_lanes] += u[i];
      back.position[i * n_lanes] -= u[i];
    }
  forth.add_internal_forces();
  back.add_internal_forces();
  dealii::SparsityPattern      pattern;
  dealii::SparseMatrix<double> k;
  reference.assemble(pattern, k);
  k.vmult(force, u);
  double largest = 0.;
  for (unsigned int i = 0; i < u.size(); ++i)
    largest = std::max(
        largest, std::abs(force[i] + 0.5 * (forth.force[i * n_lanes] - back.force[i * n_lanes])));
  return largest / force.linfty_norm();
}

/// How many sets of numbers the elements of a part share.
std::size_t n_geometries(const Hexahedra &reference)
{
  return reference.numbers.size() / element::n_numbers(reference.shape, reference.formulation);
}
} // namespace

int main()
{
  const Material material;

  const std::array<std::pair<std::string, std::function<mesh::Part()>>, 4> bodies{
      {{"ring", small_ring},
       {"bent ring", bent_ring},
       {"turned ring", turned_ring},
       {"distorted ring", distorted_ring}}};
  const std::array<std::string, element::n_shapes> shapes{{"general", "prism", "symmetric prism"}};
  for (const auto &[name, make] : bodies)
    {
      const mesh::Part body = make();
      for (const Kind &kind : kinds)
        {
          const Hexahedra reference = elements_of(body, material, kind);
          const Hexahedra general   = elements_of(body, material, kind, element::Shape::general);
          std::cout << name << ", " << kind.name << ": "
                    << shapes[static_cast<int>(reference.shape)] << ", geometries "
                    << n_geometries(reference) << ", as they lie " << n_geometries(general)
                    << "; as the general kernel to 1e-12:";
          for (const int width : {1, 2, 4, 8})
            {
              double difference = stiffness_difference(reference, general);
              if (const element::Kernels *kernels = element::kernels(width))
                {
                  Batch right(general, *kernels), batch(reference, *kernels);
                  fill(right, 1e-5); // well above the rounding of positions
                  fill(batch, 1e-5);
                  right.add_internal_forces();
                  batch.add_internal_forces();
                  difference = std::max(difference, difference_of(batch, right));
                }
              std::cout << (difference < 1e-12 ? " yes" : " NO");
            }
          const double small = small_displacement_difference(reference);
          std::cout << "; as its stiffness at small displacements to 1e-6: "
                    << (small < 1e-6 ? "yes" : "NO") << '\n';
        }
    }

  for (const auto &[name, make] : bodies)
    for (const Kind &kind : kinds)
      {
        const mesh::Part body      = make();
        const Hexahedra  reference = elements_of(body, material, kind);
        Batch            scalar(reference, *element::kernels(1));
        fill(scalar);
        scalar.add_internal_forces();
        double scale = 0.;
        for (const double f : scalar.force)
          scale = std::max(scale, std::abs(f));

        double resultant = 0., moment = 0.;
        for (int lane = 0; lane < n_lanes; ++lane)
          {
            Tensor<1, 3> sum, turning;
            for (unsigned int node = 0; node < reference.n_nodes(); ++node)
              {
                const Tensor<1, 3> f = scalar.get(scalar.force, node, lane);
                sum += f;
                turning += cross_product_3d(scalar.get(scalar.position, node, lane), f);
              }
            resultant = std::max(resultant, sum.norm() / scale);
            moment    = std::max(moment, turning.norm() / (scale * 5e-3));
          }

        // dW = -f . du by central differences, for one lane and a direction of all nodes
        Batch        forth(reference, *element::kernels(1)), back(reference, *element::kernels(1));
        const double step = 1e-9;
        double       work = 0.;
        fill(forth);
        fill(back);
        for (unsigned int i = 0; i < forth.position.size(); ++i)
          {
            const double direction = std::sin(1. + i);
            forth.position[i] += step * direction;
            back.position[i] -= step * direction;
            if (i % n_lanes == 3)
              work -= scalar.force[i] * direction;
          }
        forth.add_internal_forces();
        back.add_internal_forces();
        const double derivative = (forth.strain_energy(3) + forth.hourglass_energy(3) -
                                   back.strain_energy(3) - back.hourglass_energy(3)) /
                                  (2. * step);

        std::cout << name << ", " << kind.name << ": resultant and moment vanish to 1e-12: "
                  << (resultant < 1e-12 && moment < 1e-12 ? "yes" : "NO")
                  << "; derivative of the energy over -f: " << std::fixed << std::setprecision(5)
                  << derivative / work << std::defaultfloat << '\n';

        for (const int width : {2, 4, 8})
          {
            double difference = 0.;
            if (const element::Kernels *kernels =
                    element::kernels(width)) // else nothing to compare
              {
                Batch packed(reference, *kernels);
                fill(packed);
                packed.add_internal_forces();
                difference = difference_of(packed, scalar);
                Batch whole(reference, *element::kernels(1));
                fill(whole);
                Batch wide(reference, *kernels);
                fill(wide);
                for (unsigned int n = 0; n < 10; ++n)
                  {
                    whole.step(1e-8);
                    wide.step(1e-8);
                  }
                for (unsigned int i = 0; i < wide.velocity.size(); ++i)
                  difference =
                      std::max(difference, 1e-3 * std::abs(wide.velocity[i] - whole.velocity[i]));
              }
            std::cout << name << ", " << kind.name << ", width " << width
                      << ": as scalar to 1e-12: " << (difference < 1e-12 ? "yes" : "NO") << '\n';
          }
      }

  for (const char *asked : {"1", "2", "3", "16", "wide"})
    {
      setenv("CHAINDRIVE_SIMD_WIDTH", asked, 1);
      try
        {
          const std::string name = element::best_kernels().name;
          std::cout << "asked for " << asked << ": " << name << '\n';
        }
      catch (const InputError &)
        {
          std::cout << "asked for " << asked << ": refused\n";
        }
    }
}
