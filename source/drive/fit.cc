// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/fit.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::drive
{
using dealii::Point;

namespace
{
/// Halves [low, high] until it is no longer than @p width; @p excess falls from low to high.
template <typename Function>
double bisect(double low, double high, const double width, const Function &excess)
{
  while (high - low > width)
    {
      const double middle = 0.5 * (low + high);
      if (middle <= low || middle >= high) // neighbouring numbers
        break;
      (excess(middle) > 0. ? low : high) = middle;
    }
  return low;
}
} // namespace

double Fit::sag() const
{
  const double turn = std::abs(slack.turn);
  if (turn == 0.)
    return 0.;
  const double half = 0.5 * slack.links * turn; // of the angle that the circle spans
  // circle through the span's ends with that angle between them
  return 0.5 * slack.from.distance(slack.to) * std::tan(0.5 * half);
}

std::vector<Fit>
Fitter::fits(const double centre_distance, const bool straight, const unsigned int most_tight) const
{
  const Wheel driver(driver_teeth, Point<2>(), seats);
  const Wheel driven(driven_teeth, Point<2>(centre_distance, 0.), seats);
  if (std::abs(driver.roller_radius - driven.roller_radius) >= centre_distance)
    return {};

  std::vector<Fit> result;
  auto             tights = tight_spans(driver, driven, tight, n_links, phase);
  tights.resize(std::min<std::size_t>(tights.size(), most_tight));
  for (const TightSpan &t : tights)
    {
      const int gap = static_cast<int>(std::lround(
          (t.entry - tangent_angle(driver, driven)) / driver.pitch_angle - phase + 0.5));
      for (const SlackSpan &s :
           slack_spans(driver, driven, slack, n_links, t, straight ? 0 : bulge))
        result.push_back({centre_distance,
                          {gap, t.links, s.driver_links, s.driven_links},
                          driver,
                          driven,
                          t,
                          s});
    }
  std::stable_sort(result.begin(), result.end(), [](const Fit &a, const Fit &b) {
    return a.tight.misfit + a.slack.misfit < b.tight.misfit + b.slack.misfit;
  });
  return result;
}

std::optional<Fit> Fitter::fit(const double centre_distance, const Route &route) const
{
  const Wheel driver(driver_teeth, Point<2>(), seats);
  const Wheel driven(driven_teeth, Point<2>(centre_distance, 0.), seats);
  if (std::abs(driver.roller_radius - driven.roller_radius) >= centre_distance)
    return {};
  const double entry =
      tangent_angle(driver, driven) + (phase - 0.5 + route.gap) * driver.pitch_angle;
  const TightSpan t = tight_span(driver, driven, tight, n_links, entry, route.tight_links);
  if (t.links == 0)
    return {};
  const SlackSpan s =
      slack_span(driver, driven, slack, n_links, t, bulge, route.driver_links, route.driven_links);
  return Fit{centre_distance, route, driver, driven, t, s};
}

double Fitter::excess(const Fit &fit, const Target &target) const
{
  if (target.kind == Target::Kind::slack)
    return fit.slack.slack - target.value;
  const double chord = fit.slack.from.distance(fit.slack.to);
  return (fit.slack.slack > 0. ? fit.sag() : fit.slack.slack) / chord - target.value;
}

double Fitter::solve(const Target &target, const double low, const double high) const
{
  return bisect(low, high, 1e-7, [&](const double c) {
    const auto best = fits(c, target.kind == Target::Kind::slack, 1);
    return best.empty() ? 1. : excess(best.front(), target);
  });
}

std::optional<Fit> Fitter::solve(const Target &target, const Route &route, const double guess) const
{
  const double reach = 0.3 * mean_length();
  const auto   at    = [&](const double c) {
    const auto f = fit(c, route);
    return f ? excess(*f, target) : std::nan("");
  };
  if (!(at(guess - reach) > 0. && at(guess + reach) <= 0.))
    return {};
  return fit(bisect(guess - reach, guess + reach, 0., at), route);
}
} // namespace chaindrive::drive
