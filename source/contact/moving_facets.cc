// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/moving_facets.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace chaindrive::contact
{
using dealii::Tensor;

MovingFacets::MovingFacets(const mesh::Part                                    &part,
                           const mesh::Nodes                                   &nodes,
                           const mesh::Surface                                  surface,
                           const std::function<bool(const dealii::Point<3> &)> &chosen)
{
  std::map<unsigned int, unsigned int>                                           number;
  std::map<std::pair<unsigned int, unsigned int>, std::pair<unsigned, unsigned>> edges;
  for (const auto &cell : part.mesh->active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary() && face->boundary_id() == surface && chosen(face->center()))
        {
          const Tensor<1, 3> normal = dealii::cross_product_3d(face->vertex(3) - face->vertex(0),
                                                               face->vertex(2) - face->vertex(1));
          std::array<unsigned int, 4> corner = {{0, 1, 3, 2}};
          if (normal * (face->center() - cell->center()) < 0.)
            std::swap(corner[1], corner[3]);
          const unsigned int          facet = n_facets();
          std::array<unsigned int, 4> quad;
          for (unsigned int a = 0; a < 4; ++a)
            {
              const unsigned int node = nodes.of_vertex[face->vertex_index(corner[a])];
              const auto [entry, is_new] =
                  number.emplace(node, static_cast<unsigned int>(nodes_.size()));
              if (is_new)
                {
                  nodes_.push_back(node);
                  area_.push_back(0.);
                }
              quad[a] = entry->second;
              area_[quad[a]] += 0.125 * normal.norm();
            }
          quads_.push_back(quad);
          beyond_.push_back({{none, none, none, none}});
          for (unsigned int e = 0; e < 4; ++e)
            {
              const unsigned int a = quad[e], b = quad[(e + 1) % 4];
              const auto [other, is_first] =
                  edges.try_emplace({std::min(a, b), std::max(a, b)}, facet, e);
              if (is_first)
                continue;
              beyond_[facet][e]                                  = other->second.first;
              beyond_[other->second.first][other->second.second] = facet;
            }
        }
}

unsigned int MovingFacets::project_on(const NodeValues   &position,
                                      const Tensor<1, 3> &x,
                                      const unsigned int  facet,
                                      const double        margin,
                                      Projection         &projection) const
{
  projection.facet = facet;
  projection.node  = quads_[facet];
  std::array<Tensor<1, 3>, 4> p;
  for (unsigned int a = 0; a < 4; ++a)
    p[a] = position(projection.node[a]);
  const Tensor<1, 3> twist = p[0] - p[1] + p[2] - p[3];

  // (x - P) . P_u = (x - P) . P_v = 0 by Newton's method
  double       u = 0.5, v = 0.5;
  Tensor<1, 3> a, b, r;
  const auto   look = [&]() {
    a = (1. - v) * (p[1] - p[0]) + v * (p[2] - p[3]);
    b = (1. - u) * (p[3] - p[0]) + u * (p[2] - p[1]);
    r = x - ((1. - u) * ((1. - v) * p[0] + v * p[3]) + u * ((1. - v) * p[1] + v * p[2]));
  };
  look();
  for (unsigned int iteration = 0; iteration < 20; ++iteration)
    {
      const double aa = a * a, bb = b * b, ab = a * b - r * twist;
      const double det = aa * bb - ab * ab, ra = r * a, rb = r * b;
      const double du = (bb * ra - ab * rb) / det, dv = (aa * rb - ab * ra) / det;
      u = std::clamp(u + du, -4., 5.);
      v = std::clamp(v + dv, -4., 5.);
      look();
      if (std::max(std::abs(du), std::abs(dv)) < 1e-14)
        break;
    }

  projection.weight = {{(1. - u) * (1. - v), u * (1. - v), u * v, (1. - u) * v}};
  projection.normal = cross_product_3d(a, b);
  projection.normal /= projection.normal.norm();
  projection.gap        = r * projection.normal;
  const double       aa = a * a, bb = b * b, ab = a * b, det = aa * bb - ab * ab;
  const Tensor<1, 3> grad_u = (bb * a - ab * b) / det, grad_v = (aa * b - ab * a) / det;
  projection.gradient = {{-(1. - v) * grad_u - (1. - u) * grad_v,
                          (1. - v) * grad_u - u * grad_v,
                          v * grad_u + u * grad_v,
                          -v * grad_u + (1. - u) * grad_v}};

  const std::array<double, 4> past = {{-v, u - 1., v - 1., -u}};
  const auto                  most = std::max_element(past.begin(), past.end());
  return *most > margin ? static_cast<unsigned int>(most - past.begin()) : 4;
}

MovingFacets::Projection MovingFacets::project(const NodeValues   &position,
                                               const Tensor<1, 3> &x,
                                               const unsigned int  start) const
{
  constexpr double round_off = 1e-12, rim = 0.1;
  Projection       projection;
  if (start != none)
    {
      unsigned int facet = start;
      for (unsigned int i = 0; i < n_facets(); ++i)
        {
          const unsigned int edge = project_on(position, x, facet, round_off, projection);
          if (edge == 4)
            return projection;
          if (beyond_[facet][edge] == none)
            {
              if (project_on(position, x, facet, rim, projection) == 4)
                return projection;
              break;
            }
          facet = beyond_[facet][edge];
        }
    }
  Projection best;
  double     nearest = 0.;
  for (const double margin : {round_off, rim})
    {
      for (unsigned int facet = 0; facet < n_facets(); ++facet)
        if (project_on(position, x, facet, margin, projection) == 4 &&
            (best.facet == none || std::abs(projection.gap) < nearest))
          {
            best    = projection;
            nearest = std::abs(projection.gap);
          }
      if (best.facet != none)
        break;
    }
  return best;
}

std::vector<std::array<double, 2>> MovingFacets::ranges(const std::vector<double> &values) const
{
  std::vector<std::array<double, 2>> result;
  result.reserve(values.size());
  for (const double value : values)
    result.push_back({{value, value}});
  for (const auto &quad : quads_)
    for (const unsigned int i : quad)
      for (const unsigned int j : quad)
        result[i] = {{std::min(result[i][0], values[j]), std::max(result[i][1], values[j])}};
  return result;
}
} // namespace chaindrive::contact
