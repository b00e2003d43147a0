// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/contact/closed_window.h>
#include <chaindrive/contact/family.h>
#include <chaindrive/contact/joints.h>
#include <chaindrive/contact/roller_strips.h>
#include <chaindrive/scene/scene.h>

#include <array>
#include <map>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

namespace chaindrive::contact
{
/// Elastic cylinders in elastic bores, n_lanes joints at a time: see JointBatch. One of the two may
/// be rigid, see RigidSurfaceNodes. One record per pair. A joint is evaluated by the rank that owns
/// its bore or, where nodes do not travel and that makes loads more even, its cylinder.
///
/// Reduced bodies whose bases have the flexibility of their joints (reduction::Basis::joints) touch
/// without penalty: no node overlaps, and what the sides deflect beside their modes has no inertia.
/// Such joints have no contact damping, and stick by springs that yield little against what joints
/// slide (scene::add_full_chain).
class NodeBores : public Family, public HasClosedWindows
{
public:
  /// @p world must outlive this.
  NodeBores(const scene::Scene      &scene,
            const scene::BoreFamily &bores,
            World                   &world,
            bool                     search_every_step);

  /// Makes ghosts in @p world of the nodes of other ranks in joints that this rank evaluates.
  static void want_ghosts(const scene::BoreFamily &scene, World &world);

  /// The rank that evaluates each pair.
  static std::vector<unsigned int> owners_of(const scene::BoreFamily &scene, const World &world);

  /// The rank that evaluates the bore of each roller of @p teeth.
  static std::vector<unsigned int>
  owners_of_bores(const scene::Scene &scene, const scene::ToothFamily &teeth, const World &world);

  /// From now on forces of @p strips, which must outlive this, on rollers whose bores are among
  /// these joints are found with those of their joints.
  void couple(RollerStrips &strips);

  void search(const World &, double) override {}
  void announce(World &world, std::optional<double> dt) override;
  void add_forces(World &world, double dt) override;
  void add_springs(const World &, std::vector<Spring> &) const override {}
  bool needs_search() const override { return false; }

  std::vector<ClosedPair>   closed_pairs(const World &world) const override;
  std::vector<ClosedWindow> closed_windows() const override;

  bool knows_pressure() const override { return true; }
  void raise_pressures(std::vector<double> &largest) const override;
  void add_pressures(const World &world, std::vector<NodePressure> &pressures) const override;
  void add_patches(const World &world, std::vector<PressurePatch> &patches) const override;
  void add_massless_forces(const World &world, std::vector<NodeForce> &forces) const override;

  void                        serialize(const Archive &archive, unsigned int rank) override;
  std::optional<unsigned int> deepest_node(unsigned int i) const override;

private:
  /// Which two sides of which two parts, (group, surface) twice, bore and cylinder -> pairs.
  using Kinds = std::map<std::tuple<unsigned int, unsigned int, unsigned int, unsigned int>,
                         std::vector<unsigned int>>;
  static Kinds kinds_of(const scene::BoreFamily &scene, const World &world);

  /// How the bore stands about the cylinder, in the axes of the cylinder's body.
  struct Stance
  {
    dealii::Tensor<1, 3> offset;       ///< from the middle of its axis to that of the cylinder, m
    dealii::Tensor<1, 3> axis;         ///< of the bore
    double               cosine, sine; ///< of the turn about it
  };

  /// Pairs whose two sides are the same surfaces of the same parts.
  struct Group
  {
    /// Of the undeformed parts: bore and cylinder.
    std::unique_ptr<const std::array<mesh::CylinderGrid, 2>> grids;

    std::unique_ptr<const JointTables>                tables;
    std::vector<unsigned int>                         master_nodes, slave_nodes; ///< node_offsets()
    std::map<unsigned int, std::vector<unsigned int>> ghost_nodes; ///< same, of batches of others
    std::vector<std::unique_ptr<JointBatch>>          batches;
    std::vector<unsigned int> pairs; ///< of this rank, in the order of the lanes

    /// A side of the joints, as body batches are read by a batch of joints.
    struct Side
    {
      unsigned int              group;
      std::vector<unsigned int> node; ///< [ring][column]
      unsigned int              n_columns;
      std::vector<unsigned int> copy; ///< of each pair
      /// [batch of joints]: nodes by batches of bodies
      std::vector<std::map<unsigned int, std::vector<unsigned int>>> read;
    };
    std::array<Side, 2> sides;  ///< bore and cylinder
    ClosedPair          closed; ///< bore and cylinder

    std::unique_ptr<const JointFlexibility> flexibility; ///< without penalty
    std::array<ClosedWindow, 2>             windows;     ///< then: bore and cylinder

    /// Strips on the outside of rollers whose bores these are.
    struct Coupled
    {
      RollerStrips                          *strips;
      std::unique_ptr<const WallFlexibility> wall;
    };
    std::vector<Coupled> coupled;

    /// A search holds for a distance, where modes tell how far nodes move, not for a time.
    bool                by_distance = false;
    double              half_length = 0.; ///< of the cylinder, m
    std::vector<double> use; ///< [batch]: of what a search holds for, since the last forces
    std::vector<char>   due; ///< [batch]: a search must come before the next forces

    /// At the last search by distance of each pair: how it stood, and the amplitudes of both sides.
    std::vector<Stance>              searched_stance;
    std::vector<std::vector<double>> searched_amplitude;
  };

  Stance stance(const World &world, unsigned int pair) const;

  /// A node of the cylinder in the bore, of undeformed parts.
  struct InBore
  {
    dealii::Tensor<1, 3>        e, round, along; ///< away from the bore's axis, round and along it
    std::array<unsigned int, 4> place;           ///< [ring][column] of the bore's nodes about it
    std::array<double, 4>       weight;          ///< their shares; sum 1
  };
  InBore
  in_bore(const World &world, const Group &group, unsigned int pair, unsigned int node) const;

  /// Appends the pressures on the nodes of a bore: those of the cylinder in it, @p on_cylinder, at
  /// their places.
  void add_bore_pressures(const World               &world,
                          const Group               &group,
                          unsigned int               pair,
                          const std::vector<double> &on_cylinder,
                          std::vector<NodePressure> &pressures) const;

  /// Calls @p visit (group, pair, touching node) for all that touch.
  template <typename Visit>
  void for_each_touching(const Visit &visit) const
  {
    for (const Group &group : groups_)
      for (unsigned int i = 0; i < group.pairs.size(); ++i)
        group.batches[i / n_lanes]->for_each_touching(
            i % n_lanes,
            [&](const JointBatch::TouchingNode &at) { visit(group, group.pairs[i], at); });
  }

  /// One beyond the last pair of a group in the batch of joints number @p b.
  static std::size_t end_of_lanes(const Group &group, unsigned int b);

  /// By how much surfaces come nearer to each other where a bore goes from one place about its
  /// cylinder to another, both being rigid [m]. Half a column's way along each other counts as @p
  /// reach [m].
  static double moved(const Group &group, const Stance &from, const Stance &to, double reach);

  /// Tells the batch of joints number @p b the margins of its lanes. Returns whether one is larger
  /// than that of the last search.
  bool set_margins(Group &group, unsigned int b) const;

  /// Reach and margin [m] of a search by distance of the batch of joints number @p b, now.
  static std::pair<double, double> reach_by_distance(const Group &group, unsigned int b);

  /// Makes the windows of the batch of joints number @p b anew.
  void search(const World &world, Group &group, unsigned int b, double dt, double unforeseen);

  /// By how much surfaces of the batch of joints number @p b may have come nearer to each other
  /// since the last call [m]. Half a column's way along each other counts as @p reach [m].
  double moved(const World &world, const Group &group, unsigned int b, double reach);

  /// What is left of the reach of the last search of the batch of joints number @p b, steps forth
  /// and back not having been counted twice [m].
  double left(const World &world, const Group &group, unsigned int b) const;

  /// Remembers how the joints of the batch number @p b stand, for left().
  void remember(const World &world, Group &group, unsigned int b) const;

  /// Tells the batch of joints number @p b which strips are to be solved with it.
  void couple_lanes(const World &world, Group &group, unsigned int b);

  enum class Readers
  {
    search, ///< what it measures
    forces  ///< what is in its windows
  };

  /// Announces what these @p readers of the batch of joints number @p b read.
  void announce_joints(World &world, Group &group, unsigned int b, Readers readers) const;

  std::vector<Group>           groups_;
  std::vector<scene::BorePair> pairs_;
  std::vector<Stance>          stances_; ///< per pair, at the last evaluation of forces
  bool                         every_step_;
};
} // namespace chaindrive::contact
