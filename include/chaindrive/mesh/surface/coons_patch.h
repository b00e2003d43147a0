// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>

namespace chaindrive::mesh
{
/// A point of a surface and its normal (not of unit length inside a patch), or derivatives of both.
struct Ray
{
  dealii::Tensor<1, 3> x, n;
};

/// A quadrilateral with curved edges, x(u, v) and n(u, v) for 0 <= u, v <= 1: the bilinearly
/// blended Coons patch of four cubic edges (Farin, Curves and Surfaces for CAGD, ch. 22).
///
/// Corners are numbered counter-clockwise from (0, 0); edge e runs from corner e to corner e + 1,
/// so that edges 0 and 2 run along u and edges 1 and 3 along v.
class CoonsPatch
{
public:
  struct Edge
  {
    Ray                  first, last;    ///< derivatives at corners e and e + 1, from e to e + 1
    bool                 open   = false; ///< the surface ends here
    bool                 crease = false; ///< the surface has a sharp edge here
    std::array<bool, 2>  ends_on_rim{};  ///< of a crease: the surface ends at corner e or e + 1
    dealii::Tensor<1, 3> outward;        ///< of a crease: between the normals of its two sides
    std::array<dealii::Tensor<1, 3>, 2> inward; ///< of a crease: unit, from it into its two sides
  };

  CoonsPatch(const std::array<Ray, 4> &corners, const std::array<Edge, 4> &edges);

  /// Where p = x(u, v) + d n(u, v), with the unit normal in @p ray.n and the signed distance.
  struct Projection
  {
    double u, v;
    Ray    ray;
    double distance;
    bool   inside;    ///< 0 <= u, v <= 1 but for round-off
    double obliquity; ///< |tangential part of p - x| at (u, v) moved into the patch, m
  };

  Projection project(const dealii::Point<3> &p) const;

  /// The nearest point of the sharp edge @p e and the signed distance from it; ray.n points from
  /// the edge to @p p, or from p to the edge if p is inside the body.
  Projection project_on_edge(const dealii::Point<3> &p, unsigned int e) const;

  /// Lower bound of the distance from @p p to the patch, from a box around it in its own axes.
  double distance_bound(const dealii::Point<3> &p) const;

  dealii::BoundingBox<3> bounding_box() const;

  const Edge &edge(const unsigned int e) const { return edges_[e]; }

  /// x, n and their derivatives with respect to u and v.
  void evaluate(double u, double v, Ray &s, Ray &s_u, Ray &s_v) const;

private:
  /// Cubic edge @p e and its derivative at 0 <= t <= 1 from corner e to corner e + 1.
  void evaluate_edge(unsigned int e, double t, Ray &c, Ray &c_t) const;

  std::array<Ray, 4>                  corners_;
  std::array<Edge, 4>                 edges_;
  std::array<Ray, 3>                  middle_; ///< x and n at u = v = 1/2 and their derivatives
  dealii::Point<3>                    centre_; ///< of the box that holds the patch
  std::array<dealii::Tensor<1, 3>, 3> axes_;   ///< of that box
  std::array<double, 3>               half_;   ///< half of its sides, m
  double                              size_;   ///< length of the longer diagonal, m
};
} // namespace chaindrive::mesh
