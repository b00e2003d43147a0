// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/elastic_rim.h>
#include <chaindrive/bodies/followers.h>
#include <chaindrive/bodies/hubs.h>
#include <chaindrive/bodies/partition.h>
#include <chaindrive/bodies/reduced_bodies.h>
#include <chaindrive/bodies/rigid_bodies.h>
#include <chaindrive/bodies/world.h>
#include <chaindrive/mesh/surface/surface_nodes.h>
#include <chaindrive/scene/scene.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/ranks.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>

namespace chaindrive
{
namespace
{
/// The @p bodies in such an order that the copies of a batch are neighbours along the chain: they
/// touch others at about the same nodes. Neighbours are dealt out to @p n_in_turn batches in turn:
/// two of rollers then belong to one of links, with the first and with the second bush.
std::vector<unsigned int> neighbours_in_batches(const std::vector<unsigned int> &bodies,
                                                const unsigned int               n_in_turn)
{
  const unsigned int        n_batches = BodyBatches::n_batches_of(bodies.size());
  std::vector<unsigned int> copies(bodies.size());
  auto                      next = bodies.begin();
  for (unsigned int first = 0; first < n_batches; first += n_in_turn)
    for (unsigned int lane = 0; lane < n_lanes; ++lane)
      for (unsigned int batch = first; batch < std::min(first + n_in_turn, n_batches); ++batch)
        if (const unsigned int copy = lane * n_batches + batch; copy < copies.size())
          copies[copy] = *next++;
  return copies;
}
/// Angular momentum R I R^T w of a body with principal moments @p inertia.
dealii::Tensor<1, 3> angular_momentum(const Frame &frame, const dealii::Tensor<1, 3> &inertia)
{
  dealii::Tensor<1, 3> in_body = dealii::transpose(frame.rotation) * frame.angular_velocity;
  for (unsigned int d = 0; d < 3; ++d)
    in_body[d] *= inertia[d];
  return frame.rotation * in_body;
}
} // namespace

World::World(const scene::Scene &scene, const MPI_Comm comm)
    : node_exchange(comm)
    , time(scene.start_time)
    , whole(scene.half ? 2. : 1.)
    , comm_(comm)
    , rank_(rank_in(comm))
    , n_ranks_(n_ranks_in(comm))
{
  const unsigned int     n     = static_cast<unsigned int>(scene.bodies.size());
  const dealii::IndexSet owned = dealii::complete_index_set(3 * n);
  for (Vector *vector : {&displacement, &velocity, &force, &moment})
    vector->reinit(owned, MPI_COMM_SELF);

  frames.reserve(n);
  for (unsigned int b = 0; b < n; ++b)
    {
      const scene::Body &body = scene.bodies[b];
      frames.push_back(body.initial);
      origin.push_back(body.initial.position);
      mass.push_back(body.mass);
      const bool free =
          body.support == scene::Support::none && body.motion != scene::Motion::elastic;
      inverse_mass.push_back(free ? 1. / body.mass : 0.);
      for (unsigned int d = 0; d < 3; ++d)
        velocity.local_element(3 * b + d) = free ? body.initial.velocity[d] : 0.;

      const Quaternion orientation = to_quaternion(body.initial.rotation);
      if (body.support != scene::Support::none)
        hubs.push_back({b,
                        body.support == scene::Support::prescribed_hub,
                        body.inertia[2],
                        0.,
                        body.initial.angular_velocity[2],
                        2. * std::atan2(orientation.z, orientation.w)});
      else if (body.motion == scene::Motion::rigid || body.motion == scene::Motion::reduced)
        rotations.push_back(
            {b, orientation, angular_momentum(body.initial, body.inertia), body.inertia});
      else if (body.motion == scene::Motion::lumped && body.inertia[2] > 0.)
        spins.push_back({b, body.inertia[2], body.initial.angular_velocity[2]});
    }

  groups.add(std::make_unique<RigidBodies>());
  groups.add(std::make_unique<Hubs>());
  elastic_address.resize(n);
  const Deals deals = partition(scene, n_ranks_);
  add_elastic_bodies(scene, deals);
  add_reduced_bodies(scene, deals);
  node_address = elastic_address;
  add_followers(scene);
}

World::~World() = default;

std::map<scene::PartOf, std::vector<unsigned int>>
World::bodies_that_move(const scene::Scene &scene, const scene::Motion motion)
{
  std::map<scene::PartOf, std::vector<unsigned int>> found;
  for (unsigned int b = 0; b < scene.bodies.size(); ++b)
    if (scene.bodies[b].motion == motion)
      found[scene.bodies[b].part()].push_back(b);
  return found;
}

unsigned int World::add_copies(const scene::Scene              &scene,
                               const scene::PartOf             &of,
                               const std::vector<unsigned int> &bodies,
                               const std::vector<unsigned int> &first_batch)
{
  const unsigned int group = static_cast<unsigned int>(copies.size());
  copies.emplace_back(scene.parts.at(of), bodies, scene.bodies, first_batch, comm_);
  for (unsigned int k = 0; k < bodies.size(); ++k)
    elastic_address[bodies[k]] = {group, k};
  return group;
}

void World::add_elastic_bodies(const scene::Scene &scene, const Deals &deals)
{
  constexpr scene::Motion elastic = scene::Motion::elastic;
  for (const auto &[of, bodies] : bodies_that_move(scene, elastic))
    {
      const std::vector<unsigned int> &first_batch = deals.at({elastic, of});
      if (scene.sectors.count(of) != 0)
        {
          add_rim(scene, bodies.front(), first_batch);
          continue;
        }
      const unsigned int group = add_copies(scene, of, bodies, first_batch);
      if (!scene.plates_bend)
        copies.back().stop_plate_bending();
      groups.add(std::make_unique<ElasticBodies>(scene, *this, group));
    }
}

void World::add_reduced_bodies(const scene::Scene &scene, const Deals &deals)
{
  constexpr scene::Motion reduced = scene::Motion::reduced;
  for (const auto &[of, bodies] : bodies_that_move(scene, reduced))
    {
      const unsigned int group =
          add_copies(scene,
                     of,
                     neighbours_in_batches(bodies, of.kind == scene::Kind::roller ? 2 : 1),
                     deals.at({reduced, of}));
      copies.back().count_readers();
      groups.add(std::make_unique<ReducedBodies>(scene, *this, group));
    }
}

void World::add_rim(const scene::Scene              &scene,
                    const unsigned int               body,
                    const std::vector<unsigned int> &first_batch)
{
  Hub &hub =
      *std::find_if(hubs.begin(), hubs.end(), [body](const Hub &h) { return h.body == body; });
  const scene::Body &sprocket = scene.bodies[body];
  const auto        &sector   = scene.sectors.at(sprocket.part());
  std::vector<Frame> start;
  for (unsigned int s = 0; s < sector->n_sectors; ++s)
    start.push_back(sector->frame(sprocket.initial, s));
  copies.emplace_back(
      sector->part, std::vector<unsigned int>(start.size(), body), start, first_batch, comm_);
  rims.emplace_back(body, static_cast<unsigned int>(copies.size()) - 1, sector, copies.back());

  // with less inertia than the nodes that it holds a hub could be faster than the elements are
  const Rim &rim = rims.back();
  hub.inertia -= whole * rim.inertia;
  if (!hub.prescribed && hub.inertia < whole * rim.border_inertia)
    throw InputError("Model/Driven inertia in kg m2 = " + to_text(sprocket.inertia[2]) +
                     " is less than that of the elastic rim of the sprocket alone, " +
                     to_text(whole * (rim.inertia + rim.border_inertia)) +
                     "; choose a greater value, auto, or Model/Elastic sprockets = off.");
  groups.add(
      std::make_unique<ElasticRim>(scene, *this, static_cast<unsigned int>(rims.size()) - 1));
}

void World::add_followers(const scene::Scene &scene)
{
  // the sides of rigid bodies that touch with their nodes
  std::map<scene::PartOf, std::map<unsigned int, std::set<unsigned int>>> sides;
  for (const scene::BoreFamily &bores : scene.bores)
    if (bores.elastic)
      for (const scene::BorePair &pair : bores.pairs)
        for (const auto &[body, side] : {std::make_pair(pair.master, pair.master_surface),
                                         std::make_pair(pair.slave.body, pair.slave_surface)})
          if (elastic_address[body].group == Address::none)
            sides[scene.bodies[body].part()][body].insert(side);

  for (const auto &[of, of_bodies] : sides)
    {
      const unsigned int        group = static_cast<unsigned int>(copies.size());
      std::vector<unsigned int> bodies;
      for (const auto &entry : of_bodies)
        {
          node_address[entry.first] = {group, static_cast<unsigned int>(bodies.size())};
          bodies.push_back(entry.first);
        }
      // the first rank owns them
      std::vector<unsigned int> first_batch(n_ranks_ + 1, BodyBatches::n_batches_of(bodies.size()));
      first_batch.front() = 0;
      copies.emplace_back(scene.parts.at(of), bodies, scene.bodies, first_batch, comm_);

      std::vector<Followers::Side> followers;
      for (const auto &[body, surfaces] : of_bodies)
        for (const unsigned int surface : surfaces)
          followers.push_back({body,
                               node_address[body].copy,
                               mesh::SurfaceNodes(*copies.back().part,
                                                  copies.back().nodes,
                                                  static_cast<mesh::Surface>(surface))
                                   .node});
      groups.add(std::make_unique<Followers>(group, std::move(followers)));
    }
}

const Rim *World::rim_of(const unsigned int body) const
{
  for (const Rim &rim : rims)
    if (rim.body == body)
      return &rim;
  return nullptr;
}

void World::place_surfaces(const double earlier)
{
  for (SurfaceGroup *group : groups.surface())
    group->place_surface(*this, earlier);
}

void World::gather_forces()
{
  for (SurfaceGroup *group : groups.surface())
    group->gather_forces(*this);
}

void World::clear_forces()
{
  clear_resultants();
  for (BodyBatches &c : copies)
    c.force = 0.;
}

void World::clear_resultants()
{
  force  = 0.;
  moment = 0.;
  for (Rim &rim : rims)
    rim.momentum = dealii::Tensor<1, 3>();
  ledger.clear_stored();
  before_        = ledger;
  losses_before_ = losses;
}

void World::sum_over_ranks()
{
  if (n_ranks_ == 1 && whole == 1.)
    return;
  std::vector<double> booked; // since clear_resultants()
  for (double Ledger::*term : Ledger::added)
    booked.push_back(ledger.*term - before_.*term);
  for (std::size_t i = 0; i < losses.size(); ++i)
    for (double Loss::*term : {&Loss::friction, &Loss::damping})
      booked.push_back(losses[i].*term - losses_before_[i].*term);

  // Visits all numbers to be summed, so many at a time, and with which share they count; frames of
  // bodies that move by nodes have one share only, their owner's.
  const auto visit = [&](const auto &numbers) {
    numbers(&alarm, 1, 1.);
    for (Rim &rim : rims)
      numbers(rim.momentum.begin_raw(), 3, whole);
    for (Vector *vector : {&force, &moment})
      numbers(vector->begin(), vector->locally_owned_size(), whole);
    for (ModalGroup *group : groups.modal())
      for (const dealii::ArrayView<double> &forces : group->shared_forces(*this))
        numbers(forces.data(), forces.size(), 1.);
    numbers(requests.data(), requests.size(), 1.);
    numbers(booked.data(), booked.size(), whole);
    for (unsigned int body = 0; body < n_bodies(); ++body)
      if (moves_by_nodes(body))
        for (dealii::Tensor<1, 3> *vector : {&frames[body].position, &frames[body].velocity})
          numbers(vector->begin_raw(), 3, owns(body) ? 1. : 0.);
  };
  shared_.clear();
  visit([this](const double *first, const std::size_t n, const double share) {
    const std::size_t before = shared_.size();
    shared_.resize(before + n);
    for (std::size_t i = 0; i < n; ++i)
      shared_[before + i] = share * first[i];
  });
  if (n_ranks_ > 1)
    {
      const int status = MPI_Allreduce(
          MPI_IN_PLACE, shared_.data(), int(shared_.size()), MPI_DOUBLE, MPI_SUM, comm_);
      AssertThrowMPI(status);
    }
  auto total = shared_.cbegin();
  visit([&total](double *first, const std::size_t n, double) {
    std::copy_n(total, n, first);
    total += n;
  });

  auto increment = booked.cbegin();
  for (double Ledger::*term : Ledger::added)
    ledger.*term = before_.*term + *increment++;
  for (std::size_t i = 0; i < losses.size(); ++i)
    for (double Loss::*term : {&Loss::friction, &Loss::damping})
      losses[i].*term = losses_before_[i].*term + *increment++;

  if (whole != 1.) // what the other halves add cancels across the middle plane
    for (unsigned int body = 0; body < n_bodies(); ++body)
      force.local_element(3 * body + 2)      = moment.local_element(3 * body) =
          moment.local_element(3 * body + 1) = 0.;

  for (unsigned int body = 0; body < n_bodies(); ++body)
    if (moves_by_nodes(body))
      for (unsigned int d = 0; d < 3; ++d)
        {
          displacement.local_element(3 * body + d) = frames[body].position[d] - origin[body][d];
          velocity.local_element(3 * body + d)     = frames[body].velocity[d];
        }
}

double World::kinetic_energy() const
{
  double energy = 0.;
  for (const auto &group : groups.all())
    energy += group->kinetic_energy(*this);
  return energy;
}

void World::serialize(const Archive &archive)
{
  archive("time", time);
  archive("ledger", ledger);
  archive.numbers("losses", losses);
  for (const auto &[name, vector] : {std::make_pair("displacement", &displacement),
                                     std::make_pair("velocity", &velocity),
                                     std::make_pair("force", &force),
                                     std::make_pair("moment", &moment)})
    archive.numbers(name, vector->begin(), vector->locally_owned_size());
  archive.numbers("frames", frames);
  archive.numbers("rotations", rotations);
  archive.numbers("spins", spins);
  archive.numbers("hubs", hubs);
  for (unsigned int g = 0; g < groups.all().size(); ++g)
    groups.all()[g]->serialize(archive / ("group " + std::to_string(g)), *this);
}

std::size_t World::memory_consumption() const
{
  return displacement.memory_consumption() * 4 + n_bodies() * (sizeof(Frame) + 5 * sizeof(double)) +
         rotations.size() * sizeof(Rotation) + spins.size() * sizeof(Spin) +
         hubs.size() * sizeof(Hub) +
         std::accumulate(copies.begin(),
                         copies.end(),
                         std::size_t(0),
                         [](auto sum, const auto &c) { return sum + c.memory_consumption(); }) +
         std::accumulate(groups.all().begin(),
                         groups.all().end(),
                         std::size_t(0),
                         [](auto sum, const auto &g) { return sum + g->memory_consumption(); });
}
} // namespace chaindrive
