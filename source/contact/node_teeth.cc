// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/node_teeth.h>
#include <chaindrive/mesh/facet_surface.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::contact
{
namespace
{
constexpr double reach = 100e-6; // m; larger: fewer searches but longer lists

/// Nodes move relative to a tooth by the motion of their body, which is measured, and by spin and
/// vibration: impacts of a roller drive reach a few m/s.
constexpr double vibration = 10.; // m/s

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
  group_               = world.places[scene.slaves.front().body].group;
  const Copies &copies = world.copies[group_];
  surface_             = std::make_unique<mesh::SurfaceNodes>(
      *copies.part, copies.nodes, static_cast<mesh::Surface>(scene.slave_surface));
  extent_ = extents(copies.nodes, surface_->node);
  if (const Rim *rim = world.rim_of(scene.sprocket))
    flanks_ = std::make_unique<ToothSurface>(scene_, world, *rim);
  for (const scene::SlavePoint &slave : scene.slaves)
    {
      copy_.push_back(world.places[slave.body].copy);
      owner_.push_back(copies.owner_of(copy_.back()));
    }
  node_states_.resize(scene.slaves.size() * surface_->size());
  hints_.assign(node_states_.size(), mesh::Projection::no_facet);
  active_.resize(scene.slaves.size());
}

dealii::Tensor<1, 3> NodeTeeth::value(const World          &world,
                                      const Copies::Vector &from,
                                      const unsigned int    i,
                                      const unsigned int    s) const
{
  dealii::Tensor<1, 3> v;
  for (unsigned int d = 0; d < 3; ++d)
    v[d] = from.local_element(world.copies[group_].index(copy_[i], surface_->node[s], d));
  return v;
}

double NodeTeeth::cover(const Frame &hub, const dealii::Tensor<1, 3> &x, const unsigned int s) const
{
  const double z    = axis_of(hub, 2) * (x - hub.position);
  const double from = std::max(z - extent_[s][0], -scene_.half_width);
  const double to   = std::min(z + extent_[s][1], scene_.half_width);
  return std::max(0., to - from) / (extent_[s][0] + extent_[s][1]);
}

void NodeTeeth::search(const World &world, const double roller_reach)
{
  Teeth::search(world, roller_reach);
  for (unsigned int i = 0; i < active_.size(); ++i)
    if (!std::binary_search(near_.begin(), near_.end(), i))
      active_[i].clear(); // far from every tooth
  approach_ = reach;      // new rollers: look at their nodes
  own_.clear();
  for (const unsigned int i : near_)
    if (world.copies[group_].owns(copy_[i]))
      own_.push_back(i);
}

bool NodeTeeth::within_reach(const unsigned int i) const
{
  return std::binary_search(near_.begin(), near_.end(), i);
}

void NodeTeeth::exchange(const Archive &archive, const unsigned int rank)
{
  Teeth::exchange(archive, rank);
  archive("nodes' approach", approach_);
  if (archive.reads())
    {
      own_.clear();
      for (const unsigned int i : near_)
        if (owner_[i] == rank)
          own_.push_back(i);
    }
}

void NodeTeeth::exchange_pair(const unsigned int i, const Archive &archive)
{
  Teeth::exchange_pair(i, archive);
  archive.numbers("nodes", &state(i, 0), surface_->size());
  archive.numbers("hints", &hint(i, 0), surface_->size());
  archive("active", active_[i]);
}

Touch NodeTeeth::touch(const World                &world,
                       const unsigned int          i,
                       const unsigned int          s,
                       const dealii::Tensor<1, 3> &x,
                       ToothSurface::Foot         &foot)
{
  if (flanks_)
    return flanks_->touch(world, x, 2. * reach, hint(i, s), foot);
  return touch_flanks(scene_, x, 0., 2. * reach, world.frames[scene_.sprocket], hint(i, s));
}

void NodeTeeth::search_nodes(const World &world)
{
  const Frame              &hub = world.frames[scene_.sprocket];
  ToothSurface::Foot        foot;
  std::vector<unsigned int> found;
  for (const unsigned int i : own_)
    {
      found.clear();
      const bool looked_at = records_[i].gap < std::numeric_limits<double>::max();
      for (unsigned int s = 0; s < surface_->size(); ++s)
        {
          const dealii::Tensor<1, 3> x   = value(world, world.copies[group_].position, i, s);
          const double               gap = touch(world, i, s, x, foot).gap;
          if (gap < reach)
            found.push_back(s);
          if (gap < 0. && looked_at && cover(hub, x, s) > 0. &&
              !std::binary_search(active_[i].begin(), active_[i].end(), s))
            ++n_missed_;
        }
      active_[i].swap(found);
    }
  approach_ = 0.;
}

void NodeTeeth::add_forces(World &world, const double dt)
{
  const Frame &hub = world.frames[scene_.sprocket];

  double fastest = 0.;
  for (const unsigned int i : near_)
    fastest = std::max(fastest, world.frames[scene_.slaves[i].body].velocity.norm());
  approach_ += (fastest + hub.angular_velocity.norm() * scene_.outer_radius + vibration) * dt;
  if (every_step_ || approach_ >= reach)
    search_nodes(world);

  for (const unsigned int i : own_)
    add_roller_forces(world, i, dt);
}

void NodeTeeth::add_roller_forces(World &world, const unsigned int i, const double dt)
{
  Copies            &copies = world.copies[group_];
  ToothSurface::Foot foot;

  const Frame &hub    = world.frames[scene_.sprocket];
  Record      &record = records_[i];
  record.gap          = std::numeric_limits<double>::max();
  record.force        = dealii::Tensor<1, 3>();
  dealii::Tensor<1, 3> resultant; // of the normal forces
  double               normal_force = 0., power = 0.;
  for (const unsigned int s : active_[i])
    {
      const dealii::Tensor<1, 3> x     = value(world, copies.position, i, s);
      const double               share = cover(hub, x, s) * surface_->area[s];
      const Touch                touch = this->touch(world, i, s, x, foot);

      TouchState      &memory = state(i, s);
      const scene::Law law    = law_.times(share);
      if (share > 0.)
        record.gap = std::min(record.gap, touch.gap);
      if (touch.gap >= 0. || share == 0.)
        {
          if (memory.overlap >
              0.) // it has just come apart: let the law book what the spring gave back
            update_touch(
                law, std::max(0., touch.gap), 0., dealii::Tensor<1, 2>(), dt, memory, world.ledger);
          continue;
        }

      // Nodal velocities are the secants of the step: the sprocket's point goes along its own.
      const dealii::Tensor<1, 3> relative =
          value(world, copies.velocity, i, s) -
          (flanks_ ? flanks_->velocity(world, foot) :
                     world.velocity_at(scene_.sprocket, x, 0.5 * dt));
      const double         gap_rate = relative * touch.normal;
      dealii::Tensor<1, 2> slip_rate;
      slip_rate[0] = relative * touch.along;
      slip_rate[1] = relative * touch.across;
      update_touch(law, touch.gap, gap_rate, slip_rate, dt, memory, world.ledger);

      dealii::Tensor<1, 3> force = memory.normal * touch.normal;
      resultant += force;
      normal_force += memory.normal;
      power -= memory.normal * gap_rate;
      if (law.friction > 0.)
        force += memory.tangential[0] * touch.along + memory.tangential[1] * touch.across;
      for (unsigned int d = 0; d < 3; ++d)
        copies.force.local_element(copies.index(copy_[i], surface_->node[s], d)) += force[d];
      if (flanks_)
        flanks_->add_force(world, foot, -force);
      else
        world.add_force(scene_.sprocket, -force, x);
      record.force += force;
      record.feature = touch.feature;
    }

  for (unsigned int d = 0; d < 3; ++d) // for the motion of the centre of mass
    world.force.local_element(3 * record.slave + d) += record.force[d];
  record.force *= world.whole;
  states_[i].normal = normal_force;
  if (normal_force > 0.)
    {
      record.normal       = resultant / resultant.norm();
      record.normal_speed = power / normal_force;
      record.peak         = std::max(record.peak, world.whole * resultant.norm());
    }
}

std::vector<unsigned int> NodeTeeth::node_groups() const
{
  if (flanks_)
    return {group_, flanks_->group()};
  return {group_};
}

double NodeTeeth::largest_node_eigenvalue(const World &world) const
{
  // a rigid sprocket is heavy beside a node: each node on its own spring
  const Copies &copies  = world.copies[group_];
  double        largest = 0.;
  for (unsigned int s = 0; s < surface_->size(); ++s)
    largest = std::max(largest,
                       law_.stiffness * surface_->area[s] / copies.nodes.mass[surface_->node[s]]);
  // the two sides are separate addends of B^T M^-1 B
  if (flanks_)
    largest += flanks_->largest_eigenvalue(
        law_.stiffness, world.copies[world.rim_of(scene_.sprocket)->group], *surface_, copies);
  return largest;
}
} // namespace chaindrive::contact
