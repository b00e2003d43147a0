// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/gauss_points.h>
#include <chaindrive/mesh/nodes.h>

namespace chaindrive::mesh
{
Nodes::Nodes(const Part &part) : of_vertex(part.mesh->n_vertices(), none)
{
  for (const auto &cell : part.mesh->active_cell_iterators())
    {
      if (cell->material_id() == hub_zone)
        continue;
      std::array<unsigned int, 8> nodes;
      for (const unsigned int v : cell->vertex_indices())
        {
          unsigned int &node = of_vertex[cell->vertex_index(v)];
          if (node == none)
            {
              node = size();
              vertex.push_back(cell->vertex_index(v));
              position.push_back(cell->vertex(v));
              mass.push_back(0.);
            }
          nodes[v] = node;
        }
      const auto masses =
          lumped_masses(gauss_points(corners_of(cell)), part.density_of(cell->material_id()));
      for (unsigned int a = 0; a < 8; ++a)
        mass[nodes[a]] += masses[a];
      cells.push_back(nodes);
    }
}
} // namespace chaindrive::mesh
