// SPDX-License-Identifier: LGPL-2.1-or-later
// Which links are the tight span and which the slack one, at any ratio, however near the shafts are
// to each other and whichever span is tight. A settled start knows both: the tight span carries the
// load's torque over the pitch radius more than the slack one and moves with the chain.
#include "../support/scenes.h"

#include <chaindrive/observe/spans.h>
#include <chaindrive/scene/build.h>

#include <algorithm>

using namespace test;

int main()
{
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
