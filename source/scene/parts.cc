// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/generate/links.h>
#include <chaindrive/mesh/generate/sprocket.h>
#include <chaindrive/scene/build.h>

#include <algorithm>

namespace chaindrive::scene
{
namespace
{
std::shared_ptr<const mesh::Part> shared(mesh::Part &&part)
{
  return std::make_shared<const mesh::Part>(std::move(part));
}

/// Cells across the chain that what is swept along z needs; halves have half of them.
unsigned int fewest(const model::Meshes &meshes) { return meshes.half ? 2 : 1; }
} // namespace

std::shared_ptr<const mesh::Part>
make_roller_part(const model::Meshes &meshes, const drive::Drive &drive, const MeshUse use)
{
  const parameters::Mesh &cells = meshes.cells;
  mesh::RollerGrid        level(cells.refinement);
  drive::ChainDimensions  chain = drive.chain;
  if (use == MeshUse::picture)
    level.along = fewest(meshes);
  if (!chain.has_rollers) // the bush between the plates
    chain.roller_bore = chain.bush_bore;
  return shared(mesh::make_roller(chain,
                                  meshes.density,
                                  {cells.roller_wall.value_or(level.wall),
                                   cells.roller_around.value_or(level.around),
                                   cells.roller_along.value_or(level.along),
                                   meshes.half}));
}

std::shared_ptr<const mesh::Part> make_link_part(const model::Meshes &meshes,
                                                 const drive::Drive  &drive,
                                                 const bool           inner,
                                                 const MeshUse        use)
{
  const parameters::Mesh::Link &cells = inner ? meshes.cells.inner_link : meshes.cells.outer_link;
  mesh::LinkGrid                grid  = inner ? mesh::inner_link_grid(meshes.cells.refinement) :
                                                mesh::outer_link_grid(meshes.cells.refinement);
  grid.around                         = cells.around.value_or(grid.around);
  grid.wall                           = cells.wall.value_or(grid.wall);
  grid.rings                          = cells.rings.value_or(grid.rings);
  grid.plate_layers                   = cells.plate_layers.value_or(grid.plate_layers);
  grid.half                           = meshes.half;
  if (meshes.exact_joints)
    {
      const drive::ChainDimensions &chain = drive.chain;
      grid.along                          = std::max(grid.along, inner ? 6U : 8U);
      grid.bearing_end                    = inner ? 0.5 * chain.roller_length :
                                                    0.5 * (chain.bush_length + chain.inner_plate_thickness);
    }
  grid.along = cells.along.value_or(grid.along);

  if (use == MeshUse::picture)
    {
      grid.along        = cells.along.value_or(fewest(meshes));
      grid.plate_layers = cells.plate_layers.value_or(1);
    }

  const double density = meshes.density;
  return shared(inner ? mesh::make_inner_link(drive.chain, density, grid) :
                        mesh::make_outer_link(drive.chain, density, grid));
}

std::shared_ptr<const mesh::Part> make_sprocket_part(const model::Meshes   &meshes,
                                                     const drive::Drive    &drive,
                                                     const drive::Sprocket &sprocket,
                                                     const MeshUse          use)
{
  const mesh::SprocketDimensions dimensions{sprocket.bore,
                                            sprocket.hub_diameter,
                                            sprocket.carries_plates() ? drive.chain.pin_length :
                                                                        drive.sprocket_width};
  return shared(
      mesh::make_sprocket(sprocket.form,
                          dimensions,
                          meshes.density,
                          meshes.cells.sprocket_refinement.value_or(meshes.cells.refinement),
                          meshes.half,
                          use == MeshUse::picture));
}
} // namespace chaindrive::scene
