// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/fields.h>
#include <chaindrive/utilities/timing.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <numeric>

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

  // what is swept along z has columns of points, mostly of one height
  constexpr std::size_t most_period = 64;
  std::size_t           most        = vertices.size() / 4;
  for (std::size_t p = 2; p <= most_period; ++p)
    {
      std::size_t same = 0;
      for (std::size_t v = p; v < vertices.size(); ++v)
        same += vertices[v][2] == vertices[v - p][2];
      if (same > most)
        {
          most   = same;
          period = p;
        }
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

std::size_t n_cells_of(const std::vector<BodySnapshot> &bodies)
{
  return std::accumulate(
      bodies.begin(), bodies.end(), std::size_t(0), [](const std::size_t n, const BodySnapshot &b) {
        return n + b.part->cells.size();
      });
}

/// Of every cell of all bodies.
std::vector<files::VtuGrid::FloatData> stresses_of(const std::vector<BodySnapshot> &bodies)
{
  std::vector<float> von_mises, strain, stress;
  const std::size_t  n_cells = n_cells_of(bodies);
  von_mises.reserve(n_cells);
  strain.reserve(6 * n_cells);
  stress.reserve(6 * n_cells);
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
  std::vector<int> shown(3, 0); // as in Shown
  for (const BodySnapshot &body : bodies)
    {
      shown[0] |= static_cast<int>(body.stress.size() > 0);
      shown[1] |= static_cast<int>(body.faces.size() > 0);
      shown[2] |= static_cast<int>(body.pressure.size() > 0);
    }
  const Waiting waiting;
  dealii::Utilities::MPI::max(shown, comm, shown);
  return {shown[0] != 0, shown[1] != 0, shown[2] != 0};
}

/// The gap of a sprocket, of which @p body is all or a sector, that is nearest to @p cell.
unsigned int nearest_gap(const BodySnapshot &body, const std::array<unsigned int, 8> &cell)
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
  return static_cast<unsigned int>((gap + n) % n);
}

/// The points of @p body from @p first on, and what belongs to them.
void move_points(const BodySnapshot &body,
                 const std::size_t   first,
                 float              *point,
                 float              *displacement,
                 float              *velocity)
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
      const std::size_t at = 3 * (first + v);
      write_to(point + at, start + u);
      write_to(displacement + at, u);
      write_to(velocity + at,
               elastic ? body.velocity[v] :
                         body.now.velocity + cross_product_3d(body.now.angular_velocity, arm));
    }
}

/// Contact pressure at all points.
std::vector<float> pressures_of(const std::vector<BodySnapshot> &bodies)
{
  std::vector<float> pressure;
  for (const BodySnapshot &body : bodies)
    for (std::size_t v = 0; v < body.part->vertices.size(); ++v)
      pressure.push_back(body.pressure.size() > 0 ? static_cast<float>(body.pressure[v]) : 0.F);
  return pressure;
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

files::VtuGrid grid_of(const std::vector<PatchSnapshot> &contacts)
{
  files::VtuGrid grid;
  grid.cell         = files::VtuGrid::Cell::quad;
  grid.cell_data    = {{"contact_pressure", 1, {}}, {"normal_force", 1, {}}};
  grid.cell_numbers = {{"body", {}}, {"other_body", {}}, {"joint", {}}, {"interface", {}}};
  for (const PatchSnapshot &patch : contacts)
    {
      for (const dealii::Point<3> &corner : patch.corners)
        {
          grid.connectivity.push_back(static_cast<std::int32_t>(grid.connectivity.size()));
          append(grid.points, corner);
        }
      grid.cell_data[0].values.push_back(static_cast<float>(patch.pressure));
      grid.cell_data[1].values.push_back(static_cast<float>(patch.normal_force));
      grid.cell_numbers[0].values.push_back(patch.body);
      grid.cell_numbers[1].values.push_back(patch.other);
      grid.cell_numbers[2].values.push_back(static_cast<std::int32_t>(patch.joint));
      grid.cell_numbers[3].values.push_back(patch.interface);
    }
  return grid;
}
} // namespace

void Fields::set_up(const std::vector<BodySnapshot> &bodies)
{
  std::vector<Drawn> drawn;
  drawn.reserve(bodies.size());
  for (const BodySnapshot &body : bodies)
    drawn.push_back(
        {body.part, body.id, body.kind, body.displacement.size() > 0, body.gap_load.size()});
  const bool is_first = grid_.cell_numbers.empty();
  if (!is_first && drawn == drawn_)
    return;
  drawn_ = std::move(drawn);
  grid_  = {};
  gap_.clear();
  std::vector<std::int32_t> id, kind, deforms;
  std::size_t               n_points = 0, n_cells = 0;
  for (const BodySnapshot &body : bodies)
    {
      for (const auto &cell : body.part->cells)
        {
          for (const unsigned int v : cell)
            grid_.connectivity.push_back(static_cast<std::int32_t>(n_points + v));
          if (body.gap_load.size() > 0)
            gap_.push_back(nearest_gap(body, cell));
        }
      n_points += body.part->vertices.size();
      n_cells += body.part->cells.size();
      id.resize(n_cells, body.id);
      kind.resize(n_cells, body.kind);
      deforms.resize(n_cells, body.displacement.size() > 0 ? 1 : 0);
      grid_.bodies.push_back({body.part->vertices.size(),
                              body.part->cells.size(),
                              body.part->period,
                              body.displacement.size() > 0});
    }
  grid_.cell_numbers = {
      {"body", std::move(id)}, {"kind", std::move(kind)}, {"elastic", std::move(deforms)}};
  grid_.points.resize(3 * n_points);
  grid_.point_data = {{"displacement", 3, std::vector<float>(3 * n_points)},
                      {"velocity", 3, std::vector<float>(3 * n_points)}};
  grid_.cell_data  = {{"contact_force", 3, std::vector<float>(3 * n_cells), true},
                      {"tension", 1, std::vector<float>(n_cells), true},
                      {"tooth_load", 1, std::vector<float>(n_cells), true}};
}

void Fields::write(const double                      time,
                   const std::vector<BodySnapshot>  &bodies,
                   const std::vector<BarSnapshot>   &bars,
                   const std::vector<PatchSnapshot> *contacts)
{
  const Shown shown = shown_of(bodies, comm_);
  set_up(bodies);
  grid_.point_data.resize(2); // without what has been shown before
  grid_.cell_data.resize(3);

  std::size_t point = 0, cell = 0, gap = 0;
  float      *force      = grid_.cell_data[0].values.data();
  float      *tension    = grid_.cell_data[1].values.data();
  float      *tooth_load = grid_.cell_data[2].values.data();
  for (const BodySnapshot &body : bodies)
    {
      move_points(body,
                  point,
                  grid_.points.data(),
                  grid_.point_data[0].values.data(),
                  grid_.point_data[1].values.data());
      point += body.part->vertices.size();
      const std::size_t end = cell + body.part->cells.size();
      std::fill(tension + cell, tension + end, static_cast<float>(body.tension));
      std::fill(tooth_load + cell, tooth_load + end, static_cast<float>(body.tooth_load));
      for (; cell < end; ++cell)
        {
          write_to(force + 3 * cell, body.contact_force);
          if (body.gap_load.size() > 0)
            tooth_load[cell] = static_cast<float>(body.gap_load[gap_[gap++]]);
        }
    }
  if (shown.pressure)
    grid_.point_data.push_back({"contact_pressure", 1, pressures_of(bodies), true}); // few touch
  if (shown.stress)
    for (files::VtuGrid::FloatData &data : stresses_of(bodies))
      grid_.cell_data.push_back(std::move(data));
  if (shown.faces)
    for (files::VtuGrid::FloatData &data : faces_of(bodies))
      grid_.cell_data.push_back(std::move(data));
  bodies_.write(grid_, time);
  if (!bars.empty())
    bars_.write(grid_of(bars), time);
  if (contacts != nullptr)
    contacts_.write(grid_of(*contacts), time);
}
} // namespace chaindrive::observe
