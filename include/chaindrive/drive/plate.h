// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/chain.h>
#include <chaindrive/drive/outline.h>

namespace chaindrive::drive
{
/// A figure-eight side plate in its own plane: x runs from hole to hole, the origin is midway. Two
/// end circles about the holes are joined by concave waist arcs tangent to both; without a waist
/// the plate is an obround. Lengths in m.
struct Plate
{
  double hole_pitch;
  double hole_diameter;
  double height; ///< diameter of the end circles
  double waist;  ///< height at mid-pitch
  double thickness;

  bool has_waist() const { return waist < (1. - 1e-9) * height; }

  /// Radius of the waist arcs, whose centres are (0, +-(waist / 2 + waist_radius)).
  /// r_w = ((p/2)^2 + (w/2)^2 - (h/2)^2) / (h - w)
  double waist_radius() const;

  /// Polar angle, about the hole at positive x and from the direction of negative x, at which the
  /// end circle passes into the waist arc. [rad] Pi/2 without a waist.
  double tangency_angle() const;

  /// Half of the height of the outline at @p x.
  double half_height(double x) const;

  /// Height of material at @p x: the outline less the hole.
  double net_height(double x) const;

  /// The outline, counter-clockwise from the outermost point at positive x.
  std::vector<Segment> outline() const;

  /// Area without the holes. [m2]
  double area() const;

  /// Second moments of that area, int y^2 dA and int x^2 dA. [m4]
  double moment_about_x() const;
  double moment_about_y() const;
};

/// Plates of inner links have holes of the bush's diameter, those of outer links of the pin's.
Plate inner_plate(const ChainDimensions &chain);
Plate outer_plate(const ChainDimensions &chain);
} // namespace chaindrive::drive
