// SPDX-License-Identifier: LGPL-2.1-or-later

// The mass of a chain is that of catalogues, lumped, of rigid links and of meshed ones, which
// elastic and reduced bodies are: plates, bushes and pins are denser by one factor, rollers are
// not. A chain that is not the one of the catalogue keeps what its dimensions say.

#include <chaindrive/drive/drive.h>
#include <chaindrive/mesh/generate/links.h>

#include <cmath>
#include <iostream>

using namespace chaindrive;

namespace
{
void verdict(const std::string &what, const bool holds)
{
  std::cout << what << ": " << (holds ? "yes" : "NO") << '\n';
}

bool near(const double a, const double b, const double part = 1e-12)
{
  return std::abs(a - b) <= part * std::abs(b);
}

/// Mass per pitch of links and rollers as each fidelity has them, against the catalogue's.
void masses(const std::string &designation)
{
  Parameters p                        = Parameters();
  p.drive.chain.designation           = designation;
  p.drive.layout.centre_distance_from = parameters::CentreDistanceFrom::slack;
  p.material.density                  = 7850.;
  const drive::Drive listed           = drive::make_drive(p);
  p.model.mass_from                   = parameters::MassFrom::dimensions;
  const drive::Drive solids           = drive::make_drive(p);
  const double       wanted = drive::find_chain(designation)->mass_per_metre * listed.chain.pitch;
  const double       rigid  = listed.roller_solid.mass +
                       0.5 * (listed.inner_link_solid.mass + listed.outer_link_solid.mass);
  // of meshes, as elastic and reduced bodies have them
  const mesh::Part inner = mesh::make_inner_link(listed.chain, 7850., mesh::inner_link_grid(0)),
                   outer = mesh::make_outer_link(listed.chain, 7850., mesh::outer_link_grid(0));
  const auto factor = [](const mesh::Part &part, const mesh::Part &steel, const int component) {
    return part.density_factor[component] / steel.density_factor[component];
  };
  const mesh::Part steel = mesh::make_inner_link(solids.chain, 7850., mesh::inner_link_grid(0));
  const double     by    = listed.chain.link_density_factor;
  verdict(designation + ": lumped, rigid and meshed chains weigh what catalogues say",
          near(listed.mass_per_pitch, wanted) && near(rigid, wanted, 1e-9) &&
              near(listed.roller_solid.mass + 0.5 * (inner.exact.mass + outer.exact.mass),
                   wanted,
                   1e-9));
  verdict("  plates and bushes by one factor, rollers as they are",
          near(factor(inner, steel, mesh::inner_plate), by, 1e-9) &&
              near(factor(inner, steel, mesh::bush), by, 1e-9) && std::abs(by - 1.) > 1e-3 &&
              near(listed.inner_link_solid.inertia[2][2] / solids.inner_link_solid.inertia[2][2],
                   by,
                   1e-9) &&
              listed.roller_solid.mass == solids.roller_solid.mass);
  p.model.mass_from                = parameters::MassFrom::catalogue;
  p.drive.chain.outer_plate_height = 0.9 * listed.chain.outer_plate_height;
  const drive::Drive own           = drive::make_drive(p);
  p.drive.chain.outer_plate_height = {};
  p.model.mass_per_pitch           = 0.01;
  verdict("  none with dimensions of its own or a mass that is given",
          own.chain.link_density_factor == 1. &&
              drive::make_drive(p).chain.link_density_factor == 1.);
}
} // namespace

int main()
{
  for (const char *chain : {"06B", "08B", "32B", "72B", "04C", "081C"})
    masses(chain);
}
