// SPDX-License-Identifier: LGPL-2.1-or-later
// Wheels whose pitch circles run out. The chain is laid round the circles where they are, so that
// the shafts of a drive with slack are nearer or further by the eccentricity, half of the runout.
// A settled wheel balances its torque about its shaft, not about the centre of its circle. A drive
// with the lower span tight is the mirror image.
#include "compare.h"
#include "idler_drive.h"

#include <chaindrive/drive/drive.h>
#include <chaindrive/drive/outline.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

using namespace chaindrive;
using dealii::Point;
using dealii::Tensor;

namespace
{
Parameters slow_drive(const std::string &fidelity)
{
  Parameters p;
  p.model.fidelity                    = fidelity;
  p.effects.gravity                   = parameters::Switch::off;
  p.drive.n_links                     = 110;
  p.drive.layout.centre_distance_from = parameters::CentreDistanceFrom::slack;
  p.drive.layout.slack                = 2e-3;
  p.drive.layout.start                = parameters::Start::settled;
  p.loads.driver_speed                = 1.;
  return p;
}

/// Moment [N m], counter-clockwise, of the tensions in the middle of the two spans at wheel @p i
/// about the point @p at.
double
moment_of_spans(const drive::Drive &d, const bool lumped, const unsigned int i, const Point<2> &at)
{
  const auto        &all = d.layout.joints;
  const unsigned int n   = static_cast<unsigned int>(all.size());
  double             sum = 0.;
  for (const bool leads : {true, false})
    {
      const drive::Layout::Span &span = leads ? d.layout.into(i) : d.layout.spans[i];
      unsigned int               k    = span.first + span.links / 2;
      if (k % 2 == 0)
        ++k; // an outer link, which has the stiffness of both joints in the layered model
      const Point<2>    &a = all[k % n].bush, &b = all[(k + 1) % n].bush;
      const Tensor<1, 2> along = (b - a) / a.distance(b);
      const double       tension =
          lumped ? d.stiffness_per_pitch * (a.distance(b) - d.chain.loaded_pitch()) :
                         0.5 * d.stiffness_per_pitch * (a.distance(b) - d.chain.loaded_outer_pitch());
      sum += tension * drive::cross(a - at, leads ? -along : along);
    }
  return sum;
}
} // namespace

int main()
{
  for (const std::string fidelity : {"simple", "layered"})
    {
      std::cout << "== " << fidelity << '\n';
      Parameters p                = slow_drive(fidelity);
      p.drive.layout.start        = parameters::Start::taut;
      const drive::Drive plain    = drive::make_drive(p);
      auto              &wheels   = p.drive.sprockets.list;
      wheels[1].runout            = 0.8e-3;
      const drive::Drive outwards = drive::make_drive(p);
      wheels[0].runout            = 0.2e-3;
      wheels[0].runout_phase      = dealii::numbers::PI;
      const drive::Drive both     = drive::make_drive(p);
      compare("nearer by half of 0.8 mm, um",
              1e6 * (plain.layout.centre_distance() - outwards.layout.centre_distance()),
              400.,
              3);
      compare("and by half of 0.2 mm more, um",
              1e6 * (plain.layout.centre_distance() - both.layout.centre_distance()),
              500.,
              3);
      double apart = 0.;
      for (unsigned int k = 0; k < p.drive.n_links; ++k)
        apart =
            std::max(apart, plain.layout.joints[k].bush.distance(outwards.layout.joints[k].bush));
      verdict("the chain is where it was, within 1 nm", apart < 1e-9);

      double torque = 0., about_centre = 0., mirrored = 0.;
      for (unsigned int i = 0; i < 8; ++i)
        {
          Parameters q                             = slow_drive(fidelity);
          auto      &list                          = q.drive.sprockets.list;
          list[0].runout                           = 0.6e-3;
          list[0].runout_phase                     = 0.25 * dealii::numbers::PI * i;
          list[1].runout                           = 3e-3;
          list[1].runout_phase                     = 2. - 0.5 * dealii::numbers::PI * i;
          q.drive.layout.start_phase               = 0.1 * i;
          const drive::Drive             d         = drive::make_drive(q);
          const drive::Layout::Sprocket &at        = d.layout.sprockets[1];
          const double                   resisting = d.sprockets[1].mean_torque;
          torque                                   = std::max(
              torque,
              std::abs(moment_of_spans(d, fidelity == "simple", 1, at.axis()) / resisting - 1.));
          about_centre = std::max(
              about_centre,
              std::abs(moment_of_spans(d, fidelity == "simple", 1, at.centre) / resisting - 1.));
          if (i == 3)
            compare("eccentricity after settling, mm", 1e3 * at.eccentricity.norm(), 1.5, 6);

          q.drive.layout.start      = parameters::Start::taut;
          const drive::Drive still  = drive::make_drive(q);
          q.drive.layout.tight_span = parameters::TightSide::lower;
          const drive::Drive image  = drive::make_drive(q);
          for (unsigned int k = 0; k < q.drive.n_links; ++k)
            {
              const Point<2> &a = still.layout.joints[k].bush, &b = image.layout.joints[k].bush;
              mirrored = std::max(mirrored, std::hypot(a[0] - b[0], a[1] + b[1]));
            }
        }
      verdict("moment of the spans about the shaft that of the load within 1e-4", torque < 1e-4);
      verdict("about the centre it is not, by more than 1 %", about_centre > 0.01);
      verdict("mirror image within 1 nm", mirrored < 1e-9);
    }

  Parameters p                          = idler_drive(1, {{0.2, -0.1}}, {{0.1, -0.1}});
  p.drive.sprockets.list[1].held.holder = parameters::Holder::arm;
  p.drive.sprockets.list[1].runout      = 50e-6;
  expect_refusal("on a tensioner", [&p]() { drive::make_drive(p); });
}
