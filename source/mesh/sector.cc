// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/mass.h>
#include <chaindrive/mesh/sector.h>

#include <deal.II/base/numbers.h>

#include <array>
#include <map>

namespace chaindrive::mesh
{
Sector::Sector(const Part &whole)
    : n_sectors(whole.n_sectors), n_cells(whole.mesh->n_active_cells() / n_sectors)
{
  const auto &mesh    = *whole.mesh;
  const auto  cell_at = [&mesh](const unsigned int i) {
    return dealii::Triangulation<3>::active_cell_iterator(&mesh, 0, i);
  };

  // cells of sector 0 with vertices numbered as they come
  constexpr unsigned int           none = dealii::numbers::invalid_unsigned_int;
  std::vector<unsigned int>        number(mesh.n_vertices(), none);
  std::vector<dealii::Point<3>>    vertices;
  std::vector<dealii::CellData<3>> cells;
  for (unsigned int c = 0; c < n_cells; ++c)
    {
      const auto cell = cell_at(c);
      if (cell->material_id() == hub_zone)
        continue;
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
      whole_cell.push_back(c);
    }

  whole_vertex.assign(n_sectors, std::vector<unsigned int>(vertices.size()));
  for (unsigned int s = 0; s < n_sectors; ++s)
    for (unsigned int i = 0; i < cells.size(); ++i)
      for (unsigned int v = 0; v < 8; ++v)
        whole_vertex[s][cells[i].vertices[v]] =
            cell_at(s * n_cells + whole_cell[i])->vertex_index(v);

  std::map<unsigned int, unsigned int>
      of_next; // vertices of sector 1 by their numbers in the whole
  for (unsigned int v = 0; v < vertices.size(); ++v)
    of_next[whole_vertex[1][v]] = v;
  for (unsigned int v = 0; v < vertices.size(); ++v)
    {
      const auto same = of_next.find(whole_vertex[0][v]);
      if (same != of_next.end())
        seam.emplace_back(v, same->second);
    }

  auto sector            = std::make_shared<Part>();
  sector->name           = "sector of the " + whole.name;
  sector->half           = whole.half;
  sector->density        = whole.density;
  sector->density_factor = whole.density_factor;
  sector->mesh           = std::make_unique<dealii::Triangulation<3>>();
  sector->mesh->create_triangulation(vertices, cells, dealii::SubCellData());
  for (const auto &cell : sector->mesh->active_cell_iterators())
    {
      const auto original = cell_at(whole_cell[cell->active_cell_index()]);
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary())
          cell->face(f)->set_boundary_id(
              original->at_boundary(f) ?
                  original->face(f)->boundary_id() :
                  (original->neighbor(f)->material_id() == hub_zone ? hub : other_surface));
    }
  sector->meshed = sector->exact = meshed_properties(*sector);
  part                           = std::move(sector);
}

Frame Sector::frame(const Frame &sprocket, const unsigned int s) const
{
  Frame frame = sprocket;
  frame.rotation =
      sprocket.rotation * to_matrix(rotation_about_z(2. * dealii::numbers::PI * s / n_sectors));
  return frame;
}
} // namespace chaindrive::mesh
