// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Bodies of the kernels of link_kernels.h, for `width` links at a time.

#include <chaindrive/observe/link_kernels.h>
#include <chaindrive/utilities/pack.h>

namespace chaindrive::observe::packed
{
/// follow() for the links from @p i on.
template <int width>
CHAINDRIVE_ALWAYS_INLINE bool follow_pack(const FollowedLinks &links, const unsigned int i)
{
  using P      = Pack<double, width>;
  const P zero = P(0.), now = P::load_unaligned(links.tension + i),
          last = P::load_unaligned(links.last + i), change = now - last,
          onwards = change * P::load_unaligned(links.sense + i);
  if_less(zero, onwards, now, last).store_unaligned(links.last + i);
  if_less(zero, onwards, P(links.at), P::load_unaligned(links.way + i))
      .store_unaligned(links.way + i);
  const P back = if_less(zero, onwards, zero, greatest(change, zero - change));
  return any_less(P(links.smallest), back);
}

template <int width>
bool follow(const FollowedLinks &links)
{
  bool         turned = false;
  unsigned int i      = 0;
  for (; i + width <= links.n; i += width)
    turned |= follow_pack<width>(links, i);
  for (; i < links.n; ++i)
    turned |= follow_pack<1>(links, i);
  return turned;
}

/// raise() for the numbers from @p most and @p now on.
template <int width>
CHAINDRIVE_ALWAYS_INLINE void raise_pack(double *most, const double *now)
{
  using P        = Pack<double, width>;
  const P so_far = P::load_unaligned(most), x = P::load_unaligned(now);
  if_less(so_far, x, x, so_far).store_unaligned(most);
}

template <int width>
void raise(double *most, const double *now, const unsigned int n)
{
  unsigned int i = 0;
  for (; i + width <= n; i += width)
    raise_pack<width>(most + i, now + i);
  for (; i < n; ++i)
    raise_pack<1>(most + i, now + i);
}

template <int width>
bool any_above(const double *now, const unsigned int n, const double limit)
{
  using P          = Pack<double, width>;
  bool         any = false;
  unsigned int i   = 0;
  for (; i + width <= n; i += width)
    any |= any_less(P(limit), P::load_unaligned(now + i));
  for (; i < n; ++i)
    any |= now[i] > limit;
  return any;
}

template <int width>
constexpr LinkKernels make_link_kernels()
{
  return {width, &follow<width>, &raise<width>, &any_above<width>};
}
} // namespace chaindrive::observe::packed
