// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/links.h>
#include <chaindrive/mesh/sprocket.h>
#include <chaindrive/scene/build.h>

namespace chaindrive::scene
{
namespace
{
std::shared_ptr<const mesh::Part> shared(mesh::Part &&part)
{
  return std::make_shared<const mesh::Part>(std::move(part));
}
} // namespace

std::shared_ptr<const mesh::Part> make_roller_part(const Parameters   &parameters,
                                                   const drive::Drive &drive)
{
  return shared(
      mesh::make_roller(drive.chain, parameters.material.density, parameters.mesh.refinement));
}

std::shared_ptr<const mesh::Part>
make_link_part(const Parameters &parameters, const drive::Drive &drive, const bool inner)
{
  const double       density = parameters.material.density;
  const unsigned int level   = parameters.mesh.refinement;
  return shared(inner ? mesh::make_inner_link(drive.chain, density, mesh::inner_link_grid(level)) :
                        mesh::make_outer_link(drive.chain, density, mesh::outer_link_grid(level)));
}

std::shared_ptr<const mesh::Part>
make_sprocket_part(const Parameters &parameters, const drive::Drive &drive, const bool driver)
{
  const mesh::SprocketShape shape{driver ? drive.driver_bore : drive.driven_bore,
                                  driver ? drive.driver_hub_diameter : drive.driven_hub_diameter,
                                  drive.sprocket_width};
  return shared(mesh::make_sprocket(driver ? drive.driver : drive.driven,
                                    shape,
                                    parameters.material.density,
                                    parameters.mesh.refinement));
}
} // namespace chaindrive::scene
