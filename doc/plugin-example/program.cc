// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/model/reading.h>
#include <chaindrive/simulation.h>

#include <deal.II/base/mpi.h>

#include <iostream>

// A program with the library of chaindrive: the speed of a small drive, without any file.

int main(int argc, char **argv)
{
  using namespace chaindrive;
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const Parameters parameters = model::read_entries({{"Drive/Chain/Designation", "12A"},
                                                     {"Drive/Number of links", "76"},
                                                     {"Drive/Driver teeth", "11"},
                                                     {"Drive/Driven teeth", "23"},
                                                     {"Drive/Layout/Start", "settled"},
                                                     {"Model/Fidelity", "simple"},
                                                     {"Time/End time in ms", "10"},
                                                     {"Output/Window start in ms", "0"}})
                                    .parameters;
  Simulation simulation(parameters, {"."}, MPI_COMM_SELF);
  simulation.run();
  std::cout << simulation.summary().values["driven_speed_mean"] << " rad/s\n";
}
