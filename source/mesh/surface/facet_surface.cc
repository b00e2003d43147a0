// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/surface/facet_surface.h>

#include <chaindrive/mesh/surface/smooth_patches.h>
#include <chaindrive/utilities/errors.h>

#include <boost/container/small_vector.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <cmath>

namespace chaindrive::mesh
{
using dealii::Point;
using dealii::Tensor;

namespace
{
/// The faces of @p part with the boundary id @p surface, counter-clockwise seen from outside.
std::vector<std::array<unsigned int, 4>> boundary_quads(const Part &part, const Surface surface)
{
  std::vector<std::array<unsigned int, 4>> quads;
  for (const auto &cell : part.mesh->active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary() && face->boundary_id() == surface)
        {
          std::array<unsigned int, 4> q = {{face->vertex_index(0),
                                            face->vertex_index(1),
                                            face->vertex_index(3),
                                            face->vertex_index(2)}};
          const Tensor<1, 3> normal = dealii::cross_product_3d(face->vertex(3) - face->vertex(0),
                                                               face->vertex(2) - face->vertex(1));
          if (normal * (face->center() - cell->center()) < 0.)
            std::swap(q[1], q[3]);
          quads.push_back(q);
        }
  if (quads.empty())
    throw InputError("The mesh of the " + part.name + " has no surface named '" +
                     surface_name(surface) + "'.");
  return quads;
}

Projection make_projection(const CoonsPatch::Projection &projection, const unsigned int facet)
{
  Projection result;
  result.found    = true;
  result.distance = projection.distance;
  result.point    = Point<3>(projection.ray.x);
  result.normal   = projection.ray.n;
  result.facet    = facet;
  const double u = projection.u, v = projection.v;
  result.weights = {{(1. - u) * (1. - v), u * (1. - v), u * v, (1. - u) * v}};
  return result;
}

/// Distances from @p p [m] that differ by less are the same but for round-off, m.
double same_distance(const Point<3> &p) { return 1e-12 * p.norm(); }

/// Whether a point of @p facet at @p distance is nearer to @p p than @p best. Above an edge that
/// two facets share, where round-off would decide, it is the one in which the point was, @p hint,
/// and else that of the smaller number.
bool nearer(const double       distance,
            const unsigned int facet,
            const Point<3>    &p,
            const Projection  &best,
            const unsigned int hint)
{
  const double difference = std::abs(distance) - std::abs(best.distance);
  if (!best.found || std::abs(difference) > same_distance(p))
    return difference < 0.;
  return best.facet != hint && (facet == hint || facet < best.facet);
}

/// Looks for the nearest point of one facet and keeps it in @p best if it is nearer than that.
void search_facet(const CoonsPatch  &patch,
                  const unsigned int facet,
                  const Point<3>    &p,
                  const unsigned int hint,
                  Projection        &best)
{
  const CoonsPatch::Projection projection = patch.project(p);
  bool                         inside     = projection.inside;
  if (!inside)
    {
      bool open = false;
      for (unsigned int e = 0; e < 4; ++e)
        {
          const CoonsPatch::Edge &edge = patch.edge(e);
          if (edge.crease)
            {
              const CoonsPatch::Projection on_edge = patch.project_on_edge(p, e);
              if (on_edge.inside && nearer(on_edge.distance, facet, p, best, hint))
                best = make_projection(on_edge, facet);
            }
          const bool here = (e == 0 && projection.v == 0.) || (e == 1 && projection.u == 1.) ||
                            (e == 2 && projection.v == 1.) || (e == 3 && projection.u == 0.);
          open = open || (here && edge.open);
        }
      // a point that round-off drops between two facets, or any at the centre of an arc
      inside = !open && projection.obliquity < 1e-6 * std::abs(projection.distance);
    }
  if (inside && nearer(projection.distance, facet, p, best, hint))
    best = make_projection(projection, facet);
}
} // namespace

FacetSurface::FacetSurface(const Part &part, const Surface surface, const double crease_angle)
    : FacetSurface(part.mesh->get_vertices(), boundary_quads(part, surface), crease_angle)
{
}

FacetSurface::FacetSurface(const std::vector<Point<3>>                    &vertices,
                           const std::vector<std::array<unsigned int, 4>> &quads,
                           const double                                    crease_angle)
    : quads_(quads), patches_(smooth_patches(vertices, quads, crease_angle))
{
  std::vector<std::pair<dealii::BoundingBox<3>, unsigned int>> boxes;
  boxes.reserve(patches_.size());
  for (unsigned int f = 0; f < patches_.size(); ++f)
    boxes.emplace_back(patches_[f].bounding_box(), f);
  tree_ = dealii::pack_rtree(boxes);
}

Projection FacetSurface::closest_point(const Point<3>    &p,
                                       const double       search_radius,
                                       const unsigned int hint) const
{
  Projection best;
  if (hint < n_facets())
    search_facet(patches_[hint], hint, p, hint, best);

  // facets whose boxes are near, nearest first, until the next box is farther than what was found
  const double   reach = std::min(search_radius, std::abs(best.distance));
  const Point<3> margin(reach, reach, reach);
  boost::container::small_vector<std::pair<double, unsigned int>, 256> near;
  tree_.query(boost::geometry::index::intersects(
                  dealii::BoundingBox<3>({p - Tensor<1, 3>(margin), p + Tensor<1, 3>(margin)})),
              boost::make_function_output_iterator([&](const auto &entry) {
                const double bound = patches_[entry.second].distance_bound(p);
                if (bound <= reach && entry.second != hint)
                  near.emplace_back(bound, entry.second);
              }));
  std::sort(near.begin(), near.end());
  for (const auto &[bound, facet] : near)
    {
      if (bound > std::abs(best.distance) + same_distance(p))
        break;
      search_facet(patches_[facet], facet, p, hint, best);
    }
  return std::abs(best.distance) <= search_radius ? best : Projection();
}

std::array<Tensor<1, 3>, 4> FacetSurface::gradients(const Projection &at) const
{
  const double u = at.weights[1] + at.weights[2], v = at.weights[2] + at.weights[3];
  Ray          s, s_u, s_v;
  patches_[at.facet].evaluate(u, v, s, s_u, s_v);

  // dual to the tangents; where the point is held on a crease, the parameter across does not change
  const auto held = [&](const unsigned int e, const double across) {
    return patches_[at.facet].edge(e).crease && std::abs(across) < 1e-12;
  };
  const bool         on_u = !held(1, u - 1.) && !held(3, u), on_v = !held(0, v) && !held(2, v - 1.);
  const double       uu = s_u.x * s_u.x, uv = on_u && on_v ? s_u.x * s_v.x : 0., vv = s_v.x * s_v.x;
  const double       det    = uu * vv - uv * uv;
  const Tensor<1, 3> grad_u = on_u ? (vv * s_u.x - uv * s_v.x) / det : Tensor<1, 3>(),
                     grad_v = on_v ? (uu * s_v.x - uv * s_u.x) / det : Tensor<1, 3>();
  return {{-(1. - v) * grad_u - (1. - u) * grad_v,
           (1. - v) * grad_u - u * grad_v,
           v * grad_u + u * grad_v,
           -v * grad_u + (1. - u) * grad_v}};
}
} // namespace chaindrive::mesh
