// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/centre_distance.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace chaindrive::drive
{
namespace
{
/// Slack of the best route at @p travel, m; not a number where there is none.
double slack_at(const Fitter &fitter, const double travel)
{
  const auto best = fitter.fits(travel, true, 1);
  return best.empty() ? std::nan("") : best.front().laid.slack.slack;
}

/// A travel in the unit of its entry.
std::string in_words(const Tensioner &tensioner, const double travel)
{
  return tensioner.is_arm() ? to_text(travel * 180. / dealii::numbers::PI, 4) + " degrees" :
                              in_mm(travel, 4);
}
} // namespace

void set_tensioner(const parameters::Drive &drive, Fitter &fitter)
{
  constexpr double               least_gain = 0.02; // slack taken up over the way of the wheel
  const std::vector<path::Wheel> wheels     = fitter.wheels(drive.layout.centre_distance);
  for (std::size_t i = 0; i < wheels.size(); ++i)
    {
      fitter.sprockets[i].centre = wheels[i].centre;
      fitter.sprockets[i].moves  = false;
    }
  fitter.rises            = false;
  fitter.tensioner        = make_tensioner(drive, false);
  const double      way   = 0.02 * fitter.chain.seats.mean();
  const double      h     = way / fitter.tensioner->lever();
  const std::string wheel = drive.sprockets.list[fitter.tensioner->wheel].name;
  if (!may_be(fitter, 0.))
    throw InputError("Drive/Wheels/" + wheel +
                     "/Centre in mm: wheels overlap with the tensioner there, or the chain would "
                     "cross itself; choose another place.");
  const double gain = (slack_at(fitter, -h) - slack_at(fitter, h)) / (2. * way);
  if (!(std::abs(gain) > least_gain))
    throw InputError("Drive/Wheels/" + wheel + "/Held by = " + text_of(fitter.tensioner->holder) +
                     " moves the wheel along the chain, so that it takes up " + to_text(gain, 3) +
                     " of its way as slack; choose another " +
                     (fitter.tensioner->is_arm() ? "Pivot in mm" : "Direction in degrees") +
                     ", with which this is at least " + to_text(least_gain) + ".");
  fitter.tensioner = make_tensioner(drive, gain < 0.);
}

Proposal take_up(const Fitter &fitter, const std::string &wheel, const bool even)
{
  const Tensioner &tensioner = *fitter.tensioner;
  const double     most = tensioner.law.most, least = tensioner.law.least;
  const double     from  = std::clamp(0., least, most);
  const double     first = slack_at(fitter, from);
  const int        way   = first > 0. ? 1 : -1; // takes up slack, or lets go of some
  double near = from, far = from, step = 0.1 * fitter.chain.seats.mean() / tensioner.lever();
  for (double now = first; way * now > 0.; step *= 1.3)
    {
      const std::string the_chain =
          "Drive/Wheels/" + wheel + ": a chain of " + std::to_string(fitter.chain.n_links) +
          " links is " + in_mm(std::abs(now), 4) + " too " + (way > 0 ? "long" : "short") +
          " for the tensioner, whose travel is ";
      const std::string advice = "; choose another place of the wheel, or " +
                                 advised_links(fitter, -now, even) + " links.";
      if (far == (way > 0 ? most : least))
        {
          if (way > 0) // it rests on its stop, and the chain is slack
            return {{}, fitter.fits(most, false)};
          throw InputError(the_chain + "the least one, " + in_words(tensioner, least) + advice);
        }
      near                  = far;
      const double now_near = now;
      far                   = std::clamp(far + way * step, least, most);
      now                   = may_be(fitter, far) ? slack_at(fitter, far) : std::nan("");
      if (!std::isfinite(now) || way * (now_near - now) < 0.)
        throw InputError(the_chain + in_words(tensioner, near) +
                         ", beyond which wheels meet, the chain crosses itself or travel takes up "
                         "no more" +
                         advice);
    }
  const Fitter::Target straight{Fitter::Target::Kind::slack, 0.};
  return {straight,
          fitter.fits(fitter.solve(straight, std::min(near, far), std::max(near, far)), false)};
}
} // namespace chaindrive::drive
