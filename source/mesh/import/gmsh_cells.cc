// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/import/gmsh_cells.h>
#include <chaindrive/mesh/import/joined.h>
#include <chaindrive/mesh/quality.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <array>
#include <vector>

namespace chaindrive::mesh
{
using dealii::Point;

namespace
{
constexpr long quadrangle = 3, hexahedron = 5;

using Cell = std::array<unsigned int, 8>; // vertices in deal.II's order
using Face = std::array<unsigned int, 4>; // vertices, going round it

struct Mesh
{
  const std::string           &file;
  std::map<long, unsigned int> index; // of the nodes that hexahedra have
  std::vector<Point<3>>        vertices;
  std::vector<Cell>            cells;
  std::vector<bool>            in_hub_zone; // the cells
  std::map<Face, Face>         outside;     // faces of one cell, seen from outside, by their sorted
  std::map<Face, unsigned int> n_cells;     // vertices
};

template <typename Vertices>
Point<3> centre(const Mesh &mesh, const Vertices &vertices)
{
  Point<3> sum;
  for (const unsigned int v : vertices)
    sum += mesh.vertices[v] / static_cast<double>(vertices.size());
  return sum;
}

Face sorted(Face face)
{
  std::sort(face.begin(), face.end());
  return face;
}

/// Whether an element belongs to one of these groups; looked up once for all that share theirs.
class Membership
{
public:
  explicit Membership(const std::set<long> &groups = {}) : groups_(groups) {}
  void add(const long group) { groups_.insert(group); }

  bool operator()(const GmshFile::Element &element)
  {
    const auto [place, is_new] = known_.emplace(element.groups.get(), false);
    if (is_new)
      place->second = std::any_of(element.groups->begin(),
                                  element.groups->end(),
                                  [this](const long group) { return groups_.count(group) > 0; });
    return place->second;
  }

private:
  std::set<long>                            groups_;
  std::map<const std::vector<long> *, bool> known_;
};

/// The vertices that hexahedra have, in m and in the order of their numbers.
void collect_vertices(Mesh &mesh, const GmshFile &gmsh)
{
  for (const GmshFile::Element &element : gmsh.elements)
    if (element.type == hexahedron)
      {
        if (element.nodes.size() != 8)
          throw InputError("The mesh '" + mesh.file + "' has a hexahedron with " +
                           std::to_string(element.nodes.size()) + " nodes instead of 8.");
        for (const long node : element.nodes)
          mesh.index[node] = 0;
      }
  for (auto &[node, index] : mesh.index)
    {
      const auto found = gmsh.nodes.find(node);
      if (found == gmsh.nodes.end())
        throw InputError("The mesh '" + mesh.file + "' has a hexahedron with the node " +
                         std::to_string(node) + ", which is not among its nodes" + gmsh.not_read() +
                         ".");
      index = mesh.vertices.size();
      mesh.vertices.push_back(1e-3 * found->second);
      if (!(mesh.vertices.back().norm() < 100.)) // also when it is not a number
        throw InputError("The mesh '" + mesh.file + "' has a vertex " +
                         to_text(mesh.vertices.back().norm(), 3) +
                         " m away from the origin; lengths must be in mm, and at most 100 m.");
    }
}

double scaled_jacobian(const Mesh &mesh, const Cell &cell)
{
  Corners corners;
  for (unsigned int i = 0; i < 8; ++i)
    corners[i] = mesh.vertices[cell[i]];
  return mesh::scaled_jacobian(corners);
}

/// Left-handed cells are numbered anew; any other inverted ones are an error. A cell of the same
/// nodes is the same cell, listed for another group.
void collect_cells(Mesh &mesh, const GmshFile &gmsh, const std::set<long> &hub_volumes)
{
  Membership                   in_hub(hub_volumes);
  std::map<Cell, unsigned int> listed; // by its sorted vertices
  unsigned int                 n_inverted = 0;
  Point<3>                     where;
  for (const GmshFile::Element &element : gmsh.elements)
    if (element.type == hexahedron)
      {
        Cell                   cell;
        constexpr unsigned int order[8] = {0, 1, 3, 2, 4, 5, 7, 6}; // Gmsh goes round
        for (unsigned int i = 0; i < 8; ++i)
          cell[i] = mesh.index.at(element.nodes[order[i]]);
        if (scaled_jacobian(mesh, cell) < 0.)
          std::rotate(cell.begin(), cell.begin() + 4, cell.end()); // bottom and top change places
        Cell different = cell;
        std::sort(different.begin(), different.end());
        if (!(scaled_jacobian(mesh, cell) > 0.) ||
            std::adjacent_find(different.begin(), different.end()) != different.end())
          if (n_inverted++ == 0)
            where = centre(mesh, cell);
        const auto [place, is_new] = listed.emplace(different, mesh.cells.size());
        if (is_new)
          {
            mesh.cells.push_back(cell);
            mesh.in_hub_zone.push_back(false);
          }
        if (in_hub(element))
          mesh.in_hub_zone[place->second] = true;
      }
  if (n_inverted > 0)
    throw InputError("The mesh '" + mesh.file + "' has " + std::to_string(n_inverted) +
                     " inverted cells of " + std::to_string(mesh.cells.size()) +
                     "; the first is at " + in_mm(where) + ".");
}

/// Two cells share a whole face and see it from different sides; no face has three.
void collect_faces(Mesh &mesh)
{
  constexpr unsigned int faces[6][4] = {
      {0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  for (const Cell &cell : mesh.cells)
    for (const auto &corners : faces)
      {
        Face face;
        for (unsigned int i = 0; i < 4; ++i)
          face[i] = cell[corners[i]];
        const Face   key  = sorted(face);
        unsigned int n    = ++mesh.n_cells[key];
        bool         fits = true;
        std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
        if (n == 1)
          mesh.outside[key] = face;
        else
          {
            std::reverse(face.begin() + 1, face.end());
            fits = n == 2 && mesh.outside.at(key) == face;
            mesh.outside.erase(key);
          }
        if (!fits)
          throw InputError("The cells of the mesh '" + mesh.file + "' do not fit together at " +
                           in_mm(centre(mesh, face)) +
                           ": a face belongs to one cell, or to two that lie on its two sides.");
      }
}

/// The surfaces of outer faces, by their sorted vertices.
std::map<Face, Surface>
collect_surfaces(const Mesh &mesh, const GmshFile &gmsh, const std::map<long, Surface> &surface_of)
{
  std::map<Surface, Membership> belongs;
  for (const auto &[group, surface] : surface_of)
    belongs[surface].add(group);
  std::map<Face, Surface> surfaces;
  for (const GmshFile::Element &element : gmsh.elements)
    for (auto &[surface, is_there] : belongs)
      if (element.type == quadrangle && is_there(element))
        {
          Face face{};
          bool good = element.nodes.size() == 4;
          for (unsigned int i = 0; good && i < 4; ++i)
            {
              const auto found = mesh.index.find(element.nodes[i]);
              good             = found != mesh.index.end();
              face[i]          = good ? found->second : 0;
            }
          good = good && mesh.outside.count(sorted(face)) > 0 &&
                 surfaces.emplace(sorted(face), surface).first->second == surface;
          if (!good)
            {
              std::string nodes;
              for (const long node : element.nodes)
                nodes += " " + std::to_string(node);
              throw InputError("In the mesh '" + mesh.file + "' the physical surface '" +
                               surface_name(surface) + "' has a quadrangle with the nodes" + nodes +
                               ", which is not an outer face of a hexahedron, or is part of "
                               "another surface too.");
            }
        }
  return surfaces;
}
} // namespace

std::unique_ptr<dealii::Triangulation<3>>
make_triangulation(const std::string             &file,
                   const GmshFile                &gmsh,
                   const std::map<long, Surface> &surface_of,
                   const std::set<long>          &hub_volumes)
{
  Mesh mesh{file, {}, {}, {}, {}, {}, {}};
  collect_vertices(mesh, gmsh);
  collect_cells(mesh, gmsh, hub_volumes);
  collect_faces(mesh);

  std::vector<dealii::CellData<3>> cells;
  for (const Cell &cell : mesh.cells)
    {
      const bool inner = mesh.in_hub_zone[cells.size()];
      cells.emplace_back();
      cells.back().vertices.assign(cell.begin(), cell.end());
      cells.back().material_id = inner ? hub_zone : rim;
    }
  dealii::GridTools::consistently_order_cells(cells);
  auto triangulation = std::make_unique<dealii::Triangulation<3>>();
  triangulation->create_triangulation(mesh.vertices, cells, dealii::SubCellData());
  check_joined(file, *triangulation); // what is not joined need not fit the surfaces
  const auto surfaces = collect_surfaces(mesh, gmsh, surface_of);
  for (const auto &face : triangulation->active_face_iterators())
    if (face->at_boundary())
      {
        const auto found = surfaces.find(sorted({{face->vertex_index(0),
                                                  face->vertex_index(1),
                                                  face->vertex_index(2),
                                                  face->vertex_index(3)}}));
        face->set_boundary_id(found == surfaces.end() ? other_surface : found->second);
      }
  return triangulation;
}
} // namespace chaindrive::mesh
