// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/teeth_in_motion.h>
#include <chaindrive/dynamics/newmark.h>
#include <chaindrive/dynamics/relaxation.h>
#include <chaindrive/scene/scene.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/ranks.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace chaindrive::dynamics
{
namespace
{
using Vector3 = dealii::Tensor<1, 3>;

constexpr double allowed_speed = 2.; // m/s; see contact::unforeseen_speed()

/// @p scene at rest, without loads and friction, whatever overlaps.
scene::Scene at_rest(const scene::Scene &scene)
{
  scene::Scene still = scene;
  for (scene::Body &body : still.bodies)
    body.initial.velocity = body.initial.angular_velocity = Vector3();
  const auto without_friction = [](auto &families) {
    for (auto &family : families)
      family.law.friction = family.law.tangential_stiffness = family.law.tangential_damping = 0.;
  };
  without_friction(still.bores);
  without_friction(still.faces);
  without_friction(still.teeth);
  without_friction(still.surfaces);
  without_friction(still.tooth_sides);
  still.shafts.clear();
  still.swings.clear();
  still.loads.gravity = still.loads.drag = 0.;
  still.at_speed                         = false;
  still.prestress                        = std::numeric_limits<double>::infinity();
  return still;
}

/// Calls @p visit (copies, index, node) for every node by which elastic bodies of this rank move,
/// as they lie in memory.
template <typename Visit>
void for_each_node(World &world, const Visit &visit)
{
  for (unsigned int g = 0; g < world.n_nodal_groups(); ++g)
    {
      BodyBatches &copies = world.copies[g];
      for (unsigned int batch = copies.first_owned_batch(); batch < copies.end_of_owned_batches();
           ++batch)
        for (unsigned int node = 0; node < copies.n_nodes(); ++node)
          copies.for_each_copy_of(batch, [&](unsigned int, const unsigned int lane) {
            visit(copies, copies.start_of(batch) + node_offset(node) + lane, node);
          });
    }
}

bool is_link(const scene::Kind kind)
{
  return kind == scene::Kind::inner_link || kind == scene::Kind::outer_link;
}

/// About which axes bodies of @p scene may turn as a whole, unit, or zero: links of a running chain
/// that has been laid in line and moved since lean across its plane, about their second axis, as
/// pins ask that slide along their bushes. At rest friction holds them.
std::vector<Vector3> axes_of_lean(const scene::Scene &scene)
{
  std::vector<Vector3> axes(scene.bodies.size());
  if (scene.start_overlap == 0. ||
      scene.bodies[scene.drive.sprockets.front().body].initial.angular_velocity.norm() == 0.)
    return axes;
  for (unsigned int b = 0; b < axes.size(); ++b)
    for (unsigned int d = 0; d < 3 && is_link(scene.bodies[b].kind); ++d)
      axes[b][d] = scene.bodies[b].initial.rotation[d][1];
  return axes;
}

/// The links of a batch, which may not move as a whole, but may lean about their @p axes.
class HeldBatch
{
public:
  HeldBatch(const std::vector<Vector3> &axes, BodyBatches &copies, const unsigned int batch)
      : axes_(axes), copies_(copies), batch_(batch)
  {
    const NodeView position(std::as_const(copies_.position));
    for_each([&](const unsigned int lane, const std::size_t at, const double mass) {
      centre_[lane] += mass / copies_.mass * position[at];
    });
    std::array<dealii::SymmetricTensor<2, 3>, n_lanes> inertia;
    for_each([&](const unsigned int lane, const std::size_t at, const double mass) {
      const Vector3 arm = position[at] - centre_[lane];
      inertia[lane] += mass * (arm.norm_square() * dealii::unit_symmetric_tensor<3>() -
                               dealii::symmetrize(dealii::outer_product(arm, arm)));
    });
    copies_.for_each_copy_of(batch_, [&](unsigned int, const unsigned int lane) {
      if (copies_.part->symmetry().is_active()) // turns about z only
        inverse_inertia_[lane][2][2] = 1. / inertia[lane][2][2];
      else
        inverse_inertia_[lane] = dealii::invert(inertia[lane]);
    });
  }

  /// Takes from the velocities of their nodes what moves them as a whole.
  void constrain() const
  {
    const NodeView               position(std::as_const(copies_.position));
    const NodeView               velocity(copies_.velocity);
    std::array<Vector3, n_lanes> momentum, spin;
    for_each([&](const unsigned int lane, const std::size_t at, const double mass) {
      const Vector3 p = mass * velocity[at];
      momentum[lane] += p;
      spin[lane] += cross_product_3d(position[at] - centre_[lane], p);
    });
    std::array<Vector3, n_lanes> v, w;
    copies_.for_each_copy_of(batch_, [&](const unsigned int copy, const unsigned int lane) {
      v[lane] = momentum[lane] / copies_.mass;
      copies_.part->symmetry().cancel_across(v[lane]);
      w[lane]             = inverse_inertia_[lane] * spin[lane];
      const Vector3 &axis = axes_[copies_.bodies[copy]];
      w[lane] -= (w[lane] * axis) * axis;
    });
    for_each([&](const unsigned int lane, const std::size_t at, double) {
      velocity.add(at, -v[lane] - cross_product_3d(w[lane], position[at] - centre_[lane]));
    });
  }

private:
  /// Calls @p visit (lane, index, mass) for every node.
  template <typename Visit>
  void for_each(const Visit &visit) const
  {
    for (unsigned int node = 0; node < copies_.n_nodes(); ++node)
      copies_.for_each_copy_of(batch_, [&](unsigned int, const unsigned int lane) {
        visit(lane, copies_.start_of(batch_) + node_offset(node) + lane, copies_.nodes.mass[node]);
      });
  }

  const std::vector<Vector3>                        &axes_; ///< per body
  BodyBatches                                       &copies_;
  unsigned int                                       batch_;
  std::array<Vector3, n_lanes>                       centre_;
  std::array<dealii::SymmetricTensor<2, 3>, n_lanes> inverse_inertia_;
};

/// All links of @p world that move by nodes and that this rank owns.
std::vector<HeldBatch>
links_of(const scene::Scene &scene, const std::vector<Vector3> &axes, World &world)
{
  std::vector<HeldBatch> links;
  for (unsigned int g = 0; g < world.n_nodal_groups(); ++g)
    {
      BodyBatches &copies = world.copies[g];
      if (!is_link(scene.bodies[copies.bodies.front()].kind))
        continue;
      for (unsigned int batch = copies.first_owned_batch(); batch < copies.end_of_owned_batches();
           ++batch)
        links.emplace_back(axes, copies, batch);
    }
  return links;
}

/// Moves all nodes on with their velocities for the time @p dt.
void drift(World &world, const double dt)
{
  for (unsigned int g = 0; g < world.n_nodal_groups(); ++g)
    for (std::size_t i = 0; i < world.copies[g].velocity.locally_owned_size(); ++i)
      world.copies[g].position.local_element(i) += dt * world.copies[g].velocity.local_element(i);
}

/// Keeps nodes from moving too fast.
void slow_down(World &world)
{
  for_each_node(world, [&](BodyBatches &copies, const std::size_t at, unsigned int) {
    const NodeView velocity(copies.velocity);
    const Vector3  v     = velocity[at];
    const double   speed = v.norm();
    if (speed > allowed_speed)
      velocity.set(at, allowed_speed / speed * v);
  });
}

/// Of all nodes by which elastic bodies of all ranks move, J.
double kinetic_energy(World &world)
{
  double kinetic = 0.;
  for_each_node(world, [&](BodyBatches &copies, const std::size_t at, const unsigned int node) {
    kinetic +=
        0.5 * copies.nodes.mass[node] * NodeView(std::as_const(copies.velocity))[at].norm_square();
  });
  return dealii::Utilities::MPI::sum(kinetic, world.communicator());
}

/// Bodies whose modes are relaxed beside nodes: rigid motions of rollers, and all modes.
class ModalRelaxation
{
public:
  ModalRelaxation(const scene::Scene &scene, const std::vector<Vector3> &axes, World &world)
      : axes_(axes), world_(world)
  {
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      {
        const bool reduced = scene.bodies[b].motion == scene::Motion::reduced;
        has_modal_         = has_modal_ || reduced;
        held_.push_back(!reduced || scene.bodies[b].kind != scene::Kind::roller);
      }
    for (const ModalGroup *group : world_.groups.modal())
      {
        BodyBatches              &copies = world_.copies[group->copies()];
        std::vector<unsigned int> all(copies.n_nodes()); // slow_down() reads them
        std::iota(all.begin(), all.end(), 0u);
        for (unsigned int b = copies.first_owned_batch(); b < copies.end_of_owned_batches(); ++b)
          copies.add_readers(b, all, 1);
      }
  }

  bool has_modal() const { return has_modal_; }

  /// Kick and drift, with the forces of the last evaluation.
  void begin(const double dt)
  {
    if (!has_modal_)
      return;
    constrain();
    first_half(world_, {dt, world_.time, 0., 0., {}});
  }

  /// The second kick, after which no node is too fast; returns the kinetic energy of all ranks, J.
  double end(const double dt)
  {
    if (!has_modal_)
      return 0.;
    constrain();
    for (TeethInMotion *teeth : world_.teeth)
      teeth->use_forces(dt);
    second_half(world_, {dt, world_.time, 0., 0., {}});
    for (ModalGroup *group : world_.groups.modal())
      slow_down(*group);
    double of_modes = 0.;
    for (const ModalGroup *group : world_.groups.modal())
      of_modes += group->modal_energy(world_);
    double all = dealii::Utilities::MPI::sum(of_modes, world_.communicator());
    for (const TeethInMotion *teeth : world_.teeth) // the same on all ranks
      all += teeth->modal_energy();
    return world_.kinetic_energy() + all;
  }

  void rest()
  {
    if (!has_modal_)
      return;
    for (ModalGroup *group : world_.groups.modal())
      group->rest();
    for (TeethInMotion *teeth : world_.teeth)
      teeth->rest();
    world_.velocity = 0.;
    for (World::Rotation &rotation : world_.rotations)
      rotation.momentum = Vector3();
    for (Frame &frame : world_.frames)
      frame.velocity = frame.angular_velocity = Vector3();
  }

private:
  /// Keeps modes from moving nodes too fast.
  void slow_down(ModalGroup &group)
  {
    const BodyBatches  &copies = world_.copies[group.copies()];
    std::vector<double> share(copies.n_copies(), 1.);
    for (unsigned int batch = copies.first_owned_batch(); batch < copies.end_of_owned_batches();
         ++batch)
      {
        std::array<double, n_lanes> fastest{}; // squares
        const double               *v = copies.velocity.begin() + copies.start_of(batch);
        for (unsigned int node = 0; node < copies.n_nodes(); ++node, v += numbers_per_node)
          for (unsigned int lane = 0; lane < n_lanes; ++lane)
            fastest[lane] = std::max(fastest[lane],
                                     v[lane] * v[lane] + v[n_lanes + lane] * v[n_lanes + lane] +
                                         v[2 * n_lanes + lane] * v[2 * n_lanes + lane]);
        copies.for_each_copy_of(batch, [&](const unsigned int copy, const unsigned int lane) {
          if (fastest[lane] > allowed_speed * allowed_speed)
            share[copy] = allowed_speed / std::sqrt(fastest[lane]);
        });
      }
    dealii::Utilities::MPI::min(share, world_.communicator(), share); // all move what is shared
    for (unsigned int copy = 0; copy < copies.n_copies(); ++copy)
      if (share[copy] < 1.)
        group.slow_modes(world_, copy, share[copy]);
  }

  /// Nothing moves the other bodies as a whole, but links may lean.
  void constrain()
  {
    for (unsigned int b = 0; b < held_.size(); ++b)
      if (held_[b])
        {
          double       *moment = world_.moment.begin() + 3 * b;
          const Vector3 left   = (Vector3({moment[0], moment[1], moment[2]}) * axes_[b]) * axes_[b];
          for (unsigned int d = 0; d < 3; ++d)
            {
              world_.force.local_element(3 * b + d) = 0.;
              moment[d]                             = left[d];
            }
        }
  }

  const std::vector<Vector3> &axes_; ///< per body
  World                      &world_;
  bool                        has_modal_ = false;
  std::vector<char>           held_; ///< per body
};
} // namespace

Relaxation::Relaxation(const scene::Scene         &scene,
                       const MPI_Comm              comm,
                       const double                change,
                       const std::optional<double> known)
    : scene_(scene)
    , system_(at_rest(scene), false, comm)
    , critical_time_step_(known ? *known : system_.critical_time_step())
{
  World                       &world = system_.world;
  const std::vector<Vector3>   axes  = axes_of_lean(scene);
  const std::vector<HeldBatch> links = links_of(scene, axes, world);
  ModalRelaxation              modal(scene, axes, world);

  // links lean slowly: nothing but the tension keeps them from leaning all alike
  const bool lean =
      std::any_of(axes.begin(), axes.end(), [](const Vector3 &a) { return a != Vector3(); });
  const double       enough = lean ? std::min(change, 5e-5) : change;
  const unsigned int most   = lean ? 1000 : 100; // intervals
  const Material    &steel  = scene.material;
  const double       dt     = (modal.has_modal() ? 0.5 : 0.65) * critical_time_step_;
  const double       wave   = scene.drive.pitch / std::sqrt(steel.youngs_modulus / steel.density);
  const unsigned int steps  = static_cast<unsigned int>(5. * wave / dt) + 1;
  double             before = 0., stored = 0.;
  for (unsigned int interval = 0; interval < most; ++interval)
    {
      for (unsigned int i = 0; i < steps; ++i)
        {
          modal.begin(dt);
          system_.evaluate_forces(dt);
          for (ElasticGroup *group : world.groups.elastic())
            group->use_forces(world, {dt, world.time});
          slow_down(world);
          for (const HeldBatch &batch : links) // also of what the slower nodes leave to the others
            batch.constrain();
          const double kinetic = kinetic_energy(world) + modal.end(dt);
          if (kinetic < before)
            {
              for (unsigned int g = 0; g < world.n_nodal_groups(); ++g)
                world.copies[g].velocity = 0.;
              modal.rest();
            }
          else
            drift(world, dt);
          before = kinetic < before ? 0. : kinetic;
        }
      const double now = world.ledger.stored() - world.ledger.kinetic;
      if (std::abs(now - stored) <= enough * now)
        return;
      stored = now;
    }
  throw RunError("The elastic bodies find no balance with the forces of the start.");
}

void Relaxation::strain(World &world) const
{
  for (unsigned int g = 0; g < world.n_nodal_groups(); ++g)
    world.copies[g].position.copy_locally_owned_data_from(system_.world.copies[g].position);
  for (unsigned int g = 0; g < world.n_nodal_groups(); ++g)
    {
      BodyBatches   &copies = world.copies[g];
      const NodeView position(std::as_const(copies.position));
      const NodeView velocity(copies.velocity);
      for (unsigned int copy = 0; copy < copies.n_copies(); ++copy)
        {
          const Frame &start = scene_.bodies[copies.bodies[copy]].initial;
          for (unsigned int node = 0; copies.owns(copy) && node < copies.n_nodes(); ++node)
            {
              const std::size_t at = copies.index(copy, node);
              velocity.set(at,
                           start.velocity + cross_product_3d(start.angular_velocity,
                                                             position[at] - start.position));
            }
        }
    }

  const World &balanced = system_.world;
  for (std::size_t g = 0; g < world.groups.modal().size(); ++g)
    {
      ModalGroup        &group  = *world.groups.modal()[g];
      const ModalGroup  &from   = *balanced.groups.modal()[g];
      const BodyBatches &copies = world.copies[group.copies()];
      for (unsigned int copy = 0; copy < copies.n_copies(); ++copy)
        if (copies.owns(copy) || copies.is_shared(copies.batch_of(copy)))
          group.rest_at(world, copy, from.amplitudes_of(balanced, copy));
    }
  for (std::size_t i = 0; i < world.teeth.size(); ++i)
    world.teeth[i]->rest_as(*balanced.teeth[i]);
  for (unsigned int b = 0; b < scene_.bodies.size(); ++b)
    if (scene_.bodies[b].motion == scene::Motion::reduced)
      {
        world.frames[b].position = balanced.frames[b].position;
        world.frames[b].rotation = balanced.frames[b].rotation;
        for (unsigned int d = 0; d < 3; ++d)
          world.displacement.local_element(3 * b + d) =
              balanced.displacement.local_element(3 * b + d);
      }
  for (unsigned int r = 0; r < world.rotations.size(); ++r)
    world.rotations[r].orientation = balanced.rotations[r].orientation;
}

Relaxation::JointForces Relaxation::joint_forces()
{
  const World &world = system_.world;
  system_.contacts.gather_records(world);
  // on the outer link, towards the inner one
  const auto pulls = [&](const contact::Record &record) {
    return record.force * (scene_.bodies[record.master].initial.position -
                           scene_.bodies[record.slave].initial.position) >
           0.;
  };
  JointForces forces{std::vector<double>(scene_.drive.n_joints, 0.),
                     std::vector<double>(scene_.drive.n_joints, 0.)};
  for (const auto &family : system_.contacts.families())
    if (family->is_distributed()) // elastic bodies
      for (const contact::Record &record : family->records())
        {
          const double size = record.force.norm();
          double      &pin  = forces.pin[record.joint];
          if (scene_.bodies[record.slave].kind == scene::Kind::outer_link)
            {
              if (size > std::abs(pin))
                pin = pulls(record) ? size : -size;
            }
          else if (scene_.bodies[record.master].kind == scene::Kind::sprocket)
            forces.seat[record.joint] += size;
        }
  forces.pin  = dealii::Utilities::MPI::broadcast(world.communicator(), forces.pin);
  forces.seat = dealii::Utilities::MPI::broadcast(world.communicator(), forces.seat);
  return forces;
}
} // namespace chaindrive::dynamics
