// SPDX-License-Identifier: LGPL-2.1-or-later
// Events that make figures meaningless, made by hand: rollers are moved over the teeth of a
// sprocket in small steps as a drive turns. A chain that moves with the teeth, rides high on them
// or swings by half a pitch and back is no event; one that moves on by a gap has jumped.
#include "../support/archive.h"
#include "../support/scenes.h"

#include <chaindrive/observe/quantity.h>
#include <chaindrive/scene/build.h>

#include <algorithm>
#include <functional>

#include <deal.II/base/mpi.h>

using namespace test;

namespace
{
constexpr double PI = dealii::numbers::PI;

/// By how much rollers are ahead of the teeth of the driver at a time [s], pitches; and how much
/// farther out than when they are seated, m.
struct Motion
{
  std::function<double(double)> ahead = [](double) { return 0.; };
  double                        out   = 0.;
  bool                          slack = false; ///< there is nothing that pulls in the tight span
};

Parameters parameters_of(const parameters::TightSide side)
{
  Parameters p;
  p.model.fidelity          = "simple";
  p.drive.layout.start      = parameters::Start::settled;
  p.drive.layout.tight_span = side;
  p.loads.driver_speed      = 100.;
  p.loads.resisting_torque  = 20.;
  p.output.window_start     = 6e-3;
  p.output.field_interval   = 0.;
  p.time.end                = 20e-3;
  p.effects.planar_motion   = parameters::Switch::off; // rollers are moved in the frames
  return p;
}

/// Moves the rollers that start on the driver with it by @p motion for 20 ms; those that leave it
/// come back where others arrive, so that the wrapped arc is always full. With @p again the
/// quantity is replaced by one that reads what the first has written, at that time [s].
files::Json
events_of(const parameters::TightSide side, const Motion &motion, const double again = 1.)
{
  const Parameters     p     = parameters_of(side);
  const drive::Drive   drive = drive::make_drive(p);
  const model::Model   model = model::make_model(p, drive);
  const scene::Scene   scene = scene::build_scene(model, drive, {"."});
  dynamics::System     system(scene, false);
  observe::Observation now(scene, model, system);
  system.evaluate_forces(0.);

  const auto make = [&] {
    auto all = observe::make_quantities(now);
    return std::move(std::find_if(all.begin(), all.end(), [](const auto &item) {
                       return item.name == "events";
                     })->quantity);
  };
  auto               events = make();
  const unsigned int teeth = scene.drive.sprockets[0].teeth, body = scene.drive.sprockets[0].body;
  const double pitch = 2. * PI / teeth, radius = 0.5 * scene.drive.pitch / std::sin(PI / teeth);
  const double start = drive.layout.sprockets[0].angle;
  for (unsigned int step = 0; step <= 2000; ++step)
    {
      const double time = step * 10e-6, turned = scene.drive.sense * p.loads.driver_speed * time;
      system.world.time                  = time;
      system.world.frames[body].rotation = to_matrix(rotation_about_z(start + turned));
      // joint 0 arrives first; one after the other take the places of a whole turn of the driver
      const double passed = p.loads.driver_speed * time / pitch + motion.ahead(time);
      for (unsigned int k = 0; k < scene.drive.n_joints; ++k)
        {
          const double place = // of the joint, pitches ahead of the middle of the arc
              std::remainder(k + passed, static_cast<double>(scene.drive.n_joints));
          const double angle =
              PI + scene.drive.sense * pitch * (place - 3.) + std::remainder(start - PI, pitch);
          Vector3 &position = system.world.frames[k].position;
          if (std::abs(place - 3.) * pitch < 0.5 * PI)
            position = vector((radius + motion.out) * std::cos(angle),
                              (radius + motion.out) * std::sin(angle));
          else
            position = motion.slack || scene.bodies[k].initial.position[0] < 0. ?
                           vector(-1., 1.) : // where no tight span is
                           scene.bodies[k].initial.position;
        }
      if (time >= again && time < again + 10e-6)
        {
          Items items;
          events->serialize(writer(items));
          events = make();
          events->serialize(reader(items));
        }
      now.next(10e-6);
      events->update();
    }
  files::Json summary;
  events->summarize(summary);
  return summary["events"];
}

void print(const std::string &what, const files::Json &events)
{
  std::cout << what << ": " << events.size() << '\n';
  for (const files::Json &event : events)
    std::cout << "  " << event["sentence"].get<std::string>()
              << (event["in_window"] ? " In" : " Not in") << " the window, "
              << event.value("ahead", 0) << " ahead.\n";
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  using parameters::TightSide;
  const auto ramp = [](const double from, const double teeth) {
    return [=](const double time) { return teeth * std::clamp((time - from) / 2e-3, 0., 1.); };
  };
  for (const TightSide side : {TightSide::upper, TightSide::lower})
    {
      std::cout << text_of(side) << " span tight\n";
      print("with the teeth", events_of(side, {}));
      print("2 mm out", events_of(side, {[](double) { return 0.; }, 2e-3}));
      print("swings by 0.6 pitches and back",
            events_of(side,
                      {[](const double time) { return 0.6 * std::sin(2. * PI * time / 5e-3); }}));
      print("a tooth back before the window", events_of(side, {ramp(4.003e-3, -1.)}));
      print("three teeth ahead in the window", events_of(side, {ramp(12.003e-3, 3.)}));
      print("a tooth ahead, and back in the window", events_of(side, {[&](const double time) {
                                                                 return ramp(4.003e-3, 1.)(time) -
                                                                        ramp(14.003e-3, 1.)(time);
                                                               }}));
      print("the same of a run that is interrupted at 8 ms",
            events_of(side,
                      {[&](const double time) {
                        return ramp(4.003e-3, 1.)(time) - ramp(14.003e-3, 1.)(time);
                      }},
                      8e-3));
      print("off the driver", events_of(side, {[](double) { return 0.; }, 10e-3}));
      print("the tight span slack", events_of(side, {[](double) { return 0.; }, 0., true}));
      print("on the tips", events_of(side, {[](double) { return 0.5; }, 7.5e-3}));
    }
}
