// SPDX-License-Identifier: LGPL-2.1-or-later
// The stiffness that the kernels use is the element's own: mean gradient and hourglass matrix
// together give the matrix from which they were condensed, on a distorted hexahedron too. Natural
// frequencies of a free cube against closed forms and published values. The enhanced element bends
// as a beam.
#include "../support/elastic.h"

#include <chaindrive/element/hexahedron_stiffness.h>

using namespace test;

namespace
{
/// The unit cube of edge @p h with its corners moved by up to a fifth of it.
mesh::Corners distorted(const double h)
{
  mesh::Corners x;
  for (unsigned int v = 0; v < 8; ++v)
    for (unsigned int d = 0; d < 3; ++d)
      x[v][d] = h * (((v >> d) & 1) + 0.2 * std::sin(1. + 7. * v + 3. * d));
  return x;
}

mesh::Part single(const mesh::Corners &x)
{
  return part([&](dealii::Triangulation<3> &mesh) {
    std::vector<dealii::CellData<3>> cells(1);
    for (unsigned int v = 0; v < 8; ++v)
      cells[0].vertices[v] = v;
    mesh.create_triangulation({x.begin(), x.end()}, cells, {});
  });
}

double relative_difference(const dealii::FullMatrix<double> &a, const dealii::FullMatrix<double> &b)
{
  dealii::FullMatrix<double> difference(a);
  difference.add(-1., b);
  return difference.frobenius_norm() / b.frobenius_norm();
}
} // namespace

int main()
{
  const Material material;
  const double   E = material.youngs_modulus, nu = material.poissons_ratio, rho = material.density;
  const double   c_d = std::sqrt(E * (1. - nu) / ((1. + nu) * (1. - 2. * nu) * rho));

  std::cout << std::fixed << std::setprecision(3);
  for (const bool cube : {true, false})
    for (const bool enhanced : {true, false})
      {
        mesh::Corners x = distorted(1e-3);
        if (cube)
          for (unsigned int v = 0; v < 8; ++v)
            for (unsigned int d = 0; d < 3; ++d)
              x[v][d] = 1e-3 * ((v >> d) & 1);
        const Hexahedra reference(
            single(x), material, enhanced ? Formulation::enhanced : Formulation::full);
        const auto k = element::stiffness(mesh::gauss_points(x), material, enhanced);
        std::cout << (cube ? "cube, " : "distorted, ") << (enhanced ? "enhanced" : "full")
                  << ": kernels' stiffness differs by less than 1e-14: "
                  << (relative_difference(reference.element_stiffness(0), k) < 1e-14 ? "yes" : "NO")
                  << '\n';
      }

  mesh::Corners x;
  for (unsigned int v = 0; v < 8; ++v)
    for (unsigned int d = 0; d < 3; ++d)
      x[v][d] = 1e-3 * ((v >> d) & 1);
  const auto points = mesh::gauss_points(x);
  const auto masses = mesh::lumped_masses(points, rho);
  for (const auto &formulation : formulations)
    {
      const Hexahedra reference(single(x), material, formulation.first);
      std::cout << "free cube, " << formulation.second << ", omega h / c_d:";
      for (const double omega :
           element::natural_frequencies(reference.element_stiffness(0), masses))
        std::cout << ' ' << omega * 1e-3 / c_d;
      std::cout << '\n';
    }

  // Pure bending with curvature kappa: a beam's energy is E I L kappa^2 / 2 with I = b h^3 / 12.
  // Its deflection is left to the incompatible modes, which the vertices do not show.
  const double length = 3e-3, height = 0.5e-3, width = 0.7e-3;
  for (unsigned int v = 0; v < 8; ++v)
    x[v] = Point<3>(
        ((v & 1) - 0.5) * length, (((v >> 1) & 1) - 0.5) * height, ((v >> 2) - 0.5) * width);
  for (const auto &formulation : formulations)
    {
      const Hexahedra        reference(single(x), material, formulation.first);
      dealii::Vector<double> u(24), force(24);
      const double           kappa = 1.;
      for (unsigned int v = 0; v < 8; ++v)
        {
          u[3 * v]     = kappa * x[v][0] * x[v][1];
          u[3 * v + 2] = -nu * kappa * x[v][1] * x[v][2]; // the section is free to change its width
        }
      reference.element_stiffness(0).vmult(force, u);
      const double energy = 0.5 * (u * force);
      const double beam =
          0.5 * E * (width * height * height * height / 12.) * length * kappa * kappa;
      std::cout << "bending energy of one element over a beam's, " << formulation.second << ": "
                << energy / beam << '\n';
    }
}
