// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// The one penalty and friction evaluation, for one slave point (Number is double) or for as many as
// a Pack has. Plain structures only: the kernels are compiled for several instruction sets, see
// utilities/pack.h.

#include <chaindrive/scene/contact_law.h>
#include <chaindrive/utilities/pack.h>

namespace chaindrive::contact
{
/// What one slave point remembers from step to step. Of motion in the plane there is one tangent.
template <typename Number, int n_tangents = 2>
struct TouchStateOf
{
  Number penetration{};            ///< penetration of the last evaluation, m; 0 when apart
  Number normal{};                 ///< force along the master's normal, N, never negative
  Number slip[n_tangents]{};       ///< elastic part of the slip in the master's tangents, m
  Number tangential[n_tangents]{}; ///< force on the slave along the master's tangents, N
};

using TouchState = TouchStateOf<double>;

/// Energies of contact that an evaluation adds to: what springs hold now, and losses since the
/// start; J.
template <typename Number>
struct ContactEnergies
{
  Number stored, damping_loss, friction_loss;
};

// An approach says how deep and how fast the surfaces come together, and what the normal force
// stores and loses. There are three: of a point by itself, of one whose spring gets stiffer, and of
// a node that stands for the surface about it.

/// The approach of a point by itself: its penetration is d = max(0, -g), its spring holds k d^2 /
/// 2.
template <typename Number>
struct PointApproach
{
  Number gap;  ///< g, negative when the surfaces overlap, m
  Number rate; ///< g', m/s

  CHAINDRIVE_ALWAYS_INLINE Number penetration() const
  {
    return greatest(Number(0.), Number(0.) - gap);
  }

  /// What the spring bears at the penetration @p d [m], N.
  CHAINDRIVE_ALWAYS_INLINE Number spring(const scene::ContactLawOf<Number> &law,
                                         const Number                       d) const
  {
    return law.stiffness * d;
  }

  /// The work of the normal force over the step, by the trapezoidal rule, is stored in the spring
  /// or lost in the dashpot: of (N0 + N) (d - d0) / 2 the spring takes k (d^2 - d0^2) / 2. In the
  /// step in which the surfaces meet central differences let the dashpot's force, which begins with
  /// a jump, act on all of the way -g' dt, also where it was not yet there: what it takes is lost.
  template <int n_tangents>
  CHAINDRIVE_ALWAYS_INLINE void book(const scene::ContactLawOf<Number>      &law,
                                     const TouchStateOf<Number, n_tangents> &before,
                                     const TouchStateOf<Number, n_tangents> &now,
                                     const Number                            dt,
                                     ContactEnergies<Number>                &energies) const
  {
    const Number half(0.5);
    const Number springs = law.stiffness * (before.penetration + now.penetration);
    const Number closing = if_less(Number(0.),
                                   before.penetration,
                                   now.penetration - before.penetration,
                                   Number(0.) - rate * dt);
    energies.stored += half * law.stiffness * now.penetration * now.penetration;
    energies.damping_loss += half * (before.normal + now.normal - springs) * closing;
  }
};

/// The spring of drive::StiffnessCurve at one place.
template <typename Number>
struct CurvedSpring
{
  Number first;  ///< N/m
  Number growth; ///< half of that of the tangent stiffness up to the depth, N/m2
  Number depth;  ///< m

  CHAINDRIVE_ALWAYS_INLINE Number force(const Number d) const
  {
    const Number beyond = greatest(Number(0.), d - depth);
    return first * d + growth * (d * d - beyond * beyond);
  }

  /// What it stores, J.
  CHAINDRIVE_ALWAYS_INLINE Number energy(const Number d) const
  {
    const Number beyond = greatest(Number(0.), d - depth);
    return Number(0.5) * first * d * d +
           Number(1. / 3.) * growth * (d * d * d - beyond * beyond * beyond);
  }
};

/// The approach of a point by itself on a curved spring, in whose place that of the law is not
/// there.
template <typename Number>
struct CurvedApproach
{
  Number               gap;           ///< g, negative when the surfaces overlap, m
  Number               rate;          ///< g', m/s
  CurvedSpring<Number> curve, before; ///< now, and where the contact was at the last evaluation

  CHAINDRIVE_ALWAYS_INLINE Number penetration() const
  {
    return greatest(Number(0.), Number(0.) - gap);
  }

  CHAINDRIVE_ALWAYS_INLINE Number spring(const scene::ContactLawOf<Number> &, const Number d) const
  {
    return curve.force(d);
  }

  /// As of PointApproach. The work of the spring by the trapezoidal rule is what it stores but for
  /// the third power of the step, of either sign.
  template <int n_tangents>
  CHAINDRIVE_ALWAYS_INLINE void book(const scene::ContactLawOf<Number> &,
                                     const TouchStateOf<Number, n_tangents> &before,
                                     const TouchStateOf<Number, n_tangents> &now,
                                     const Number                            dt,
                                     ContactEnergies<Number>                &energies) const
  {
    const Number springs = this->before.force(before.penetration) + curve.force(now.penetration);
    const Number closing = if_less(Number(0.),
                                   before.penetration,
                                   now.penetration - before.penetration,
                                   Number(0.) - rate * dt);
    energies.stored += curve.energy(now.penetration);
    energies.damping_loss += Number(0.5) * (before.normal + now.normal - springs) * closing;
  }
};

/// The approach of a node: its penetration is the mean of that of the surface about it, of which it
/// has a share also when only its neighbour overlaps. Nodes share the energy of the springs between
/// them as k d (-g) / 2, which for a point by itself is its own k d^2 / 2.
template <typename Number>
struct NodeApproach
{
  Number mean_penetration; ///< d, m
  Number gap;              ///< g, at the node, m
  Number rate;             ///< g', m/s
  Number closing;          ///< by how much the surfaces have come closer over the step, m

  CHAINDRIVE_ALWAYS_INLINE Number penetration() const { return mean_penetration; }

  CHAINDRIVE_ALWAYS_INLINE Number spring(const scene::ContactLawOf<Number> &law,
                                         const Number                       d) const
  {
    return law.stiffness * d;
  }

  /// What the normal force is more than that of the spring is the dashpot's, whose work over the
  /// step is lost.
  template <int n_tangents>
  CHAINDRIVE_ALWAYS_INLINE void book(const scene::ContactLawOf<Number>      &law,
                                     const TouchStateOf<Number, n_tangents> &before,
                                     const TouchStateOf<Number, n_tangents> &now,
                                     const Number /*dt*/,
                                     ContactEnergies<Number> &energies) const
  {
    const Number half(0.5);
    const Number spring = law.stiffness * now.penetration;
    energies.stored -= half * spring * gap;
    const Number damping_before = before.normal - law.stiffness * before.penetration;
    energies.damping_loss += half * (damping_before + now.normal - spring) * closing;
  }
};

/// Length of a vector in the tangents' plane.
template <typename Number>
CHAINDRIVE_ALWAYS_INLINE Number length(const Number (&v)[2])
{
  return square_root(v[0] * v[0] + v[1] * v[1]);
}

/// What friction does in update_touch(), which has found the normal force, along one tangent: the
/// return mappings are limits of two numbers, without a division.
template <typename Number>
CHAINDRIVE_ALWAYS_INLINE void slide(const scene::ContactLawOf<Number> &law,
                                    const Number (&slip_rate)[1],
                                    const Number                   dt,
                                    const TouchStateOf<Number, 1> &before,
                                    TouchStateOf<Number, 1>       &touch,
                                    ContactEnergies<Number>       &energies)
{
  const Number zero(0.), half(0.5), stiffness = law.tangential_stiffness;
  const auto   within = [&zero](const Number &x, const Number &limit) {
    return greatest(zero - limit, least(limit, x));
  };
  const Number limit     = law.friction * touch.normal;
  const Number increment = dt * slip_rate[0];
  // the same for all contacts of a law: found once
  const Number compliance = Number(1.) / greatest(stiffness, Number(1e-300));
  touch.slip[0]           = within(before.slip[0] + increment, limit * compliance);
  touch.tangential[0] =
      within(zero - stiffness * touch.slip[0] - law.tangential_damping * slip_rate[0], limit);
  const Number work   = (before.tangential[0] + touch.tangential[0]) * increment;
  const Number growth = (touch.slip[0] + before.slip[0]) * (touch.slip[0] - before.slip[0]);
  energies.stored += half * stiffness * touch.slip[0] * touch.slip[0];
  energies.friction_loss -= half * (work + stiffness * growth);
}

/// The same along two tangents.
template <typename Number>
CHAINDRIVE_ALWAYS_INLINE void slide(const scene::ContactLawOf<Number> &law,
                                    const Number (&slip_rate)[2],
                                    const Number                   dt,
                                    const TouchStateOf<Number, 2> &before,
                                    TouchStateOf<Number, 2>       &touch,
                                    ContactEnergies<Number>       &energies)
{
  const Number zero(0.), half(0.5);
  const Number limit        = law.friction * touch.normal;
  const auto   within_limit = [&limit](const Number &size) {
    return if_less(limit, size, limit / size, Number(1.));
  };
  Number increment[2], elastic[2];
  for (int d = 0; d < 2; ++d)
    {
      increment[d] = dt * slip_rate[d];
      elastic[d]   = before.slip[d] + increment[d];
    }
  const Number elastic_part = within_limit(law.tangential_stiffness * length(elastic));
  for (int d = 0; d < 2; ++d)
    {
      touch.slip[d] = elastic_part * elastic[d];
      touch.tangential[d] =
          zero - law.tangential_stiffness * touch.slip[d] - law.tangential_damping * slip_rate[d];
    }
  const Number part = within_limit(length(touch.tangential));
  Number       work(0.), square(0.), growth(0.);
  for (int d = 0; d < 2; ++d)
    {
      touch.tangential[d] = part * touch.tangential[d];
      work += (before.tangential[d] + touch.tangential[d]) * increment[d];
      square += touch.slip[d] * touch.slip[d];
      growth += (touch.slip[d] + before.slip[d]) * (touch.slip[d] - before.slip[d]);
    }
  energies.stored += half * law.tangential_stiffness * square;
  energies.friction_loss -= half * (work + law.tangential_stiffness * growth);
}

/// Penalty force with damping and Coulomb friction at one instant.
///
///   N = max(0, k d - c g')   where d > 0              linear spring and dashpot (Kelvin-Voigt),
///                                                     or a curved spring in place of k d
///   |k_t s| <= mu N                                   return mapping of the elastic slip s
///   T = - k_t s - c_t s',    |T| <= mu N              and then of the force: the dashpot takes
///                                                     what the spring leaves of the limit
///
/// With the return mapping a contact below the limit is an elastic spring that keeps its origin: it
/// sticks and does not creep (Giannakopoulos 1989; Wriggers, Computational Contact Mechanics, 5.2).
/// Nothing but slip loads the spring. If T were mapped back alone and s = -T / k_t, it would take
/// over the dashpot's share, with energy that no work has put in. The dashpot's part never drives:
/// with the projection P onto the disc of radius mu N, which holds -k_t s, and T = P(-k_t s - c_t
/// s'), it is (T + k_t s) . s' <= 0.
/// Stored energy and losses are booked by the trapezoidal rule over the step.
///
/// @p approach tells penetration d [m] and gap rate g' [m/s]; @p slip_rate s' is the velocity of
/// the slave's material relative to the master's along the two tangents [m/s]; @p dt the time since
/// the last evaluation [s]. Without friction @p touch keeps what it has of slip.
template <typename Number, int n_tangents, typename Approach>
CHAINDRIVE_ALWAYS_INLINE void update_touch(const scene::ContactLawOf<Number> &law,
                                           const Approach                    &approach,
                                           const Number (&slip_rate)[n_tangents],
                                           const Number                      dt,
                                           const bool                        with_friction,
                                           TouchStateOf<Number, n_tangents> &touch,
                                           ContactEnergies<Number>          &energies)
{
  const Number                           zero(0.);
  const TouchStateOf<Number, n_tangents> before = touch;

  touch.penetration = approach.penetration();
  touch.normal =
      if_less(zero,
              touch.penetration,
              greatest(zero, approach.spring(law, touch.penetration) - law.damping * approach.rate),
              zero);
  approach.book(law, before, touch, dt, energies);
  if (!with_friction)
    return;

  slide(law, slip_rate, dt, before, touch, energies);
}
} // namespace chaindrive::contact
