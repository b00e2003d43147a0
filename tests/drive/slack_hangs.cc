// SPDX-License-Identifier: LGPL-2.1-or-later

// The slack span hangs along gravity wherever the next sprocket stands: right or left of the
// driver, above or below it, with either span tight. Without gravity it bulges outwards. On start a
// straight line through its ends has the middle joint on the right side of it, by the span's sag.

#include "compare.h"
#include "forms.h"

#include <chaindrive/drive/layout.h>

#include <array>

using namespace chaindrive;

namespace
{
void hang(const std::string          &where,
          const std::array<double, 2> centre,
          const parameters::TightSide side,
          const bool                  weightless)
{
  parameters::Drive drive;
  drive.layout.tight_span           = side;
  drive.layout.centre_distance_from = parameters::CentreDistanceFrom::given;
  drive.layout.centre_distance      = std::hypot(centre[0], centre[1]);
  drive.sprockets.list[0].centre    = std::array<double, 2>{{0., 0.}};
  drive.sprockets.list[1].centre    = centre;
  const auto          chain         = drive::make_chain(drive.chain);
  const drive::Layout layout        = drive::make_layout(
      drive, chain, forms_of(drive, chain), false, 3e8, 120.74, 1412., weightless);
  const drive::Layout::Span &slack = layout.slack();
  const auto                 n     = layout.joints.size();
  const auto                 at    = [&](const unsigned int k) -> const dealii::Point<2>                    &{
    return layout.joints[(slack.first + k) % n].bush;
  };
  const dealii::Tensor<1, 2> sag    = at(slack.links / 2) - 0.5 * (at(0) + at(slack.links)),
                             across = sag - (sag * slack.direction) * slack.direction;
  verdict(where + (side == parameters::TightSide::lower ? ", lower" : ", upper") +
              (weightless ? ", weightless: outwards" : ": down"),
          slack.sag > 1e-3 && across.norm() > 0.9 * slack.sag &&
              (weightless ? across * slack.normal > 0. : across[1] < 0.));
}
} // namespace

int main()
{
  const double distance = 0.6425;
  for (const bool weightless : {false, true})
    for (const auto side : {parameters::TightSide::upper, parameters::TightSide::lower})
      for (const auto &[where, angle] : {std::make_pair("right", 0.),
                                         std::make_pair("right and up", 60.),
                                         std::make_pair("left and up", 120.),
                                         std::make_pair("left", 180.),
                                         std::make_pair("left and down", 240.),
                                         std::make_pair("right and down", 300.)})
        hang(where,
             {{distance * std::cos(angle / 57.29578), distance * std::sin(angle / 57.29578)}},
             side,
             weightless);
}
