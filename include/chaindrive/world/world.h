// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/utilities/rotation.h>
#include <chaindrive/world/copies.h>
#include <chaindrive/world/ledger.h>
#include <chaindrive/world/rim.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <vector>

namespace chaindrive
{
/// The state of all bodies. Translations live in deal.II's distributed vectors, three entries per
/// body (x, y, z of the centre of mass); rotations in two short lists beside them, because a rigid
/// body's rotation is no vector. `frames` repeats positions and velocities in the form that forces
/// are computed from.
class World
{
public:
  using Vector = dealii::LinearAlgebra::distributed::Vector<double>;

  /// A free rigid body's rotation.
  struct Rotation
  {
    unsigned int         body;
    Quaternion           orientation;
    dealii::Tensor<1, 3> momentum; ///< angular, about the centre of mass, world axes, kg m2/s
    dealii::Tensor<1, 3> inertia;  ///< principal moments in body axes, kg m2
  };

  /// A body that only turns about the z axis through its origin.
  struct Hub
  {
    unsigned int body;
    bool         prescribed;
    double       inertia;     ///< of all that moves as the hub does, kg m2
    double       angle = 0.;  ///< since the start, rad, counter-clockwise positive
    double       speed = 0.;  ///< rad/s
    double       start_angle; ///< orientation at the start, rad
  };

  /// Where an elastic body of one copy is found.
  struct Place
  {
    static constexpr unsigned int none = static_cast<unsigned int>(-1);

    unsigned int group = none, copy = none;
  };

  explicit World(const scene::Scene &scene);

  unsigned int n_bodies() const { return static_cast<unsigned int>(frames.size()); }

  /// Sets forces and moments to zero.
  void clear_forces();

  /// A force @p f [N] that acts on @p body at the world point @p at [m].
  void
  add_force(const unsigned int body, const dealii::Tensor<1, 3> &f, const dealii::Tensor<1, 3> &at)
  {
    double                    *force_on  = force.begin() + 3 * body;
    double                    *moment_on = moment.begin() + 3 * body;
    const dealii::Tensor<1, 3> arm       = at - frames[body].position;
    for (unsigned int d = 0; d < 3; ++d)
      force_on[d] += f[d];
    moment_on[0] += arm[1] * f[2] - arm[2] * f[1];
    moment_on[1] += arm[2] * f[0] - arm[0] * f[2];
    moment_on[2] += arm[0] * f[1] - arm[1] * f[0];
  }

  /// Velocity [m/s] of the material point of @p body that is at the world point @p at now, at the
  /// instant @p earlier [s] before now to which the velocities in `frames` belong: half a step
  /// while forces are evaluated, nothing at full steps. A point that turns with its body has then
  /// moved along the chord of its circle, and two points that stick together drift apart by
  /// nothing.
  dealii::Tensor<1, 3>
  velocity_at(const unsigned int body, const dealii::Tensor<1, 3> &at, const double earlier) const
  {
    const Frame                &frame = frames[body];
    const dealii::Tensor<1, 3> &w     = frame.angular_velocity;
    dealii::Tensor<1, 3>        arm   = at - frame.position;
    arm -= earlier * dealii::cross_product_3d(w, arm);
    return frame.velocity + dealii::cross_product_3d(w, arm);
  }

  /// The rim of @p body; null when it has none.
  const Rim *rim_of(unsigned int body) const;

  /// Kinetic energy [J] of every rigid or lumped body but a prescribed hub, from the present
  /// velocities.
  double kinetic_energy() const;

  /// Bytes held by the state.
  std::size_t memory_consumption() const;

  // one entry per direction and body
  Vector displacement; ///< of the centre of mass since the start, m
  Vector velocity;     ///< m/s
  Vector force;        ///< resultant, N
  Vector moment;       ///< resultant about the centre of mass, N m

  std::vector<double>               mass;         ///< per body, kg
  std::vector<double>               inverse_mass; ///< per body, 1/kg; 0: held by a hub, or elastic
  std::vector<dealii::Tensor<1, 3>> origin;       ///< per body, position at the start, m
  std::vector<Rotation>             rotations;
  std::vector<Hub>                  hubs;
  std::vector<Frame>  frames; ///< per body, now; of an elastic one, its centre of mass
  std::vector<Copies> copies; ///< the elastic bodies, part by part
  std::vector<Place>  places; ///< per body, in copies
  std::vector<Rim>    rims;   ///< of elastic sprockets

  double time = 0.; ///< s
  Ledger ledger;

private:
  /// Makes the rim of hub @p h, an elastic sprocket, and leaves the hub the inertia of the rest.
  void add_rim(const scene::Scene &scene, unsigned int h);
};
} // namespace chaindrive
