// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/cylinder_patches.h>
#include <chaindrive/contact/node_contact.h>
#include <chaindrive/contact/point_force.h>
#include <chaindrive/utilities/ranks.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::contact
{
namespace
{
constexpr double within = 200e-6; // m, how far facets of an imported mesh are looked for at first

std::vector<unsigned int> bodies_of(const std::vector<scene::SlavePoint> &slaves)
{
  std::vector<unsigned int> bodies;
  bodies.reserve(slaves.size());
  for (const scene::SlavePoint &slave : slaves)
    bodies.push_back(slave.body);
  return bodies;
}

/// Whether @p surface is that of a cylinder.
bool is_round(const unsigned int surface)
{
  return surface == mesh::roller_outside || surface == mesh::bush_outside_first ||
         surface == mesh::bush_outside_second;
}
} // namespace

NodeContact::NodeContact(const scene::SurfaceFamily &scene,
                         const World                &world,
                         const bool                  search_every_step)
    : SurfaceContact(scene.name, scene.interface, scene.law, pairs_on(scene.surface, scene.slaves))
    , surface_(scene.surface)
    , slaves_(world, bodies_of(scene.slaves), scene.slave_surface, scene.slave_nodes)
    , every_step_(search_every_step)
    , surface_stiffness_(scene.surface_stiffness)
    , half_angle_(scene.half_angle)
{
  for (unsigned int i = 0; i < slaves_.n_bodies(); ++i)
    owner_.push_back(slaves_.owner(world, i));
  nodes_.resize(std::size_t(slaves_.n_bodies()) * slaves_.n_nodes());
  find_own(rank_in(world.communicator()));
}

void NodeContact::find_own(const unsigned int rank)
{
  own_.clear();
  for (const unsigned int i : near_)
    if (owner_[i] == rank)
      own_.push_back(i);
}

void NodeContact::search(const World &world, const double reach)
{
  SurfaceContact::search(world, reach);
  find_own(rank_in(world.communicator()));
  for (unsigned int i = 0; i < slaves_.n_bodies(); ++i)
    if (!within_reach(i)) // far from everything: when it comes back it is a new one
      std::fill_n(nodes_.begin() + i * slaves_.n_nodes(), slaves_.n_nodes(), Node());
}

bool NodeContact::within_reach(const unsigned int i) const
{
  return std::binary_search(near_.begin(), near_.end(), i);
}

void NodeContact::serialize(const Archive &archive, const unsigned int rank)
{
  SurfaceContact::serialize(archive, rank);
  clock_.serialize(archive);
  if (archive.reads())
    find_own(rank);
}

void NodeContact::serialize_pair(const unsigned int i, const Archive &archive)
{
  SurfaceContact::serialize_pair(i, archive);
  archive.numbers("nodes", &node(i, 0), slaves_.n_nodes());
}

void NodeContact::add_forces(World &world, const double dt)
{
  clock_.advance(dt);
  unforeseen_ = unforeseen_speed(world);
  for (const unsigned int i : own_)
    add_body_forces(world, i, dt);
}

void NodeContact::add_body_forces(World &world, const unsigned int i, const double dt)
{
  Record &record = records_[i];
  record.gap     = std::numeric_limits<double>::max();
  record.force   = dealii::Tensor<1, 3>();
  Resultant sum;
  if (surface_stiffness_ > 0.)
    add_forces_on_deflected(world, i, dt, sum);
  else
    {
      Surface::Projection projection; // once for all, since not every surface has one
      for (unsigned int s = 0; s < slaves_.n_nodes(); ++s)
        if (is_due(i, s))
          add_node_force(world, i, visit(world, i, s, projection), dt, projection, sum);
    }
  for (unsigned int s = 0; s < slaves_.n_nodes(); ++s)
    record.gap = std::min(record.gap, node(i, s).gap);

  for (unsigned int d = 0; d < 3; ++d) // for the motion of the centre of mass
    world.force.local_element(3 * record.slave + d) += record.force[d];
  record.force      = world.symmetry.whole_force(record.force);
  states_[i].normal = sum.normal_force;
  if (sum.normal_force > 0.)
    {
      record.normal       = sum.normal / sum.normal.norm();
      record.normal_speed = sum.power / sum.normal_force;
    }
}

void NodeContact::add_forces_on_deflected(World             &world,
                                          const unsigned int i,
                                          const double       dt,
                                          Resultant         &sum)
{
  Surface::Projection none; // the surface is rigid
  visits_.clear();
  penetrating_.clear();
  for (unsigned int s = 0; s < slaves_.n_nodes(); ++s)
    if (is_due(i, s))
      {
        visits_.push_back(visit(world, i, s, none));
        const Visit &v = visits_.back();
        if (v.may_touch && v.gap < 0.)
          {
            const dealii::Tensor<1, 3> relative =
                surface_->relative_velocity(world, v.x, none, slaves_.velocity(world, i, s), dt);
            penetrating_.push_back({v.law.stiffness, -v.gap, -(relative * v.touch.normal)});
          }
      }
  const Deflection deflection = deflection_under(surface_stiffness_, penetrating_);
  for (Visit &v : visits_)
    {
      if (v.gap < 0.)
        {
          v.touch.gap += deflection.depth;
          v.receding = deflection.rate;
        }
      add_node_force(world, i, v, dt, none, sum);
    }
  TouchState now;
  now.penetration = deflection.depth;
  now.normal      = sum.normal_force;
  book_deflection(surface_stiffness_, states_[i], now, world.ledger);
  states_[i] = now;
}

NodeContact::Visit NodeContact::visit(const World         &world,
                                      const unsigned int   i,
                                      const unsigned int   s,
                                      Surface::Projection &projection)
{
  const Frame &master = world.frames[surface_->body()];
  Node        &node   = this->node(i, s);
  Visit        visit;
  visit.s           = s;
  visit.x           = slaves_.position(world, i, s);
  const double z    = axis_of(master, 2) * (visit.x - master.position);
  const double area = slaves_.cover(z, surface_->half_width(), s) * slaves_.area(s);
  visit.law         = law_.times(area);
  visit.may_touch   = area > 0.;

  // what overlaps is looked for as deep as it may be, and deeper
  const double far =
      node.touch.penetration > 0. ? std::max(within, 2. * penetration_limit()) : within;
  visit.touch = surface_->project(world, visit.x, 0., far, node.hint, projection);
  visit.gap   = visit.touch.gap;
  return visit;
}

void NodeContact::add_node_force(World                     &world,
                                 const unsigned int         i,
                                 const Visit               &visit,
                                 const double               dt,
                                 const Surface::Projection &projection,
                                 Resultant                 &sum)
{
  Node        &node       = this->node(i, visit.s);
  Record      &record     = records_[i];
  const Touch &touch      = visit.touch;
  const bool   left_alone = node.cadence.left_alone(clock_);
  const bool   found      = visit.gap != std::numeric_limits<double>::max();
  const auto   relative   = [&]() {
    return surface_->relative_velocity(
        world, visit.x, projection, slaves_.velocity(world, i, visit.s), dt);
  };

  node.gap = visit.may_touch ? touch.gap : std::numeric_limits<double>::max();
  if (touch.gap >= 0. || !visit.may_touch)
    {
      if (found)
        separate(visit.law, dt, node.touch, world.ledger);
      else if (node.touch.penetration > 0.)
        lose_contact(visit.law, node.touch, world.ledger);
      node.cadence.restart(
          clock_, holding_time(std::clamp(visit.gap, 0., within), relative().norm(), unforeseen_));
      return;
    }
  if (left_alone)
    ++n_missed_;
  node.cadence.restart(clock_, 0.);

  const dealii::Tensor<1, 3> v     = relative();
  const PointForce           force = penalty_force(visit.law,
                                         touch,
                                         v + visit.receding * touch.normal,
                                         surface_->slip_velocity(world, touch, projection, v),
                                         dt,
                                         node.touch,
                                         world.ledger);
  slaves_.add_force(world, i, visit.s, force.total);
  surface_->add_opposite(world, visit.x, touch, projection, force);

  record.force += force.total;
  record.feature = touch.feature;
  sum.normal += node.touch.normal * touch.normal;
  sum.normal_force += node.touch.normal;
  sum.power -= node.touch.normal * (v * touch.normal);
}

void NodeContact::raise_pressures(std::vector<double> &largest) const
{
  for_each_pressure([&](const unsigned int i, const unsigned int, const double pressure) {
    double &of_joint = largest[records_[i].joint];
    of_joint         = std::max(of_joint, pressure);
  });
}

void NodeContact::add_pressures(const World & /*world*/, std::vector<NodePressure> &pressures) const
{
  for_each_pressure([&](const unsigned int i, const unsigned int s, const double pressure) {
    pressures.push_back({records_[i].slave, slaves_.node(s), pressure});
  });
}

void NodeContact::add_patches(const World &world, std::vector<PressurePatch> &patches) const
{
  if (!is_round(slaves_.surface()))
    return;
  if (!round_)
    {
      const BodyBatches        &copies = slaves_.batches(world);
      const mesh::CylinderGrid  grid(*copies.part, static_cast<mesh::Surface>(slaves_.surface()));
      std::vector<unsigned int> place(slaves_.n_nodes());
      const auto               &nodes = slaves_.side().node; // in ascending order
      for (unsigned int p = 0; p < grid.vertex.size(); ++p)
        {
          const unsigned int node  = copies.nodes.of_vertex[grid.vertex[p]];
          const auto         found = std::lower_bound(nodes.begin(), nodes.end(), node);
          if (found != nodes.end() && *found == node)
            place[found - nodes.begin()] = p;
        }
      round_ = std::make_unique<const Round>(Round{grid, place});
    }
  for_each_pressure([&](const unsigned int i, const unsigned int s, const double pressure) {
    const unsigned int n = round_->grid.n_circumferential(), place = round_->place[s];
    patches.push_back(
        {records_[i].slave,
         surface_->body(),
         records_[i].joint,
         corners_of_piece(round_->grid, place / n, place % n, world.frames[records_[i].slave]),
         pressure * slaves_.area(s),
         pressure});
  });
}

std::vector<ClosedPair> NodeContact::closed_pairs(const World &world) const
{
  const BodyBatches &batches = slaves_.batches(world);
  ClosedPair         pair;
  ClosedSide        &slave = pair[1];
  slave.group              = slaves_.group();
  slave.surface            = slaves_.surface();
  slave.flat               = surface_->facing() == Surface::Facing::anywhere;
  slave.stiffness.resize(batches.n_nodes());
  for (unsigned int s = 0; s < slaves_.n_nodes(); ++s)
    slave.add_spring(
        slaves_.node(s), law_.stiffness * slaves_.area(s), batches.nodes.mass[slaves_.node(s)]);
  if (is_round(slave.surface))
    {
      const dealii::Point<3> &axis = pairs_.front().slave.point;
      slave.half_angle             = half_angle_;
      slave.normal.resize(batches.n_nodes());
      for (unsigned int s = 0; s < slaves_.n_nodes(); ++s)
        {
          const dealii::Point<3> &x = batches.nodes.position[slaves_.node(s)];
          const double            r = std::hypot(x[0] - axis[0], x[1] - axis[1]);
          for (unsigned int d = 0; d < 2; ++d)
            slave.normal[slaves_.node(s)][d] = (x[d] - axis[d]) / r;
        }
    }
  pair[0] = surface_->closed_side(world, law_.stiffness, slaves_.side(), batches);
  return {pair};
}

std::optional<unsigned int> NodeContact::deepest_node(const unsigned int i) const
{
  if (!std::binary_search(own_.begin(), own_.end(), i))
    return {};
  const auto first = nodes_.begin() + i * slaves_.n_nodes();
  const auto deepest =
      std::max_element(first, first + slaves_.n_nodes(), [](const Node &a, const Node &b) {
        return a.touch.penetration < b.touch.penetration;
      });
  return slaves_.node(deepest - first);
}
} // namespace chaindrive::contact
