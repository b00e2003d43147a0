// SPDX-License-Identifier: LGPL-2.1-or-later
// The paper's drive with the layered model, joints taut at the start.
#include "../support/ranges.h"

int main()
{
  const auto s = test::run("prm/paper/layered.prm", {"Output/Field interval in ms=0"});
  test::paper_ranges(s, 1.155, 171.);
  test::range("slack tension (N)", s["slack_tension_mean"], 15., 70.);
  test::range("largest tight tension of the start (N)",
              s["tight_tension_max_start"],
              4200. * 0.85,
              4200. * 1.15);
  double peak = 0.;
  for (const auto &e : s["engagements"])
    if (e["sprocket"] == "driver" && e["complete"] && e["time"] >= s["window"]["start"])
      peak = std::max(peak, e["peak_force"].get<double>());
  test::range("largest peak force at the driver (N)", peak, 900., 1800.);
  const auto &loss = s["energy"];
  test::range("dissipated energy (J)",
              loss["friction_loss"].get<double>() + loss["contact_damping_loss"].get<double>(),
              1.8,
              6.9);
  test::range("energy imbalance / energy turned over", s["energy_imbalance_max"], 0., 5e-3);
}
