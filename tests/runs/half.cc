// SPDX-License-Identifier: LGPL-2.1-or-later
// A symmetry model gives what the whole one gives, forces and energies of whole bodies: a short
// chain brought to speed, all of its links elastic, only those that arrive, beside rigid ones, or
// all of them reduced, whole ones with more modes. Both sum the same forces in another order.
#include "../support/ranges.h"
#include "../support/small_drive.h"

#include <deal.II/base/mpi.h>

namespace
{
nlohmann::json
small(const std::string &half, const std::string &fidelity, const std::string &elastic)
{
  return test::run("prm/paper/layered-auto.prm",
                   test::small_full_drive_with({"Model/Symmetry model=" + half,
                                                "Model/Fidelity=" + fidelity,
                                                "Model/Elastic links=" + elastic,
                                                std::string("Time/Time step in us=") +
                                                    (fidelity == "full" ? "0.09" : "0.2"),
                                                "Loads/Ramp time in ms=0.2",
                                                "Time/End time in ms=0.4",
                                                "Output/Window start in ms=0.2",
                                                "Output/Field interval in ms=0"}));
}

void compare(const std::string &fidelity, const std::string &elastic)
{
  std::cout << fidelity << ", elastic links: " << elastic << std::endl;
  const nlohmann::json whole = small("false", fidelity, elastic),
                       half  = small("true", fidelity, elastic);

  const auto ratio = [](const nlohmann::json &a, const nlohmann::json &b) {
    return a.get<double>() / b.get<double>();
  };
  for (const std::string name :
       {"driven_angle_end", "driver_torque_mean", "drive_work", "resisting_work"})
    test::range(name + ", half over whole", ratio(half[name], whole[name]), 0.99999, 1.00001);
  for (const std::string name : {"kinetic", "strain"})
    test::range(name + " energy, half over whole",
                ratio(half["energy"][name], whole["energy"][name]),
                0.99999,
                1.00001);
  test::range("energy imbalance / energy turned over", half["energy_imbalance_max"], 0., 1e-3);
  test::range("contacts missed by the searches", half["contacts_missed"], 0., 0.);
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  compare("full", "all");
  compare("full", "region of interest");
  compare("reduced", "all");
}
