// SPDX-License-Identifier: LGPL-2.1-or-later
// A window that waits for the drive to settle: it begins after whole pitch times of a drive at full
// speed, on all ranks at the same step although only the first one knows the tensions, and is as
// many pitch times long as asked for. What is added to means before it begins does not count.
#include "../support/scenes.h"

#include <chaindrive/observe/window_statistics.h>
#include <chaindrive/parameters/parameters.h>
#include <chaindrive/scene/build.h>

#include <deal.II/base/mpi.h>

using namespace test;

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const MPI_Comm                                 comm = MPI_COMM_WORLD;

  Parameters p;
  p.drive.n_links                  = 22;
  p.drive.sprockets.driver().teeth = p.drive.sprockets.driven().teeth = 9;
  p.drive.layout.slack                                                = 1e-4;
  p.model.driven_inertia                                              = 1e-4;
  p.loads.resisting_torque                                            = 20.;
  p.loads.ramp_time                                                   = 2e-3;
  p.time.end                                                          = 0.4;
  p.output.window_start.reset();
  p.output.window_pitches  = 2;
  const drive::Drive drive = drive::make_drive(p);
  const model::Model model = model::make_model(p, drive);
  const scene::Scene scene = scene::build_scene(model, drive, {"."});
  dynamics::System   system(scene, false, comm);
  const double       dt = 0.9 * system.critical_time_step();

  observe::Observation      now(scene, model, system);
  observe::WindowStatistics means(now, {{"time", "s"}, {"one", "1"}});
  unsigned long             begins = 0, ends = 0;
  now.next(0.);
  while (!now.window().is_full(now.time()) && now.time() < p.time.end)
    {
      system.advance(dt, now.time() + dt);
      now.next(dt);
      ++ends;
      begins += now.window().settled() ? 0 : 1;
      means.add({now.time() - 0.5 * dt, 1.});
    }
  files::Json summary;
  means.summarize(summary);
  const files::Json &statistics = summary["statistics"];

  const observe::Window &window     = now.window();
  const double           pitch_time = 2. * dealii::numbers::PI / 9. / p.loads.driver_speed;
  const double           waited     = (window.start() - p.loads.ramp_time) / pitch_time;
  const auto             same       = [comm](const double value) {
    return dealii::Utilities::MPI::max(value, comm) == dealii::Utilities::MPI::min(value, comm);
  };
  const bool all_same =
      same(double(begins)) && same(double(ends)) && same(window.start()) && same(window.end());
  if (dealii::Utilities::MPI::this_mpi_process(comm) != 0)
    return 0;
  verdict("the drive settles", window.settled());
  verdict("after whole pitch times at full speed", std::abs(waited - std::round(waited)) < 1e-9);
  verdict("from the sixth on", waited > 5.9);
  verdict("at the first step there",
          window.start() <= (begins + 1) * dt * (1. + 1e-9) &&
              window.start() > begins * dt * (1. - 1e-9));
  ratio("length over two pitch times", window.end() - window.start(), 2. * pitch_time, 9);
  verdict("at the end it is full", now.time() >= window.end() && now.time() < window.end() + dt);
  verdict("the same on all ranks", all_same);
  const double middle = 0.5 * (window.start() + window.end());
  ratio("mean of time over its middle", statistics["time"]["mean"], middle, 4);
  verdict("the means are over the window alone",
          std::abs(statistics["one"]["mean"].get<double>() - 1.) < 1e-12);
}
