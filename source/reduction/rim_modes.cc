// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/reduction/rim_modes.h>
#include <chaindrive/utilities/eigenvalue.h>

#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

namespace chaindrive::reduction
{
namespace
{
using dealii::FullMatrix;
using dealii::Point;
using dealii::Tensor;
using dealii::numbers::PI;

/// A point of the section: of a sector, and whether it is that of the next one.
struct OfSector
{
  unsigned int point;
  unsigned int next; ///< 0 or 1

  bool operator<(const OfSector &other) const
  {
    return std::make_pair(point, next) < std::make_pair(other.point, other.next);
  }
};

/// A quadrilateral of unit thickness in plane stress: stiffness [N/m per m] in x and y of its
/// corners, and an integral of each corner's shape function, m2.
struct Quadrilateral
{
  Quadrilateral(const std::array<Point<2>, 4> &corners, const Material &material)
      : stiffness(8, 8), area{}
  {
    constexpr std::array<double, 4> xi = {{-1., 1., 1., -1.}}, eta = {{-1., -1., 1., 1.}};
    const double                    nu = material.poissons_ratio, factor = material.plane_modulus();
    // gradients in the unit cell, of corners and of the two incompatible modes, and the Jacobian
    const auto jacobian = [&](const double x, const double y) {
      Tensor<2, 2> j; // [in the cell][in the plane]
      for (unsigned int a = 0; a < 4; ++a)
        for (unsigned int d = 0; d < 2; ++d)
          {
            j[0][d] += 0.25 * xi[a] * (1. + eta[a] * y) * corners[a][d];
            j[1][d] += 0.25 * eta[a] * (1. + xi[a] * x) * corners[a][d];
          }
      return j;
    };
    const Tensor<2, 2> middle      = jacobian(0., 0.);
    const double       of_middle   = dealii::determinant(middle);
    const Tensor<2, 2> from_middle = dealii::invert(middle);
    FullMatrix<double> of_all(12, 12);
    constexpr double   gauss[2] = {-0.57735026918962576, 0.57735026918962576};
    for (const double x : gauss)
      for (const double y : gauss)
        {
          const Tensor<2, 2> j = jacobian(x, y), inverse = dealii::invert(j);
          const double       weight = dealii::determinant(j);
          if (!(weight > 0.))
            throw std::logic_error("RimModes: a cell of the sprocket is turned inside out");
          std::array<Tensor<1, 2>, 6> gradient;
          for (unsigned int a = 0; a < 4; ++a)
            {
              area[a] += weight * 0.25 * (1. + xi[a] * x) * (1. + eta[a] * y);
              Tensor<1, 2> of_cell;
              of_cell[0]  = 0.25 * xi[a] * (1. + eta[a] * y);
              of_cell[1]  = 0.25 * eta[a] * (1. + xi[a] * x);
              gradient[a] = inverse * of_cell;
            }
          for (unsigned int i = 0; i < 2; ++i) // 1 - x^2, 1 - y^2, by the middle's Jacobian
            {
              Tensor<1, 2> of_cell;
              of_cell[i]      = -2. * (i == 0 ? x : y);
              gradient[4 + i] = of_middle / weight * (from_middle * of_cell);
            }
          for (unsigned int a = 0; a < 6; ++a)
            for (unsigned int b = 0; b < 6; ++b)
              {
                const Tensor<1, 2> &g = gradient[a], &h = gradient[b];
                const double        shear   = 0.5 * (1. - nu);
                const double        k[2][2] = {
                           {g[0] * h[0] + shear * g[1] * h[1], nu * g[0] * h[1] + shear * g[1] * h[0]},
                           {nu * g[1] * h[0] + shear * g[0] * h[1], g[1] * h[1] + shear * g[0] * h[0]}};
                for (unsigned int c = 0; c < 2; ++c)
                  for (unsigned int d = 0; d < 2; ++d)
                    of_all(2 * a + c, 2 * b + d) += weight * factor * k[c][d];
              }
        }
    // the incompatible modes follow
    FullMatrix<double> own(4, 4), coupled(4, 8), solved(4, 8);
    for (unsigned int i = 0; i < 4; ++i)
      {
        for (unsigned int j = 0; j < 4; ++j)
          own(i, j) = of_all(8 + i, 8 + j);
        for (unsigned int j = 0; j < 8; ++j)
          coupled(i, j) = of_all(8 + i, j);
      }
    own.gauss_jordan();
    own.mmult(solved, coupled);
    for (unsigned int i = 0; i < 8; ++i)
      for (unsigned int j = 0; j < 8; ++j)
        {
          stiffness(i, j) = of_all(i, j);
          for (unsigned int k = 0; k < 4; ++k)
            stiffness(i, j) -= coupled(k, i) * solved(k, j);
        }
  }

  FullMatrix<double>    stiffness;
  std::array<double, 4> area;
};

/// One sector of a rim, whose points on the hub are held.
class RimSector
{
public:
  RimSector(const drive::ToothForm         &form,
            const mesh::SprocketDimensions &dimensions,
            const Material                 &material,
            unsigned int                    refinement);

  /// Adds to @p modes those with @p waves round the rim up to @p modes_up_to [rad/s].
  void add_modes(unsigned int waves, double modes_up_to, RimModes &modes) const;

  const std::vector<double> &along() const { return along_; }

private:
  static constexpr unsigned int held = static_cast<unsigned int>(-1);

  struct Cell
  {
    std::array<OfSector, 4> corner;
    FullMatrix<double>      stiffness; ///< N/m, each corner in the axes of its own sector
  };

  /// The axes of the next sector in those of this one.
  Tensor<2, 2> turn() const
  {
    const double cosine = std::cos(2. * PI / teeth_), sine = std::sin(2. * PI / teeth_);
    return Tensor<2, 2>({{cosine, -sine}, {sine, cosine}});
  }

  /// Lists the points of the profile, from the middle of one tooth to that of the next.
  void find_profile(const std::vector<Point<2>> &points, double half_length);

  unsigned int              teeth_, n_unknowns_ = 0;
  std::vector<Cell>         cells_;
  std::vector<unsigned int> unknown_; ///< of each point the first one; or held
  std::vector<double>       mass_;    ///< of each point, kg
  std::vector<OfSector>     profile_;
  std::vector<double>       along_; ///< of these, m
};

RimSector::RimSector(const drive::ToothForm         &form,
                     const mesh::SprocketDimensions &dimensions,
                     const Material                 &material,
                     const unsigned int              refinement)
    : teeth_(form.teeth)
{
  const mesh::PlanarMesh section  = mesh::sprocket_section(form, dimensions, refinement);
  const auto             n_points = static_cast<unsigned int>(section.points.size() / teeth_);
  const std::size_t      n_quads  = section.quads.size() / teeth_;
  unknown_.assign(n_points, held);
  mass_.assign(n_points, 0.);
  std::vector<char> of_hub(n_points, 0);
  for (std::size_t q = 0; q < n_quads; ++q)
    {
      const mesh::PlanarMesh::Quad &quad = section.quads[q];
      std::array<Point<2>, 4>       corners;
      Cell                          cell{{}, FullMatrix<double>(8, 8)};
      for (unsigned int v = 0; v < 4; ++v)
        {
          corners[v]     = section.points[quad.vertices[v]];
          cell.corner[v] = {quad.vertices[v] % n_points, quad.vertices[v] / n_points};
          if (quad.component == mesh::hub_zone)
            of_hub[cell.corner[v].point] = 1;
        }
      if (quad.component == mesh::hub_zone)
        continue;
      const Quadrilateral in_plane(corners, material);
      const Tensor<2, 2>  next = turn();
      const auto          axes = [&](const unsigned int v) {
        return cell.corner[v].next != 0 ? next : Tensor<2, 2>({{1., 0.}, {0., 1.}});
      };
      for (unsigned int a = 0; a < 4; ++a)
        {
          mass_[cell.corner[a].point] += material.density * dimensions.width * in_plane.area[a];
          unknown_[cell.corner[a].point] = 0;
          for (unsigned int b = 0; b < 4; ++b)
            {
              Tensor<2, 2> block;
              for (unsigned int c = 0; c < 2; ++c)
                for (unsigned int d = 0; d < 2; ++d)
                  block[c][d] = dimensions.width * in_plane.stiffness(2 * a + c, 2 * b + d);
              block = dealii::transpose(axes(a)) * block * axes(b);
              for (unsigned int c = 0; c < 2; ++c)
                for (unsigned int d = 0; d < 2; ++d)
                  cell.stiffness(2 * a + c, 2 * b + d) = block[c][d];
            }
        }
      cells_.push_back(cell);
    }
  for (unsigned int p = 0; p < n_points; ++p)
    {
      if (of_hub[p] != 0)
        unknown_[p] = held;
      if (unknown_[p] == held)
        continue;
      unknown_[p] = n_unknowns_;
      n_unknowns_ += 2;
    }
  double half_length = 0.;
  for (const drive::Segment &segment : form.half_profile)
    half_length += std::max(0., segment.length());
  find_profile(std::vector<Point<2>>(section.points.begin(), section.points.begin() + n_points),
               half_length);
}

void RimSector::find_profile(const std::vector<Point<2>> &points, const double half_length)
{
  // Edges of one cell only, which are those of the profile and of the hub; those of other sectors
  // are moved to where one point is of this one.
  using Edge = std::pair<OfSector, OfSector>;
  std::map<Edge, unsigned int> times;
  for (const Cell &cell : cells_)
    for (unsigned int v = 0; v < 4; ++v)
      {
        OfSector           a = cell.corner[v], b = cell.corner[(v + 1) % 4];
        const unsigned int first = std::min(a.next, b.next);
        a.next -= first;
        b.next -= first;
        ++times[b < a ? Edge(b, a) : Edge(a, b)];
      }
  std::map<unsigned int, std::vector<std::pair<unsigned int, int>>> beside; // point, sectors on
  for (const auto &[edge, n] : times)
    if (const auto &[a, b] = edge;
        n == 1 && (unknown_[a.point] != held || unknown_[b.point] != held))
      {
        beside[a.point].push_back({b.point, int(b.next) - int(a.next)});
        beside[b.point].push_back({a.point, int(a.next) - int(b.next)});
      }
  // from the bottom of gap 0 upwards, to the middle of the tooth
  unsigned int here = held;
  for (const auto &[point, neighbours] : beside)
    if (here == held || std::abs(points[point][1]) < std::abs(points[here][1]))
      here = point;
  if (here == held)
    throw std::logic_error("RimModes: a sprocket without a profile");
  std::vector<OfSector> upper    = {{here, 0}};
  const auto            position = [&](const OfSector &at) {
    return at.next != 0 ? Point<2>(turn() * points[at.point]) : points[at.point];
  };
  std::vector<double> length   = {0.};
  unsigned int        previous = held;
  while (std::atan2(position(upper.back())[1], position(upper.back())[0]) <
         (1. - 1e-9) * PI / teeth_)
    {
      const OfSector at    = upper.back();
      bool           found = false;
      for (const auto &[point, sectors] : beside.at(at.point))
        {
          const int next = int(at.next) + sectors;
          if (found || point == previous || next < 0 || next > 1)
            continue;
          const OfSector to{point, static_cast<unsigned int>(next)};
          if (upper.size() == 1 && position(to)[1] < 0.)
            continue;
          found = true;
          length.push_back(length.back() + position(to).distance(position(at)));
          upper.push_back(to);
        }
      if (!found)
        throw std::logic_error("RimModes: the profile of a sprocket has an end");
      previous = at.point;
    }
  // chords are a little shorter than the profile
  for (double &l : length)
    l *= half_length / length.back();
  // points below are the mirror images, by their places
  const auto mirrored = [&](const OfSector &at) {
    const Point<2> x = position(at);
    OfSector       nearest{held, 0};
    double         least = 0.;
    for (const auto &entry : beside)
      {
        const double d = points[entry.first].distance(Point<2>(x[0], -x[1]));
        if (nearest.point == held || d < least)
          {
            nearest = {entry.first, 0};
            least   = d;
          }
      }
    if (least > 1e-6 * half_length)
      throw std::logic_error("RimModes: the profile of a sprocket is not symmetric");
    return nearest;
  };
  for (std::size_t i = upper.size(); i-- > 1;)
    {
      profile_.push_back(mirrored(upper[i]));
      along_.push_back(-length[i]);
    }
  profile_.insert(profile_.end(), upper.begin(), upper.end());
  along_.insert(along_.end(), length.begin(), length.end());
}

void RimSector::add_modes(const unsigned int waves, const double modes_up_to, RimModes &modes) const
{
  // Of a sector between others, whose displacement is the real part of (a + i b) exp(2 pi i waves j
  // / z) in sector j, in terms of a and b; real itself where the factor is.
  const bool         real = waves == 0 || 2 * waves == teeth_;
  const unsigned int n    = n_unknowns_;
  FullMatrix<double> matrix(real ? n : 2 * n);
  const auto         factor = [&](const int sectors) {
    return std::polar(1., 2. * PI * waves * sectors / teeth_);
  };
  for (const Cell &cell : cells_)
    for (unsigned int a = 0; a < 4; ++a)
      for (unsigned int b = 0; b < 4; ++b)
        {
          const unsigned int i = unknown_[cell.corner[a].point], j = unknown_[cell.corner[b].point];
          if (i == held || j == held)
            continue;
          const std::complex<double> e =
              factor(int(cell.corner[b].next) - int(cell.corner[a].next)) /
              std::sqrt(mass_[cell.corner[a].point] * mass_[cell.corner[b].point]);
          for (unsigned int c = 0; c < 2; ++c)
            for (unsigned int d = 0; d < 2; ++d)
              {
                const double k = cell.stiffness(2 * a + c, 2 * b + d);
                matrix(i + c, j + d) += k * e.real();
                if (real)
                  continue;
                matrix(n + i + c, n + j + d) += k * e.real();
                matrix(i + c, n + j + d) -= k * e.imag();
                matrix(n + i + c, j + d) += k * e.imag();
              }
        }
  matrix.symmetrize();
  const Eigenpairs found = eigenpairs(matrix, modes_up_to * modes_up_to);
  const double     unit  = std::sqrt((real ? 1. : 2.) / teeth_);
  for (unsigned int m = 0; m < found.values.size(); ++m)
    {
      modes.omega.push_back(std::sqrt(std::max(0., found.values[m])));
      modes.waves.push_back(waves);
      for (const OfSector &at : profile_)
        {
          const unsigned int i = unknown_[at.point];
          Tensor<1, 2>       cosine, sine;
          for (unsigned int d = 0; d < 2 && i != held; ++d)
            {
              const double               root = std::sqrt(mass_[at.point]);
              const std::complex<double> u =
                  std::complex<double>(found.vectors(i + d, m),
                                       real ? 0. : found.vectors(n + i + d, m)) *
                  factor(int(at.next)) * (unit / root);
              cosine[d] = u.real();
              sine[d]   = u.imag();
            }
          if (at.next != 0)
            {
              cosine = turn() * cosine;
              sine   = turn() * sine;
            }
          for (unsigned int d = 0; d < 2; ++d)
            {
              modes.cosine.push_back(cosine[d]);
              modes.sine.push_back(sine[d]);
            }
        }
    }
}
} // namespace

double RimModes::highest_frequency() const
{
  return omega.empty() ? 0. : *std::max_element(omega.begin(), omega.end());
}

RimModes::Place RimModes::place_at(const double at) const
{
  const auto after = std::upper_bound(along.begin(), along.end(), at);
  if (after == along.begin())
    return {0, 0.};
  if (after == along.end())
    return {n_points() - 2, 1.};
  const auto before = after - 1;
  return {static_cast<unsigned int>(before - along.begin()), (at - *before) / (*after - *before)};
}

double RimModes::compliance(const std::vector<double> &forces) const
{
  const std::size_t n   = 2 * std::size_t(n_points());
  double            sum = 0.;
  for (unsigned int m = 0; m < n_modes(); ++m)
    {
      double force = 0.;
      for (std::size_t i = 0; i < n; ++i)
        force += cosine[m * n + i] * forces[i];
      sum += force * force / (omega[m] * omega[m]);
    }
  return sum;
}

RimModes make_rim_modes(const drive::ToothForm         &form,
                        const mesh::SprocketDimensions &dimensions,
                        const Material                 &material,
                        const double                    modes_up_to,
                        const unsigned int              refinement)
{
  const RimSector sector(form, dimensions, material, refinement);
  RimModes        modes;
  modes.teeth = form.teeth;
  modes.along = sector.along();
  for (unsigned int waves = 0; 2 * waves <= form.teeth; ++waves)
    sector.add_modes(waves, modes_up_to, modes);
  return modes;
}
} // namespace chaindrive::reduction
