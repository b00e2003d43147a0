// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// The law of law.h for P::width contact points at a time.

#include <chaindrive/contact/joint_kernels.h>

namespace chaindrive::contact::bodies
{
/// What one contact point remembers, see TouchEntry.
template <typename P>
struct Touches
{
  P overlap, normal, slip[2], tangential[2];
};

/// SurfaceLaw times an area.
template <typename P>
struct PointLaw
{
  P stiffness, damping, friction, tangential_stiffness, tangential_damping; ///< see scene::Law
};

/// Energies of joints, see JointSums.
template <typename P>
struct Energies
{
  P stored, damping_loss, friction_loss;
};

/// What the normal force of a point follows from.
template <typename P>
struct Approach
{
  P overlap; ///< d: of a point, max(0, -g); of a node, the mean about it; m
  P gap;     ///< g, m
  P rate;    ///< g', m/s
  P closing; ///< by how much the surfaces have come closer while they overlap, m
};

/// update_touch() of law.h with the same formulas. Nodes share the energy of the springs between
/// them as k d (-g) / 2, which for a point is its own k d^2 / 2.
template <typename P>
CHAINDRIVE_ALWAYS_INLINE void update_touches(const PointLaw<P> &law,
                                             const Approach<P> &approach,
                                             const P (&slip_rate)[2],
                                             const P      dt,
                                             const bool   with_friction,
                                             Touches<P>  &touch,
                                             Energies<P> &energies)
{
  const P          zero(0.), half(0.5);
  const Touches<P> before = touch;

  touch.overlap  = approach.overlap;
  const P spring = law.stiffness * touch.overlap;
  touch.normal =
      if_less(zero, touch.overlap, greatest(zero, spring - law.damping * approach.rate), zero);

  energies.stored -= half * spring * approach.gap;
  const P damping_before = before.normal - law.stiffness * before.overlap;
  energies.damping_loss += half * (damping_before + touch.normal - spring) * approach.closing;
  if (!with_friction)
    return;

  const P limit = law.friction * touch.normal;
  P       increment[2];
  for (int d = 0; d < 2; ++d)
    {
      increment[d]  = dt * slip_rate[d];
      touch.slip[d] = before.slip[d] + increment[d];
      touch.tangential[d] =
          zero - law.tangential_stiffness * touch.slip[d] - law.tangential_damping * slip_rate[d];
    }
  const P trial  = square_root(touch.tangential[0] * touch.tangential[0] +
                              touch.tangential[1] * touch.tangential[1]);
  const P factor = limit / trial;
  P       work(0.), stored(0.), stored_before(0.);
  for (int d = 0; d < 2; ++d)
    {
      const P slides = factor * touch.tangential[d];
      touch.slip[d] =
          if_less(limit, trial, zero - slides / law.tangential_stiffness, touch.slip[d]);
      touch.tangential[d] = if_less(limit, trial, slides, touch.tangential[d]);
      // apart: no division above counts
      touch.slip[d]       = if_less(zero, limit, touch.slip[d], zero);
      touch.tangential[d] = if_less(zero, limit, touch.tangential[d], zero);

      work += (before.tangential[d] + touch.tangential[d]) * increment[d];
      stored_before += before.slip[d] * before.slip[d];
      stored += touch.slip[d] * touch.slip[d];
    }
  stored_before = half * law.tangential_stiffness * stored_before;
  stored        = half * law.tangential_stiffness * stored;
  energies.stored += stored;
  energies.friction_loss -= half * work + (stored - stored_before);
}
} // namespace chaindrive::contact::bodies
