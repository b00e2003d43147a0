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
using dealii::Tensor;

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

/// The line of a guide as an obstacle about the origin.
class Line : public path::Obstacle
{
public:
  Line(path::Curve curve, const double radius) : curve_(std::move(curve)), radius_(radius)
  {
    constexpr unsigned int n = 8;
    for (unsigned int i = 0; i <= n * curve_.n_pieces(); ++i)
      reach_ = std::max(reach_, curve_.at(static_cast<double>(i) / n).norm());
    reach_ *= 1.05; // between these points
  }

  double reach() const override { return reach_; }

  /// A plate that is behind the line by more than its radius is on another side of the guide.
  path::Nearest nearest(const Point<2> &p) const override
  {
    unsigned int  hint  = curve_.n_pieces();
    path::Nearest found = curve_.nearest(p, hint);
    if (found.distance < -radius_)
      found.distance = reach_;
    return found;
  }

private:
  path::Curve curve_;
  double      radius_, reach_ = 0.; ///< of plates, m; about the origin, m
};

const std::string of_driver = "Drive/Wheels/driver/Guide/";

/// Refuses what a guide on an arm or a slide cannot be.
void check_pressed(const parameters::Drive &drive)
{
  const parameters::Guide     &given  = drive.sprockets.driver().guide;
  const parameters::Holder     holder = given.held.holder;
  const std::string            entry  = of_driver + "Held by = " + text_of(holder);
  const bool                   arm    = parameters::turns(holder);
  const std::string            limit  = of_driver + (arm ? "Arm/" : "Slide/");
  const parameters::Tensioner &spring = given.held.tensioner();
  if (arm && !given.held.pivot)
    throw InputError(entry + " turns about a pivot; give " + limit + "Pivot in mm.");
  if (!(spring.inertia > 0.))
    throw InputError(entry + " has no inertia; give " + limit +
                     (arm ? "Inertia in kg m2" : "Mass in g") + " above 0.");
  if (spring.preload == 0. && spring.stiffness == 0.)
    throw InputError(
        limit +
        (arm ? "Moment in N m and Stiffness in N m/rad" : "Force in N and Stiffness in N/m") +
        " are both 0, so that nothing presses the guide against the chain; give one.");
  if (spring.least.value_or(-1e9) >= spring.most.value_or(1e9))
    throw InputError(limit + (arm ? "Least angle in degrees must be below Greatest angle in "
                                    "degrees." :
                                    "Least travel in mm must be below Greatest travel in mm."));
  if (const unsigned int wheel = tensioned_wheel(drive.sprockets); wheel > 0)
    throw InputError(entry + " and Drive/Wheels/" + drive.sprockets.list[wheel].name +
                     "/Held by = " + text_of(drive.sprockets.list[wheel].held.holder) +
                     ": one of them takes up the slack; choose nothing, or bearing.");
  const auto from = drive.layout.centre_distance_from;
  if (from == parameters::CentreDistanceFrom::sag ||
      from == parameters::CentreDistanceFrom::pretension)
    throw InputError("Drive/Layout/Centre distance from = " + text_of(from) + " cannot be with " +
                     entry +
                     ", whose spring decides tension and sag; choose given, or slack, "
                     "which is that of the chain beside the guide.");
  if (drive.layout.start == parameters::Start::concentric)
    throw InputError("Drive/Layout/Start = concentric has no contact in its joints, so that the "
                     "chain cannot bear the spring of " +
                     entry + "; choose taut or settled.");
}

Tensor<1, 2> left_of(const Tensor<1, 2> &v)
{
  Tensor<1, 2> result;
  result[0] = 0. - v[1];
  result[1] = v[0];
  return result;
}

/// The normal, outwards, of the line that touches the pitch circles at the ends of the slack span.
Tensor<1, 2> normal_of_slack(const Layout &layout, const std::vector<ToothForm> &forms)
{
  const Tensor<1, 2> line   = layout.sprockets[1].centre - layout.sprockets[0].centre;
  const auto         radius = [&](const unsigned int i) {
    return 0.5 * layout.sprockets[i].turn * forms[i].pitch_diameter;
  };
  const double along = (radius(0) - radius(1)) / line.norm();
  return (along * line - std::sqrt(1. - along * along) * layout.sense * left_of(line)) /
         line.norm();
}

/// How deep the plates of any joint of the slack span are in @p guide at @p travel, m; below zero
/// as far as they are from it.
double depth_at(const Guide &guide, const Layout &layout, const double radius, const double travel)
{
  const Tensioner    &held = *guide.held;
  const Line          line(guide.in_frame(), std::numeric_limits<double>::infinity());
  const Point<2>      frame = held.is_arm() ? held.pivot : held.centre(travel);
  const double        angle = held.is_arm() ? held.sense * travel : 0.;
  const double        c = std::cos(angle), s = std::sin(angle);
  const Layout::Span &span = layout.slack();
  double              most = -std::numeric_limits<double>::infinity();
  for (unsigned int k = 0; k <= span.links; ++k)
    {
      const Tensor<1, 2> arm = layout.joints[(span.first + k) % layout.joints.size()].bush - frame;
      most                   = std::max(
          most,
          radius -
              line.nearest(Point<2>(c * arm[0] + s * arm[1], c * arm[1] - s * arm[0])).distance);
    }
  return most;
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
                               const Layout                 &layout)
{
  const double       half = 0.5 * chain.inner_plate_height;
  const unsigned int n    = static_cast<unsigned int>(layout.joints.size());
  std::vector<Guide> guides;
  for (unsigned int i = 0; i < drive.sprockets.list.size(); ++i)
    {
      const parameters::Guide &given = drive.sprockets.list[i].guide;
      if (given.points.empty() || given.is_sprung())
        continue;
      const std::string section = "Drive/Wheels/" + drive.sprockets.list[i].name + "/Guide/";
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
          unsigned int any = guide.curve.n_pieces();
          const double distance =
              std::abs(guide.curve.nearest(layout.joints[k].bush, any).distance);
          if (half - distance > deepest)
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

path::Curve Guide::in_frame() const
{
  path::Curve moved = curve;
  if (held && held->is_arm())
    moved.move(Point<2>() - held->pivot);
  return moved;
}

std::vector<Point<2>> Guide::polyline(const unsigned int per_piece) const
{
  std::vector<Point<2>> points;
  for (unsigned int i = 0; i <= per_piece * curve.n_pieces(); ++i)
    {
      const Point<2> p = curve.at(static_cast<double>(i) / per_piece);
      points.push_back(!held          ? p :
                       held->is_arm() ? held->turned(p) :
                                        p + held->travel * held->direction);
    }
  return points;
}

std::string Guide::in_words(const double slack, const unsigned int strands) const
{
  return held->in_words("guide", slack, strands, "the middle of its line");
}

std::optional<Guide> make_pressed_guide(const parameters::Drive      &drive,
                                        const ChainDimensions        &chain,
                                        const std::vector<ToothForm> &forms,
                                        const Layout                 &layout,
                                        const double                  gravity)
{
  const parameters::Guide &given = drive.sprockets.driver().guide;
  if (!given.is_sprung())
    return {};
  check_pressed(drive);
  Guide guide{0, line_of(given, of_driver, layout.sense), given.friction, given.stiffness};

  // on which side of the straight span it is, and how far
  const double       half    = 0.5 * chain.inner_plate_height;
  const Tensor<1, 2> normal  = normal_of_slack(layout, forms);
  const double       touches = 0.5 * layout.sprockets[0].turn * forms[0].pitch_diameter;
  const auto         beside  = [&](const Point<2> &p) {
    return normal * (p - layout.sprockets[0].centre) - touches;
  };
  const unsigned int n       = guide.curve.n_pieces();
  const Point<2>     middle  = guide.curve.at(0.5 * n);
  const Tensor<1, 2> towards = (beside(middle) > 0. ? -1. : 1.) * normal;
  double             nearest = std::numeric_limits<double>::infinity();
  for (unsigned int i = 0; i <= 8 * n; ++i)
    nearest = std::min(nearest, -(towards * normal) * beside(guide.curve.at(0.125 * i)));
  if (nearest < half)
    throw InputError(of_driver +
                     "Points in mm: without travel the guide must stand clear of the "
                     "straight slack span, on one side of it, but it comes " +
                     in_mm(nearest, 4) + " near, half the height of a plate being " +
                     in_mm(half, 4) + "; move its points away by " + in_mm(half - nearest, 4) +
                     ", or turn them away from the chain.");
  unsigned int hint = n;
  if (guide.curve.nearest(middle - beside(middle) * normal, hint).distance < 0.)
    guide.curve.reverse();

  // which way it moves
  constexpr double             least_gain = 0.02;
  const parameters::Tensioner &spring     = given.held.tensioner();
  const double                 share      = drive.chain.share();
  Tensioner                    held{};
  held.wheel   = static_cast<unsigned int>(drive.sprockets.list.size());
  held.holder  = given.held.holder;
  held.inertia = share * spring.inertia;
  held.sense   = 1;
  if (held.is_arm())
    {
      held.reference = middle;
      held.pivot     = Point<2>((*given.held.pivot)[0], layout.sense * (*given.held.pivot)[1]);
      if (held.lever() < 1e-3)
        throw InputError(of_driver + "Arm/Pivot in mm must be at least 1 mm from the middle of the "
                                     "guide's line.");
      held.sense = left_of(middle - held.pivot) * towards > 0. ? 1 : -1;
    }
  else
    {
      held.direction[0] = std::cos(given.held.direction);
      held.direction[1] = layout.sense * std::sin(given.held.direction);
      held.direction *= held.direction * towards > 0. ? 1. : -1.;
    }
  if (!(held.way(0.) * towards > least_gain * held.lever()))
    throw InputError(of_driver + "Held by = " + text_of(held.holder) +
                     " moves the guide along the chain, and not against it; choose another " +
                     (held.is_arm() ? "Arm/Pivot in mm." : "Slide/Direction in degrees."));
  held.law = make_law(spring, share, held.lever());
  held.carry(0., gravity);
  guide.held = held;

  // up to the chain as it is laid
  const double farthest = std::min(held.law.most, held.is_arm() ? 1.5 : 0.5);
  double       low = std::max(0., held.law.least), high = low;
  const double step = 0.5e-3 / held.lever();
  while (high < farthest && depth_at(guide, layout, half, high) < 0.)
    {
      low  = high;
      high = std::min(farthest, high + step);
    }
  if (depth_at(guide, layout, half, high) < 0. && farthest < held.law.most)
    throw InputError(of_driver + "Points in mm: the guide does not come to the slack span within " +
                     held.with_unit(farthest) + " of travel; choose other points, or stops.");
  for (unsigned int i = 0; i < 60; ++i)
    (depth_at(guide, layout, half, 0.5 * (low + high)) < 0. ? low : high) = 0.5 * (low + high);
  guide.held->travel = low;
  return guide;
}

RestingGuide resting_guide(Guide &guide, const ChainDimensions &chain)
{
  const double half = 0.5 * chain.inner_plate_height;
  return {std::make_shared<Line>(guide.in_frame(), half), {half, guide.stiffness}, &*guide.held};
}

std::optional<double> tension_of(const Guide &guide, const Layout &layout)
{
  const Tensioner    &held = *guide.held;
  const Layout::Span &span = layout.spans[guide.span];
  if (held.travel >= held.law.most || held.travel <= held.law.least || span.links < 2)
    return {};
  const auto joint = [&](const unsigned int k) {
    return layout.joints[(span.first + k) % layout.joints.size()].bush;
  };
  const Tensor<1, 2> in = joint(1) - joint(0), out = joint(span.links) - joint(span.links - 1);
  const Tensor<1, 2> before = in / in.norm(), behind = out / out.norm();
  // of 1 N of tension, on the travel
  const double back = held.is_arm() ? held.sense * (cross(joint(span.links) - held.pivot, behind) -
                                                    cross(joint(0) - held.pivot, before)) :
                                      held.direction * (behind - before);
  const double push =
      held.law.elastic(held.travel) - held.weight * (held.is_arm() ? 0. : held.direction[1]);
  if (push <= 0. || back >= 0.)
    return {};
  return -push / back;
}
} // namespace chaindrive::drive
