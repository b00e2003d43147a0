// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/closed_joint.h>
#include <chaindrive/contact/closed_springs.h>
#include <chaindrive/contact/node_bores.h>
#include <chaindrive/contact/tributary_area.h>
#include <chaindrive/mesh/surface/cylinder_grid.h>
#include <chaindrive/mesh/surface/surface_nodes.h>
#include <chaindrive/reduction/basis.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/ranks.h>
#include <chaindrive/utilities/simd.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

namespace chaindrive::contact
{
namespace
{
JointBody body_at(BodyBatches                     &copies,
                  const unsigned int               copy,
                  const std::size_t                first,
                  const std::vector<unsigned int> &nodes)
{
  return {nodes.data(),
          copies.position.begin() + first,
          copies.velocity.begin() + first,
          copies.force.begin() + first,
          copies.pressed(copies.batch_of(copy))};
}

/// A body all of whose nodes this rank has.
JointBody
whole_body(BodyBatches &copies, const unsigned int copy, const std::vector<unsigned int> &nodes)
{
  return body_at(copies, copy, copies.index(copy, 0), nodes);
}

/// A body of another rank, of which the nodes @p offsets are ghosts: @p nodes become their places.
JointBody ghost_body(BodyBatches                     &copies,
                     const unsigned int               copy,
                     const std::vector<unsigned int> &offsets,
                     std::vector<unsigned int>       &nodes)
{
  const unsigned int lane = copies.lane_of(copy);
  if (nodes.empty())
    for (const unsigned int offset : offsets)
      nodes.push_back(
          static_cast<unsigned int>(copies.index(copy, offset / numbers_per_node) - lane));
  return body_at(copies, copy, lane, nodes);
}
} // namespace

NodeBores::Kinds NodeBores::kinds_of(const scene::BoreFamily &scene, const World &world)
{
  Kinds kinds;
  for (unsigned int i = 0; i < scene.pairs.size(); ++i)
    {
      const scene::BorePair &pair = scene.pairs[i];
      kinds[{world.node_address[pair.master].group,
             pair.master_surface,
             world.node_address[pair.slave.body].group,
             pair.slave_surface}]
          .push_back(i);
    }
  return kinds;
}

std::vector<unsigned int> NodeBores::owners_of(const scene::BoreFamily &scene, const World &world)
{
  std::vector<unsigned int> owner(scene.pairs.size()), load(n_ranks_in(world.communicator()), 0);
  for (const auto &[sides, pairs] : kinds_of(scene, world))
    {
      const BodyBatches &masters          = world.copies[std::get<0>(sides)],
                        &slaves           = world.copies[std::get<2>(sides)];
      const bool                at_second = std::get<1>(sides) == mesh::bush_bore_second;
      std::vector<unsigned int> by_bore, by_cylinder;
      for (const unsigned int i : pairs)
        {
          const unsigned int master = world.node_address[scene.pairs[i].master].copy;
          by_bore.push_back(masters.joint_ranks.empty() ?
                                masters.owner_of(master) :
                                masters.joint_ranks[master][at_second ? 1 : 0]);
          by_cylinder.push_back(
              slaves.owner_of(world.node_address[scene.pairs[i].slave.body].copy));
        }
      const auto with = [&load](const std::vector<unsigned int> &owners) {
        std::vector<unsigned int> sum = load;
        for (const unsigned int rank : owners)
          ++sum[rank];
        return sum;
      };
      const auto most = [&with](const std::vector<unsigned int> &owners) {
        const std::vector<unsigned int> sum = with(owners);
        return *std::max_element(sum.begin(), sum.end());
      };
      const bool either =
          masters.counts_readers() && slaves.counts_readers() && masters.joint_ranks.empty();
      const std::vector<unsigned int> &owners =
          either && most(by_cylinder) < most(by_bore) ? by_cylinder : by_bore;
      load = with(owners);
      for (unsigned int k = 0; k < pairs.size(); ++k)
        owner[pairs[k]] = owners[k];
    }
  return owner;
}

std::vector<unsigned int> NodeBores::owners_of_bores(const scene::Scene       &scene,
                                                     const scene::ToothFamily &teeth,
                                                     const World              &world)
{
  std::map<unsigned int, unsigned int> owner_of; // by body
  for (const scene::BoreFamily &bores : scene.bores)
    if (bores.elastic)
      {
        const std::vector<unsigned int> owner = owners_of(bores, world);
        for (unsigned int i = 0; i < owner.size(); ++i)
          owner_of[bores.pairs[i].master] = owner[i];
      }
  std::vector<unsigned int> owner;
  for (const scene::SlavePoint &slave : teeth.slaves)
    {
      const auto found = owner_of.find(slave.body);
      if (found == owner_of.end())
        throw std::logic_error("NodeBores: a roller on teeth without penalty has no joint");
      owner.push_back(found->second);
    }
  return owner;
}

void NodeBores::want_ghosts(const scene::BoreFamily &scene, World &world)
{
  const unsigned int              rank  = rank_in(world.communicator());
  const std::vector<unsigned int> owner = owners_of(scene, world);
  for (unsigned int i = 0; i < scene.pairs.size(); ++i)
    if (owner[i] == rank)
      {
        const scene::BorePair &pair = scene.pairs[i];
        for (const auto &[body, surface] : {std::make_pair(pair.master, pair.master_surface),
                                            std::make_pair(pair.slave.body, pair.slave_surface)})
          {
            const World::Address &at     = world.node_address[body];
            BodyBatches          &copies = world.copies[at.group];
            if (!copies.owns(at.copy))
              copies.want(at.copy,
                          mesh::SurfaceNodes(
                              *copies.part, copies.nodes, static_cast<mesh::Surface>(surface))
                              .node);
          }
      }
}

NodeBores::NodeBores(const scene::Scene      &scene,
                     const scene::BoreFamily &bores,
                     World                   &world,
                     const bool               search_every_step)
    : Family(bores.name, bores.interface, bores.law), every_step_(search_every_step)
{
  const bool exact = !has_penalty(scene, bores);
  largest_force_   = bores.largest_force;
  pairs_           = bores.pairs;
  for (const scene::BorePair &pair : bores.pairs)
    {
      add_radius(pair.slave.radius);
      add_record(pair.master, pair.slave.body, pair.slave.joint);
    }
  states_.resize(records_.size());
  for (unsigned int i = 0; i < records_.size(); ++i)
    stances_.push_back(stance(world, i));
  owner_                  = owners_of(bores, world);
  const unsigned int rank = rank_in(world.communicator());

  const JointKernels &kernels = *joint_kernels(simd_width());
  const auto          room    = std::make_shared<JointRoom>();
  for (auto &[sides, pairs] : kinds_of(bores, world))
    {
      const auto &[master_group, master_surface, slave_group, slave_surface] = sides;
      BodyBatches             &masters = world.copies[master_group];
      BodyBatches             &slaves  = world.copies[slave_group];
      const mesh::CylinderGrid bore(*masters.part, static_cast<mesh::Surface>(master_surface));
      const mesh::CylinderGrid cylinder(*slaves.part, static_cast<mesh::Surface>(slave_surface));

      const auto nodes_of = [](const mesh::CylinderGrid &grid, const BodyBatches &copies) {
        std::vector<unsigned int> nodes;
        for (const unsigned int vertex : grid.vertex)
          nodes.push_back(copies.nodes.of_vertex[vertex]);
        return nodes;
      };
      const std::vector<unsigned int> bore_nodes     = nodes_of(bore, masters),
                                      cylinder_nodes = nodes_of(cylinder, slaves);

      Group group;
      group.grids = std::make_unique<const std::array<mesh::CylinderGrid, 2>>(
          std::array<mesh::CylinderGrid, 2>{{bore, cylinder}});
      group.tables       = std::make_unique<JointTables>(bore, cylinder);
      group.master_nodes = node_offsets(bore, masters.nodes.vertex);
      group.slave_nodes  = node_offsets(cylinder, slaves.nodes.vertex);
      const auto carried = [&](const unsigned int s) { return carried_area(bore, s, cylinder); };
      const auto own     = [&](const unsigned int s) { return cylinder.area(s, 0); };
      group.closed       = {
                {closed_side(bore, master_surface, carried, law_.stiffness, world, master_group),
                 closed_side(cylinder, slave_surface, own, law_.stiffness, world, slave_group)}};
      for (ClosedSide &side : group.closed)
        if (cylinder.radius < bore.radius)
          side.half_angle = bores.half_angle;
      if (exact)
        {
          const reduction::RoundFlexibility &of_bore = *scene::round_flexibility(
                                                scene, masters.bodies.front(), master_surface),
                                            &of_cylinder = *scene::round_flexibility(
                                                scene, slaves.bodies.front(), slave_surface);
          group.flexibility = std::make_unique<const JointFlexibility>(of_bore, of_cylinder);
          const JointFlexibility &joint = *group.flexibility;
          group.windows                 = {
                              {window_of(of_bore,
                         bore,
                         joint.places().front().first,
                         joint.places().back().first + 1,
                         law_),
                               window_of(
                   of_cylinder, cylinder, joint.rings().front(), joint.rings().back(), law_)}};
          group.windows[0].group   = master_group;
          group.windows[1].group   = slave_group;
          group.windows[0].in_bore = true;
          group.windows[1].joint   = &joint;
          for (unsigned int i = 0; i < 2; ++i)
            group.windows[i].half_angle = group.closed[i].half_angle;
        }
      else if (master_group < world.n_elastic_groups() && slave_group < world.n_elastic_groups())
        group.closed[1].springs = closed_springs(
            bore, masters.nodes.of_vertex, cylinder, slaves.nodes.of_vertex, law_.stiffness);

      pairs.erase(std::remove_if(pairs.begin(),
                                 pairs.end(),
                                 [&](const unsigned int i) { return owner_[i] != rank; }),
                  pairs.end());
      // joints whose bores lie in one batch, lane by lane: their numbers are then side by side
      std::sort(pairs.begin(), pairs.end(), [&](const unsigned int a, const unsigned int b) {
        const unsigned int i = world.node_address[bores.pairs[a].master].copy,
                           j = world.node_address[bores.pairs[b].master].copy;
        return std::make_pair(masters.batch_of(i), i) < std::make_pair(masters.batch_of(j), j);
      });
      group.pairs = pairs;
      group.sides = {{{master_group, bore_nodes, bore.n_circumferential(), {}, {}},
                      {slave_group, cylinder_nodes, cylinder.n_circumferential(), {}, {}}}};
      for (const unsigned int i : pairs)
        {
          group.sides[0].copy.push_back(world.node_address[bores.pairs[i].master].copy);
          group.sides[1].copy.push_back(world.node_address[bores.pairs[i].slave.body].copy);
        }
      for (Group::Side &side : group.sides)
        side.read.resize(n_batches_of(pairs.size()));
      group.half_length =
          std::max(std::abs(cylinder.rings.front()), std::abs(cylinder.rings.back()));
      group.by_distance   = masters.counts_readers() && slaves.counts_readers();
      std::size_t n_modes = 0; // of both sides
      if (group.by_distance)
        for (const BodyBatches *copies : {&masters, &slaves})
          n_modes += scene.bases.at(scene.bodies[copies->bodies.front()].part())->size();
      group.use.resize(n_batches_of(pairs.size()), 0.);
      group.due.resize(n_batches_of(pairs.size()), 1);
      group.searched_stance.resize(pairs.size());
      group.searched_amplitude.resize(pairs.size(), std::vector<double>(n_modes, 0.));
      groups_.push_back(std::move(group));
      Group &placed = groups_.back();
      for (unsigned int i = 0; i < pairs.size(); ++i)
        {
          if (i % n_lanes == 0)
            {
              placed.batches.push_back(std::make_unique<JointBatch>(*placed.tables, law_, kernels));
              if (placed.flexibility)
                placed.batches.back()->set_flexibility(*placed.flexibility, room);
            }
          const scene::BorePair &pair   = bores.pairs[pairs[i]];
          const unsigned int     master = world.node_address[pair.master].copy,
                             slave      = world.node_address[pair.slave.body].copy;
          placed.batches.back()->set_joint(
              i % n_lanes,
              whole_body(masters, master, placed.master_nodes),
              slaves.has_nodes(slaves.batch_of(slave)) ?
                  whole_body(slaves, slave, placed.slave_nodes) :
                  ghost_body(slaves,
                             slave,
                             placed.slave_nodes,
                             placed.ghost_nodes[slaves.batch_of(slave)]));
        }
    }
}

void NodeBores::couple(RollerStrips &strips)
{
  for (Group &group : groups_)
    {
      const bool of_rollers =
          std::any_of(group.pairs.begin(), group.pairs.end(), [&](const unsigned int i) {
            return std::find(strips.bodies().begin(), strips.bodies().end(), records_[i].master) !=
                   strips.bodies().end();
          });
      if (of_rollers)
        group.coupled.push_back(
            {&strips,
             std::make_unique<const WallFlexibility>(strips.outside(),
                                                     strips.flexibility().grid(),
                                                     strips.flexibility().rings(),
                                                     group.flexibility->places())});
    }
}

void NodeBores::couple_lanes(const World &world, Group &group, const unsigned int b)
{
  for (unsigned int lane = 0; lane < n_lanes && b * n_lanes + lane < group.pairs.size(); ++lane)
    {
      const Record          &record = records_[group.pairs[b * n_lanes + lane]];
      StripProblem          *strips = nullptr;
      const WallFlexibility *wall   = nullptr;
      for (const Group::Coupled &coupled : group.coupled)
        {
          StripProblem *found = coupled.strips->problem_of(record.master);
          if (found == nullptr || found->n() == 0)
            continue;
          if (strips != nullptr)
            throw RunError("The roller of joint " + std::to_string(record.joint) +
                           " touches two sprockets at once, which teeth without penalty cannot do; "
                           "choose Contact/Enforcement = exact joints.");
          strips = found;
          wall   = coupled.wall.get();
        }
      double angle = 0.; // of the bush
      if (strips != nullptr)
        {
          strips->bush         = record.slave;
          const auto &rotation = world.frames[record.slave].rotation;
          angle                = std::atan2(rotation[1][0], rotation[0][0]);
        }
      group.batches[b]->couple(static_cast<int>(lane), strips, wall, angle);
    }
}

void NodeBores::add_forces(World &world, const double dt)
{
  const double unforeseen = unforeseen_speed(world);
  for (Group &group : groups_)
    for (unsigned int b = 0; b < group.batches.size(); ++b)
      {
        JointBatch &batch = *group.batches[b];
        if (group.due[b] != 0)
          {
            search(world, group, b, dt, unforeseen);
            announce_joints(world, group, b, every_step_ ? Readers::search : Readers::forces);
          }
        if (!group.coupled.empty())
          couple_lanes(world, group, b);
        batch.add_forces(dt, group.use[b]);

        const JointSums &sums = batch.sums();
        for (unsigned int lane = 0; lane < n_lanes; ++lane)
          {
            const unsigned int i = b * n_lanes + lane;
            if (i >= group.pairs.size())
              break;
            Record &record = records_[group.pairs[i]];
            record.gap     = sums.touching[lane] > 0 ? -sums.largest_penetration[lane] :
                                                       std::numeric_limits<double>::max();
            for (unsigned int d = 0; d < 3; ++d)
              {
                const double force = sums.force[d][lane];
                record.force[d]    = force;
                // for the motion of the centres of mass
                world.force.local_element(3 * record.slave + d) += force;
                world.force.local_element(3 * record.master + d) -= force;
              }
            record.force                   = world.symmetry.whole_force(record.force);
            const double size              = record.force.norm();
            most_pressed_                  = std::max(most_pressed_, size / largest_force_);
            states_[group.pairs[i]].normal = size;
            if (size > 0.)
              record.normal = record.force / size;
            world.ledger.contact += sums.stored[lane];
            world.ledger.contact_damping += sums.damping_loss[lane];
            world.ledger.friction += sums.friction_loss[lane];
          }
        batch.clear_losses();
      }
}

void NodeBores::serialize(const Archive &archive, const unsigned int rank)
{
  Family::serialize(archive, rank);
  for (Group &group : groups_)
    for (unsigned int i = 0; i < group.pairs.size(); ++i)
      {
        const unsigned int pair = group.pairs[i];
        const Archive      own  = archive.of_this_rank() / ("joint " + std::to_string(pair));
        group.batches[i / n_lanes]->serialize(i % n_lanes, own);
        own("stance", stances_[pair]);
        own("searched stance", group.searched_stance[i]);
        own.numbers("searched amplitudes", group.searched_amplitude[i]);
      }
}

std::vector<ClosedPair> NodeBores::closed_pairs(const World &) const
{
  std::vector<ClosedPair> pairs;
  pairs.reserve(groups_.size());
  for (const Group &group : groups_)
    if (!group.flexibility)
      pairs.push_back(group.closed);
  return pairs;
}

std::vector<ClosedWindow> NodeBores::closed_windows() const
{
  std::vector<ClosedWindow> windows;
  for (const Group &group : groups_)
    if (group.flexibility)
      windows.insert(windows.end(), group.windows.begin(), group.windows.end());
  return windows;
}

std::optional<unsigned int> NodeBores::deepest_node(const unsigned int i) const
{
  for (const Group &group : groups_)
    {
      const auto found = std::find(group.pairs.begin(), group.pairs.end(), i);
      if (found == group.pairs.end())
        continue;
      const std::size_t place = found - group.pairs.begin(), lane = place % n_lanes;
      const auto       &state       = group.batches[place / n_lanes]->state();
      const auto        penetration = [&](const unsigned int node) {
        return state[(node * n_touch_entries + touch_penetration) * n_lanes + lane];
      };
      unsigned int deepest = 0;
      for (unsigned int node = 1; node < group.slave_nodes.size(); ++node)
        if (penetration(node) > penetration(deepest))
          deepest = node;
      return group.slave_nodes[deepest] / (3 * n_lanes);
    }
  return {};
}
} // namespace chaindrive::contact
