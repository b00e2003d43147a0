// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/body_batches.h>
#include <chaindrive/bodies/body_groups.h>
#include <chaindrive/bodies/ledger.h>
#include <chaindrive/bodies/node_exchange.h>
#include <chaindrive/bodies/planar_bodies.h>
#include <chaindrive/bodies/rim.h>
#include <chaindrive/scene/scene.h>
#include <chaindrive/utilities/archive.h>
#include <chaindrive/utilities/mirror_symmetry.h>
#include <chaindrive/utilities/rotation.h>

#include <deal.II/base/array_view.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <initializer_list>
#include <vector>

namespace chaindrive
{
class TeethInMotion;

/// The state of all bodies, which make_world() makes. Translations live in deal.II's distributed
/// vectors, three entries per body (x, y, z of the centre of mass); rotations in three short lists
/// beside them, because a rigid body's rotation is no vector. `frames` repeats positions and
/// velocities in the form that forces are computed from.
///
/// Elastic bodies move by nodes, or are reduced: rigid bodies whose nodes move by modes as well.
/// The nodes of both and the modes are distributed over the ranks of a communicator, all else, and
/// modes of batches whose nodes several ranks touch, is repeated on each of them. While forces are
/// evaluated, a rank adds its own share of resultants, moments and energies to what it holds;
/// sum_over_ranks() makes the totals of it.
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

  /// Of a lumped roller, whose ring turns about the z axis through its centre. A ring looks the
  /// same however far it has turned: that is not followed.
  struct Spin
  {
    unsigned int body;
    double       inertia; ///< kg m2
    double       speed;   ///< rad/s, counter-clockwise positive
  };

  /// Of a lumped body without inertia about z, whose angular velocity is that of the line from one
  /// body to another (TiedSpins).
  struct Tied
  {
    unsigned int body, first, second;
  };

  /// A body that only turns, about an axis that stands still or is carried, or only moves along an
  /// axis, or does not move at all.
  struct Hub
  {
    unsigned int body;
    bool         prescribed;
    bool         slides;       ///< along the axis: its inertia is a mass, kg; angle and speed are
                               ///< its way, m, and m/s
    dealii::Tensor<1, 3> axis; ///< unit; positive is counter-clockwise seen from its end
    dealii::Tensor<1, 3> arm;  ///< of the body's origin from the axis at the start, m
    double               inertia;     ///< about the axis of all that moves as the hub does, kg m2
    double               angle = 0.;  ///< since the start, rad
    double               speed = 0.;  ///< rad/s
    double               start_angle; ///< orientation at the start, about z, rad
    Quaternion           start;       ///< the same of a body on another axis than z

    bool about_z() const { return axis[2] == 1.; }
  };

  /// The frame of the body of a hub at its present angle and speed.
  void place(const Hub &hub);

  /// A body on a hub that another one takes along.
  struct Carried
  {
    unsigned int body, carrier;
    bool         slides = false; ///< along its axis on its carrier
  };

  /// Puts what is carried where its carrier is, once all hubs have been placed.
  void place_carried()
  {
    for (const Carried &c : carried)
      if (c.slides)
        {
          frames[c.body].position += frames[c.carrier].position - origin[c.carrier];
          frames[c.body].velocity += frames[c.carrier].velocity;
        }
      else
        {
          frames[c.body].position = frames[c.carrier].position;
          frames[c.body].velocity = frames[c.carrier].velocity;
        }
  }

  /// Moment of all forces on the body of @p hub, and on those that it carries, about its axis, N m;
  /// of one that slides the force along it, N.
  double moment_about(const Hub &hub) const;

  /// Where the axis of a hub passes the origin of its body, m.
  dealii::Tensor<1, 3> pivot_of(const Hub &hub) const { return origin[hub.body] - hub.arm; }

  /// Where the nodes of an elastic body of one copy are found.
  struct Address
  {
    static constexpr unsigned int none = static_cast<unsigned int>(-1);

    unsigned int group = none, copy = none;
  };

  /// Whether this is the rank that adds the share of everything that is not distributed.
  bool is_first_rank() const { return rank_ == 0; }

  /// Whether this rank writes what there is to say of @p body: all but elastic ones are the first
  /// rank's.
  bool owns(const unsigned int body) const
  {
    const Address &place = elastic_address[body];
    return place.group == Address::none ? is_first_rank() : copies[place.group].owns(place.copy);
  }

  MPI_Comm communicator() const { return comm_; }

  /// Brings frames, displacements, velocities, forces and spins of bodies that move in the plane up
  /// to the present full step. System does so unless told not to.
  void update_bodies()
  {
    if (planar != nullptr)
      planar->update(*this);
  }

  /// Where the centre of mass of @p body is [m] and how fast [m/s], also without update_bodies().
  dealii::Tensor<1, 3> position_of(const unsigned int body) const
  {
    return planar == nullptr || planar->slot_of(body) == PlanarBodies::none ?
               dealii::Tensor<1, 3>(frames[body].position) :
               in_space(planar->position(planar->slot_of(body)), frames[body].position[2]);
  }
  dealii::Tensor<1, 3> velocity_of(const unsigned int body) const
  {
    return planar == nullptr || planar->slot_of(body) == PlanarBodies::none ?
               frames[body].velocity :
               in_space(planar->velocity(planar->slot_of(body)), 0.);
  }

  /// The same of the point @p local [m] in the frame of @p body.
  dealii::Tensor<1, 3> position_of(unsigned int body, const dealii::Point<3> &local) const;
  dealii::Tensor<1, 3> velocity_of(unsigned int body, const dealii::Point<3> &local) const;

  unsigned int n_bodies() const { return static_cast<unsigned int>(frames.size()); }

  /// Sets forces, moments and stored energies to zero, to be added anew.
  void clear_forces();

  /// The same but for the forces on nodes, which elastic bodies use up.
  void clear_resultants();

  /// Numbers that others sum along with those of bodies.
  struct Summands
  {
    dealii::ArrayView<double> numbers;
    bool                      of_bodies; ///< with halves, those of whole bodies are wanted
  };

  /// Sums what the ranks have added since clear_forces(): forces and moments on bodies, forces on
  /// shared modes, the ledger but for the work of the hubs, and what @p others have to be summed;
  /// with halves, of whole bodies, but for the modes. Shares out frames of elastic bodies.
  /// Collective.
  void sum_over_ranks(std::initializer_list<Summands> others = {});

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

  /// The first groups of copies are elastic bodies, those that move by nodes before the reduced
  /// ones; what comes after them are the meshes of rigid ones.
  unsigned int n_elastic_groups() const
  {
    return static_cast<unsigned int>(groups.elastic().size());
  }
  unsigned int n_nodal_groups() const { return static_cast<unsigned int>(groups.nodal().size()); }
  bool         has_elastic_bodies() const { return !groups.elastic().empty(); }

  /// Whether the motion of @p body is that of its nodes: three degrees of freedom each.
  bool is_nodal(const unsigned int body) const
  {
    return elastic_address[body].group < n_nodal_groups();
  }

  /// The group that moves the elastic bodies of these #copies.
  const ElasticGroup &group_of(const unsigned int of_copies) const
  {
    return *groups.elastic()[of_copies];
  }

  /// SurfaceGroup::place_surface() and gather_forces() of all groups that have them.
  void place_surfaces(double earlier);
  void gather_forces();

  /// The rim of @p body; null when it has none.
  const Rim *rim_of(unsigned int body) const;

  /// The teeth of @p body if they have inertia; else null.
  TeethInMotion *teeth_of(unsigned int body);

  /// Kinetic energy [J] of all groups that have not booked theirs: of every rigid or lumped body
  /// but a prescribed hub, from the present velocities.
  double kinetic_energy() const;

  /// The state between two steps, whose forces are those of the present time. Nodes that follow
  /// rigid or reduced bodies are placed anew at every step and are none.
  void serialize(const Archive &archive);

  /// Bytes held by the state.
  std::size_t memory_consumption() const;

  // one entry per direction and body
  Vector displacement; ///< of the centre of mass since the start, m
  Vector velocity;     ///< m/s
  Vector force;        ///< resultant, N
  Vector moment;       ///< resultant about the centre of mass, N m

  std::vector<double> mass;                 ///< per body, kg
  std::vector<double> inverse_mass;         ///< per body, 1/kg; 0: held by a hub, or moves by nodes
  std::vector<dealii::Tensor<1, 3>> origin; ///< per body, position at the start, m
  std::vector<Rotation>             rotations;
  std::vector<Spin>                 spins;
  std::vector<Tied>                 tied;
  std::vector<Hub>                  hubs;
  std::vector<Carried>              carried; ///< each after its carrier
  std::vector<unsigned int>         turning; ///< bodies that move by nodes and whose frames turn
  std::vector<Frame>       frames;        ///< per body, now; of an elastic one, its centre of mass
  std::vector<BodyBatches> copies;        ///< the elastic bodies, part by part
  NodeExchange             node_exchange; ///< between the ranks' copies
  std::vector<Address>     elastic_address; ///< per body, in copies
  std::vector<Rim>         rims;            ///< of elastic sprockets

  /// Of rigid sprockets whose rims have inertia; they are among the groups.
  PointerList<TeethInMotion> teeth;

  std::vector<Address>
      node_address; ///< per body, in copies: elastic_address, and those of rigid surface nodes

  /// How all of this moves: rigid bodies, hubs, then one group for each of the copies.
  BodyGroups groups;

  /// That one of the groups which moves free bodies in the plane; null: they move in space.
  PlanarBodies *planar = nullptr;

  double time = 0.; ///< s
  Ledger ledger;

  /// What makes forces, masses and energies of whole bodies of those that are computed. Until
  /// sum_over_ranks() they are those of what is computed.
  MirrorSymmetry symmetry;

private:
  /// The bodies at the start, without groups and nodes.
  World(const scene::Scene &scene, MPI_Comm comm);
  friend World make_world(const scene::Scene &scene, MPI_Comm comm);

  static dealii::Tensor<1, 3> in_space(const dealii::Tensor<1, 2> &in_plane, const double z)
  {
    dealii::Tensor<1, 3> v;
    v[0] = in_plane[0];
    v[1] = in_plane[1];
    v[2] = z;
    return v;
  }

  /// Adds the forces on all that @p carrier takes along.
  void add_carried(unsigned int carrier, dealii::Tensor<1, 3> &force_on) const;

  MPI_Comm            comm_;
  unsigned int        rank_, n_ranks_;
  Ledger              before_; ///< the ledger at clear_forces()
  std::vector<double> shared_; ///< what sum_over_ranks() sums
};
} // namespace chaindrive
