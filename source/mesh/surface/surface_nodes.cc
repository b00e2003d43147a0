// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/surface/surface_nodes.h>

#include <algorithm>
#include <map>

namespace chaindrive::mesh
{
SurfaceNodes::SurfaceNodes(const Part &part, const Nodes &nodes, const Surface surface)
{
  std::map<unsigned int, double> areas;
  double                         volume = 0., total = 0.;
  for (const auto &cell : part.mesh->active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary() && face->boundary_id() == surface)
        {
          // half the cross product of the diagonals: exact for a flat face
          const double area = 0.5 * dealii::cross_product_3d(face->vertex(3) - face->vertex(0),
                                                             face->vertex(2) - face->vertex(1))
                                        .norm();
          for (const unsigned int v : face->vertex_indices())
            areas[nodes.of_vertex[face->vertex_index(v)]] += 0.25 * area;
          volume += cell->measure();
          total += area;
        }
  for (const auto &[n, a] : areas)
    {
      node.push_back(n);
      area.push_back(a);
    }
  thickness = total > 0. ? volume / total : 0.;
}

void SurfaceNodes::keep(const std::vector<unsigned int> &nodes)
{
  if (nodes.empty())
    return;
  unsigned int n = 0;
  for (unsigned int s = 0; s < size(); ++s)
    if (std::find(nodes.begin(), nodes.end(), node[s]) != nodes.end())
      {
        node[n] = node[s];
        area[n] = area[s];
        ++n;
      }
  node.resize(n);
  area.resize(n);
}
} // namespace chaindrive::mesh
