// SPDX-License-Identifier: LGPL-2.1-or-later

// A settled start with a given sag: the slack span hangs as deep as asked for and with the tension
// that the plan states, although weight, load and centrifugal tension stretch the chain.

#include "compare.h"

#include <chaindrive/drive/facts.h>

using namespace chaindrive;

namespace
{
/// Depth of the slack span's lowest joint below the straight line between its ends.
double depth(const drive::Layout &layout)
{
  const drive::Layout::Span &span = layout.slack();
  const unsigned int         n    = layout.joints.size();
  const auto                &from = layout.joints[span.first].bush;
  double                     most = 0.;
  for (unsigned int i = 1; i < span.links; ++i)
    most =
        std::max(most, std::abs((layout.joints[(span.first + i) % n].bush - from) * span.normal));
  return most;
}

/// Of the bar in the middle of that span.
double tension(const drive::Drive &d)
{
  const drive::Layout::Span &span   = d.layout.slack();
  const unsigned int         middle = span.first + span.links / 2;
  const double length = d.layout.joints[middle].bush.distance(d.layout.joints[middle + 1].bush);
  return d.stiffness_per_pitch * (length - d.chain.loaded_pitch());
}

void test(const std::string &name, const Parameters &p)
{
  const drive::Drive d       = drive::make_drive(p);
  const drive::Facts facts   = make_facts(p, d);
  const auto        &slack   = facts.slack();
  const bool         is_kept = p.drive.layout.sag > 0.;
  std::cout << name << '\n';
  if (is_kept)
    compare("  sag over what is asked for",
            depth(d.layout) / (p.drive.layout.sag * slack.links * d.chain.loaded_pitch()),
            1.,
            2);
  if (p.model.fidelity == "simple")
    compare("  tension over what is stated", tension(d) / slack.tension, 1., 2);
}
} // namespace

int main()
{
  Parameters p;
  p.drive.chain.designation           = "12B";
  p.drive.sprockets.driver().teeth    = 21;
  p.drive.sprockets.driven().teeth    = 21;
  p.drive.n_links                     = 650;
  p.drive.layout.start                = parameters::Start::settled;
  p.drive.layout.centre_distance_from = parameters::CentreDistanceFrom::sag;
  p.drive.layout.sag                  = 0.01;
  p.model.stiffness_per_pitch         = 1.211e8;
  p.loads.driver_speed                = 10.472;
  p.loads.resisting_torque            = 47.75;
  for (const std::string fidelity : {"simple", "layered"})
    for (const unsigned int links : {650, 120})
      for (const double speed : {10., 100.})
        {
          p.model.fidelity     = fidelity;
          p.drive.n_links      = links;
          p.loads.driver_speed = speed;
          test(fidelity + ", " + std::to_string(links) + " links, " +
                   std::to_string(static_cast<int>(speed)) + " rad/s",
               p);
        }
  std::cout << "== worn chains, whose rollers ride up\n";
  p.model.fidelity     = "simple";
  p.loads.driver_speed = 10.;
  for (const double elongation : {0.005, 0.015, 0.025})
    {
      p.drive.chain.elongation = elongation;
      test(std::to_string(elongation), p);
    }
  p.drive.chain.elongation = 0.;
  std::cout << "== without slack but for the stretch\n";
  p.model.fidelity                    = "simple";
  p.drive.layout.centre_distance_from = parameters::CentreDistanceFrom::slack;
  p.drive.layout.slack = p.drive.layout.sag = 0.;
  for (const unsigned int links : {650, 120})
    {
      p.drive.n_links = links;
      test(std::to_string(links) + " links", p);
    }

  std::cout << "== refusals name what may be too much\n";
  p.drive.chain.designation           = "08B";
  p.drive.sprockets.driver().teeth    = 15;
  p.drive.sprockets.driven().teeth    = 114;
  p.drive.n_links                     = 194;
  p.drive.chain.elongation            = 0.05;
  p.drive.layout.centre_distance_from = parameters::CentreDistanceFrom::sag;
  p.drive.layout.sag                  = 0.01;
  p.loads.resisting_torque            = 240.;
  expect_refusal("worn by 5 %", [&] { drive::make_drive(p); });
}
