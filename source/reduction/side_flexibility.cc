// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/reduction/side_flexibility.h>
#include <chaindrive/utilities/checksum.h>
#include <chaindrive/utilities/eigenvalue.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/first_rank.h>
#include <chaindrive/utilities/text.h>
#include <chaindrive/version.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace chaindrive::reduction
{
namespace
{
using dealii::numbers::PI;

/// Of what is kept: to be raised with every change that changes results.
constexpr unsigned int side_version = 1;

struct Patch
{
  unsigned int side, column, ring;
};

/// What is done with the patches of sides by their numbers.
struct Numbering
{
  explicit Numbering(const std::vector<SidePatches> &sides) : sides(sides)
  {
    for (const SidePatches &side : sides)
      {
        first.push_back(n);
        n += side.n();
      }
  }

  unsigned int number(const Patch &p) const
  {
    return first[p.side] + p.column * sides[p.side].n_rings() + p.ring;
  }

  /// The patch at the mirror image of @p p across the axis @p d; without one, of side none.
  Patch reflected(const Patch &p, const unsigned int d) const
  {
    const SidePatches &side  = sides[p.side];
    const unsigned int n     = side.n_columns;
    Patch              image = p;
    if (d < 2)
      {
        image.column          = (d == 0 ? n + n / 2 - p.column : n - p.column) % n;
        dealii::Point<2> axis = side.axis;
        axis[d]               = -axis[d];
        image.side            = none;
        for (unsigned int s = 0; s < sides.size(); ++s)
          if (sides[s].axis.distance(axis) < 1e-6 * side.radius &&
              std::abs(sides[s].radius - side.radius) < 1e-6 * side.radius &&
              sides[s].bounds == side.bounds)
            image.side = s;
        return image;
      }
    const unsigned int opposite = side.n_rings() - 1 - p.ring;
    image.ring                  = opposite;
    if (std::abs(side.height[opposite] + side.height[p.ring]) > 1e-6 * side.radius)
      image.side = none;
    return image;
  }

  static constexpr unsigned int none = static_cast<unsigned int>(-1);

  const std::vector<SidePatches> &sides;
  std::vector<unsigned int>       first;
  unsigned int                    n = 0;
};

/// Maps of all patches onto others that the part looks the same from.
std::vector<std::vector<unsigned int>> symmetries(const FreePart &part, const Numbering &numbering)
{
  std::vector<Patch> all;
  for (unsigned int side = 0; side < numbering.sides.size(); ++side)
    for (unsigned int c = 0; c < numbering.sides[side].n_columns; ++c)
      for (unsigned int s = 0; s < numbering.sides[side].n_rings(); ++s)
        all.push_back({side, c, s});

  std::vector<std::vector<unsigned int>> maps;
  for (const unsigned int d : part.symmetry().axis)
    {
      std::vector<unsigned int> map;
      for (const Patch &p : all)
        if (const Patch image = numbering.reflected(p, d); image.side != Numbering::none)
          map.push_back(numbering.number(image));
      if (map.size() == all.size())
        maps.push_back(map);
    }
  const SidePatches &first = numbering.sides.front();
  if (std::all_of(numbering.sides.begin(), numbering.sides.end(), [&first](const SidePatches &s) {
        return s.axis.norm() < 1e-9 * s.radius && s.n_columns == first.n_columns;
      }))
    {
      std::vector<unsigned int> map; // all a column further
      for (Patch p : all)
        {
          p.column = (p.column + 1) % first.n_columns;
          map.push_back(numbering.number(p));
        }
      maps.push_back(map);
    }
  return maps;
}

[[noreturn]] void
refuse(const mesh::Part &part, const mesh::Surface surface, const std::string &why)
{
  throw InputError("The side '" + mesh::surface_name(surface) + "' of the " + part.name +
                   " cannot be divided into patches: " + why + ".");
}

mesh::CylinderGrid equal_columns(const mesh::Part &part, const mesh::Surface surface)
{
  mesh::CylinderGrid grid(part, surface);
  if (!grid.uniform() || std::abs(grid.angles[0]) > 1e-6 || grid.n_circumferential() % 4 != 0)
    refuse(part,
           surface,
           "its nodes are not at equal angles from the x axis on, a multiple of four in number");
  return grid;
}

std::string key_of_sides(const FreePart &part, const std::vector<SidePatches> &sides)
{
  Checksum   sum;
  const auto add = [&sum](const double *values, const std::size_t n) {
    sum.add(reinterpret_cast<const char *>(values), n * sizeof(double));
  };
  for (unsigned int row = 0; row < part.n_unknowns(); ++row)
    for (auto entry = part.stiffness().begin(row); entry != part.stiffness().end(row); ++entry)
      {
        const double numbers[] = {double(entry->column()), entry->value()};
        add(numbers, 2);
      }
  add(part.mass().get_vector().begin(), part.n_unknowns());
  std::string key = "flexibility of the sides of the " + part.name();
  for (const SidePatches &side : sides)
    {
      for (const unsigned int node : side.node)
        {
          const double number = node;
          add(&number, 1);
        }
      for (const std::vector<double> &shares : side.share)
        add(shares.data(), shares.size());
      key += "; side " + std::to_string(side.surface) + " with " + std::to_string(side.n());
    }
  return key + "; matrices and shares " + std::to_string(sum.value()) + "; version " +
         std::to_string(side_version) + " of " + chaindrive::version;
}
} // namespace

SidePatches::SidePatches(const mesh::Part   &part,
                         const mesh::Nodes  &nodes,
                         const mesh::Surface surface)
    : surface(surface)
{
  const mesh::CylinderGrid grid = equal_columns(part, surface);
  radius                        = grid.radius;
  axis                          = grid.axis;
  n_columns                     = grid.n_circumferential();
  bounds = height = grid.rings;
  for (unsigned int r = 0; r < grid.n_rings(); ++r)
    {
      share.emplace_back(grid.n_rings(), 0.);
      share[r][r] = 1.;
      length.push_back(grid.area(r, 0) * n_columns / (2. * PI * radius));
    }
  for (const unsigned int v : grid.vertex)
    node.push_back(nodes.of_vertex[v]);
}

SidePatches::SidePatches(const mesh::Part          &part,
                         const mesh::Nodes         &nodes,
                         const mesh::Surface        surface,
                         const std::vector<double> &bounds)
    : surface(surface), bounds(bounds)
{
  const mesh::CylinderGrid grid = equal_columns(part, surface);
  radius                        = grid.radius;
  axis                          = grid.axis;
  n_columns                     = grid.n_circumferential();
  for (unsigned int s = 0; s + 1 < bounds.size(); ++s)
    {
      std::vector<double> part_of(grid.n_rings(), 0.);
      double              sum = 0., middle = 0.;
      for (unsigned int r = 0; r < grid.n_rings(); ++r)
        {
          const double z = grid.rings[r];
          part_of[r]     = 0.;
          for (const unsigned int other : {r - 1, r + 1}) // below and above
            if (other < grid.n_rings())
              {
                // the integral of what falls from 1 at z to 0 at the other row
                const double height = grid.rings[other] - z;
                const auto   at     = [&](const double bound) {
                  const double t = std::clamp((bound - z) / height, 0., 1.);
                  return std::abs(height) * (t - 0.5 * t * t);
                };
                part_of[r] += std::abs(at(bounds[s + 1]) - at(bounds[s]));
              }
          sum += part_of[r];
          middle += part_of[r] * z;
        }
      if (!(sum > 0.))
        refuse(part,
               surface,
               "there is nothing of it from z = " + to_text(1e3 * bounds[s], 4) + " to " +
                   to_text(1e3 * bounds[s + 1], 4) + " mm");
      for (double &x : part_of)
        x /= sum;
      share.push_back(part_of);
      length.push_back(sum);
      height.push_back(middle / sum);
    }
  for (const unsigned int v : grid.vertex)
    node.push_back(nodes.of_vertex[v]);
}

double SidePatches::angle(const unsigned int column) const { return 2. * PI * column / n_columns; }

Vector SidePatches::force(const unsigned int column,
                          const unsigned int ring,
                          const unsigned int n_unknowns) const
{
  Vector       f(n_unknowns);
  const double c = std::cos(angle(column)), s = std::sin(angle(column));
  for (unsigned int r = 0; r < share[ring].size(); ++r)
    {
      const unsigned int a = node[r * n_columns + column];
      f[3 * a]             = c * share[ring][r];
      f[3 * a + 1]         = s * share[ring][r];
    }
  return f;
}

double
SidePatches::displacement(const Vector &u, const unsigned int column, const unsigned int ring) const
{
  const double c = std::cos(angle(column)), s = std::sin(angle(column));
  double       sum = 0.;
  for (unsigned int r = 0; r < share[ring].size(); ++r)
    {
      const unsigned int a = node[r * n_columns + column];
      sum += share[ring][r] * (c * u[3 * a] + s * u[3 * a + 1]);
    }
  return sum;
}

SideFlexibility side_flexibility(const FreePart &part, const std::vector<SidePatches> &sides)
{
  const Numbering   numbering(sides);
  const auto        maps = symmetries(part, numbering);
  SideFlexibility   flexibility(numbering.n, numbering.n);
  std::vector<char> known(numbering.n, 0);

  unsigned int j = 0;
  for (const SidePatches &loaded : sides)
    for (unsigned int c = 0; c < loaded.n_columns; ++c)
      for (unsigned int s = 0; s < loaded.n_rings(); ++s, ++j)
        {
          if (known[j] != 0)
            continue;
          const Vector u = part.displacement(loaded.force(c, s, part.n_unknowns()));
          unsigned int i = 0;
          for (const SidePatches &side : sides)
            for (unsigned int column = 0; column < side.n_columns; ++column)
              for (unsigned int ring = 0; ring < side.n_rings(); ++ring, ++i)
                flexibility(i, j) = side.displacement(u, column, ring);
          known[j] = 1;
          // the images of this column, and theirs
          std::vector<unsigned int> todo = {j};
          while (!todo.empty())
            {
              const unsigned int from = todo.back();
              todo.pop_back();
              for (const auto &map : maps)
                if (known[map[from]] == 0)
                  {
                    for (unsigned int row = 0; row < numbering.n; ++row)
                      flexibility(map[row], map[from]) = flexibility(row, from);
                    known[map[from]] = 1;
                    todo.push_back(map[from]);
                  }
            }
        }
  // solutions are as symmetric as round-off lets them be
  for (unsigned int row = 0; row < numbering.n; ++row)
    for (unsigned int column = 0; column < row; ++column)
      flexibility(row, column) = flexibility(column, row) =
          0.5 * (flexibility(row, column) + flexibility(column, row));
  return flexibility;
}

SideFlexibility kept_side_flexibility(const std::function<const FreePart &()> &part,
                                      const std::vector<SidePatches>          &sides,
                                      statics::Cache                          &cache,
                                      const MPI_Comm                           comm)
{
  unsigned int n = 0;
  for (const SidePatches &side : sides)
    n += side.n();
  const std::size_t size = std::size_t(n) * n * sizeof(double);
  std::string       kept;
  on_first_rank(comm, [&] {
    const std::string key  = key_of_sides(part(), sides);
    const auto        fits = [size](const nlohmann::json &json) {
      return dealii::Utilities::decode_base64(json.at("m/N")).size() == size;
    };
    if (const auto found = cache.find(key, fits))
      {
        kept = found->at("m/N");
        return;
      }
    const SideFlexibility computed = side_flexibility(part(), sides);
    const auto           *bytes    = reinterpret_cast<const unsigned char *>(&computed(0, 0));
    kept = dealii::Utilities::encode_base64(std::vector<unsigned char>(bytes, bytes + size));
    cache.keep(key, {{"m/N", kept}});
  });
  if (n_ranks_in(comm) > 1)
    kept = dealii::Utilities::MPI::broadcast(comm, kept);
  const std::vector<unsigned char> bytes = dealii::Utilities::decode_base64(kept);
  SideFlexibility                  result(n, n);
  std::memcpy(&result(0, 0), bytes.data(), size);
  return result;
}

dealii::FullMatrix<double> patch_motions(const std::vector<SidePatches> &sides,
                                         const std::vector<Vector>      &motions)
{
  unsigned int n = 0;
  for (const SidePatches &side : sides)
    n += side.n();
  dealii::FullMatrix<double> rows(n, motions.size());
  for (unsigned int m = 0; m < motions.size(); ++m)
    {
      unsigned int i = 0;
      for (const SidePatches &side : sides)
        for (unsigned int c = 0; c < side.n_columns; ++c)
          for (unsigned int s = 0; s < side.n_rings(); ++s, ++i)
            rows(i, m) = side.displacement(motions[m], c, s);
    }
  return rows;
}

SideFlexibility residual_flexibility(const SideFlexibility            &flexibility,
                                     const dealii::FullMatrix<double> &modes,
                                     const std::vector<double>        &omega)
{
  SideFlexibility residual = flexibility;
  for (unsigned int i = 0; i < modes.m(); ++i)
    for (unsigned int j = 0; j < modes.m(); ++j)
      for (unsigned int m = 0; m < modes.n(); ++m)
        residual(i, j) -= modes(i, m) * modes(j, m) / (omega[m] * omega[m]);
  return residual;
}

double closed_frequency(const std::vector<double>        &omega,
                        const dealii::FullMatrix<double> &rigid,
                        const dealii::FullMatrix<double> &modes,
                        const SideFlexibility            &residual,
                        const std::vector<unsigned int>  &closed)
{
  const unsigned int n = static_cast<unsigned int>(closed.size()), n_rigid = rigid.n(),
                     n_all = n_rigid + static_cast<unsigned int>(omega.size());
  dealii::FullMatrix<double> inverse(n, n), rows(n, n_all), held(n, n_all), matrix(n_all, n_all);
  for (unsigned int i = 0; i < n; ++i)
    {
      for (unsigned int j = 0; j < n; ++j)
        inverse(i, j) = residual(closed[i], closed[j]);
      for (unsigned int m = 0; m < n_all; ++m)
        rows(i, m) = m < n_rigid ? rigid(closed[i], m) : modes(closed[i], m - n_rigid);
    }
  if (n > 0)
    {
      inverse.gauss_jordan();
      inverse.mmult(held, rows);
      rows.Tmmult(matrix, held);
    }
  for (unsigned int m = n_rigid; m < n_all; ++m)
    matrix(m, m) += omega[m - n_rigid] * omega[m - n_rigid];
  const dealii::Vector<double> values = eigenpairs(matrix).values;
  return std::sqrt(std::max(0., values[values.size() - 1]));
}
} // namespace chaindrive::reduction
