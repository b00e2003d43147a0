// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/node_view.h>
#include <chaindrive/bodies/world.h>
#include <chaindrive/mesh/surface/surface_nodes.h>

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace chaindrive::contact
{
/// Nodes of one side of elastic bodies of one part, each of which stands for an area of it. Bodies
/// are numbered in the order given, nodes in that of SurfaceNodes.
class SlaveNodes
{
public:
  /// Of the nodes of the side only those of @p chosen, if any are.
  SlaveNodes(const World                     &world,
             const std::vector<unsigned int> &bodies,
             unsigned int                     surface,
             const std::vector<unsigned int> &chosen = {});

  unsigned int n_bodies() const { return static_cast<unsigned int>(copy_.size()); }
  unsigned int n_nodes() const { return side_->size(); }

  const mesh::SurfaceNodes &side() const { return *side_; }
  unsigned int              surface() const { return surface_; }
  unsigned int              group() const { return group_; } ///< in World::copies
  unsigned int              node(const unsigned int s) const { return side_->node[s]; }
  double                    area(const unsigned int s) const { return side_->area[s]; } ///< m2

  const BodyBatches &batches(const World &world) const { return world.copies[group_]; }
  bool               owns(const World &world, const unsigned int body) const
  {
    return batches(world).owns(copy_[body]);
  }
  unsigned int owner(const World &world, const unsigned int body) const
  {
    return batches(world).owner_of(copy_[body]);
  }

  /// From now on the nodes of these @p bodies of this rank are read, and no others of this.
  void announce(World &world, const std::vector<unsigned int> &bodies);

  /// The part of the area of node @p s that lies between -@p half_width and half_width when the
  /// node is at @p z [m]: 0 ... 1.
  double cover(double z, double half_width, unsigned int s) const;

  /// Position [m, world] and velocity [m/s] of node @p s of @p body, which this rank owns. Nodal
  /// velocities are the secants of the step.
  dealii::Tensor<1, 3>
  position(const World &world, const unsigned int body, const unsigned int s) const
  {
    return NodeView(batches(world).position)[index(body, s)];
  }
  dealii::Tensor<1, 3>
  velocity(const World &world, const unsigned int body, const unsigned int s) const
  {
    return NodeView(batches(world).velocity)[index(body, s)];
  }

  /// Adds the force @p f [N] on the node. That on its body is the caller's to add.
  void add_force(World                      &world,
                 const unsigned int          body,
                 const unsigned int          s,
                 const dealii::Tensor<1, 3> &f) const
  {
    BodyBatches &copies = world.copies[group_];
    NodeView(copies.force).add(index(body, s), f);
    if (char *const pressed = copies.pressed(copies.batch_of(copy_[body])))
      pressed[side_->node[s]] = 1;
  }

private:
  std::size_t index(const unsigned int body, const unsigned int s) const
  {
    return first_[body] + node_offset(side_->node[s]);
  }

  unsigned int                              group_, surface_;
  std::unique_ptr<const mesh::SurfaceNodes> side_;
  std::vector<std::array<double, 2>>        extent_; ///< of the nodes' areas along the axis, m
  std::vector<unsigned int>                 copy_;   ///< per body
  std::vector<std::size_t>                  first_;  ///< per body of this rank: its first node
  std::vector<unsigned int>                 read_;   ///< bodies announced last
};
} // namespace chaindrive::contact
