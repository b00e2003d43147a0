// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Bodies of the kernels of planar_contact_kernels.h, for `width` contacts at a time. The formulas
// are those of Bore, drive::ToothForm::closest_point() and World::velocity_at() in two components,
// and the law is update_touch().

#include <chaindrive/contact/penalty.h>
#include <chaindrive/contact/planar_contact_kernels.h>

namespace chaindrive::contact::packed
{
/// How a body moves.
template <typename P>
struct PlanarBody
{
  P position[2], velocity[2], spin;

  /// Velocity of its material at @p x, at the instant @p earlier before now.
  CHAINDRIVE_ALWAYS_INLINE void velocity_at(const P (&x)[2], const P &earlier, P (&v)[2]) const
  {
    const P turned = earlier * spin, arm[2] = {x[0] - position[0], x[1] - position[1]};
    v[0] = velocity[0] - spin * (arm[1] - turned * arm[0]);
    v[1] = velocity[1] + spin * (arm[0] + turned * arm[1]);
  }

  /// Moment about its centre of a force @p f at @p x.
  CHAINDRIVE_ALWAYS_INLINE P moment_of(const P (&x)[2], const P (&f)[2]) const
  {
    return (x[0] - position[0]) * f[1] - (x[1] - position[1]) * f[0];
  }
};

/// The law in the plane, with what all lanes share.
template <int width>
struct PlanarLaw
{
  using P = Pack<double, width>;

  CHAINDRIVE_ALWAYS_INLINE explicit PlanarLaw(const PlanarContacts &contacts)
      : law{contacts.law.stiffness,
            contacts.law.damping,
            contacts.law.friction,
            contacts.law.tangential_stiffness,
            contacts.law.tangential_damping}
      , radius(contacts.radius)
      , dt(contacts.dt)
      , earlier(0.5 * contacts.dt)
      , friction(contacts.law.friction > 0.)
      , touch(contacts.touch)
      , n_places(contacts.n_places)
      , energies{P(0.), P(0.), P(0.)}
  {
  }

  CHAINDRIVE_ALWAYS_INLINE double *of(const unsigned int entry, const unsigned int place) const
  {
    return touch + entry * n_places + place;
  }

  /// Evaluates the pairs from @p place on, whose gaps are @p gap, the normals @p normal and the
  /// slaves' axes @p centre; @p own_rate is what gaps change by beside the motion of the bodies.
  /// Returns false if none touches and none did; else @p force is that on
  /// the slaves at @p point.
  CHAINDRIVE_ALWAYS_INLINE bool press(const unsigned int place,
                                      const P           &gap,
                                      const P (&normal)[2],
                                      const P (&centre)[2],
                                      const PlanarBody<P> &slave,
                                      const PlanarBody<P> &master,
                                      P (&point)[2],
                                      P (&force)[2],
                                      const P *own_rate = nullptr)
  {
    const P zero(0.);
    gap.store(of(planar_touch_gap, place));
    TouchStateOf<P, 1> state;
    state.penetration = P::load(of(planar_touch_penetration, place));
    if (!any_less(least(gap, zero - state.penetration), zero))
      return false;
    state.normal        = P::load(of(planar_touch_normal, place));
    state.slip[0]       = P::load(of(planar_touch_slip, place));
    state.tangential[0] = P::load(of(planar_touch_tangential, place));

    P of_slave[2], of_master[2], relative[2];
    for (int d = 0; d < 2; ++d)
      point[d] = centre[d] - radius * normal[d];
    slave.velocity_at(point, earlier, of_slave);
    master.velocity_at(point, earlier, of_master);
    for (int d = 0; d < 2; ++d)
      relative[d] = of_slave[d] - of_master[d];
    P speed = relative[0] * normal[0] + relative[1] * normal[1];
    if (own_rate != nullptr)
      speed += *own_rate;
    // those that have just separated give back what their springs held: see separate()
    const auto touching = [&](const P &a) { return if_less(gap, zero, a, zero); };
    const P    rate     = touching(speed);
    const P    slip[1]  = {touching(relative[1] * normal[0] - relative[0] * normal[1])};
    update_touch(
        law, PointApproach<P>{least(gap, zero), rate}, slip, dt, friction, state, energies);

    state.penetration.store(of(planar_touch_penetration, place));
    state.normal.store(of(planar_touch_normal, place));
    state.slip[0].store(of(planar_touch_slip, place));
    state.tangential[0].store(of(planar_touch_tangential, place));
    const auto keep = [&](const unsigned int entry, const P &now) {
      double *at = of(entry, place);
      if_less(gap, zero, now, P::load(at)).store(at);
    };
    keep(planar_touch_direction, normal[0]);
    keep(planar_touch_direction + 1, normal[1]);
    keep(planar_touch_approach, zero - rate);
    const P tangential = friction ? touching(state.tangential[0]) : zero;
    force[0]           = state.normal * normal[0] - tangential * normal[1];
    force[1]           = state.normal * normal[1] + tangential * normal[0];
    return true;
  }

  CHAINDRIVE_ALWAYS_INLINE void book(PlanarEnergies &to) const
  {
    for (int i = 0; i < width; ++i)
      {
        to.stored += energies.stored[i];
        to.damping_loss += energies.damping_loss[i];
        to.friction_loss += energies.friction_loss[i];
      }
  }

  scene::ContactLawOf<P> law;
  P                      radius, dt, earlier;
  bool                   friction;
  double                *touch;
  unsigned int           n_places;
  ContactEnergies<P>     energies;
};

/// The bodies in the slots from @p slot on, and where their points @p axis are.
template <int width>
CHAINDRIVE_ALWAYS_INLINE void take_bodies(const PlanarSlots &bodies,
                                          const unsigned int slot,
                                          const double (&axis)[2],
                                          PlanarBody<Pack<double, width>> &body,
                                          Pack<double, width> (&point)[2])
{
  using P             = Pack<double, width>;
  const auto entry_at = [&](const unsigned int entry) {
    return P::load_unaligned(bodies.of(entry) + slot);
  };
  for (unsigned int d = 0; d < 2; ++d)
    {
      body.position[d] = entry_at(planar_position + d);
      body.velocity[d] = entry_at(planar_velocity + d);
    }
  body.spin = entry_at(planar_spin);
  const P c = entry_at(planar_rotation), s = entry_at(planar_rotation + 1);
  point[0] = body.position[0] + c * P(axis[0]) - s * P(axis[1]);
  point[1] = body.position[1] + s * P(axis[0]) + c * P(axis[1]);
}

template <int width>
CHAINDRIVE_ALWAYS_INLINE void add_to(double *to, const Pack<double, width> &what)
{
  (Pack<double, width>::load_unaligned(to) + what).store_unaligned(to);
}

/// The oval of a roller at an angle, and what a contact there does to it.
template <int width>
struct OvalAt
{
  using P = Pack<double, width>;

  /// Where the normal, unit, is @p n; the oval is @p a, its rate @p rate.
  CHAINDRIVE_ALWAYS_INLINE OvalAt(const P (&n)[2], const P (&a)[2], const P (&rate)[2])
      : cosine(n[0] * n[0] - n[1] * n[1])
      , sine(P(2.) * n[0] * n[1])
      , outwards(a[0] * cosine + a[1] * sine)
      , outwards_rate(rate[0] * cosine + rate[1] * sine)
      , slope(P(2.) * (a[1] * cosine - a[0] * sine))
  {
  }

  P cosine, sine;                   ///< of twice the angle
  P outwards, outwards_rate, slope; ///< m, m/s, and how it grows with the angle, m
};

/// The share of the normal force by which it pushes a roller along the tangent when the normal
/// turns by @p turn [1/m] along it: what is not round has a contact that moves towards where there
/// is room. As the force of a potential it keeps the energy.
template <typename P>
CHAINDRIVE_ALWAYS_INLINE P sideways(const P &slope, const P &turn)
{
  return greatest(P(-1.), least(P(1.), slope * turn));
}

template <int width, bool ovals>
void press_bores_of(PlanarSlots           bodies,
                    const PlanarContacts &contacts,
                    const PlanarRun      &run,
                    PlanarEnergies       &energies)
{
  using P = Pack<double, width>;
  PlanarLaw<width> law(contacts);
  for (unsigned int i = 0; i < run.n; i += width)
    {
      PlanarBody<P> master, slave;
      P             axis[2], centre[2];
      take_bodies<width>(bodies, run.master + i, run.master_axis, master, axis);
      take_bodies<width>(bodies, run.slave + i, run.slave_axis, slave, centre);
      const P            offset[2] = {centre[0] - axis[0], centre[1] - axis[1]};
      const P            distance  = square_root(offset[0] * offset[0] + offset[1] * offset[1]);
      const unsigned int place     = run.first_place + i;
      P                  gap       = P::load(law.of(planar_touch_room, place)) - distance;
      const P            inverse   = P(-1.) / greatest(distance, P(1e-300));
      const P            normal[2] = {offset[0] * inverse, offset[1] * inverse};
      P                  point[2], force[2], aside[2] = {P(0.), P(0.)};
      if (ovals)
        {
          const auto two = [&](const unsigned int entry, P(&to)[2]) {
            for (unsigned int d = 0; d < 2; ++d)
              to[d] = P::load_unaligned(bodies.of(entry + d) + run.master + i);
          };
          P oval[2], rate[2];
          two(planar_ring, oval);
          two(planar_ring_rate, rate);
          const OvalAt<width> at(normal, oval, rate);
          const P             share(contacts.oval), wider = share * at.outwards_rate;
          gap += share * at.outwards;
          if (!law.press(place, gap, normal, centre, slave, master, point, force, &wider))
            continue;
          const P pressed = share * (force[0] * normal[0] + force[1] * normal[1]);
          add_to<width>(bodies.of(planar_ring_force) + run.master + i, pressed * at.cosine);
          add_to<width>(bodies.of(planar_ring_force + 1) + run.master + i, pressed * at.sine);
          // the normal turns by 1 / distance backwards along the tangent (-n_y, n_x)
          const P along = pressed * sideways(at.slope, inverse);
          aside[0]      = P(0.) - along * normal[1];
          aside[1]      = along * normal[0];
        }
      else if (!law.press(place, gap, normal, centre, slave, master, point, force))
        continue;
      const P opposite[2] = {P(0.) - force[0], P(0.) - force[1]};
      for (unsigned int d = 0; d < 2; ++d)
        {
          add_to<width>(bodies.of(planar_force + d) + run.master + i, opposite[d]);
          add_to<width>(bodies.of(planar_force + d) + run.slave + i, force[d]);
        }
      add_to<width>(bodies.of(planar_moment) + run.master + i, master.moment_of(point, opposite));
      add_to<width>(bodies.of(planar_moment) + run.slave + i, slave.moment_of(point, force));
      if (ovals) // from centre to centre
        {
          for (unsigned int d = 0; d < 2; ++d)
            {
              add_to<width>(bodies.of(planar_force + d) + run.master + i, P(0.) - aside[d]);
              add_to<width>(bodies.of(planar_force + d) + run.slave + i, aside[d]);
            }
          add_to<width>(bodies.of(planar_moment) + run.slave + i, slave.moment_of(centre, aside));
        }
    }
  law.book(energies);
}

template <int width>
void press_bores(PlanarSlots           bodies,
                 const PlanarContacts &contacts,
                 const PlanarRun      &run,
                 PlanarEnergies       &energies)
{
  if (contacts.oval != 0.)
    press_bores_of<width, true>(bodies, contacts, run, energies);
  else
    press_bores_of<width, false>(bodies, contacts, run, energies);
}

/// The numbers of an array at the places stride * @p slots + @p first.
template <int width, unsigned int stride = 1>
CHAINDRIVE_ALWAYS_INLINE Pack<double, width>
gather_slots(const double *from, const unsigned int *slots, const unsigned int first = 0)
{
  const double *at[width];
  for (int i = 0; i < width; ++i)
    at[i] = from + stride * slots[i];
  return gather<double, width>(at, first);
}

/// Nearest points of a profile, for a pack of points.
template <int width>
struct NearestOnProfile
{
  using P = Pack<double, width>;

  P distance;                   ///< not signed, m
  P signed_distance, normal[2]; ///< where it is between the ends of a segment
  P which; ///< 0: between the ends of a segment; 2 i + 1 or 2 i + 2: the begin or end of segment i
  P turn;  ///< how the normal turns along the tangent, 1/m
};

template <int width>
CHAINDRIVE_ALWAYS_INLINE NearestOnProfile<width>
nearest_on_profile(const PlanarTeeth &teeth, const Pack<double, width> (&p)[2])
{
  using P = Pack<double, width>;
  NearestOnProfile<width> best;
  const P                 zero(0.);
  best.distance        = P(1e300);
  best.signed_distance = best.normal[0] = best.normal[1] = best.which = zero;
  P curved(0.);           // 1: an arc
  P length(1.), sign(1.); // what normals are still to be divided by and multiplied with
  for (unsigned int i = 0; i < teeth.n_segments; ++i)
    {
      const PlanarSegment &s             = teeth.segments[i];
      const P              from_begin[2] = {p[0] - P(s.begin[0]), p[1] - P(s.begin[1])},
              from_end[2]                = {p[0] - P(s.end[0]), p[1] - P(s.end[1])};
      const P begin = from_begin[0] * from_begin[0] + from_begin[1] * from_begin[1],
              end   = from_end[0] * from_end[0] + from_end[1] * from_end[1];
      P signed_distance, normal[2], norm(1.), inside; // inside: not negative between the ends
      if (s.kind == 0)
        {
          const double d[2]   = {s.end[0] - s.begin[0], s.end[1] - s.begin[1]};
          const double square = d[0] * d[0] + d[1] * d[1], one = 1. / __builtin_sqrt(square);
          const P      along = from_begin[0] * P(d[0]) + from_begin[1] * P(d[1]);
          inside             = least(along, P(square) - along);
          normal[0]          = P(d[1] * one);
          normal[1]          = P(-d[0] * one);
          signed_distance    = from_begin[0] * normal[0] + from_begin[1] * normal[1];
        }
      else
        {
          const P w[2]    = {p[0] - P(s.centre[0]), p[1] - P(s.centre[1])};
          norm            = square_root(w[0] * w[0] + w[1] * w[1]);
          inside          = w[0] * P(s.middle[0]) + w[1] * P(s.middle[1]) - norm * P(s.half_cosine);
          normal[0]       = w[0];
          normal[1]       = w[1];
          signed_distance = P(double(s.kind)) * (norm - P(s.radius));
        }
      const P to_end = square_root(least(begin, end));
      const P distance =
          if_less(zero, inside, greatest(signed_distance, zero - signed_distance), to_end);
      const P which = if_less(
          zero, inside, zero, if_less(begin, end, P(double(2 * i + 1)), P(double(2 * i + 2))));
      const auto keep_nearer = [&](P &to, const P &what) {
        to = if_less(distance, best.distance, what, to);
      };
      keep_nearer(best.signed_distance, signed_distance);
      keep_nearer(best.normal[0], normal[0]);
      keep_nearer(best.normal[1], normal[1]);
      keep_nearer(best.which, which);
      keep_nearer(length, norm);
      keep_nearer(sign, P(s.kind == 0 ? 1. : double(s.kind)));
      keep_nearer(curved, P(s.kind == 0 ? 0. : 1.));
      best.distance = least(distance, best.distance);
    }
  const P outward = sign / greatest(length, P(1e-300));
  best.turn       = if_less(P(0.), curved, outward, P(0.));
  for (P &component : best.normal)
    component = component * outward;
  return best;
}

/// Signed distance and normal of the point @p p, whose nearest point is the end @p which of the
/// profile, as in NearestOnProfile.
CHAINDRIVE_ALWAYS_INLINE double end_of_profile(const PlanarTeeth &teeth,
                                               const unsigned int which,
                                               const double (&p)[2],
                                               const double distance,
                                               double (&normal)[2])
{
  const PlanarSegment &s   = teeth.segments[(which - 1) / 2];
  const unsigned int   end = (which - 1) % 2;
  const double        *at = end == 0 ? s.begin : s.end, *n = s.end_normal[end];
  const double         away[2] = {p[0] - at[0], p[1] - at[1]};
  double               result  = distance;
  if (s.corner[end] < 0 || (s.corner[end] == 0 && away[0] * n[0] + away[1] * n[1] < 0.))
    result = -distance;
  const bool turns = s.corner[end] != 0 && result != 0.;
  normal[0]        = turns ? away[0] / result : n[0];
  normal[1]        = turns ? away[1] / result : n[1];
  return result;
}

/// Folds points @p p in the sprocket's frame into the sector of half a gap with half a tooth:
/// @p folded; @p turn becomes cosine and sine of the gap's angle, @p side the sign of the mirror.
template <int width>
CHAINDRIVE_ALWAYS_INLINE void fold(const PlanarTeeth &teeth,
                                   unsigned int      *gap,
                                   const Pack<double, width> (&p)[2],
                                   Pack<double, width> (&folded)[2],
                                   Pack<double, width> (&turn)[2],
                                   Pack<double, width> &side)
{
  using P = Pack<double, width>;
  const P    zero(0.), flat(1. + teeth.turns[2]), steep(teeth.turns[3]);
  P          y;
  const auto unturn = [&](const double *angles) {
    turn[0]   = gather_slots<width, 2>(angles, gap);
    turn[1]   = gather_slots<width, 2>(angles, gap, 1);
    folded[0] = turn[0] * p[0] + turn[1] * p[1];
    y         = turn[0] * p[1] - turn[1] * p[0];
  };
  for (unsigned int tries = 0; tries <= teeth.n_teeth; ++tries)
    {
      unturn(teeth.turns);
      // the middle of the tooth is where y / x = tan(pi / z)
      const P beyond = greatest(y, zero - y) * flat - folded[0] * steep;
      if (!any_less(zero, beyond))
        break;
      for (int i = 0; i < width; ++i)
        if (beyond[i] > 0.)
          {
            const unsigned int last = teeth.n_teeth - 1;
            gap[i] =
                y[i] < 0. ? (gap[i] == 0 ? last : gap[i] - 1) : (gap[i] == last ? 0 : gap[i] + 1);
          }
    }
  if (teeth.shifted != nullptr)
    unturn(teeth.shifted);
  side      = if_less(y, zero, P(-1.), P(1.));
  folded[1] = side * y;
}

template <int width, bool ovals>
void press_teeth_of(PlanarSlots           bodies,
                    const PlanarContacts &contacts,
                    PlanarTeeth          &teeth,
                    PlanarEnergies       &energies)
{
  using P = Pack<double, width>;
  PlanarLaw<width> law(contacts);
  PlanarBody<P>    sprocket;
  for (int d = 0; d < 2; ++d)
    {
      sprocket.position[d] = P(teeth.position[d]);
      sprocket.velocity[d] = P(teeth.velocity[d]);
    }
  sprocket.spin = P(teeth.spin);
  const P cosine(teeth.rotation[0]), sine(teeth.rotation[1]);
  P       on_sprocket[2] = {P(0.), P(0.)}, moment(0.);
  for (unsigned int place = 0; place < teeth.n; place += width)
    {
      const unsigned int *slots = teeth.slot + place;
      PlanarBody<P>       roller;
      for (unsigned int d = 0; d < 2; ++d)
        roller.position[d] = gather_slots<width>(bodies.of(planar_position + d), slots);
      const P offset[2] = {roller.position[0] - sprocket.position[0],
                           roller.position[1] - sprocket.position[1]};
      const P local[2]  = {cosine * offset[0] + sine * offset[1],
                           cosine * offset[1] - sine * offset[0]};
      P       p[2], turn[2], side;
      fold<width>(teeth, teeth.gap + place, local, p, turn, side);
      NearestOnProfile<width> nearest = nearest_on_profile<width>(teeth, p);
      if (any_less(P(0.5), nearest.which))
        for (int i = 0; i < width; ++i)
          if (const unsigned int which = static_cast<unsigned int>(nearest.which[i]); which > 0)
            {
              const double at[2] = {p[0][i], p[1][i]};
              double       normal[2];
              set_lane(nearest.signed_distance,
                       i,
                       end_of_profile(teeth, which, at, nearest.distance[i], normal));
              set_lane(nearest.normal[0], i, normal[0]);
              set_lane(nearest.normal[1], i, normal[1]);
              if (ovals) // about a corner the normal turns with the roller
                set_lane(nearest.turn,
                         i,
                         teeth.segments[(which - 1) / 2].corner[(which - 1) % 2] == 0 ||
                                 nearest.signed_distance[i] == 0. ?
                             0. :
                             1. / nearest.signed_distance[i]);
            }
      P gap = nearest.signed_distance - P::load(law.of(planar_touch_room, place));
      // back from the sector to the sprocket's frame, and from there to the world
      const P y              = side * nearest.normal[1];
      const P in_sprocket[2] = {turn[0] * nearest.normal[0] - turn[1] * y,
                                turn[1] * nearest.normal[0] + turn[0] * y};
      const P normal[2]      = {cosine * in_sprocket[0] - sine * in_sprocket[1],
                                sine * in_sprocket[0] + cosine * in_sprocket[1]};
      for (unsigned int d = 0; d < 2; ++d)
        roller.velocity[d] = gather_slots<width>(bodies.of(planar_velocity + d), slots);
      roller.spin = gather_slots<width>(bodies.of(planar_spin), slots);
      P point[2], force[2];
      if (ovals)
        {
          P oval[2], rate[2];
          for (unsigned int d = 0; d < 2; ++d)
            {
              oval[d] = gather_slots<width>(bodies.of(planar_ring + d), slots);
              rate[d] = gather_slots<width>(bodies.of(planar_ring_rate + d), slots);
            }
          const OvalAt<width> at(normal, oval, rate);
          const P             closer = P(0.) - at.outwards_rate;
          gap                        = gap - at.outwards;
          if (!law.press(
                  place, gap, normal, roller.position, roller, sprocket, point, force, &closer))
            continue;
          const P pressed = force[0] * normal[0] + force[1] * normal[1];
          const P along   = pressed * sideways(at.slope, nearest.turn);
          P       aside[2];
          aside[0] = along * normal[1];
          aside[1] = P(0.) - along * normal[0];
          for (int i = 0; i < width; ++i)
            {
              bodies.of(planar_ring_force)[slots[i]] -= pressed[i] * at.cosine[i];
              bodies.of(planar_ring_force + 1)[slots[i]] -= pressed[i] * at.sine[i];
              bodies.of(planar_force)[slots[i]] += aside[0][i];
              bodies.of(planar_force + 1)[slots[i]] += aside[1][i];
            }
          on_sprocket[0] -= aside[0];
          on_sprocket[1] -= aside[1];
          // the normal turns with the sprocket, too
          moment -= sprocket.moment_of(roller.position, aside) + pressed * at.slope;
        }
      else if (!law.press(place, gap, normal, roller.position, roller, sprocket, point, force))
        continue;
      const P on_roller = roller.moment_of(point, force);
      for (int i = 0; i < width; ++i)
        {
          bodies.of(planar_force)[slots[i]] += force[0][i];
          bodies.of(planar_force + 1)[slots[i]] += force[1][i];
          bodies.of(planar_moment)[slots[i]] += on_roller[i];
        }
      on_sprocket[0] -= force[0];
      on_sprocket[1] -= force[1];
      moment -= sprocket.moment_of(point, force);
    }
  law.book(energies);
  teeth.force[0] = teeth.force[1] = teeth.moment = 0.;
  for (int i = 0; i < width; ++i)
    {
      teeth.force[0] += on_sprocket[0][i];
      teeth.force[1] += on_sprocket[1][i];
      teeth.moment += moment[i];
    }
}

template <int width>
void press_teeth(PlanarSlots           bodies,
                 const PlanarContacts &contacts,
                 PlanarTeeth          &teeth,
                 PlanarEnergies       &energies)
{
  if (contacts.oval != 0.)
    press_teeth_of<width, true>(bodies, contacts, teeth, energies);
  else
    press_teeth_of<width, false>(bodies, contacts, teeth, energies);
}

template <int width>
constexpr PlanarContactKernels make_planar_contact_kernels()
{
  return {width, &press_bores<width>, &press_teeth<width>};
}
} // namespace chaindrive::contact::packed
