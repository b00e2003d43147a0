// SPDX-License-Identifier: LGPL-2.1-or-later
// Free modes and the displacements of a part that nothing holds.
//
// - A cube, most of whose frequencies are equal to others, against LAPACK's solution of the dense
//   problem: all modes up to a limit, each to a millionth.
// - A thin ring, of which half is meshed, against the closed form of bending without extension in
//   its plane (Blevins, Formulas for Natural Frequency and Mode Shape, ch. 9), omega^2 = E h^2/(12
//   rho R^4) n^2 (n^2 - 1)^2/(n^2 + 1), which leaves out shear and rotation, of order (n h / R)^2:
//   twice each, and the convergence to it.
// - A link that is pulled, against the same on very soft springs.
#include "../support/modes.h"

#include <chaindrive/drive/chain.h>
#include <chaindrive/mesh/generate/links.h>
#include <chaindrive/reduction/free_modes.h>
#include <chaindrive/reduction/tractions.h>
#include <chaindrive/utilities/eigenvalue.h>

using namespace test;
using dealii::numbers::PI;

namespace
{
const Material material;

reduction::FreePart free_part(const mesh::Part &part)
{
  const mesh::Nodes nodes(part);
  return {part, nodes, element::ElasticPart(part, nodes, material, parameters::Elements())};
}

void cube()
{
  const mesh::Part           body = brick({0.01, 0.01, 0.01}, {3, 3, 3});
  const LinearModel          model(Hexahedra(body, material, Formulation::enhanced));
  const unsigned int         n = model.stiffness.m();
  dealii::FullMatrix<double> scaled(n, n);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      scaled(i, j) = model.stiffness.el(i, j) /
                     std::sqrt(model.mass.diag_element(i) * model.mass.diag_element(j));
  const Vector<double> exact = eigenpairs(scaled).values;

  unsigned int n_modes = 40; // but not some of several that are equal
  while (exact[6 + n_modes] < 1.001 * exact[6 + n_modes - 1])
    ++n_modes;
  const double highest = std::sqrt(0.5 * (exact[6 + n_modes - 1] + exact[6 + n_modes]));
  const auto   part    = free_part(body);
  const auto   modes   = reduction::free_modes(part, highest);
  double       worst = 0., mass = 0., rigid = 0.;
  unsigned int n_equal = 0;
  for (unsigned int i = 0; i < modes.size(); ++i)
    {
      worst = std::max(worst, std::abs(modes[i].omega / std::sqrt(exact[6 + i]) - 1.));
      n_equal += i > 0 && modes[i].omega < (1. + 1e-9) * modes[i - 1].omega;
      for (unsigned int j = 0; j < modes.size(); ++j)
        mass = std::max(mass,
                        std::abs(part.mass_product(modes[i].vector, modes[j].vector) - (i == j)));
      for (const auto &motion : part.rigid())
        rigid = std::max(rigid, std::abs(part.mass_product(motion, modes[i].vector)));
    }
  std::cout << "cube: modes found " << modes.size()
            << ", all: " << (modes.size() == n_modes ? "yes" : "NO") << ", equal to the one before "
            << n_equal << ", frequencies of the dense problem to a millionth: "
            << (worst < 1e-6 ? "yes" : "NO")
            << ", orthonormal to 1e-10: " << (mass < 1e-10 ? "yes" : "NO") << ", and to "
            << part.rigid().size() << " rigid motions: " << (rigid < 1e-10 ? "yes" : "NO") << '\n';
}

void thin_ring()
{
  const double R = 0.01, h = 2e-4;
  const auto   closed_form = [&](const double n) {
    return std::sqrt(material.youngs_modulus * h * h / (12. * material.density)) / (R * R) * n *
           (n * n - 1.) / std::sqrt(n * n + 1.);
  };
  std::array<std::vector<reduction::Mode>, 3> modes;
  for (unsigned int level = 0; level < 3; ++level)
    {
      mesh::Part body = ring(R - 0.5 * h, R + 0.5 * h, 0.5 * h, {{1, 32u << level, 1}});
      body.half       = true;
      modes[level]    = reduction::free_modes(free_part(body), 1.3 * closed_form(3.));
    }
  for (const unsigned int i : {0, 1, 2, 3})
    {
      const double a = modes[0].at(i).omega, b = modes[1].at(i).omega, c = modes[2].at(i).omega;
      std::cout << "ring, n = " << 2 + i / 2 << ": over the closed form " << std::fixed
                << std::setprecision(4) << c / closed_form(2. + i / 2) << ", last refinements by "
                << std::setprecision(1) << 1e3 * (b / a - 1.) << " and " << 1e3 * (c / b - 1.)
                << " thousandths\n";
    }
  std::cout << "ring: modes " << modes[2].size() << '\n';
}

void pulled_link()
{
  const auto        chain = drive::make_chain(parameters::Chain());
  const mesh::Part  body = mesh::make_outer_link(chain, material.density, mesh::outer_link_grid(1));
  const auto        part = free_part(body);
  const auto        load = reduction::contact_loads(body, mesh::Nodes(body)).front();
  const LinearModel model(Hexahedra(body, material, Formulation::enhanced));
  const double      ratio = load.force * part.displacement(load.force) /
                       (load.force * model.displacements(load.force, 100.));
  std::cout << "outer link, " << load.name << ": compliance over that on soft springs "
            << std::setprecision(6) << ratio << '\n';

  // a single force accelerates it
  reduction::Vector force(part.n_unknowns()), inertia(part.n_unknowns());
  force[1]                  = 1e3;
  const reduction::Vector u = part.displacement(force);
  part.stiffness().vmult(inertia, u);
  inertia -= force;
  double rigid = 0.;
  for (const auto &motion : part.rigid())
    {
      rigid = std::max(rigid,
                       std::abs(part.mass_product(motion, u)) / std::sqrt(part.mass_product(u, u)));
      reduction::Vector along(part.n_unknowns());
      part.mass().vmult(along, motion);
      inertia.add(motion * force, along);
    }
  std::cout << "outer link, one force: balanced by inertia "
            << (inertia.l2_norm() < 1e-9 * force.l2_norm() ? "yes" : "NO") << ", no rigid motion "
            << (rigid < 1e-10 ? "yes" : "NO") << '\n';
}
} // namespace

int main()
{
  cube();
  thin_ring();
  pulled_link();
}
