// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/joint_flexibility.h>
#include <chaindrive/stability/closed_ways.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <array>
#include <cmath>

namespace chaindrive::stability
{
namespace
{
using contact::ClosedStrips;
using dealii::numbers::PI;
using Motions = std::vector<dealii::Tensor<1, 3>>;

/// What is closed in a window: a node, or a place in strips.
struct ClosedPlace
{
  unsigned int closed; ///< the window, by its place among all that are closed
  unsigned int place;  ///< or ring * n_columns + column
  double       angle;
  double       across; ///< springs of friction, N/m
  double       shared; ///< its part of the slip of the window's one spring of friction

  unsigned int                n_nodes;
  std::array<unsigned int, 4> node;
  std::array<double, 4>       weight;

  /// What it moves by the motions of @p bodies.
  Motions moved(const ModalGroup &bodies) const
  {
    Motions sum = bodies.motions_of(node[0]);
    for (dealii::Tensor<1, 3> &motion : sum)
      motion *= weight[0];
    for (unsigned int k = 1; k < n_nodes; ++k)
      {
        const Motions of_node = bodies.motions_of(node[k]);
        for (unsigned int j = 0; j < sum.size(); ++j)
          sum[j] += weight[k] * of_node[j];
      }
    return sum;
  }
};

/// All places of @p closed.
std::vector<ClosedPlace> places_of(const std::vector<Closed> &closed)
{
  std::vector<ClosedPlace> places;
  for (unsigned int i = 0; i < closed.size(); ++i)
    {
      const ClosedWindow &window = *closed[i].window;
      if (const ClosedStrips *strips = closed[i].strips())
        for (unsigned int p = 0; p < strips->places.size(); ++p)
          {
            const ClosedStrips::Place &place = strips->places[p];
            const bool in_middle = p / window.n_rings == strips->places.size() / window.n_rings / 2;
            places.push_back({i,
                              p,
                              place.angle,
                              0.,
                              in_middle ? 1. / window.n_rings : 0.,
                              4,
                              place.node,
                              place.weight});
          }
      else
        for (const unsigned int column : closed[i].columns())
          for (unsigned int ring = 0; ring < window.n_rings; ++ring)
            {
              const unsigned int number = ring * window.n_columns + column;
              places.push_back({i,
                                number,
                                2. * PI * column / window.n_columns,
                                window.across[ring],
                                0.,
                                1,
                                {{window.node[number]}},
                                {{1.}}});
            }
    }
  return places;
}

/// What one of @p places moves away from the axis under one newton on another one, m/N.
double flexibility_of(const std::vector<Closed> &closed, const ClosedPlace &a, const ClosedPlace &b)
{
  const ClosedWindow &window = *closed[a.closed].window, &other = *closed[b.closed].window;
  const ClosedStrips *strips = closed[a.closed].strips();
  const unsigned int  n      = window.n_columns;
  if (a.closed == b.closed)
    return strips != nullptr ? strips->flexibility[a.place * strips->places.size() + b.place] :
                               window.flexibility[(a.place / n * window.n_rings + b.place / n) * n +
                                                  (b.place % n + n - a.place % n) % n];
  if (strips == nullptr)
    return closed[b.closed].strips() == nullptr ? 0. : flexibility_of(closed, b, a);
  return strips->through[(std::size_t(a.place) * n + b.place % n) * window.n_rings_of_through +
                         other.first_ring + b.place / n];
}

/// Directions of a place at an @p angle about the axis.
struct Directions
{
  explicit Directions(const double angle)
      : axis(dealii::Point<3>(0., 0., 1.))
      , normal(dealii::Point<3>(std::cos(angle), std::sin(angle), 0.))
      , round(cross_product_3d(axis, normal))
  {
  }

  dealii::Tensor<1, 3> axis, normal, round;
};

/// A node of the cylinder at an @p angle of the ring: where it is in the bore.
struct InBore
{
  InBore(const Ringed &bodies, const ClosedPlace &node, const double angle)
  {
    const ClosedWindow                     &bore = *bodies.bore;
    const contact::JointFlexibility::Place &along =
        bodies.cylinder->joint->places()[node.place / bodies.cylinder->n_columns];
    const unsigned int n      = bore.n_columns;
    const double       column = (angle / (2. * PI) - std::floor(angle / (2. * PI))) * n,
                 before = std::floor(column), part = column - before;
    for (unsigned int k = 0; k < 4; ++k)
      {
        const unsigned int c = (static_cast<unsigned int>(before) + k % 2) % n,
                           r = along.first + k / 2;
        place[k]             = {c, r};
        carried.node[k]      = bore.node[(r - bore.first_ring) * n + c];
        carried.weight[k] =
            (k % 2 == 0 ? 1. - part : part) * (k / 2 == 0 ? 1. - along.part : along.part);
      }
    carried.n_nodes = 4;
  }

  struct Place
  {
    unsigned int column, ring; ///< ring: of the whole bore
  };
  std::array<Place, 4> place;
  ClosedPlace          carried{};
};

/// What a strip of the ring's outside moves under one newton at a node of the cylinder, m/N.
double through_wall(const Closed &outside, const ClosedPlace &strip, const InBore &node)
{
  const ClosedWindow &window = *outside.window;
  double              sum    = 0.;
  for (unsigned int k = 0; k < 4; ++k)
    sum += node.carried.weight[k] *
           outside.strips()
               ->through[(std::size_t(strip.place) * window.n_columns + node.place[k].column) *
                             window.n_rings_of_through +
                         node.place[k].ring];
  return sum;
}

/// Hold::of_rim of strips on the rim @p modes, which these rows are of: [mode][cosine, sine], and
/// @p solved with the flexibility.
double of_rim(const reduction::RimModes              &modes,
              const std::vector<std::vector<double>> &rows,
              const std::vector<std::vector<double>> &solved)
{
  const auto times = [&](const unsigned int i, const unsigned int j) {
    double sum = 0.;
    for (std::size_t a = 0; a < rows[i].size(); ++a)
      sum += rows[i][a] * solved[j][a];
    return sum;
  };
  double most = 0.;
  for (unsigned int k = 0; 2 * k <= modes.teeth; ++k)
    {
      std::vector<unsigned int> with; // so many waves
      for (unsigned int m = 0; m < modes.n_modes(); ++m)
        if (modes.waves[m] == k)
          with.push_back(m);
      // Of the displacements c + i s in terms of the modes, a complex matrix: as a real one. Pairs
      // of modes are there twice.
      const auto   n    = static_cast<unsigned int>(with.size());
      const bool   real = k == 0 || 2 * k == modes.teeth;
      const double unit = (real ? 1. : 0.25) * modes.teeth;
      Matrix       matrix(2 * n, 2 * n);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          {
            const unsigned int a = 2 * with[i], b = 2 * with[j];
            matrix(i, j) = matrix(n + i, n + j) = unit * (times(a, b) + times(a + 1, b + 1));
            matrix(n + i, j)                    = unit * (times(a, b + 1) - times(a + 1, b));
            matrix(j, n + i)                    = matrix(n + i, j);
          }
      if (n > 0)
        most = std::max(most, largest(matrix));
    }
  return most;
}

/// Adds the squares of @p rows times @p factor to a symmetric @p matrix.
void add_square(const std::vector<double> &row, const double factor, Matrix &matrix)
{
  for (unsigned int i = 0; i < row.size(); ++i)
    {
      const double times = factor * row[i];
      if (times != 0.)
        for (unsigned int j = 0; j < row.size(); ++j)
          matrix(i, j) += times * row[j];
    }
}
} // namespace

std::vector<unsigned int> Closed::columns() const
{
  std::vector<unsigned int> found;
  for (unsigned int c = 0; c < window->n_columns; ++c)
    {
      const double from_middle = std::abs(std::remainder(
          2. * PI * (double(c) / window->n_columns - double(number) / n_directions), 2. * PI));
      if (from_middle <= window->half_angle + PI / window->n_columns)
        found.push_back(c);
    }
  return found;
}

Hold held_by(const ModalGroup &bodies, const std::vector<Closed> &closed)
{
  const std::vector<ClosedPlace> places  = places_of(closed);
  const auto                     n       = static_cast<unsigned int>(places.size());
  const auto                     motions = static_cast<unsigned int>(bodies.motions_of(0).size());
  Hold                           hold{Matrix(motions, motions), Matrix(motions, motions)};
  for (const Closed &window : closed)
    if (window.strips() == nullptr)
      hold.nodes = window.window;
  if (n == 0)
    return hold;
  dealii::LAPACKFullMatrix<double> flexibility(n, n);
  dealii::LAPACKFullMatrix<double> held(n, motions + 2); // and strips by a shift in the plane
  Matrix                           rows(n, motions);
  // by square roots of springs: of nodes, and of strips, which share one
  Matrix                     across(2 * n, motions), in_strips(2 * closed.size(), motions);
  const dealii::Tensor<1, 3> axis = dealii::Point<3>(0., 0., 1.);
  for (unsigned int a = 0; a < n; ++a)
    {
      const dealii::Tensor<1, 3> normal = dealii::Point<3>(
                                     std::cos(places[a].angle), std::sin(places[a].angle), 0.),
                                 round = cross_product_3d(axis, normal);
      const unsigned int one           = 2 * places[a].closed;
      const double       root          = std::sqrt(places[a].across),
                   of_one =
                       places[a].shared * std::sqrt(closed[places[a].closed].window->across_middle);
      const Motions moved = places[a].moved(bodies);
      for (unsigned int j = 0; j < motions; ++j)
        {
          rows(a, j)           = normal * moved[j];
          across(2 * a, j)     = root * (round * moved[j]);
          across(2 * a + 1, j) = root * (axis * moved[j]);
          in_strips(one, j) += of_one * (round * moved[j]);
          in_strips(one + 1, j) += of_one * (axis * moved[j]);
        }
      for (unsigned int j = 0; j < motions; ++j)
        held(a, j) = rows(a, j);
      for (unsigned int d = 0; d < 2 && closed[places[a].closed].strips() != nullptr; ++d)
        held(a, motions + d) = normal[d];
      for (unsigned int b = 0; b < n; ++b)
        flexibility(a, b) = flexibility_of(closed, places[a], places[b]);
    }
  flexibility.set_property(dealii::LAPACKSupport::symmetric);
  flexibility.compute_cholesky_factorization();
  flexibility.solve(held);
  for (unsigned int a = 0; a < n; ++a)
    {
      for (unsigned int i = 0; i < motions; ++i)
        for (unsigned int j = 0; j < motions; ++j)
          hold.matrix(i, j) += rows(a, i) * held(a, j);
      if (closed[places[a].closed].strips() != nullptr)
        hold.stiffness += std::cos(places[a].angle) * held(a, motions) +
                          std::sin(places[a].angle) * held(a, motions + 1);
    }
  for (unsigned int i = 0; i < closed.size(); ++i)
    if (const reduction::RimModes *rim = closed[i].window->rim;
        rim != nullptr && closed[i].strips() != nullptr)
      {
        // flexibility has its factors now; other places do not move with the rim
        const ClosedStrips              &strips = *closed[i].strips();
        std::vector<std::vector<double>> of_modes;
        dealii::LAPACKFullMatrix<double> solved(n, 2 * rim->n_modes());
        for (unsigned int m = 0; m < rim->n_modes(); ++m)
          for (const std::vector<double> *numbers : {&strips.rim_cosine, &strips.rim_sine})
            {
              of_modes.emplace_back(n, 0.);
              for (unsigned int a = 0; a < n; ++a)
                if (places[a].closed == i)
                  of_modes.back()[a] =
                      (*numbers)[std::size_t(m) * strips.places.size() + places[a].place];
              for (unsigned int a = 0; a < n; ++a)
                solved(a, of_modes.size() - 1) = of_modes.back()[a];
            }
        flexibility.solve(solved);
        std::vector<std::vector<double>> held_modes;
        for (unsigned int c = 0; c < of_modes.size(); ++c)
          {
            held_modes.emplace_back(n);
            for (unsigned int a = 0; a < n; ++a)
              held_modes.back()[a] = solved(a, c);
          }
        hold.of_rim = std::max(hold.of_rim, of_rim(*rim, of_modes, held_modes));
      }
  in_strips.Tmmult(hold.matrix, in_strips, true);
  across.Tmmult(hold.across, across);
  for (const Closed &window : closed)
    if (window.strips() != nullptr)
      hold.stiffness += window.window->across_middle;
  return hold;
}
Matrix held_together(const Ringed &bodies, const unsigned int direction, const RingWay &way)
{
  const ClosedWindow            &cylinder = *bodies.cylinder;
  const bool                     outside  = way.outside.window != nullptr;
  const std::vector<ClosedPlace> strips   = outside ? places_of({way.outside}) :
                                                      std::vector<ClosedPlace>(),
                                 nodes    = places_of({{&cylinder, direction}});
  const double turn     = 2. * PI / n_directions * (double(direction) - way.direction);
  const auto   n_strips = static_cast<unsigned int>(strips.size()),
             n          = n_strips + static_cast<unsigned int>(nodes.size()),
             n_ring     = static_cast<unsigned int>(bodies.ring->motions_of(0).size()),
             motions    = n_ring + static_cast<unsigned int>(bodies.link->motions_of(0).size());

  Matrix                           held(motions, motions);
  dealii::LAPACKFullMatrix<double> flexibility(n, n), solved(n, motions);
  Matrix                           rows(n, motions);
  std::vector<double>              in_strips(motions), along(motions);
  for (unsigned int a = 0; a < n_strips; ++a)
    {
      const Directions to(strips[a].angle);
      const Motions    moved = strips[a].moved(*bodies.ring);
      for (unsigned int j = 0; j < n_ring; ++j)
        {
          rows(a, j) = to.normal * moved[j];
          in_strips[j] += strips[a].shared * (to.round * moved[j]);
          along[j] += strips[a].shared * (to.axis * moved[j]);
        }
      for (unsigned int b = 0; b < n_strips; ++b)
        flexibility(a, b) = flexibility_of({way.outside}, strips[a], strips[b]);
    }
  if (outside)
    {
      add_square(in_strips, way.outside.window->across_middle, held);
      add_square(along, way.outside.window->across_middle, held);
    }
  const unsigned int n_columns = cylinder.n_columns;
  for (unsigned int a = 0; a < nodes.size(); ++a)
    {
      const Directions to(nodes[a].angle), in_ring(nodes[a].angle - turn);
      const InBore     bore(bodies, nodes[a], nodes[a].angle - turn);
      const Motions    of_ring = bore.carried.moved(*bodies.ring),
                    of_link    = nodes[a].moved(*bodies.link);
      std::vector<double> round(motions), axial(motions);
      for (unsigned int j = 0; j < motions; ++j)
        {
          const bool                  is_of_ring = j < n_ring;
          const Directions           &d          = is_of_ring ? in_ring : to;
          const dealii::Tensor<1, 3> &moved      = is_of_ring ? of_ring[j] : of_link[j - n_ring];
          const double                sign       = is_of_ring ? 1. : -1.;
          rows(n_strips + a, j)                  = sign * (d.normal * moved);
          round[j]                               = sign * (d.round * moved);
          axial[j]                               = sign * (d.axis * moved);
        }
      add_square(round, nodes[a].across, held);
      add_square(axial, nodes[a].across, held);
      for (unsigned int b = 0; b < nodes.size(); ++b)
        flexibility(n_strips + a, n_strips + b) =
            cylinder.joint->at(nodes[a].place / n_columns,
                               nodes[b].place / n_columns,
                               n_columns + nodes[b].place % n_columns - nodes[a].place % n_columns);
      for (unsigned int b = 0; b < n_strips; ++b)
        flexibility(n_strips + a, b) = flexibility(b, n_strips + a) =
            through_wall(way.outside, strips[b], bore);
    }
  for (unsigned int a = 0; a < n; ++a)
    for (unsigned int j = 0; j < motions; ++j)
      solved(a, j) = rows(a, j);
  flexibility.set_property(dealii::LAPACKSupport::symmetric);
  flexibility.compute_cholesky_factorization();
  flexibility.solve(solved);
  for (unsigned int a = 0; a < n; ++a)
    for (unsigned int i = 0; i < motions; ++i)
      for (unsigned int j = 0; j < motions; ++j)
        held(i, j) += rows(a, i) * solved(a, j);
  return held;
}
} // namespace chaindrive::stability
