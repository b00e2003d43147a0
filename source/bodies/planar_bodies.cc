// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/planar_bodies.h>
#include <chaindrive/bodies/world.h>
#include <chaindrive/scene/scene.h>
#include <chaindrive/utilities/simd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace chaindrive
{
namespace
{
/// The order of slots: rows of bodies of one kind by number, rollers in two rows where there are
/// links.
std::array<unsigned int, 3> place_in_order(const scene::Body &body, const bool two_rows)
{
  const bool         in_rows = two_rows && body.kind == scene::Kind::roller;
  const unsigned int row     = in_rows ? body.number % 2 : 0;
  return {{static_cast<unsigned int>(body.kind), row, body.number}};
}

bool stays_in_plane(const scene::Body &body)
{
  const Frame &frame = body.initial;
  return frame.velocity[2] == 0. && frame.angular_velocity[0] == 0. &&
         frame.angular_velocity[1] == 0. && frame.rotation[2][2] == 1.;
}
} // namespace

PlanarBodies::PlanarBodies(const scene::Scene &scene, const World &world)
    : kernels_(*planar_kernels(simd_width())), slot_of_(world.n_bodies(), none), oval_(scene.oval)
{
  const bool two_rows =
      std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const scene::Body &body) {
        return body.kind == scene::Kind::inner_link;
      });
  for (unsigned int b = 0; b < world.n_bodies(); ++b)
    if (world.inverse_mass[b] > 0.)
      {
        if (!stays_in_plane(scene.bodies[b]))
          throw std::logic_error("PlanarBodies: a body leaves the plane");
        bodies_.push_back(b);
      }
  std::stable_sort(bodies_.begin(), bodies_.end(), [&](const unsigned int a, const unsigned int b) {
    return place_in_order(scene.bodies[a], two_rows) < place_in_order(scene.bodies[b], two_rows);
  });
  unsigned int                n_taken = 0;
  std::array<unsigned int, 3> last{};
  for (const unsigned int b : bodies_)
    {
      const std::array<unsigned int, 3> place = place_in_order(scene.bodies[b], two_rows);
      if (place[0] != last[0] || place[1] != last[1]) // rows begin where memory is aligned
        n_taken = n_computed_of(n_taken);
      slot_of_[b] = n_taken++;
      last        = place;
    }
  // a run of pairs is read to a multiple of n_lanes, wherever it begins
  n_slots_ = n_computed_of(n_taken) + n_lanes;
  state_.resize((oval_ ? n_planar_entries_of_ovals : n_planar_entries) * n_slots_, 0.);

  for (const unsigned int b : bodies_)
    {
      const unsigned int i     = slot_of_[b];
      const Frame       &frame = world.frames[b];
      for (unsigned int d = 0; d < 2; ++d)
        {
          of(planar_origin + d)[i]   = world.origin[b][d];
          of(planar_position + d)[i] = world.origin[b][d];
          of(planar_velocity + d)[i] = frame.velocity[d];
          of(planar_rotation + d)[i] = frame.rotation[d][0];
        }
      of(planar_inverse_mass)[i] = world.inverse_mass[b];
      of(planar_mass)[i]         = world.mass[b];
    }
  if (oval_)
    for (const unsigned int b : bodies_)
      if (scene.bodies[b].kind == scene::Kind::roller)
        {
          of(planar_ring_inverse_mass)[slot_of_[b]] = 1. / oval_->mass;
          of(planar_ring_mass)[slot_of_[b]]         = oval_->mass;
          of(planar_ring_stiffness)[slot_of_[b]]    = oval_->stiffness;
        }
  const auto turns = [this](const unsigned int body, const double inertia, const double spin) {
    const unsigned int i          = slot_of_[body];
    of(planar_inertia)[i]         = inertia;
    of(planar_inverse_inertia)[i] = 1. / inertia;
    of(planar_spin)[i]            = spin;
  };
  for (const World::Rotation &rotation : world.rotations)
    {
      turns(rotation.body, rotation.inertia[2], world.frames[rotation.body].angular_velocity[2]);
      of(planar_follows_rotation)[slot_of_[rotation.body]] = 1.;
    }
  for (const World::Spin &spin : world.spins)
    turns(spin.body, spin.inertia, spin.speed);
}

void PlanarBodies::kick(World & /*world*/, const double h)
{
  kinetic_energy_.reset();
  if (others_act_)
    kernels_.kick(slots(), h);
  else if (has_moved_)
    kinetic_energy_ = kernels_.kick(slots(), h);
  else
    waits_ += h;
  has_moved_ = false;
  if (oval_)
    kernels_.kick_ovals(slots(), h);
}

void PlanarBodies::drift(World &world, const Step &step)
{
  PlanarLoads loads{0., 0., 0., 0.};
  if (world.is_first_rank()) // which does so for all
    {
      loads.gravity = step.gravity;
      loads.drag    = step.drag;
    }
  fastest_square_ = kernels_.advance(slots(), waits_, step.dt, loads);
  loads_          = loads;
  begun_          = true;
  has_moved_      = true;
  waits_          = 0.;
  kinetic_energy_.reset();
  travelled_ += step.dt * std::sqrt(fastest_square_);
  if (oval_)
    kernels_.drift_ovals(slots(), step.dt);
}

void PlanarBodies::finish(World & /*world*/, const Step & /*step*/) { is_behind_ = true; }

void PlanarBodies::update(World &world)
{
  if (!is_behind_)
    return;
  is_behind_ = false;
  publish(world);
  if (!others_act_)
    write_forces(world);
  double *u = world.displacement.begin(), *v = world.velocity.begin();
  for (const unsigned int b : bodies_)
    for (unsigned int d = 0; d < 2; ++d)
      {
        u[3 * b + d] = of(planar_displacement + d)[slot_of_[b]];
        v[3 * b + d] = of(planar_velocity + d)[slot_of_[b]];
      }
  for (World::Rotation &rotation : world.rotations)
    rotation.momentum[2] =
        of(planar_inertia)[slot_of_[rotation.body]] * of(planar_spin)[slot_of_[rotation.body]];
  for (World::Spin &spin : world.spins)
    spin.speed = of(planar_spin)[slot_of_[spin.body]];
}

void PlanarBodies::publish(World &world) const
{
  for (const unsigned int b : bodies_)
    {
      const unsigned int i     = slot_of_[b];
      Frame             &frame = world.frames[b];
      for (unsigned int d = 0; d < 2; ++d)
        {
          frame.position[d] = of(planar_position + d)[i];
          frame.velocity[d] = of(planar_velocity + d)[i];
        }
      const double cosine = of(planar_rotation)[i], sine = of(planar_rotation + 1)[i];
      frame.rotation[0][0]      = cosine;
      frame.rotation[0][1]      = -sine;
      frame.rotation[1][0]      = sine;
      frame.rotation[1][1]      = cosine;
      frame.angular_velocity[2] = of(planar_spin)[i];
    }
}

double PlanarBodies::kinetic_energy(const World & /*world*/) const
{
  return (kinetic_energy_ ? *kinetic_energy_ : kernels_.kinetic_energy(slots())) +
         (oval_ ? kernels_.kinetic_energy_of_ovals(slots()) : 0.);
}

PlanarLoads PlanarBodies::add_loads(const double gravity, const double drag)
{
  PlanarLoads loads{gravity, drag, 0., 0.};
  if (loads_)
    loads = *loads_;
  else
    kernels_.load(slots(), loads);
  loads_.reset();
  return loads;
}

void PlanarBodies::clear_forces()
{
  if (!begun_)
    {
      std::fill_n(of(planar_force), 2 * n_slots_, 0.);
      std::fill_n(of(planar_moment), n_slots_, 0.);
      loads_.reset();
    }
  begun_ = false;
  if (oval_)
    std::fill_n(of(planar_ring_force), 2 * n_slots_, 0.);
}

void PlanarBodies::bend_ovals(World &world) { world.ledger.strain += kernels_.bend_ovals(slots()); }

dealii::ArrayView<double> PlanarBodies::forces_on_ovals()
{
  return {of(oval_ ? planar_ring_force : planar_force), oval_ ? 2 * n_slots_ : 0};
}

void PlanarBodies::complete_forces(World &world)
{
  double *force = world.force.begin(), *moment = world.moment.begin();
  for (const unsigned int b : bodies_)
    {
      const unsigned int i = slot_of_[b];
      for (unsigned int d = 0; d < 2; ++d)
        force[3 * b + d] = of(planar_force + d)[i] += force[3 * b + d];
      moment[3 * b + 2] = of(planar_moment)[i] += moment[3 * b + 2];
    }
}

void PlanarBodies::write_forces(World &world) const
{
  double *force = world.force.begin(), *moment = world.moment.begin();
  for (const unsigned int b : bodies_)
    {
      const unsigned int i = slot_of_[b];
      for (unsigned int d = 0; d < 2; ++d)
        force[3 * b + d] = of(planar_force + d)[i];
      moment[3 * b + 2] = of(planar_moment)[i];
    }
}

void PlanarBodies::take_forces(const World &world)
{
  const double *force = world.force.begin(), *moment = world.moment.begin();
  for (const unsigned int b : bodies_)
    {
      const unsigned int i = slot_of_[b];
      for (unsigned int d = 0; d < 2; ++d)
        of(planar_force + d)[i] = force[3 * b + d];
      of(planar_moment)[i] = moment[3 * b + 2];
    }
}

void PlanarBodies::serialize(const Archive &archive, World & /*world*/)
{
  archive.numbers("planar", state_.begin(), state_.size());
  if (!archive.reads())
    return;
  is_behind_ = false; // World was written with it
  has_moved_ = begun_ = false;
  kinetic_energy_.reset();
  travelled_ += 1e3; // bodies are somewhere else now, nearer than that
}

std::size_t PlanarBodies::memory_consumption() const
{
  return state_.size() * sizeof(double) + (slot_of_.size() + bodies_.size()) * sizeof(unsigned int);
}
} // namespace chaindrive
