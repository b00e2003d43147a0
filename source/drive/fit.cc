// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/fit.h>
#include <chaindrive/drive/tooth_form.h>

#include <algorithm>
#include <cmath>
#include <utility>

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

std::vector<path::Wheel> Fitter::wheels(const double centre_distance) const
{
  std::vector<path::Wheel> at;
  for (const Wheel &wheel : sprockets)
    {
      Point<2> centre = wheel.centre;
      if (tensioner && at.size() == tensioner->wheel)
        centre = tensioner->centre(centre_distance);
      else if (wheel.moves)
        centre = Point<2>(sprockets[0].centre[0] + centre_distance * std::cos(wheel.direction),
                          sprockets[0].centre[1] + centre_distance * std::sin(wheel.direction));
      centre += wheel.eccentricity;
      if (wheel.joints > 0.)
        at.push_back(path::Wheel::flat(wheel.joints, centre, chain.seats, wheel.turn));
      else
        at.emplace_back(wheel.teeth, centre, chain.seats, wheel.turn);
    }
  return at;
}

bool Fitter::moves() const
{
  return tensioner || std::any_of(sprockets.begin(), sprockets.end(), [](const Wheel &wheel) {
           return wheel.moves;
         });
}

std::vector<Fitter::Wheel> wheels_of(const parameters::Sprockets &sprockets,
                                     const ChainDimensions       &chain)
{
  std::vector<Fitter::Wheel> wheels;
  for (const parameters::Sprocket &sprocket : sprockets.list)
    {
      const bool at_origin = !sprocket.centre && wheels.empty();
      wheels.push_back({sprocket.teeth, sprocket.turn, !sprocket.centre && !at_origin});
      if (sprocket.centre)
        wheels.back().centre = Point<2>((*sprocket.centre)[0], (*sprocket.centre)[1]);
      if (sprocket.is_flat())
        wheels.back().joints = joint_radius(sprocket.flat, chain);
      wheels.back().direction       = sprocket.direction;
      wheels.back().eccentricity[0] = 0.5 * sprocket.runout * std::cos(sprocket.runout_phase);
      wheels.back().eccentricity[1] = 0.5 * sprocket.runout * std::sin(sprocket.runout_phase);
    }
  return wheels;
}

int Fitter::bulge(const std::vector<path::Wheel> &at) const
{
  // the angle is that of the outward normal
  if (!pressing.empty())
    return path::beside(at[0], at[1], pressing) > 0. ? -1 : 1;
  return gravity * std::sin(path::tangent_angle(at[0], at[1])) < 0. ? -1 : 1;
}

std::vector<Fit>
Fitter::fits(const double centre_distance, const bool straight, const unsigned int most_tight) const
{
  const std::vector<path::Wheel> at      = wheels(centre_distance);
  path::Chain                    hanging = chain;
  hanging.bulge                          = bulge(at);
  std::vector<Fit> result;
  for (path::Laid &laid : path::lay_all(at, hanging, straight, most_tight))
    result.push_back({centre_distance, at, std::move(laid)});
  return result;
}

std::optional<Fit> Fitter::fit(const double centre_distance, const path::Route &route) const
{
  std::vector<path::Wheel> at      = wheels(centre_distance);
  path::Chain              hanging = chain;
  hanging.bulge                    = bulge(at);
  const auto laid                  = path::lay(at, hanging, route);
  if (!laid)
    return {};
  return Fit{centre_distance, std::move(at), *laid};
}

double Fitter::excess(const Fit &fit, const Target &target)
{
  const path::SlackSpan &slack = fit.laid.slack;
  if (target.kind == Target::Kind::slack)
    return slack.slack - target.value;
  const double chord = slack.from.distance(slack.to);
  return (slack.slack > 0. ? slack.sag() : slack.slack) / chord - target.value;
}

double Fitter::solve(const Target &target, const double low, const double high) const
{
  return bisect(low, high, 1e-7, [&](const double c) {
    const auto best = fits(c, target.kind == Target::Kind::slack, 1);
    return best.empty() ? 1. : (rises ? -1. : 1.) * excess(best.front(), target);
  });
}

std::optional<Fit>
Fitter::solve(const Target &target, const path::Route &route, const double guess) const
{
  const double near = 0.3 * chain.seats.mean() / (tensioner ? tensioner->lever() : 1.);
  const auto   at   = [&](const double c) {
    const auto f = fit(c, route);
    return f ? (rises ? -1. : 1.) * excess(*f, target) : std::nan("");
  };
  // a tensioner takes up only a part of its way as slack
  const double far = tensioner ? 20. * near : near;
  for (double reach = near; reach <= far; reach *= 2.)
    if (at(guess - reach) > 0. && at(guess + reach) <= 0.)
      return fit(bisect(guess - reach, guess + reach, 0., at), route);
  return {};
}
} // namespace chaindrive::drive
