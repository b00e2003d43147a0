// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/guide.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace chaindrive::drive
{
using dealii::Point;

namespace
{
/// The line of @p given, whose section is @p section, mirrored where the drive is.
path::Curve line_of(const parameters::Guide &given, const std::string &section, const int sense)
{
  std::vector<Point<2>> points;
  for (const auto &p : given.points)
    points.emplace_back(p[0], sense * p[1]);
  for (std::size_t i = 1; i < points.size(); ++i)
    if (points[i].distance(points[i - 1]) < 1e-4)
      throw InputError(section + "Points in mm: point " + std::to_string(i + 1) +
                       " is less than 0.1 mm from the one before it.");
  if (given.line == parameters::GuideLine::spline)
    return path::Curve::spline(points);
  if (points.size() != 3)
    throw InputError(section + "Line = arc takes three points; Points in mm has " +
                     std::to_string(points.size()) + ". Choose spline, or three points.");
  const dealii::Tensor<1, 2> a = points[1] - points[0], b = points[2] - points[0];
  if (std::abs(a[0] * b[1] - a[1] * b[0]) < 1e-6 * a.norm() * b.norm())
    throw InputError(section + "Line = arc: the three points lie on a straight line, round which "
                               "there is no circle; choose spline.");
  return path::Curve::arc(points);
}

/// How far @p p is from the line, on whichever side.
double distance_of(const path::Curve &curve, const Point<2> &p)
{
  double least = std::numeric_limits<double>::infinity();
  for (unsigned int piece = 0; piece < curve.n_pieces(); ++piece) // each may have a nearest point
    {
      unsigned int hint = piece;
      least             = std::min(least, std::abs(curve.nearest(p, hint).distance));
    }
  return least;
}
} // namespace

std::vector<Guide> make_guides(const parameters::Drive      &drive,
                               const ChainDimensions        &chain,
                               const std::vector<ToothForm> &forms,
                               const Layout                 &layout,
                               const bool                    has_nodes)
{
  const double       half = 0.5 * chain.inner_plate_height;
  const unsigned int n    = static_cast<unsigned int>(layout.joints.size());
  std::vector<Guide> guides;
  for (unsigned int i = 0; i < drive.sprockets.list.size(); ++i)
    {
      const parameters::Guide &given = drive.sprockets.list[i].guide;
      if (given.points.empty())
        continue;
      const std::string section = "Drive/Wheels/" + drive.sprockets.list[i].name + "/Guide/";
      if (has_nodes)
        throw InputError(section +
                         "Points in mm: guides are for the fidelities simple, layered and reduced; "
                         "choose one of these, or no points.");
      Guide guide{i, line_of(given, section, layout.sense), given.friction, given.stiffness};
      for (unsigned int k = 0; k < forms.size(); ++k)
        {
          const double radius = 0.5 * forms[k].root_diameter;
          const double inside = radius - distance_of(guide.curve, layout.sprockets[k].centre);
          if (inside > 0.)
            throw InputError(section + "Points in mm: the guide would pass through the " +
                             drive.sprockets.list[k].in_words() + ", by " + in_mm(inside, 4) +
                             " within its root circle, whose diameter is " + in_mm(2. * radius, 4) +
                             "; move its points away from there.");
        }
      // the chain is on the side on which the joint of the span is that is nearest to the line
      const Layout::Span &span    = layout.spans[i];
      double              nearest = std::numeric_limits<double>::infinity(), side = 1.;
      unsigned int        hint = guide.curve.n_pieces();
      for (unsigned int k = 0; k <= span.links; ++k)
        {
          const double distance =
              guide.curve.nearest(layout.joints[(span.first + k) % n].bush, hint).distance;
          if (std::abs(distance) < std::abs(nearest))
            {
              nearest = distance;
              side    = distance;
            }
        }
      if (side < 0.)
        guide.curve.reverse();
      double       deepest = 1e-9; // m, that plates may be in it by round-off
      unsigned int joint   = n;
      for (unsigned int k = 0; k < n; ++k)
        {
          unsigned int any      = guide.curve.n_pieces();
          const double distance = guide.curve.nearest(layout.joints[k].bush, any).distance;
          if (half - distance > deepest && distance > -half) // else it is behind the guide
            {
              deepest = half - distance;
              joint   = k;
            }
        }
      if (joint < n)
        throw InputError(section +
                         "Points in mm: at the start plates reach into the guide, those "
                         "of joint " +
                         std::to_string(joint) + " the deepest, by " + in_mm(deepest, 4) +
                         ", half the height of a plate being " + in_mm(half, 4) +
                         "; move its points away from the chain by at least the former.");
      guides.push_back(std::move(guide));
    }
  return guides;
}
} // namespace chaindrive::drive
