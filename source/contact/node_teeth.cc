// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/node_teeth.h>
#include <chaindrive/mesh/surface/facet_surface.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace chaindrive::contact
{
namespace
{
constexpr double within = 200e-6; // m, how far facets of an imported mesh are looked for at first

/// How far the share of each node of a side reaches below and above it along z: half way to the
/// next station of nodes, m.
std::vector<std::array<double, 2>> extents(const mesh::Nodes               &nodes,
                                           const std::vector<unsigned int> &side)
{
  std::vector<double> stations;
  stations.reserve(side.size());
  for (const unsigned int node : side)
    stations.push_back(nodes.position[node][2]);
  std::sort(stations.begin(), stations.end());
  const double same = 1e-9 * (stations.back() - stations.front());
  stations.erase(std::unique(stations.begin(),
                             stations.end(),
                             [same](const double a, const double b) { return b - a <= same; }),
                 stations.end());

  std::vector<std::array<double, 2>> result;
  for (const unsigned int node : side)
    {
      const double z     = nodes.position[node][2];
      const auto   below = std::lower_bound(stations.begin(), stations.end(), z - same);
      const auto   above = std::upper_bound(stations.begin(), stations.end(), z + same);
      result.push_back({{below == stations.begin() ? 0. : 0.5 * (z - *(below - 1)),
                         above == stations.end() ? 0. : 0.5 * (*above - z)}});
    }
  return result;
}
} // namespace

NodeTeeth::NodeTeeth(const scene::ToothFamily &scene,
                     const World              &world,
                     const bool                search_every_step)
    : Teeth(scene), every_step_(search_every_step)
{
  group_                    = world.elastic_address[scene.slaves.front().body].group;
  const BodyBatches &copies = world.copies[group_];
  surface_                  = std::make_unique<mesh::SurfaceNodes>(
      *copies.part, copies.nodes, static_cast<mesh::Surface>(scene.slave_surface));
  extent_ = extents(copies.nodes, surface_->node);
  if (const Rim *rim = world.rim_of(scene.sprocket))
    flanks_ = make_flanks(scene_, world, *rim);
  for (const scene::SlavePoint &slave : scene.slaves)
    {
      copy_.push_back(world.elastic_address[slave.body].copy);
      owner_.push_back(copies.owner_of(copy_.back()));
      first_.push_back(copies.owns(copy_.back()) ? copies.index(copy_.back(), 0, 0) : 0);
    }
  nodes_.resize(scene.slaves.size() * surface_->size());
}

dealii::Tensor<1, 3>
NodeTeeth::value(const BodyBatches::Vector &from, const unsigned int i, const unsigned int s) const
{
  dealii::Tensor<1, 3> v;
  const std::size_t    place = first_[i] + std::size_t(3) * surface_->node[s] * n_lanes;
  for (unsigned int d = 0; d < 3; ++d)
    v[d] = from.local_element(place + d * n_lanes);
  return v;
}

double NodeTeeth::cover(const Frame &hub, const dealii::Tensor<1, 3> &x, const unsigned int s) const
{
  const double z    = axis_of(hub, 2) * (x - hub.position);
  const double from = std::max(z - extent_[s][0], -scene_.half_width);
  const double to   = std::min(z + extent_[s][1], scene_.half_width);
  return std::max(0., to - from) / (extent_[s][0] + extent_[s][1]);
}

void NodeTeeth::search(const World &world, const double reach)
{
  Teeth::search(world, reach);
  own_.clear();
  for (unsigned int i = 0; i < copy_.size(); ++i)
    if (!world.copies[group_].owns(copy_[i]))
      continue;
    else if (std::binary_search(near_.begin(), near_.end(), i))
      own_.push_back(i);
    else // far from every tooth: when it comes back it is a new one
      std::fill_n(nodes_.begin() + i * surface_->size(), surface_->size(), Node());
}

bool NodeTeeth::within_reach(const unsigned int i) const
{
  return std::binary_search(near_.begin(), near_.end(), i);
}

void NodeTeeth::serialize(const Archive &archive, const unsigned int rank)
{
  Teeth::serialize(archive, rank);
  archive("now", now_);
  archive("before", before_);
  if (archive.reads())
    {
      own_.clear();
      for (const unsigned int i : near_)
        if (owner_[i] == rank)
          own_.push_back(i);
    }
}

void NodeTeeth::serialize_pair(const unsigned int i, const Archive &archive)
{
  Teeth::serialize_pair(i, archive);
  archive.numbers("nodes", &node(i, 0), surface_->size());
}

Touch NodeTeeth::touch(const World                &world,
                       const unsigned int          i,
                       const unsigned int          s,
                       const dealii::Tensor<1, 3> &x,
                       Flanks::Projection         &projection)
{
  Node &node = this->node(i, s);
  // what overlaps is looked for as deep as it may be, and deeper
  const double far = node.touch.overlap > 0. ? std::max(within, 2. * senseless_overlap()) : within;
  if (flanks_)
    return flanks_->touch(world, x, far, node.hint, projection);
  return touch_flanks(scene_, x, 0., far, world.frames[scene_.sprocket], node.hint);
}

dealii::Tensor<1, 3> NodeTeeth::flank_velocity(const World                &world,
                                               const dealii::Tensor<1, 3> &x,
                                               const Flanks::Projection   &projection,
                                               const double                dt) const
{
  // nodal velocities are the secants of the step: the sprocket's point goes along its own
  return flanks_ ? flanks_->velocity(world, projection) :
                   world.velocity_at(scene_.sprocket, x, 0.5 * dt);
}

void NodeTeeth::add_forces(World &world, const double dt)
{
  before_ = now_;
  now_ += dt;
  unforeseen_ = unforeseen_speed(world);
  for (const unsigned int i : own_)
    add_roller_forces(world, i, dt);
}

void NodeTeeth::add_roller_forces(World &world, const unsigned int i, const double dt)
{
  BodyBatches       &copies = world.copies[group_];
  Flanks::Projection projection;

  const Frame &hub    = world.frames[scene_.sprocket];
  Record      &record = records_[i];
  record.gap          = std::numeric_limits<double>::max();
  record.force        = dealii::Tensor<1, 3>();
  dealii::Tensor<1, 3> resultant; // of the normal forces
  double               normal_force = 0., power = 0.;
  for (unsigned int s = 0; s < surface_->size(); ++s)
    {
      Node &node = this->node(i, s);
      if (node.due > now_ && !every_step_)
        {
          record.gap = std::min(record.gap, node.gap);
          continue;
        }
      const bool                 left_alone = node.due >= 0. && node.visited < before_;
      const dealii::Tensor<1, 3> x          = value(copies.position, i, s);
      const double               share      = cover(hub, x, s) * surface_->area[s];
      const Touch                touch      = this->touch(world, i, s, x, projection);

      TouchState             &memory = node.touch;
      const scene::ContactLaw law    = law_.times(share);
      node.gap                       = share > 0. ? touch.gap : std::numeric_limits<double>::max();
      node.due                       = now_;
      node.visited                   = now_;
      record.gap                     = std::min(record.gap, node.gap);
      if (touch.gap >= 0. || share == 0.)
        {
          if (memory.overlap > 0. && touch.gap == std::numeric_limits<double>::max())
            lose_touch(law, memory, world.ledger);
          else
            come_apart(law, dt, memory, world.ledger);
          const double speed =
              (value(copies.velocity, i, s) - flank_velocity(world, x, projection, dt)).norm();
          node.due += std::clamp(touch.gap, 0., within) / (2. * speed + unforeseen_);
          continue;
        }
      if (left_alone)
        ++n_missed_;

      const dealii::Tensor<1, 3> relative =
          value(copies.velocity, i, s) - flank_velocity(world, x, projection, dt);
      const dealii::Tensor<1, 3> force =
          press(law, touch, relative, relative, dt, memory, world.ledger).total;
      resultant += memory.normal * touch.normal;
      normal_force += memory.normal;
      power -= memory.normal * (relative * touch.normal);
      for (unsigned int d = 0; d < 3; ++d)
        copies.force.local_element(first_[i] + (3 * surface_->node[s] + d) * n_lanes) += force[d];
      if (flanks_)
        flanks_->add_force(world, projection, -force);
      else
        world.add_force(scene_.sprocket, -force, x);
      record.force += force;
      record.feature = touch.feature;
    }

  for (unsigned int d = 0; d < 3; ++d) // for the motion of the centre of mass
    world.force.local_element(3 * record.slave + d) += record.force[d];
  record.force      = world.of_whole(record.force);
  states_[i].normal = normal_force;
  if (normal_force > 0.)
    {
      record.normal       = resultant / resultant.norm();
      record.normal_speed = power / normal_force;
    }
}

std::vector<ClosedPair> NodeTeeth::closed_pairs(const World &world) const
{
  const BodyBatches &copies = world.copies[group_];
  ClosedPair         pair;
  ClosedSide        &roller = pair[1];
  roller.group              = group_;
  roller.surface            = scene_.slave_surface;
  roller.stiffness.resize(copies.n_nodes());
  for (unsigned int s = 0; s < surface_->size(); ++s)
    {
      const unsigned int node = surface_->node[s];
      const double       k    = law_.stiffness * surface_->area[s];
      roller.hold(node, k, copies.nodes.mass[node]);
    }
  if (flanks_) // a rigid sprocket is heavy beside a node: each node on its own spring
    pair[0] = flanks_->closed_side(
        law_.stiffness, world.copies[world.rim_of(scene_.sprocket)->group], *surface_, copies);
  return {pair};
}

std::optional<unsigned int> NodeTeeth::deepest_node(const unsigned int i) const
{
  if (!std::binary_search(own_.begin(), own_.end(), i))
    return {};
  const auto first = nodes_.begin() + i * surface_->size();
  const auto deepest =
      std::max_element(first, first + surface_->size(), [](const Node &a, const Node &b) {
        return a.touch.overlap < b.touch.overlap;
      });
  return surface_->node[deepest - first];
}
} // namespace chaindrive::contact
