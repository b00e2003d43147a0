// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/hanging_span.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::drive
{
using dealii::numbers::PI;

double HangingSpan::tension(const double slack) const
{
  // e H^3 + s H^2 = a grows and is convex above this bound of its positive root, from which
  // Newton's method falls to the root
  const double a   = weight * weight * length * length * length / 24.;
  double       now = std::max(0., -slack) / flexibility + std::cbrt(a / flexibility);
  for (unsigned int i = 0; i < 200 && now > 0.; ++i)
    {
      const double excess = (flexibility * now + slack) * now * now - a;
      const double next   = now - excess / ((3. * flexibility * now + 2. * slack) * now);
      if (!(next < now))
        break;
      now = next;
    }
  return now;
}

double HangingSpan::tension_of_sag(const double sag) const
{
  return sag > 0. ? weight * length * length / (8. * sag) : 0.;
}

double HangingSpan::sag(const double tension) const { return tension_of_sag(tension); }

LowestMode lowest_mode(const HangingSpan &span, const double tension)
{
  if (tension <= 0.)
    return {1., true};
  const double slope  = span.weight * span.length / tension;
  const double lambda = slope * slope * span.length / (tension * span.flexibility); // squared
  if (lambda >= 4. * PI * PI)
    return {2., false};
  // between a quarter and half a wave, where the tangent has no pole; without sag the first
  double low = 0.5 * PI, high = PI;
  for (unsigned int i = 0; i < 60; ++i)
    {
      const double x = 0.5 * (low + high);
      (lambda * std::sin(x) > std::cos(x) * (lambda * x - 4. * x * x * x) ? low : high) = x;
    }
  return {2. * low / PI, true};
}

double relative_sag(const Layout &layout)
{
  const Layout::Span &span = layout.slack();
  const auto         &from = layout.joints[span.first].bush;
  return span.sag /
         from.distance(layout.joints[(span.first + span.links) % layout.joints.size()].bush);
}
} // namespace chaindrive::drive
