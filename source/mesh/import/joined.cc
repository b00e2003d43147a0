// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/import/joined.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace chaindrive::mesh
{
using dealii::Point;

namespace
{
void check_vertices(const std::string &file, const dealii::Triangulation<3> &mesh)
{
  double shortest = 1e300;
  for (const auto &cell : mesh.active_cell_iterators())
    for (const unsigned int line : cell->line_indices())
      shortest = std::min(shortest, cell->line(line)->diameter());
  const double near = 0.01 * shortest;

  // in their order along a line that is oblique to the planes of a sprocket: few are close
  const dealii::Tensor<1, 3>                   line({0.531, 0.297, 0.794}); // of length 1
  const std::vector<Point<3>>                 &vertices = mesh.get_vertices();
  std::vector<std::pair<double, unsigned int>> along;
  for (unsigned int v = 0; v < vertices.size(); ++v)
    along.emplace_back(line * vertices[v], v);
  std::sort(along.begin(), along.end());
  unsigned int n = 0, first = 0; // the first by its number
  for (std::size_t i = 1; i < along.size(); ++i)
    for (std::size_t k = i; k > 0 && along[i].first - along[k - 1].first < near; --k)
      {
        const unsigned int v = along[i].second, other = along[k - 1].second;
        if (vertices[v].distance(vertices[other]) < near)
          {
            first = n++ == 0 ? v : std::min(first, v);
            break;
          }
      }
  if (n > 0)
    throw InputError("The mesh '" + file + "' has " + std::to_string(n) +
                     " vertices in the places of others, one of them at " + in_mm(vertices[first]) +
                     ": its cells are not joined there. Join them in Gmsh: Coherence before "
                     "meshing, or Coherence Mesh after it.");
}

void check_pieces(const std::string &file, const dealii::Triangulation<3> &mesh)
{
  std::vector<bool>     reached(mesh.n_active_cells(), false);
  std::vector<Point<3>> pieces; // a point of each
  for (const auto &start : mesh.active_cell_iterators())
    if (!reached[start->active_cell_index()])
      {
        pieces.push_back(start->center());
        reached[start->active_cell_index()]                              = true;
        std::vector<dealii::Triangulation<3>::active_cell_iterator> edge = {start};
        while (!edge.empty())
          {
            const auto cell = edge.back();
            edge.pop_back();
            for (const unsigned int f : cell->face_indices())
              if (!cell->at_boundary(f) && !reached[cell->neighbor(f)->active_cell_index()])
                {
                  reached[cell->neighbor(f)->active_cell_index()] = true;
                  edge.emplace_back(cell->neighbor(f));
                }
          }
      }
  if (pieces.size() > 1)
    throw InputError("The mesh '" + file + "' has " + std::to_string(pieces.size()) +
                     " pieces that no face joins: one at " + in_mm(pieces[0]) + ", another at " +
                     in_mm(pieces[1]) +
                     ". A sprocket is one body, in which neighbours share whole faces.");
}
} // namespace

std::string in_mm(const Point<3> &p)
{
  return "(" + to_text(1e3 * p[0]) + ", " + to_text(1e3 * p[1]) + ", " + to_text(1e3 * p[2]) +
         ") mm";
}

void check_joined(const std::string &file, const dealii::Triangulation<3> &mesh)
{
  check_vertices(file, mesh);
  check_pieces(file, mesh);
}
} // namespace chaindrive::mesh
