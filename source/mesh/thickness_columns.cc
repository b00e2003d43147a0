// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/thickness_columns.h>

#include <map>

namespace chaindrive::mesh
{
std::vector<std::vector<unsigned int>>
thickness_columns(const Part &part, const Nodes &nodes, const Surface surface)
{
  std::map<unsigned int, std::vector<unsigned int>> columns; // by first node
  for (const auto &first : part.mesh->active_cell_iterators())
    for (const unsigned int f : first->face_indices())
      {
        if (!first->face(f)->at_boundary() || first->face(f)->boundary_id() != surface)
          continue;
        for (const unsigned int v : first->vertex_indices())
          {
            // the vertices of a face of direction f / 2 have one value of that bit of their number
            if ((v >> (f / 2) & 1u) != f % 2)
              continue;
            std::vector<unsigned int> column;
            auto                      cell = first;
            unsigned int              face = f, vertex = v;
            const auto node = [&]() { return nodes.of_vertex[cell->vertex_index(vertex)]; };
            for (column.push_back(node());;)
              {
                vertex ^= 1u << (face / 2);
                face ^= 1u;
                column.push_back(node());
                if (cell->face(face)->at_boundary())
                  break;
                const unsigned int at        = cell->vertex_index(vertex);
                const auto         next_face = cell->neighbor_of_neighbor(face);
                cell                         = cell->neighbor(face);
                face                         = next_face;
                for (const unsigned int w : cell->vertex_indices())
                  if (cell->vertex_index(w) == at)
                    vertex = w;
              }
            columns.emplace(column.front(), std::move(column));
          }
      }
  std::vector<std::vector<unsigned int>> result;
  result.reserve(columns.size());
  for (auto &entry : columns)
    result.push_back(std::move(entry.second));
  return result;
}
} // namespace chaindrive::mesh
