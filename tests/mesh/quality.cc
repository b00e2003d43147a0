// SPDX-License-Identifier: LGPL-2.1-or-later
// No cell of any part of any chain is inverted or nearly so, those of sprockets that are pictures
// included; the worst corners are printed. Chain 35 has no rollers.

#include <chaindrive/mesh/generate/links.h>
#include <chaindrive/mesh/generate/sprocket.h>
#include <chaindrive/mesh/quality.h>

#include <algorithm>
#include <iomanip>
#include <iostream>

using namespace chaindrive;

namespace
{
double worst(const mesh::Part &part)
{
  double worst = 1.;
  for (const auto &cell : part.mesh->active_cell_iterators())
    worst = std::min(worst, mesh::scaled_jacobian(mesh::corners_of(cell)));
  return worst;
}
} // namespace

int main()
{
  std::cout << std::fixed << std::setprecision(2)
            << "worst scaled Jacobian of roller, inner link, outer link, sprocket 9, 31 teeth, "
               "pictures of these\n";
  for (const std::string designation : {"525", "06B", "08B", "12A", "35", "200"})
    for (const auto form_name : {parameters::StandardForm::iso_min, parameters::StandardForm::ansi})
      for (const unsigned int level : {0, 1})
        {
          parameters::Chain chosen;
          chosen.designation          = designation;
          const auto            chain = drive::make_chain(chosen);
          parameters::Sprockets sprockets;
          sprockets.tooth_form = form_name;
          std::cout << designation << ' ' << text_of(form_name) << " level " << level << ": "
                    << (chain.has_rollers ? worst(mesh::make_roller(chain, 7600., level)) : 1.)
                    << ' '
                    << worst(mesh::make_inner_link(chain, 7600., mesh::inner_link_grid(level)))
                    << ' '
                    << worst(mesh::make_outer_link(chain, 7600., mesh::outer_link_grid(level)));
          for (const bool picture : {false, true})
            for (const unsigned int z : {9, 31})
              {
                const auto   form = drive::make_tooth_form(z, chain, sprockets, 0);
                const double hub  = 0.7 * form.root_diameter;
                std::cout << ' '
                          << worst(mesh::make_sprocket(form,
                                                       {0.8 * hub, hub, 0.4 * chain.pitch},
                                                       7600.,
                                                       level,
                                                       false,
                                                       picture));
              }
          std::cout << '\n';
        }
}
