// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/generate/cut_out.h>
#include <chaindrive/mesh/generate/links.h>
#include <chaindrive/statics/pieces.h>

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <cmath>
#include <memory>
#include <set>
#include <vector>

namespace chaindrive::statics
{
namespace
{
using dealii::Point;
using dealii::Tensor;

Tensor<1, 3> along_z()
{
  Tensor<1, 3> z;
  z[2] = 1.;
  return z;
}

/// The cells of @p part on which @p keep holds for their centres; sides in the planes x = 0, y = 0,
/// z = 0 become planes of symmetry if @p mirrors has their axis.
std::unique_ptr<dealii::Triangulation<3>>
keep_cells(const mesh::Part                            &part,
           const std::function<bool(const Point<3> &)> &keep,
           const std::set<unsigned int>                &mirrors)
{
  std::vector<unsigned int> chosen;
  for (const auto &cell : part.mesh->active_cell_iterators())
    if (keep(cell->center()))
      chosen.push_back(cell->active_cell_index());
  auto result = mesh::cut_out(
      *part.mesh, chosen, [](const mesh::CellIterator &) { return mesh::other_surface; });
  for (const auto &cell : result->active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
      if (cell->face(f)->at_boundary())
        for (const unsigned int d : mirrors)
          if (std::abs(cell->face(f)->center()[d]) < 1e-9 * cell->diameter())
            cell->face(f)->set_boundary_id(static_cast<dealii::types::boundary_id>(plane_x + d));
  return result;
}

/// Where the points of faces and lines lie on cylinders: those about the hole and the arcs of a
/// plate's outline.
void attach_link_manifolds(dealii::Triangulation<3> &mesh,
                           const drive::Plate       &plate,
                           const double              tube_radius,
                           const double              bore_radius)
{
  // axes of the cylinders and their radii
  struct Cylinder
  {
    Point<3> axis;
    double   radius;
  };
  const Point<3>        hole(0.5 * plate.hole_pitch, 0., 0.);
  std::vector<Cylinder> cylinders = {{hole, tube_radius}, {hole, 0.5 * plate.height}};
  if (bore_radius > 0.)
    cylinders.push_back({hole, bore_radius});
  if (plate.has_waist())
    for (const double side : {1., -1.})
      cylinders.push_back({Point<3>(0., side * (0.5 * plate.waist + plate.waist_radius()), 0.),
                           plate.waist_radius()});
  for (unsigned int c = 0; c < cylinders.size(); ++c)
    mesh.set_manifold(c + 1, dealii::CylindricalManifold<3>(along_z(), cylinders[c].axis));

  const auto cylinder_of = [&](const auto &face) {
    for (unsigned int c = 0; c < cylinders.size(); ++c)
      {
        bool all = true;
        for (const unsigned int v : face->vertex_indices())
          all = all && std::abs(std::hypot(face->vertex(v)[0] - cylinders[c].axis[0],
                                           face->vertex(v)[1] - cylinders[c].axis[1]) -
                                cylinders[c].radius) < 1e-7 * cylinders[c].radius;
        if (all)
          return c + 1;
      }
    return 0U;
  };
  for (const auto &cell : mesh.active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
      {
        // ends of a ring's sector have all their points at the same distances too
        const auto face = cell->face(f);
        if (f >= 4)
          continue;
        if (const unsigned int c = cylinder_of(face); c > 0)
          face->set_all_manifold_ids(c);
      }
}

/// The vertices of a face, by which cells find it whatever its number and direction.
std::set<unsigned int> vertices_of(const mesh::CellIterator &cell, const unsigned int f)
{
  std::set<unsigned int> vertices;
  for (const unsigned int v : cell->face(f)->vertex_indices())
    vertices.insert(cell->face(f)->vertex_index(v));
  return vertices;
}

/// The same mesh with the vertices of each cell in an order by which opposite edges run the same
/// way in all cells: for others deal.II 9.4 tells p4est wrongly which edges are the same. Their
/// refinement would not keep cells at such an edge within a level of each other.
std::unique_ptr<dealii::Triangulation<3>> in_order(const dealii::Triangulation<3> &mesh)
{
  std::vector<dealii::CellData<3>> cells;
  for (const auto &cell : mesh.active_cell_iterators())
    {
      dealii::CellData<3> data;
      data.material_id = cell->material_id();
      for (const unsigned int v : cell->vertex_indices())
        data.vertices[v] = cell->vertex_index(v);
      cells.push_back(data);
    }
  dealii::GridTools::consistently_order_cells(cells);
  auto result = std::make_unique<dealii::Triangulation<3>>();
  result->create_triangulation(mesh.get_vertices(), cells, dealii::SubCellData());
  for (const auto &cell : result->active_cell_iterators())
    {
      const mesh::CellIterator original = mesh::cell_at(mesh, cell->active_cell_index());
      for (const unsigned int f : cell->face_indices())
        for (const unsigned int g : original->face_indices())
          if (cell->face(f)->at_boundary() && vertices_of(cell, f) == vertices_of(original, g))
            cell->face(f)->set_boundary_id(original->face(g)->boundary_id());
    }
  return result;
}

drive::Plate plate_of(const drive::ChainDimensions &chain, const bool inner)
{
  return inner ? drive::inner_plate(chain) : drive::outer_plate(chain);
}

Piece link_piece(const drive::ChainDimensions &chain, const bool inner, const bool half_y)
{
  mesh::LinkGrid grid = {n_around, 1, 2, 1, inner ? 6U : 10U};
  grid.half           = true;
  const mesh::Part part =
      inner ? mesh::make_inner_link(chain, 1., grid) : mesh::make_outer_link(chain, 1., grid);
  Piece piece;
  piece.name = part.name;
  piece.mesh = keep_cells(
      part,
      [half_y](const Point<3> &x) { return x[0] > 0. && (!half_y || x[1] > 0.); },
      half_y ? std::set<unsigned int>{0, 1, 2} : std::set<unsigned int>{0, 2});
  if (!half_y)
    piece.free = 1;
  attach_link_manifolds(*piece.mesh,
                        plate_of(chain, inner),
                        0.5 * (inner ? chain.bush_diameter : chain.pin_diameter),
                        0.5 * (inner ? chain.bush_bore : chain.pin_bore));
  return piece;
}
} // namespace

Piece link_eighth(const drive::ChainDimensions &chain, const bool inner)
{
  return link_piece(chain, inner, true);
}

Piece plate_eighth(const drive::ChainDimensions &chain, const bool inner)
{
  const mesh::LinkGrid grid = {n_around, 1, 3, 2, 2};
  const mesh::Part     link =
      inner ? mesh::make_inner_link(chain, 1., grid) : mesh::make_outer_link(chain, 1., grid);
  const drive::Plate plate  = plate_of(chain, inner);
  const double       middle = 0.5 * (inner ? chain.bush_length : chain.pin_length);
  dealii::GridTools::shift(-middle * along_z(), *link.mesh);
  const double radius = 0.5 * plate.hole_diameter;
  const auto   x_of   = [&plate](const Point<3> &x) {
    return std::hypot(x[0] - 0.5 * plate.hole_pitch, x[1]);
  };

  Piece piece;
  piece.name = inner ? "inner plate" : "outer plate";
  piece.mesh = keep_cells(link,
                          [&](const Point<3> &x) {
                            return x[0] > 0. && x[1] > 0. && x[2] > 0. &&
                                   x[2] < 0.5 * plate.thickness && x_of(x) > radius;
                          },
                          {0, 1, 2});
  for (const auto &cell : piece.mesh->active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
      {
        bool on_hole = cell->face(f)->at_boundary();
        for (const unsigned int v : cell->face(f)->vertex_indices())
          on_hole = on_hole && std::abs(x_of(cell->face(f)->vertex(v)) - radius) < 1e-7 * radius;
        if (on_hole)
          cell->face(f)->set_boundary_id(hole_side);
      }
  attach_link_manifolds(*piece.mesh, plate, radius, 0.);
  return piece;
}

Piece link_quarter(const drive::ChainDimensions &chain) { return link_piece(chain, true, false); }

Piece roller_quarter(const drive::ChainDimensions &chain)
{
  const mesh::Part part = mesh::make_roller(chain, 1., {1, n_around, 6, true});
  Piece            piece;
  piece.name = part.name;
  piece.mesh = keep_cells(part, [](const Point<3> &x) { return x[1] > 0.; }, {1, 2});
  piece.free = 0;
  piece.mesh->set_all_manifold_ids(1);
  piece.mesh->set_manifold(1, dealii::CylindricalManifold<3>(2));
  return piece;
}

Piece rim_sector(const drive::ToothForm         &form,
                 const mesh::SprocketDimensions &dimensions,
                 const unsigned int              n_sectors)
{
  const mesh::Part part = mesh::make_sprocket(form, dimensions, 1., 0, true);
  Piece            piece;
  piece.name         = part.name;
  const double reach = n_sectors * dealii::numbers::PI / form.teeth;

  std::vector<unsigned int> chosen;
  for (const auto &cell : part.mesh->active_cell_iterators())
    if (cell->material_id() == mesh::rim &&
        std::abs(std::atan2(cell->center()[1], cell->center()[0])) < reach)
      chosen.push_back(cell->active_cell_index());
  piece.mesh = mesh::cut_out(*part.mesh, chosen, [](const mesh::CellIterator &beyond) {
    return beyond->material_id() == mesh::hub_zone ? mesh::hub : mesh::other_surface;
  });
  piece.mesh = in_order(*piece.mesh);
  for (const auto &cell : piece.mesh->active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
      if (cell->face(f)->at_boundary() && cell->face(f)->boundary_id() == mesh::middle_plane)
        cell->face(f)->set_boundary_id(plane_z);
  piece.held = {mesh::hub};
  return piece;
}
} // namespace chaindrive::statics
