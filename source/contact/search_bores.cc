// SPDX-License-Identifier: LGPL-2.1-or-later
// When joints of nodes are searched, how far, and which nodes are read: of class NodeBores.
#include <chaindrive/contact/node_bores.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace chaindrive::contact
{
namespace
{
constexpr double least_reach = 6e-6; // m

/// How far [m] a search looks: larger, and searches were fewer but windows wider. Steps of elements
/// have many to a search either way; at those of reduced bodies, which are longer, a search is to
/// hold for some, even if gaps close with the speed @p unforeseen [m/s].
double search_reach(const double dt, const double unforeseen)
{
  constexpr double steps = 10.;
  return std::max(least_reach, steps * unforeseen * dt);
}
} // namespace

std::size_t NodeBores::end_of_lanes(const Group &group, const unsigned int b)
{
  return std::min<std::size_t>((std::size_t(b) + 1) * n_lanes, group.pairs.size());
}

void NodeBores::announce(World &world, const std::optional<double> dt)
{
  for (Group &group : groups_)
    for (unsigned int b = 0; b < group.batches.size(); ++b)
      if (!dt)
        announce_joints(world, group, b, every_step_ ? Readers::search : Readers::forces);
      else
        {
          JointBatch  &batch = *group.batches[b];
          const double use   = group.by_distance ? moved(world, group, b, least_reach) : *dt;
          group.use[b]       = use;
          const bool farther = set_margins(group, b);
          if (group.by_distance && !every_step_ && !farther && batch.search_due(use))
            if (const double rest = left(world, group, b); rest > 0.25 * least_reach)
              batch.renew(rest + use);
          group.due[b] = every_step_ || farther || batch.search_due(use) ? 1 : 0;
          if (group.due[b] == 0)
            continue;
          if (group.by_distance && !every_step_)
            {
              const auto [reach, margin] = reach_by_distance(group, b);
              batch.choose_columns(reach, margin, use);
            }
          announce_joints(world, group, b, Readers::search);
        }
}

NodeBores::Stance NodeBores::stance(const World &world, const unsigned int pair) const
{
  const scene::BorePair &p    = pairs_[pair];
  const Frame           &bore = world.frames[p.master], &cylinder = world.frames[p.slave.body];
  const auto             x = axis_of(bore, 0), along = axis_of(cylinder, 0);
  const auto             in_cylinder = dealii::transpose(cylinder.rotation);
  return {dealii::Tensor<1, 3>(p.slave.point) +
              in_cylinder * (cylinder.position - bore.position -
                             bore.rotation * dealii::Tensor<1, 3>(p.axis)),
          in_cylinder * axis_of(bore, 2),
          along * x,
          along * axis_of(bore, 1)};
}

double
NodeBores::moved(const Group &group, const Stance &from, const Stance &to, const double reach)
{
  const JointGrid &grid = group.batches.front()->grid();
  const double     columns =
      std::max(grid.master_circumferential, grid.slave_circumferential) / dealii::numbers::PI;
  return (to.offset - from.offset).norm() + group.half_length * (to.axis - from.axis).norm() +
         reach * columns * std::hypot(to.cosine - from.cosine, to.sine - from.sine);
}

double
NodeBores::moved(const World &world, const Group &group, const unsigned int b, const double reach)
{
  double most = 0.;
  for (std::size_t i = b * n_lanes; i < end_of_lanes(group, b); ++i)
    {
      const unsigned int pair = group.pairs[i];
      const Stance       now  = stance(world, pair);
      double             sum  = moved(group, stances_[pair], now, reach);
      for (const Group::Side &side : group.sides)
        sum += world.copies[side.group].moved_by_modes[side.copy[i]];
      most           = std::max(most, sum);
      stances_[pair] = now;
    }
  return most;
}

void NodeBores::remember(const World &world, Group &group, const unsigned int b) const
{
  for (std::size_t i = b * n_lanes; i < end_of_lanes(group, b); ++i)
    {
      group.searched_stance[i] = stance(world, group.pairs[i]);
      double *amplitude        = group.searched_amplitude[i].data();
      for (const Group::Side &side : group.sides)
        {
          const BodyBatches &copies = world.copies[side.group];
          const unsigned int batch  = copies.batch_of(side.copy[i]),
                             lane   = copies.lane_of(side.copy[i]);
          for (unsigned int m = 0; m < copies.modes.n; ++m)
            *amplitude++ = copies.modes.of(batch, m, lane);
        }
    }
}

double NodeBores::left(const World &world, const Group &group, const unsigned int b) const
{
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = b * n_lanes; i < end_of_lanes(group, b); ++i)
    {
      const double  reach     = group.batches[b]->reach(static_cast<int>(i % n_lanes));
      const double *amplitude = group.searched_amplitude[i].data();
      double        rest =
          reach - moved(group, group.searched_stance[i], stance(world, group.pairs[i]), reach);
      for (const Group::Side &side : group.sides)
        {
          const BodyBatches &copies = world.copies[side.group];
          const unsigned int batch  = copies.batch_of(side.copy[i]),
                             lane   = copies.lane_of(side.copy[i]);
          for (unsigned int m = 0; m < copies.modes.n; ++m)
            rest -=
                copies.modes.farthest[m] * std::abs(copies.modes.of(batch, m, lane) - *amplitude++);
        }
      least = std::min(least, rest);
    }
  return least;
}

void NodeBores::announce_joints(World             &world,
                                Group             &group,
                                const unsigned int b,
                                const Readers      readers) const
{
  const JointBatch &batch = *group.batches[b];
  const JointGrid  &grid  = batch.grid();
  for (unsigned int is_slave = 0; is_slave < 2; ++is_slave)
    {
      Group::Side &side   = group.sides[is_slave];
      BodyBatches &copies = world.copies[side.group];
      if (!copies.counts_readers())
        continue;
      std::map<unsigned int, std::vector<char>> columns; // of batches of bodies
      for (unsigned int i = b * n_lanes; i < end_of_lanes(group, b); ++i)
        {
          std::vector<char> &near = columns[copies.batch_of(side.copy[i])];
          near.resize(side.n_columns, 0);
          if (readers == Readers::search)
            batch.mark_wanted(i % n_lanes, is_slave != 0, near);
          else
            batch.mark_circumferential(i % n_lanes, is_slave != 0, near);
        }
      for (auto &[bodies, nodes] : side.read[b])
        copies.add_readers(bodies, nodes, -1);
      side.read[b].clear();
      for (const auto &[bodies, near] : columns)
        {
          std::vector<unsigned int> &nodes = side.read[b][bodies];
          // the axis of a bore is that of its ends
          const std::size_t last  = side.node.size() - side.n_columns; // ring
          const std::size_t first = is_slave != 0 ? grid.first_ring * side.n_columns : 0,
                            end = is_slave != 0 ? grid.end_ring * side.n_columns : side.node.size();
          for (std::size_t n = first; n < end; ++n)
            if (near[n % side.n_columns] != 0 ||
                (is_slave == 0 && (n < side.n_columns || n >= last) &&
                 n % side.n_columns % grid.axis_stride == 0))
              nodes.push_back(side.node[n]);
          copies.add_readers(bodies, nodes, 1);
        }
    }
}

bool NodeBores::set_margins(Group &group, const unsigned int b) const
{
  if (!group.flexibility)
    return false;
  // Without a penalty forces deflect surfaces beside where bodies and modes have moved them; teeth
  // do so through the walls of rollers.
  bool more = false;
  for (std::size_t i = b * n_lanes; i < end_of_lanes(group, b); ++i)
    {
      const unsigned int body = records_[group.pairs[i]].master;
      const bool         on_teeth =
          std::any_of(group.coupled.begin(), group.coupled.end(), [body](const auto &coupled) {
            return coupled.strips->problem_of(body) != nullptr;
          });
      const int lane = static_cast<int>(i % n_lanes);
      // by as much as last time, and what may come nearer in a step; in steps of two, or a load
      // that rises would ask for a search each time
      const double last =
          group.batches[b]->deflected(lane) + (group.by_distance ? 2. * group.use[b] : 0.);
      double margin = on_teeth ? 1e-5 : 1e-6;
      while (margin < last)
        margin *= 2.;
      const double known = group.batches[b]->deflection(lane);
      more               = more || margin > known;
      if (margin > known || 4. * margin <= known)
        group.batches[b]->set_deflection(lane, margin);
    }
  return more;
}

std::pair<double, double> NodeBores::reach_by_distance(const Group &group, const unsigned int b)
{
  const double step = group.use[b]; // by which a search may come late, a little more or less
  return {std::max(least_reach, 4. * step), 2. * step};
}

void NodeBores::search(const World       &world,
                       Group             &group,
                       const unsigned int b,
                       const double       dt,
                       const double       unforeseen)
{
  JointBatch &batch = *group.batches[b];
  if (group.by_distance && !every_step_)
    {
      const auto [reach, margin] = reach_by_distance(group, b);
      n_missed_ += batch.search(reach, {}, margin);
      remember(world, group, b);
    }
  else
    n_missed_ += batch.search(every_step_ ? 0. : search_reach(dt, unforeseen), unforeseen);
}
} // namespace chaindrive::contact
