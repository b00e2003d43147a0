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
using Target = Fitter::Target;

/// Excess of the best route at @p travel over the @p target; not a number where there is no route.
double excess_at(const Fitter &fitter, const Target &target, const double travel)
{
  const auto best = fitter.fits(travel, target.kind == Target::Kind::slack, 1);
  return best.empty() ? std::nan("") : Fitter::excess(best.front(), target);
}

/// Slack of the same with a straight slack span, m.
double slack_at(const Fitter &fitter, const double travel)
{
  return excess_at(fitter, {Target::Kind::slack, 0.}, travel);
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
  if (!std::isfinite(slack_at(fitter, 0.)))
    throw InputError("Drive/Wheels/" + wheel + ": " +
                     too_short(fitter, 0., drive.n_links % 2 == 0));
  const double gain = (slack_at(fitter, -h) - slack_at(fitter, h)) / (2. * way);
  if (!(std::abs(gain) > least_gain))
    throw InputError("Drive/Wheels/" + wheel + "/Held by = " + text_of(fitter.tensioner->holder) +
                     " moves the wheel along the chain, so that it takes up " + to_text(gain, 3) +
                     " of its way as slack; choose another " +
                     (fitter.tensioner->is_arm() ? "Pivot in mm" : "Direction in degrees") +
                     ", with which this is at least " + to_text(least_gain) + ".");
  fitter.tensioner = make_tensioner(drive, gain < 0.);
}

Proposal
take_up(const Fitter &fitter, const Target &target, const std::string &wheel, const bool even)
{
  const Tensioner &tensioner = *fitter.tensioner;
  const double     most = tensioner.law.most, least = tensioner.law.least;
  const double     from     = std::clamp(0., least, most);
  const bool       is_slack = target.kind == Target::Kind::slack;
  double           slack    = slack_at(fitter, from);
  const auto       excess   = [&](const double travel) { // where the slack is known
    return is_slack ? slack - target.value : excess_at(fitter, target, travel);
  };
  double    now = excess(from);
  const int way = now > 0. ? 1 : -1; // takes up slack, or lets go of some

  const auto refusal = [&](const std::string &travel) {
    const double missing  = (is_slack ? target.value : 0.) - slack;
    const bool   is_known = std::isfinite(missing);
    return InputError(
        "Drive/Wheels/" + wheel + ": a chain of " + std::to_string(fitter.chain.n_links) +
        " links is " + (is_known ? in_mm(std::abs(missing), 4) + " " : "") + "too " +
        (way > 0 ? "long" : "short") + " for the " +
        (tensioner.is_clamped() ? text_of(tensioner.holder) : "tensioner") + ", whose travel is " +
        travel + "; choose another place of the wheel" +
        (is_known ? ", or " + advised_links(fitter, missing, even) + " links" : "") + ".");
  };
  double near = from, far = from, step = 0.1 * fitter.chain.seats.mean() / tensioner.lever();
  for (; way * now > 0.; step *= 1.3)
    {
      if (far == (way > 0 ? most : least))
        {
          if (way > 0 && !tensioner.is_clamped()) // it rests on its stop, and the chain is slack
            return {{}, fitter.fits(most, false)};
          throw refusal(std::string("the ") + (way > 0 ? "greatest" : "least") + " one, " +
                        tensioner.with_unit(far));
        }
      near                = far;
      far                 = std::clamp(far + way * step, least, most);
      const double before = slack;
      const bool   may    = may_be(fitter, far);
      slack               = slack_at(fitter, far);
      now                 = may ? excess(far) : std::nan("");
      if (!std::isfinite(now) || way * (before - slack) < 0.)
        {
          slack = before; // that of the last travel that may be
          throw refusal(tensioner.with_unit(near) +
                        ", beyond which wheels meet, the chain crosses itself or travel takes up "
                        "no more");
        }
    }
  return {target,
          fitter.fits(fitter.solve(target, std::min(near, far), std::max(near, far)), false)};
}
} // namespace chaindrive::drive
