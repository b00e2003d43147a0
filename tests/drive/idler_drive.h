// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/centre_distance.h>
#include <chaindrive/parameters/parameters.h>

#include <array>

/// An 08B chain over a driver of 17 teeth in the origin, an idler of 13 and a driven sprocket of
/// 38, 405 mm away, in simple fidelity. The idler is below the lower span: inside of the loop for
/// @p turn +1, outside for -1. As many links as leave slack to be taken up where all centres are
/// given, as they are.
inline chaindrive::Parameters
idler_drive(const int turn, const std::array<double, 2> &centre, const std::array<double, 2> &pivot)
{
  chaindrive::Parameters p;
  p.model.fidelity          = "simple";
  p.drive.chain.designation = "08B";
  p.drive.sprockets.set_order({"driver", "idler", "driven"});
  auto &list                          = p.drive.sprockets.list;
  list[0].teeth                       = 17;
  list[1].teeth                       = 13;
  list[2].teeth                       = 38;
  list[1].turn                        = turn;
  list[1].centre                      = centre;
  list[1].held.pivot                  = pivot;
  list[2].centre                      = std::array<double, 2>{{0.405, 0.}};
  p.drive.layout.centre_distance_from = chaindrive::parameters::CentreDistanceFrom::given;
  p.drive.n_links                     = chaindrive::drive::number_of_links(p.drive);
  return p;
}
