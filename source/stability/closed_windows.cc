// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/stability/closed_windows.h>
#include <chaindrive/stability/coupled_modes.h>
#include <chaindrive/stability/held_bodies.h>
#include <chaindrive/stability/kept_limit.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <set>

namespace chaindrive::stability
{
namespace
{
constexpr unsigned int n_rounds = 6; ///< of balancing bodies, after which their steps hardly change

/// Of two bodies that stick to each other by springs each one alone, with its other end at rest,
/// feels as much of them as it takes: (u - v)^2 <= (1 + t) u^2 + (1 + 1/t) v^2. The t of a family,
/// of its cylinders, is chosen so that bodies are about equally fast.
class Shares
{
public:
  Shares(std::vector<ClosedWindow>           &windows,
         const unsigned int                   n_families,
         std::map<unsigned int, HeldBodies *> held)
      : windows_(windows), held_(std::move(held)), t_(n_families, 1.)
  {
  }

  /// The smallest limit, s, with the best t that were found.
  double critical_time_step()
  {
    std::vector<double> best = t_;
    double              most = 0.;
    for (unsigned int round = 0; round < n_rounds; ++round)
      {
        apply();
        std::map<unsigned int, double> step; // of groups
        double                         least = infinity;
        for (auto &[group, body] : held_)
          {
            step[group] = body->is_held() ? body->near_critical_time_step() : infinity;
            least       = std::min(least, step[group]);
          }
        if (least > most)
          {
            most = least;
            best = t_;
          }
        const std::vector<double> before = t_;
        balance(step);
        if (t_ == before) // nothing sticks
          break;
      }
    t_ = best;
    apply();
    double least = infinity;
    for (auto &[group, body] : held_)
      if (body->is_held())
        least = std::min(least, body->critical_time_step());
    return least;
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  void apply()
  {
    for (ClosedWindow &window : windows_)
      window.springs = 1. + (window.in_bore ? 1. / t_[window.family] : t_[window.family]);
    for (auto &[group, body] : held_)
      body->take_springs();
  }

  /// Of the groups that meet the faster one gets less.
  void balance(const std::map<unsigned int, double> &step)
  {
    for (unsigned int f = 0; f < t_.size(); ++f)
      {
        std::array<double, 2> least{{infinity, infinity}}; // of cylinders, of bores
        bool                  sticks = false;
        for (const ClosedWindow &window : windows_)
          if (window.family == f && window.strips.empty() && !window.together)
            {
              double &of_side = least[window.in_bore ? 1 : 0];
              of_side         = std::min(of_side, step.at(window.group));
              sticks          = sticks || window.across.front() > 0.;
            }
        if (sticks)
          t_[f] = std::clamp(t_[f] * std::pow(least[0] / least[1], 2), 0.1, 10.);
      }
  }

  std::vector<ClosedWindow>           &windows_;
  std::map<unsigned int, HeldBodies *> held_; ///< by group
  std::vector<double>                  t_;
};

/// A joint's windows: of the bore and of the cylinder in it.
struct Joint
{
  ClosedWindow *bore, *cylinder;
};

/// Joints of rings, which have no other one, on links all of whose rings are alike: these are not
/// taken apart. By the groups of the links.
std::map<unsigned int, std::vector<Joint>> ring_joints(std::vector<ClosedWindow> &windows)
{
  std::map<unsigned int, std::set<unsigned int>> bores, cylinders; // surfaces of groups
  for (const ClosedWindow &window : windows)
    if (window.strips.empty())
      (window.in_bore ? bores : cylinders)[window.group].insert(window.surface);
  std::map<unsigned int, std::vector<Joint>> joints;
  std::set<unsigned int>                     several;
  for (std::size_t w = 1; w < windows.size(); ++w)
    if (windows[w].joint != nullptr)
      {
        const Joint        joint{&windows[w - 1], &windows[w]};
        const unsigned int ring = joint.bore->group, link = joint.cylinder->group;
        if (ring == link || bores[ring].size() != 1 || cylinders.count(ring) > 0)
          continue;
        for (const Joint &other : joints[link])
          if (other.cylinder->surface == joint.cylinder->surface)
            several.insert(link);
        joints[link].push_back(joint);
      }
  for (const unsigned int link : several)
    joints.erase(link);
  for (const auto &[link, of_link] : joints)
    for (const Joint &joint : of_link)
      joint.bore->together = joint.cylinder->together = true;
  return joints;
}

/// The smallest limit, s, of bodies in @p windows, of @p n_families families, and in contacts of
/// other @p kinds.
double find_limit(const World                   &world,
                  std::vector<ClosedWindow>     &windows,
                  const std::vector<ClosedKind> &kinds,
                  const unsigned int             n_families)
{
  const auto                       together = ring_joints(windows);
  std::map<unsigned int, HeldBody> alone; // by group
  for (const ModalGroup *group : world.groups.modal())
    alone.emplace(group->copies(), *group);
  for (const ClosedWindow &window : windows)
    alone.at(window.group).add(window);
  for (auto &[group, body] : alone)
    body.close();
  for (const ClosedKind &kind : kinds)
    for (const contact::ClosedSide &side : kind.sides)
      if (const auto body = alone.find(side.group); body != alone.end() && !side.flat)
        body->second.add(side, kind);

  std::map<unsigned int, HeldBodies *> held;
  for (auto &[group, body] : alone)
    held[group] = &body;
  std::map<unsigned int, HeldLink> links;
  for (const auto &[link, joints] : together)
    {
      HeldLink &all = links.emplace(link, alone.at(link)).first->second;
      for (const Joint &joint : joints)
        all.add(alone.at(joint.bore->group), *joint.bore, *joint.cylinder);
      all.close();
      held[link] = &all;
      for (const Joint &joint : joints) // unless there is another link which it is apart from
        if (std::none_of(windows.begin(), windows.end(), [&](const ClosedWindow &window) {
              return window.group == joint.bore->group && window.strips.empty() && !window.together;
            }))
          held.erase(joint.bore->group);
    }
  return Shares(windows, n_families, std::move(held)).critical_time_step();
}
} // namespace

double closed_windows_time_step(const World                                &world,
                                const std::vector<const contact::Family *> &families,
                                statics::Cache                             *kept)
{
  std::vector<ClosedWindow> windows;
  std::vector<ClosedKind>   kinds; // of other contacts
  for (unsigned int f = 0; f < families.size(); ++f)
    {
      if (const auto *exact = dynamic_cast<const contact::HasClosedWindows *>(families[f]))
        for (const contact::ClosedWindow &window : exact->closed_windows())
          windows.push_back({window, f});
      for (ClosedKind &kind : closed_kinds(world, *families[f]))
        kinds.push_back(std::move(kind));
    }
  if (windows.empty())
    return std::numeric_limits<double>::infinity();
  const auto n_families = static_cast<unsigned int>(families.size());
  return kept_limit(world, windows, n_families, kinds.empty() ? kept : nullptr, [&] {
    return find_limit(world, windows, kinds, n_families);
  });
}
} // namespace chaindrive::stability
