// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/node_faces.h>
#include <chaindrive/contact/point_force.h>
#include <chaindrive/contact/tributary_area.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace chaindrive::contact
{
namespace
{
constexpr double reach = 50e-6; // m; larger: fewer searches but more nodes to look at

/// The facets of one face: on the side of z and of x that @p axis is on.
std::unique_ptr<const MovingFacets> facets_of(const BodyBatches      &copies,
                                              const unsigned int      surface,
                                              const dealii::Point<3> &axis,
                                              const double            sign)
{
  return std::make_unique<const MovingFacets>(*copies.part,
                                              copies.nodes,
                                              static_cast<mesh::Surface>(surface),
                                              [&axis, sign](const dealii::Point<3> &x) {
                                                return sign * x[2] > 0. && axis[0] * x[0] >= 0.;
                                              });
}

std::vector<double>
distances(const MovingFacets &facets, const BodyBatches &copies, const dealii::Point<3> &axis)
{
  std::vector<double> r;
  for (const unsigned int n : facets.nodes())
    {
      const dealii::Point<3> &x = copies.nodes.position[n];
      r.push_back(std::hypot(x[0] - axis[0], x[1] - axis[1]));
    }
  return r;
}

std::vector<TributaryArea>
tributary_areas(const MovingFacets &facets, const BodyBatches &copies, const dealii::Point<3> &axis)
{
  const std::vector<double>  r     = distances(facets, copies, axis);
  const auto                 range = facets.ranges(r);
  std::vector<TributaryArea> result;
  for (unsigned int i = 0; i < r.size(); ++i)
    result.emplace_back(facets.areas()[i], r[i], range[i][0], range[i][1]);
  return result;
}

/// The same for every pair of the same two sides.
using SideKey = std::tuple<unsigned int, unsigned int, unsigned int, unsigned int, bool, bool>;

SideKey key_of(const scene::FacePair &pair, const World &world)
{
  return {world.elastic_address[pair.master].group,
          pair.master_surface,
          world.elastic_address[pair.slave].group,
          pair.slave_surface,
          pair.master_axis[0] > 0.,
          pair.slave_axis[0] > 0.};
}
} // namespace

void NodeFaces::want_ghosts(const scene::FaceFamily &scene, World &world)
{
  for (const scene::FacePair &pair : scene.pairs)
    {
      const World::Address &master = world.elastic_address[pair.master],
                           &slave  = world.elastic_address[pair.slave];
      BodyBatches &masters         = world.copies[master.group];
      if (!world.copies[slave.group].owns(slave.copy) || masters.owns(master.copy))
        continue;
      for (const double sign : {-1., 1.})
        masters.want(master.copy,
                     facets_of(masters, pair.master_surface, pair.master_axis, sign)->nodes());
    }
}

NodeFaces::NodeFaces(const scene::FaceFamily &scene, World &world, const bool search_every_step)
    : Family(scene.name, scene.interface, scene.law), every_step_(search_every_step)
{
  std::map<SideKey, unsigned int> numbers;
  for (unsigned int i = 0; i < scene.pairs.size(); ++i)
    {
      const scene::FacePair &pair   = scene.pairs[i];
      const World::Address  &master = world.elastic_address[pair.master],
                           &slave   = world.elastic_address[pair.slave];
      const BodyBatches &masters = world.copies[master.group], &slaves = world.copies[slave.group];
      owner_.push_back(slaves.owner_of(slave.copy));
      add_record(pair.master, pair.slave, pair.joint);

      const auto [entry, is_new] =
          numbers.emplace(key_of(pair, world), static_cast<unsigned int>(side_pairs_.size()));
      if (is_new)
        {
          side_pairs_.push_back({master.group,
                                 slave.group,
                                 pair.master_surface,
                                 pair.slave_surface,
                                 pair.master_axis,
                                 pair.slave_axis,
                                 {}});
          for (const double sign : {-1., 1.})
            {
              Faces      faces{facets_of(masters, pair.master_surface, pair.master_axis, sign),
                          facets_of(slaves, pair.slave_surface, pair.slave_axis, sign),
                          {}};
              const auto r = distances(*faces.slaves, slaves, pair.slave_axis);
              for (unsigned int n = 0; n < r.size(); ++n)
                if (r[n] <= scene.radius)
                  faces.taking_part.push_back(n);
              if (faces.masters->n_facets() > 0)
                side_pairs_.back().faces.push_back(std::move(faces));
            }
        }
      if (!slaves.owns(slave.copy))
        continue;
      const SidePair &sides = side_pairs_[entry->second];
      for (unsigned int f = 0; f < sides.faces.size(); ++f)
        {
          const Faces             &faces = sides.faces[f];
          std::vector<std::size_t> of_master, of_slave;
          for (const unsigned int n : faces.masters->nodes())
            of_master.push_back(masters.index(master.copy, n));
          for (const unsigned int s : faces.taking_part)
            of_slave.push_back(slaves.index(slave.copy, faces.slaves->nodes()[s]));
          FaceContact contact{i,
                              entry->second,
                              f,
                              {pair.master, master.group, *faces.masters, std::move(of_master)},
                              std::move(of_slave),
                              std::vector<Node>(faces.taking_part.size()),
                              {},
                              {},
                              {{masters.batch_of(master.copy), slaves.batch_of(slave.copy)}},
                              false};
          contacts_.push_back(std::move(contact));
        }
    }
  states_.resize(records_.size());
}

void NodeFaces::announce(World &world, const std::optional<double> dt)
{
  for (FaceContact &contact : contacts_)
    read(world, contact, reads_without_search(contact) || (dt && contact.cadence.is_due(*dt)));
}

void NodeFaces::read(World &world, FaceContact &contact, const bool reads)
{
  if (contact.reads == reads)
    return;
  contact.reads         = reads;
  const SidePair &sides = side_pairs_[contact.sides];
  const Faces    &faces = sides.faces[contact.face];
  const int       more  = reads ? 1 : -1;
  for (const auto &[group, batch, nodes] :
       {std::make_tuple(sides.master_group, contact.batches[0], &faces.masters->nodes()),
        std::make_tuple(sides.slave_group, contact.batches[1], &faces.slaves->nodes())})
    if (world.copies[group].counts_readers())
      world.copies[group].add_readers(batch, *nodes, more);
}

void NodeFaces::search_nodes(const World &world, FaceContact &contact)
{
  const BodyBatches &slaves = world.copies[side_pairs_[contact.sides].slave_group];
  const NodeValues   x{NodeView(slaves.position), contact.slaves},
      v{NodeView(slaves.velocity), contact.slaves};

  Surface::Projection       projection;
  std::vector<unsigned int> found;
  double                    nearest = std::numeric_limits<double>::max(), fastest = 0.;
  for (unsigned int s = 0; s < contact.nodes.size(); ++s)
    {
      Node       &node  = contact.nodes[s];
      const Touch touch = contact.surface.project(world, x(s), 0., reach, node.facet, projection);
      const bool  holds = node.touch.penetration > 0.; // its spring has to let go
      if (node.facet == MovingFacets::none)
        {
          if (holds)
            found.push_back(s);
          continue;
        }
      const dealii::Tensor<1, 3> relative =
          contact.surface.relative_velocity(world, x(s), projection, v(s), 0.);
      fastest = std::max(fastest, -(relative * touch.normal));
      if (touch.gap < 0. && contact.cadence.left_alone() &&
          !std::binary_search(contact.active.begin(), contact.active.end(), s))
        ++n_missed_;
      if (touch.gap < reach || holds)
        found.push_back(s);
      else
        nearest = std::min(nearest, touch.gap);
    }
  contact.active.swap(found);
  contact.cadence.restart(holding_time(std::min(nearest, 1.), fastest, unforeseen_speed(world)));
}

void NodeFaces::add_forces(World &world, const double dt)
{
  for (const FaceContact &contact : contacts_)
    {
      Record &record               = records_[contact.pair];
      record.gap                   = std::numeric_limits<double>::max();
      record.force                 = dealii::Tensor<1, 3>();
      states_[contact.pair].normal = 0.;
    }
  for (FaceContact &contact : contacts_)
    {
      if (every_step_ || contact.cadence.is_due(dt))
        {
          search_nodes(world, contact);
          read(world, contact, reads_without_search(contact));
        }
      else
        contact.cadence.use(dt);
      if (!contact.active.empty())
        add_face_forces(world, contact, dt);
    }
}

void NodeFaces::add_face_forces(World &world, FaceContact &contact, const double dt)
{
  const SidePair  &sides  = side_pairs_[contact.sides];
  const Faces     &faces  = sides.faces[contact.face];
  BodyBatches     &slaves = world.copies[sides.slave_group];
  const NodeValues x{NodeView(std::as_const(slaves.position)), contact.slaves},
      v{NodeView(std::as_const(slaves.velocity)), contact.slaves};
  const NodeView f(slaves.force);

  Record              &record = records_[contact.pair];
  Surface::Projection  projection;
  dealii::Tensor<1, 3> resultant, normals;
  double               normal_force = 0.;
  for (const unsigned int s : contact.active)
    {
      Node                      &node = contact.nodes[s];
      const dealii::Tensor<1, 3> at   = x(s);
      const Touch touch = contact.surface.project(world, at, 0., reach, node.facet, projection);
      const scene::ContactLaw law = law_.times(faces.slaves->areas()[faces.taking_part[s]]);
      if (node.facet == MovingFacets::none)
        {
          lose_contact(law, node.touch, world.ledger);
          continue;
        }
      record.gap = std::min(record.gap, touch.gap);
      if (touch.gap >= 0.)
        {
          separate(law, dt, node.touch, world.ledger);
          continue;
        }

      const dealii::Tensor<1, 3> relative =
          contact.surface.relative_velocity(world, at, projection, v(s), dt);
      const PointForce force =
          penalty_force(law,
                        touch,
                        relative,
                        contact.surface.slip_velocity(world, touch, projection, relative),
                        dt,
                        node.touch,
                        world.ledger);
      f.add(contact.slaves[s], force.total);
      slaves.press(contact.slaves[s]);
      contact.surface.add_opposite(world, at, touch, projection, force);
      resultant += force.total;
      normals += force.normal * touch.normal;
      normal_force += force.normal;
    }

  record.force += world.symmetry.whole_force(resultant);
  for (unsigned int d = 0; d < 3; ++d) // for the motion of the centres of mass
    {
      world.force.local_element(3 * record.slave + d) += resultant[d];
      world.force.local_element(3 * record.master + d) -= resultant[d];
    }
  states_[contact.pair].normal += normal_force;
  if (normal_force > 0.)
    record.normal = normals / normals.norm();
}

void NodeFaces::serialize_pair(const unsigned int i, const Archive &archive)
{
  Family::serialize_pair(i, archive);
  for (FaceContact &contact : contacts_)
    if (contact.pair == i)
      {
        const Archive part = archive / ("face " + std::to_string(contact.face));
        part.numbers("nodes", contact.nodes);
        part("active", contact.active);
        contact.cadence.serialize(part);
      }
}

std::vector<ClosedPair> NodeFaces::closed_pairs(const World &world) const
{
  std::vector<ClosedPair> pairs;
  for (const SidePair &sides : side_pairs_)
    {
      const BodyBatches &masters = world.copies[sides.master_group],
                        &slaves  = world.copies[sides.slave_group];
      ClosedPair pair;
      pair[0].group   = sides.master_group;
      pair[0].surface = sides.master_surface;
      pair[0].stiffness.resize(masters.n_nodes());
      pair[1].group   = sides.slave_group;
      pair[1].surface = sides.slave_surface;
      pair[1].stiffness.resize(slaves.n_nodes());
      pair[0].flat = pair[1].flat = true;
      const auto carry =
          [](ClosedSide &side, const BodyBatches &copies, const unsigned int node, const double k) {
            side.add_spring(node, k, copies.nodes.mass[node]);
          };
      for (const Faces &faces : sides.faces)
        {
          const auto of_slaves  = tributary_areas(*faces.slaves, slaves, sides.slave_axis),
                     of_masters = tributary_areas(*faces.masters, masters, sides.master_axis);
          TributaryArea largest;
          for (const unsigned int s : faces.taking_part)
            {
              largest.grow_to(of_slaves[s]);
              carry(pair[1],
                    slaves,
                    faces.slaves->nodes()[s],
                    law_.stiffness * faces.slaves->areas()[s]);
            }
          for (unsigned int i = 0; i < of_masters.size(); ++i)
            carry(pair[0],
                  masters,
                  faces.masters->nodes()[i],
                  law_.stiffness * carried_area(of_masters[i], largest));
        }
      pairs.push_back(std::move(pair));
    }
  return pairs;
}
} // namespace chaindrive::contact
