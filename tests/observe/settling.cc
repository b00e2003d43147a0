// SPDX-License-Identifier: LGPL-2.1-or-later
// When the window of the averages opens, after how many periods: on signals whose answer is known.
#include "../support/archive.h"

#include <chaindrive/observe/settling.h>

#include <cmath>
#include <functional>
#include <iostream>
#include <optional>
#include <random>

using namespace chaindrive;
using observe::Settling;

namespace
{
/// The period after which a signal of the mean 1 has settled; empty if it has not after 2000.
std::optional<unsigned int> opens(const std::function<double(unsigned int)> &mean)
{
  Settling settling;
  for (unsigned int period = 0; period < 2000; ++period)
    {
      settling.add({mean(period)}, {1.});
      if (settling.settled())
        return period + 1;
    }
  return {};
}

void show(const std::string &what, const std::function<double(unsigned int)> &mean)
{
  const auto period = opens(mean);
  std::cout << what << ": "
            << (period ? "after " + std::to_string(*period) + " periods" : std::string("never"))
            << std::endl;
}

double alternating(const unsigned int i) { return i % 2 == 0 ? 1. : -1.; }
} // namespace

int main()
{
  show("constant", [](unsigned int) { return 1.; });
  show("ripple of a period", [](const unsigned int i) { return 1. + 1e-14 * std::sin(7. * i); });
  show("ripple of two periods, 5 %",
       [](const unsigned int i) { return 1. + 0.05 * alternating(i); });

  // a drift that is there, without scatter: what is accepted is 0.5 % over six periods
  show("drift of 0.09 % per period", [](const unsigned int i) { return 1. + 9e-4 * i; });
  show("drift of 0.11 % per period", [](const unsigned int i) { return 1. + 11e-4 * i; });
  // and with some: 2 % per period is too much whatever the scatter
  show("drift of 0.2 %, ripple 0.1 %",
       [](const unsigned int i) { return 1. + 2e-3 * i + 1e-3 * alternating(i); });
  show("drift of 2 %, ripple 5 %",
       [](const unsigned int i) { return 1. + 0.02 * i + 0.05 * alternating(i); });

  // From the first to the last of six means a decay 0.4 exp(-i/3) falls by 0.5 % when for the first
  // 0.4 exp(-i/3) (1 - exp(-5/3)) = 0.005, i = 12.5: six periods later it is let pass. What is left
  // of it then is below 0.1 %. Ripple hides the end of it.
  const auto decay   = [](const unsigned int i) { return 1. + 0.4 * std::exp(-double(i) / 3.); };
  const auto rippled = [&](const unsigned int i) { return decay(i) + 0.01 * alternating(i); };
  for (const auto &[what, mean] :
       {std::pair<const char *, std::function<double(unsigned int)>>{"decay", decay},
        {"decay and ripple of 1 %", rippled}})
    {
      show(what, mean);
      const unsigned int begin = *opens(mean);
      double             error = 0.;
      for (unsigned int i = begin; i < begin + 10; ++i)
        error += 0.1 * (mean(i) - 1.);
      std::cout << "  error of the mean over ten periods below 1 %: "
                << (std::abs(error) < 0.01 ? "yes" : "NO") << std::endl;
    }

  // scatter without drift: most open at once, all soon
  std::mt19937 random(1);
  unsigned int at_once = 0, latest = 0;
  for (unsigned int run = 0; run < 500; ++run)
    {
      const auto scatter = [&random](unsigned int) {
        double sum = 0.;
        for (unsigned int j = 0; j < 12; ++j)
          sum += random() / 4294967296.;
        return 1. + 0.03 * (sum - 6.); // nearly normal, the same on all machines
      };
      const unsigned int period = *opens(scatter);
      at_once += period == Settling::n_periods ? 1 : 0;
      latest = std::max(latest, period);
    }
  std::cout << "scatter of 3 %, 500 times: at once in more than 80 %: "
            << (at_once > 400 ? "yes" : "NO")
            << ", after 30 periods at the latest: " << (latest <= 30 ? "yes" : "NO") << std::endl;

  // of two signals both must have settled
  Settling both;
  for (unsigned int i = 0; i < Settling::n_periods; ++i)
    both.add({1., 1. + 0.02 * i}, {1., 1.});
  std::cout << "one of two signals drifts: " << (both.settled() ? "settled" : "not settled")
            << std::endl;

  // a run that was interrupted forgets nothing
  unsigned int differ = 0;
  for (unsigned int stop = 1; stop < 20; ++stop)
    {
      Settling through, first, rest;
      for (unsigned int i = 0; i < 20; ++i)
        {
          through.add({rippled(i)}, {1.});
          (i < stop ? first : rest).add({rippled(i)}, {1.});
          if (i + 1 == stop)
            {
              test::Items items;
              first.serialize(test::writer(items));
              rest.serialize(test::reader(items));
            }
          if (i >= stop && rest.settled() != through.settled())
            ++differ;
        }
    }
  std::cout << "resumed runs that decide otherwise: " << differ << std::endl;
}
