// SPDX-License-Identifier: LGPL-2.1-or-later
// The paper's drive with the simple model: figures that any valid model gives, its start, which is
// nearly deterministic, and its engagements.
#include "../support/ranges.h"

int main()
{
  const auto s = test::run("prm/paper/simple.prm", {"Output/Field interval in ms=0"});
  test::paper_ranges(s, 1.180, 174.5);
  test::range("largest tight tension of the start (N)",
              s["tight_tension_max_start"],
              3900. * 0.85,
              3900. * 1.15);
  test::range("tight tension (N), by slack 0.5 mm", s["tight_tension_mean"], 1600., 1850.);
  test::engagement_ranges(s, 2e8, 10.7e-3);
  test::range("energy imbalance / drive work", s["energy_imbalance_max"], 0., 1e-3);
}
