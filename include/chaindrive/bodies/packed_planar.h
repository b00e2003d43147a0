// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Bodies of the kernels of planar_kernels.h, for `width` bodies at a time.

#include <chaindrive/bodies/planar_kernels.h>
#include <chaindrive/utilities/rows.h>

namespace chaindrive::packed
{
/// Cosine and sine of @p angle [rad]. The series are exact to round-off up to 0.05; beyond that the
/// angle is halved six times and then doubled as often.
template <typename P>
CHAINDRIVE_ALWAYS_INLINE void cosine_and_sine(P angle, P &cosine, P &sine)
{
  const bool large = any_less(P(0.0025), angle * angle);
  if (large)
    angle = angle * P(1. / 64.);
  const P square = angle * angle;
  sine = angle * (P(1.) - square * (P(1. / 6.) - square * (P(1. / 120.) - square * P(1. / 5040.))));
  // 1 - cos: what is small is not lost beside 1
  P versed = square *
             (P(0.5) - square * (P(1. / 24.) - square * (P(1. / 720.) - square * P(1. / 40320.))));
  if (large)
    for (int i = 0; i < 6; ++i)
      {
        const P doubled = P(2.) * sine * (P(1.) - versed);
        versed          = P(2.) * sine * sine;
        sine            = doubled;
      }
  cosine = P(1.) - versed;
}

/// Adds @p h [s] times the accelerations of the bodies at @p bodies to their velocities @p v and
/// spins @p spin.
template <int width>
CHAINDRIVE_ALWAYS_INLINE void kick_pack(const Rows                &bodies,
                                        const Pack<double, width> &h,
                                        Pack<double, width> (&v)[2],
                                        Pack<double, width> &spin)
{
  using P             = Pack<double, width>;
  const auto of       = [&bodies](const unsigned int entry) { return P::load(bodies.of(entry)); };
  const P    per_mass = h * of(planar_inverse_mass);
  for (unsigned int d = 0; d < 2; ++d)
    {
      v[d] = of(planar_velocity + d) + per_mass * of(planar_force + d);
      v[d].store(bodies.of(planar_velocity + d));
    }
  spin = of(planar_spin) + h * of(planar_inverse_inertia) * of(planar_moment);
  spin.store(bodies.of(planar_spin));
}

/// Twice the kinetic energy of bodies with these velocities, J.
template <int width>
CHAINDRIVE_ALWAYS_INLINE Pack<double, width>
energy_of(const Rows &bodies, const Pack<double, width> (&v)[2], const Pack<double, width> &spin)
{
  using P = Pack<double, width>;
  return P::load(bodies.of(planar_mass)) * (v[0] * v[0] + v[1] * v[1]) +
         P::load(bodies.of(planar_inertia)) * spin * spin;
}

template <int width>
double kick_planar(PlanarSlots slots, const double h)
{
  using P = Pack<double, width>;
  P    energy(0.);
  Rows bodies(slots.state, slots.n_slots, 0);
  for (unsigned int i = 0; i < slots.n_slots; i += width, bodies.advance(width))
    {
      P v[2], spin;
      kick_pack<width>(bodies, P(h), v, spin);
      energy += energy_of<width>(bodies, v, spin);
    }
  return 0.5 * sum_of(energy);
}

template <int width>
double kinetic_energy_of_planar(PlanarSlots slots)
{
  using P = Pack<double, width>;
  P    energy(0.);
  Rows bodies(slots.state, slots.n_slots, 0);
  for (unsigned int i = 0; i < slots.n_slots; i += width, bodies.advance(width))
    {
      const P v[2] = {P::load(bodies.of(planar_velocity)), P::load(bodies.of(planar_velocity + 1))};
      energy += energy_of<width>(bodies, v, P::load(bodies.of(planar_spin)));
    }
  return 0.5 * sum_of(energy);
}

/// Forces of the loads on bodies.
template <int width>
struct PackedLoads
{
  using P = Pack<double, width>;

  CHAINDRIVE_ALWAYS_INLINE explicit PackedLoads(const PlanarLoads &loads)
      : gravity(loads.gravity), drag(loads.drag), potential(0.), power(0.)
  {
  }

  /// @p force on the bodies at @p bodies, of the velocities @p v and the height @p y above the
  /// start.
  CHAINDRIVE_ALWAYS_INLINE void act(const Rows &bodies, const P (&v)[2], const P &y, P (&force)[2])
  {
    const P mass   = P::load(bodies.of(planar_mass));
    const P weight = gravity * mass, resistance = drag * mass;
    potential += weight * y;
    force[0] = P(0.) - resistance * v[0];
    force[1] = P(0.) - resistance * v[1] - weight;
    power += resistance * (v[0] * v[0] + v[1] * v[1]);
  }

  CHAINDRIVE_ALWAYS_INLINE void book(PlanarLoads &loads) const
  {
    loads.potential = sum_of(potential);
    loads.power     = sum_of(power);
  }

  P gravity, drag, potential, power;
};

template <int width>
double advance_planar(PlanarSlots slots, const double h, const double dt, PlanarLoads &given)
{
  using P = Pack<double, width>;
  P                  fastest(0.);
  const P            kick(h), step(dt);
  PackedLoads<width> loads(given);
  Rows               bodies(slots.state, slots.n_slots, 0);
  for (unsigned int i = 0; i < slots.n_slots; i += width, bodies.advance(width))
    {
      const auto of = [&bodies](const unsigned int entry) { return P::load(bodies.of(entry)); };
      P          v[2], spin, u[2], force[2];
      kick_pack<width>(bodies, kick, v, spin);
      for (unsigned int d = 0; d < 2; ++d)
        {
          u[d] = of(planar_displacement + d) + step * v[d];
          u[d].store(bodies.of(planar_displacement + d));
          (of(planar_origin + d) + u[d]).store(bodies.of(planar_position + d));
        }
      fastest = greatest(fastest, v[0] * v[0] + v[1] * v[1]);
      loads.act(bodies, v, u[1], force);
      force[0].store(bodies.of(planar_force));
      force[1].store(bodies.of(planar_force + 1));
      P(0.).store(bodies.of(planar_moment));

      P turned[2];
      cosine_and_sine(step * of(planar_follows_rotation) * spin, turned[0], turned[1]);
      const P before[2] = {of(planar_rotation), of(planar_rotation + 1)};
      const P after[2]  = {before[0] * turned[0] - before[1] * turned[1],
                           before[1] * turned[0] + before[0] * turned[1]};
      // round-off lets the length drift: one step of Newton's method sets it back
      const P length = P(1.5) - P(0.5) * (after[0] * after[0] + after[1] * after[1]);
      for (unsigned int d = 0; d < 2; ++d)
        (length * after[d]).store(bodies.of(planar_rotation + d));
    }
  loads.book(given);
  double most = 0.;
  for (int i = 0; i < width; ++i)
    most = most < fastest[i] ? fastest[i] : most;
  return most;
}

template <int width>
void load_planar(PlanarSlots slots, PlanarLoads &given)
{
  using P = Pack<double, width>;
  PackedLoads<width> loads(given);
  Rows               bodies(slots.state, slots.n_slots, 0);
  for (unsigned int i = 0; i < slots.n_slots; i += width, bodies.advance(width))
    {
      P force[2];
      P v[2] = {P::load(bodies.of(planar_velocity)), P::load(bodies.of(planar_velocity + 1))};
      loads.act(bodies, v, P::load(bodies.of(planar_displacement + 1)), force);
      for (unsigned int d = 0; d < 2; ++d)
        (P::load(bodies.of(planar_force + d)) + force[d]).store(bodies.of(planar_force + d));
    }
  loads.book(given);
}

/// The number of the lane before in each lane, and zero in the first one.
template <int width>
CHAINDRIVE_ALWAYS_INLINE Pack<double, width> moved_up(const Pack<double, width> &p)
{
  Pack<double, width>       r(0.);
  const Pack<double, width> zero(0.);
  if constexpr (width == 2)
    r.v = __builtin_shufflevector(p.v, zero.v, 2, 0);
  else if constexpr (width == 4)
    r.v = __builtin_shufflevector(p.v, zero.v, 4, 0, 1, 2);
  else if constexpr (width == 8)
    r.v = __builtin_shufflevector(p.v, zero.v, 8, 0, 1, 2, 3, 4, 5, 6);
  return r;
}

/// Of @p neighbours each bar ends at the body at which the next one begins. What bars on both sides
/// do to a body is then added at once: numbers that have just been stored from other lanes would
/// have to be waited for.
template <int width, bool neighbours>
void stretch_run(PlanarSlots bodies, PlanarBars &bars)
{
  using P = Pack<double, width>;
  P      energy(0.), loss(0.);
  double tension_before = 0., before[2] = {0., 0.}; // of the bar before this pack
  for (unsigned int i = 0; i < bars.n; i += width)
    {
      P between[2], rate(0.), square(0.);
      for (unsigned int d = 0; d < 2; ++d)
        {
          const double *x = bodies.of(planar_position + d);
          between[d] =
              P::load_unaligned(x + bars.second + i) - P::load_unaligned(x + bars.first + i);
          square += between[d] * between[d];
        }
      const P length = greatest(square_root(square), P(1e-300)), inverse = P(1.) / length;
      for (unsigned int d = 0; d < 2; ++d)
        {
          const double *v = bodies.of(planar_velocity + d);
          between[d]      = inverse * between[d];
          rate += between[d] *
                  (P::load_unaligned(v + bars.second + i) - P::load_unaligned(v + bars.first + i));
        }
      const P longer  = length - P::load(bars.unloaded + i);
      const P elastic = P::load(bars.stiffness + i) * longer;
      const P viscous = P::load(bars.damping + i) * rate;
      const P tension = elastic + viscous;
      tension.store(bars.tension + i);
      energy += elastic * longer;
      loss += (P::load(bars.viscous + i) + viscous) * (length - P::load(bars.length + i));
      viscous.store(bars.viscous + i);
      length.store(bars.length + i);
      if constexpr (neighbours)
        {
          P alone(0.);
          set_lane(alone, 0, tension_before);
          const P behind = moved_up(tension);
          for (unsigned int d = 0; d < 2; ++d)
            {
              double *f   = bodies.of(planar_force + d) + bars.first + i;
              P       sum = P::load_unaligned(f) - alone * P(before[d]);
              sum         = sum + tension * between[d];
              sum         = sum - behind * moved_up(between[d]);
              sum.store_unaligned(f);
              before[d] = between[d][width - 1];
            }
          tension_before = tension[width - 1];
        }
      else // one after the other: a body may be in both slots
        for (unsigned int d = 0; d < 2; ++d)
          {
            const P pull = tension * between[d];
            double *f    = bodies.of(planar_force + d);
            (P::load_unaligned(f + bars.first + i) + pull).store_unaligned(f + bars.first + i);
            (P::load_unaligned(f + bars.second + i) - pull).store_unaligned(f + bars.second + i);
          }
    }
  if constexpr (neighbours) // the last body has no further bar
    for (unsigned int d = 0; d < 2; ++d)
      bodies.of(planar_force + d)[bars.first + bars.n] -= tension_before * before[d];
  bars.energy += 0.5 * sum_of(energy);
  bars.loss += 0.5 * sum_of(loss);
}

template <int width>
void stretch_planar(PlanarSlots bodies, PlanarBars &bars)
{
  if (bars.second == bars.first + 1)
    stretch_run<width, true>(bodies, bars);
  else
    stretch_run<width, false>(bodies, bars);
}

template <int width>
void kick_ovals(PlanarSlots bodies, const double h)
{
  using P = Pack<double, width>;
  for (unsigned int i = 0; i < bodies.n_slots; i += width)
    for (unsigned int d = 0; d < 2; ++d)
      {
        double *at = bodies.of(planar_ring_rate + d) + i;
        (P::load(at) + P(h) * P::load(bodies.of(planar_ring_inverse_mass) + i) *
                           P::load(bodies.of(planar_ring_force + d) + i))
            .store(at);
      }
}

template <int width>
void drift_ovals(PlanarSlots bodies, const double dt)
{
  using P = Pack<double, width>;
  for (unsigned int i = 0; i < bodies.n_slots; i += width)
    for (unsigned int d = 0; d < 2; ++d)
      {
        double *at = bodies.of(planar_ring + d) + i;
        (P::load(at) + P(dt) * P::load(bodies.of(planar_ring_rate + d) + i)).store(at);
      }
}

template <int width>
double kinetic_energy_of_ovals(PlanarSlots bodies)
{
  using P = Pack<double, width>;
  P energy(0.);
  for (unsigned int i = 0; i < bodies.n_slots; i += width)
    {
      const P a = P::load(bodies.of(planar_ring_rate) + i),
              b = P::load(bodies.of(planar_ring_rate + 1) + i);
      energy += P::load(bodies.of(planar_ring_mass) + i) * (a * a + b * b);
    }
  return 0.5 * sum_of(energy);
}

template <int width>
double bend_ovals(PlanarSlots bodies)
{
  using P = Pack<double, width>;
  P energy(0.);
  for (unsigned int i = 0; i < bodies.n_slots; i += width)
    for (unsigned int d = 0; d < 2; ++d)
      {
        const P a     = P::load(bodies.of(planar_ring + d) + i);
        const P force = P::load(bodies.of(planar_ring_stiffness) + i) * a;
        double *at    = bodies.of(planar_ring_force + d) + i;
        (P::load(at) - force).store(at);
        energy += force * a;
      }
  return 0.5 * sum_of(energy);
}

template <int width>
constexpr PlanarKernels make_planar_kernels()
{
  return {width,
          &kick_planar<width>,
          &advance_planar<width>,
          &load_planar<width>,
          &kinetic_energy_of_planar<width>,
          &stretch_planar<width>,
          &kick_ovals<width>,
          &drift_ovals<width>,
          &kinetic_energy_of_ovals<width>,
          &bend_ovals<width>};
}
} // namespace chaindrive::packed
