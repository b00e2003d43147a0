// SPDX-License-Identifier: LGPL-2.1-or-later
// Idlers that are moved until the chain has the slack, sag or pre-tension that is asked for, and
// clamped: eccentrics and slots of 48 random drives. With the wheel on a bearing where it was
// found the chain has that slack or sag; with pre-tension the links are stretched by it.
#include "compare.h"
#include "idler_drive.h"

#include <chaindrive/drive/centre_distance.h>
#include <chaindrive/drive/drive.h>
#include <chaindrive/drive/hanging_span.h>
#include <chaindrive/drive/tensioner.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <array>
#include <random>

using namespace chaindrive;
using dealii::Point;
using dealii::numbers::PI;
using parameters::CentreDistanceFrom;
using parameters::Holder;

namespace
{
constexpr double stiffness = 2e7; // N/m, per pitch

/// Driver, idler that presses the lower span out or in by about @p depth [m], driven sprocket.
Parameters with_idler(const int turn, const double depth)
{
  const double y                      = turn < 0 ? depth - 0.08 : -0.029 - depth;
  Parameters   p                      = idler_drive(turn, {{0.19, y}}, {{0.11, y - 0.02}});
  p.model.stiffness_per_pitch         = stiffness;
  p.drive.layout.centre_distance_from = CentreDistanceFrom::slack;
  return p;
}

Parameters random_drive(std::mt19937 &random)
{
  const auto between = [&random](const double low, const double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto   yes   = [&random]() { return std::bernoulli_distribution(0.5)(random); };
  const double depth = between(0.004, 0.012);
  Parameters   p     = with_idler(yes() ? 1 : -1, depth);
  p.drive.sprockets.list[1].held.direction = between(1., 2.);
  p.drive.sprockets.list[1].held.holder    = yes() ? Holder::eccentric : Holder::slot;
  parameters::Layout      &layout          = p.drive.layout;
  const CentreDistanceFrom kinds[]         = {
              CentreDistanceFrom::slack, CentreDistanceFrom::sag, CentreDistanceFrom::pretension};
  layout.centre_distance_from = kinds[random() % 3];
  layout.slack                = between(0., 4e-3);
  layout.sag                  = between(0.005, 0.03);
  layout.pretension           = between(50., 500.);
  layout.start_phase          = between(0., 0.99);
  layout.tight_span           = yes() ? parameters::TightSide::upper : parameters::TightSide::lower;
  return p;
}

/// The drive of @p p with its idler on a bearing where @p layout has it.
Parameters on_a_bearing(Parameters p, const drive::Layout &layout)
{
  const Point<2> at                     = layout.sprockets[1].centre;
  p.drive.sprockets.list[1].centre      = std::array<double, 2>{{at[0], layout.sense * at[1]}};
  p.drive.sprockets.list[1].held.holder = Holder::bearing;
  p.drive.layout.centre_distance_from   = CentreDistanceFrom::given;
  return p;
}

/// Of the spans, from the stretch of the links in their middles, N.
double mean_tension(const drive::Drive &d)
{
  const auto &joints = d.layout.joints;
  double      sum    = 0.;
  for (const drive::Layout::Span &span : d.layout.spans)
    {
      const unsigned int k = (span.first + span.links / 2) % joints.size();
      sum += stiffness * (joints[k].bush.distance(joints[(k + 1) % joints.size()].bush) -
                          d.chain.loaded_pitch());
    }
  return sum / d.layout.spans.size();
}
} // namespace

int main()
{
  std::mt19937 random(36);
  double       slack = 0., sag = 0., tension = 0., off_track = 0., furthest = 0.;
  unsigned int refused = 0, laid_alike = 0, eccentrics = 0, outside = 0, mirrored = 0,
               kinds[3] = {0, 0, 0};
  for (unsigned int i = 0; i < 48; ++i)
    {
      const Parameters p = random_drive(random);
      drive::Drive     d;
      try
        {
          d = drive::make_drive(p);
        }
      catch (const InputError &) // the hanging span lies on a tooth of the idler
        {
          ++refused;
          continue;
        }
      const parameters::Layout &given  = p.drive.layout;
      const drive::Tensioner   &at     = *d.layout.clamped;
      const Point<2>            centre = d.layout.sprockets[1].centre;
      eccentrics += at.is_arm();
      outside += p.drive.sprockets.list[1].turn < 0;
      mirrored += d.layout.sense < 0;
      furthest = std::max(furthest, std::abs(at.travel) * at.lever());

      const Point<2> reference((*p.drive.sprockets.list[1].centre)[0],
                               d.layout.sense * (*p.drive.sprockets.list[1].centre)[1]);
      const auto     moved = centre - reference;
      off_track =
          std::max(off_track,
                   at.is_arm() ? std::abs(centre.distance(at.pivot) / at.lever() - 1.) :
                                 std::abs(moved[0] * at.direction[1] - moved[1] * at.direction[0]));
      if (given.centre_distance_from == CentreDistanceFrom::pretension)
        {
          tension = std::max(tension, std::abs(mean_tension(d) / given.pretension - 1.));
          ++kinds[2];
          continue;
        }
      // on a bearing the chain may be laid with another number of joints on a wheel
      const drive::Layout still = drive::make_drive(on_a_bearing(p, d.layout)).layout;
      const bool          same  = still.spans[0].links == d.layout.spans[0].links &&
                        still.sprockets[1].seats == d.layout.sprockets[1].seats;
      laid_alike += same;
      const bool by_slack = given.centre_distance_from == CentreDistanceFrom::slack;
      ++kinds[by_slack ? 0 : 1];
      for (const drive::Layout *layout : std::array<const drive::Layout *, 2>{{&d.layout, &still}})
        if (layout == &d.layout || same)
          {
            if (by_slack)
              slack = std::max(slack, std::abs(layout->slack().slack - given.slack));
            else
              sag = std::max(sag, std::abs(drive::relative_sag(*layout) / given.sag - 1.));
          }
    }
  std::cout << "48 drives: " << eccentrics << " eccentrics, " << outside << " outside of the loop, "
            << mirrored << " mirrored; " << kinds[0] << " with slack, " << kinds[1] << " with sag, "
            << kinds[2] << " with pre-tension; " << refused << " refused, " << laid_alike
            << " laid alike on a bearing\n";
  verdict("wheels are on the circles of their eccentrics, or the lines of their slots",
          off_track < 1e-12);
  verdict("some have moved by more than 3 mm", furthest > 3e-3);
  verdict("the chain has the slack to 1 nm", slack < 1e-9);
  verdict("and the sag to 1e-6", sag < 1e-6);
  verdict("and the pre-tension to 1e-3", tension < 1.0001e-3);

  // a worn chain whose shafts are kept has the place that the new one had
  Parameters p                          = with_idler(-1, 0.008);
  p.drive.sprockets.list[1].held.holder = Holder::eccentric;
  p.drive.layout.slack                  = 1e-3;
  const drive::Layout as_new            = drive::make_drive(p).layout;
  p.drive.chain.elongation              = 0.004;
  p.drive.layout.worn_chain             = parameters::WornChain::shafts_kept;
  const drive::Layout worn              = drive::make_drive(p).layout;
  verdict("the shafts of a worn chain are kept",
          worn.sprockets[1].centre.distance(as_new.sprockets[1].centre) < 1e-12 &&
              worn.slack().slack > 3e-3);

  // outside of the loop, a chain is tightened as the distance of the wheel falls
  p                                   = with_idler(-1, 0.008);
  p.drive.sprockets.list[1].direction = std::atan2(-0.072, 0.19);
  p.drive.sprockets.list[1].centre.reset();
  p.drive.layout.centre_distance      = std::hypot(0.19, 0.072);
  p.drive.layout.centre_distance_from = CentreDistanceFrom::pretension;
  p.drive.layout.pretension           = 200.;
  verdict("a wheel outside of the loop has the pre-tension, too",
          std::abs(mean_tension(drive::make_drive(p)) / 200. - 1.) < 1.0001e-3);

  p.model.fidelity                      = "full"; // clamped wheels are for all
  p.drive                               = with_idler(-1, 0.008).drive;
  p.drive.sprockets.list[1].held.holder = Holder::eccentric;
  verdict("in an elastic model as well", drive::make_drive(p).layout.clamped.has_value());

  const auto refuse = [](const std::string &what, const auto &change) {
    expect_refusal(what, [&change]() {
      Parameters q                          = with_idler(-1, 0.008);
      q.drive.sprockets.list[1].held.holder = Holder::eccentric;
      change(q);
      drive::make_drive(q);
    });
  };
  refuse("given",
         [](Parameters &q) { q.drive.layout.centre_distance_from = CentreDistanceFrom::given; });
  refuse("two links too many for its stop", [](Parameters &q) {
    q.drive.n_links += 2;
    q.drive.sprockets.list[1].held.arm.most = 0.05;
  });
}
