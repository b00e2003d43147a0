// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/mobility.h>
#include <chaindrive/bodies/spring.h>
#include <chaindrive/bodies/world.h>
#include <chaindrive/contact/geometry.h>
#include <chaindrive/contact/point_force.h>

#include <algorithm>
#include <array>
#include <cmath>
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

/// What the contact of elastic nodes, all of it held closed, is to one of its two sides: springs
/// between each node and a ground, if the other side stood still.
struct ClosedSide
{
  static constexpr unsigned int none = static_cast<unsigned int>(-1);

  unsigned int        group   = none;  ///< of the bodies in World::copies; none: without nodes
  unsigned int        surface = none;  ///< of their mesh: a node of it is in one contact at a time
  std::vector<double> stiffness;       ///< per node of an elastic body, N/m; empty: a rigid one
  double              eigenvalue = 0.; ///< largest of the springs and the masses alone, 1/s2

  /// Holds an elastic body's node of @p mass [kg] by a spring @p k [N/m].
  void hold(const unsigned int node, const double k, const double mass)
  {
    stiffness[node] = k;
    eigenvalue      = std::max(eigenvalue, k / mass);
  }
};

/// The two sides of all pairs of one kind.
using ClosedPair = std::array<ClosedSide, 2>;

/// Speed [m/s] with which gaps of elastic bodies may close beyond what their velocities tell, until
/// they are looked at again: of vibration, 100 MPa in a wave are 2.5 m/s, and of impacts, which may
/// be as fast as bodies fly.
inline double unforeseen_speed(const World &world)
{
  double square = 25.;
  for (const Frame &frame : world.frames)
    square = std::max(square, frame.velocity.norm_square());
  return std::sqrt(square);
}

/// All interfaces of one kind: search -> geometry -> law for each of its pairs.
class Family
{
public:
  virtual ~Family() = default;

  /// Chooses the pairs that may touch before any body has moved by @p reach [m].
  virtual void search(const World &world, double reach) = 0;

  /// Adds the contact forces at the present state and books their energy. @p dt is the time since
  /// the last call [s], zero at the first one.
  virtual void add_forces(World &world, double dt) = 0;

  /// Appends the springs of every pair, held closed, for the stable step. Pairs of smooth surfaces
  /// that the search has left out do not count.
  virtual void add_springs(const World &world, std::vector<Spring> &springs) const = 0;

  /// The contact of elastic nodes, held closed, for the stable step; none for rigid and lumped
  /// slaves, whose springs are above.
  virtual std::vector<ClosedPair> closed_pairs(const World &) const { return {}; }

  /// Nodes that a search found to overlap without having been looked at before; there must be none.
  virtual unsigned long n_missed() const { return 0; }

  /// Whether each rank evaluates the pairs whose elastic bodies it owns. Families that are not
  /// dealt out are evaluated by the first rank.
  bool is_dealt_out() const { return !owner_.empty(); }

  /// Appends the records of the pairs that rank @p rank evaluates to @p numbers, or takes them from
  /// there, beginning at @p position, which moves on. Pairs that are out of reach are left out.
  void pack_records(unsigned int rank, std::vector<double> &numbers) const;
  void unpack_records(unsigned int rank, const std::vector<double> &numbers, std::size_t &position);

  /// What the pairs remember between two steps: records, and pair by pair, from the rank that
  /// evaluates it, all else. This is rank @p rank.
  virtual void serialize(const Archive &archive, unsigned int rank);

  /// Whether this family needs search() at all.
  virtual bool needs_search() const = 0;

  /// An overlap [m] out of all proportion to the bodies: a quarter of the smallest radius of a
  /// slave, which even a soft penalty does not need. Infinite where slaves have no radius.
  double senseless_overlap() const { return 0.25 * smallest_radius_; }

  /// The node of an elastic slave that overlaps most in pair @p i, if this rank evaluates it.
  virtual std::optional<unsigned int> deepest_node(const unsigned int) const { return {}; }

  const std::string         &name() const { return name_; }
  const scene::ContactLaw   &law() const { return law_; }
  const std::vector<Record> &records() const { return records_; }
  unsigned int               n_touching() const;

  std::size_t memory_consumption() const
  {
    return records_.size() * (sizeof(Record) + sizeof(TouchState));
  }

protected:
  Family(std::string name, const scene::ContactLaw &law) : name_(std::move(name)), law_(law) {}

  /// Appends the record of a pair of bodies, for the slave's @p joint.
  void add_record(const unsigned int master, const unsigned int slave, const unsigned int joint)
  {
    Record record{};
    record.master = master;
    record.slave  = slave;
    record.joint  = joint;
    records_.push_back(record);
  }

  /// Law and bookkeeping of pair @p i whose geometry is @p touch.
  void apply(World &world, unsigned int i, const Touch &touch, double dt);

  /// Springs that are no softer than pair @p i, closed along any normal across the master's z axis:
  /// @p centre [m, world] is the slave's axis, @p radius [m] how far from it friction acts; @p
  /// along is some direction across z.
  void add_closed(const World                &world,
                  const Mobility             &mobility,
                  unsigned int                i,
                  const dealii::Tensor<1, 3> &along,
                  const dealii::Tensor<1, 3> &centre,
                  double                      radius,
                  std::vector<Spring>        &springs) const;

  /// What pair @p i of a family that is dealt out remembers.
  virtual void serialize_pair(const unsigned int i, const Archive &archive)
  {
    archive("state", states_[i]);
  }

  /// Whether the last search left pair @p i within reach: the same on all ranks.
  virtual bool within_reach(const unsigned int) const { return true; }

  /// Takes @p radius [m] of a slave into account for senseless_overlap().
  void add_radius(const double radius)
  {
    if (radius > 0.)
      smallest_radius_ = std::min(smallest_radius_, radius);
  }

  std::string               name_;
  scene::ContactLaw         law_; ///< of one pair
  std::vector<Record>       records_;
  std::vector<TouchState>   states_;
  std::vector<unsigned int> owner_; ///< rank that evaluates the pair; empty: the first one

private:
  double smallest_radius_ = std::numeric_limits<double>::infinity(); ///< of the slaves, m
};

/// Cylinders in bores: every pair is near all the time.
class Bores : public Family
{
public:
  explicit Bores(const scene::BoreFamily &scene);

  void search(const World &, double) override {}
  void add_forces(World &world, double dt) override;
  void add_springs(const World &world, std::vector<Spring> &springs) const override;
  bool needs_search() const override { return false; }

private:
  std::vector<scene::BorePair> pairs_;
};

/// A cylinder (or a node, with the radius 0) over the flanks of the sprocket @p master, which are
/// taken to go on beyond its width: its gap is the distance of its @p centre [m, world] less its
/// @p radius [m]. Facets of an imported mesh are looked for @p within a distance [m]; @p hint is
/// the facet found last time, if any.
Touch touch_flanks(const scene::ToothFamily   &family,
                   const dealii::Tensor<1, 3> &centre,
                   double                      radius,
                   double                      within,
                   const Frame                &master,
                   unsigned int               &hint);

/// Rollers on the teeth of one sprocket: only those near its circumference are looked at.
class Teeth : public Family
{
public:
  explicit Teeth(const scene::ToothFamily &scene);

  void search(const World &world, double reach) override;
  void add_forces(World &world, double dt) override;
  void add_springs(const World &world, std::vector<Spring> &springs) const override;
  void serialize(const Archive &archive, unsigned int rank) override;
  bool needs_search() const override { return true; }

  unsigned int                     sprocket() const { return scene_.sprocket; }
  const std::vector<unsigned int> &near() const { return near_; }

protected:
  scene::ToothFamily        scene_;
  std::vector<unsigned int> near_; ///< pairs chosen by the last search

private:
  std::vector<unsigned int> hints_; ///< per pair, facet met last on an imported mesh
};
} // namespace chaindrive::contact
