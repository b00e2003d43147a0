// SPDX-License-Identifier: LGPL-2.1-or-later
// Rings of lumped rollers roll: a chain 16A on 11 and 33 teeth with the friction 0.3 loses by it
// what it loses in the layered model, whose rings are free on their bushes, and the slack span is
// as tight as without friction.
#include "../support/ranges.h"

#include <deal.II/base/mpi.h>

using namespace chaindrive;

namespace
{
nlohmann::json start(const std::vector<std::string> &more)
{
  std::vector<std::string> overrides = {"Drive/Chain/Designation=16A",
                                        "Drive/Driver teeth=11",
                                        "Drive/Driven teeth=33",
                                        "Drive/Number of links=90",
                                        "Contact/Friction coefficient=0.3",
                                        // rollers roll on soft seats, on stiff ones they bounce
                                        "Contact/Roller-tooth stiffness in N/m=3e7",
                                        "Contact/Roller-bush friction=0",
                                        "Contact/Bush-pin friction=0",
                                        "Time/End time in ms=12"};
  overrides.insert(overrides.end(), more.begin(), more.end());
  return test::run("prm/verification/hard.prm", overrides);
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const nlohmann::json lumped = start({}), smooth = start({"Contact/Friction coefficient=0"}),
                       layered = start({"Model/Fidelity=layered"});
  const auto loss              = [](const nlohmann::json &s) {
    return s["energy"]["friction_loss"].get<double>() / s["drive_work"].get<double>();
  };
  test::range("part of the drive work that friction takes, lumped over layered rollers",
              loss(lumped) / loss(layered),
              0.7,
              1.4);
  test::range("slack tension with friction over that without",
              lumped["slack_tension_mean"].get<double>() /
                  smooth["slack_tension_mean"].get<double>(),
              0.9,
              1.1);
}
