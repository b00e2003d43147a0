// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/path/span.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <cmath>
#include <complex>

namespace chaindrive::path
{
using dealii::Point;
using dealii::Tensor;
using dealii::numbers::PI;

namespace
{
double direction(const Tensor<1, 2> &v) { return std::atan2(v[1], v[0]); }

/// The angle that is @p angle but for whole revolutions, between -pi and pi.
double principal(const double angle) { return std::remainder(angle, 2. * PI); }

double outside(const double turn, const double most)
{
  return std::max(0., -turn) + std::max(0., turn - most);
}

/// Vector from end to end of a polygon that turns by @p turn, not zero, from link to link, the
/// middle of its angles along x; as a complex number. Every second link has the same length, and n
/// of them that turn by 2 q add up to sin(n q) / sin(q) times the middle one.
std::complex<double>
chord(const LinkLengths &lengths, const unsigned int first, const unsigned int n, const double turn)
{
  const double a = lengths.of(first), b = lengths.of(first + 1);
  if (n % 2 == 0)
    return (std::polar(a, -0.5 * turn) + std::polar(b, 0.5 * turn)) * std::sin(0.5 * n * turn) /
           std::sin(turn);
  return (a * std::sin(0.5 * (n + 1.) * turn) + b * std::sin(0.5 * (n - 1.) * turn)) /
         std::sin(turn);
}

template <typename Span>
void sort_by_misfit(std::vector<Span> &spans)
{
  std::stable_sort(
      spans.begin(), spans.end(), [](const Span &a, const Span &b) { return a.misfit < b.misfit; });
}

/// By what the chain turns round @p wheel from the direction angle @p before to the link that
/// follows its first seat, at the polar angle @p seat; and from the link before its last seat to
/// the direction @p after.
double turn_at_entry(const Wheel &wheel, const double seat, const double before)
{
  return principal(wheel.turn *
                   (wheel.direction(seat + wheel.turn * (0.5 * wheel.pitch_angle)) - before));
}

double turn_at_exit(const Wheel &wheel, const double seat, const double after)
{
  return principal(wheel.turn *
                   (after - wheel.direction(seat - wheel.turn * (0.5 * wheel.pitch_angle))));
}
} // namespace

double tangent_angle(const Wheel &from, const Wheel &to)
{
  const Tensor<1, 2> way = to.centre - from.centre;
  return direction(way) - 0.5 * PI +
         std::asin((from.turn * from.roller_radius - to.turn * to.roller_radius) / way.norm());
}

double beside(const Wheel &from, const Wheel &to, const std::vector<Point<2>> &points)
{
  const double tangent = tangent_angle(from, to);
  double       sum     = 0.;
  for (const Point<2> &p : points)
    sum +=
        std::cos(tangent) * (p[0] - from.centre[0]) + std::sin(tangent) * (p[1] - from.centre[1]);
  return sum / static_cast<double>(points.size()) - from.turn * from.roller_radius;
}

double touching(const Wheel &wheel, const double tangent)
{
  return wheel.turn > 0 ? tangent : tangent + PI;
}

TautSpan taut_span(const Wheel       &from,
                   const Wheel       &to,
                   const LinkLengths &lengths,
                   const unsigned int joint,
                   const double       entry,
                   const unsigned int links)
{
  TautSpan span{};
  span.entry = entry;
  span.to    = to.bush(entry, joint);
  // The triangle of the span, the radius of the wheel before it to its last bush and the line from
  // that wheel's centre to the entry bush has three known sides.
  const unsigned int exit_joint = joint - links;
  const Tensor<1, 2> to_entry   = span.to - from.centre;
  const double       reach = to_entry.norm(), length = lengths.sum(exit_joint, links);
  const double cosine = (reach * reach + from.bush_radius * from.bush_radius - length * length) /
                        (2. * reach * from.bush_radius);
  if (std::abs(cosine) > 1.)
    return span;
  const double bush = principal(direction(to_entry) - from.turn * std::acos(cosine));
  span.exit         = bush + from.turn * (exit_joint % 2 == 0 ? -from.shift : from.shift);
  span.from         = from.bush(span.exit, exit_joint);
  span.links        = links;

  const double along = direction(span.to - span.from);
  span.misfit        = outside(turn_at_entry(to, entry, along), to.pitch_angle) +
                outside(turn_at_exit(from, span.exit, along), from.pitch_angle);
  return span;
}

std::vector<TautSpan> taut_spans(const Wheel               &from,
                                 const Wheel               &to,
                                 const LinkLengths         &lengths,
                                 const unsigned int         joint,
                                 const std::vector<double> &entries)
{
  const double way    = from.centre.distance(to.centre);
  const double across = from.turn * from.roller_radius - to.turn * to.roller_radius;
  const int    nominal =
      static_cast<int>(std::sqrt(std::max(0., way * way - across * across)) / lengths.mean());
  std::vector<TautSpan> spans;
  for (const double entry : entries)
    for (int n = std::max(1, nominal - 3); n <= nominal + 4 && n < int(joint); ++n)
      {
        const TautSpan span = taut_span(from, to, lengths, joint, entry, n);
        if (span.links > 0)
          spans.push_back(span);
      }
  sort_by_misfit(spans);
  return spans;
}

int links_on(const Wheel &wheel, const double from, const double to)
{
  const double angle = 0.75 * PI + principal(wheel.turn * (to - from) - 0.75 * PI);
  return std::max(0, static_cast<int>(std::lround(angle / wheel.pitch_angle)));
}

std::vector<double> entries_near_tangent(const Wheel &from, const Wheel &to, const double phase)
{
  const double        tangent = touching(to, tangent_angle(from, to));
  std::vector<double> entries;
  for (int gap = -1; gap <= 1; ++gap)
    entries.push_back(tangent + to.turn * ((phase - 0.5 + gap) * to.pitch_angle));
  return entries;
}

double SlackSpan::sag() const
{
  const double angle = std::abs(turn);
  if (angle == 0.)
    return 0.;
  const double half = 0.5 * links * angle; // of the angle that the circle spans
  // circle through the span's ends with that angle between them
  return 0.5 * from.distance(to) * std::tan(0.5 * half);
}

SlackSpan slack_span(const Gap         &gap,
                     const LinkLengths &lengths,
                     const int          bulge,
                     const int          links_before,
                     const int          links_after)
{
  const double exit  = gap.before.after(gap.entry, links_before);
  const double entry = gap.after.after(gap.exit, -links_after);
  const int    links = static_cast<int>(gap.links) - links_before - links_after;

  SlackSpan span;
  span.links_before = links_before;
  span.links_after  = links_after;
  span.links        = links;
  span.from         = gap.before.bush(exit, links_before);
  span.to           = gap.after.bush(entry, links_before + links);

  const Tensor<1, 2> bridge = span.to - span.from;
  const double       width  = bridge.norm();
  span.slack   = (links > 0 ? lengths.sum(links_before, links) : links * lengths.mean()) - width;
  span.turn    = 0.;
  span.heading = direction(bridge);
  double last  = span.heading;
  if (bulge != 0 && span.slack > 0. && links > 1)
    {
      // the distance from end to end falls as the turn grows, to nearly zero for a closed polygon
      double low = 0., high = 2. * PI / links;
      for (int i = 0; i < 80; ++i)
        {
          const double turn = 0.5 * (low + high);
          if (turn <= low || turn >= high)
            break;
          (std::abs(chord(lengths, links_before, links, turn)) > width ? low : high) = turn;
        }
      span.turn          = bulge * high;
      const double whole = (links - 1) * span.turn;
      span.heading -= std::arg(chord(lengths, links_before, links, span.turn)) + 0.5 * whole;
      last = span.heading + whole;
    }
  span.leaving  = turn_at_exit(gap.before, exit, span.heading);
  span.arriving = turn_at_entry(gap.after, entry, last);
  span.misfit =
      outside(span.leaving, gap.before.pitch_angle) + outside(span.arriving, gap.after.pitch_angle);
  return span;
}

std::vector<SlackSpan> slack_spans(const Gap &gap, const LinkLengths &lengths, const int bulge)
{
  const double tangent = tangent_angle(gap.before, gap.after);
  int          a       = links_on(gap.before, gap.entry, touching(gap.before, tangent));
  int          b       = links_on(gap.after, touching(gap.after, tangent), gap.exit);

  // put rollers on the wheels, or take them off, until the chain turns by less than a pitch angle
  const auto change = [](const double turn, const double most) {
    return turn < 0. ? -1 : turn > most ? 1 : 0;
  };
  for (int i = 0; i < 100; ++i)
    {
      const SlackSpan span   = slack_span(gap, lengths, bulge, a, b);
      const int       more_a = change(span.leaving, gap.before.pitch_angle);
      const int       more_b = change(span.arriving, gap.after.pitch_angle);
      if ((more_a == 0 && more_b == 0) || a + more_a < 0 || b + more_b < 0)
        break;
      a += more_a;
      b += more_b;
    }

  std::vector<SlackSpan> spans;
  for (int i = std::max(0, a - 1); i <= a + 1; ++i)
    for (int j = std::max(0, b - 1); j <= b + 1; ++j)
      spans.push_back(slack_span(gap, lengths, bulge, i, j));
  sort_by_misfit(spans);
  return spans;
}

std::vector<Point<2>> slack_joints(const SlackSpan &span, const LinkLengths &lengths)
{
  std::vector<Point<2>> joints;
  Point<2>              joint = span.from;
  for (int i = 0; i + 1 < span.links; ++i)
    {
      const double length = lengths.of(span.links_before + i);
      const double angle  = span.heading + i * span.turn;
      joint[0] += length * std::cos(angle);
      joint[1] += length * std::sin(angle);
      joints.push_back(joint);
    }
  return joints;
}
} // namespace chaindrive::path
