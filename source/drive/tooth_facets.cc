// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/tooth_form.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace chaindrive::drive
{
using dealii::Point;
using dealii::Tensor;

namespace
{
/// How many of @p n chords each of @p segments gets.
std::vector<unsigned int> share_out(const std::vector<Segment> &segments, const unsigned int n)
{
  std::vector<unsigned int> chords(segments.size(), 1);
  for (std::size_t given = segments.size(); given < n; ++given)
    {
      std::size_t longest = 0;
      for (std::size_t i = 1; i < segments.size(); ++i)
        if (segments[i].length() / chords[i] > segments[longest].length() / chords[longest])
          longest = i;
      ++chords[longest];
    }
  return chords;
}

/// A corner of a faceted outline.
struct Place
{
  Point<2> at;
  double   back; ///< by which it stands back from the arc, m
};

/// The corners of @p n chords in place of @p s.
std::vector<Place> places_on(const Segment &s, const unsigned int n)
{
  double back = 0.;
  if (s.kind == Segment::Kind::concave)
    back = s.radius * (1. / std::cos(0.5 * (s.begin_angle - s.end_angle) / n) - 1.);
  std::vector<Place> places;
  for (unsigned int i = 0; i <= n; ++i)
    {
      const Point<2> p = i == 0 ? s.begin : i == n ? s.end : s.point(static_cast<double>(i) / n);
      places.push_back({back > 0. ? p + back / s.radius * (p - s.centre) : p, back});
    }
  return places;
}

/// The corner between two chords, of which the metal is on the left.
ToothForm::Corner corner_between(const Tensor<1, 2> &before, const Tensor<1, 2> &after)
{
  const double left = before[0] * after[1] - before[1] * after[0];
  if (std::abs(left) <= 1e-12 * before.norm() * after.norm())
    return ToothForm::Corner::none;
  return left > 0. ? ToothForm::Corner::convex : ToothForm::Corner::concave;
}

/// @p v mirrored at a line with the direction @p axis, a unit vector.
Tensor<1, 2> mirrored(const Tensor<1, 2> &v, const Tensor<1, 2> &axis)
{
  return 2. * (v * axis) * axis - v;
}
} // namespace

ToothForm ToothForm::faceted(const unsigned int n) const
{
  const std::vector<unsigned int> chords = share_out(half_profile, n / 2);
  std::vector<Place>              outline;
  for (std::size_t i = 0; i < half_profile.size(); ++i)
    {
      std::vector<Place> places = places_on(half_profile[i], chords[i]);
      if (!outline.empty()) // the end of one is the begin of the next
        {
          if (outline.back().back > places.front().back)
            places.front() = outline.back();
          outline.pop_back();
        }
      outline.insert(outline.end(), places.begin(), places.end());
    }

  ToothForm form = *this;
  form.half_profile.clear();
  for (std::size_t i = 1; i < outline.size(); ++i)
    form.half_profile.push_back(line_segment(outline[i - 1].at, outline[i].at));

  const auto chord = [&form](const std::size_t i) {
    return form.half_profile[i].end - form.half_profile[i].begin;
  };
  const std::size_t  last        = form.half_profile.size() - 1;
  const Point<2>    &top         = form.half_profile[last].end;
  const Tensor<1, 2> bottom_axis = Point<2>(1., 0.), top_axis = top / top.norm();
  // the chord before the first is its mirror image run through backwards, so is the one after the
  // last
  form.corners = {corner_between(-mirrored(chord(0), bottom_axis), chord(0))};
  for (std::size_t i = 1; i <= last; ++i)
    form.corners.push_back(corner_between(chord(i - 1), chord(i)));
  form.corners.push_back(corner_between(chord(last), -mirrored(chord(last), top_axis)));
  return form;
}
} // namespace chaindrive::drive
