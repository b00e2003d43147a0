// SPDX-License-Identifier: LGPL-2.1-or-later
// Chains round two, three and five wheels, some of which they touch from outside: every link has
// its length, joints lie on their wheels and outside of all others, the chain turns once in all,
// and at no wheel by more than a pitch angle or the wrong way. In a mirror it is laid as its image.
#include <chaindrive/path/route.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

using namespace chaindrive::path;
using dealii::Point;
using dealii::numbers::PI;

namespace
{
constexpr LinkLengths lengths{12.66e-3, 12.74e-3}, even{12.7e-3, 12.7e-3};

struct Case
{
  std::string        name;
  std::vector<Wheel> wheels;
};

double angle_of(const dealii::Tensor<1, 2> &v) { return std::atan2(v[1], v[0]); }

/// The number of links, even, with which span 0 has the least slack that is not negative.
unsigned int links_for(const std::vector<Wheel> &wheels, Chain chain)
{
  for (chain.n_links = 20; chain.n_links < 400; chain.n_links += 2)
    {
      const std::vector<Laid> all = lay_all(wheels, chain, true, 4);
      if (!all.empty() && all.front().misfit < 1e-9 && all.front().slack.slack >= 0.)
        return chain.n_links;
    }
  return 0;
}

/// The worst of what may not be, over start phases.
struct Worst
{
  double length = 0., seat = 0., inside = 0., turning = 0., misfit = 0., again = 0.;
  double straight = 0., least_slack = 1e9, most_slack = -1e9;
  bool   fits = true;
};

void examine(const std::vector<Wheel> &wheels, Chain chain, Worst &worst)
{
  const std::vector<Laid> all = lay_all(wheels, chain, false, 4);
  if (all.empty())
    {
      worst.fits = false;
      return;
    }
  const Laid              &laid = all.front();
  const std::vector<Joint> at   = joints(wheels, chain, laid);
  worst.fits                    = worst.fits && at.size() == chain.n_links;
  worst.misfit                  = std::max(worst.misfit, laid.misfit);
  const Laid   straight         = lay_all(wheels, chain, true, 4).front();
  const double slack            = straight.slack.slack;
  worst.straight                = std::max(worst.straight, straight.misfit);
  worst.least_slack             = std::min(worst.least_slack, slack);
  worst.most_slack              = std::max(worst.most_slack, slack);

  double turned = 0.;
  for (unsigned int k = 0; k < at.size(); ++k)
    {
      const Point<2> &a = at[k].bush, &b = at[(k + 1) % at.size()].bush,
                     &c = at[(k + 2) % at.size()].bush;
      worst.length      = std::max(worst.length, std::abs(a.distance(b) - chain.seats.of(k)));
      turned += std::remainder(angle_of(c - b) - angle_of(b - a), 2. * PI);
      for (unsigned int i = 0; i < wheels.size(); ++i)
        {
          const double away = a.distance(wheels[i].centre) - wheels[i].bush_radius;
          if (at[k].wheel == int(i))
            worst.seat = std::max(worst.seat, std::abs(away));
          else
            worst.inside = std::max(worst.inside, -away);
        }
    }
  worst.turning = std::max(worst.turning, std::abs(std::abs(turned) - 2. * PI));

  const auto again = lay(wheels, chain, laid.route);
  worst.again = std::max(worst.again, !again ? 1. : std::abs(again->slack.turn - laid.slack.turn));
}

void verdict(const std::string &what, const bool holds)
{
  std::cout << "  " << what << ": " << (holds ? "yes" : "NO") << '\n';
}

std::vector<Wheel> mirrored(std::vector<Wheel> wheels)
{
  for (Wheel &wheel : wheels)
    {
      wheel.turn      = -wheel.turn;
      wheel.centre[1] = -wheel.centre[1];
    }
  return wheels;
}
} // namespace

int main()
{
  const auto at = [](const double x, const double y) { return Point<2>(1e-3 * x, 1e-3 * y); };
  const std::vector<Case> cases = {
      {"two", {Wheel(19, at(0, 0), lengths), Wheel(38, at(400, 0), lengths)}},
      {"two, the other way round",
       {Wheel(38, at(0, 0), lengths), Wheel(17, at(-250, 90), lengths)}},
      {"three in a triangle",
       {Wheel(19, at(0, 0), lengths),
        Wheel(25, at(400, 50), lengths),
        Wheel(17, at(180, 300), lengths)}},
      {"an idler on the back of the straight span",
       {Wheel(19, at(0, 0), lengths),
        Wheel(38, at(420, 0), lengths),
        Wheel(13, at(200, 30), lengths, -1)}},
      {"an idler on the back of the slack span",
       {Wheel(19, at(0, 0), lengths),
        Wheel(13, at(200, -30), lengths, -1),
        Wheel(38, at(420, 0), lengths)}},
      {"a flat idler, inside",
       {Wheel(19, at(0, 0), lengths),
        Wheel(38, at(420, 0), lengths),
        Wheel::flat(30e-3, at(210, 140), lengths)}},
      {"five, two of them outside",
       {Wheel(21, at(0, 0), lengths),
        Wheel(13, at(180, -20), lengths, -1),
        Wheel(30, at(400, -40), lengths),
        Wheel(19, at(380, 260), lengths),
        Wheel::flat(25e-3, at(160, 150), lengths, -1)}},
  };
  for (const Case &c : cases)
    {
      Worst              worst;
      Chain              chain{0, lengths, lengths, lengths, 0., 1};
      const unsigned int n = links_for(c.wheels, chain);
      chain.n_links        = n + 2; // slack in any phase
      double image         = 0.;
      for (chain.phase = 0.; chain.phase < 0.999; chain.phase += 0.04)
        {
          examine(c.wheels, chain, worst);
          Chain other                 = chain;
          other.bulge                 = -chain.bulge;
          const std::vector<Laid> one = lay_all(c.wheels, chain, false, 4),
                                  two = lay_all(mirrored(c.wheels), other, false, 4);
          if (one.empty() || two.empty())
            {
              image = 1.;
              continue;
            }
          const std::vector<Joint> a = joints(c.wheels, chain, one.front()),
                                   b = joints(mirrored(c.wheels), other, two.front());
          for (unsigned int k = 0; k < std::min(a.size(), b.size()); ++k)
            image = std::max({image,
                              std::abs(a[k].bush[0] - b[k].bush[0]),
                              std::abs(a[k].bush[1] + b[k].bush[1])});
        }
      std::cout << c.name << ": " << n << " links\n";
      verdict("laid in every phase", worst.fits);
      verdict("links have their lengths to 1e-12 m", worst.length < 1e-12);
      verdict("joints lie on their wheels to 1e-12 m", worst.seat < 1e-12);
      // what hangs may bend by a tenth of a pitch angle the wrong way at a wheel outside of the
      // loop
      const bool inside =
          std::all_of(c.wheels.begin(), c.wheels.end(), [](const Wheel &w) { return w.turn > 0; });
      verdict(inside ? "and not in others" : "and not in others by more than 0.5 mm",
              worst.inside < (inside ? 1e-12 : 0.5e-3));
      verdict("it turns once to 1e-9", worst.turning < 1e-9);
      verdict("no misfit above 1e-9 where span 0 is straight", worst.straight < 1e-9);
      verdict(inside ? "nor where it hangs" : "nor one above 0.06 where it hangs",
              worst.misfit < (inside ? 1e-9 : 0.06));
      verdict("the slack varies by less than a tenth of a pitch",
              worst.most_slack - worst.least_slack < 1.3e-3);
      verdict("its route gives the same", worst.again < 1e-12);
      verdict("its image is laid in the mirror", image < 1e-9);
    }

  // what cannot be
  const Chain chain{60, even, even, even, 0.3, 1};
  verdict("one wheel within another: none",
          lay_all({Wheel(38, at(0, 0), even), Wheel(9, at(20, 0), even)}, chain, false, 4).empty());
  verdict("crossed spans of wheels that overlap: none",
          lay_all({Wheel(19, at(0, 0), even), Wheel(19, at(60, 0), even, -1)}, chain, false, 4)
              .empty());
}
