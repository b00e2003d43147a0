// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/world.h>
#include <chaindrive/scene/scene.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/ranks.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <utility>

namespace chaindrive
{
namespace
{
/// Angular momentum R I R^T w of a body with principal moments @p inertia.
dealii::Tensor<1, 3> angular_momentum(const Frame &frame, const dealii::Tensor<1, 3> &inertia)
{
  dealii::Tensor<1, 3> in_body = dealii::transpose(frame.rotation) * frame.angular_velocity;
  for (unsigned int d = 0; d < 3; ++d)
    in_body[d] *= inertia[d];
  return frame.rotation * in_body;
}

/// Batches of one group of copies, to be dealt out to the ranks.
struct Deal
{
  unsigned int n_batches;
  double       cost;  ///< of each
  bool         apart; ///< they touch few batches of other groups: any rank may have any of them
};

/// What a joint costs the owner of its bore, in elements: some 75 visits of a node, 37 ns each,
/// beside 16 ns (doc/performance.md).
constexpr double elements_per_joint = 170.;

/// Deals the batches of each group out to @p n_ranks ranks in turn: equal shares, and what does not
/// go up to those that have least so far, the last of them, since the first rank has results to
/// take care of. Batches that may be apart even out the load. Returns per group the first batch of
/// each rank, and the number of batches.
std::vector<std::vector<unsigned int>> deal(const std::vector<Deal> &groups,
                                            const unsigned int       n_ranks)
{
  std::vector<double>                    load(n_ranks, 0.);
  std::vector<std::vector<unsigned int>> result;
  for (const Deal &group : groups)
    {
      const unsigned int        share = group.apart ? 0 : group.n_batches / n_ranks;
      std::vector<unsigned int> count(n_ranks, share);
      for (double &l : load)
        l += share * group.cost;
      for (unsigned int i = n_ranks * share; i < group.n_batches; ++i)
        {
          const auto least = std::min_element(load.rbegin(), load.rend());
          *least += group.cost;
          ++count[load.rend() - least - 1];
        }
      std::vector<unsigned int> first = {0};
      for (const unsigned int n : count)
        first.push_back(first.back() + n);
      result.push_back(first);
    }
  return result;
}
} // namespace

World::World(const scene::Scene &scene, const MPI_Comm comm)
    : time(scene.start_time)
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
      else if (body.motion == scene::Motion::rigid)
        rotations.push_back(
            {b, orientation, angular_momentum(body.initial, body.inertia), body.inertia});
      else if (body.motion == scene::Motion::lumped && body.inertia[2] > 0.)
        spins.push_back({b, body.inertia[2], body.initial.angular_velocity[2]});
    }

  std::map<scene::Kind, std::vector<unsigned int>> elastic;
  for (unsigned int b = 0; b < n; ++b)
    if (scene.bodies[b].motion == scene::Motion::elastic)
      elastic[scene.bodies[b].kind].push_back(b);
  std::map<scene::Kind, unsigned int> n_joints; // at bores of elastic bodies
  for (const scene::BoreFamily &bores : scene.bores)
    for (const scene::BorePair &pair : bores.pairs)
      if (bores.elastic && scene.bodies[pair.master].motion == scene::Motion::elastic)
        ++n_joints[scene.bodies[pair.master].kind];
  std::vector<Deal> deals;
  for (const auto &[kind, bodies] : elastic)
    {
      const auto         sector    = scene.sectors.find(kind);
      const bool         is_rim    = sector != scene.sectors.end();
      const unsigned int n_batches = BodyBatches::n_batches_of(
          is_rim ? std::size_t(sector->second->n_sectors) : bodies.size());
      const auto &part = is_rim ? *sector->second->part : *scene.parts.at(kind);
      deals.push_back({n_batches,
                       part.mesh->n_active_cells() +
                           elements_per_joint * n_joints[kind] / double(bodies.size()),
                       is_rim});
    }
  const auto first_batches = deal(deals, n_ranks_);
  elastic_address.resize(n);
  for (const auto &[kind, bodies] : elastic)
    {
      const unsigned int group = static_cast<unsigned int>(copies.size());
      if (scene.sectors.count(kind) != 0)
        add_rim(scene, bodies.front(), first_batches[group]);
      else
        {
          copies.emplace_back(
              scene.parts.at(kind), bodies, scene.bodies, first_batches[group], comm_);
          for (unsigned int k = 0; k < bodies.size(); ++k)
            elastic_address[bodies[k]] = {group, k};
        }
    }
  node_address = elastic_address;
  add_followers(scene);
}

void World::add_rim(const scene::Scene              &scene,
                    const unsigned int               body,
                    const std::vector<unsigned int> &first_batch)
{
  Hub &hub =
      *std::find_if(hubs.begin(), hubs.end(), [body](const Hub &h) { return h.body == body; });
  const scene::Body &sprocket = scene.bodies[body];
  const auto        &sector   = scene.sectors.at(sprocket.kind);
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
}

const Rim *World::rim_of(const unsigned int body) const
{
  for (const Rim &rim : rims)
    if (rim.body == body)
      return &rim;
  return nullptr;
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
  before_ = ledger;
}

void World::sum_over_ranks()
{
  if (n_ranks_ == 1 && whole == 1.)
    return;
  // This rank's share of everything, one number after the other; frames of elastic bodies have one
  // share only, their owner's.
  const auto visit = [this](const auto &item) {
    item(alarm, 1.);
    for (Rim &rim : rims)
      for (unsigned int d = 0; d < 3; ++d)
        item(rim.momentum[d], whole);
    for (Vector *vector : {&force, &moment})
      for (double &value : *vector)
        item(value, whole);
    for (double &request : requests)
      item(request, 1.);
    for (double Ledger::*term : Ledger::added)
      {
        double increment = ledger.*term - before_.*term;
        item(increment, whole);
        ledger.*term = before_.*term + increment;
      }
    for (unsigned int body = 0; body < n_bodies(); ++body)
      if (elastic_address[body].group != Address::none)
        {
          Frame       &frame = frames[body];
          const double mine  = owns(body) ? 1. : 0.;
          for (unsigned int d = 0; d < 3; ++d)
            {
              item(frame.position[d], mine);
              item(frame.velocity[d], mine);
            }
        }
  };
  shared_.clear();
  visit([this](const double value, const double share) { shared_.push_back(share * value); });
  if (n_ranks_ > 1)
    {
      const int status = MPI_Allreduce(
          MPI_IN_PLACE, shared_.data(), int(shared_.size()), MPI_DOUBLE, MPI_SUM, comm_);
      AssertThrowMPI(status);
    }
  auto total = shared_.cbegin();
  visit([&total](double &value, double) { value = *total++; });

  for (unsigned int body = 0; body < n_bodies(); ++body)
    if (elastic_address[body].group != Address::none)
      for (unsigned int d = 0; d < 3; ++d)
        {
          displacement.local_element(3 * body + d) = frames[body].position[d] - origin[body][d];
          velocity.local_element(3 * body + d)     = frames[body].velocity[d];
        }
}

double World::kinetic_energy() const
{
  double energy = 0.;
  for (unsigned int b = 0; b < n_bodies(); ++b)
    if (inverse_mass[b] > 0.)
      energy += 0.5 * mass[b] * frames[b].velocity.norm_square();
  for (const Rotation &r : rotations)
    energy += 0.5 * (r.momentum * frames[r.body].angular_velocity);
  for (const Spin &spin : spins)
    energy += 0.5 * spin.inertia * spin.speed * spin.speed;
  for (const Hub &hub : hubs)
    if (!hub.prescribed)
      energy += 0.5 * hub.inertia * hub.speed * hub.speed;
  return energy;
}

void World::serialize(const Archive &archive)
{
  archive("time", time);
  archive("ledger", ledger);
  for (const auto &[name, vector] : {std::make_pair("displacement", &displacement),
                                     std::make_pair("velocity", &velocity),
                                     std::make_pair("force", &force),
                                     std::make_pair("moment", &moment)})
    archive.numbers(name, vector->begin(), vector->locally_owned_size());
  archive.numbers("frames", frames);
  archive.numbers("rotations", rotations);
  archive.numbers("spins", spins);
  archive.numbers("hubs", hubs);
  for (unsigned int g = 0; g < n_elastic_groups(); ++g)
    copies[g].serialize(archive / ("copies " + std::to_string(g)));
}

std::size_t World::memory_consumption() const
{
  return displacement.memory_consumption() * 4 + n_bodies() * (sizeof(Frame) + 5 * sizeof(double)) +
         rotations.size() * sizeof(Rotation) + spins.size() * sizeof(Spin) +
         hubs.size() * sizeof(Hub) +
         std::accumulate(copies.begin(), copies.end(), std::size_t(0), [](auto sum, const auto &c) {
           return sum + c.memory_consumption();
         });
}
} // namespace chaindrive
