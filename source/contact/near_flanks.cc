// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/near_flanks.h>
#include <chaindrive/utilities/ranks.h>
#include <chaindrive/utilities/timing.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace chaindrive::contact
{
void NearFlanks::add(const ElasticFlanks &flanks, const SurfaceContact &family)
{
  // a small part of a gap, in which a roller fits; and far more than a roller is deformed
  constexpr double part_of_radius = 0.05;
  const double     margin         = part_of_radius * family.smallest_radius();
  margin_                         = items_.empty() ? margin : std::min(margin_, margin);
  items_.push_back({&flanks, &family});
}

double NearFlanks::largest_speed(const World &world) const
{
  double of_bodies = 0., of_hubs = 0.;
  for (const Frame &frame : world.frames)
    of_bodies = std::max(of_bodies, frame.velocity.norm_square());
  for (const Item &item : items_)
    of_hubs = std::max(of_hubs, world.frames[item.flanks->body()].angular_velocity.norm());
  return std::sqrt(of_bodies) + of_hubs * (farthest_ + margin_);
}

void NearFlanks::update(World &world, const bool searched, const double dt)
{
  if (items_.empty() || n_ranks_in(world.communicator()) == 1)
    return;
  const double moved = largest_speed(world) * dt;
  if (!searched && !cadence_.is_due(moved))
    {
      cadence_.use(moved);
      return;
    }
  cadence_.restart(margin_);

  bool changed = false;
  farthest_    = 0.;
  for (Item &item : items_)
    {
      const Frame &hub = world.frames[item.flanks->body()];
      const auto   at  = [&](const unsigned int i) {
        const scene::SlavePoint &slave = item.family->slave(i);
        return to_world(world.frames[slave.body], slave.point);
      };
      for (const unsigned int i : item.family->near())
        farthest_ = std::max(farthest_, (at(i) - hub.position).norm());
      std::set<unsigned int> gaps;
      for (const unsigned int i : item.family->own(world))
        // one margin is for motion, the other for what slaves are deformed
        gaps.merge(
            item.flanks->gaps_near(world, at(i), item.family->slave(i).radius, 2. * margin_));
      changed = changed || gaps != item.gaps;
      item.gaps.swap(gaps);
    }
  const auto any_changed = [&] {
    const Waiting waiting;
    return dealii::Utilities::MPI::max(changed ? 1 : 0, world.communicator()) != 0;
  };
  if (!any_changed())
    return;

  std::map<unsigned int, std::vector<BodyBatches::Place>> wanted; // by group of copies
  for (const Item &item : items_)
    {
      std::vector<BodyBatches::Place> &of_group = wanted[item.flanks->group()];
      for (const unsigned int gap : item.gaps)
        for (const BodyBatches::Place &place : item.flanks->nodes_of_gap(gap))
          of_group.push_back(place);
    }
  for (const auto &[group, places] : wanted)
    world.copies[group].want_now(places);
  world.node_exchange.connect(world.copies);
}
} // namespace chaindrive::contact
