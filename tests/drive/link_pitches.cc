// SPDX-License-Identifier: LGPL-2.1-or-later
// Links with pitches of their own. Random ones are within the tolerance, with the variance of an
// even distribution, and the first of a seed are those of another implementation of the Mersenne
// twister. The same deviation of all links is an elongation. The layout of a chain without load has
// each link at its own length and its rollers out of the teeth, with the slack that is asked for,
// and the centre distance of two equal sprockets grows by half of what the spans are longer. Pulled
// without friction or weight, all links of a span carry the same tension.
#include "compare.h"
#include "slack_drive.h"

#include <chaindrive/drive/drive.h>
#include <chaindrive/utilities/errors.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

using namespace chaindrive;

namespace
{
/// Length of the links of the slack span less the distance between its ends, m.
double slack_of(const drive::Drive &d, const bool lumped)
{
  const drive::Layout::Span &span = d.layout.slack();
  const auto                &all  = d.layout.joints;
  double                     sum  = 0.;
  for (unsigned int k = 0; k < span.links; ++k)
    sum += own_length(d, lumped, (span.first + k) % all.size());
  return sum - all[span.first].bush.distance(all[(span.first + span.links) % all.size()].bush);
}

/// The greatest difference of tension in a span over the mean of all spans, and that mean.
std::pair<double, double> tensions(const drive::Drive &d, const bool lumped)
{
  double mean = 0., differ = 0.;
  for (const drive::Layout::Span &span : d.layout.spans)
    {
      double least = 1e9, most = 0.;
      for (unsigned int i = 0; i < span.links; ++i)
        {
          const unsigned int k = (span.first + i) % d.layout.joints.size();
          if (!lumped && k % 2 == 0)
            continue; // as good as rigid
          const double now = (lumped ? 1. : 0.5) * d.stiffness_per_pitch *
                             (length(d, k) - own_length(d, lumped, k));
          least = std::min(least, now);
          most  = std::max(most, now);
        }
      mean += 0.5 * (least + most) / d.layout.spans.size();
      differ = std::max(differ, most - least);
    }
  return {differ / mean, mean};
}

} // namespace

int main()
{
  std::cout << "== random pitches\n";
  {
    parameters::Drive drive;
    drive.n_links                  = 10000;
    drive.chain.pitch_tolerance    = 1e-3;
    drive.chain.pitch_seed         = 1;
    const drive::LinkPitches links = drive::make_link_pitches(drive, 10e-3, false, false);
    double                   most = 0., square = 0.;
    for (unsigned int k = 0; k < drive.n_links; ++k)
      {
        const double whole = 1e6 * links.of(k);
        most               = std::max(most, std::abs(whole));
        square += whole * whole / drive.n_links;
      }
    verdict("within 10 um but for their means, and some near it", most <= 10.3 && most > 9.9);
    verdict("variance a third of the square within 3 %",
            std::abs(square / (100. / 3.) - 1.) < 0.03);
    const drive::LinkPitches again = drive::make_link_pitches(drive, 10e-3, false, false);
    verdict("the same seed, the same chain", again.deviations == links.deviations);
    drive.chain.pitch_seed         = 2;
    const drive::LinkPitches other = drive::make_link_pitches(drive, 10e-3, false, false);
    verdict("another seed, another chain", other.deviations != links.deviations);
    drive.chain.pitch_seed = 1;
    drive.n_links          = 6;
    for (const double deviation : drive::make_link_pitches(drive, 10e-3, true, false).deviations)
      std::cout << std::setprecision(6) << 1e6 * deviation << " um\n";
  }

  for (const std::string fidelity : {"simple", "layered"})
    {
      const bool lumped = fidelity == "simple";
      std::cout << "== " << fidelity << '\n';

      Parameters worn = slack_drive(fidelity), longer = worn;
      worn.drive.chain.elongation         = 0.01;
      longer.drive.chain.pitch_deviations = {0.127e-3};
      const drive::Drive w = drive::make_drive(worn), l = drive::make_drive(longer);
      double             apart = 0.;
      for (unsigned int k = 0; k < 90; ++k)
        apart = std::max(apart, w.layout.joints[k].bush.distance(l.layout.joints[k].bush));
      verdict("all links longer by 1 %: an elongation, within 2 nm", apart < 2e-9);

      // two equal sprockets of 18 teeth: of 90 links 72 are in the spans
      Parameters equal                     = slack_drive(fidelity);
      equal.drive.sprockets.driver().teeth = 18;
      equal.drive.sprockets.driven().teeth = 18;
      const double before                  = drive::make_drive(equal).layout.centre_distance();
      equal.drive.chain.pitch_deviations   = {30e-6, 5e-6, -2e-6, 10e-6, -7e-6, 24e-6};
      const double after                   = drive::make_drive(equal).layout.centre_distance();
      compare("centre distance over half of the longer spans",
              (after - before) / (0.5 * 72. * 10e-6),
              1.,
              3);

      double worst = 0., overlap = -1., slack = 0., pulled = 0.;
      int    laid = 0;
      for (unsigned int seed = 1; seed <= 25; ++seed)
        {
          Parameters p                  = slack_drive(fidelity);
          p.drive.chain.pitch_tolerance = 1.5e-3;
          p.drive.chain.pitch_seed      = seed;
          p.drive.layout.start_phase    = 0.04 * (seed - 1);
          if (seed % 5 == 0)
            p.drive.layout.tight_span = parameters::TightSide::lower;
          const drive::Drive d = drive::make_drive(p);
          for (unsigned int k = 0; k < 90; ++k)
            worst = std::max(worst, std::abs(length(d, k) - own_length(d, lumped, k)));
          overlap = std::max(overlap, deepest(d));
          slack   = std::max(slack, std::abs(slack_of(d, lumped) - 1e-3));

          p.drive.layout.centre_distance_from = parameters::CentreDistanceFrom::pretension;
          p.drive.layout.pretension           = 400.;
          const auto [differ, mean]           = tensions(drive::make_drive(p), lumped);
          pulled = std::max({pulled, differ, std::abs(mean / 400. - 1.)});
          ++laid;
        }
      std::cout << laid << " chains of random links:\n";
      verdict("each link has its length within 10 nm", worst < 1e-8);
      verdict("no roller overlaps a tooth by 1 nm", overlap < 1e-9);
      // lumped rollers climb in their gaps, bushes have room in their rollers
      verdict("slack is 1 mm within " + std::string(lumped ? "0.1 mm" : "2 um"),
              slack < (lumped ? 1e-4 : 2e-6));
      verdict("with 400 N the tension of a span is that within 0.2 %", pulled < 2e-3);
    }

  std::cout << "== refused\n";
  const auto refused = [](const std::string &what, const Parameters &given) {
    expect_refusal(what, [&given]() { drive::make_drive(given); });
  };
  Parameters p                   = slack_drive("simple");
  p.drive.chain.pitch_deviations = {1e-6, 2e-6, 3e-6, 4e-6};
  refused("a list that does not repeat", p);
  p.drive.chain.pitch_deviations = {1e-6, 2e-6};
  p.drive.chain.pitch_tolerance  = 1e-3;
  refused("a list beside a tolerance", p);
  p                             = slack_drive("layered");
  p.drive.chain.pitch_tolerance = 1e-3;
  p.drive.layout.start          = parameters::Start::concentric;
  refused("no contact in the joints", p);
  p                             = slack_drive("full");
  p.drive.chain.pitch_tolerance = 1e-3;
  refused("elastic links", p);
  p                              = slack_drive("layered");
  p.drive.chain.pitch_deviations = {5e-6, -6e-6};
  refused("a chain too short", p);
}
