// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/catalogue.h>
#include <chaindrive/drive/chain_mass.h>
#include <chaindrive/utilities/text.h>

#include <cmath>

namespace chaindrive::drive
{
namespace
{
/// Of the solids of a roller and half of either link, kg.
double mass_of_solids(const Drive &d)
{
  return d.roller_solid.mass + 0.5 * (d.inner_link_solid.mass + d.outer_link_solid.mass);
}
} // namespace

void set_chain_mass(const Parameters &parameters, Drive &d)
{
  const double density    = parameters.material.density;
  const auto   set_solids = [&d, density] {
    d.roller_solid     = roller_solid(d.chain, density);
    d.inner_link_solid = inner_link_solid(d.chain, density);
    d.outer_link_solid = outer_link_solid(d.chain, density);
    d.mass_per_pitch   = mass_of_solids(d);
  };
  set_solids();
  const CatalogueChain *row = find_chain(d.chain.designation);
  if (row == nullptr || row->mass_per_metre <= 0. || parameters.model.mass_per_pitch ||
      has_own_dimensions(d.chain))
    return;
  const double listed = row->mass_per_metre * d.chain.pitch, solids = d.mass_per_pitch;
  const auto   per_metre = [&d](const double mass) {
    return to_text(mass / d.chain.pitch, 4) + " kg/m";
  };
  if (parameters.model.mass_from == parameters::MassFrom::dimensions)
    {
      if (std::abs(solids / listed - 1.) > 0.03)
        d.notes.push_back("Mass of the chain " + per_metre(solids) +
                          ", of its solids; catalogues have " + per_metre(listed) +
                          ", which Model/Mass from = catalogue takes.");
      return;
    }
  const double factor = (listed - d.roller_solid.mass) / (solids - d.roller_solid.mass);
  if (!(factor > 0.5 && factor < 2.)) // rollers of another material than the rest is made of
    {
      d.notes.push_back("Mass of the chain " + per_metre(solids) +
                        ", of its solids: with Material/Density in kg/m3 = " + to_text(density) +
                        " they are too far from the catalogues' " + per_metre(listed) +
                        " to be scaled to it.");
      return;
    }
  d.chain.link_density_factor = factor;
  set_solids();
  d.mass_per_pitch = listed; // but for round-off
  d.notes.push_back("Mass of the chain " + per_metre(listed) +
                    ", of catalogues (Model/Mass from): plates, bushes and pins have " +
                    to_text(factor, 3) + " times the density " + to_text(density) +
                    " kg/m3, with which all solids have " + per_metre(solids) + ".");
}
} // namespace chaindrive::drive
