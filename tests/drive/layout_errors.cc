// SPDX-License-Identifier: LGPL-2.1-or-later

// Drives that cannot be laid: each refusal says what would fit.

#include "compare.h"
#include "forms.h"
#include "idler_drive.h"

#include <chaindrive/drive/layout.h>

using namespace chaindrive;

namespace
{
void refuse(const std::string &what, const parameters::Drive &drive, const bool clearances = false)
{
  expect_refusal(what, [&] {
    const auto chain = drive::make_chain(drive.chain);
    drive::make_layout(drive, chain, forms_of(drive, chain), clearances, 3e8, 0., 0.);
  });
}
} // namespace

int main()
{
  using parameters::Drive;
  Drive d;
  d.layout.centre_distance_from = parameters::CentreDistanceFrom::given;
  d.layout.centre_distance      = 0.65;
  refuse("too few links for the centre distance", d);
  refuse("too few links, clearances", d, true);
  d.layout.centre_distance = 0.14;
  refuse("sprockets that overlap", d);
  d.layout.centre_distance = 0.3;
  refuse("far too many links", d);

  d         = Drive();
  d.n_links = 30;
  refuse("a chain that does not reach around", d);
  d         = Drive();
  d.n_links = 111;
  refuse("odd number of links with clearances", d, true);
  d              = Drive();
  d.layout.slack = 1.2;
  refuse("more slack than there is", d);
  d.layout.slack = 0.12;
  refuse("more slack than a span can hang through", d);

  d                                    = Drive();
  d.sprockets.seat_centre              = parameters::SeatCentre::bottom_diameter;
  d.sprockets.driver().bottom_diameter = 66.28e-3;
  d.sprockets.driven().bottom_diameter = 202.82e-3;
  refuse("bottom diameters too large for the chain", d);
  refuse("bottom diameters too large for the chain, clearances", d, true);

  d                          = Drive();
  d.sprockets.driver().teeth = d.sprockets.driven().teeth = 9;
  d.layout.tight_span                                     = parameters::TightSide::lower;
  d.layout.centre_distance_from                           = parameters::CentreDistanceFrom::sag;
  d.layout.sag                                            = 0.1;
  refuse("slack span that would lie on the tight one", d);
  d                             = Drive();
  d.layout.start                = parameters::Start::concentric;
  d.layout.centre_distance_from = parameters::CentreDistanceFrom::pretension;
  refuse("pre-tension without contact", d, true);
  d.layout.centre_distance_from = parameters::CentreDistanceFrom::given;
  refuse("concentric joints at a distance for a taut chain", d, true);
  d                    = Drive();
  d.layout.start_phase = 1.;
  refuse("start phase", d);

  // three wheels: none of the spans can be as short as so few links are
  d                             = idler_drive(-1, {{0.19, -0.066}}, {{0.11, -0.1}}).drive;
  d.n_links                     = 60;
  d.layout.centre_distance_from = parameters::CentreDistanceFrom::given;
  refuse("a chain that is far too short for given centres", d);
  d.sprockets.list[2].centre.reset();
  d.layout.centre_distance_from = parameters::CentreDistanceFrom::slack;
  d.layout.centre_distance      = 0.4;
  d.layout.slack                = 0.;
  refuse("a chain that is far too short where the search begins", d);
}
