// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Plain structures and plain pointers only: the kernels are compiled for several instruction sets
// (see utilities/pack.h).

namespace chaindrive::observe
{
/// The tensions of links and what is remembered of each, in arrays over n links.
struct FollowedLinks
{
  const double *tension; ///< now, N
  double       *last;    ///< as far as it has gone in its sense, N
  double       *way;     ///< when it was so
  const double *sense;   ///< 1: it rises, -1: it falls, 0: not known
  unsigned int  n;
  double        at;       ///< now, as way
  double        smallest; ///< change that counts, N
};

/// What is done with all links or joints at every step, by one instruction set.
struct LinkKernels
{
  int width; ///< numbers that the machine computes at a time
  /// Where tensions go on in their sense, last and way become those of now. Returns whether one has
  /// turned: it has changed by more than the smallest otherwise.
  bool (*follow)(const FollowedLinks &);
  /// Each of @p n numbers in @p most becomes that of @p now where that is larger.
  void (*raise)(double *most, const double *now, unsigned int n);
  /// Whether one of @p n numbers is above @p limit.
  bool (*any_above)(const double *now, unsigned int n, double limit);
};

/// Kernels of @p width 1, 2, 4 or 8 numbers; null where this machine has none, as with
/// element::kernels().
const LinkKernels *link_kernels(int width);
} // namespace chaindrive::observe
