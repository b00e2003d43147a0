// SPDX-License-Identifier: LGPL-2.1-or-later

// Starts of the 525 drive: mirrored tight span, gravity, alternation of links, a settled start
// whose velocities fit together.

#include "compare.h"
#include "forms.h"

#include <chaindrive/drive/four_bar.h>
#include <chaindrive/drive/layout.h>

using namespace chaindrive;

namespace
{
drive::Layout
make(const parameters::Drive &drive, const bool clearances, const bool weightless = false)
{
  const auto chain = drive::make_chain(drive.chain);
  return drive::make_layout(
      drive, chain, forms_of(drive, chain), clearances, 3e8, 120.74, 1412., weightless);
}
} // namespace

int main()
{
  parameters::Drive drive;
  const auto        upper = make(drive, true);
  std::cout << "links: tight " << upper.tight().links << ", slack " << upper.slack().links
            << "; seats: driver " << upper.sprockets[0].seats << ", driven "
            << upper.sprockets[1].seats << '\n';
  compare("direction of the tight span, x",
          upper.tight().direction[0],
          -std::cos(6.0714 / 57.29578),
          3);
  verdict("its normal is outward, to the right of the travel",
          upper.tight().normal[1] > 0.99 &&
              std::abs(upper.tight().normal * upper.tight().direction) < 1e-15);
  verdict("even links are inner links", upper.links[0].inner && !upper.links[1].inner);
  verdict("nothing moves", upper.sprockets[0].speed == 0. && upper.joints[3].velocity.norm() == 0.);

  std::cout << "== lower span tight, no gravity: the mirror image\n";
  drive.layout.slack      = 2e-3;
  const auto straight     = make(drive, true, true);
  drive.layout.tight_span = parameters::TightSide::lower;
  const auto lower        = make(drive, true, true);
  double     difference   = 0.;
  for (unsigned int k = 0; k < drive.n_links; ++k)
    difference = std::max(difference,
                          std::abs(lower.joints[k].bush[0] - straight.joints[k].bush[0]) +
                              std::abs(lower.joints[k].bush[1] + straight.joints[k].bush[1]));
  verdict("joints mirrored to 1e-8 m", difference < 1e-8);
  verdict("clockwise, travel of the tight span to the driver",
          lower.sense == -1 && lower.tight().direction[0] < -0.99 &&
              lower.tight().normal[1] < -0.99);
  verdict("both spans: outward normals stand on the directions of travel", [&] {
    double worst = 0.;
    for (const auto &layout : {upper, lower})
      for (const auto &span : layout.spans)
        {
          const auto &from = layout.joints[span.first].bush,
                     &to   = layout.joints[(span.first + span.links) % layout.joints.size()].bush;
          const dealii::Point<2> middle(0.5 * layout.centre_distance(), 0.);
          worst = std::max({worst,
                            std::abs(span.normal * span.direction),
                            (span.direction - (to - from) / to.distance(from)).norm(),
                            (from - middle) * span.normal > 0. ? 0. : 1.});
        }
    return worst < 1e-12;
  }());
  verdict("driver gap angles follow",
          std::abs(lower.sprockets[0].angle + straight.sprockets[0].angle) < 1e-12);

  std::cout << "== the slack span hangs down, whichever it is\n";
  drive.layout.centre_distance_from = parameters::CentreDistanceFrom::sag;
  for (const auto tight : {parameters::TightSide::upper, parameters::TightSide::lower})
    {
      drive.layout.tight_span = tight;
      const auto         l    = make(drive, true);
      const unsigned int a = l.slack().first, n = l.slack().links;
      const auto        &first = l.joints[a].bush, &last = l.joints[a + n].bush;
      const auto        &middle = l.joints[a + n / 2].bush;
      const double       t      = (middle[0] - first[0]) / (last[0] - first[0]);
      compare(text_of(tight) + ": middle below the chord, over the sag",
              (first[1] + t * (last[1] - first[1]) - middle[1]) / l.slack().sag,
              1.,
              1);
    }

  std::cout << "== settled\n";
  drive.layout.tight_span  = parameters::TightSide::upper;
  drive.layout.start       = parameters::Start::settled;
  drive.layout.start_phase = 0.4;
  for (const bool clearances : {false, true})
    {
      const auto settled = make(drive, clearances);
      compare("driven over driver speed, over the four-bar's",
              settled.sprockets[1].speed / settled.sprockets[0].speed /
                  drive::four_bar_ratio(settled.centre_distance(), 15.875e-3, 15, 42, 0.4),
              1.,
              3);
      const auto        &j = settled.joints;
      const unsigned int n = drive.n_links, exit = settled.tight().first;
      compare("both ends of the tight span move alike along it, m/s",
              j[exit].velocity * settled.tight().direction,
              j[0].velocity * settled.tight().direction,
              3);
      double jump = 0.;
      for (unsigned int k = 0; k < n; ++k)
        jump = std::max(jump, (j[k].velocity - j[(k + 1) % n].velocity).norm());
      verdict("neighbours differ by no more than p w1", jump < 15.9e-3 * 120.74);
      const auto &mid = j[exit + settled.tight().links / 2];
      compare(
          "chain speed within the polygon's range 4.509 ... 4.610", mid.velocity.norm(), 4.56, 1);
    }
  drive.layout.tight_span = parameters::TightSide::lower;
  const auto clockwise    = make(drive, true);
  verdict("mirrored: both speeds negative",
          clockwise.sprockets[0].speed == -120.74 && clockwise.sprockets[1].speed < 0.);
}
