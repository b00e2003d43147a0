// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/contact/family.h>
#include <chaindrive/contact/tooth_surface.h>
#include <chaindrive/mesh/surface_nodes.h>

#include <array>
#include <memory>
#include <vector>

namespace chaindrive::contact
{
/// Elastic rollers on the exact arcs of a sprocket, rigid or with an elastic rim: every node of a
/// roller's outside is a slave with the stiffness of its share of the surface, or of the part of it
/// that lies over the tooth's width. There is one record per roller, with the sum of its nodes'
/// forces.
///
/// Rollers near the sprocket are found as for rigid ones. Of their nodes only those closer to a
/// flank than a reach are visited; the list is made anew before the nodes can have come nearer by
/// that reach, and a node that touches without having been on it is counted as missed.
class NodeTeeth : public Teeth
{
public:
  NodeTeeth(const scene::ToothFamily &scene, const World &world, bool search_every_step);

  void   search(const World &world, double reach) override;
  void   add_forces(World &world, double dt) override;
  void   add_springs(const World &, std::vector<Spring> &) const override {}
  double largest_node_eigenvalue(const World &world) const override;

  std::vector<unsigned int> node_groups() const override;

  unsigned long n_missed() const override { return n_missed_; }

  void exchange(const Archive &archive, unsigned int rank) override;

protected:
  void exchange_pair(unsigned int i, const Archive &archive) override;
  bool within_reach(unsigned int i) const override;

private:
  /// Lists the nodes within reach of each roller that is near.
  void search_nodes(const World &world);

  /// The contact of node @p s of slave @p i at @p x [m, world]; @p foot of an elastic rim only.
  Touch touch(const World                &world,
              unsigned int                i,
              unsigned int                s,
              const dealii::Tensor<1, 3> &x,
              ToothSurface::Foot         &foot);

  /// Contact of slave @p i with its record.
  void add_roller_forces(World &world, unsigned int i, double dt);

  /// The part of the share of the surface's node number @p s, at @p x, that lies over the
  /// sprocket's width: 0 ... 1.
  double cover(const Frame &hub, const dealii::Tensor<1, 3> &x, unsigned int s) const;

  /// Current position or velocity of the surface's node number @p s of slave @p i.
  dealii::Tensor<1, 3>
  value(const World &world, const Copies::Vector &from, unsigned int i, unsigned int s) const;

  TouchState &state(const unsigned int i, const unsigned int s)
  {
    return node_states_[i * surface_->size() + s];
  }

  unsigned int &hint(const unsigned int i, const unsigned int s)
  {
    return hints_[i * surface_->size() + s];
  }

  unsigned int                              group_; ///< of the rollers in World::copies
  std::unique_ptr<const mesh::SurfaceNodes> surface_;
  std::unique_ptr<const ToothSurface>       flanks_; ///< of an elastic rim; null: rigid
  std::vector<std::array<double, 2>>        extent_; ///< of the nodes' shares along the axis, m
  std::vector<unsigned int>                 copy_;   ///< per slave
  std::vector<unsigned int>                 own_;    ///< those near that this rank owns
  std::vector<TouchState>                   node_states_; ///< [slave][node of the surface]
  std::vector<unsigned int>                 hints_;       ///< [slave][node]: facet met last
  std::vector<std::vector<unsigned int>>    active_;      ///< per slave: nodes of the surface
  bool                                      every_step_;
  double                                    approach_ = 0.; ///< since the nodes' search, m
  unsigned long                             n_missed_ = 0;
};
} // namespace chaindrive::contact
