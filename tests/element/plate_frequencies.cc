// SPDX-License-Identifier: LGPL-2.1-or-later
// The first three frequencies of a thin square plate, thickness 1/100 of its edge, on meshes of
// N x N elements with one through the thickness, over Kirchhoff's: simply supported (closed form,
// pi^2 (m^2 + n^2)) and clamped (35.992, 73.413, 108.27; A. W. Leissa, The free vibration of
// rectangular plates, J. Sound Vib. 31 (1973) 257). Both nodes of an edge are held across the
// plate, and along the edge or, clamped, in all directions. Bricks are beside solid-shells.
#include "../support/modes.h"

using namespace test;

namespace
{
constexpr double PI = dealii::numbers::PI;

struct Support
{
  std::string           name;
  bool                  clamped;
  std::array<double, 3> number; ///< angular frequency times a^2 sqrt(rho h / D)
};

constexpr double edge = 0.1, thickness = 1e-3; // m

/// The first three different frequencies, Hz; the second one is that of two modes.
std::array<double, 3>
frequencies(const Kind &kind, const Support &support, const unsigned int n, const double near)
{
  const Material   material;
  const mesh::Part body = brick({edge, edge, thickness}, {n, n, 1});
  const Hexahedra  reference =
      elements_of(body, material, kind, element::Shape::symmetric_prism, across_plate);
  LinearModel model(reference);
  model.constrain(reference, [&](const Point<3> &x, const unsigned int i) {
    const auto on_edge = [&x](const unsigned int d) { return x[d] < 1e-9 || x[d] > edge - 1e-9; };
    if (support.clamped || i == 2)
      return on_edge(0) || on_edge(1);
    return on_edge(1 - i); // along this edge
  });
  const std::vector<Mode> modes = natural_modes(model, near, 4);
  return {
      {modes[0].frequency, 0.5 * (modes[1].frequency + modes[2].frequency), modes[3].frequency}};
}
} // namespace

int main()
{
  const Material material;
  const double   D = material.youngs_modulus * std::pow(thickness, 3) /
                   (12. * (1. - std::pow(material.poissons_ratio, 2)));
  const double unit =
      std::sqrt(D / (material.density * thickness)) / (edge * edge) / (2. * PI); // Hz
  std::cout << std::fixed << std::setprecision(3);
  for (const Support &support :
       {Support{"simply supported", false, {{2. * PI * PI, 5. * PI * PI, 8. * PI * PI}}},
        Support{"clamped", true, {{35.992, 73.413, 108.27}}}})
    for (const Kind &kind : kinds)
      if (kind.formulation == Formulation::enhanced &&
          kind.element_type != parameters::ElementType::membrane)
        {
          std::array<double, 3> error{};
          unsigned int          level = 0;
          for (const unsigned int n : {6, 12, 24})
            {
              std::cout << support.name << ", " << kind.name << ", " << n << " x " << n << ':';
              const auto found = frequencies(kind, support, n, 0.5 * support.number[0] * unit);
              for (unsigned int m = 0; m < 3; ++m)
                {
                  const double ratio = found[m] / (support.number[m] * unit);
                  std::cout << ' ' << ratio;
                  error[level] = std::max(error[level], std::abs(ratio - 1.));
                }
              std::cout << '\n';
              ++level;
            }
          if (kind.element_type == parameters::ElementType::solid_shell)
            std::cout << "- within 1 % on the last mesh: " << (error[2] < 0.01 ? "yes" : "NO")
                      << "; largest error divided by two and a half or more by each refinement: "
                      << (error[0] > 2.5 * error[1] && error[1] > 2.5 * error[2] ? "yes" : "NO")
                      << '\n';
        }
}
