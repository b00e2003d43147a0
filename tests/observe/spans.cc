// SPDX-License-Identifier: LGPL-2.1-or-later
// Which links are the tight span and which the slack one, at any ratio, however near the shafts are
// to each other and whichever span is tight. A settled start knows both: the tight span carries the
// load's torque over the pitch radius more than the slack one and moves with the chain. Of two
// spans side by side that travel alike each has its own links. In the plane links are looked at
// when they may have come to another span: over a pitch and a half nobody sees a difference.
#include "../support/scenes.h"

#include <chaindrive/model/reading.h>
#include <chaindrive/observe/spans.h>
#include <chaindrive/scene/build.h>

#include <algorithm>

using namespace test;

namespace
{
/// There and back twice: round the driver on the left, along the floor to the first of two wheels
/// on the right, back to a wheel outside of the loop, beside the driver, and over the second one.
void serpentine()
{
  const Parameters p =
      model::read_entries({{"Drive/Number of links", "202"},
                           {"Drive/Driver teeth", "48"},
                           {"Drive/Driven teeth", "16"},
                           {"Drive/Wheels/Order of travel", "driver, driven, back, last"},
                           {"Drive/Wheels/driver/Centre in mm", "0, 122"},
                           {"Drive/Wheels/driven/Centre in mm", "auto"},
                           {"Drive/Wheels/driven/Direction in degrees", "-6.6"},
                           {"Drive/Wheels/back/Teeth", "16"},
                           {"Drive/Wheels/back/Side", "outside"},
                           {"Drive/Wheels/back/Centre in mm", "180, 122"},
                           {"Drive/Wheels/last/Teeth", "16"},
                           {"Drive/Wheels/last/Centre in mm", "700, 203"},
                           {"Drive/Layout/Centre distance from", "slack"},
                           {"Drive/Layout/Centre distance in mm", "705"},
                           {"Drive/Layout/Slack in mm", "1"},
                           {"Drive/Layout/Start", "settled"},
                           {"Model/Fidelity", "simple"},
                           {"Loads/Driver speed in rad/s", "30"},
                           {"Loads/Resisting torque in N m", "20"}})
          .parameters;
  const drive::Drive drive = drive::make_drive(p);
  const scene::Scene scene = scene::build_scene(model::make_model(p, drive), drive, {"."});
  dynamics::System   system(scene, false);
  observe::Spans     spans(scene, system);
  spans.update(system);
  const double pitch = scene.drive.pitch;
  for (unsigned int s = 0; s < scene.drive.spans.size(); ++s)
    {
      // by the layout, which knows where each span begins, the mean over the middle of its links
      const drive::Layout::Span &laid = drive.layout.spans[s];
      Vector3                    middle;
      unsigned int               n = 0;
      for (unsigned int k = laid.first + laid.links / 3; k < laid.first + laid.links * 2 / 3; ++k)
        {
          const auto &at = drive.layout.joints[k % drive.layout.joints.size()].roller;
          middle += vector(at[0], at[1]) - scene.bodies[scene.drive.driver().body].initial.position;
          ++n;
        }
      const double offset = middle * scene.drive.spans[s].normal / n;
      verdict(scene.drive.spans[s].name + " is where it was laid, to a fifth of a pitch",
              std::abs(spans.of(s).offset - offset) < 0.2 * pitch);
    }
}

void followed_in_the_plane(const std::string &fidelity)
{
  const Parameters p = model::read_entries({{"Drive/Number of links", "40"},
                                            {"Drive/Driver teeth", "11"},
                                            {"Drive/Driven teeth", "19"},
                                            {"Drive/Layout/Start", "settled"},
                                            {"Model/Fidelity", fidelity},
                                            {"Loads/Driver speed in rad/s", "300"},
                                            {"Loads/Resisting torque in N m", "20"}})
                           .parameters;
  const drive::Drive drive = drive::make_drive(p);
  const scene::Scene scene = scene::build_scene(model::make_model(p, drive), drive, {"."});
  dynamics::System   system(scene, false);
  observe::Spans     spans(scene, system);
  const double       dt = 0.5 * system.critical_time_step(), start = system.world.time;
  if (system.world.planar == nullptr)
    std::cout << "the drive is not in the plane" << std::endl;
  bool same = true;
  for (unsigned int i = 1; system.world.time < start + 1.5 * scene.pitch_time(); ++i)
    {
      system.advance_without_update(dt, start + i * dt);
      spans.update(system);
      if (i % 20 != 0)
        continue;
      observe::Spans fresh(scene, system); // which looks at all links
      fresh.update(system);
      for (unsigned int s = 0; s < scene.drive.spans.size(); ++s)
        for (double observe::Spans::Span::*mean : {&observe::Spans::Span::tension,
                                                   &observe::Spans::Span::speed,
                                                   &observe::Spans::Span::offset,
                                                   &observe::Spans::Span::inward})
          same = same && spans.of(s).*mean == fresh.of(s).*mean;
    }
  verdict(fidelity + ", spans that are followed are those that are looked for", same);
  verdict("  and the chain has moved by more than a pitch",
          system.world.planar->travelled() > scene.drive.pitch);
}
} // namespace

int main()
{
  serpentine();
  followed_in_the_plane("simple");
  followed_in_the_plane("layered");
  std::cout << "teeth, links, tight span, fidelity; over all start phases, each over what it must "
               "be:\ntension less slack tension, slack tension, speed; offset of the tight span, "
               "of the slack span\n";
  for (const auto &[driver, driven, links] : {std::tuple<unsigned, unsigned, unsigned>{57, 11, 100},
                                              {11, 57, 100},
                                              {57, 11, 66}, // short spans
                                              {80, 10, 110},
                                              {15, 42, 110},
                                              {9, 9, 16}}) // spans of three or four links
    for (const auto side : {parameters::TightSide::upper, parameters::TightSide::lower})
      for (const std::string fidelity : {"simple", "layered"})
        {
          if (fidelity == "layered" && links != 100)
            continue;
          double worst[5] = {0., 0., 0., 0., 0.};
          for (double phase = 0.05; phase < 1.; phase += 0.1)
            {
              Parameters p;
              p.drive.sprockets.driver().teeth = driver;
              p.drive.sprockets.driven().teeth = driven;
              p.drive.n_links                  = links;
              p.drive.layout.tight_span        = side;
              p.drive.layout.start             = parameters::Start::settled;
              p.drive.layout.start_phase       = phase;
              p.drive.layout.slack             = 0.;
              // has room for a chain that is laid taut
              p.drive.sprockets.tooth_form = parameters::StandardForm::iso_mid;
              p.loads.resisting_torque     = 20.;
              p.loads.driver_speed         = 30.;
              p.loads.gravity              = 0.; // straight spans
              p.model.fidelity             = fidelity;
              p.output.field_interval      = 0.;
              const drive::Drive drive     = drive::make_drive(p);
              const scene::Scene scene =
                  scene::build_scene(model::make_model(p, drive), drive, {"."});
              dynamics::System system(scene, false);
              observe::Spans   spans(scene, system);
              system.evaluate_forces(0.);
              spans.update(system);

              const double tension = drive.nominal_tension;
              const double radius  = 0.5 * drive.sprockets[0].form.pitch_diameter;
              const double note[5] = {(spans.tight().tension - spans.slack().tension) / tension -
                                          1.,
                                      spans.slack().tension / tension,
                                      spans.tight().speed / (30. * radius) - 1.,
                                      spans.tight().offset / radius - 1.,
                                      -spans.slack().inward / radius - 1.};
              for (unsigned int i = 0; i < 5; ++i)
                if (std::abs(note[i]) > std::abs(worst[i]))
                  worst[i] = note[i];
            }
          std::cout << driver << '/' << driven << ' ' << links << ' ' << text_of(side) << ' '
                    << fidelity << std::fixed << std::setprecision(3);
          for (const double value : worst)
            std::cout << ' ' << value + 0.;
          std::cout << std::defaultfloat << '\n';
        }
}
