// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/generate/cut_out.h>

#include <deal.II/base/numbers.h>

namespace chaindrive::mesh
{
std::unique_ptr<dealii::Triangulation<3>>
cut_out(const dealii::Triangulation<3>                     &mesh,
        const std::vector<unsigned int>                    &chosen,
        const std::function<Surface(const CellIterator &)> &surface_of_cut)
{
  constexpr unsigned int           none = dealii::numbers::invalid_unsigned_int;
  std::vector<unsigned int>        number(mesh.n_vertices(), none);
  std::vector<dealii::Point<3>>    vertices;
  std::vector<dealii::CellData<3>> cells;
  for (const unsigned int c : chosen)
    {
      const CellIterator  cell = cell_at(mesh, c);
      dealii::CellData<3> data;
      data.material_id = cell->material_id();
      for (const unsigned int v : cell->vertex_indices())
        {
          unsigned int &n = number[cell->vertex_index(v)];
          if (n == none)
            {
              n = static_cast<unsigned int>(vertices.size());
              vertices.push_back(cell->vertex(v));
            }
          data.vertices[v] = n;
        }
      cells.push_back(data);
    }

  auto result = std::make_unique<dealii::Triangulation<3>>();
  result->create_triangulation(vertices, cells, dealii::SubCellData());
  for (const auto &cell : result->active_cell_iterators())
    {
      const CellIterator original = cell_at(mesh, chosen[cell->active_cell_index()]);
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary())
          cell->face(f)->set_boundary_id(original->at_boundary(f) ?
                                             original->face(f)->boundary_id() :
                                             surface_of_cut(original->neighbor(f)));
    }
  return result;
}
} // namespace chaindrive::mesh
