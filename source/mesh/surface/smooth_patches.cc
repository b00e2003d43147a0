// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/surface/smooth_patches.h>

#include <chaindrive/utilities/errors.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace chaindrive::mesh
{
using dealii::Point;
using dealii::Tensor;

namespace
{
Tensor<1, 3> unit(const Tensor<1, 3> &a) { return a / a.norm(); }

/// Tangent at b of the circle through a, b and c.
Tensor<1, 3> circle_tangent(const Point<3> &a, const Point<3> &b, const Point<3> &c)
{
  const Tensor<1, 3> first = b - a, second = c - b;
  return unit(first / first.norm_square() + second / second.norm_square());
}

/// Tangent at one end of an arc from the tangent at its other end; @p chord is a unit vector.
Tensor<1, 3> other_end(const Tensor<1, 3> &tangent, const Tensor<1, 3> &chord)
{
  return 2. * (tangent * chord) * chord - tangent;
}

/// Quadrilaterals with their vertices split along sharp edges: what is left is smooth everywhere.
class SmoothNet
{
public:
  SmoothNet(const std::vector<Point<3>>                    &vertices,
            const std::vector<std::array<unsigned int, 4>> &quads,
            double                                          crease_angle);

  std::vector<CoonsPatch> patches() const;

private:
  static constexpr unsigned int none = dealii::numbers::invalid_unsigned_int;

  /// An edge at a node: its other end and the one or two facets that it belongs to.
  struct Spoke
  {
    unsigned int                node;
    std::array<unsigned int, 2> facets = {{none, none}};
    Tensor<1, 3>                tangent; ///< unit, from the node along the edge
  };
  struct Node
  {
    Point<3>           x;
    std::vector<Spoke> spokes;
    Tensor<1, 3>       normal;
  };
  /// What lies beyond edge e of a facet.
  struct Side
  {
    unsigned int neighbour = none;
    bool         crease    = false;
  };

  void find_neighbours(double crease_angle);
  void split_nodes(const std::vector<Point<3>> &vertices);
  void add_spoke(unsigned int from, unsigned int to, unsigned int facet);
  void find_tangents(unsigned int node);

  const Spoke &spoke(unsigned int from, unsigned int to) const;
  Tensor<1, 3> inward(unsigned int facet, const Point<3> &on_edge, const Tensor<1, 3> &along) const;
  unsigned int beyond(unsigned int from, unsigned int at) const;
  Tensor<1, 3> line_tangent(unsigned int at, unsigned int to) const;

  std::vector<std::array<unsigned int, 4>> facets_; ///< by nodes
  std::vector<std::array<Side, 4>>         sides_;
  std::vector<Tensor<1, 3>>                facet_normals_;
  std::vector<Node>                        nodes_;

  const std::vector<std::array<unsigned int, 4>> &quads_;
  std::vector<bool>                               on_rim_; ///< vertices where the surface ends
};

SmoothNet::SmoothNet(const std::vector<Point<3>>                    &vertices,
                     const std::vector<std::array<unsigned int, 4>> &quads,
                     const double                                    crease_angle)
    : quads_(quads), on_rim_(vertices.size(), false)
{
  for (const auto &q : quads)
    facet_normals_.push_back(unit(dealii::cross_product_3d(vertices[q[2]] - vertices[q[0]],
                                                           vertices[q[3]] - vertices[q[1]])));
  find_neighbours(crease_angle);
  split_nodes(vertices);
  for (unsigned int n = 0; n < nodes_.size(); ++n)
    find_tangents(n);
}

void SmoothNet::find_neighbours(const double crease_angle)
{
  sides_.resize(quads_.size());
  std::map<std::pair<unsigned int, unsigned int>, std::vector<std::array<unsigned int, 2>>> edges;
  for (unsigned int f = 0; f < quads_.size(); ++f)
    for (unsigned int e = 0; e < 4; ++e)
      edges[std::minmax(quads_[f][e], quads_[f][(e + 1) % 4])].push_back({{f, e}});
  for (const auto &[ends, users] : edges)
    {
      if (users.size() > 2)
        throw InputError("A contact surface has an edge that more than two of its faces share.");
      if (users.size() == 2)
        {
          const auto &[f, e] = users[0];
          const auto &[g, d] = users[1];
          const bool crease  = facet_normals_[f] * facet_normals_[g] < std::cos(crease_angle);
          sides_[f][e]       = {g, crease};
          sides_[g][d]       = {f, crease};
        }
      else
        on_rim_[ends.first] = on_rim_[ends.second] = true;
    }
}

void SmoothNet::split_nodes(const std::vector<Point<3>> &vertices)
{
  // corners of facets that meet in a vertex are one node if smooth edges lead from one to another
  std::vector<unsigned int> root(4 * quads_.size());
  std::iota(root.begin(), root.end(), 0u);
  const auto find = [&root](unsigned int c) {
    while (root[c] != c)
      c = root[c] = root[root[c]];
    return c;
  };
  for (unsigned int f = 0; f < quads_.size(); ++f)
    for (unsigned int e = 0; e < 4; ++e)
      if (sides_[f][e].neighbour != none && !sides_[f][e].crease)
        for (const unsigned int mine : {e, (e + 1) % 4})
          for (unsigned int other = 0; other < 4; ++other)
            if (quads_[sides_[f][e].neighbour][other] == quads_[f][mine])
              root[find(4 * f + mine)] = find(4 * sides_[f][e].neighbour + other);

  std::vector<unsigned int> number(root.size(), none);
  facets_.resize(quads_.size());
  for (unsigned int f = 0; f < quads_.size(); ++f)
    for (unsigned int c = 0; c < 4; ++c)
      {
        unsigned int &n = number[find(4 * f + c)];
        if (n == none)
          {
            n = static_cast<unsigned int>(nodes_.size());
            nodes_.push_back({vertices[quads_[f][c]], {}, Tensor<1, 3>()});
          }
        facets_[f][c] = n;
      }
  for (unsigned int f = 0; f < facets_.size(); ++f)
    for (unsigned int e = 0; e < 4; ++e)
      {
        add_spoke(facets_[f][e], facets_[f][(e + 1) % 4], f);
        add_spoke(facets_[f][(e + 1) % 4], facets_[f][e], f);
      }
}

void SmoothNet::add_spoke(const unsigned int from, const unsigned int to, const unsigned int facet)
{
  for (Spoke &s : nodes_[from].spokes)
    if (s.node == to)
      {
        s.facets[1] = facet;
        return;
      }
  nodes_[from].spokes.push_back({to, {{facet, none}}, Tensor<1, 3>()});
}

const SmoothNet::Spoke &SmoothNet::spoke(const unsigned int from, const unsigned int to) const
{
  const auto &spokes = nodes_[from].spokes;
  return *std::find_if(spokes.begin(), spokes.end(), [to](const Spoke &s) { return s.node == to; });
}

/// The node that follows on the line of edges from @p from through @p at: across the only edge that
/// has no facet in common with the one we come along. `none` if the net is irregular or ends there.
unsigned int SmoothNet::beyond(const unsigned int from, const unsigned int at) const
{
  const auto  &mine   = spoke(at, from).facets;
  unsigned int result = none;
  for (const Spoke &s : nodes_[at].spokes)
    {
      bool common = s.node == from;
      for (const unsigned int f : s.facets)
        common = common || (f != none && (f == mine[0] || f == mine[1]));
      if (!common)
        {
          if (result != none)
            return none;
          result = s.node;
        }
    }
  return result;
}

/// Unit tangent of the line of edges through @p at, in the direction of its neighbour @p to.
Tensor<1, 3> SmoothNet::line_tangent(const unsigned int at, const unsigned int to) const
{
  const Point<3>             &x      = nodes_[at].x;
  const unsigned int          before = beyond(to, at);
  std::optional<Tensor<1, 3>> middle, ahead, behind;
  if (before != none)
    middle = circle_tangent(nodes_[before].x, x, nodes_[to].x);
  if (const unsigned int next = beyond(at, to); next != none && next != before)
    ahead = other_end(circle_tangent(x, nodes_[to].x, nodes_[next].x), unit(nodes_[to].x - x));
  if (before != none)
    if (const unsigned int last = beyond(at, before); last != none && last != to)
      behind = other_end(circle_tangent(nodes_[last].x, nodes_[before].x, x),
                         unit(x - nodes_[before].x));

  if (middle && ahead && behind)
    {
      // the median is the one with the least sum of distances to the others
      const double m_a = (*middle - *ahead).norm(), m_b = (*middle - *behind).norm(),
                   a_b = (*ahead - *behind).norm();
      if (m_a + m_b <= a_b + std::min(m_a, m_b))
        return *middle;
      return m_a < m_b ? *ahead : *behind;
    }
  if (middle)
    return *middle;
  if (ahead)
    return *ahead;
  return unit(nodes_[to].x - x);
}

void SmoothNet::find_tangents(const unsigned int n)
{
  Node &node = nodes_[n];

  Tensor<1, 3> mean; // Max's weights
  for (unsigned int i = 0; i < node.spokes.size(); ++i)
    for (unsigned int j = i + 1; j < node.spokes.size(); ++j)
      for (const unsigned int f : node.spokes[i].facets)
        if (f != none && (f == node.spokes[j].facets[0] || f == node.spokes[j].facets[1]))
          {
            const Tensor<1, 3> a = nodes_[node.spokes[i].node].x - node.x,
                               b = nodes_[node.spokes[j].node].x - node.x;
            Tensor<1, 3> c = dealii::cross_product_3d(a, b) / (a.norm_square() * b.norm_square());
            mean += c * facet_normals_[f] < 0. ? -1. * c : c;
          }

  // Two lines of edges that cross here span the tangent plane.
  std::vector<Tensor<1, 3>> lines;
  std::vector<unsigned int> done;
  for (const Spoke &s : node.spokes)
    if (std::find(done.begin(), done.end(), s.node) == done.end())
      {
        lines.push_back(line_tangent(n, s.node));
        done.push_back(beyond(s.node, n));
      }
  node.normal = unit(mean);
  if (lines.size() == 2)
    {
      const Tensor<1, 3> normal = unit(dealii::cross_product_3d(lines[0], lines[1]));
      node.normal               = normal * mean < 0. ? -1. * normal : normal;
    }
  // An edge leaves in the plane of its chord and the normal.
  for (Spoke &s : node.spokes)
    {
      const Tensor<1, 3> chord = nodes_[s.node].x - node.x;
      s.tangent                = unit(chord - (chord * node.normal) * node.normal);
    }
}

/// Unit vector from an edge through @p on_edge in the direction @p along into @p facet.
Tensor<1, 3> SmoothNet::inward(const unsigned int  facet,
                               const Point<3>     &on_edge,
                               const Tensor<1, 3> &along) const
{
  Tensor<1, 3> in;
  for (const unsigned int n : facets_[facet])
    in += nodes_[n].x - on_edge;
  return unit(in - (in * along) * along);
}

std::vector<CoonsPatch> SmoothNet::patches() const
{
  std::vector<CoonsPatch> patches;
  patches.reserve(facets_.size());
  for (unsigned int f = 0; f < facets_.size(); ++f)
    {
      std::array<Ray, 4>              corners;
      std::array<CoonsPatch::Edge, 4> edges;
      for (unsigned int e = 0; e < 4; ++e)
        {
          const unsigned int a = facets_[f][e], b = facets_[f][(e + 1) % 4];
          corners[e] = {Tensor<1, 3>(nodes_[a].x), nodes_[a].normal};

          // A cubic that leaves its chord at the angle alpha is nearest to an arc if its derivative
          // there has the length 2 h / (1 + cos alpha); the normal turns with the curvature.
          const Tensor<1, 3> span  = nodes_[b].x - nodes_[a].x;
          const double       h     = span.norm();
          const Tensor<1, 3> chord = span / h;
          const Tensor<1, 3> start = spoke(a, b).tangent, end = -1. * spoke(b, a).tangent;
          const double       curvature = (nodes_[b].normal - nodes_[a].normal) * chord / h;
          edges[e].first.x             = 2. * h / (1. + start * chord) * start;
          edges[e].last.x              = 2. * h / (1. + end * chord) * end;
          edges[e].first.n             = curvature * edges[e].first.x;
          edges[e].last.n              = curvature * edges[e].last.x;

          const Side &side     = sides_[f][e];
          edges[e].open        = side.neighbour == none;
          edges[e].ends_on_rim = {{on_rim_[quads_[f][e]], on_rim_[quads_[f][(e + 1) % 4]]}};
          edges[e].crease      = side.crease;
          if (side.crease)
            {
              edges[e].outward = unit(facet_normals_[f] + facet_normals_[side.neighbour]);
              edges[e].inward  = {
                   {inward(f, nodes_[a].x, chord), inward(side.neighbour, nodes_[a].x, chord)}};
            }
        }
      patches.emplace_back(corners, edges);
    }
  return patches;
}
} // namespace

std::vector<CoonsPatch> smooth_patches(const std::vector<Point<3>>                    &vertices,
                                       const std::vector<std::array<unsigned int, 4>> &quads,
                                       const double                                    crease_angle)
{
  return SmoothNet(vertices, quads, crease_angle).patches();
}
} // namespace chaindrive::mesh
