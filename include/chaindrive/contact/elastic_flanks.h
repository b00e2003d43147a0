// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/contact/rigid_flanks.h>
#include <chaindrive/contact/tributary_area.h>
#include <chaindrive/mesh/surface/surface_nodes.h>

#include <array>
#include <memory>
#include <set>
#include <vector>

namespace chaindrive::contact
{
/// The flanks of a sprocket with an elastic rim: a smooth surface that turns with the hub,
/// displaced by what the nodes of the flank mesh have moved relative to the hub.
///
/// A point X of the hub's frame that is nearest to the surface in the facet of nodes i with the
/// weights w_i has the gap g = d(X - u), with the distance d from the surface and the bilinear
/// displacement u = sum w_i u_i. Forces are the derivatives of g: along the surface's normal tilted
/// by the facet's turn, on the nodes by their weights, and on the hub a couple, since surface and
/// facets do not quite coincide. They cancel to round-off in force and moment.
class ElasticFlanks : public RigidFlanks
{
public:
  Touch project(const World                &world,
                const dealii::Tensor<1, 3> &x,
                double                      radius,
                double                      within,
                unsigned int               &hint,
                Projection                 &projection) const override;

  /// Nodal velocities are the secants of the step.
  dealii::Tensor<1, 3> relative_velocity(const World                &world,
                                         const dealii::Tensor<1, 3> &x,
                                         const Projection           &projection,
                                         const dealii::Tensor<1, 3> &v,
                                         double                      dt) const override;

  void add_opposite(World                      &world,
                    const dealii::Tensor<1, 3> &x,
                    const Touch                &touch,
                    const Projection           &projection,
                    const PointForce           &on_slave) const override;

  /// The gaps between two teeth on whose nodes, or twins, a slave at @p x [m, world] may be
  /// projected, or a node of it that is no farther than @p radius [m] away, also when it has moved
  /// by @p margin [m] from there as the hub sees it.
  std::set<unsigned int>
  gaps_near(const World &world, const dealii::Tensor<1, 3> &x, double radius, double margin) const;

  /// These nodes, of the sectors #group.
  virtual std::vector<BodyBatches::Place> nodes_of_gap(unsigned int gap) const = 0;

  unsigned int group() const { return group_; }

protected:
  ElasticFlanks(const scene::ToothFamily &family, const Rim &rim)
      : RigidFlanks(family), group_(rim.group)
  {
  }

  /// The facet nearest to a point, undeformed and in the hub's frame.
  struct Facet
  {
    bool                                found    = false;
    double                              distance = 0.; ///< of the surface, m
    dealii::Tensor<1, 3>                normal;        ///< unit, outward
    unsigned int                        feature = 0;   ///< see Touch
    std::array<dealii::Tensor<1, 3>, 4> nodes;         ///< m
    /// Of the weights of the nodes while the point moves along the surface, 1/m.
    std::array<dealii::Tensor<1, 3>, 4> gradients;
  };

  /// The facet nearest to @p x [m, in the hub's frame] and no farther than @p within; sets nodes,
  /// twins and weights of @p projection.
  virtual Facet nearest(const dealii::Tensor<1, 3> &x,
                        double                      within,
                        unsigned int               &hint,
                        Projection                 &projection) const = 0;

  /// How far [m] the nodes of the facet nearest to a point of a slave with @p radius [m] may be
  /// from it, beyond the sector of that point: nothing where facets end with sectors.
  virtual double beyond(double /*radius*/) const { return 0.; }

  unsigned int group_; ///< of the sectors in World::copies

private:
  /// Completes @p projection for a slave at @p x [m, world]. Returns the displacements of the nodes
  /// of @p facet relative to the hub, world axes, m.
  std::array<dealii::Tensor<1, 3>, 4> complete(const World                &world,
                                               const dealii::Tensor<1, 3> &x,
                                               const Facet                &facet,
                                               Projection                 &projection) const;
};

/// The largest share of a node of @p side of @p copies, along the axis z.
TributaryArea largest_share(const mesh::SurfaceNodes &side, const BodyBatches &copies);

/// The flanks of the sprocket of @p family: rigid, or elastic where it has a rim.
std::shared_ptr<const Surface> make_flanks(const scene::ToothFamily &family, const World &world);

/// The rollers of @p family on these.
scene::SurfaceFamily on_flanks(const scene::ToothFamily &family, const World &world);
} // namespace chaindrive::contact
