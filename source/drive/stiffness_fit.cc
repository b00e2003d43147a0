// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/stiffness_fit.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace chaindrive::drive
{
namespace
{
double at_place(const double (&coefficients)[3], const double place)
{
  return coefficients[0] + place * (coefficients[1] + place * coefficients[2]);
}

/// How much of the force grows from the first to the last stiffness, m.
double share_of_last(const double depth, const double approach)
{
  const double beyond = std::max(0., approach - depth);
  return (approach * approach - beyond * beyond) / (2. * depth);
}

/// What a curve of some depth has by its first and last stiffness, over what was found.
struct Share
{
  double of_first, of_last; ///< m/N
};

/// The shares in the forces of @p found, and with @p tangents in those between its forces.
std::vector<Share>
shares_of(const Approaches &found, const double depth, const std::vector<double> &tangents)
{
  // F = first (d - h) + last h, and its derivative
  std::vector<Share> result;
  for (std::size_t i = 0; i < found.force.size(); ++i)
    {
      const double h = share_of_last(depth, found.approach[i]);
      result.push_back({(found.approach[i] - h) / found.force[i], h / found.force[i]});
    }
  for (std::size_t i = 0; i < tangents.size(); ++i)
    {
      const double last = std::min(1., found.approach[i + 1] / depth);
      result.push_back({(1. - last) / tangents[i], last / tangents[i]});
    }
  return result;
}

/// Tangents at all forces of @p found but the first and the last, N/m: of the parabola through a
/// force and its two neighbours, over logarithms, in which power laws are lines.
std::vector<double> tangents_of(const Approaches &found)
{
  std::vector<double> result;
  for (std::size_t i = 1; i + 1 < found.force.size(); ++i)
    {
      const double before = std::log(found.approach[i] / found.approach[i - 1]),
                   behind = std::log(found.approach[i + 1] / found.approach[i]);
      const double power  = (std::log(found.force[i] / found.force[i - 1]) * behind / before +
                            std::log(found.force[i + 1] / found.force[i]) * before / behind) /
                           (before + behind);
      result.push_back(power * found.force[i] / found.approach[i]);
    }
  return result;
}

/// First and last stiffness of what was @p found, N/m, with these @p tangents between; adds the
/// squares of relative errors to @p squares.
std::array<double, 2> fit_one(const Approaches          &found,
                              const std::vector<double> &tangents,
                              const double               depth,
                              double                    &squares)
{
  const std::vector<Share> shares = shares_of(found, depth, tangents);

  double a = 0., b = 0., c = 0., p = 0., q = 0.;
  for (const Share &share : shares)
    {
      a += share.of_first * share.of_first;
      b += share.of_first * share.of_last;
      c += share.of_last * share.of_last;
      p += share.of_first;
      q += share.of_last;
    }
  const double          determinant = a * c - b * b;
  std::array<double, 2> fitted = {{(p * c - q * b) / determinant, (q * a - p * b) / determinant}};
  if (!(fitted[0] > 0.) || !(fitted[1] > 0.))
    fitted[0] = fitted[1] = found.force.back() / found.approach.back();
  for (const Share &share : shares)
    squares += std::pow(fitted[0] * share.of_first + fitted[1] * share.of_last - 1., 2);
  return fitted;
}

/// The extreme values of a polynomial from place 0 to @p end.
std::pair<double, double> extremes(const double (&coefficients)[3], const double end)
{
  const double at_end = at_place(coefficients, end);
  double       least = std::min(coefficients[0], at_end), most = std::max(coefficients[0], at_end);
  if (coefficients[2] != 0.)
    if (const double turn = -0.5 * coefficients[1] / coefficients[2]; turn > 0. && turn < end)
      {
        least = std::min(least, at_place(coefficients, turn));
        most  = std::max(most, at_place(coefficients, turn));
      }
  return {least, most};
}

/// The polynomial through @p values at @p places, a line through the first and the last where it
/// would not be positive.
void interpolate(const std::vector<double>     &values,
                 const std::vector<Approaches> &places,
                 double (&coefficients)[3])
{
  const double end = places.back().place;
  coefficients[0]  = values[0];
  if (places.size() == 3)
    {
      const double middle     = places[1].place;
      const double from_first = (values[1] - values[0]) / middle,
                   to_last    = (values[2] - values[1]) / (end - middle);
      coefficients[2]         = (to_last - from_first) / end;
      coefficients[1]         = from_first - coefficients[2] * middle;
      if (extremes(coefficients, end).first > 0.)
        return;
    }
  coefficients[2] = 0.;
  coefficients[1] = places.size() == 1 ? 0. : (values.back() - values[0]) / end;
}

/// From the smallest approach to the largest of @p found.
std::vector<double> depths_of(const Approaches &found)
{
  constexpr unsigned int n     = 64;
  const double           ratio = found.approach.back() / found.approach.front();
  std::vector<double>    result;
  for (unsigned int i = 0; i <= n; ++i)
    result.push_back(found.approach.front() * std::pow(ratio, static_cast<double>(i) / n));
  return result;
}
} // namespace

StiffnessCurve fit_stiffness(const std::vector<Approaches> &places, const bool with_tangents)
{
  bool good = !places.empty() && places.size() <= 3 && places[0].place == 0.;
  for (std::size_t i = 1; i < places.size(); ++i)
    good = good && places[i].place > places[i - 1].place;
  if (!good)
    throw std::logic_error("A stiffness curve is fitted at one to three ascending places from 0.");
  for (const Approaches &found : places)
    if (found.force.size() < 2 || found.force.size() != found.approach.size())
      throw std::logic_error("A stiffness curve needs two forces at each place.");
  StiffnessCurve      curve{};
  std::vector<double> first, last;
  double              least = std::numeric_limits<double>::infinity();
  for (const double depth : with_tangents ? depths_of(places[0]) :
                                            std::vector<double>(places[0].approach.begin() + 1,
                                                                places[0].approach.end()))
    {
      double              squares = 0.;
      std::vector<double> of_first, of_last;
      for (const Approaches &found : places)
        {
          const std::array<double, 2> fitted = fit_one(
              found, with_tangents ? tangents_of(found) : std::vector<double>(), depth, squares);
          of_first.push_back(fitted[0]);
          of_last.push_back(fitted[1]);
        }
      if (squares < least)
        {
          least       = squares;
          curve.depth = depth;
          first       = of_first;
          last        = of_last;
        }
    }
  curve.end = places.back().place;
  interpolate(first, places, curve.first);
  interpolate(last, places, curve.last);
  return curve;
}

double force_of(const StiffnessCurve &curve, const double place, const double approach)
{
  const double at   = std::clamp(place, 0., curve.end);
  const double last = share_of_last(curve.depth, approach);
  return at_place(curve.first, at) * (approach - last) + at_place(curve.last, at) * last;
}

double approach_of(const StiffnessCurve &curve, const double place, const double force)
{
  const double at    = std::clamp(place, 0., curve.end);
  const double first = at_place(curve.first, at), last = at_place(curve.last, at);
  const double bend = 0.5 * (first + last) * curve.depth; // from which force on it is a line
  if (force > bend)
    return curve.depth + (force - bend) / last;
  // the root of the parabola that is zero without force, where its curvature may vanish
  const double growth = (last - first) / curve.depth;
  return 2. * force / (first + std::sqrt(first * first + 2. * growth * force));
}

double stiffest(const StiffnessCurve &curve)
{
  return std::max(extremes(curve.first, curve.end).second, extremes(curve.last, curve.end).second);
}
} // namespace chaindrive::drive
