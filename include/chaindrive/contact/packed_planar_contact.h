// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Bodies of the kernels of planar_contact_kernels.h, for `width` contacts at a time. The formulas
// are those of Bore, drive::ToothForm::closest_point() and World::velocity_at() in two components,
// and the law is update_touch().

#include <chaindrive/contact/packed_profile.h>
#include <chaindrive/contact/penalty.h>
#include <chaindrive/contact/planar_contact_kernels.h>
#include <chaindrive/utilities/rows.h>

namespace chaindrive::contact::packed
{
/// How a body moves.
template <typename P>
struct PlanarBody
{
  P position[2], velocity[2], spin;

  /// Velocity of its material at @p arm from its centre, at the instant @p earlier before now.
  CHAINDRIVE_ALWAYS_INLINE void velocity_at(const P (&arm)[2], const P &earlier, P (&v)[2]) const
  {
    const P turned = earlier * spin;
    v[0]           = velocity[0] - spin * (arm[1] - turned * arm[0]);
    v[1]           = velocity[1] + spin * (arm[0] + turned * arm[1]);
  }
};

/// Moment of a force @p f at @p arm.
template <typename P>
CHAINDRIVE_ALWAYS_INLINE P moment_of(const P (&arm)[2], const P (&f)[2])
{
  return arm[0] * f[1] - arm[1] * f[0];
}

/// How slaves meet their masters. All contacts of a run are met before the first one is pressed:
/// what one of them does waits for its root and its division, and a processor begins only as many
/// others in the meantime as it has room for operations that wait.
template <int width>
struct Meeting
{
  using P = Pack<double, width>;

  /// Where the normals are @p normal_of_master [unit] and the slaves' axes @p centre; the slaves
  /// have the radius @p radius, and velocities are those @p earlier before now.
  CHAINDRIVE_ALWAYS_INLINE void meet(const P &gap_of_pair,
                                     const P (&normal_of_master)[2],
                                     const P (&centre)[2],
                                     const P             &radius,
                                     const PlanarBody<P> &slave,
                                     const PlanarBody<P> &master,
                                     const P             &earlier)
  {
    P of_slave[2], of_master[2], relative[2];
    gap = gap_of_pair;
    for (int d = 0; d < 2; ++d)
      {
        normal[d]     = normal_of_master[d];
        const P point = centre[d] - radius * normal[d];
        slave_arm[d]  = point - slave.position[d];
        master_arm[d] = point - master.position[d];
      }
    slave.velocity_at(slave_arm, earlier, of_slave);
    master.velocity_at(master_arm, earlier, of_master);
    for (int d = 0; d < 2; ++d)
      relative[d] = of_slave[d] - of_master[d];
    speed = relative[0] * normal[0] + relative[1] * normal[1];
    slip  = relative[1] * normal[0] - relative[0] * normal[1];
  }

  P gap, normal[2];              ///< m, unit
  P slave_arm[2], master_arm[2]; ///< from the bodies' centres to where they touch, m
  P speed, slip; ///< of the slave against the master, along the normal and across it, m/s
};

// The loops over them stay loops: a compiler that knows that they are short would write out each
// turn, and the code no longer fits where instructions are kept.
#ifdef __clang__
#define CHAINDRIVE_ROLLED _Pragma("nounroll")
#else
#define CHAINDRIVE_ROLLED _Pragma("GCC unroll 1")
#endif

/// How many packs are met before the first of them is pressed.
constexpr unsigned int n_ahead = 8;

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
      , dt(contacts.dt)
      , earlier(0.5 * contacts.dt)
      , friction(contacts.law.friction > 0.)
      , energies{P(0.), P(0.), P(0.)}
  {
  }

  /// Evaluates the pairs at @p touch that meet as @p pair; @p spring is that which is not the
  /// law's. Returns false if none touches and none did; else @p force is that on the slaves.
  CHAINDRIVE_ALWAYS_INLINE bool press(const Rows           &touch,
                                      const Meeting<width> &pair,
                                      P (&force)[2],
                                      const SpringNow<P> *spring = nullptr)
  {
    const P zero(0.), gap = pair.gap;
    gap.store(touch.of(planar_touch_gap));
    TouchStateOf<P, 1> state;
    state.penetration = P::load(touch.of(planar_touch_penetration));
    if (!any_negative(least(gap, zero - state.penetration)))
      return false;
    state.normal        = P::load(touch.of(planar_touch_normal));
    state.slip[0]       = P::load(touch.of(planar_touch_slip));
    state.tangential[0] = P::load(touch.of(planar_touch_tangential));
    // those that have just separated give back what their springs held: see separate()
    const auto touching = [&](const P &a) { return if_less(gap, zero, a, zero); };
    const P    rate     = touching(pair.speed);
    const P    slip[1]  = {touching(pair.slip)};
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

    state.penetration.store(touch.of(planar_touch_penetration));
    state.normal.store(touch.of(planar_touch_normal));
    state.slip[0].store(touch.of(planar_touch_slip));
    state.tangential[0].store(touch.of(planar_touch_tangential));
    const auto keep = [&](const unsigned int entry, const P &now) {
      double *at = touch.of(entry);
      if_less(gap, zero, now, P::load(at)).store(at);
    };
    keep(planar_touch_direction, pair.normal[0]);
    keep(planar_touch_direction + 1, pair.normal[1]);
    keep(planar_touch_approach, zero - rate);
    const P tangential = friction ? touching(state.tangential[0]) : zero;
    force[0]           = state.normal * pair.normal[0] - tangential * pair.normal[1];
    force[1]           = state.normal * pair.normal[1] + tangential * pair.normal[0];
    return true;
  }

  CHAINDRIVE_ALWAYS_INLINE void book(PlanarEnergies &to) const
  {
    to.stored += sum_of(energies.stored);
    to.damping_loss += sum_of(energies.damping_loss);
    to.friction_loss += sum_of(energies.friction_loss);
  }

  scene::ContactLawOf<P> law;
  P                      dt, earlier;
  bool                   friction;
  ContactEnergies<P>     energies;
};

/// How the bodies at @p bodies move, but for their positions.
template <int width>
CHAINDRIVE_ALWAYS_INLINE void take_rates(const Rows &bodies, PlanarBody<Pack<double, width>> &body)
{
  using P = Pack<double, width>;
  for (unsigned int d = 0; d < 2; ++d)
    body.velocity[d] = P::load_unaligned(bodies.of(planar_velocity + d));
  body.spin = P::load_unaligned(bodies.of(planar_spin));
}

/// The bodies at @p bodies, and where their points @p axis are.
template <int width>
CHAINDRIVE_ALWAYS_INLINE void take_bodies(const Rows &bodies,
                                          const Pack<double, width> (&axis)[2],
                                          PlanarBody<Pack<double, width>> &body,
                                          Pack<double, width> (&point)[2])
{
  using P = Pack<double, width>;
  for (unsigned int d = 0; d < 2; ++d)
    body.position[d] = P::load_unaligned(bodies.of(planar_position + d));
  take_rates<width>(bodies, body);
  const P c = P::load_unaligned(bodies.of(planar_rotation)),
          s = P::load_unaligned(bodies.of(planar_rotation + 1));
  point[0]  = body.position[0] + c * axis[0] - s * axis[1];
  point[1]  = body.position[1] + s * axis[0] + c * axis[1];
}

template <int width>
CHAINDRIVE_ALWAYS_INLINE void add_to(double *to, const Pack<double, width> &what)
{
  (Pack<double, width>::load_unaligned(to) + what).store_unaligned(to);
}

/// Adds @p force and @p moment to those on the bodies at @p bodies.
template <int width>
CHAINDRIVE_ALWAYS_INLINE void
push(const Rows &bodies, const Pack<double, width> (&force)[2], const Pack<double, width> &moment)
{
  for (unsigned int d = 0; d < 2; ++d)
    add_to<width>(bodies.of(planar_force + d), force[d]);
  add_to<width>(bodies.of(planar_moment), moment);
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

/// The ovals of the rollers at @p rollers where the normals are @p normal.
template <int width>
CHAINDRIVE_ALWAYS_INLINE OvalAt<width> oval_at(const Rows &rollers,
                                               const Pack<double, width> (&normal)[2])
{
  using P = Pack<double, width>;
  P oval[2], rate[2];
  for (unsigned int d = 0; d < 2; ++d)
    {
      oval[d] = P::load_unaligned(rollers.of(planar_ring + d));
      rate[d] = P::load_unaligned(rollers.of(planar_ring_rate + d));
    }
  return OvalAt<width>(normal, oval, rate);
}

/// Adds to the forces on the ovals of the rollers at @p rollers what @p pressed there does.
template <int width>
CHAINDRIVE_ALWAYS_INLINE void
push_oval(const Rows &rollers, const OvalAt<width> &at, const Pack<double, width> &pressed)
{
  add_to<width>(rollers.of(planar_ring_force), pressed * at.cosine);
  add_to<width>(rollers.of(planar_ring_force + 1), pressed * at.sine);
}

template <int width, bool ovals, bool curved>
void press_bores_of(PlanarSlots           bodies,
                    const PlanarContacts &contacts,
                    const PlanarRun      *runs,
                    const unsigned int    n_runs,
                    PlanarEnergies       &energies)
{
  using P = Pack<double, width>;
  PlanarLaw<width> law(contacts);
  SpringNow<P>     spring;
  if (curved)
    spring.here = spring.before =
        spring_of(P(contacts.curve->first[0]), P(contacts.curve->last[0]), contacts.curve->depth);
  const SpringNow<P> *const by = curved ? &spring : nullptr;
  const P                   share(contacts.oval);
  Meeting<width>            pairs[n_ahead];
  P                         turns[ovals ? n_ahead : 1]; // of the normal along the tangent, 1/m
  for (const PlanarRun *run = runs; run != runs + n_runs; ++run)
    {
      Rows    masters(bodies.state, bodies.n_slots, run->master);
      Rows    slaves(bodies.state, bodies.n_slots, run->slave);
      Rows    touch(contacts.touch, contacts.n_places, run->first_place);
      const P master_axis[2] = {P(run->master_axis[0]), P(run->master_axis[1])},
              slave_axis[2]  = {P(run->slave_axis[0]), P(run->slave_axis[1])}, radius(run->radius);
      const unsigned int n   = run->n / width; // which nothing that is stored below can change
      for (unsigned int first = 0; first < n; first += n_ahead)
        {
          const unsigned int n_met = n - first < n_ahead ? n - first : n_ahead;
          Rows               met_masters(masters), met_slaves(slaves), met(touch);
          CHAINDRIVE_ROLLED
          for (unsigned int i = 0; i < n_met; ++i)
            {
              PlanarBody<P> master, slave;
              P             axis[2], centre[2];
              take_bodies<width>(met_masters, master_axis, master, axis);
              take_bodies<width>(met_slaves, slave_axis, slave, centre);
              const P offset[2] = {centre[0] - axis[0], centre[1] - axis[1]};
              const P distance  = square_root(offset[0] * offset[0] + offset[1] * offset[1]);
              const P gap       = P::load(met.of(planar_touch_room)) - distance;
              const P inverse   = P(-1.) / greatest(distance, P(1e-300));
              const P normal[2] = {offset[0] * inverse, offset[1] * inverse};
              pairs[i].meet(gap, normal, centre, radius, slave, master, law.earlier);
              if (ovals)
                {
                  const OvalAt<width> at = oval_at<width>(met_masters, normal);
                  pairs[i].gap += share * at.outwards;
                  pairs[i].speed += share * at.outwards_rate;
                  turns[i] = inverse;
                }
              met_masters.advance(width);
              met_slaves.advance(width);
              met.advance(width);
            }
          CHAINDRIVE_ROLLED
          for (unsigned int i = 0; i < n_met;
               ++i, masters.advance(width), slaves.advance(width), touch.advance(width))
            {
              const Meeting<width> &pair = pairs[i];
              P                     force[2];
              if (!law.press(touch, pair, force, by))
                continue;
              const P opposite[2] = {P(0.) - force[0], P(0.) - force[1]};
              push<width>(masters, opposite, moment_of(pair.master_arm, opposite));
              push<width>(slaves, force, moment_of(pair.slave_arm, force));
              if (ovals)
                {
                  const P(&normal)[2]    = pair.normal;
                  const OvalAt<width> at = oval_at<width>(masters, normal);
                  const P pressed        = share * (force[0] * normal[0] + force[1] * normal[1]);
                  push_oval<width>(masters, at, pressed);
                  // from centre to centre; the normal turns by 1 / distance backwards along the
                  // tangent (-n_y, n_x)
                  const P along = pressed * sideways(at.slope, turns[i]);
                  along.store(touch.of(planar_touch_aside));
                  const P aside[2] = {P(0.) - along * normal[1], along * normal[0]},
                          back[2]  = {along * normal[1], P(0.) - along * normal[0]};
                  P axis[2];
                  for (unsigned int d = 0; d < 2; ++d)
                    axis[d] = pair.slave_arm[d] + radius * normal[d];
                  push<width>(masters, back, P(0.));
                  push<width>(slaves, aside, moment_of(axis, aside));
                }
            }
        }
    }
  law.book(energies);
}

template <int width>
void press_bores(PlanarSlots           bodies,
                 const PlanarContacts &contacts,
                 const PlanarRun      *runs,
                 const unsigned int    n_runs,
                 PlanarEnergies       &energies)
{
  const auto press = contacts.oval != 0. ?
                         (contacts.curve != nullptr ? &press_bores_of<width, true, true> :
                                                      &press_bores_of<width, true, false>) :
                         (contacts.curve != nullptr ? &press_bores_of<width, false, true> :
                                                      &press_bores_of<width, false, false>);
  press(bodies, contacts, runs, n_runs, energies);
}

/// What teeth that are softer higher up are where rollers touch them.
template <int width>
struct ClimbedTeeth
{
  using P = Pack<double, width>;

  SpringNow<P>    spring;
  CurvedSpring<P> upwards;
  P               climbs; ///< of the height of the contact, as the roller moves along the tangent
};

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
  const P cosine(teeth.rotation[0]), sine(teeth.rotation[1]), radius(teeth.radius);
  P       on_sprocket[2] = {P(0.), P(0.)}, moment(0.);

  Meeting<width>      pairs[n_ahead];
  P                   turns[ovals ? n_ahead : 1]; // of the normal along the tangent, 1/m
  ClimbedTeeth<width> climbed[curved ? n_ahead : 1];
  const auto          rollers_at = [&](const unsigned int place) {
    return Rows(bodies.state, bodies.n_slots, teeth.slot[place / n_lanes] + place % n_lanes);
  };
  for (unsigned int first = 0; first < teeth.n; first += n_ahead * width)
    {
      const unsigned int left  = (teeth.n - first) / width;
      const unsigned int n_met = left < n_ahead ? left : n_ahead;
      CHAINDRIVE_ROLLED
      for (unsigned int i = 0; i < n_met; ++i)
        {
          const unsigned int place   = first + i * width;
          const Rows         rollers = rollers_at(place);
          const Rows         touch(contacts.touch, contacts.n_places, place);
          const double      *known = known_of(teeth, place);
          PlanarBody<P>      roller;
          for (unsigned int d = 0; d < 2; ++d)
            roller.position[d] = P::load_unaligned(rollers.of(planar_position + d));
          const P offset[2] = {roller.position[0] - sprocket.position[0],
                               roller.position[1] - sprocket.position[1]};
          const P local[2]  = {cosine * offset[0] + sine * offset[1],
                               cosine * offset[1] - sine * offset[0]};
          P       p[2], turn[2], side;
          fold<width>(teeth, place, known, local, p, turn, side);
          if (!stay_near<width>(known, p))
            {
              alignas(64) double at[2][width];
              for (int d = 0; d < 2; ++d)
                p[d].store(at[d]);
              look_again<width>(teeth, place, at[0], at[1]);
            }
          const NearestOnProfile<width> nearest(known, p);
          const P gap = nearest.signed_distance - P::load(touch.of(planar_touch_room));
          // back from the sector to the sprocket's frame, and from there to the world
          const P y              = side * nearest.normal[1];
          const P in_sprocket[2] = {turn[0] * nearest.normal[0] - turn[1] * y,
                                    turn[1] * nearest.normal[0] + turn[0] * y};
          const P normal[2]      = {cosine * in_sprocket[0] - sine * in_sprocket[1],
                                    sine * in_sprocket[0] + cosine * in_sprocket[1]};
          take_rates<width>(rollers, roller);
          pairs[i].meet(gap, normal, roller.position, radius, roller, sprocket, law.earlier);
          if (curved)
            {
              // The contact moves as far as the roller on a line, less on convex arcs, not at all
              // about corners. In the sector the tangent is (-n_y, n_x).
              const P climbs = P(0.) - nearest.normal[1] * side *
                                           (P(1.) - nearest.signed_distance * nearest.turn);
              const SpringOnTeeth<width> at(*contacts.curve,
                                            p[0] - nearest.normal[0] * nearest.signed_distance);
              P                          below[2];
              sprocket.velocity_at(offset, law.earlier, below);
              const P along = (roller.velocity[1] - below[1]) * normal[0] -
                              (roller.velocity[0] - below[0]) * normal[1];
              climbed[i] = {at.now(climbs * along * law.dt), at.upwards, climbs};
            }
          if (ovals)
            {
              const OvalAt<width> at = oval_at<width>(rollers, normal);
              pairs[i].gap -= at.outwards;
              pairs[i].speed -= at.outwards_rate;
              turns[i] = nearest.turn;
            }
        }
      CHAINDRIVE_ROLLED
      for (unsigned int i = 0; i < n_met; ++i)
        {
          const unsigned int    place   = first + i * width;
          const Rows            rollers = rollers_at(place);
          const Rows            touch(contacts.touch, contacts.n_places, place);
          const Meeting<width> &pair = pairs[i];
          P                     force[2];
          if (!law.press(touch, pair, force, curved ? &climbed[i].spring : nullptr))
            continue;
          const P(&normal)[2] = pair.normal;
          const P pressed     = force[0] * normal[0] + force[1] * normal[1];
          const P on_roller   = moment_of(pair.slave_arm, force);
          P       along(0.);
          moment -= moment_of(pair.master_arm, force);
          if (ovals)
            {
              const OvalAt<width> at = oval_at<width>(rollers, normal);
              push_oval<width>(rollers, at, P(0.) - pressed);
              along += pressed * sideways(at.slope, turns[i]);
              moment -= pressed * at.slope; // the normal turns with the sprocket, too
            }
          if (curved) // the force of the same potential pushes the roller to where they are softer
            along +=
                climbed[i].upwards.energy(greatest(P(0.), P(0.) - pair.gap)) * climbed[i].climbs;
          if (ovals || curved) // at the roller's axis
            {
              (P(0.) - along).store(touch.of(planar_touch_aside));
              const P aside[2] = {along * normal[1], P(0.) - along * normal[0]};
              P       axis[2];
              for (unsigned int d = 0; d < 2; ++d)
                {
                  axis[d] = pair.master_arm[d] + radius * normal[d];
                  force[d] += aside[d];
                }
              moment -= moment_of(axis, aside);
            }
          push<width>(rollers, force, on_roller);
          on_sprocket[0] -= force[0];
          on_sprocket[1] -= force[1];
        }
    }
  law.book(energies);
  teeth.force[0] = sum_of(on_sprocket[0]);
  teeth.force[1] = sum_of(on_sprocket[1]);
  teeth.moment   = sum_of(moment);
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
