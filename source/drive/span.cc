// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/span.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <complex>

namespace chaindrive::drive
{
using dealii::Point;
using dealii::Tensor;
using dealii::numbers::PI;

namespace
{
Point<2> polar(const double radius, const double angle)
{
  return Point<2>(radius * std::cos(angle), radius * std::sin(angle));
}

double direction(const Tensor<1, 2> &v) { return std::atan2(v[1], v[0]); }

/// The angle that is @p angle but for whole turns, between -pi and pi.
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
} // namespace

double LinkLengths::sum(const unsigned int first, const unsigned int n) const
{
  const unsigned int pairs = n / 2;
  return pairs * (inner + outer) + (n % 2 == 1 ? of(first) : 0.);
}

Wheel::Wheel(const unsigned int n_teeth, const Point<2> &position, const LinkLengths &lengths)
    : teeth(n_teeth), centre(position), pitch_angle(2. * PI / n_teeth)
{
  // inner = 2 r sin(pi/z - shift), outer = 2 r sin(pi/z + shift)
  const double half = PI / teeth, mean = 0.5 * (lengths.inner + lengths.outer);
  shift         = std::atan(std::tan(half) * 0.5 * (lengths.outer - lengths.inner) / mean);
  bush_radius   = 0.5 * lengths.inner / std::sin(half - shift);
  roller_radius = 0.5 * mean / std::sin(half);
}

Point<2> Wheel::roller(const double seat) const { return centre + polar(roller_radius, seat); }

Point<2> Wheel::bush(const double seat, const unsigned int joint) const
{
  return centre + polar(bush_radius, joint % 2 == 0 ? seat + shift : seat - shift);
}

double tangent_angle(const Wheel &driver, const Wheel &driven)
{
  return 0.5 * PI + std::asin((driven.roller_radius - driver.roller_radius) /
                              driver.centre.distance(driven.centre));
}

TightSpan tight_span(const Wheel       &driver,
                     const Wheel       &driven,
                     const LinkLengths &lengths,
                     const unsigned int n_joints,
                     const double       entry,
                     const unsigned int links)
{
  TightSpan span{};
  span.entry = entry;
  span.to    = driver.bush(entry, 0);
  // The triangle of the span, the driven sprocket's radius to its last bush and the line from its
  // centre to the entry bush has three known sides.
  const unsigned int exit_joint = n_joints - links;
  const Tensor<1, 2> to_entry   = span.to - driven.centre;
  const double       reach = to_entry.norm(), length = lengths.sum(exit_joint, links);
  const double       cosine =
      (reach * reach + driven.bush_radius * driven.bush_radius - length * length) /
      (2. * reach * driven.bush_radius);
  if (std::abs(cosine) > 1.)
    return span;
  const double bush = principal(direction(to_entry) - std::acos(cosine));
  span.exit         = bush + (exit_joint % 2 == 0 ? -driven.shift : driven.shift);
  span.from         = driven.bush(span.exit, exit_joint);
  span.links        = links;

  const double along = direction(span.to - span.from);
  span.misfit =
      outside(principal(entry + 0.5 * driver.pitch_angle + 0.5 * PI - along), driver.pitch_angle) +
      outside(principal(along - (span.exit - 0.5 * driven.pitch_angle + 0.5 * PI)),
              driven.pitch_angle);
  return span;
}

std::vector<TightSpan> tight_spans(const Wheel       &driver,
                                   const Wheel       &driven,
                                   const LinkLengths &lengths,
                                   const unsigned int n_joints,
                                   const double       phase)
{
  const double           tangent = tangent_angle(driver, driven);
  const double           centres = driver.centre.distance(driven.centre);
  const double           mean    = 0.5 * (lengths.inner + lengths.outer);
  const int              nominal = static_cast<int>(centres * std::sin(tangent) / mean);
  std::vector<TightSpan> spans;
  for (int gap = -1; gap <= 1; ++gap)
    for (int n = std::max(1, nominal - 3); n <= nominal + 4 && n < int(n_joints); ++n)
      {
        const TightSpan span = tight_span(driver,
                                          driven,
                                          lengths,
                                          n_joints,
                                          tangent + (phase - 0.5 + gap) * driver.pitch_angle,
                                          n);
        if (span.links > 0)
          spans.push_back(span);
      }
  sort_by_misfit(spans);
  return spans;
}

SlackSpan slack_span(const Wheel       &driver,
                     const Wheel       &driven,
                     const LinkLengths &lengths,
                     const unsigned int n_joints,
                     const TightSpan   &tight,
                     const int          bulge,
                     const int          driver_links,
                     const int          driven_links)
{
  const double exit  = tight.entry + driver_links * driver.pitch_angle;
  const double entry = tight.exit - driven_links * driven.pitch_angle;
  const int    links = static_cast<int>(n_joints - tight.links) - driver_links - driven_links;

  SlackSpan span;
  span.driver_links = driver_links;
  span.driven_links = driven_links;
  span.links        = links;
  span.from         = driver.bush(exit, driver_links);
  span.to           = driven.bush(entry, driver_links + links);

  const Tensor<1, 2> bridge = span.to - span.from;
  const double       gap    = bridge.norm();
  const double       mean   = 0.5 * (lengths.inner + lengths.outer);
  span.slack                = (links > 0 ? lengths.sum(driver_links, links) : links * mean) - gap;
  span.turn                 = 0.;
  span.heading              = direction(bridge);
  double last               = span.heading;
  if (bulge != 0 && span.slack > 0. && links > 1)
    {
      // the distance from end to end falls as the turn grows, to nearly zero for a closed polygon
      double low = 0., high = 2. * PI / links;
      for (int i = 0; i < 80; ++i)
        {
          const double turn = 0.5 * (low + high);
          if (turn <= low || turn >= high)
            break;
          (std::abs(chord(lengths, driver_links, links, turn)) > gap ? low : high) = turn;
        }
      span.turn          = bulge * high;
      const double whole = (links - 1) * span.turn;
      span.heading -= std::arg(chord(lengths, driver_links, links, span.turn)) + 0.5 * whole;
      last = span.heading + whole;
    }
  span.leaving  = principal(span.heading - (exit - 0.5 * driver.pitch_angle + 0.5 * PI));
  span.arriving = principal(entry + 0.5 * driven.pitch_angle + 0.5 * PI - last);
  span.misfit =
      outside(span.leaving, driver.pitch_angle) + outside(span.arriving, driven.pitch_angle);
  return span;
}

std::vector<SlackSpan> slack_spans(const Wheel       &driver,
                                   const Wheel       &driven,
                                   const LinkLengths &lengths,
                                   const unsigned int n_joints,
                                   const TightSpan   &tight,
                                   const int          bulge)
{
  const double tangent = tangent_angle(driver, driven);
  int a = static_cast<int>(std::lround((2. * PI - tangent - tight.entry) / driver.pitch_angle));
  int b = static_cast<int>(std::lround((tight.exit + tangent) / driven.pitch_angle));
  a     = std::max(a, 0);
  b     = std::max(b, 0);

  // put rollers on the sprockets, or take them off, until the chain turns by less than a pitch
  // angle
  const auto change = [](const double turn, const double most) {
    return turn < 0. ? -1 : turn > most ? 1 : 0;
  };
  for (int i = 0; i < 100; ++i)
    {
      const SlackSpan span   = slack_span(driver, driven, lengths, n_joints, tight, bulge, a, b);
      const int       more_a = change(span.leaving, driver.pitch_angle);
      const int       more_b = change(span.arriving, driven.pitch_angle);
      if ((more_a == 0 && more_b == 0) || a + more_a < 0 || b + more_b < 0)
        break;
      a += more_a;
      b += more_b;
    }

  std::vector<SlackSpan> spans;
  for (int i = std::max(0, a - 1); i <= a + 1; ++i)
    for (int j = std::max(0, b - 1); j <= b + 1; ++j)
      spans.push_back(slack_span(driver, driven, lengths, n_joints, tight, bulge, i, j));
  sort_by_misfit(spans);
  return spans;
}

std::vector<Point<2>> slack_joints(const SlackSpan &span, const LinkLengths &lengths)
{
  std::vector<Point<2>> joints;
  Point<2>              joint = span.from;
  for (int i = 0; i + 1 < span.links; ++i)
    {
      joint += polar(lengths.of(span.driver_links + i), span.heading + i * span.turn);
      joints.push_back(joint);
    }
  return joints;
}
} // namespace chaindrive::drive
