// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/generate/sweep.h>

namespace chaindrive::mesh
{
using dealii::Point;
using dealii::Tensor;

unsigned int PlanarMesh::add(const dealii::Point<2> &p)
{
  points.push_back(p);
  return static_cast<unsigned int>(points.size() - 1);
}

void PlanarMesh::add_grid(const std::vector<std::vector<unsigned int>> &rows,
                          const Component                               component,
                          const bool                                    closed)
{
  for (std::size_t j = 0; j + 1 < rows.size(); ++j)
    {
      const std::size_t n = rows[j].size();
      for (std::size_t i = 0; i + (closed ? 0 : 1) < n; ++i)
        {
          const std::size_t next = (i + 1) % n;
          quads.push_back(
              {{{rows[j][i], rows[j][next], rows[j + 1][next], rows[j + 1][i]}}, component});
        }
    }
}

std::vector<double> divide(const double first, const double last, const unsigned int n)
{
  std::vector<double> values(n + 1);
  for (unsigned int i = 0; i <= n; ++i)
    values[i] = first + (last - first) * i / n;
  values[n] = last;
  return values;
}

std::vector<double> planes_of(const double outer_face, const unsigned int n, const bool half)
{
  return half ? divide(0., outer_face, n / 2) : divide(-outer_face, outer_face, n);
}

std::vector<double> fractions_along(const Line &line)
{
  std::vector<double> s = {0.};
  for (std::size_t i = 1; i < line.size(); ++i)
    s.push_back(s.back() + line[i].distance(line[i - 1]));
  for (double &x : s)
    x /= s.back();
  return s;
}

Grid fill(const Line &first_row,
          const Line &last_row,
          const Line &first_column,
          const Line &last_column)
{
  const std::size_t n = first_column.size(), m = first_row.size();
  const auto        s_first = fractions_along(first_row), s_last = fractions_along(last_row);
  const auto        t_first = fractions_along(first_column), t_last = fractions_along(last_column);
  Grid              grid(n, Line(m));
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < m; ++i)
      {
        const double t = t_first[j] + (t_last[j] - t_first[j]) * i / (m - 1.);
        const double s = s_first[i] + (s_last[i] - s_first[i]) * j / (n - 1.);
        Tensor<1, 2> p =
            (1. - t) * first_row[i] + t * Tensor<1, 2>(last_row[i]) +
            (1. - s) * Tensor<1, 2>(first_column[j]) + s * Tensor<1, 2>(last_column[j]) -
            (1. - t) * (1. - s) * Tensor<1, 2>(first_row[0]) -
            (1. - t) * s * Tensor<1, 2>(first_row[m - 1]) -
            t * (1. - s) * Tensor<1, 2>(last_row[0]) - t * s * Tensor<1, 2>(last_row[m - 1]);
        grid[j][i] = Point<2>(p);
      }
  // sides as they were given, to the last digit
  grid.front() = first_row;
  grid.back()  = last_row;
  for (std::size_t j = 0; j < n; ++j)
    {
      grid[j].front() = first_column[j];
      grid[j].back()  = last_column[j];
    }
  return grid;
}

std::unique_ptr<dealii::Triangulation<3>>
sweep(const PlanarMesh                                                        &section,
      const std::vector<double>                                               &planes,
      const std::function<bool(Component, unsigned int)>                      &present,
      const std::function<Surface(Component, const dealii::Point<3> &, bool)> &surface_of)
{
  const unsigned int n_planes = static_cast<unsigned int>(planes.size());
  const auto at = [n_planes](unsigned int point, unsigned int k) { return point * n_planes + k; };

  // deal.II numbers the vertices of a quadrilateral line by line, not around it
  std::vector<dealii::CellData<3>> cells;
  for (const PlanarMesh::Quad &quad : section.quads)
    for (unsigned int k = 0; k + 1 < n_planes; ++k)
      if (present(quad.component, k))
        {
          dealii::CellData<3> cell;
          const auto         &v = quad.vertices;
          cell.vertices         = {at(v[0], k),
                                   at(v[1], k),
                                   at(v[3], k),
                                   at(v[2], k),
                                   at(v[0], k + 1),
                                   at(v[1], k + 1),
                                   at(v[3], k + 1),
                                   at(v[2], k + 1)};
          cell.material_id      = quad.component;
          cells.push_back(cell);
        }

  // number the vertices that are used, in the order of the section's points
  const unsigned int        unused = dealii::numbers::invalid_unsigned_int;
  std::vector<unsigned int> number(section.points.size() * n_planes, unused);
  for (const auto &cell : cells)
    for (const unsigned int v : cell.vertices)
      number[v] = 0;
  std::vector<dealii::Point<3>> vertices;
  for (unsigned int p = 0; p < section.points.size(); ++p)
    for (unsigned int k = 0; k < n_planes; ++k)
      if (number[at(p, k)] != unused)
        {
          number[at(p, k)] = static_cast<unsigned int>(vertices.size());
          vertices.emplace_back(section.points[p][0], section.points[p][1], planes[k]);
        }
  for (auto &cell : cells)
    for (unsigned int &v : cell.vertices)
      v = number[v];

  auto mesh = std::make_unique<dealii::Triangulation<3>>();
  mesh->create_triangulation(vertices, cells, dealii::SubCellData());

  for (const auto &cell : mesh->active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
      if (cell->face(f)->at_boundary())
        cell->face(f)->set_boundary_id(surface_of(
            static_cast<Component>(cell->material_id()), cell->face(f)->center(), f >= 4));
  return mesh;
}
} // namespace chaindrive::mesh
