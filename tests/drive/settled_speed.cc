// SPDX-License-Identifier: LGPL-2.1-or-later
// With which speed the driven side of a settled start turns, over the driver's: below its resonance
// the one of a rigid tight span (four-bar linkage), above it the mean, at any phase. Joints move
// with their sprockets, and in the spans linearly from one end to the other.
#include "compare.h"

#include <chaindrive/drive/facts.h>
#include <chaindrive/drive/four_bar.h>
#include <chaindrive/parameters/reader.h>

#include <algorithm>

using namespace chaindrive;

namespace
{
constexpr double phases[] = {0., 0.3, 0.8};

Parameters at(const double phase, const double inertia, const parameters::TightSide side)
{
  Parameters p;
  p.model.fidelity           = "simple";
  p.model.driven_inertia     = inertia;
  p.drive.layout.start       = parameters::Start::settled;
  p.drive.layout.start_phase = phase;
  p.drive.layout.tight_span  = side;
  return p;
}

/// How far the joints are from moving with their sprockets, and from the mean of their neighbours
/// in the spans, over the speed of the chain.
double misfit(const drive::Layout &layout)
{
  const unsigned int n     = layout.joints.size();
  double             worst = 0.;
  for (const auto &joint : layout.joints)
    if (joint.sprocket >= 0)
      {
        const auto &sprocket = layout.sprockets[joint.sprocket];
        // what bears on a seat may be off its centre
        const auto                 arm = joint.roller - sprocket.centre;
        const dealii::Tensor<1, 2> turned({-sprocket.speed * arm[1], sprocket.speed * arm[0]});
        worst = std::max(worst, (joint.velocity - turned).norm());
      }
  for (const auto &span : layout.spans)
    for (unsigned int i = 1; i < span.links; ++i)
      {
        const auto v = [&](const unsigned int k) {
          return layout.joints[(span.first + k) % n].velocity;
        };
        worst = std::max(worst, (v(i - 1) - 2. * v(i) + v(i + 1)).norm());
      }
  return worst / layout.joints[0].velocity.norm();
}
} // namespace

int main()
{
  for (const auto side : {parameters::TightSide::upper, parameters::TightSide::lower})
    for (const double inertia : {3e-3, 0.3})
      {
        double of_polygon = 0., of_mean = 0., fit = 0.;
        bool   below = false;
        for (const double phase : phases)
          {
            const Parameters   p     = at(phase, inertia, side);
            const drive::Drive d     = drive::make_drive(p);
            const drive::Facts facts = drive::make_facts(p, d);
            const double       ratio = d.layout.sprockets[1].speed / d.layout.sprockets[0].speed;
            const double       rigid = drive::four_bar_ratio(
                d.layout.centre_distance(), d.chain.loaded_pitch(), 15, 42, phase);
            below      = facts.tooth_frequency < facts.driven_frequency;
            of_polygon = std::max(of_polygon, std::abs(ratio / rigid - 1.));
            of_mean    = std::max(of_mean, std::abs(ratio * 42. / 15. - 1.));
            fit        = std::max(fit, misfit(d.layout));
          }
        std::cout << text_of(side) << " span tight, tooth frequency " << (below ? "below" : "above")
                  << " the resonance" << std::endl;
        if (below)
          verdict("the polygon's speed within 0.2 %, and not the mean",
                  of_polygon < 2e-3 && of_mean > 5e-3);
        else
          verdict("the mean within 1e-12, and not the polygon's speed",
                  of_mean < 1e-12 && of_polygon > 5e-3);
        verdict("joints move with sprockets, and linearly between", fit < 1e-12);
      }
}
