// SPDX-License-Identifier: LGPL-2.1-or-later

// Ratings, fatigue and wear of chains: the table of Shigley's Mechanical Engineering Design, the
// table of strengths against the formula of Annex C of ISO 606, the example of ASTM E1049,
// Goodman's line, the bending of a pin by integration, wear by the work of a Coulomb joint.

#include <chaindrive/drive/catalogue.h>
#include <chaindrive/drive/life.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>

using namespace chaindrive::drive;

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

/// Cycles by range, half cycles counted as such.
std::map<double, double> counts(const std::vector<double> &history)
{
  std::map<double, double> found;
  for (const Cycle &cycle : rainflow(history))
    found[cycle.range] += cycle.count;
  return found;
}
} // namespace

int main()
{
  // Table 17-20 of Shigley, 17 teeth, horsepower
  struct Row
  {
    const char *chain;
    double      pitch, rpm, power;
  };
  for (const Row &row : {Row{"40", 12.7e-3, 50., 0.37},
                         Row{"40", 12.7e-3, 1200., 6.45},
                         Row{"60", 19.05e-3, 50., 1.24},
                         Row{"60", 19.05e-3, 1600., 14.8}})
    verdict(
        std::string("No. ") + row.chain + " at " + std::to_string(int(row.rpm)) + " rpm",
        near(ratings_of(row.chain, row.pitch, 17., row.rpm, 0.).power() / 745.7, row.power, 0.005));
  verdict("rollers last 15000 h at their rating",
          near(hours_of_rollers(5., 5., 100.), 15000., 1e-12));
  verdict("and 2^2.5 times as long at half of it",
          near(hours_of_rollers(5., 2.5, 100.), 15000. * std::sqrt(32.), 1e-12));

  // the standard's table and the standard's formula
  double worst = 0.;
  for (const auto *table : {&iso_a_chains(), &iso_b_chains()})
    for (const CatalogueChain &row : *table)
      if (const auto listed = minimum_dynamic_strength(row.designation))
        worst = std::max(worst,
                         std::abs(dynamic_strength_of_plates(row.pitch,
                                                             row.inner_plate_height,
                                                             row.inner_plate_thickness,
                                                             row.roller_diameter,
                                                             row.pin_diameter) /
                                      *listed -
                                  1.));
      else
        std::cout << row.designation << " is not in the table of strengths\n";
  std::cout << "table of strengths and its formula differ by " << std::lround(100. * worst)
            << " %\n";
  verdict("ANSI sizes have the values of ISO sizes",
          minimum_dynamic_strength("50") == minimum_dynamic_strength("10A"));
  verdict("heavy chains endure up to 1.2 times as much", [] {
    bool so = true;
    for (const char *size : {"60", "80", "100", "120", "140", "160", "180", "200", "240"})
      {
        const double more =
            *minimum_dynamic_strength(std::string(size) + "H") / *minimum_dynamic_strength(size);
        so = so && more > 1. && more < 1.2;
      }
    return so;
  }());
  verdict("motorcycle chains have none", !minimum_dynamic_strength("525"));

  // ASTM E1049-85, Fig. 6: ranges 3, 4, 6, 8, 9 are counted 0.5, 1.5, 0.5, 1, 0.5 times
  const std::vector<double>      astm     = {-2., 1., -3., 5., -1., 3., -4., 4., -2.};
  const std::map<double, double> expected = {{3., 0.5}, {4., 1.5}, {6., 0.5}, {8., 1.}, {9., 0.5}};
  verdict("rainflow counts of ASTM E1049", counts(astm) == expected);
  std::vector<double> fine; // with values between turning points, some of them twice
  for (std::size_t i = 0; i + 1 < astm.size(); ++i)
    for (const double x : {0., 0.3, 0.3, 0.8})
      fine.push_back(astm[i] + x * (astm[i + 1] - astm[i]));
  fine.push_back(astm.back());
  verdict("the same between turning points", counts(fine) == expected);
  verdict("a sine of n periods has n cycles", [] {
    std::vector<double> sine;
    for (int i = 0; i <= 700; ++i)
      sine.push_back(std::sin(0.02 * M_PI * i));
    double sum = 0.;
    for (const Cycle &cycle : rainflow(sine))
      sum += cycle.range > 1.99 ? cycle.count : 0.;
    return sum == 6.5; // from the first crest to the last trough, and what is before and after
  }());
  verdict("nothing of a constant", rainflow({1., 1., 1.}).empty() && rainflow({}).empty());

  // the same history again and again: ASTM E1049-85, Fig. 7, wherever it begins
  std::map<double, double> repeated;
  for (const Cycle &cycle : rainflow_of_turn({-2., 1., -3., 5., -1., 3., -4., 4.}))
    repeated[cycle.range] += cycle.count;
  verdict("repeating history of ASTM E1049, Fig. 7: 3, 4, 7 and 9",
          repeated == std::map<double, double>{{3., 1.}, {4., 1.}, {7., 1.}, {9., 1.}});
  bool same = true;
  for (int first = 0; first < 8; ++first)
    {
      std::vector<double> turn = {-2., 1., -3., 5., -1., 3., -4., 4.};
      std::rotate(turn.begin(), turn.begin() + first, turn.end());
      std::map<double, double> found;
      for (const Cycle &cycle : rainflow_of_turn(turn))
        found[cycle.range] += cycle.count;
      same = same && found == repeated;
    }
  verdict("wherever a turn begins", same && rainflow_of_turn({}).empty());

  // Goodman: F_max = F_d + F_min (F_u - F_d) / F_u
  const PlateFatigue plates{3850., 21800.};
  verdict("dynamic strength: 3e6 cycles", near(plates.cycles(0., 3850.), 3e6, 1e-12));
  verdict("from a greater least force",
          near(plates.cycles(2000., 3850. + 2000. * (21800. - 3850.) / 21800.), 3e6, 1e-9));
  verdict("endless below 1e7 cycles",
          near(plates.cycles(0., 1.0001 * plates.endurance()), 1e7, 0.01) &&
              plates.cycles(0., 0.9999 * plates.endurance()) == endless);
  verdict("Miner: one cycle and a half a turn",
          near(turns_of(plates, {{5000., 2500., 1.}, {5000., 2500., 0.5}}),
               plates.cycles(0., 5000.) / 1.5,
               1e-12));

  verdict("two deviations are a tenth of the force, a factor of 2.87 in cycles",
          near(plates.weaker(2.).cycles(0., 5000.) * std::pow(0.9, -10.),
               plates.cycles(0., 5000.),
               1e-12));

  // impacts: 15,000 hours at the rated power with equal peaks; as the power where a roller has its
  // force from the power alone; hardly by it where the force is of impacts
  verdict("peaks at the rated power",
          near(life_of_peaks({900., 900.}, 400., 1., 100.).hours, 15000., 1e-12));
  verdict("half of the rated power, without impacts",
          near(life_of_peaks({400., 400.}, 400., 2., 100.).hours, 15000. * std::sqrt(32.), 1e-12));
  verdict(
      "and with impacts of the same size",
      near(life_of_peaks({800., 800.}, 400., 2., 100.).hours, 15000. * std::pow(1.5, 2.5), 1e-12));
  verdict("peaks that scatter do more",
          near(life_of_peaks({600., 1200.}, 400., 1., 100.).hours,
               15000. * 2. / (std::pow(600. / 900., 2.5) + std::pow(1200. / 900., 2.5)),
               1e-12));
  verdict("above the rated power as the power",
          near(life_of_peaks({900., 900.}, 400., 0.5, 100.).hours, 15000. / std::sqrt(32.), 1e-12));
  verdict("without peaks", life_of_peaks({}, 400., 2., 100.).hours == endless);
  // Binder: forces on the first roller of 6 teeth with a pressure angle of 15 degrees
  verdict(
      "force of the first roller",
      near(seat_force(1000., 6.), 1000. * std::sqrt(0.75) / std::sin(75. * M_PI / 180.), 1e-12));

  // a joint under a constant force: friction work mu F r angle at each turn
  const JointWear joints{15.875e-3, 5.08e-3, 70e-6, 120.};
  const double    angle_force = 1590. * 0.44, pitches = 300., mu = 0.1;
  const double    watts = mu * angle_force * 0.5 * joints.pin_diameter * pitches;
  verdict("wear of tensions is that of their friction",
          near(joints.rate_of_losses(watts, mu), joints.rate(angle_force, pitches), 1e-12));
  const double hours = 0.03 / joints.rate(angle_force, pitches) / 3600.;
  // k F/A r angle of each of v t / (X p) turns is 3 % of a pitch
  verdict("hours by hand",
          near(hours,
               0.03 * 15.875e-3 / (1e-16 * angle_force / 70e-6 * 2.54e-3) * 120. / 300. / 3600.,
               1e-12));
  verdict("without oil",
          near(wear_factor(Lubrication::none, Lubrication::bath, 5.) * 0.15, 1., 1e-12) &&
              wear_factor(Lubrication::forced, Lubrication::bath, 5.) == 1. &&
              near(wear_factor(Lubrication::drip, Lubrication::bath, 5.), 1. / 0.3, 1e-12));
  verdict("lubrication at the speeds of B29.1",
          least_lubrication(12.7e-3, 1.51) == Lubrication::manual &&
              least_lubrication(12.7e-3, 1.54) == Lubrication::drip &&
              least_lubrication(50.8e-3, 5.07) == Lubrication::bath &&
              least_lubrication(50.8e-3, 5.09) == Lubrication::forced);

  // moment of a pin: reactions F/2 at its ends, F spread over the bush
  const double d = 5.08e-3, l = 15.4e-3, b = 11.2e-3, F = 2000.;
  double       moment = 0.5 * F * 0.5 * l;
  for (int i = 0; i < 1000; ++i)
    moment -= F / b * (0.5 * b / 1000.) * (0.5 * b * (i + 0.5) / 1000.);
  verdict("bending of a pin",
          near(pin_stress(F, d, 0., l, b).bending, 32. * moment / (M_PI * d * d * d), 1e-6));
  verdict("hole of half the height: 2.5 times the net stress",
          near(plate_stress(F, 10e-3, 7e-3, 5e-3, 2e-3).hole /
                   plate_stress(F, 10e-3, 7e-3, 5e-3, 2e-3).net,
               2.5,
               0.01));
}
