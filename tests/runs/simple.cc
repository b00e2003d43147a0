// SPDX-License-Identifier: LGPL-2.1-or-later
// The paper's drive with the simple model: figures that any valid model gives, its start, which is
// nearly deterministic, and its engagements.
#include "../support/ranges.h"

#include <deal.II/base/mpi.h>

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const auto s = test::run("prm/paper/simple.prm", {"Output/Field interval in ms=0"});
  test::paper_ranges(s, 1.180, 174.5);
  test::range("largest tight tension of the start (N)",
              s["tight_tension_max_start"],
              3900. * 0.85,
              3900. * 1.15);
  test::range("tight tension (N), by slack 0.5 mm", s["tight_tension_mean"], 1600., 1850.);
  test::engagement_ranges(s, 2e8, 10.7e-3);
  test::range("energy imbalance / energy turned over", s["energy_imbalance_max"], 0., 1e-3);

  // at five times the speed: 2 pi T / (z2 p) and z1 p w1 / (2 pi)
  const auto up = test::run("prm/verification/hard.prm",
                            {"Drive/Number of links=100",
                             "Drive/Driver teeth=57",
                             "Drive/Driven teeth=11",
                             "Loads/Driver speed in rad/s=25",
                             "Loads/Ramp time in ms=5",
                             "Loads/Resisting torque in N m=25",
                             "Time/End time in ms=40",
                             "Output/Window start in ms=20"});
  test::range("57/11: tight less slack tension / theory",
              (up["tight_tension_mean"].get<double>() - up["slack_tension_mean"].get<double>()) /
                  (2. * M_PI * 25. / (11. * 15.875e-3)),
              0.98,
              1.02);
  test::range("57/11: tight-span speed / theory",
              up["span_speed_mean"].get<double>() / (57. * 15.875e-3 * 25. / (2. * M_PI)),
              0.998,
              1.002);
}
