// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/stability/closed_contact.h>
#include <chaindrive/stability/closed_modes.h>
#include <chaindrive/stability/closed_windows.h>
#include <chaindrive/stability/coupled_modes.h>
#include <chaindrive/stability/critical_time_step.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace chaindrive::stability
{
namespace
{
using contact::ClosedSide;

/// Of each of World::copies: the group that moves it if it vibrates, by nodes or by modes, and its
/// largest eigenvalue without springs, 1/s2.
struct Bodies
{
  const NodalGroup *nodal    = nullptr;
  const ModalGroup *modal    = nullptr;
  double            elements = 0.;
  Matrix            free; ///< ModalGroup::modal_matrix() without springs
};

std::vector<Bodies> bodies_of(const World &world)
{
  std::vector<Bodies> bodies(world.copies.size());
  for (const ElasticGroup *group : world.groups.elastic())
    {
      const double step                = group->critical_time_step();
      bodies[group->copies()].elements = 4. / (step * step);
    }
  for (const NodalGroup *group : world.groups.nodal())
    bodies[group->copies()].nodal = group;
  for (const ModalGroup *group : world.groups.modal())
    {
      bodies[group->copies()].modal = group;
      bodies[group->copies()].free  = group->modal_matrix({});
    }
  return bodies;
}

/// The springs and dampers that hold the bodies of one group, if the ground bears their other ends.
struct Held
{
  std::vector<double> stiffness, damping; ///< per node, N/m and N s/m; empty: rigid bodies
  double              stiffest = 0.;      ///< largest eigenvalue of the springs, 1/s2
  double              damped   = 0.;      ///< the same of the dampers, 1/s
  ModalBodies         modal;              ///< of modal bodies
};

/// The largest eigenvalue of a body on springs that are 1 + t times as stiff as they are, about
/// e + (1 + t) c.
struct Bound
{
  double e = 0., c = 0.;
  bool   felt = false; ///< c is what the body feels of the springs, not their largest eigenvalue
};

/// t of closed_contact.h that makes the bounds of the bodies on either side equal: e0 + (1 + t) c0
/// = e1 + (1 + 1/t) c1. The limit is a bound for every t > 0: a guess of how much a body feels of
/// its springs makes it less sharp where it is wrong, and never too large. Of the faster body,
/// whose elements decide, Weyl's c is too much: their fastest mode is spread over all nodes, of
/// which the springs hold those of the surface. It is taken to feel c (c + e/4) / (c + e): all of
/// stiff springs, a quarter of soft ones. The quarter is a fit to the rollers and links of the test
/// stability/closed_contact.
double ratio(Bound b0, Bound b1)
{
  const auto feel = [](Bound &b) {
    if (!b.felt)
      b.c = b.c > 0. ? b.c * (b.c + 0.25 * b.e) / (b.c + b.e) : 0.;
  };
  if (b0.e > b1.e)
    feel(b0);
  else if (b1.e > b0.e) // of equal bodies neither: exchanged, they must have 1 / t
    feel(b1);
  const double half = 0.5 * (b0.e + b0.c - b1.e - b1.c),
               root = std::sqrt(half * half + b0.c * b1.c);
  return half > 0. ? b1.c / (half + root) : (root - half) / b0.c;
}

/// What holds the nodes of one side of one group of bodies.
struct Springs
{
  std::vector<double> stiffness, damping; ///< per node, N/m and N s/m

  /// Each node is in one contact at a time with what @p side meets there: the stiffest counts.
  void update_largest(const ClosedSide &side, const double factor, const double time)
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

bool is_modal(const std::vector<Bodies> &bodies, const ClosedSide &side)
{
  return side.group != ClosedSide::none && bodies[side.group].modal != nullptr;
}

/// The critical time step [s] of modal bodies, if they can be treated together; then takes
/// theirs away from @p kinds. Infinite without such.
double
take_coupled(const World &world, const std::vector<Bodies> &bodies, std::vector<ClosedKind> &kinds)
{
  if (kinds.empty())
    return std::numeric_limits<double>::infinity();
  auto coupled = CoupledModes::make(world, kinds);
  if (!coupled)
    return std::numeric_limits<double>::infinity();
  kinds.erase(std::remove_if(kinds.begin(),
                             kinds.end(),
                             [&](const ClosedKind &kind) {
                               return is_modal(bodies, kind.sides[0]) ||
                                      is_modal(bodies, kind.sides[1]);
                             }),
              kinds.end());
  return coupled->critical_time_step();
}

/// What flat sides add to modal bodies, beside what else holds these: where both sides deform, each
/// feels at most twice the springs, with its other end at rest: (u - v)^2 <= 2 u^2 + 2 v^2.
class FlatSides
{
public:
  /// Takes the kinds away from @p kinds that have flat sides of modal @p bodies.
  FlatSides(const World &world, const std::vector<Bodies> &bodies, std::vector<ClosedKind> &kinds)
  {
    std::vector<ClosedKind> others;
    for (ClosedKind &kind : kinds)
      {
        bool taken = false;
        for (const ClosedSide &side : kind.sides)
          if (side.flat && is_modal(bodies, side))
            {
              add(world, *bodies[side.group].modal, side, kind);
              taken = true;
            }
        if (!taken)
          others.push_back(std::move(kind));
      }
    kinds = std::move(others);
  }

  /// The critical time step [s] of all where without these it is @p step: eigenvalues add up at
  /// most.
  double critical_time_step(const double step) const
  {
    double both = step;
    for (const auto &[group, held] : held_)
      {
        const double others = 4. / (step * step);
        double       of     = critical_time_step_of(others + largest(held.springs(std::nullopt)),
                                          largest(held.dampers()));
        for (unsigned int round = 0; round < 3; ++round)
          of = 2. / std::sqrt(others + largest(held.springs(of)));
        both = std::min(both, of);
      }
    return both;
  }

private:
  struct Of
  {
    Matrix matrix;
    double time; ///< s
  };

  /// What holds the bodies of one group.
  struct Held
  {
    std::vector<Of>            joints;  ///< all closed at a time
    std::map<unsigned int, Of> grounds; ///< by surface: one of those that it may meet

    /// Springs, with what the dampers add for steps of @p dt [s].
    Matrix springs(const std::optional<double> dt) const
    {
      return sum([&dt](const Of &of) { return 1. + (dt ? 2. * of.time / *dt : 0.); });
    }

    Matrix dampers() const
    {
      return sum([](const Of &of) { return of.time; });
    }

  private:
    template <typename Factor>
    Matrix sum(const Factor &factor) const
    {
      Matrix     total;
      const auto add = [&](const Of &of) {
        if (total.empty())
          total.reinit(of.matrix.m(), of.matrix.n());
        total.add(factor(of), of.matrix);
      };
      std::for_each(joints.begin(), joints.end(), add);
      for (const auto &[surface, of] : grounds)
        add(of);
      return total;
    }
  };

  void
  add(const World &world, const ModalGroup &group, const ClosedSide &side, const ClosedKind &kind)
  {
    const mesh::Nodes &nodes    = world.copies[side.group].nodes;
    const bool         is_joint = kind.sides[0].group != ClosedSide::none;
    Of                 worst{Matrix(), kind.time};
    double             most = 0.;
    for (const double sign : {-1., 1.})
      {
        ClosedSide face = side;
        face.half_angle = dealii::numbers::PI;
        face.normal.resize(face.stiffness.size());
        for (unsigned int n = 0; n < face.stiffness.size(); ++n)
          {
            face.normal[n][2] = sign;
            if (sign * nodes.position[n][2] < 0.)
              face.stiffness[n] = 0.;
          }
        Matrix matrix = added_to_modes(group, face, kind.law);
        matrix *= is_joint ? 2. : 1.;
        if (const double value = largest(matrix); value > most)
          {
            most         = value;
            worst.matrix = std::move(matrix);
          }
      }
    if (most == 0.)
      return;
    Held &held = held_[side.group];
    if (is_joint)
      held.joints.push_back(std::move(worst));
    else if (const auto found = held.grounds.find(side.surface);
             found == held.grounds.end() || largest(found->second.matrix) < most)
      held.grounds[side.surface] = std::move(worst);
  }

  std::map<unsigned int, Held> held_; ///< by group
};

/// The pairs of one kind: factors 1 + t and 1 + 1/t of the springs on either side.
struct Kind
{
  contact::ClosedPair   sides;
  std::array<Matrix, 2> on_modes; ///< see added_to_modes()
  std::array<double, 2> factor{{1., 1.}};
  double                time = 0.;
};

/// Those of @p closed whose springs are split between their two sides.
std::vector<Kind> split(std::vector<ClosedKind> closed, const std::vector<Bodies> &bodies)
{
  std::vector<Kind> kinds;
  for (ClosedKind &of_closed : closed)
    {
      Kind kind;
      kind.sides = std::move(of_closed.sides);
      kind.time  = of_closed.time;
      for (unsigned int i = 0; i < 2; ++i)
        if (const ClosedSide &side = kind.sides[i]; is_modal(bodies, side))
          kind.on_modes[i] = added_to_modes(*bodies[side.group].modal, side, of_closed.law);
      kinds.push_back(std::move(kind));
    }
  return kinds;
}

/// The bound of side @p i of @p kind alone; @p rigid are all springs on a rigid body, 1/s2, and
/// springs with their dampers are @p damped times as stiff.
Bound bound_of(const Kind                &kind,
               const unsigned int         i,
               const std::vector<Bodies> &bodies,
               const std::vector<double> &rigid,
               const double               damped)
{
  const ClosedSide &side = kind.sides[i];
  if (side.group == ClosedSide::none)
    return {};
  if (kind.on_modes[i].empty())
    return {bodies[side.group].elements,
            (side.stiffness.empty() ? rigid[side.group] : side.eigenvalue) * damped,
            false};
  Matrix once = bodies[side.group].free, twice = once;
  once.add(damped, kind.on_modes[i]);
  twice.add(2. * damped, kind.on_modes[i]);
  const double of_once = largest(once), more = largest(twice) - of_once;
  return {of_once - more, more, true};
}

/// What modal bodies feel of their sides; of several kinds that one side may meet
/// that with the largest factor.
std::vector<ModalBodies> modal_bodies_of(const std::vector<Kind>   &kinds,
                                         const std::vector<Bodies> &bodies)
{
  std::vector<ModalBodies> modal(bodies.size());
  for (const Kind &kind : kinds)
    for (unsigned int i = 0; i < 2; ++i)
      if (!kind.on_modes[i].empty())
        {
          const ClosedSide &side = kind.sides[i];
          modal[side.group].free = bodies[side.group].free;
          modal[side.group].sides[side.surface].update_largest(
              kind.on_modes[i], kind.factor[i], kind.time);
        }
  return modal;
}

/// Makes modal bodies about equally fast: of two that meet the faster one gets less
/// of the springs between them.
void balance(std::vector<Kind> &kinds, const std::vector<Bodies> &bodies, const double dt)
{
  for (unsigned int round = 0; round < 12; ++round)
    {
      std::vector<double> eigenvalue;
      for (const ModalBodies &modal : modal_bodies_of(kinds, bodies))
        eigenvalue.push_back(modal.sides.empty() ? 0. : modal.eigenvalue(dt));
      for (Kind &kind : kinds)
        if (!kind.on_modes[0].empty() && !kind.on_modes[1].empty())
          {
            const double t = (kind.factor[0] - 1.) * std::sqrt(eigenvalue[kind.sides[1].group] /
                                                               eigenvalue[kind.sides[0].group]);
            kind.factor    = {{1. + t, 1. + 1. / t}};
          }
    }
}

/// The contacts @p closed for a step of about @p dt [s].
std::vector<Held> add_closed_springs(const World               &world,
                                     const std::vector<Bodies> &bodies,
                                     std::vector<ClosedKind>    closed,
                                     const double               dt)
{
  std::vector<Kind>   kinds = split(std::move(closed), bodies);
  std::vector<double> rigid(world.copies.size()); // all springs on a rigid body, 1/s2
  for (const Kind &kind : kinds)
    for (const ClosedSide &side : kind.sides)
      if (side.group != ClosedSide::none && side.stiffness.empty())
        rigid[side.group] += side.eigenvalue;
  for (Kind &kind : kinds)
    {
      const double               damped = 1. + 2. * kind.time / dt;
      const std::array<Bound, 2> bounds = {
          {bound_of(kind, 0, bodies, rigid, damped), bound_of(kind, 1, bodies, rigid, damped)}};
      for (unsigned int i = 0; i < 2; ++i)
        if (kind.sides[i].group != ClosedSide::none)
          kind.factor[i] = 1. + ratio(bounds[i], bounds[1 - i]);
    }
  balance(kinds, bodies, dt);

  std::vector<Held>                            held(world.copies.size());
  std::vector<std::map<unsigned int, Springs>> sides(world.copies.size()); // by surface
  for (const Kind &kind : kinds)
    for (unsigned int i = 0; i < 2; ++i)
      if (const ClosedSide &side = kind.sides[i];
          side.group != ClosedSide::none && kind.on_modes[i].empty())
        {
          if (side.stiffness.empty()) // a rigid body feels all its nodes at once
            {
              held[side.group].stiffest += kind.factor[i] * side.eigenvalue;
              held[side.group].damped += kind.factor[i] * side.eigenvalue * kind.time;
            }
          else
            sides[side.group][side.surface].update_largest(side, kind.factor[i], kind.time);
        }
  std::vector<ModalBodies> modal = modal_bodies_of(kinds, bodies);
  for (unsigned int g = 0; g < held.size(); ++g)
    held[g].modal = std::move(modal[g]);

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
  return held;
}
} // namespace

double closed_contact_time_step(const World             &world,
                                const contact::Contacts &contacts,
                                double                   limit,
                                statics::Cache          *kept)
{
  const std::vector<Bodies> bodies = bodies_of(world);
  std::vector<ClosedKind>   kinds;
  for (const auto &family : contacts.families())
    for (ClosedKind &kind : closed_kinds(world, *family))
      kinds.push_back(std::move(kind));
  const FlatSides flat(world, bodies, kinds);
  limit                        = std::min(limit, take_coupled(world, bodies, kinds));
  const std::vector<Held> held = add_closed_springs(world, bodies, std::move(kinds), limit);
  for (unsigned int g = 0; g < held.size(); ++g)
    if (!held[g].modal.sides.empty())
      limit = std::min(limit, held[g].modal.critical_time_step());
    else
      {
        double step = critical_time_step_of(bodies[g].elements + held[g].stiffest, held[g].damped);
        if (step < limit && !held[g].stiffness.empty())
          // with the dampers of a smaller step the body admits at least this one: from below to it
          for (unsigned int round = 0; round < 2; ++round)
            {
              std::vector<double> springs(held[g].stiffness);
              for (std::size_t n = 0; n < springs.size(); ++n)
                springs[n] += 2. / step * held[g].damping[n];
              step = 2. / bodies[g].nodal->largest_frequency(springs);
            }
        limit = std::min(limit, step);
      }
  std::vector<const contact::Family *> families;
  for (const auto &family : contacts.families())
    families.push_back(family);
  return flat.critical_time_step(std::min(limit, closed_windows_time_step(world, families, kept)));
}

double
closed_contact_time_step(const World &world, const contact::Family &family, statics::Cache *kept)
{
  const std::vector<Bodies> bodies = bodies_of(world);
  std::vector<ClosedKind>   kinds  = closed_kinds(world, family);
  const FlatSides           flat(world, bodies, kinds);
  double                    step = flat.critical_time_step(take_coupled(world, bodies, kinds));
  for (const ClosedKind &kind : kinds)
    {
      double both = 0.;
      for (unsigned int i = 0; i < 2; ++i)
        {
          const ClosedSide &side = kind.sides[i];
          both += is_modal(bodies, side) ?
                      largest(added_to_modes(*bodies[side.group].modal, side, kind.law)) :
                      side.eigenvalue;
        }
      step = std::min(step, critical_time_step_of(both, both * kind.time));
    }
  return std::min(step, closed_windows_time_step(world, {&family}, kept));
}
} // namespace chaindrive::stability
