// SPDX-License-Identifier: LGPL-2.1-or-later
// A chain with much slack and four times the load jumps over teeth. The summary says so, and how
// many it says are those by which the driven sprocket has fallen behind the driver; the drive as it
// is has no events.
#include "../support/ranges.h"

#include <deal.II/base/mpi.h>

#include <cmath>

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const auto                                     s = test::run("prm/paper/simple.prm",
                           {"Drive/Layout/Centre distance from=slack",
                                                                "Drive/Layout/Slack in mm=70",
                                                                "Loads/Resisting torque in N m=600",
                                                                "Time/End time in ms=40",
                                                                "Output/Window start in ms=8",
                                                                "Output/Field interval in ms=0"});
  // 15 and 42 teeth; the driver gains speed linearly for 5 ms
  const double driver = 15. / (2. * M_PI) * 120.74 * (40e-3 - 2.5e-3);
  const double driven = 42. / (2. * M_PI) * s["driven_angle_end"].get<double>();
  double       teeth = 0., ahead = 0., broken = 0.;
  bool         in_window = false;
  for (const auto &event : s["events"])
    if (event["kind"] == "above breaking")
      broken = event["amount"];
    else if (event["kind"] == "jumped")
      {
        teeth += event["amount"].get<double>();
        ahead += (event["sprocket"] == "driver" ? 1. : -1.) * event["ahead"].get<double>();
        in_window = in_window || event["in_window"].get<bool>();
      }
  test::range("teeth jumped", teeth, 1., 4.);
  // the chain swings on the teeth by some half a pitch
  test::range("teeth by which the driven sprocket is ahead", driven - driver, -4.7, -0.3);
  test::range("the same less those by which the chain jumped", driven - driver - ahead, -0.7, 0.7);
  test::range("largest tension (N), where the chain breaks at 26500 N", broken, 26500., 1e5);
  test::range("window is valid", s["window"]["valid"].get<bool>() ? 1. : 0., 0., 0.);
  test::range("the chain jumped in the window", in_window ? 1. : 0., 1., 1.);

  const auto sound = test::run("prm/paper/simple.prm", {"Output/Field interval in ms=0"});
  test::range("events of the drive as it is", sound["events"].size(), 0., 0.);
  test::range("window is valid", sound["window"]["valid"].get<bool>() ? 1. : 0., 1., 1.);
}
