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

/// How often a chain turns counter-clockwise on its way round @p wheels, with wraps of less than a
/// turn; NaN where two wheels have no common tangent.
double turns_of(const std::vector<path::Wheel> &wheels)
{
  const std::size_t n     = wheels.size();
  double            turns = 0.;
  for (std::size_t i = 0; i < n; ++i)
    {
      const double in     = path::tangent_angle(wheels[(i + n - 1) % n], wheels[i]);
      const double out    = path::tangent_angle(wheels[i], wheels[(i + 1) % n]);
      const double turned = wheels[i].turn * (out - in) / (2. * PI);
      turns += wheels[i].turn * (turned - std::floor(turned));
    }
  return turns;
}

/// Pitches of a chain on pitch circles of @p wheels, which are apart.
double pitches_round(const std::vector<path::Wheel> &wheels, const double pitch)
{
  const std::size_t n       = wheels.size();
  double            pitches = 0.;
  for (std::size_t i = 0; i < n; ++i)
    {
      const path::Wheel &before = wheels[(i + n - 1) % n], &wheel = wheels[i],
                        &after = wheels[(i + 1) % n];
      const double far         = wheel.centre.distance(after.centre);
      const double across = wheel.turn * wheel.roller_radius - after.turn * after.roller_radius;
      const double turned =
          wheel.turn * (path::tangent_angle(wheel, after) - path::tangent_angle(before, wheel));
      const double wrap = turned - 2. * PI * std::floor(turned / (2. * PI));
      pitches += std::sqrt(far * far - across * across) / pitch + wrap / wheel.pitch_angle;
    }
  return pitches;
}

/// The layouts near the given centre distance that meet @p target, for more than two wheels: the
/// range of distances in which those are whose excess has either sign grows from there, as far as
/// wheels may be. Beyond, the slack is another one, since the chain would go another way.
Proposal propose_near(const Fitter      &fitter,
                      const Target      &target,
                      const double       given,
                      const std::string &entry,
                      const bool         even)
{
  const std::string begin = "Drive/Layout/Centre distance in mm = " + to_text(given * 1e3, 7) +
                            ", with which the search ";
  if (!may_be(fitter, given))
    throw InputError(begin +
                     "begins: wheels overlap there, or the chain would cross itself; choose "
                     "another one.");
  const auto excess = [&](const double c) {
    const auto best = fitter.fits(c, target.kind == Target::Kind::slack, 1);
    return best.empty() ? std::nan("") : Fitter::excess(best.front(), target);
  };
  double       near = given, far = given, step = 0.1 * fitter.chain.seats.mean();
  const double first = excess(given);
  if (!std::isfinite(first))
    throw InputError(begin + "for " + entry + " begins: " + too_short(fitter, given, even));
  const int much = first > 0. ? 1 : -1; // slack
  const int way  = fitter.rises ? -much : much;
  for (double now = first; much * now > 0.; step *= 1.3)
    {
      near = far;
      far += way * step;
      now = far > 0. && may_be(fitter, far) ? excess(far) : std::nan("");
      if (!std::isfinite(now))
        {
          const auto   best    = fitter.fits(near, true, 1);
          const double missing = best.empty() ? 0. :
                                 target.kind == Target::Kind::slack ?
                                                target.value - best.front().laid.slack.slack :
                                                -best.front().laid.slack.slack;
          throw InputError(
              begin + "for " + entry + " begins: a chain of " +
              std::to_string(fitter.chain.n_links) + " links is too " +
              (much > 0 ? "long" : "short") + " as far as to " + at_least(near) +
              ", beyond which wheels meet or the chain crosses itself; it would have " +
              advised_links(fitter, missing, even) +
              " links there. Choose other "
              "links, or places of wheels.");
        }
    }
  return {target,
          fitter.fits(fitter.solve(target, std::min(near, far), std::max(near, far)), false)};
}
} // namespace

Target wanted(const parameters::Layout &layout)
{
  if (layout.centre_distance_from == parameters::CentreDistanceFrom::slack)
    return {Target::Kind::slack, layout.slack};
  if (layout.centre_distance_from == parameters::CentreDistanceFrom::sag)
    return {Target::Kind::sag, layout.sag};
  return {Target::Kind::slack, 0.}; // pre-tension: the link lengths hold the stretch
}

bool may_be(const Fitter &fitter, const double c)
{
  const std::vector<path::Wheel> wheels = fitter.wheels(c);
  for (std::size_t i = 0; i < wheels.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (wheels[i].centre.distance(wheels[j].centre) <=
          wheels[i].roller_radius + wheels[j].roller_radius)
        return false;
  return std::abs(turns_of(wheels) - 1.) < 1e-6;
}

namespace
{
/// Refuses more than one wheel whose centre is to be found; whether there is one.
bool finds_one(const parameters::Sprockets &sprockets,
               const parameters::Layout    &layout,
               const Fitter                &fitter)
{
  std::vector<std::string> found;
  for (std::size_t i = 0; i < fitter.sprockets.size(); ++i)
    if (fitter.sprockets[i].moves)
      found.push_back(sprockets.list[i].name);
  if (found.size() > 1)
    throw InputError("Drive/Wheels: one centre is found from " +
                     text_of(layout.centre_distance_from) + ", but those of " +
                     join(found, " and ") + " are auto; give all but one.");
  return !found.empty();
}

std::string overlap_of(const parameters::Sprockets &sprockets,
                       const std::size_t            i,
                       const std::size_t            j,
                       const double                 away,
                       const double                 least)
{
  return "Drive/Wheels: " + sprockets.list[j].name + " and " + sprockets.list[i].name +
         " overlap: their centres are " + in_mm(away, 5) + " apart and must be more than " +
         at_least(least) + ".";
}
} // namespace

void check_wheels(const parameters::Sprockets  &sprockets,
                  const parameters::Layout     &layout,
                  const std::vector<ToothForm> &forms,
                  const Fitter                 &fitter)
{
  const auto &wheels = fitter.sprockets;
  const bool  clamped =
      parameters::is_clamped(sprockets.list[tensioned_wheel(sprockets)].held.holder);
  if (!finds_one(sprockets, layout, fitter) && !clamped &&
      layout.centre_distance_from != parameters::CentreDistanceFrom::given)
    throw InputError("Drive/Layout/Centre distance from = " + text_of(layout.centre_distance_from) +
                     " finds the centre of one wheel, but all of Drive/Wheels have one; choose "
                     "given, or Centre in mm = auto for one of them.");
  for (std::size_t i = 0; i < wheels.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!wheels[i].moves && !wheels[j].moves)
        {
          const double least = 0.5 * (forms[i].outside_diameter + forms[j].outside_diameter);
          const double away  = wheels[i].centre.distance(wheels[j].centre);
          if (away <= least)
            throw InputError(overlap_of(sprockets, i, j, away, least));
        }
}

bool slack_rises(const Fitter &fitter, const double at)
{
  if (fitter.sprockets.size() == 2 || !fitter.moves())
    return false;
  const double h      = 0.02 * fitter.chain.seats.mean();
  const auto   before = fitter.fits(at - h, true, 1), after = fitter.fits(at + h, true, 1);
  return !before.empty() && !after.empty() &&
         after.front().laid.slack.slack > before.front().laid.slack.slack;
}

void check_loop(const std::vector<path::Wheel> &wheels)
{
  if (const double turns = turns_of(wheels); std::isfinite(turns) && std::abs(turns - 1.) > 1e-6)
    throw InputError(
        "Drive/Wheels/Order of travel: round these wheels the chain would cross itself; give them "
        "in the order of a counter-clockwise loop (that of Drive/Layout/Tight span = upper), those "
        "that the chain has on its right-hand side as Side = outside.");
}

unsigned int number_of_links(const parameters::Drive &drive)
{
  parameters::Chain chain          = drive.chain;
  chain.elongation                 = 0.;
  const ChainDimensions dimensions = make_chain(chain);
  const double          pitch      = dimensions.loaded_pitch();
  const double          c          = drive.layout.centre_distance;
  Fitter                fitter;
  fitter.sprockets                      = wheels_of(drive.sprockets, dimensions);
  fitter.chain.seats                    = {pitch, pitch};
  const std::vector<path::Wheel> wheels = fitter.wheels(c);
  finds_one(drive.sprockets, drive.layout, fitter);
  check_loop(wheels);
  const std::size_t n = wheels.size();
  for (std::size_t i = 0; i < n; ++i)
    {
      const path::Wheel &wheel = wheels[i], &after = wheels[(i + 1) % n];
      const double       far   = wheel.centre.distance(after.centre);
      const double       least = wheel.roller_radius + after.roller_radius;
      if (far <= least && n > 2)
        throw InputError(overlap_of(drive.sprockets, (i + 1) % n, i, far, least));
      if (far <= least)
        throw InputError(
            "Drive/Layout/Centre distance in mm = " + to_text(c * 1e3, 7) +
            ": the sprockets overlap; for Drive/Number of links = auto it must exceed " +
            at_least(least) + ".");
    }
  const double pairs = 0.5 * pitches_round(wheels, pitch);
  const bool   stay =
      drive.layout.centre_distance_from == parameters::CentreDistanceFrom::given || !fitter.moves();
  return 2 * static_cast<unsigned int>(stay ? std::ceil(pairs - 1e-9) : std::round(pairs));
}

std::string advised_links(const Fitter &fitter, const double missing, const bool even)
{
  const double wanted = fitter.chain.n_links + missing / fitter.chain.seats.mean();
  const double step   = even ? 2. : 1.;
  return std::to_string(static_cast<long>(
      step * (missing > 0. ? std::ceil(wanted / step - 1e-9) : std::floor(wanted / step + 1e-9))));
}

double missing_length(Fitter fitter, const double c)
{
  const unsigned int n     = fitter.chain.n_links;
  const double       pitch = fitter.chain.seats.mean();
  auto               taut  = fitter.fits(c, true, 1);
  if (taut.empty()) // it may be far too short
    {
      const double more = pitches_round(fitter.wheels(c), pitch) + 2. - n;
      if (!(more > 0.))
        return std::nan("");
      fitter.chain.n_links += 2 * static_cast<unsigned int>(std::ceil(0.5 * more));
      taut = fitter.fits(c, true, 1);
    }
  return taut.empty() ? std::nan("") :
                        (fitter.chain.n_links - n) * pitch - taut.front().laid.slack.slack;
}

std::string too_short(const Fitter &fitter, const double c, const bool even)
{
  const double      missing = missing_length(fitter, c);
  const std::string chain   = "a chain of " + std::to_string(fitter.chain.n_links) + " links ";
  if (!std::isfinite(missing))
    return chain + "closes on no route around the wheels where they are; choose other places.";
  return chain + "is " + in_mm(missing, 6) +
         " too short for the wheels where they are; choose other places, or at least " +
         advised_links(fitter, missing, even) + " links.";
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

  if (fitter.sprockets.size() > 2 && fitter.moves() && !is_given)
    return propose_near(fitter,
                        wanted(layout),
                        given,
                        "Drive/Layout/Centre distance from = " +
                            text_of(layout.centre_distance_from),
                        even);
  if (!fitter.moves() || fitter.sprockets.size() > 2)
    {
      if (!(missing_length(fitter, given) <= 1e-12))
        throw InputError("Drive/Wheels: " + too_short(fitter, given, even));
      return {{}, fitter.fits(given, false)};
    }

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
