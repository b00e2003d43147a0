// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// The law of law.h for P::width contact points at a time.

#include <chaindrive/contact/joint_kernels.h>

namespace chaindrive::contact::packed
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
  P stiffness, damping, friction, tangential_stiffness,
      tangential_damping; ///< see scene::ContactLaw
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

/// Length of a vector in the tangents' plane.
template <typename P>
CHAINDRIVE_ALWAYS_INLINE P length(const P (&v)[2])
{
  return square_root(v[0] * v[0] + v[1] * v[1]);
}

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

  const P    limit        = law.friction * touch.normal;
  const auto within_limit = [&limit](const P &size) {
    return if_less(limit, size, limit / size, P(1.));
  };
  P increment[2], elastic[2];
  for (int d = 0; d < 2; ++d)
    {
      increment[d] = dt * slip_rate[d];
      elastic[d]   = before.slip[d] + increment[d];
    }
  const P elastic_part = within_limit(law.tangential_stiffness * length(elastic));
  for (int d = 0; d < 2; ++d)
    {
      touch.slip[d] = elastic_part * elastic[d];
      touch.tangential[d] =
          zero - law.tangential_stiffness * touch.slip[d] - law.tangential_damping * slip_rate[d];
    }
  const P part = within_limit(length(touch.tangential));
  P       work(0.), stored(0.), stored_before(0.);
  for (int d = 0; d < 2; ++d)
    {
      touch.tangential[d] = part * touch.tangential[d];
      work += (before.tangential[d] + touch.tangential[d]) * increment[d];
      stored_before += before.slip[d] * before.slip[d];
      stored += touch.slip[d] * touch.slip[d];
    }
  stored_before = half * law.tangential_stiffness * stored_before;
  stored        = half * law.tangential_stiffness * stored;
  energies.stored += stored;
  energies.friction_loss -= half * work + (stored - stored_before);
}
} // namespace chaindrive::contact::packed
