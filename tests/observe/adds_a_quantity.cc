// SPDX-License-Identifier: LGPL-2.1-or-later
// A new quantity is one file. This is one: the power that the driven hub delivers, with a history,
// a member of the summary and something to remember. It is in a run that knows nothing of it, among
// the quantities of the program; a run that was interrupted forgets nothing of it. One that the
// scene has not is never made.
#include "../support/archive.h"
#include "../support/scenes.h"
#include "../support/table.h"

#include <chaindrive/observe/quantity.h>
#include <chaindrive/observe/schema.h>
#include <chaindrive/simulation.h>

#include <algorithm>
#include <filesystem>

#include <deal.II/base/mpi.h>

using namespace test;
using namespace chaindrive::observe;

namespace
{
double power_of(const dynamics::System &system)
{
  double power = 0.;
  for (const World::Hub &hub : system.world.hubs)
    if (!hub.prescribed)
      power += std::abs(system.loads.torque(hub.body) * hub.speed);
  return power;
}

class Power : public Quantity
{
public:
  using Quantity::Quantity;

  static bool exists(const Observation &start) { return start.system.world.hubs.size() == 2; }

  static Contents contents()
  {
    return {{{"hubs/driven_power", "W", "Power that the driven hub delivers"}},
            {{"driven_power_max", "W", "power of the driven hub, largest"}}};
  }

  void add_channels(Channels &channels) override
  {
    channels.add("hubs/driven_power",
                 [this](const Channels::Row row) { row[0] = power_of(now_.system); });
  }
  void update() override { largest_ = std::max(largest_, power_of(now_.system)); }
  void summarize(files::Json &summary) const override { summary["driven_power_max"] = largest_; }
  void serialize(const Archive &archive) override { archive("largest", largest_); }

private:
  double largest_ = 0.; ///< W
};
const Registered<Power> power({"driven power", "What the driven hub delivers."});

class Never : public Quantity
{
public:
  explicit Never(const Observation &now) : Quantity(now) { std::cout << "It is made.\n"; }

  static bool exists(const Observation &start) { return start.scene.has_elastic_bodies(); }
};
const Registered<Never> never({"never", "In no scene.", {"driven power"}});

class StopAt : public dynamics::Observer
{
public:
  explicit StopAt(const unsigned long step) : step_(step) {}

  void observe(const dynamics::System &,
               const unsigned long step,
               double,
               dynamics::Services &services) override
  {
    if (step >= step_)
      services.stop_run();
  }
  std::string name() const override { return "stop"; }

private:
  unsigned long step_;
};

void serialize(const Archive &archive, Simulation &simulation)
{
  simulation.system().serialize(archive / "system");
  for (dynamics::Observer *observer : simulation.observers())
    observer->serialize(archive / observer->name(), simulation.system());
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Parameters                                     p;
  p.model.fidelity          = "simple";
  p.drive.layout.start      = parameters::Start::settled;
  p.loads.driver_speed      = 100.;
  p.loads.resisting_torque  = 20.;
  p.time.end                = 5e-3;
  p.output.window_start     = 0.;
  p.output.history_interval = 1e-9; // every step
  p.output.csv              = true;

  Simulation whole(p, {"."}, MPI_COMM_SELF);
  whole.recorder().write_histories(".", "", whole.n_steps());
  whole.run();
  whole.recorder().close(true);
  const double largest = whole.summary().values.at("driven_power_max");

  const Table                hubs("histories_hubs.csv");
  const std::vector<double> &power = hubs["driven_power"], &speed = hubs["driven_speed"],
                            &torque = hubs["load_torque"];
  double error                      = 0.;
  for (std::size_t i = 0; i < power.size(); ++i)
    error = std::max(error, std::abs(power[i] - speed[i] * torque[i]) / largest);
  std::cout << std::setprecision(4) << "mean speed "
            << whole.summary().values.at("driven_speed_mean").get<double>() << " rad/s\n";
  verdict("a sample at every step", power.size() == whole.n_steps() + 1);
  const files::Json schema = chaindrive::observe::schema();
  verdict("both are in the schema",
          schema["histories"]["hubs/driven_power"]["unit"] == "W" &&
              schema["summary"]["driven_power_max"]["unit"] == "W");
  verdict("power is torque times speed", error < 1e-12 && largest > 100.);
  verdict("its largest value is in the summary",
          largest == *std::max_element(power.begin(), power.end()));

  const unsigned long stop =
      std::max_element(power.begin(), power.end()) - power.begin() + 5; // after the largest
  Items items;
  {
    Simulation first(p, {"."}, MPI_COMM_SELF);
    StopAt     late(stop);
    first.run({&late});
    serialize(writer(items), first);
  }
  Simulation rest(p, {"."}, MPI_COMM_SELF);
  serialize(reader(items), rest);
  rest.run({}, stop);
  verdict("the largest is before the interruption", stop < rest.n_steps());
  verdict("and not forgotten", rest.summary().values.at("driven_power_max") == largest);
}
