// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/rest.h>

#include <optional>
#include <string>
#include <vector>

namespace chaindrive::drive
{
/// By how much the pitches of single links, as made or worn, differ from those of the dimensions of
/// their chain. m.
struct LinkPitches
{
  double              inner = 0., outer = 0.; ///< the mean of all inner links, of all outer ones
  std::vector<double> deviations; ///< of each link from the mean of its kind; empty: none

  bool   are_equal() const { return deviations.empty(); }
  double of(const unsigned int link) const { return are_equal() ? 0. : deviations[link]; }

  /// @p chain with pitches that are the means.
  ChainDimensions in(ChainDimensions chain) const;

  /// What there is to say of them, in a sentence.
  std::string in_words() const;
};

/// The pitches of the links that @p drive has: listed ones, or random ones that are evenly
/// distributed between plus and minus the tolerance, less the means of inner and outer links. They
/// come link by link from a Mersenne twister, so that a seed means one chain on every machine. @p
/// pitch is the nominal one. Without @p clearances, in the simple model, inner and outer links are
/// the same, and have one mean.
///
/// @throws InputError when a list does not go into the number of links, or makes the chain shorter,
/// for a list beside a tolerance, for Start = concentric and for a fidelity that @p is_elastic.
LinkPitches
make_link_pitches(const parameters::Drive &drive, double pitch, bool clearances, bool is_elastic);

/// Moves the joints of @p layout, whose links have the means as their pitches, along the chain's
/// path until each link has its own, and wheels along with the joints on them; the driver stays.
/// What remains is of second order: quadratic in what joints move.
void shift_joints(Layout &layout, const LinkPitches &links);

/// Puts the links of @p layout, which shift_joints() has placed, to their own pitches exactly where
/// nothing pulls at the chain: rollers in their gaps, also those that stand off their places,
/// wheels where the chain turns them.
///
/// @throws InputError, naming the entries, when teeth do not let them.
void fit_links(Layout &layout, const RestingChain &chain, const std::vector<RestingWheel> &wheels);
} // namespace chaindrive::drive
