// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/scene/scene.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>
#include <chaindrive/world/world.h>

#include <cmath>
#include <map>
#include <numeric>

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

World::World(const scene::Scene &scene) : time(scene.start_time)
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
    }

  std::map<scene::Kind, std::vector<unsigned int>> elastic;
  for (unsigned int b = 0; b < n; ++b)
    if (scene.bodies[b].motion == scene::Motion::elastic &&
        scene.bodies[b].support == scene::Support::none)
      elastic[scene.bodies[b].kind].push_back(b);
  for (const auto &[kind, bodies] : elastic)
    copies.emplace_back(scene.parts.at(kind), bodies, scene.bodies);
  places.resize(n);
  for (unsigned int g = 0; g < copies.size(); ++g)
    for (unsigned int k = 0; k < copies[g].n_copies(); ++k)
      places[copies[g].bodies[k]] = {g, k};

  for (unsigned int h = 0; h < hubs.size(); ++h)
    if (scene.bodies[hubs[h].body].motion == scene::Motion::elastic)
      add_rim(scene, h);
}

void World::add_rim(const scene::Scene &scene, const unsigned int h)
{
  Hub               &hub    = hubs[h];
  const scene::Body &body   = scene.bodies[hub.body];
  const auto        &sector = scene.sectors.at(body.kind);
  std::vector<Frame> start;
  for (unsigned int s = 0; s < sector->n_sectors; ++s)
    start.push_back(sector->frame(body.initial, s));
  copies.emplace_back(sector->part, std::vector<unsigned int>(start.size(), hub.body), start);
  rims.emplace_back(
      hub.body, h, static_cast<unsigned int>(copies.size()) - 1, sector, copies.back());

  // with less inertia than the nodes that it holds a hub could be faster than the elements are
  const Rim &rim = rims.back();
  hub.inertia -= rim.inertia;
  if (!hub.prescribed && hub.inertia < rim.border_inertia)
    throw InputError("Model/Driven inertia in kg m2 = " + to_text(body.inertia[2]) +
                     " is less than that of the elastic rim of the sprocket alone, " +
                     to_text(rim.inertia + rim.border_inertia) +
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
  force  = 0.;
  moment = 0.;
  for (Copies &c : copies)
    c.force = 0.;
}

double World::kinetic_energy() const
{
  double energy = 0.;
  for (unsigned int b = 0; b < n_bodies(); ++b)
    if (inverse_mass[b] > 0.)
      energy += 0.5 * mass[b] * frames[b].velocity.norm_square();
  for (const Rotation &r : rotations)
    energy += 0.5 * (r.momentum * frames[r.body].angular_velocity);
  for (const Hub &hub : hubs)
    if (!hub.prescribed)
      energy += 0.5 * hub.inertia * hub.speed * hub.speed;
  return energy;
}

std::size_t World::memory_consumption() const
{
  return displacement.memory_consumption() * 4 + n_bodies() * (sizeof(Frame) + 5 * sizeof(double)) +
         rotations.size() * sizeof(Rotation) + hubs.size() * sizeof(Hub) +
         std::accumulate(copies.begin(), copies.end(), std::size_t(0), [](auto sum, const auto &c) {
           return sum + c.memory_consumption();
         });
}
} // namespace chaindrive
