// SPDX-License-Identifier: LGPL-2.1-or-later

// Chains of several strands: what is said of chain and joints is what a single strand with its
// share of torques, inertias and springs has, bit by bit; what is said of shafts is so many times
// as much. Ratings and life are those of one strand with the load over the factor of B29.1, 1.7
// and 2.5. The mass of a chain is that of catalogues, in links of every kind.

#include "compare.h"

#include <chaindrive/drive/checks.h>
#include <chaindrive/drive/design_life.h>

#include <cmath>

using namespace chaindrive;

namespace
{
bool near(const double a, const double b, const double part = 1e-12)
{
  return std::abs(a - b) <= part * std::abs(b);
}

/// An 08B of so many strands over 19 and 38 teeth: 30 N m, 0.06 kg m2.
Parameters drive_of(const unsigned int strands, const double torque = 30., const double j = 0.06)
{
  Parameters p;
  p.drive.chain.designation           = "08B";
  p.drive.chain.strands               = strands;
  p.drive.n_links                     = 90;
  p.drive.sprockets.driver().teeth    = 19;
  p.drive.sprockets.driven().teeth    = 38;
  p.drive.layout.centre_distance_from = parameters::CentreDistanceFrom::sag;
  p.drive.layout.start                = parameters::Start::settled;
  p.loads.driver_speed                = 100.;
  p.loads.resisting_torque            = torque;
  p.loads.torque_step_time            = 1e-3;
  p.loads.torque_after_step           = 2. * torque;
  p.model.driven_inertia              = j;
  return p;
}

struct Case
{
  explicit Case(const Parameters &p)
      : drive(drive::make_drive(p))
      , facts(drive::make_facts(p, drive))
      , life(drive::design_life(facts, drive.chain, false))
  {
  }

  drive::Drive      drive;
  drive::Facts      facts;
  drive::DesignLife life;
};

void against_simplex(const unsigned int n, const double factor, const double strength)
{
  const Case  several(drive_of(n)), simplex(drive_of(1, 30. / n, 0.06 / n));
  const auto &a = several.facts, &b = simplex.facts;
  const auto  exactness = n == 2 ? 0. : 1e-12; // a third is not exact
  std::cout << "== " << n << " strands\n";
  bool same = near(several.drive.layout.centre_distance(),
                   simplex.drive.layout.centre_distance(),
                   exactness) &&
              near(several.drive.stiffness_per_pitch, simplex.drive.stiffness_per_pitch, exactness);
  for (std::size_t i = 0; i < a.spans.size(); ++i)
    same = same && near(a.spans[i].tension, b.spans[i].tension, exactness) &&
           near(a.spans[i].frequency, b.spans[i].frequency, exactness);
  verdict("a strand has the layout, stiffness, tensions and frequencies of a simplex chain",
          same && near(a.effective_tension, b.effective_tension, exactness) &&
              near(a.driven_frequency, b.driven_frequency, exactness) &&
              near(a.joint_pressure, b.joint_pressure, exactness) &&
              near(a.mass_per_metre, b.mass_per_metre, exactness));
  bool whole = near(a.power, n * b.power) && near(a.shaft_load, n * b.shaft_load) &&
               near(a.driven_inertia, 0.06) && near(a.loaded().torque, 30.);
  for (std::size_t i = 0; i < a.sprockets.size(); ++i)
    whole = whole && near(a.sprockets[i].torque, n * b.sprockets[i].torque) &&
            near(a.sprockets[i].inertia, n * b.sprockets[i].inertia) &&
            near(a.sprockets[i].load, n * b.sprockets[i].load);
  verdict("power, torques, inertias and loads of shafts are those of all", whole);

  const Case most(drive_of(1, 30. / factor, 0.06));
  verdict("rated as the factor says", near(a.rated_power, factor * b.rated_power));
  verdict("galls, and its rollers and its frame last, as the strand that pulls most",
          near(a.highest_speed, most.facts.highest_speed) &&
              near(several.life.roller_hours, most.life.roller_hours) &&
              near(several.life.frame_hours, most.life.frame_hours));
  verdict("its joints wear and its plates are stressed as that, to 0.5 %",
          near(several.life.wear_hours, most.life.wear_hours, 0.005) &&
              near(several.life.inner.hole, most.life.inner.hole, 0.005) &&
              several.life.wear_hours < 0.95 * simplex.life.wear_hours);
  verdict("breaks as the standard lists", near(n * a.tensile_strength, strength));

  // checks name the torque with which the chain has its usual safety, of all strands
  Parameters overloaded = drive_of(n, 400. * n);
  overloaded.loads.torque_step_time.reset();
  const auto checks = check_design(overloaded, Case(overloaded).facts);
  std::cout << checks.front().sentence << '\n';
  const std::string entry       = "Loads/Resisting torque in N m of at most ";
  const std::size_t at          = checks.front().sentence.find(entry);
  const double      most_torque = std::stod(checks.front().sentence.substr(at + entry.size()));
  for (const double part : {0.98, 1.02})
    {
      Parameters p             = overloaded;
      p.loads.resisting_torque = part * most_torque;
      const auto found         = check_design(p, Case(p).facts);
      std::cout << part << " of that: "
                << (found.empty() || found.front().name != "strength" ? "safe" : "warned") << '\n';
    }
}

} // namespace

int main()
{
  against_simplex(2, 1.7, 31.1e3);
  against_simplex(3, 2.5, 44.5e3);
}
