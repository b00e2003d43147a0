// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/contact/face_surface.h>
#include <chaindrive/contact/family.h>
#include <chaindrive/contact/search_cadence.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace chaindrive::contact
{
/// Flat faces of two elastic bodies round a common axis along z, such as those of plates in a
/// joint: nodes of one are slaves, facets of the other masters. One record per pair, with the sum
/// over the faces at z < 0 and z > 0. A pair is evaluated by the rank that owns the slave.
///
/// Only slaves within a radius of the axis take part, where the master's face is a full ring
/// however the two are turned: no node passes its rim.
///
/// A pair is left alone until the gap of the nodes that do not touch may have closed, see
/// holding_time().
class NodeFaces : public Family
{
public:
  /// @p world must outlive this.
  NodeFaces(const scene::FaceFamily &scene, World &world, bool search_every_step);

  /// Makes ghosts in @p world of the masters' nodes whose slaves this rank owns.
  static void want_ghosts(const scene::FaceFamily &scene, World &world);

  void search(const World &, double) override {}
  void announce(World &world, std::optional<double> dt) override;
  void add_forces(World &world, double dt) override;
  void add_springs(const World &, std::vector<Spring> &) const override {}
  bool needs_search() const override { return false; }

  std::vector<ClosedPair> closed_pairs(const World &world) const override;

protected:
  void serialize_pair(unsigned int i, const Archive &archive) override;

private:
  /// Two faces, one opposite the other, of all pairs of the same sides.
  struct Faces
  {
    std::unique_ptr<const MovingFacets> masters, slaves;
    std::vector<unsigned int>           taking_part; ///< slaves near the axis
  };

  /// What pairs of the same sides of the same parts have in common.
  struct SidePair
  {
    unsigned int       master_group, slave_group;     ///< in World::copies
    unsigned int       master_surface, slave_surface; ///< see scene::FacePair
    dealii::Point<3>   master_axis, slave_axis;       ///< likewise
    std::vector<Faces> faces;                         ///< at z < 0 and z > 0
  };

  /// What is kept of a slave.
  struct Node
  {
    TouchState   touch;
    unsigned int facet = MovingFacets::none; ///< that it was above last
  };

  /// One face of one pair of this rank.
  struct FaceContact
  {
    unsigned int                pair, sides, face; ///< in records(), side_pairs_, its faces
    FaceSurface                 surface;           ///< of the master
    std::vector<std::size_t>    slaves;            ///< nodes that take part, see NodeView
    std::vector<Node>           nodes;             ///< likewise
    std::vector<unsigned int>   active;            ///< of these: closer than a reach
    SearchCadence               cadence;           ///< s, of active
    std::array<unsigned int, 2> batches;           ///< of the master and of the slave
    bool                        reads; ///< nodes of both sides, where readers are counted
  };

  /// Whether forces on @p contact can be evaluated only if its nodes are placed.
  bool reads_without_search(const FaceContact &contact) const
  {
    return every_step_ || !contact.active.empty();
  }

  /// From now on nodes of both sides are read, or not.
  void read(World &world, FaceContact &contact, bool reads);

  /// Lists the slaves of @p contact that are closer than a reach.
  void search_nodes(const World &world, FaceContact &contact);

  /// Contact of these, added to the record of their pair.
  void add_face_forces(World &world, FaceContact &contact, double dt);

  std::vector<SidePair>    side_pairs_;
  std::vector<FaceContact> contacts_;
  bool                     every_step_;
};
} // namespace chaindrive::contact
