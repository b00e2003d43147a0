// SPDX-License-Identifier: LGPL-2.1-or-later
// The small drive of full.cc of which only the links that arrive at the driver are elastic, or
// deform by modes, all others rigid: energy closes, the driver turns the driven sprocket as
// prescribed, the chain pulls the load round, and neither search has missed a contact. Where
// elastic links hang on rigid ones the tension differs from one link to the next by what it does
// elsewhere in the spans.
#include "../support/small_drive.h"
#include "../support/table.h"

#include <deal.II/base/mpi.h>

#include <cmath>

namespace
{
constexpr unsigned int n_links = 22;

/// Root mean square of the differences of tension [N] between the links on both sides of joint k.
std::vector<double> steps_of_tension()
{
  const test::Table   links("results/histories_links.csv");
  std::vector<double> steps;
  for (unsigned int k = 0; k < n_links; ++k)
    {
      const unsigned int         previous = (k + n_links - 1) % n_links;
      const std::vector<double> &before   = links["tension " + std::to_string(previous)];
      const std::vector<double> &after    = links["tension " + std::to_string(k)];
      double                     square   = 0.;
      for (std::size_t i = before.size() / 3; i < before.size(); ++i)
        square += (after[i] - before[i]) * (after[i] - before[i]);
      steps.push_back(std::sqrt(square / before.size()));
    }
  return steps;
}

/// Runs the drive with what elastic links of @p fidelity are.
void arrive(const std::string &fidelity)
{
  std::cout << fidelity << std::endl;
  const nlohmann::json s = test::start_small_full_drive(
      {"Model/Fidelity=" + fidelity, "Model/Elastic links=region of interest"});
  test::range("strain energy over that of pull", test::strain_over_pull(), 1., 1.5);
  test::range("contacts missed by the searches", s["contacts_missed"], 0., 0.);

  // from 18 to 3 elastic; 0 to 2 and 13 to 15 sit on the sprockets or next to them
  const std::vector<double> steps = steps_of_tension();
  double                    mean  = 0.;
  for (const unsigned int k : {4, 5, 6, 7, 8, 9, 10, 11, 12, 16, 17, 19, 20, 21})
    mean += steps[k] / 14.;
  test::range(
      "step of tension at the first elastic joint over that elsewhere", steps[18] / mean, 0.5, 2.);
  test::range(
      "step of tension at the last elastic joint over that elsewhere", steps[3] / mean, 0.5, 2.);
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  arrive("full");
  arrive("reduced");
}
