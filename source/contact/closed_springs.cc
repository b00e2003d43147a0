// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/closed_springs.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace chaindrive::contact
{
std::vector<ClosedSpring> closed_springs(const mesh::CylinderGrid        &bore,
                                         const std::vector<unsigned int> &bore_of_vertex,
                                         const mesh::CylinderGrid        &cylinder,
                                         const std::vector<unsigned int> &of_vertex,
                                         const double                     stiffness)
{
  const unsigned int        n = bore.n_circumferential(), last = cylinder.n_rings() - 1;
  const double              width = 2. * dealii::numbers::PI / n;
  std::vector<ClosedSpring> springs;
  for (unsigned int s = 0; s <= last; ++s)
    {
      const double z = cylinder.rings[s];
      const double fade =
          (s == 0 || s == last ? 0.5 : 0.25) *
          (cylinder.rings[std::min(s + 1, last)] - cylinder.rings[s == 0 ? 0 : s - 1]);
      const double cover = std::clamp(bore.depth(z) / fade, 0., 1.);
      if (cover == 0.)
        continue;
      const auto   above = std::upper_bound(bore.rings.begin() + 1, bore.rings.end() - 1, z);
      const auto   upper = static_cast<unsigned int>(above - bore.rings.begin());
      const double along = std::clamp(
          (z - bore.rings[upper - 1]) / (bore.rings[upper] - bore.rings[upper - 1]), 0., 1.);
      for (unsigned int c = 0; c < cylinder.n_circumferential(); ++c)
        {
          // between which two columns of the bore, and where between them
          const double place = (cylinder.angles[c] - bore.angles[0]) / width,
                       below = std::floor(place + 1e-9), around = std::max(0., place - below);
          const auto first =
              static_cast<unsigned int>((static_cast<int>(below) % int(n) + int(n)) % int(n));
          ClosedSpring spring;
          spring.node      = of_vertex[cylinder.vertex_at(s, c)];
          spring.stiffness = stiffness * cover * cylinder.area(s, c);
          spring.normal[0] = std::cos(cylinder.angles[c]);
          spring.normal[1] = std::sin(cylinder.angles[c]);
          for (unsigned int i = 0; i < 4; ++i)
            {
              spring.bore_nodes[i] =
                  bore_of_vertex[bore.vertex_at(upper - 1 + i / 2, (first + i % 2) % n)];
              spring.weights[i] =
                  (i / 2 == 1 ? along : 1. - along) * (i % 2 == 1 ? around : 1. - around);
            }
          springs.push_back(spring);
        }
    }
  return springs;
}
} // namespace chaindrive::contact
