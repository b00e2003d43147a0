// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Bodies of the kernels of planar_contact_kernels.h, for `width` contacts at a time. The formulas
// are those of Bore, drive::ToothForm::closest_point() and World::velocity_at() in two components,
// and the law is update_touch().

#include <chaindrive/contact/packed_profile.h>
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

/// Springs that are not the law's, here and where they were a step ago.
template <typename P>
struct SpringNow
{
  CurvedSpring<P> here, before;
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
  /// slaves' axes @p centre; @p own_rate is what gaps change by beside the motion of the bodies,
  /// @p spring that which is not the law's. Returns false if none touches and none did; else
  /// @p force is that on the slaves at @p point.
  CHAINDRIVE_ALWAYS_INLINE bool press(const unsigned int place,
                                      const P           &gap,
                                      const P (&normal)[2],
                                      const P (&centre)[2],
                                      const PlanarBody<P> &slave,
                                      const PlanarBody<P> &master,
                                      P (&point)[2],
                                      P (&force)[2],
                                      const P            *own_rate = nullptr,
                                      const SpringNow<P> *spring   = nullptr)
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
    if (spring != nullptr)
      update_touch(law,
                   CurvedApproach<P>{least(gap, zero), rate, spring->here, spring->before},
                   slip,
                   dt,
                   friction,
                   state,
                   energies);
    else
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

/// The spring whose tangent stiffness is @p first at its first touch and @p last from @p depth on.
template <typename P>
CHAINDRIVE_ALWAYS_INLINE CurvedSpring<P>
                         spring_of(const P &first, const P &last, const double depth)
{
  return {first, (last - first) * P(0.5 / depth), P(depth)};
}

/// Teeth over the height at which a roller touches them.
template <int width>
struct SpringOnTeeth
{
  using P = Pack<double, width>;

  /// The point of contact is @p height [m] from the sprocket's axis, along the middle of the gap.
  CHAINDRIVE_ALWAYS_INLINE SpringOnTeeth(const drive::StiffnessCurve &curve, const P &height)
  {
    const P    zero(0.), end(curve.end), x = (height - P(curve.bottom)) * P(1. / curve.unit);
    const P    place = least(greatest(x, zero), end);
    const auto value = [&place](const double(&c)[3]) {
      return P(c[0]) + place * (P(c[1]) + place * P(c[2]));
    };
    const auto slope = [&](const double(&c)[3]) {
      const P along = P(c[1] / curve.unit) + place * P(2. * c[2] / curve.unit);
      return if_less(zero, x, if_less(x, end, along, zero), zero);
    };
    here    = spring_of(value(curve.first), value(curve.last), curve.depth);
    upwards = spring_of(slope(curve.first), slope(curve.last), curve.depth);
  }

  /// This, and what it was where the contact was lower by @p rise [m].
  CHAINDRIVE_ALWAYS_INLINE SpringNow<P> now(const P &rise) const
  {
    return {here,
            {here.first - rise * upwards.first, here.growth - rise * upwards.growth, here.depth}};
  }

  CurvedSpring<P> here, upwards; ///< the second is the derivative of the first over the height
};

template <int width, bool ovals, bool curved>
void press_bores_of(PlanarSlots           bodies,
                    const PlanarContacts &contacts,
                    const PlanarRun      &of,
                    PlanarEnergies       &energies)
{
  using P              = Pack<double, width>;
  const PlanarRun  run = of; // which nothing that is stored below can change
  PlanarLaw<width> law(contacts);
  SpringNow<P>     spring;
  if (curved)
    spring.here = spring.before =
        spring_of(P(contacts.curve->first[0]), P(contacts.curve->last[0]), contacts.curve->depth);
  const SpringNow<P> *const by = curved ? &spring : nullptr;
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
          if (!law.press(place, gap, normal, centre, slave, master, point, force, &wider, by))
            continue;
          const P pressed = share * (force[0] * normal[0] + force[1] * normal[1]);
          add_to<width>(bodies.of(planar_ring_force) + run.master + i, pressed * at.cosine);
          add_to<width>(bodies.of(planar_ring_force + 1) + run.master + i, pressed * at.sine);
          // the normal turns by 1 / distance backwards along the tangent (-n_y, n_x)
          const P along = pressed * sideways(at.slope, inverse);
          aside[0]      = P(0.) - along * normal[1];
          aside[1]      = along * normal[0];
        }
      else if (!law.press(place, gap, normal, centre, slave, master, point, force, nullptr, by))
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
  const auto press = contacts.oval != 0. ?
                         (contacts.curve != nullptr ? &press_bores_of<width, true, true> :
                                                      &press_bores_of<width, true, false>) :
                         (contacts.curve != nullptr ? &press_bores_of<width, false, true> :
                                                      &press_bores_of<width, false, false>);
  press(bodies, contacts, run, energies);
}

template <int width, bool ovals, bool curved>
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
      NearestOnProfile<width> nearest;
      if (!nearest_as_known<width>(teeth, place, p, nearest))
        {
          nearest = nearest_on_profile<width>(teeth, p);
          for (int i = 0; i < width; ++i)
            {
              const double       at[2] = {p[0][i], p[1][i]};
              const unsigned int which = static_cast<unsigned int>(nearest.which[i]);
              if (!stays_near<width>(teeth, place + i, at))
                keep_nearest<width>(
                    teeth,
                    place + i,
                    {which > 0 ? (which - 1) / 2 : static_cast<unsigned int>(nearest.segment[i]),
                     which > 0 ? (which - 1) % 2 + 1 : 0,
                     nearest.distance[i]},
                    at);
              if (which == 0)
                continue;
              double normal[2];
              set_lane(nearest.signed_distance,
                       i,
                       end_of_profile(teeth, which, at, nearest.distance[i], normal));
              set_lane(nearest.normal[0], i, normal[0]);
              set_lane(nearest.normal[1], i, normal[1]);
              if (ovals || curved) // about a corner the normal turns with the roller
                set_lane(nearest.turn,
                         i,
                         teeth.segments[(which - 1) / 2].corner[(which - 1) % 2] == 0 ||
                                 nearest.signed_distance[i] == 0. ?
                             0. :
                             1. / nearest.signed_distance[i]);
            }
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
      SpringNow<P>    spring;
      CurvedSpring<P> upwards;
      P               climbs; // of the height of the contact, as the roller moves along the tangent
      if (curved)
        {
          // The contact moves as far as the roller on a line, less on convex arcs, not at all about
          // corners. In the sector the tangent is (-n_y, n_x).
          climbs =
              P(0.) - nearest.normal[1] * side * (P(1.) - nearest.signed_distance * nearest.turn);
          const SpringOnTeeth<width> at(*contacts.curve,
                                        p[0] - nearest.normal[0] * nearest.signed_distance);
          P                          below[2];
          sprocket.velocity_at(roller.position, law.earlier, below);
          const P along = (roller.velocity[1] - below[1]) * normal[0] -
                          (roller.velocity[0] - below[0]) * normal[1];
          spring  = at.now(climbs * along * law.dt);
          upwards = at.upwards;
        }
      const SpringNow<P> *const by = curved ? &spring : nullptr;
      P                         point[2], force[2];
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
                  place, gap, normal, roller.position, roller, sprocket, point, force, &closer, by))
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
      else if (!law.press(place,
                          gap,
                          normal,
                          roller.position,
                          roller,
                          sprocket,
                          point,
                          force,
                          nullptr,
                          by))
        continue;
      if (curved)
        {
          // teeth that are softer higher up push the roller there: the force of the same potential
          const P along    = upwards.energy(greatest(P(0.), P(0.) - gap)) * climbs;
          const P aside[2] = {along * normal[1], P(0.) - along * normal[0]};
          for (int i = 0; i < width; ++i)
            {
              bodies.of(planar_force)[slots[i]] += aside[0][i];
              bodies.of(planar_force + 1)[slots[i]] += aside[1][i];
            }
          on_sprocket[0] -= aside[0];
          on_sprocket[1] -= aside[1];
          moment -= sprocket.moment_of(roller.position, aside);
        }
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
  const auto press = contacts.oval != 0. ?
                         (contacts.curve != nullptr ? &press_teeth_of<width, true, true> :
                                                      &press_teeth_of<width, true, false>) :
                         (contacts.curve != nullptr ? &press_teeth_of<width, false, true> :
                                                      &press_teeth_of<width, false, false>);
  press(bodies, contacts, teeth, energies);
}

template <int width>
constexpr PlanarContactKernels make_planar_contact_kernels()
{
  return {width, &press_bores<width>, &press_teeth<width>};
}
} // namespace chaindrive::contact::packed
