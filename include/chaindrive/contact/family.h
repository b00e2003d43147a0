// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/spring.h>
#include <chaindrive/bodies/world.h>
#include <chaindrive/contact/closed_pair.h>
#include <chaindrive/contact/penalty.h>
#include <chaindrive/scene/interface.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace chaindrive::contact
{
/// What is known of one interface at the instant of the last evaluation.
struct Record
{
  unsigned int         master, slave;                            ///< bodies
  unsigned int         joint;                                    ///< of the slave point
  double               gap = std::numeric_limits<double>::max(); ///< m; unset while out of reach
  dealii::Tensor<1, 3> force;                                    ///< on the slave, N
  unsigned int         feature = 0;       ///< gap of the sprocket that the last touch was in
  dealii::Tensor<1, 3> normal;            ///< of the last touch
  double               normal_speed = 0.; ///< approach along the normal, m/s, while touching
};

/// Pressure on the surface of an elastic body at one of its nodes.
struct NodePressure
{
  unsigned int body, node; ///< number of the part's node
  double       pressure;   ///< of all that the node stands for, Pa
};

/// A piece of a surface that presses another one evenly, as fine as forces between them are found.
struct PressurePatch
{
  unsigned int slave, master; ///< bodies
  unsigned int joint;         ///< as in Record

  std::array<dealii::Point<3>, 4> corners;      ///< round and round, world, m
  double                          normal_force; ///< N
  double                          pressure;     ///< that over the area of the patch, Pa
};

/// The force of a contact on a node of a body.
struct NodeForce
{
  unsigned int         body, node; ///< number of the part's node
  dealii::Tensor<1, 3> force;      ///< N, world
};

/// All contacts of one kind, each a pair of a slave and a master: a slave set, a surface and a law,
/// evaluated as search -> geometry -> law. What it books per pair is a Record.
class Family
{
public:
  virtual ~Family() = default;

  /// Chooses the pairs that may touch before any body has moved by @p reach [m].
  virtual void search(const World &world, double reach) = 0;

  /// Tells bodies that place only nodes that are read (BodyBatches::add_readers()) which ones those
  /// are: what add_forces() with @p dt is going to look at; without it, what a step without a
  /// search would.
  virtual void announce(World &, std::optional<double> /*dt*/) {}

  /// Adds the contact forces at the present state and books their energy. @p dt is the time since
  /// the last call [s], zero at the first one.
  virtual void add_forces(World &world, double dt) = 0;

  /// After add_forces() of all families: forces that others have found. Books their energy too.
  virtual void finish_forces(World &, double /*dt*/) {}

  /// Appends the springs of every pair, held closed, for the critical time step. Pairs of smooth
  /// surfaces that the search has left out do not count.
  virtual void add_springs(const World &world, std::vector<Spring> &springs) const = 0;

  /// The contact of elastic nodes, held closed, for the critical time step; none for rigid and
  /// lumped slaves, whose springs are above.
  virtual std::vector<ClosedPair> closed_pairs(const World &) const { return {}; }

  /// Nodes that a search found to overlap without having been looked at before; there must be none.
  unsigned long n_missed() const { return n_missed_; }

  /// The force of a pair [N] up to which the limit of the step holds; infinite: any.
  double largest_force() const { return largest_force_; }

  /// The largest force since the start over that, of the pairs that this rank has evaluated.
  double most_pressed() const { return most_pressed_; }
  void   set_most_pressed(const double most) { most_pressed_ = most; }

  /// Whether each rank evaluates the pairs whose elastic bodies it owns. Families that are not
  /// distributed are evaluated by the first rank.
  bool is_distributed() const { return !owner_.empty(); }

  /// Appends the records of the pairs that rank @p rank evaluates to @p numbers, or takes them from
  /// there, beginning at @p position, which moves on. Pairs that are out of reach are left out.
  void pack_records(unsigned int rank, std::vector<double> &numbers) const;
  void unpack_records(unsigned int rank, const std::vector<double> &numbers, std::size_t &position);

  /// How many numbers pack_records() may append.
  std::size_t most_numbers(unsigned int rank) const;

  /// What the pairs remember between two steps: records, and pair by pair, from the rank that
  /// evaluates it, all else. This is rank @p rank.
  virtual void serialize(const Archive &archive, unsigned int rank);

  /// The smallest radius of a slave [m]; infinite where slaves have none.
  double smallest_radius() const { return smallest_radius_; }

  /// Whether this family needs search() at all.
  virtual bool needs_search() const = 0;

  /// A penetration [m] out of all proportion to the bodies: a quarter of the smallest radius of a
  /// slave, which even a soft penalty does not need.
  double penetration_limit() const { return 0.25 * smallest_radius_; }

  /// The node of an elastic slave that overlaps most in pair @p i, if this rank evaluates it.
  virtual std::optional<unsigned int> deepest_node(const unsigned int) const { return {}; }

  const std::string         &name() const { return name_; } ///< in words
  const scene::InterfaceOf  &interface() const { return interface_; }
  const scene::ContactLaw   &law() const { return law_; }
  const std::vector<Record> &records() const
  {
    if (stale_)
      update_records();
    stale_ = false;
    return records_;
  }

  /// Adds to @p forces, by joint, the forces of the records on the slaves [N].
  virtual void add_joint_forces(std::vector<dealii::Tensor<1, 3>> &forces) const;

  /// Adds to @p forces, by joint, their parts along the normals [N]; returns the largest
  /// penetration, or 0 where nothing touches [m].
  virtual double add_normal_forces(std::vector<double> &forces) const;

  /// The largest penetration [m], of all pairs; negative where nothing touches.
  virtual double deepest() const;

  /// Whether this family has elastic slaves, on whose surfaces it knows the pressure.
  virtual bool knows_pressure() const { return false; }

  /// Raises @p largest, by joint, to the largest pressure [Pa] on the slaves that this rank
  /// evaluates.
  virtual void raise_pressures(std::vector<double> & /*largest*/) const {}

  /// Appends the pressures on the nodes of elastic bodies in the pairs that this rank evaluates;
  /// several of one node add up. With the areas of the nodes those of a slave add up to its normal
  /// force; a master in whose bore it is has the same at its own nodes.
  virtual void add_pressures(const World &, std::vector<NodePressure> &) const {}

  /// Appends what touches in the pairs that this rank evaluates in pieces, which lie on one of both
  /// bodies as it is without deflection; of a symmetry model those at z >= 0. Surfaces that are
  /// neither round nor flanks have none.
  virtual void add_patches(const World &, std::vector<PressurePatch> &) const {}

  /// Appends the forces on nodes of reduced bodies in the pairs that this rank evaluates without a
  /// penalty: what their bodies deflect beside their modes follows them without inertia. Several
  /// on one node add up.
  virtual void add_massless_forces(const World &, std::vector<NodeForce> &) const {}

  /// Whether add_forces() looks at frames of free bodies: not where all of them are PlanarBodies.
  virtual bool reads_frames() const { return true; }

  unsigned int n_touching() const;

  std::size_t memory_consumption() const
  {
    return records_.size() * (sizeof(Record) + sizeof(TouchState));
  }

protected:
  Family(std::string name, const scene::InterfaceOf &interface, const scene::ContactLaw &law)
      : name_(std::move(name)), interface_(interface), law_(law)
  {
  }

  /// Appends the record of a pair of bodies, for the slave's @p joint.
  void add_record(const unsigned int master, const unsigned int slave, const unsigned int joint)
  {
    Record record{};
    record.master = master;
    record.slave  = slave;
    record.joint  = joint;
    records_.push_back(record);
  }

  /// Completes records and states after records_are_stale().
  virtual void update_records() const {}

  /// Forces have been evaluated, and neither records nor states follow them until somebody asks.
  void records_are_stale() { stale_ = true; }

  /// What pair @p i of a family that is distributed remembers.
  virtual void serialize_pair(const unsigned int i, const Archive &archive)
  {
    archive("state", states_[i]);
  }

  /// Whether the last search left pair @p i within reach: the same on all ranks.
  virtual bool within_reach(const unsigned int) const { return true; }

  /// Takes @p radius [m] of a slave into account for penetration_limit().
  void add_radius(const double radius)
  {
    if (radius > 0.)
      smallest_radius_ = std::min(smallest_radius_, radius);
  }

  std::string                     name_;
  scene::InterfaceOf              interface_;
  scene::ContactLaw               law_; ///< of one pair
  mutable std::vector<Record>     records_;
  mutable std::vector<TouchState> states_;
  std::vector<unsigned int>       owner_; ///< rank that evaluates the pair; empty: the first one
  unsigned long                   n_missed_ = 0;
  double largest_force_ = std::numeric_limits<double>::infinity(), most_pressed_ = 0.;

private:
  mutable bool stale_           = false;
  double       smallest_radius_ = std::numeric_limits<double>::infinity(); ///< of the slaves, m
};
} // namespace chaindrive::contact
