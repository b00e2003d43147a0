// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/fields.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::observe
{
PartPatches::PartPatches(const dealii::Triangulation<3> &mesh, const bool rigid_zone_only)
    : vertices(mesh.get_vertices())
{
  // deal.II numbers the vertices of a cell lexicographically, VTK around its two faces
  constexpr std::array<unsigned int, 8> lexicographic{{0, 1, 3, 2, 4, 5, 7, 6}};
  cells.reserve(mesh.n_active_cells());
  for (const auto &cell : mesh.active_cell_iterators())
    {
      if (rigid_zone_only && cell->material_id() != mesh::hub_zone)
        continue;
      cells.emplace_back();
      for (unsigned int v = 0; v < 8; ++v)
        cells.back()[v] = cell->vertex_index(lexicographic[v]);
    }
}

namespace
{
void write_to(float *place, const dealii::Tensor<1, 3> &v)
{
  for (unsigned int d = 0; d < 3; ++d)
    place[d] = static_cast<float>(v[d]);
}

void append(std::vector<float> &values, const dealii::Tensor<1, 3> &v)
{
  values.insert(values.end(), {float(v[0]), float(v[1]), float(v[2])});
}

/// In VTK's order.
void append(std::vector<float> &values, const dealii::SymmetricTensor<2, 3> &t)
{
  for (const double value : {t[0][0], t[1][1], t[2][2], t[0][1], t[1][2], t[0][2]})
    values.push_back(static_cast<float>(value));
}

/// Of every cell of all bodies.
std::vector<files::VtuGrid::FloatData> stresses_of(const std::vector<BodySnapshot> &bodies)
{
  std::vector<float> von_mises, strain, stress;
  for (const BodySnapshot &body : bodies)
    {
      const std::size_t n = body.part->cells.size();
      Assert(body.stress.size() == 0 || body.stress.size() == n,
             dealii::ExcMessage("One stress per cell"));
      for (const element::Stress &s : body.stress)
        {
          von_mises.push_back(static_cast<float>(element::von_mises(s.cauchy)));
          append(strain, s.strain);
          append(stress, s.piola);
        }
      if (body.stress.size() == 0)
        {
          von_mises.resize(von_mises.size() + n, 0.F);
          strain.resize(strain.size() + 6 * n, 0.F);
          stress.resize(stress.size() + 6 * n, 0.F);
        }
    }
  return {{"von_mises", 1, std::move(von_mises)},
          {"strain", 6, std::move(strain)},
          {"stress", 6, std::move(stress)}};
}

/// At both faces of the cells of walls.
std::vector<files::VtuGrid::FloatData> faces_of(const std::vector<BodySnapshot> &bodies)
{
  std::vector<float> inner, outer;
  for (const BodySnapshot &body : bodies)
    {
      for (const element::FaceStresses &s : body.faces)
        {
          append(inner, s.inner);
          append(outer, s.outer);
        }
      if (body.faces.size() == 0)
        for (std::vector<float> *values : {&inner, &outer})
          values->resize(values->size() + 6 * body.part->cells.size(), 0.F);
    }
  return {{"stress_inner", 6, std::move(inner)}, {"stress_outer", 6, std::move(outer)}};
}

/// What an output shows of stresses; all its pieces show the same.
struct Shown
{
  bool stress, faces, pressure;
};

Shown shown_of(const std::vector<BodySnapshot> &bodies, MPI_Comm comm)
{
  int stress = 0, faces = 0, pressure = 0;
  for (const BodySnapshot &body : bodies)
    {
      stress |= static_cast<int>(body.stress.size() > 0);
      faces |= static_cast<int>(body.faces.size() > 0);
      pressure |= static_cast<int>(body.pressure.size() > 0);
    }
  return {dealii::Utilities::MPI::max(stress, comm) != 0,
          dealii::Utilities::MPI::max(faces, comm) != 0,
          dealii::Utilities::MPI::max(pressure, comm) != 0};
}

/// Normal force [N] in the gap of a sprocket that is nearest to cell @p cell of @p body.
double load_of_gap(const BodySnapshot &body, const std::array<unsigned int, 8> &cell)
{
  dealii::Tensor<1, 3> centre; // at the start
  for (const unsigned int v : cell)
    centre += 0.125 * body.part->vertices[v];
  const Frame               &axes = *body.sprocket;
  const dealii::Tensor<1, 3> arm =
      transpose(axes.rotation) *
      (body.initial.position + body.initial.rotation * centre - axes.position);
  const int  n     = static_cast<int>(body.gap_load.size());
  const auto pitch = 2. * dealii::numbers::PI / n;
  const int  gap   = static_cast<int>(std::lround(std::atan2(arm[1], arm[0]) / pitch));
  return body.gap_load[(gap + n) % n];
}

files::VtuGrid grid_of(const std::vector<BodySnapshot> &bodies, const Shown &shown)
{
  std::size_t n_points = 0, n_cells = 0;
  for (const BodySnapshot &body : bodies)
    {
      n_points += body.part->vertices.size();
      n_cells += body.part->cells.size();
    }

  std::vector<float>        displacement, velocity, pressure, contact_force, tension, tooth_load;
  std::vector<std::int32_t> id, kind, deforms;
  files::VtuGrid            grid;
  for (auto *values : {&displacement, &velocity, &grid.points})
    values->resize(3 * n_points);
  grid.connectivity.reserve(8 * n_cells);
  contact_force.reserve(3 * n_cells);
  for (auto *values : {&tension, &tooth_load})
    values->reserve(n_cells);
  for (auto *numbers : {&id, &kind, &deforms})
    numbers->reserve(n_cells);

  std::int32_t first_point = 0;
  for (const BodySnapshot &body : bodies)
    {
      const auto &vertices = body.part->vertices;
      const bool  elastic  = body.displacement.size() > 0;
      Assert(!elastic || (body.displacement.size() == vertices.size() &&
                          body.velocity.size() == vertices.size()),
             dealii::ExcMessage("One displacement and one velocity per vertex"));
      for (std::size_t v = 0; v < vertices.size(); ++v)
        {
          const dealii::Tensor<1, 3> start =
              body.initial.position + body.initial.rotation * vertices[v];
          const dealii::Tensor<1, 3> arm = body.now.rotation * vertices[v];
          const dealii::Tensor<1, 3> u =
              elastic ? body.displacement[v] : body.now.position + arm - start;
          if (shown.pressure)
            pressure.push_back(body.pressure.size() > 0 ? static_cast<float>(body.pressure[v]) :
                                                          0.F);
          const std::size_t point = 3 * (first_point + v);
          write_to(&grid.points[point], start + u);
          write_to(&displacement[point], u);
          write_to(&velocity[point],
                   elastic ? body.velocity[v] :
                             body.now.velocity + cross_product_3d(body.now.angular_velocity, arm));
        }
      for (const auto &cell : body.part->cells)
        {
          for (const unsigned int v : cell)
            grid.connectivity.push_back(first_point + v);
          append(contact_force, body.contact_force);
          id.push_back(body.id);
          kind.push_back(body.kind);
          deforms.push_back(elastic ? 1 : 0);
          tension.push_back(static_cast<float>(body.tension));
          tooth_load.push_back(static_cast<float>(
              body.gap_load.size() > 0 ? load_of_gap(body, cell) : body.tooth_load));
        }
      first_point += vertices.size();
    }

  grid.point_data = {{"displacement", 3, std::move(displacement)},
                     {"velocity", 3, std::move(velocity)}};
  if (shown.pressure)
    grid.point_data.push_back({"contact_pressure", 1, std::move(pressure)});
  grid.cell_data = {{"contact_force", 3, std::move(contact_force)},
                    {"tension", 1, std::move(tension)},
                    {"tooth_load", 1, std::move(tooth_load)}};
  if (shown.stress)
    for (files::VtuGrid::FloatData &data : stresses_of(bodies))
      grid.cell_data.push_back(std::move(data));
  if (shown.faces)
    for (files::VtuGrid::FloatData &data : faces_of(bodies))
      grid.cell_data.push_back(std::move(data));
  grid.cell_numbers = {
      {"body", std::move(id)}, {"kind", std::move(kind)}, {"elastic", std::move(deforms)}};
  return grid;
}

files::VtuGrid grid_of(const std::vector<BarSnapshot> &bars)
{
  files::VtuGrid grid;
  grid.cell         = files::VtuGrid::Cell::line;
  grid.point_data   = {{"displacement", 3, {}}, {"velocity", 3, {}}};
  grid.cell_data    = {{"tension", 1, {}}};
  grid.cell_numbers = {{"bar", {}}};
  for (const BarSnapshot &bar : bars)
    {
      for (const unsigned int end : {0, 1})
        {
          grid.connectivity.push_back(grid.connectivity.size());
          append(grid.points, bar.position[end]);
          append(grid.point_data[0].values, bar.displacement[end]);
          append(grid.point_data[1].values, bar.velocity[end]);
        }
      grid.cell_data[0].values.push_back(static_cast<float>(bar.tension));
      grid.cell_numbers[0].values.push_back(bar.id);
    }
  return grid;
}
} // namespace

void Fields::write(const double                     time,
                   const std::vector<BodySnapshot> &bodies,
                   const std::vector<BarSnapshot>  &bars)
{
  bodies_.write(grid_of(bodies, shown_of(bodies, comm_)), time);
  if (!bars.empty())
    bars_.write(grid_of(bars), time);
}
} // namespace chaindrive::observe
