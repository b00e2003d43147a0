// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/contact/family.h>
#include <chaindrive/contact/flanks.h>
#include <chaindrive/mesh/surface/facet_surface.h>
#include <chaindrive/mesh/surface/surface_nodes.h>

#include <array>
#include <memory>
#include <vector>

namespace chaindrive::contact
{
/// Elastic rollers on the flanks of a sprocket, rigid or with an elastic rim: every node of a
/// roller's outside is a slave with the stiffness of its share of the surface, or of the part of it
/// that lies over the tooth's width. There is one record per roller, with the sum of its nodes'
/// forces.
///
/// Rollers near the sprocket are found as for rigid ones. A node of theirs that does not touch is
/// left alone until its gap may have closed: at twice the speed that it has relative to the tooth,
/// plus a speed for what bodies do meanwhile (vibration, and impacts that turn them round). A node
/// that is found to touch after it has been left alone is counted as missed.
class NodeTeeth : public Teeth
{
public:
  NodeTeeth(const scene::ToothFamily &scene, const World &world, bool search_every_step);

  void search(const World &world, double reach) override;
  void add_forces(World &world, double dt) override;
  void add_springs(const World &, std::vector<Spring> &) const override {}

  std::vector<ClosedPair> closed_pairs(const World &world) const override;

  std::optional<unsigned int> deepest_node(unsigned int i) const override;

  unsigned long n_missed() const override { return n_missed_; }

  void serialize(const Archive &archive, unsigned int rank) override;

protected:
  void serialize_pair(unsigned int i, const Archive &archive) override;
  bool within_reach(unsigned int i) const override;

private:
  /// The contact of node @p s of slave @p i at @p x [m, world]; @p projection of an elastic rim
  /// only.
  Touch touch(const World                &world,
              unsigned int                i,
              unsigned int                s,
              const dealii::Tensor<1, 3> &x,
              Flanks::Projection         &projection);

  /// Contact of slave @p i with its record.
  void add_roller_forces(World &world, unsigned int i, double dt);

  /// The part of the share of the surface's node number @p s, at @p x, that lies over the
  /// sprocket's width: 0 ... 1.
  double cover(const Frame &hub, const dealii::Tensor<1, 3> &x, unsigned int s) const;

  /// Current position or velocity of the surface's node number @p s of slave @p i.
  dealii::Tensor<1, 3> value(const BodyBatches::Vector &from, unsigned int i, unsigned int s) const;

  /// Velocity [m/s] of the flank at @p x and @p projection.
  dealii::Tensor<1, 3> flank_velocity(const World                &world,
                                      const dealii::Tensor<1, 3> &x,
                                      const Flanks::Projection   &projection,
                                      double                      dt) const;

  /// What is kept of one node of one slave.
  struct Node
  {
    TouchState   touch;
    double       gap     = std::numeric_limits<double>::max(); ///< when it was last visited, m
    double       due     = -1.; ///< when it must be visited again, s; negative: for the first time
    unsigned int hint    = mesh::Projection::no_facet; ///< facet met last
    double       visited = 0.;                         ///< when, s
  };

  Node &node(const unsigned int i, const unsigned int s)
  {
    return nodes_[i * surface_->size() + s];
  }

  unsigned int                              group_; ///< of the rollers in World::copies
  std::unique_ptr<const mesh::SurfaceNodes> surface_;
  std::unique_ptr<const Flanks>             flanks_; ///< of an elastic rim; null: rigid
  std::vector<std::array<double, 2>>        extent_; ///< of the nodes' shares along the axis, m
  std::vector<unsigned int>                 copy_;   ///< per slave
  std::vector<std::size_t>                  first_;  ///< per slave of this rank, in the vectors
  std::vector<unsigned int>                 own_;    ///< those near that this rank owns
  std::vector<Node>                         nodes_;  ///< [slave][node of the surface]
  bool                                      every_step_;
  double        now_ = 0., before_ = 0.; ///< sum of all steps, now and at the last evaluation, s
  double        unforeseen_ = 0.;        ///< see unforeseen_speed(), m/s
  unsigned long n_missed_   = 0;
};
} // namespace chaindrive::contact
