// SPDX-License-Identifier: LGPL-2.1-or-later
// With which speed the driven side of a settled start turns, over the driver's: below its resonance
// the one of a rigid tight span (four-bar linkage), above it the mean, at any phase. Joints move
// with their sprockets. In spans they run along their polygon, which cannot follow the rollers at
// its ends, but for a drive so slow that its spans swing with them: then linearly from one end to
// the other.
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

/// How far the joints are from moving with their sprockets, over the speed of the chain.
double misfit_on_sprockets(const drive::Layout &layout)
{
  double worst = 0.;
  for (const auto &joint : layout.joints)
    if (joint.sprocket >= 0)
      {
        const auto &sprocket = layout.sprockets[joint.sprocket];
        // what bears on a seat may be off its centre
        const auto                 arm = joint.roller - sprocket.centre;
        const dealii::Tensor<1, 2> turned({-sprocket.speed * arm[1], sprocket.speed * arm[0]});
        worst = std::max(worst, (joint.velocity - turned).norm());
      }
  return worst / layout.joints[0].velocity.norm();
}

/// How far the joints in spans are from the mean of their neighbours, and from moving along the
/// line between these at the mean of speeds, over the speed of the chain.
struct InSpans
{
  double swing = 0., run = 0.;
};

InSpans misfit_in_spans(const drive::Layout &layout)
{
  InSpans    worst;
  const auto joint = [&](const unsigned int k) -> const drive::Layout::Joint & {
    return layout.joints[k % layout.joints.size()];
  };
  for (const auto &span : layout.spans)
    {
      // along the span: of the ends, the parts that pull at it
      const auto speed = [&](const unsigned int i) {
        const unsigned int k   = span.first + i;
        const auto         way = i == 0          ? joint(k + 1).bush - joint(k).bush :
                                 i == span.links ? joint(k).bush - joint(k - 1).bush :
                                                   joint(k + 1).bush - joint(k - 1).bush;
        return joint(k).velocity * way / way.norm();
      };
      for (unsigned int i = 1; i < span.links; ++i)
        {
          const unsigned int k = span.first + i;
          worst.swing          = std::max(
              worst.swing,
              (joint(k - 1).velocity - 2. * joint(k).velocity + joint(k + 1).velocity).norm());
          const double across =
              std::sqrt(std::max(0., joint(k).velocity.norm_square() - speed(i) * speed(i)));
          worst.run =
              std::max({worst.run, across, std::abs(speed(i - 1) - 2. * speed(i) + speed(i + 1))});
        }
    }
  const double of_chain = layout.joints[0].velocity.norm();
  return {worst.swing / of_chain, worst.run / of_chain};
}
} // namespace

int main()
{
  for (const auto side : {parameters::TightSide::upper, parameters::TightSide::lower})
    for (const double inertia : {3e-3, 0.3})
      {
        double of_polygon = 0., of_mean = 0., on_sprockets = 0., along = 0.;
        bool   below = false;
        for (const double phase : phases)
          {
            const Parameters   p     = at(phase, inertia, side);
            const drive::Drive d     = drive::make_drive(p);
            const drive::Facts facts = drive::make_facts(p, d);
            const double       ratio = d.layout.sprockets[1].speed / d.layout.sprockets[0].speed;
            const double       rigid = drive::four_bar_ratio(
                d.layout.centre_distance(), d.chain.loaded_pitch(), 15, 42, phase);
            below        = facts.tooth_frequency < facts.driven_frequency;
            of_polygon   = std::max(of_polygon, std::abs(ratio / rigid - 1.));
            of_mean      = std::max(of_mean, std::abs(ratio * 42. / 15. - 1.));
            on_sprockets = std::max(on_sprockets, misfit_on_sprockets(d.layout));
            along        = std::max(along, misfit_in_spans(d.layout).run);
          }
        std::cout << text_of(side) << " span tight, tooth frequency " << (below ? "below" : "above")
                  << " the resonance" << std::endl;
        if (below)
          verdict("the polygon's speed within 0.2 %, and not the mean",
                  of_polygon < 2e-3 && of_mean > 5e-3);
        else
          verdict("the mean within 1e-12, and not the polygon's speed",
                  of_mean < 1e-12 && of_polygon > 5e-3);
        verdict("joints move with sprockets", on_sprockets < 1e-12);
        verdict("and along the polygon between", along < 1e-7); // a difference of squares
      }
  Parameters slow          = at(0.3, 3e-3, parameters::TightSide::upper);
  slow.loads.driver_speed  = 0.2;
  const drive::Drive d     = drive::make_drive(slow);
  const drive::Facts facts = drive::make_facts(slow, d);
  for (const auto &span : facts.spans)
    verdict("tooth frequency below that of a span", facts.tooth_frequency < 0.4 * span.frequency);
  verdict("joints move with sprockets, and linearly between",
          misfit_on_sprockets(d.layout) < 1e-12 && misfit_in_spans(d.layout).swing < 1e-12);
}
