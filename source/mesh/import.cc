// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/import.h>

#include <chaindrive/mesh/cut_out.h>
#include <chaindrive/mesh/mass.h>
#include <chaindrive/mesh/quality.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace chaindrive::mesh
{
using dealii::Point;

namespace
{
/// What must be known of a Gmsh file before deal.II reads it.
struct GmshSummary
{
  std::map<std::string, unsigned int>  surfaces, volumes; ///< physical names and numbers
  std::map<unsigned int, unsigned int> n_elements;        ///< of each Gmsh element type
};

/// Skips what is left of a section.
void skip_to(std::istream &in, const std::string &line)
{
  for (std::string s; std::getline(in, s);)
    if (s.compare(0, line.size(), line) == 0)
      return;
}

/// Counts the elements of a section `Elements`, which differs between the versions of the format.
void count_elements(std::istream &in, const double version, GmshSummary &summary)
{
  std::string line;
  std::getline(in, line);
  if (version < 4.)
    {
      unsigned long n = 0;
      std::istringstream(line) >> n;
      for (; n > 0 && std::getline(in, line); --n)
        {
          unsigned int number = 0, type = 0;
          std::istringstream(line) >> number >> type;
          ++summary.n_elements[type];
        }
      return;
    }
  unsigned long n_blocks = 0;
  std::istringstream(line) >> n_blocks;
  for (; n_blocks > 0 && std::getline(in, line); --n_blocks)
    {
      unsigned int  dimension = 0, entity = 0, type = 0;
      unsigned long n = 0;
      std::istringstream(line) >> dimension >> entity >> type >> n;
      summary.n_elements[type] += n;
      while (n-- > 0 && std::getline(in, line))
        ;
    }
}

GmshSummary scan(const std::string &file)
{
  std::ifstream in(file);
  if (!in)
    throw InputError("The mesh file '" + file + "' cannot be opened.");
  std::string line;
  std::getline(in, line);
  if (line.compare(0, 11, "$MeshFormat") != 0)
    throw InputError("'" + file +
                     "' is not a mesh file of Gmsh: it does not begin with $MeshFormat.");
  double version = 0.;
  int    binary  = 1;
  in >> version >> binary;
  if (binary != 0 || !(version == 2.2 || version == 4.1))
    throw InputError("'" + file + "' is a Gmsh file of version " + to_text(version) +
                     (binary != 0 ? ", binary" : "") +
                     "; 2.2 and 4.1 in ASCII can be read (gmsh -format msh41).");

  GmshSummary summary;
  while (std::getline(in, line))
    if (line.compare(0, 14, "$PhysicalNames") == 0)
      {
        unsigned int n = 0;
        in >> n;
        for (; n > 0 && in; --n)
          {
            unsigned int dimension = 0, number = 0;
            in >> dimension >> number;
            std::getline(in, line);
            const auto first = line.find('"'), last = line.rfind('"');
            if (first + 1 < last && dimension > 1)
              (dimension == 2 ? summary.surfaces :
                                summary.volumes)[line.substr(first + 1, last - first - 1)] = number;
          }
        skip_to(in, "$EndPhysicalNames");
      }
    else if (line.compare(0, 9, "$Elements") == 0)
      count_elements(in, version, summary);
  return summary;
}

void check_elements(const std::string &file, const GmshSummary &summary)
{
  // Gmsh's numbers of the three-dimensional elements of first and second order
  static const std::map<unsigned int, std::string> others = {{4, "tetrahedra"},
                                                             {6, "prisms"},
                                                             {7, "pyramids"},
                                                             {11, "tetrahedra of second order"},
                                                             {12, "hexahedra of second order"},
                                                             {17, "hexahedra of second order"},
                                                             {13, "prisms of second order"},
                                                             {14, "pyramids of second order"}};
  for (const auto &[type, name] : others)
    if (const auto found = summary.n_elements.find(type); found != summary.n_elements.end())
      throw InputError("The mesh '" + file + "' has " + std::to_string(found->second) + " " + name +
                       "; only hexahedra of first order are allowed.");
  if (summary.n_elements.count(5) == 0)
    throw InputError("The mesh '" + file + "' has no hexahedra.");
}

/// Number of the surface called @p name.
unsigned int number_of(const std::string &file, const GmshSummary &summary, const std::string &name)
{
  if (const auto found = summary.surfaces.find(name); found != summary.surfaces.end())
    return found->second;
  std::string names;
  for (const auto &surface : summary.surfaces)
    names += (names.empty() ? "'" : ", '") + surface.first + "'";
  throw InputError("The mesh '" + file + "' has no physical surface '" + name + "'; it has " +
                   (names.empty() ? "none with a name" : names) + ".");
}

std::string in_mm(const Point<3> &p)
{
  return "(" + to_text(1e3 * p[0]) + ", " + to_text(1e3 * p[1]) + ", " + to_text(1e3 * p[2]) +
         ") mm";
}

void check_cells(const std::string &file, const dealii::Triangulation<3> &mesh)
{
  unsigned int n_inverted = 0;
  Point<3>     where;
  for (const auto &cell : mesh.active_cell_iterators())
    if (scaled_jacobian(corners_of(cell)) <= 0.)
      {
        if (n_inverted == 0)
          where = cell->center();
        ++n_inverted;
      }
  if (n_inverted > 0)
    throw InputError("The mesh '" + file + "' has " + std::to_string(n_inverted) +
                     " inverted cells of " + std::to_string(mesh.n_active_cells()) +
                     "; the first is at " + in_mm(where) + ".");
}

void check_teeth(const std::string              &file,
                 const dealii::Triangulation<3> &mesh,
                 const drive::ToothForm         &form)
{
  double   worst = 0.;
  Point<3> where;
  for (const auto &face : mesh.active_face_iterators())
    if (face->at_boundary() && face->boundary_id() == tooth_flanks)
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
  if (worst > 0.05 * form.pitch)
    throw InputError("The tooth flanks of the mesh '" + file + "' are " + to_text(1e3 * worst, 4) +
                     " mm away from the drive's tooth form at " + in_mm(where) +
                     ". Lengths must be in mm, the axis of rotation must be the z axis, the middle "
                     "of a gap must be on +x, and the number of teeth must be " +
                     std::to_string(form.teeth) + ".");
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
        throw InputError("Model/Half model = true needs a mesh with vertices in its middle plane, "
                         "but in '" +
                         file + "' the cell at " + in_mm(cell->center()) +
                         " lies on both sides of it. Choose another mesh, or Half model = false.");
      if (high > same)
        above.push_back(cell->active_cell_index());
      difference += (high > same ? 1. : -1.) * cell->measure();
      volume += cell->measure();
    }
  if (std::abs(difference) > 1e-6 * volume)
    throw InputError("Model/Half model = true needs a mesh that is symmetric about its middle "
                     "plane, but '" +
                     file +
                     "' has different volumes on its two sides. Choose another mesh, or "
                     "Half model = false.");
  auto half = cut_out(mesh, above, [](const CellIterator &) { return middle_plane; });
  dealii::GridTools::transform(
      [same](const Point<3> &x) { return Point<3>(x[0], x[1], std::abs(x[2]) < same ? 0. : x[2]); },
      *half);
  return half;
}
} // namespace

std::string find_file(const std::string &name, const std::vector<std::string> &folders)
{
  namespace fs = std::filesystem;
  std::string looked;
  if (fs::path(name).is_absolute())
    {
      if (fs::is_regular_file(name))
        return name;
      looked = name;
    }
  else
    for (const std::string &folder : folders)
      {
        const fs::path path = (fs::path(folder) / name).lexically_normal();
        if (fs::is_regular_file(path))
          return path.string();
        looked += (looked.empty() ? "" : " and ") + path.string();
      }
  throw InputError("There is no file '" + name + "'; looked for " + looked + ".");
}

Part import_sprocket(const std::string      &file,
                     const drive::ToothForm &form,
                     const double            density,
                     const bool              half)
{
  const GmshSummary summary = scan(file);
  check_elements(file, summary);
  std::map<unsigned int, Surface> surface_of = {
      {number_of(file, summary, "tooth flanks"), tooth_flanks},
      {number_of(file, summary, "hub"), hub}};
  if (summary.surfaces.count("sides") > 0)
    surface_of[summary.surfaces.at("sides")] = sprocket_sides;

  Part part;
  part.name    = "imported sprocket";
  part.density = density;
  part.mesh    = std::make_unique<dealii::Triangulation<3>>();
  try
    {
      dealii::GridIn<3> reader(*part.mesh);
      std::ifstream     in(file);
      reader.read_msh(in);
    }
  catch (const dealii::ExceptionBase &error)
    {
      std::ostringstream why;
      error.print_info(why);
      std::string text = why.str();
      std::replace(text.begin(), text.end(), '\n', ' ');
      text.erase(std::unique(text.begin(),
                             text.end(),
                             [](const char a, const char b) { return a == ' ' && b == ' '; }),
                 text.end());
      if (text.find("deal.II") != std::string::npos) // words for those who program with it
        text = " its sections, counts and numbers do not fit together, as in a damaged file.";
      throw InputError("The mesh '" + file + "' cannot be used:" + text);
    }
  for (const Point<3> &x : part.mesh->get_vertices())
    if (!(x.norm() < 1e5)) // also when it is not a number
      throw InputError("The mesh '" + file + "' has a vertex " + to_text(1e-3 * x.norm(), 3) +
                       " m away from the origin; lengths must be in mm, and at most 100 m.");
  dealii::GridTools::scale(1e-3, *part.mesh);
  double low = 1e300, high = -1e300;
  for (const Point<3> &x : part.mesh->get_vertices())
    {
      low  = std::min(low, x[2]);
      high = std::max(high, x[2]);
    }
  dealii::GridTools::shift(Point<3>(0., 0., -0.5 * (low + high)), *part.mesh);
  check_cells(file, *part.mesh);

  const auto hub_volume = summary.volumes.find("hub zone");
  for (const auto &cell : part.mesh->active_cell_iterators())
    {
      const bool rigid =
          hub_volume != summary.volumes.end() && cell->material_id() == hub_volume->second;
      cell->set_material_id(rigid ? hub_zone : rim);
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
          {
            const auto found = surface_of.find(face->boundary_id());
            face->set_boundary_id(found != surface_of.end() ? found->second : other_surface);
          }
    }
  check_teeth(file, *part.mesh, form);
  if (half)
    {
      part.mesh = upper_half(file, *part.mesh);
      part.half = true;
    }
  part.exact = part.meshed = meshed_properties(part);
  return part;
}
} // namespace chaindrive::mesh
