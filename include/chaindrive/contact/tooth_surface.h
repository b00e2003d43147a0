// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/contact/family.h>
#include <chaindrive/mesh/surface_nodes.h>

#include <array>
#include <vector>

namespace chaindrive::contact
{
/// The flanks of a sprocket with an elastic rim: its exact arcs, which turn with the hub, displaced
/// by what the nodes of the flank mesh have moved relative to the hub. Facets form a grid, columns
/// along the profile by layers along the axis.
///
/// A point X of the hub's frame that meets the profile's facet at (xi, eta) has the gap
/// g = d(X - u(xi, eta)) with the distance d from the arcs and the bilinear displacement u of the
/// facet's four nodes. Forces are the derivatives of g: along the arcs' normal tilted by the
/// facet's turn, on the nodes by their weights, and on the hub a couple, since arcs and facets do
/// not quite coincide. They cancel to round-off in force and moment.
class ToothSurface
{
public:
  /// @p rim is that of the sprocket of @p family.
  ToothSurface(const scene::ToothFamily &family, const World &world, const Rim &rim);

  /// Where a point is on the flanks.
  struct Foot
  {
    std::array<std::size_t, 4> nodes{}; ///< places: along the profile first, then the axis
    std::array<double, 4>      weights{};
    dealii::Tensor<1, 3>       displacement; ///< relative to the hub, world axes, m
    dealii::Tensor<1, 3>       arm;          ///< from the mean of the nodes to the point, m
  };

  /// The contact of a slave node at @p x [m, world] and its @p foot. The other arguments are those
  /// of touch_flanks().
  Touch touch(const World                &world,
              const dealii::Tensor<1, 3> &x,
              double                      within,
              unsigned int               &hint,
              Foot                       &foot) const;

  /// Velocity [m/s] of the flank's material there.
  dealii::Tensor<1, 3> velocity(const World &world, const Foot &foot) const;

  /// Adds a force @p f [N] on the flank there.
  void add_force(World &world, const Foot &foot, const dealii::Tensor<1, 3> &f) const;

  /// The flank's nodes on springs of @p stiffness [N/m3] of the @p slaves, nodes of copies @p
  /// of_slaves, wherever these touch. The sum of a hat of half width L at points of spacing a is at
  /// most 9/8 max(L, a) / a.
  ClosedSide closed_side(double                    stiffness,
                         const Copies             &flanks,
                         const mesh::SurfaceNodes &slaves,
                         const Copies             &of_slaves) const;

  unsigned int group() const { return group_; } ///< of the sectors in World::copies

private:
  /// Where the x component of a node stands in the vectors of the copies.
  std::size_t place(const unsigned int sector, const unsigned int c, const unsigned int k) const
  {
    return place_[sector * nodes_.size() + k * angle_.size() + c];
  }

  /// Node of a sector in column @p c and layer @p k of the flanks' nodes.
  unsigned int node(const unsigned int c, const unsigned int k) const
  {
    return nodes_[k * angle_.size() + c];
  }

  const scene::ToothFamily         &family_;
  unsigned int                      group_;  ///< of the sectors in World::copies
  std::vector<unsigned int>         nodes_;  ///< [layer][column]
  std::vector<double>               angle_;  ///< per column, polar, in sector 0, ascending, rad
  std::vector<dealii::Tensor<1, 2>> column_; ///< x and y in sector 0, m
  std::vector<double>               z_;      ///< per layer, ascending, m
  std::vector<std::size_t>          place_;  ///< [sector][layer][column]: of x in the vectors
};
} // namespace chaindrive::contact
