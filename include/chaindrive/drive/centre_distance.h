// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/fit.h>
#include <chaindrive/drive/tooth_form.h>
#include <chaindrive/parameters/drive.h>

#include <optional>
#include <string>
#include <vector>

namespace chaindrive::drive
{
/// What a layout may be, the best first. With a target the centre distances are approximate, and
/// each route is yet to be solved for its own.
struct Proposal
{
  std::optional<Fitter::Target> target; ///< none for a given centre distance
  std::vector<Fit>              fits;
};

/// @param least_distance  at which the sprockets touch, m
/// @param even            whether advice is for an even number of links
/// @throws InputError when the chain does not reach or the sprockets overlap.
Proposal
propose(const Fitter &fitter, const parameters::Layout &layout, double least_distance, bool even);

/// Whether the wheels of @p fitter may be where they are with the one that moves at the distance
/// or travel @p c: apart from each other, in a loop.
bool may_be(const Fitter &fitter, double c);

/// Makes the tensioner of @p drive what moves in its @p fitter: all other wheels stay, and the
/// sense of its travel is the one in which slack falls. InputError where it moves along the chain
/// and takes up next to nothing.
void set_tensioner(const parameters::Drive &drive, Fitter &fitter);

/// What the slack span has where the layout finds the place of a wheel: the slack or sag of @p
/// layout; none with pre-tension, where the link lengths hold the stretch.
Fitter::Target wanted(const parameters::Layout &layout);

/// The travel of the tensioner of @p fitter that meets the @p target; at its greatest one where
/// even this leaves more and it has a spring.
/// @throws InputError when the chain is too short for the least travel, or too long for any with
/// which wheels are apart.
Proposal
take_up(const Fitter &fitter, const Fitter::Target &target, const std::string &wheel, bool even);

/// Refuses (InputError) wheels of which more than one is to be found, that overlap, whatever the
/// distance of the one that is found, or round which the chain would cross itself.
void check_wheels(const parameters::Sprockets  &sprockets,
                  const parameters::Layout     &layout,
                  const std::vector<ToothForm> &forms,
                  const Fitter                 &fitter);

/// Whether the slack of @p fitter, of more than two wheels, grows with the distance of the one that
/// is found, about the distance @p at [m].
bool slack_rises(const Fitter &fitter, double at);

/// Refuses (InputError) wheels round which a chain does not run as it should: with wraps that are
/// less than a turn the directions of its spans must turn once, counter-clockwise.
void check_loop(const std::vector<path::Wheel> &wheels);

/// The number of links, even, for Drive/Layout/Centre distance: the length of the chain in pitches
/// p is, for pitch circles of the radii r1 and r2 at the distance C and a = asin((r2 - r1) / C),
///
///   X = 2 C cos(a) / p + (z1 + z2) / 2 + (z2 - z1) a / pi,
///
/// rounded to the nearest even number; up where the centre distance is given and nothing adjusts
/// it, and where all centres are given, so that there is slack for a wheel that takes it up. Of a
/// new chain. InputError where the sprockets would overlap, or for an unknown chain.
unsigned int number_of_links(const parameters::Drive &drive);

/// What a chain round the wheels with the one that moves at the distance or travel @p c would have
/// to be longer to be taut, m, also where it is far too short to be laid; below zero it has slack.
/// Not a number where a chain closes on no route.
double missing_length(Fitter fitter, double c);

/// That the chain is too short by missing_length(), and what to choose; from its subject on.
std::string too_short(const Fitter &fitter, double c, bool even);

/// The number of links that makes up for the length @p missing [m], negative when there is too
/// much.
std::string advised_links(const Fitter &fitter, double missing, bool even);
} // namespace chaindrive::drive
