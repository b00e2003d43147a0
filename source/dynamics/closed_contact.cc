// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/dynamics/closed_contact.h>
#include <chaindrive/dynamics/stable_step.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace chaindrive::dynamics
{
namespace
{
using contact::ClosedSide;

/// Damping time c/k [s] of a contact that sticks or slides.
double damping_time(const scene::ContactLaw &law)
{
  const double normal = law.damping / law.stiffness;
  if (law.friction > 0. && law.tangential_stiffness > 0.)
    return std::max(normal, law.tangential_damping / law.tangential_stiffness);
  return normal;
}

/// The springs and dampers that hold the bodies of one group, if the ground bears their other ends.
struct Held
{
  std::vector<double> stiffness, damping; ///< per node, N/m and N s/m; empty: rigid bodies
  double              stiffest = 0.;      ///< largest eigenvalue of the springs, 1/s2
  double              damped   = 0.;      ///< the same of the dampers, 1/s
};

/// t of closed_contact.h from the largest eigenvalues of the elements and of the springs of the
/// bodies on either side: e0 + (1 + t) c0 = e1 + (1 + 1/t) c1. The fastest mode of a body's
/// elements is spread over all of them; springs of its surface add about a quarter of their own to
/// it.
double ratio(const double e0, double c0, const double e1, double c1)
{
  const auto felt = [](const double e, const double c) {
    return c > 0. ? c * (c + 0.25 * e) / (c + e) : 0.;
  };
  if (e0 > e1)
    c0 = felt(e0, c0);
  else if (e1 > e0) // of equal bodies neither: exchanged, they must have 1 / t
    c1 = felt(e1, c1);
  const double half = 0.5 * (e0 + c0 - e1 - c1), root = std::sqrt(half * half + c0 * c1);
  return half > 0. ? c1 / (half + root) : (root - half) / c0;
}

/// What holds the nodes of one side of one group of bodies.
struct Springs
{
  std::vector<double> stiffness, damping; ///< per node, N/m and N s/m

  /// Each node is in one contact at a time with what @p side meets there: the stiffest counts.
  void take(const ClosedSide &side, const double factor, const double time)
  {
    stiffness.resize(side.stiffness.size());
    damping.resize(side.stiffness.size());
    for (std::size_t n = 0; n < side.stiffness.size(); ++n)
      {
        const double k = factor * side.stiffness[n];
        stiffness[n]   = std::max(stiffness[n], k);
        damping[n]     = std::max(damping[n], k * time);
      }
  }
};

/// Of each of World::copies: the group that moves it if it vibrates, and its largest eigenvalue
/// without springs, 1/s2.
struct Bodies
{
  const BodyGroup *group    = nullptr;
  double           elements = 0.;
};

/// The largest eigenvalue [1/s2] of springs [N/m] on the masses of @p bodies alone, or [1/s] of
/// dampers, where @p of_nodes is that of single nodes.
double
eigenvalue_on(const Bodies &bodies, const std::vector<double> &springs, const double of_nodes)
{
  const auto frequency = bodies.group->frequency_on(springs);
  return frequency ? *frequency * *frequency : of_nodes;
}

/// All contacts, held closed, for a step of about @p dt [s].
std::vector<Held> hold(const World               &world,
                       const std::vector<Bodies> &bodies,
                       const contact::Contacts   &contacts,
                       const double               dt)
{
  struct Kind
  {
    contact::ClosedPair sides;
    double              time;
  };
  std::vector<Kind>   kinds;
  std::vector<double> rigid(world.copies.size()); // all springs on a rigid body, 1/s2
  for (const auto &family : contacts.families())
    for (contact::ClosedPair &sides : family->closed_pairs(world))
      {
        for (const ClosedSide &side : sides)
          if (side.group != ClosedSide::none && side.stiffness.empty())
            rigid[side.group] += side.eigenvalue;
        kinds.push_back({std::move(sides), damping_time(family->law())});
      }

  std::vector<Held>                            held(world.copies.size());
  std::vector<std::map<unsigned int, Springs>> sides(world.copies.size()); // by surface
  for (const Kind &kind : kinds)
    {
      std::array<double, 2> e{}, c{};
      for (unsigned int i = 0; i < 2; ++i)
        if (const ClosedSide &side = kind.sides[i]; side.group != ClosedSide::none)
          {
            const Bodies &b = bodies[side.group];
            e[i]            = b.elements;
            c[i]            = (side.stiffness.empty() ? rigid[side.group] :
                                                        eigenvalue_on(b, side.stiffness, side.eigenvalue)) *
                   (1. + 2. * kind.time / dt);
          }
      for (unsigned int i = 0; i < 2; ++i)
        if (const ClosedSide &side = kind.sides[i]; side.group != ClosedSide::none)
          {
            const double factor = 1. + ratio(e[i], c[i], e[1 - i], c[1 - i]);
            if (side.stiffness.empty()) // a rigid body feels all its nodes at once
              {
                held[side.group].stiffest += factor * side.eigenvalue;
                held[side.group].damped += factor * side.eigenvalue * kind.time;
              }
            else
              sides[side.group][side.surface].take(side, factor, kind.time);
          }
    }

  // a node on the edge of two sides may be in contact on both of them
  for (unsigned int g = 0; g < held.size(); ++g)
    for (const auto &[surface, springs] : sides[g])
      {
        held[g].stiffness.resize(springs.stiffness.size());
        held[g].damping.resize(springs.stiffness.size());
        for (std::size_t n = 0; n < springs.stiffness.size(); ++n)
          {
            const double mass = world.copies[g].nodes.mass[n];
            held[g].stiffness[n] += springs.stiffness[n];
            held[g].damping[n] += springs.damping[n];
            held[g].stiffest = std::max(held[g].stiffest, held[g].stiffness[n] / mass);
            held[g].damped   = std::max(held[g].damped, held[g].damping[n] / mass);
          }
      }
  for (unsigned int g = 0; g < held.size(); ++g)
    if (!held[g].stiffness.empty())
      {
        held[g].stiffest = eigenvalue_on(bodies[g], held[g].stiffness, held[g].stiffest);
        held[g].damped   = eigenvalue_on(bodies[g], held[g].damping, held[g].damped);
      }
  return held;
}
} // namespace

double closed_contact_step(const World &world, const contact::Contacts &contacts, double limit)
{
  std::vector<Bodies> bodies(world.copies.size());
  for (const auto &group : world.groups)
    if (const unsigned int g = group->elastic_copies(); g != BodyGroup::none)
      {
        const double step = group->stable_step();
        bodies[g]         = {group.get(), 4. / (step * step)};
      }

  const std::vector<Held> held = hold(world, bodies, contacts, limit);
  for (unsigned int g = 0; g < held.size(); ++g)
    {
      double step = stable_step_of(bodies[g].elements + held[g].stiffest, held[g].damped);
      if (step < limit && !held[g].stiffness.empty())
        // with the dampers of a smaller step the body admits at least this one: from below to it
        for (unsigned int round = 0; round < 2; ++round)
          {
            std::vector<double> springs(held[g].stiffness);
            for (std::size_t n = 0; n < springs.size(); ++n)
              springs[n] += 2. / step * held[g].damping[n];
            step = 2. / bodies[g].group->largest_frequency(springs);
          }
      limit = std::min(limit, step);
    }
  return limit;
}

double closed_contact_step(const World &world, const contact::Family &family)
{
  const double time = damping_time(family.law());
  double       step = std::numeric_limits<double>::infinity();
  for (const contact::ClosedPair &pair : family.closed_pairs(world))
    {
      const double both = pair[0].eigenvalue + pair[1].eigenvalue;
      step              = std::min(step, stable_step_of(both, both * time));
    }
  return step;
}
} // namespace chaindrive::dynamics
