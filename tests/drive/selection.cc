// SPDX-License-Identifier: LGPL-2.1-or-later

// The choice of a chain: an example of Bhandari's Design of Machine Elements (14.3, as solved in
// the FOSSEE collection), the first of the list, what is refused, and how figures follow from the
// demand.

#include <chaindrive/drive/selection.h>
#include <chaindrive/utilities/errors.h>

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace chaindrive;
using namespace drive;

namespace
{
void verdict(const std::string &what, const bool holds)
{
  std::cout << what << ": " << (holds ? "yes" : "NO") << '\n';
}

bool near(const double value, const double expected, const double share)
{
  return std::abs(value / expected - 1.) < share;
}

/// 5 kW at 1400 rpm, 3 to 1, 500 mm, an electric motor and moderate shock.
Demand example()
{
  Demand demand{};
  demand.power           = 5e3;
  demand.speed           = 1400. * M_PI / 30.;
  demand.ratio           = 3.;
  demand.centre_distance = 0.5;
  demand.shock           = Shock::moderate;
  return demand;
}

void refused(Demand demand)
{
  try
    {
      select_drives(demand);
      std::cout << "NO\n";
    }
  catch (const InputError &error)
    {
      std::cout << error.what() << '\n';
    }
}
} // namespace

int main()
{
  const auto      all   = select_drives(example());
  const Candidate first = all.front();
  std::cout << first.chain << '-' << first.strands << ' ' << first.driver_teeth << '/'
            << first.driven_teeth << ' ' << first.links << " links, "
            << std::lround(1e4 * first.centre_distance) / 10. << " mm\n"; // 08A, 21/63, 122, 500.80
  verdict("service factor 1.3", service_factor(Motor::electric, Shock::moderate) == 1.3);
  verdict("those without faults come first",
          std::is_partitioned(
              all.begin(), all.end(), [](const Candidate &c) { return c.faults.empty(); }));
  verdict(
      "they carry the power and last", std::all_of(all.begin(), all.end(), [](const Candidate &c) {
        return !c.faults.empty() || (c.capacity >= 1. && c.hours() >= 15000. && c.breaking >= 7.);
      }));

  Demand smooth = example();
  smooth.power *= 1.3;
  smooth.shock       = Shock::smooth;
  const auto   same  = select_drives(smooth);
  unsigned int pairs = 0, equal = 0; // where the same sprockets are the best
  for (const Candidate &c : all)
    for (const Candidate &other : same)
      if (c.chain == other.chain && c.strands == other.strands &&
          c.driver_teeth == other.driver_teeth)
        {
          ++pairs;
          equal += near(c.capacity, other.capacity, 1e-12) ? 1 : 0;
        }
  verdict("the factor is one on the power", pairs > 10 && equal == pairs);

  Demand dry      = example();
  dry.lubrication = Lubrication::manual;
  const auto less = select_drives(dry);
  verdict("too little oil is a fault of each",
          std::none_of(less.begin(), less.end(), [](const Candidate &c) {
            return c.faults.empty() && c.lubrication > Lubrication::manual;
          }));

  Demand up = example();
  up.ratio  = 1. / 3.;
  up.speed /= 3.;
  const Candidate faster = select_drives(up).front();
  verdict("a drive to greater speed is the same the other way round",
          faster.driver_teeth == first.driven_teeth && faster.driven_teeth == first.driver_teeth &&
              near(faster.wear_hours, first.wear_hours, 1e-9));

  // RS80, 16 teeth, 123 rpm: 57 dB(A); twice the speed has eight times the power
  const double w = 123. * M_PI / 30., v = impact_speed(25.4e-3, 16., w);
  verdict("speed of impact after Binder and Covert",
          near(v, 25.4e-3 * w * std::sin((27.5 + 22.5) * M_PI / 180.), 1e-12));
  verdict("level of Tsubaki's guide",
          near(sound_estimate(2.515 * 25.4e-3, {v, v}, 16. * w / (2. * M_PI)), 57., 1e-12));
  verdict("9 dB for twice the speed",
          near(sound_estimate(2.515 * 25.4e-3, {2. * v, 2. * v}, 32. * w / (2. * M_PI)),
               57. + 10. * std::log10(8.),
               1e-12));

  Demand bad = example();
  bad.power  = -1.;
  refused(bad);
  bad       = example();
  bad.ratio = 11.;
  refused(bad);
  bad         = example();
  bad.strands = 7;
  refused(bad);
  bad       = example();
  bad.hours = std::nan("");
  refused(bad);
}
