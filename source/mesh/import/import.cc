// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/import/import.h>

#include <chaindrive/mesh/generate/cut_out.h>
#include <chaindrive/mesh/import/gmsh_cells.h>
#include <chaindrive/mesh/import/gmsh_file.h>
#include <chaindrive/mesh/import/joined.h>
#include <chaindrive/mesh/mass.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/tensor.h>
#include <deal.II/grid/grid_tools.h>

#include <cmath>
#include <map>
#include <set>

namespace chaindrive::mesh
{
using dealii::Point;

namespace
{
void check_elements(const std::string &file, const GmshFile &gmsh)
{
  std::map<long, unsigned int> n_elements; // of each type
  for (const GmshFile::Element &element : gmsh.elements)
    ++n_elements[element.type];
  // Gmsh's numbers of the three-dimensional elements that its manual lists
  static const std::map<long, std::string> others = {{4, "tetrahedra"},
                                                     {6, "prisms"},
                                                     {7, "pyramids"},
                                                     {11, "tetrahedra of second order"},
                                                     {12, "hexahedra of second order"},
                                                     {17, "hexahedra of second order"},
                                                     {13, "prisms of second order"},
                                                     {14, "pyramids of second order"},
                                                     {18, "prisms of second order"},
                                                     {19, "pyramids of second order"},
                                                     {29, "tetrahedra of third order"},
                                                     {30, "tetrahedra of fourth order"},
                                                     {31, "tetrahedra of fifth order"},
                                                     {92, "hexahedra of third order"},
                                                     {93, "hexahedra of fourth order"}};
  for (const auto &[type, name] : others)
    if (const auto found = n_elements.find(type); found != n_elements.end())
      throw InputError("The mesh '" + file + "' has " + std::to_string(found->second) + " " + name +
                       "; only hexahedra of first order are allowed.");
  if (n_elements.count(5) == 0)
    throw InputError("The mesh '" + file + "' has no hexahedra" + gmsh.not_read() + ".");
}

/// Numbers of the physical surfaces called @p name.
std::vector<long> numbers_of(const std::string &file, const GmshFile &gmsh, const std::string &name)
{
  if (const auto found = gmsh.surfaces.find(name); found != gmsh.surfaces.end())
    return found->second;
  std::string names;
  for (const auto &surface : gmsh.surfaces)
    names += (names.empty() ? "'" : ", '") + surface.first + "'";
  throw InputError("The mesh '" + file + "' has no physical surface '" + name + "'; it has " +
                   (names.empty() ? "none with a name" : names) + gmsh.not_read() + ".");
}

/// The surfaces that are needed must have faces.
void check_surfaces(const std::string              &file,
                    const dealii::Triangulation<3> &mesh,
                    const GmshFile                 &gmsh)
{
  const bool grouped =
      std::any_of(gmsh.elements.begin(), gmsh.elements.end(), [](const GmshFile::Element &element) {
        return !element.groups->empty() && *element.groups != std::vector<long>{0};
      });
  const auto present_ids = mesh.get_boundary_ids();
  for (const Surface surface : {tooth_flanks, hub})
    if (std::count(present_ids.begin(), present_ids.end(), surface) == 0)
      throw InputError(
          "No quadrangle of the mesh '" + file + "' belongs to its physical surface '" +
          surface_name(surface) + "'" +
          (grouped ? "" :
                     ", nor any element to any group: in version 2.2, Gmsh writes all elements "
                     "(Mesh.SaveAll) without their groups") +
          gmsh.not_read() + ".");
}

/// Calls @p f with every face of @p mesh that belongs to the tooth flanks.
template <typename Function>
void for_each_flank(const dealii::Triangulation<3> &mesh, const Function &f)
{
  for (const auto &face : mesh.active_face_iterators())
    if (face->at_boundary() && face->boundary_id() == tooth_flanks)
      f(face);
}

void check_teeth(const std::string              &file,
                 const dealii::Triangulation<3> &mesh,
                 const drive::ToothForm         &form)
{
  double   worst = 0.;
  Point<3> where;
  for_each_flank(mesh, [&](const auto &face) {
    for (const unsigned int v : face->vertex_indices())
      {
        const Point<3> &x         = face->vertex(v);
        const double    deviation = std::abs(form.closest_point(Point<2>(x[0], x[1])).distance);
        if (deviation > worst)
          {
            worst = deviation;
            where = x;
          }
      }
  });
  if (worst > 0.05 * form.pitch)
    throw InputError("The tooth flanks of the mesh '" + file + "' are " + to_text(1e3 * worst, 4) +
                     " mm away from the drive's tooth form at " + in_mm(where) +
                     ". Lengths must be in mm, the axis of rotation must be the z axis, the middle "
                     "of a gap must be on +x, and the number of teeth must be " +
                     std::to_string(form.teeth) + ".");
}

/// The flanks must be the whole profile over the width of the teeth: where a face lacks their name
/// rollers would pass through.
void check_whole(const std::string              &file,
                 const dealii::Triangulation<3> &mesh,
                 const drive::ToothForm         &form)
{
  double     length  = 0.; // of the profile, of one gap
  const auto profile = form.half_polyline(8);
  for (unsigned int i = 0; i + 1 < profile.size(); ++i)
    length += 2. * profile[i].distance(profile[i + 1]);
  double low = 1e300, high = -1e300; // of the teeth
  for (const Point<3> &x : mesh.get_vertices())
    if (std::hypot(x[0], x[1]) > 0.5 * form.root_diameter + 0.05 * form.pitch)
      {
        low  = std::min(low, x[2]);
        high = std::max(high, x[2]);
      }
  std::vector<double> area(form.teeth, 0.);
  for_each_flank(mesh, [&](const auto &face) {
    const Point<3> centre = face->center();
    const double   turned = std::atan2(centre[1], centre[0]) / form.pitch_angle() + form.teeth;
    area[static_cast<unsigned int>(std::lround(turned)) % form.teeth] += face->measure();
  });
  const double expected = length * (high - low);
  for (unsigned int gap = 0; gap < form.teeth; ++gap)
    if (area[gap] < 0.8 * expected || area[gap] > 1.2 * expected)
      throw InputError("The tooth flanks of the mesh '" + file + "' have " +
                       to_text(area[gap] * 1e6, 4) + " mm2 in gap " + std::to_string(gap) +
                       ", but the profile of a gap is " + to_text(length * 1e3, 4) +
                       " mm long and the teeth are " + to_text((high - low) * 1e3, 4) +
                       " mm wide: " + to_text(expected * 1e6, 4) +
                       " mm2. The surface must hold every face of the profile, with the tips, "
                       "between the two sides, and no other.");
}

/// Outer faces without a name must look along the axis, as the sides do: others are gaps in the
/// body, or a part of the flanks or the hub that was forgotten.
void check_named(const std::string &file, const dealii::Triangulation<3> &mesh)
{
  constexpr double along = 0.9;
  unsigned int     n     = 0;
  Point<3>         where;
  for (const auto &face : mesh.active_face_iterators())
    if (face->at_boundary() && face->boundary_id() == other_surface)
      {
        const auto normal = dealii::cross_product_3d(face->vertex(3) - face->vertex(0),
                                                     face->vertex(2) - face->vertex(1));
        if (std::abs(normal[2]) < along * normal.norm() && n++ == 0)
          where = face->center();
      }
  if (n > 0)
    throw InputError("The mesh '" + file + "' has " + std::to_string(n) +
                     " outer faces that are in no physical surface and do not look along the axis; "
                     "the first is at " +
                     in_mm(where) +
                     ". If cells should be joined there, let them share whole faces; if not, put "
                     "the faces into 'tooth flanks', 'hub' or 'sides'.");
}

/// The cells of @p mesh at z >= 0, which must be its mirror image in this plane.
std::unique_ptr<dealii::Triangulation<3>> upper_half(const std::string              &file,
                                                     const dealii::Triangulation<3> &mesh)
{
  const double              same = 1e-6 * mesh.begin_active()->diameter();
  std::vector<unsigned int> above;
  double                    difference = 0., volume = 0.;
  for (const auto &cell : mesh.active_cell_iterators())
    {
      double low = 1e300, high = -1e300;
      for (const unsigned int v : cell->vertex_indices())
        {
          low  = std::min(low, cell->vertex(v)[2]);
          high = std::max(high, cell->vertex(v)[2]);
        }
      if (low < -same && high > same)
        throw InputError(
            "Model/Symmetry model = true needs a mesh with vertices in its middle plane, "
            "but in '" +
            file + "' the cell at " + in_mm(cell->center()) +
            " lies on both sides of it. Choose another mesh, or Symmetry model = false.");
      if (high > same)
        above.push_back(cell->active_cell_index());
      difference += (high > same ? 1. : -1.) * cell->measure();
      volume += cell->measure();
    }
  if (std::abs(difference) > 1e-6 * volume)
    throw InputError("Model/Symmetry model = true needs a mesh that is symmetric about its middle "
                     "plane, but '" +
                     file +
                     "' has different volumes on its two sides. Choose another mesh, or "
                     "Symmetry model = false.");
  auto half = cut_out(mesh, above, [](const CellIterator &) { return middle_plane; });
  dealii::GridTools::transform(
      [same](const Point<3> &x) { return Point<3>(x[0], x[1], std::abs(x[2]) < same ? 0. : x[2]); },
      *half);
  return half;
}
} // namespace

Part import_sprocket(const std::string      &file,
                     const drive::ToothForm &form,
                     const double            density,
                     const bool              half)
{
  const GmshFile gmsh = read_gmsh(file);
  check_elements(file, gmsh);
  std::map<long, Surface> surface_of;
  for (const Surface surface : {tooth_flanks, hub})
    for (const long number : numbers_of(file, gmsh, surface_name(surface)))
      surface_of[number] = surface;
  if (gmsh.surfaces.count("sides") > 0)
    for (const long number : gmsh.surfaces.at("sides"))
      surface_of[number] = sprocket_sides;
  std::set<long> hub_volumes;
  if (gmsh.volumes.count("hub zone") > 0)
    hub_volumes.insert(gmsh.volumes.at("hub zone").begin(), gmsh.volumes.at("hub zone").end());

  Part part;
  part.name    = "imported sprocket";
  part.density = density;
  part.mesh    = make_triangulation(file, gmsh, surface_of, hub_volumes);
  double low = 1e300, high = -1e300;
  for (const Point<3> &x : part.mesh->get_vertices())
    {
      low  = std::min(low, x[2]);
      high = std::max(high, x[2]);
    }
  dealii::GridTools::shift(Point<3>(0., 0., -0.5 * (low + high)), *part.mesh);
  check_teeth(file, *part.mesh, form);
  check_surfaces(file, *part.mesh, gmsh);
  check_whole(file, *part.mesh, form);
  check_named(file, *part.mesh);
  if (half)
    {
      part.mesh = upper_half(file, *part.mesh);
      part.half = true;
    }
  part.exact = part.meshed = meshed_properties(part);
  return part;
}

double flank_width(const Part &sprocket)
{
  double reach = 0.;
  for_each_flank(*sprocket.mesh, [&reach](const auto &face) {
    for (const unsigned int v : face->vertex_indices())
      reach = std::max(reach, std::abs(face->vertex(v)[2]));
  });
  return 2. * reach;
}
} // namespace chaindrive::mesh
