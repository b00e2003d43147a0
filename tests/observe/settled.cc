// SPDX-License-Identifier: LGPL-2.1-or-later
// A settled start is in balance from the first step on, in all fidelities: the chain pulls the
// driven sprocket with the load torque, the span carries the tension that belongs to it, less and
// less of it is left from tooth to tooth, and the tension stays what it is while nothing arrives.
// Elastic bodies hold the energy that pulls them, none of it as vibration. In lumped chains each
// joint has the acceleration of its motion: in spans none but that of gravity, on a sprocket that
// of its circle.
#include "../support/scenes.h"
#include "../support/small_drive.h"

#include <chaindrive/model/reading.h>
#include <chaindrive/observe/spans.h>
#include <chaindrive/simulation.h>

#include <algorithm>

using namespace test;

namespace
{
/// The least and the greatest of some values.
struct Extremes
{
  double least = 1e9, most = -1e9;

  bool empty() const { return least > most; }
  void add(const double value)
  {
    least = std::min(least, value);
    most  = std::max(most, value);
  }
  void within(const std::string &what, const double low, const double high) const
  {
    std::cout << "  " << what << " in [" << low << ", " << high << "]: "
              << (least >= low && most <= high ?
                      "yes" :
                      "NO, " + std::to_string(least) + " to " + std::to_string(most))
              << std::endl;
  }
};

/// What is left over of the forces on the joints of a lumped chain when those are taken off that
/// its motion needs, over the tension.
void add_unbalanced(const Simulation &simulation, Extremes &rest)
{
  const World &world  = simulation.system().world;
  const auto  &layout = simulation.drive.layout;
  for (unsigned int k = 0; k < layout.joints.size(); ++k)
    {
      Vector3 force;
      for (unsigned int d = 0; d < 3; ++d)
        force[d] = world.force.local_element(3 * k + d);
      if (const int i = layout.joints[k].sprocket; i >= 0)
        for (unsigned int d = 0; d < 2; ++d)
          force[d] += world.mass[k] * std::pow(layout.sprockets[i].speed, 2) *
                      (layout.joints[k].roller[d] - layout.sprockets[i].centre[d]);
      rest.add(force.norm() / simulation.drive.nominal_tension);
    }
}

/// @p accuracy of tension at the start and @p torque that may be left over, of the load's; @p
/// steady: by how much the tension may change in the first tenth of a millisecond.
void report(const std::string              &what,
            const std::vector<std::string> &overrides,
            const double                    accuracy,
            const double                    torque,
            const double                    steady)
{
  std::cout << what << std::endl;
  Extremes pull, left_over, tension, rise, rest, imbalance, vibration;
  for (const std::string phase : {"0.1", "0.7"})
    {
      std::vector<std::string> all = overrides;
      all.insert(all.end(),
                 {"Drive/Layout/Start=settled",
                  "Drive/Layout/Start phase=" + phase,
                  "Output/Field interval in ms=0",
                  "Output/Window start in ms=0"});
      const auto input = model::read_parameters(
          std::string(SOURCE_DIR) + "/../../prm/paper/layered-auto.prm", all);
      Simulation         simulation(input.parameters, {"."}, MPI_COMM_SELF);
      dynamics::System  &system = simulation.system();
      const unsigned int driven = simulation.scene.drive.driven().body;
      const double       load   = input.parameters.loads.resisting_torque;
      observe::Spans     spans(simulation.scene, system);
      spans.update(system);
      const double start = spans.tight().tension;
      pull.add((start - spans.slack().tension) / simulation.drive.nominal_tension);
      left_over.add(system.world.moment.local_element(3 * driven + 2) / load);
      for (unsigned int k = 0; k + 2 < simulation.drive.layout.sprockets[0].seats; ++k)
        rise.add((spans.link_tension()[k + 1] - spans.link_tension()[k]) / start);
      if (!simulation.scene.bars.empty())
        add_unbalanced(simulation, rest);

      const Ledger &ledger = system.world.ledger;
      const double  first  = ledger.stored() - ledger.kinetic - ledger.potential;
      const double  dt     = simulation.step.step;
      advance(system, static_cast<unsigned long>(1e-4 / dt), dt, [&] {
        spans.update(system);
        tension.add(spans.tight().tension / start);
        vibration.add((ledger.stored() - ledger.kinetic - ledger.potential) / first);
        imbalance.add(std::abs(ledger.imbalance()) / first);
      });
    }
  pull.within("tight less slack tension over that of the load", 1. - accuracy, 1. + accuracy);
  left_over.within("torque left over, over the load's", -torque, torque);
  rise.within("rise of tension from tooth to tooth over the span's", -1., 1e-3);
  if (!rest.empty())
    rest.within("force left over on a joint, over the tension", 0., 0.01);
  tension.within("tension over 0.1 ms, over that at the start", 1. - steady, 1. + steady);
  const double energy = std::max(steady, 0.02); // goes with the square of the tension
  vibration.within(
      "energy stored in links and contacts, over that at the start", 1. - energy, 1. + energy);
  imbalance.within("imbalance of the energy over it", 0., 1e-3);
}
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  report("simple, without friction",
         {"Model/Fidelity=simple", "Contact/Friction coefficient=0"},
         0.01,
         0.001,
         0.01);
  report("layered", {}, 0.01, 0.001, 0.01);
  const std::string held = "Loads/Driver speed in rad/s=0";
  report("simple, driver held", {"Model/Fidelity=simple", held}, 0.01, 0.001, 0.01);
  report("layered, driver held", {held, "Loads/Torque ramp angle in rad=0"}, 0.01, 0.001, 0.01);
  // single joints are wrong by a few hundred N
  report("full", small_full_drive, 0.05, 0.6, 0.2);
  report("arriving, half",
         small_full_drive_with({"Model/Symmetry model=true",
                                "Model/Elastic links=region of interest",
                                "Time/End time in ms=1"}),
         0.05,
         0.01,
         0.15);
}
