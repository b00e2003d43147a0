// SPDX-License-Identifier: LGPL-2.1-or-later
// Both models with masses, inertias and stiffnesses from the parts: figures that do not depend on
// them.
#include "../support/ranges.h"

#include <deal.II/base/mpi.h>

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  for (const std::string model : {"simple", "layered"})
    {
      std::cout << model << '\n';
      const auto s =
          test::run("prm/paper/" + model + "-auto.prm", {"Output/Field interval in ms=0"});
      test::range("driven speed (rad/s)", s["driven_speed_mean"], 42.9, 43.4);
      test::range("tight-span speed (m/s)", s["span_speed_mean"], 4.54, 4.62);
      test::range("pitch time (ms)", 1e3 * s["pitch_time_mean"].get<double>(), 3.36, 3.62);
      test::range("tight less slack tension (N)",
                  s["tight_tension_mean"].get<double>() - s["slack_tension_mean"].get<double>(),
                  1340.,
                  1460.);
      test::range("energy imbalance / energy turned over",
                  s["energy_imbalance_max"],
                  0.,
                  model == "simple" ? 1e-3 : 5e-3);
    }
}
