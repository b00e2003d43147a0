// SPDX-License-Identifier: LGPL-2.1-or-later
// Tensioners that cannot be are refused with the entry, the value and what is allowed. One whose
// travel does not suffice rests on its stop, with slack.
#include "compare.h"
#include "idler_drive.h"

#include <chaindrive/drive/centre_distance.h>
#include <chaindrive/drive/drive.h>

#include <array>
#include <functional>

using namespace chaindrive;

namespace
{
/// Driver, idler below the lower span on an arm, driven sprocket.
Parameters tensioned()
{
  Parameters p       = idler_drive(-1, {{0.19, -0.066}}, {{0.11, -0.1}});
  auto      &held    = p.drive.sprockets.list[1].held;
  held.holder        = parameters::Holder::arm;
  held.arm.preload   = 6.;
  held.arm.stiffness = 8.;
  held.slide.preload = 80.;
  held.direction     = 1.5;
  return p;
}

void refuse(const std::string &what, const std::function<void(Parameters &)> &change)
{
  expect_refusal(what, [&change]() {
    Parameters p = tensioned();
    change(p);
    drive::make_drive(p);
  });
}
} // namespace

int main()
{
  using parameters::Holder;
  const auto idler = [](Parameters &p) -> parameters::Sprocket & {
    return p.drive.sprockets.list[1];
  };
  refuse("loaded", [&](Parameters &p) { idler(p).role = parameters::Role::driven; });
  refuse("without a centre", [&](Parameters &p) { idler(p).centre.reset(); });
  refuse("without a pivot", [&](Parameters &p) { idler(p).held.pivot.reset(); });
  refuse("pivot in its centre", [&](Parameters &p) { idler(p).held.pivot = idler(p).centre; });
  refuse("two of them", [&](Parameters &p) {
    auto &list = p.drive.sprockets.list;
    list.push_back(list[1]);
    list.back().name = "other";
  });
  refuse("sag", [](Parameters &p) {
    p.drive.layout.centre_distance_from = parameters::CentreDistanceFrom::sag;
  });
  refuse("concentric", [](Parameters &p) { p.drive.layout.start = parameters::Start::concentric; });
  refuse("stops the wrong way round", [&](Parameters &p) {
    idler(p).held.arm.least = 0.1;
    idler(p).held.arm.most  = -0.1;
  });
  refuse("nothing presses",
         [&](Parameters &p) { idler(p).held.arm.preload = idler(p).held.arm.stiffness = 0.; });
  refuse("along the chain", [&](Parameters &p) {
    idler(p).held.holder    = Holder::slide;
    idler(p).held.direction = 0.05;
  });
  refuse("chain too short for the least travel", [&](Parameters &p) {
    p.drive.n_links -= 2;
    idler(p).held.arm.least = -0.02;
  });
  refuse("chain far too long", [](Parameters &p) { p.drive.n_links += 40; });
  refuse("chain far too short", [](Parameters &p) { p.drive.n_links -= 20; });
  refuse("chain that cannot be laid", [](Parameters &p) { p.drive.n_links = 40; });

  Parameters p           = tensioned();
  idler(p).held.arm.most = 0.01;
  p.drive.n_links += 2;
  const drive::Layout layout = drive::make_drive(p).layout;
  verdict("on its greatest stop there is slack",
          std::abs(layout.tensioner->travel - 0.01) < 1e-4 && layout.slack().slack > 5e-3);

  // a worn chain is taken up: travel grows with its elongation
  double before = -1.;
  bool   grows  = true;
  for (const double elongation : {0., 0.001, 0.002})
    {
      Parameters worn             = tensioned();
      worn.drive.chain.elongation = elongation;
      const double travel         = drive::make_drive(worn).layout.tensioner->travel;
      grows                       = grows && travel > before;
      before                      = travel;
    }
  verdict("wear is taken up", grows);

  // slack that decides the centre distance is that without travel
  Parameters from_slack                        = tensioned();
  from_slack.drive.layout.centre_distance_from = parameters::CentreDistanceFrom::slack;
  from_slack.drive.layout.centre_distance      = 0.4;
  from_slack.drive.layout.slack                = 4e-3;
  from_slack.drive.sprockets.list[2].centre.reset();
  const drive::Drive found = drive::make_drive(from_slack);
  from_slack.drive         = drive::without_tensioner(from_slack.drive);
  const drive::Drive still = drive::make_drive(from_slack);
  verdict("slack is that without travel",
          std::abs(found.layout.centre_distance() - still.layout.centre_distance()) < 1e-9);
  verdict("and is taken up", found.layout.tensioner->travel > 0.01);
}
