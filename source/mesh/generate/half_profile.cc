// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/generate/half_profile.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::mesh
{
using dealii::Point;
using dealii::Tensor;
using dealii::numbers::PI;

HalfProfile::HalfProfile(const drive::ToothForm &form) : segments_(form.half_profile)
{
  double s = 0.;
  for (const drive::Segment &segment : segments_)
    ends_.push_back(s += segment.length());
}

const drive::Segment &HalfProfile::find(const double s, double &fraction) const
{
  const std::size_t i = std::min<std::size_t>(
      std::lower_bound(ends_.begin(), ends_.end(), s) - ends_.begin(), ends_.size() - 1);
  const double before = i == 0 ? 0. : ends_[i - 1];
  fraction            = (s - before) / (ends_[i] - before);
  return segments_[i];
}

Point<2> HalfProfile::at(const double s) const
{
  double                fraction;
  const drive::Segment &segment = find(s, fraction);
  return fraction <= 0. ? segment.begin : fraction >= 1. ? segment.end : segment.point(fraction);
}

Tensor<1, 2> HalfProfile::tangent(const double s) const
{
  double                fraction;
  const drive::Segment &segment = find(s, fraction);
  Tensor<1, 2>          t       = segment.end - segment.begin;
  if (segment.kind != drive::Segment::Kind::line)
    {
      const Tensor<1, 2> a     = at(s) - segment.centre;
      const double       sense = segment.end_angle > segment.begin_angle ? 1. : -1.;
      t[0]                     = -sense * a[1];
      t[1]                     = sense * a[0];
    }
  return t / t.norm();
}

double HalfProfile::where_turned_by(const double angle) const
{
  constexpr double snap   = 10. / 180. * PI;
  double           turned = 0., s = 0.;
  for (const drive::Segment &segment : segments_)
    {
      const double subdivided =
          segment.kind == drive::Segment::Kind::line ? 0. : segment.begin_angle - segment.end_angle;
      if (std::abs(turned + subdivided - angle) < snap)
        return s + segment.length();
      if (turned + subdivided > angle)
        return s + (angle - turned) * segment.radius;
      turned += subdivided;
      s += segment.length();
    }
  return ends_.front();
}

std::vector<Point<2>>
HalfProfile::divide(const double first, const double last, const double size) const
{
  std::vector<Point<2>> points = {at(first)};
  double                from   = first;
  for (const double end : ends_)
    {
      const double to = std::min(end, last);
      if (to > from)
        {
          const auto n = std::max(1u, static_cast<unsigned int>(std::lround((to - from) / size)));
          const auto subdivided = divide(from, to, n);
          points.insert(points.end(), subdivided.begin() + 1, subdivided.end());
          from = to;
        }
    }
  return points;
}

std::vector<Point<2>>
HalfProfile::divide(const double first, const double last, const unsigned int n) const
{
  std::vector<Point<2>> points;
  for (unsigned int i = 0; i <= n; ++i)
    points.push_back(at(i == n ? last : first + (last - first) * i / n));
  return points;
}
} // namespace chaindrive::mesh
