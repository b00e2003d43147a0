// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/command_line.h>
#include <chaindrive/parameters/reader.h>
#include <chaindrive/simulation.h>
#include <chaindrive/utilities/errors.h>

#include <deal.II/base/mpi.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <thread>

namespace
{
/// Runs what the command line asks for on this rank. Exit status: 0 done, 2 input that cannot be
/// run, 3 a run that failed.
int run(const int argc, char **argv)
{
  using namespace chaindrive;
  try
    {
      const CommandLine command_line = parse_command_line(argc, argv);
      if (command_line.help)
        std::cout << help_text();
      else if (command_line.version)
        std::cout << version_text();
      else if (command_line.write_parameters)
        parameters::write_template(std::cout);
      else if (command_line.write_documentation)
        std::cout << parameters::parameter_documentation();
      else
        simulate(command_line);
      return 0;
    }
  catch (const InputError &error)
    {
      std::cerr << "chaindrive: " << error.what() << std::endl;
      return 2;
    }
  catch (const std::exception &error)
    {
      std::cerr << "chaindrive: " << error.what() << std::endl;
      return 3;
    }
}

/// Waits, without burning the processor, for the exit status of the rank that computes.
int share_status(int status, const MPI_Comm comm)
{
  MPI_Request request;
  MPI_Ibcast(&status, 1, MPI_INT, 0, comm, &request);
  int done = 0;
  for (MPI_Test(&request, &done, MPI_STATUS_IGNORE); !done;
       MPI_Test(&request, &done, MPI_STATUS_IGNORE))
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  return status;
}
} // namespace

int main(int argc, char **argv)
{
  // A program that was not started by mpirun needs no daemon to talk to other ranks: without it
  // OpenMPI starts a second earlier. Under mpirun the variable is not looked at.
  setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
  std::signal(SIGXFSZ, SIG_IGN); // a file at its size limit is a failed write, told in a sentence
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  // Lumped and rigid models are too small to be worth dealing out: the first rank computes them and
  // the others wait for its exit status.
  int        status  = 0;
  const bool is_root = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  if (is_root)
    status = run(argc, argv);
  return share_status(status, MPI_COMM_WORLD);
}
