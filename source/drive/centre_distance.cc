// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/centre_distance.h>
#include <chaindrive/drive/chain.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace chaindrive::drive
{
namespace
{
using Target = Fitter::Target;
using dealii::numbers::PI;

std::string at_most(const double length) { return to_text_at_most(length * 1e3, 7) + " mm"; }
std::string at_least(const double length) { return to_text_at_least(length * 1e3, 7) + " mm"; }

/// Such as "15 and 42".
std::string teeth_in_words(const Fitter &fitter)
{
  std::string text;
  for (std::size_t i = 0; i < fitter.sprockets.size(); ++i)
    text += (i == 0                           ? "" :
             i + 1 == fitter.sprockets.size() ? " and " :
                                                ", ") +
            std::to_string(fitter.sprockets[i].teeth);
  return text;
}

Target wanted(const parameters::Layout &layout)
{
  if (layout.centre_distance_from == parameters::CentreDistanceFrom::slack)
    return {Target::Kind::slack, layout.slack};
  if (layout.centre_distance_from == parameters::CentreDistanceFrom::sag)
    return {Target::Kind::sag, layout.sag};
  return {Target::Kind::slack, 0.}; // pre-tension: the link lengths hold the stretch
}
} // namespace

unsigned int number_of_links(const parameters::Drive &drive)
{
  parameters::Chain chain = drive.chain;
  chain.elongation        = 0.;
  const double pitch      = make_chain(chain).loaded_pitch();
  const double c          = drive.layout.centre_distance;
  Fitter       fitter;
  fitter.sprockets                      = wheels_of(drive.sprockets);
  fitter.chain.seats                    = {pitch, pitch};
  const std::vector<path::Wheel> wheels = fitter.wheels(c);
  const std::size_t              n      = wheels.size();
  double                         links  = 0.;
  for (std::size_t i = 0; i < n; ++i)
    {
      const path::Wheel &before = wheels[(i + n - 1) % n], &wheel = wheels[i],
                        &after = wheels[(i + 1) % n];
      const double far         = wheel.centre.distance(after.centre);
      const double least       = wheel.roller_radius + after.roller_radius;
      if (far <= least)
        throw InputError(
            "Drive/Layout/Centre distance in mm = " + to_text(c * 1e3, 7) +
            ": the sprockets overlap; for Drive/Number of links = auto it must exceed " +
            at_least(least) + ".");
      const double across = wheel.turn * wheel.roller_radius - after.turn * after.roller_radius;
      const double turned =
          wheel.turn * (path::tangent_angle(wheel, after) - path::tangent_angle(before, wheel));
      const double wrap = turned - 2. * PI * std::floor(turned / (2. * PI));
      links += std::sqrt(far * far - across * across) / pitch + wrap / wheel.pitch_angle;
    }
  const double pairs = 0.5 * links;
  const bool   given = drive.layout.centre_distance_from == parameters::CentreDistanceFrom::given;
  return 2 * static_cast<unsigned int>(given ? std::ceil(pairs - 1e-9) : std::round(pairs));
}

std::string advised_links(const Fitter &fitter, const double missing, const bool even)
{
  const double wanted = fitter.chain.n_links + missing / fitter.chain.seats.mean();
  const double step   = even ? 2. : 1.;
  return std::to_string(static_cast<long>(
      step * (missing > 0. ? std::ceil(wanted / step - 1e-9) : std::floor(wanted / step + 1e-9))));
}

Proposal propose(const Fitter             &fitter,
                 const parameters::Layout &layout,
                 const double              least_distance,
                 const bool                even)
{
  const std::string the_chain = "A chain of " + std::to_string(fitter.chain.n_links) + " links";
  const double      given     = layout.centre_distance;
  const bool        is_given = layout.centre_distance_from == parameters::CentreDistanceFrom::given;
  if (is_given && given <= least_distance)
    throw InputError("Drive/Layout/Centre distance in mm = " + to_text(given * 1e3, 7) +
                     ": the sprockets overlap; it must exceed " + at_least(least_distance) + ".");

  const auto   closest = fitter.fits(least_distance, true, 1);
  const double most_slack =
      closest.empty() ? -4. * fitter.chain.seats.mean() : closest.front().laid.slack.slack;
  if (most_slack < 0.)
    throw InputError(the_chain + " is too short for sprockets of " + teeth_in_words(fitter) +
                     " teeth; it takes at least " + advised_links(fitter, -most_slack, even) +
                     " links.");

  const double farthest = 0.5 * fitter.chain.seats.mean() * fitter.chain.n_links;
  if (is_given)
    {
      const auto   fits    = fitter.fits(given, true, 1); // none when it is far too short
      const double missing = fits.empty() ? 2. * (given - least_distance) - most_slack :
                                            -fits.front().laid.slack.slack;
      if (missing > 1e-12)
        throw InputError(
            "Drive/Layout/Centre distance in mm = " + to_text(given * 1e3, 7) + ": " + the_chain +
            " is " + (fits.empty() ? "much" : in_mm(missing)) +
            " too short; the distance must be at most " +
            at_most(fitter.solve({Target::Kind::slack, 0.}, least_distance, farthest)) +
            ", or the chain must have at least " + advised_links(fitter, missing, even) +
            " links.");
      return {{}, fitter.fits(given, false)};
    }

  const Target target   = wanted(layout);
  const bool   is_slack = target.kind == Target::Kind::slack;
  if (!(target.value >= 0.))
    throw InputError("Drive/Layout/" + std::string(is_slack ? "Slack in mm" : "Sag in percent") +
                     " must not be negative.");
  if (is_slack && most_slack < target.value)
    throw InputError("Drive/Layout/Slack in mm = " + to_text(target.value * 1e3) + ": " +
                     the_chain + " has at most " + at_most(most_slack) +
                     " of slack before the sprockets touch; it takes at least " +
                     advised_links(fitter, target.value - most_slack, even) + " links.");
  return {target, fitter.fits(fitter.solve(target, least_distance, farthest), false)};
}
} // namespace chaindrive::drive
