// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/generate/cut_out.h>
#include <chaindrive/mesh/mass.h>
#include <chaindrive/mesh/sector.h>
#include <chaindrive/mesh/surface/surface_nodes.h>
#include <chaindrive/utilities/errors.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <map>

namespace chaindrive::mesh
{
namespace
{
/// Refuses what cannot move as an elastic rim on a rigid hub.
void check_rim(const Part &rim, const Part &whole)
{
  const auto has = [](const Part &part, const Surface surface) {
    for (const auto &cell : part.mesh->active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() && face->boundary_id() == surface)
          return true;
    return false;
  };
  if (!has(rim, hub))
    throw InputError("Nothing holds the elastic zone of the " + whole.name +
                     ": it has no surface 'hub' and shares no face with a hub zone. Choose "
                     "Model/Elastic sprockets = off, or another mesh.");
  for (const auto &cell : whole.mesh->active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (cell->material_id() == hub_zone && face->at_boundary() &&
          face->boundary_id() == tooth_flanks)
        throw InputError("The hub zone of the " + whole.name +
                         ", which is rigid, reaches the tooth flanks. Choose Model/Elastic "
                         "sprockets = off, or a mesh with an elastic zone below all flanks.");
}
} // namespace

Sector::Sector(const Part &whole)
    : n_sectors(whole.n_sectors), n_cells(whole.mesh->n_active_cells() / n_sectors)
{
  for (unsigned int c = 0; c < n_cells; ++c)
    if (cell_at(*whole.mesh, c)->material_id() != hub_zone)
      whole_cell.push_back(c);
  if (whole_cell.empty())
    throw InputError("All of the " + whole.name +
                     " is hub zone, which is rigid. Choose Model/Elastic sprockets = off, or a "
                     "mesh with an elastic zone.");

  auto sector            = std::make_shared<Part>();
  sector->name           = (n_sectors > 1 ? "sector of the " : "rim of the ") + whole.name;
  sector->half           = whole.half;
  sector->density        = whole.density;
  sector->density_factor = whole.density_factor;
  sector->mesh           = cut_out(*whole.mesh, whole_cell, [](const CellIterator &beyond) {
    return beyond->material_id() == hub_zone ? hub : other_surface;
  });
  sector->meshed = sector->exact = meshed_properties(*sector);
  check_rim(*sector, whole);

  const unsigned int n_vertices = sector->mesh->n_vertices();
  whole_vertex.assign(n_sectors, std::vector<unsigned int>(n_vertices));
  for (const auto &cell : sector->mesh->active_cell_iterators())
    for (unsigned int s = 0; s < n_sectors; ++s)
      {
        const auto original =
            cell_at(*whole.mesh, s * n_cells + whole_cell[cell->active_cell_index()]);
        for (const unsigned int v : cell->vertex_indices())
          whole_vertex[s][cell->vertex_index(v)] = original->vertex_index(v);
      }

  std::map<unsigned int, unsigned int>
      of_next; // vertices of sector 1 by their numbers in the whole
  for (unsigned int v = 0; n_sectors > 1 && v < n_vertices; ++v)
    of_next[whole_vertex[1][v]] = v;
  for (unsigned int v = 0; v < n_vertices; ++v)
    {
      const auto same = of_next.find(whole_vertex[0][v]);
      if (same != of_next.end())
        seam.emplace_back(v, same->second);
    }
  part = std::move(sector);
}

Sector::Inertia Sector::inertia(const Nodes &nodes) const
{
  const std::vector<unsigned int> border = SurfaceNodes(*part, nodes, hub).node;
  Inertia                         sum{0., 0.};
  for (unsigned int node = 0; node < nodes.size(); ++node)
    {
      const dealii::Point<3> &x = nodes.position[node];
      (std::binary_search(border.begin(), border.end(), node) ? sum.held : sum.free) +=
          n_sectors * nodes.mass[node] * (x[0] * x[0] + x[1] * x[1]);
    }
  return sum;
}

Frame Sector::frame(const Frame &sprocket, const unsigned int s) const
{
  Frame frame = sprocket;
  frame.rotation =
      sprocket.rotation * to_matrix(rotation_about_z(2. * dealii::numbers::PI * s / n_sectors));
  return frame;
}
} // namespace chaindrive::mesh
