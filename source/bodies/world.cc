// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/teeth_in_motion.h>
#include <chaindrive/bodies/world.h>
#include <chaindrive/scene/scene.h>
#include <chaindrive/utilities/message_tags.h>
#include <chaindrive/utilities/ranks.h>
#include <chaindrive/utilities/timing.h>

#include <algorithm>
#include <cmath>
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
} // namespace

namespace
{
/// What turns about an axis, at the start. Its inertia about the axis is that about the parallel
/// axis through its centre of mass, and m a^2 of the arm a (Steiner).
World::Hub make_hub(const unsigned int b, const scene::Body &body, const Quaternion &orientation)
{
  const scene::Mount &mount = body.mount;
  const Frame        &start = body.initial;
  World::Hub          hub{};
  hub.body       = b;
  hub.slides     = mount.kind == scene::Mount::Kind::prismatic;
  hub.prescribed = mount.kind != scene::Mount::Kind::revolute && !hub.slides;
  hub.axis       = mount.axis;
  hub.start      = orientation;
  hub.speed   = mount.kind == scene::Mount::Kind::fixed ? 0. : start.angular_velocity * mount.axis;
  hub.inertia = hub.slides ? body.mass : body.inertia[2];
  if (hub.slides)
    hub.speed = start.velocity * mount.axis;
  else if (hub.about_z())
    hub.start_angle = 2. * std::atan2(orientation.z, orientation.w);
  else
    {
      const dealii::Tensor<1, 3> axis = transpose(start.rotation) * hub.axis;
      hub.inertia                     = 0.;
      for (unsigned int d = 0; d < 3; ++d)
        hub.inertia += axis[d] * axis[d] * body.inertia[d];
    }
  if (mount.pivot)
    {
      hub.arm = start.position - *mount.pivot;
      hub.arm -= (hub.arm * hub.axis) * hub.axis;
      hub.inertia += body.mass * hub.arm.norm_square();
    }
  return hub;
}
} // namespace

World::World(const scene::Scene &scene, const MPI_Comm comm)
    : node_exchange(comm)
    , time(scene.start_time)
    , symmetry(scene.half)
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
      const bool free = body.mount.is_free() && body.motion != scene::Motion::elastic;
      inverse_mass.push_back(free ? 1. / body.mass : 0.);
      for (unsigned int d = 0; d < 3; ++d)
        velocity.local_element(3 * b + d) = free ? body.initial.velocity[d] : 0.;

      const Quaternion orientation = to_quaternion(body.initial.rotation);
      if (!body.mount.is_free())
        {
          hubs.push_back(make_hub(b, body, orientation));
          if (body.mount.carrier)
            carried.push_back({b, *body.mount.carrier, hubs.back().slides});
        }
      else if (body.motion == scene::Motion::rigid || body.motion == scene::Motion::reduced)
        rotations.push_back(
            {b, orientation, angular_momentum(body.initial, body.inertia), body.inertia});
      else if (body.motion == scene::Motion::lumped && body.inertia[2] > 0.)
        spins.push_back({b, body.inertia[2], body.initial.angular_velocity[2]});
      else if (body.turns_with)
        tied.push_back({b, (*body.turns_with)[0], (*body.turns_with)[1]});
    }

  const auto depth = [&scene](unsigned int b) {
    unsigned int carriers = 0;
    for (; scene.bodies[b].mount.carrier; b = *scene.bodies[b].mount.carrier)
      ++carriers;
    return carriers;
  };
  std::stable_sort(carried.begin(), carried.end(), [&](const Carried &a, const Carried &b) {
    return depth(a.body) < depth(b.body);
  });

  elastic_address.resize(n);
  node_address.resize(n);
}

void World::place(const Hub &hub)
{
  Frame &frame = frames[hub.body];
  if (hub.slides)
    {
      frame.position = origin[hub.body] + hub.angle * hub.axis;
      frame.velocity = hub.speed * hub.axis;
      return;
    }
  frame.angular_velocity = hub.speed * hub.axis;
  if (hub.about_z())
    frame.rotation = to_matrix(rotation_about_z(hub.start_angle + hub.angle));
  else
    frame.rotation = to_matrix(rotation_by(hub.angle * hub.axis) * hub.start);
  if (hub.arm.norm_square() == 0.)
    return;
  const dealii::Tensor<1, 3> arm = to_matrix(rotation_by(hub.angle * hub.axis)) * hub.arm;
  frame.position                 = pivot_of(hub) + arm;
  frame.velocity                 = cross_product_3d(frame.angular_velocity, arm);
}

void World::add_carried(const unsigned int carrier, dealii::Tensor<1, 3> &force_on) const
{
  for (const Carried &c : carried)
    if (c.carrier == carrier)
      {
        for (unsigned int d = 0; d < 3; ++d)
          force_on[d] += force.local_element(3 * c.body + d);
        add_carried(c.body, force_on);
      }
}

double World::moment_about(const Hub &hub) const
{
  dealii::Tensor<1, 3> moment_on, force_on;
  for (unsigned int d = 0; d < 3; ++d)
    {
      moment_on[d] = moment.local_element(3 * hub.body + d);
      force_on[d]  = force.local_element(3 * hub.body + d);
    }
  if (hub.about_z() && hub.arm.norm_square() == 0.)
    return moment_on[2];
  add_carried(hub.body, force_on);
  if (hub.slides)
    return hub.axis * force_on;
  return hub.axis *
         (moment_on + cross_product_3d(frames[hub.body].position - pivot_of(hub), force_on));
}

const Rim *World::rim_of(const unsigned int body) const
{
  for (const Rim &rim : rims)
    if (rim.body == body)
      return &rim;
  return nullptr;
}

TeethInMotion *World::teeth_of(const unsigned int body)
{
  for (TeethInMotion *of_body : teeth)
    if (of_body->body() == body)
      return of_body;
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
  if (planar != nullptr)
    planar->clear_forces();
  if (planar != nullptr && !planar->others_act())
    {
      for (const Hub &hub : hubs) // nothing else is acted on here
        for (Vector *vector : {&force, &moment})
          std::fill_n(vector->begin() + 3 * hub.body, 3, 0.);
    }
  else
    {
      // not by the vectors' own assignment, which starts a loop over threads
      std::fill_n(force.begin(), force.locally_owned_size(), 0.);
      std::fill_n(moment.begin(), moment.locally_owned_size(), 0.);
    }
  for (Rim &rim : rims)
    rim.momentum = dealii::Tensor<1, 3>();
  ledger.clear_stored();
  before_ = ledger;
}

void World::sum_over_ranks(const std::initializer_list<Summands> others)
{
  if (planar != nullptr && planar->others_act())
    planar->complete_forces(*this);
  if (n_ranks_ == 1 && !symmetry.is_active())
    return;
  std::vector<double> booked; // since clear_resultants()
  for (double Ledger::*term : Ledger::added)
    booked.push_back(ledger.*term - before_.*term);

  // Visits all numbers to be summed, so many at a time, and with which share they count; frames of
  // nodal bodies have one share only, their owner's.
  const double whole = symmetry.multiplicity();
  const auto   visit = [&](const auto &numbers) {
    for (Rim &rim : rims)
      numbers(rim.momentum.begin_raw(), 3, whole);
    for (Vector *vector : {&force, &moment})
      numbers(vector->begin(), vector->locally_owned_size(), whole);
    if (planar != nullptr && planar->oval())
      numbers(planar->forces_on_ovals().data(), planar->forces_on_ovals().size(), 1.);
    for (SharedGroup *group : groups.shared())
      for (const dealii::ArrayView<double> &forces : group->shared_forces(*this))
        numbers(forces.data(), forces.size(), 1.);
    for (const Summands &other : others)
      numbers(other.numbers.data(), other.numbers.size(), other.of_bodies ? whole : 1.);
    numbers(booked.data(), booked.size(), whole);
    for (unsigned int body = 0; body < n_bodies(); ++body)
      if (is_nodal(body))
        for (dealii::Tensor<1, 3> *vector : {&frames[body].position, &frames[body].velocity})
          numbers(vector->begin_raw(), 3, owns(body) ? 1. : 0.);
    for (const unsigned int body : turning)
      {
        const double share = owns(body) ? 1. : 0.;
        numbers(frames[body].rotation.begin_raw(), 9, share);
        numbers(frames[body].angular_velocity.begin_raw(), 3, share);
      }
  };
  shared_.clear();
  visit([this](const double *first, const std::size_t n, const double share) {
    const std::size_t before = shared_.size();
    shared_.resize(before + n);
    for (std::size_t i = 0; i < n; ++i)
      shared_[before + i] = share * first[i];
  });
  if (n_ranks_ == 2)
    {
      // One exchange; MPI's own sum makes two of messages as long as this one.
      const std::size_t n     = shared_.size();
      const int         other = rank_ == 0 ? 1 : 0;
      shared_.resize(2 * n);
      {
        const Waiting waiting;
        const int     status = MPI_Sendrecv(shared_.data(),
                                        int(n),
                                        MPI_DOUBLE,
                                        other,
                                        tag_sum,
                                        shared_.data() + n,
                                        int(n),
                                        MPI_DOUBLE,
                                        other,
                                        tag_sum,
                                        comm_,
                                        MPI_STATUS_IGNORE);
        AssertThrowMPI(status);
      }
      for (std::size_t i = 0; i < n; ++i)
        shared_[i] += shared_[n + i];
    }
  else if (n_ranks_ > 2)
    {
      const Waiting waiting;
      const int     status = MPI_Allreduce(
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

  for (unsigned int body = 0; body < n_bodies(); ++body)
    {
      symmetry.cancel_across(force.begin() + 3 * body);
      symmetry.cancel_tilting(moment.begin() + 3 * body);
    }

  if (planar != nullptr)
    planar->take_forces(*this);

  for (unsigned int body = 0; body < n_bodies(); ++body)
    if (is_nodal(body))
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
  for (const auto &[name, vector] : {std::make_pair("displacement", &displacement),
                                     std::make_pair("velocity", &velocity),
                                     std::make_pair("force", &force),
                                     std::make_pair("moment", &moment)})
    archive.numbers(name, vector->begin(), vector->locally_owned_size());
  archive.numbers("frames", frames);
  // A settled start is found anew by a run that goes on, and differs by what round-off has become
  // in it: on another number of ranks bodies would all be elsewhere.
  archive.numbers("origins", origin);
  archive.numbers("rotations", rotations);
  archive.numbers("spins", spins);
  archive.numbers("hubs", hubs);
  for (std::size_t g = 0; g < groups.all().size(); ++g)
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

dealii::Tensor<1, 3> World::position_of(const unsigned int      body,
                                        const dealii::Point<3> &local) const
{
  if (planar == nullptr || planar->slot_of(body) == PlanarBodies::none)
    return frames[body].position + frames[body].rotation * dealii::Tensor<1, 3>(local);
  const unsigned int         slot = planar->slot_of(body);
  const dealii::Tensor<1, 2> turn = planar->rotation(slot);
  dealii::Tensor<1, 3>       at   = position_of(body);
  at[0] += turn[0] * local[0] - turn[1] * local[1];
  at[1] += turn[1] * local[0] + turn[0] * local[1];
  at[2] += local[2];
  return at;
}

dealii::Tensor<1, 3> World::velocity_of(const unsigned int      body,
                                        const dealii::Point<3> &local) const
{
  const dealii::Tensor<1, 3> arm = position_of(body, local) - position_of(body);
  if (planar == nullptr || planar->slot_of(body) == PlanarBodies::none)
    return frames[body].velocity + cross_product_3d(frames[body].angular_velocity, arm);
  const double         spin = planar->spin(planar->slot_of(body));
  dealii::Tensor<1, 3> v    = velocity_of(body);
  v[0] -= spin * arm[1];
  v[1] += spin * arm[0];
  return v;
}
} // namespace chaindrive
