// SPDX-License-Identifier: LGPL-2.1-or-later
// Pre-tension asked for is the mean tension of the two spans at the start, at which nothing moves:
// after 2 ms with the driver held it is still there. Over fidelities, tooth forms, start phases and
// sprockets; with friction and gravity. A settled start without speed and load is the same state.
#include "../support/decided.h"
#include "../support/scenes.h"

#include <chaindrive/observe/spans.h>

#include <algorithm>

using namespace test;

namespace
{
struct Found
{
  double least = 1e9, most = 0., speed = 0.;
};

/// The mean tension over the one asked for, at the start and after it; the largest speed, m/s.
void rest(const Parameters &p, Found &found)
{
  const scene::Scene scene = scene_of(p);
  dynamics::System   system(scene, false);
  observe::Spans     spans(scene, system);
  const auto         look = [&] {
    spans.update(system);
    const double mean =
        0.5 * (spans.tight().tension + spans.slack().tension) / p.drive.layout.pretension;
    found.least = std::min(found.least, mean);
    found.most  = std::max(found.most, mean);
    // lumped rollers or links: single rollers beside a tooth fall through what is left of their
    // clearance
    const unsigned int first = scene.bars.empty() ? scene.drive.n_joints : 0;
    for (unsigned int k = first; k < first + scene.drive.n_joints; ++k)
      found.speed = std::max(found.speed, system.world.frames[k].velocity.norm());
  };
  look();
  for (unsigned int i = 0; i < 8; ++i)
    {
      advance(system, 250, 1e-6, [] {});
      look();
    }
}

void report(const std::string &what, const std::vector<Parameters> &drives)
{
  Found found;
  for (const Parameters &p : drives)
    rest(p, found);
  std::cout << what << std::fixed << std::setprecision(2) << ": tension / asked " << found.least
            << " to " << found.most << std::defaultfloat
            << (found.least > 0.98 && found.most < 1.02 ? "" : "  NO")
            << "; below 2 mm/s: " << (found.speed < 2e-3 ? "yes" : "NO") << std::endl;
}
} // namespace

int main()
{
  Parameters p;
  p.loads.driver_speed                = 0.;
  p.output.field_interval             = 0.;
  p.model.driven_inertia              = 9.88e-3;
  p.model.stiffness_per_pitch         = 3e8;
  p.drive.layout.centre_distance_from = parameters::CentreDistanceFrom::pretension;
  for (const std::string fidelity : {"simple", "layered"})
    {
      p.model.fidelity = fidelity;
      for (const double tension : {30., 300., 730., 2000.})
        {
          p.drive.layout.pretension = tension;
          report(fidelity + ", " + std::to_string(int(tension)) + " N", {p});
        }
      p.drive.layout.pretension = 730.;
      for (const auto &[form, name] : parameters::texts_of<parameters::StandardForm>)
        {
          std::vector<Parameters> phases;
          for (const double phase : {0.3, 0.7})
            {
              p.drive.layout.start_phase   = phase;
              p.drive.sprockets.tooth_form = form;
              p.drive.layout.tight_span =
                  phase < 0.5 ? parameters::TightSide::upper : parameters::TightSide::lower;
              phases.push_back(p);
            }
          report(fidelity + ", " + name, phases);
        }
      Parameters small                     = p;
      small.drive.sprockets.driver().teeth = 19;
      small.drive.sprockets.driven().teeth = 11;
      small.drive.n_links                  = 60;
      small.drive.layout.tight_span        = parameters::TightSide::upper;
      report(fidelity + ", 19/11", {small});
      Parameters settled             = p;
      settled.drive.layout.start     = parameters::Start::settled;
      settled.loads.resisting_torque = 0.;
      report(fidelity + ", settled", {settled});
    }
}
