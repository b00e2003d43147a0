// SPDX-License-Identifier: LGPL-2.1-or-later

// Speed ratio of a rigid straight span on 15 and 42 teeth, pitch 15.875 mm: its mean is z1/z2, it
// is the derivative of the driven by the driver angle, its ripple depends on how far the span is
// from a whole number of pitches (expected values from an independent script).

#include "compare.h"

#include <chaindrive/drive/four_bar.h>
#include <chaindrive/path/span.h>

#include <algorithm>
#include <numeric>

int main()
{
  const auto ripple = [](const std::vector<double> &r) {
    return *std::max_element(r.begin(), r.end()) - *std::min_element(r.begin(), r.end());
  };
  for (const auto &[distance, expected] :
       {std::pair<double, double>{643.29, 2.263}, {642.5, 2.201}, {638.8, 1.930}, {630.8, 2.479}})
    {
      const auto   r = chaindrive::drive::four_bar_ratios(distance * 1e-3, 15.875e-3, 15, 42, 2000);
      const double mean = std::accumulate(r.begin(), r.end(), 0.) / r.size();
      std::cout << "C = " << std::fixed << std::setprecision(2) << distance << " mm\n";
      compare("mean over 15/42", mean * 42. / 15., 1., 6);
      compare("peak to peak over the mean, percent", 100. * ripple(r) / mean, expected, 3);
    }

  using namespace chaindrive::path;
  const LinkLengths lengths{15.875e-3, 15.875e-3};
  const Wheel       driver(15, dealii::Point<2>(), lengths);
  const Wheel       driven(42, dealii::Point<2>(0.6425, 0.), lengths);
  double            worst = 0.;
  for (const double phase : {0.1, 0.3, 0.5, 0.9})
    {
      const double d    = 1e-4;
      const auto   span = [&](const double at) {
        return taut_spans(driven, driver, lengths, 110, entries_near_tangent(driven, driver, at))
            .front();
      };
      const auto   before = span(phase - d), after = span(phase + d);
      const double slope = (after.exit - before.exit) / (2. * d * driver.pitch_angle);
      worst              = std::max(
          worst,
          std::abs(slope / chaindrive::drive::four_bar_ratio(0.6425, 15.875e-3, 15, 42, phase) -
                   1.));
    }
  verdict("difference quotient of the driven angle within 1e-8", worst < 1e-8);

  std::cout << "equal sprockets, a whole number of pitches apart: no ripple\n";
  const auto r = chaindrive::drive::four_bar_ratios(40 * 15.875e-3, 15.875e-3, 20, 20, 100);
  verdict("ripple below 1e-12", ripple(r) < 1e-12);
}
