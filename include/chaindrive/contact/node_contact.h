// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/contact/deflection.h>
#include <chaindrive/contact/search_cadence.h>
#include <chaindrive/contact/slave_nodes.h>
#include <chaindrive/contact/surface_contact.h>
#include <chaindrive/mesh/surface/cylinder_grid.h>
#include <chaindrive/mesh/surface/facet_surface.h>

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace chaindrive::contact
{
/// Nodes of elastic bodies on one surface, such as elastic rollers on the flanks of a sprocket:
/// every node of a side is a slave with the stiffness of its area, or of the part of it that lies
/// over the surface's width. There is one record per body, with the sum of its nodes' forces.
///
/// Bodies near the surface are found as for rigid ones. A node of theirs that does not touch is
/// left alone until its gap may have closed, see PointCadence. A node that is found to touch after
/// it has been left alone is counted as missed.
///
/// A rigid surface may deflect under all nodes of a body as a whole, see deflection_under(): what
/// it is made of bends behind the contact. Under each body it does so by itself.
class NodeContact : public SurfaceContact
{
public:
  /// The slaves are bodies of one part.
  NodeContact(const scene::SurfaceFamily &scene, const World &world, bool search_every_step);

  void search(const World &world, double reach) override;
  void announce(World &world, std::optional<double> /*dt*/) override
  {
    slaves_.announce(world, own_);
  }
  void add_forces(World &world, double dt) override;
  void add_springs(const World &, std::vector<Spring> &) const override {}

  std::vector<ClosedPair> closed_pairs(const World &world) const override;

  std::optional<unsigned int> deepest_node(unsigned int i) const override;

  std::vector<unsigned int> own(const World &) const override { return own_; }

  bool knows_pressure() const override { return true; }
  void raise_pressures(std::vector<double> &largest) const override;
  void add_pressures(const World &world, std::vector<NodePressure> &pressures) const override;
  void add_patches(const World &world, std::vector<PressurePatch> &patches) const override;

  void serialize(const Archive &archive, unsigned int rank) override;

protected:
  void serialize_pair(unsigned int i, const Archive &archive) override;
  bool within_reach(unsigned int i) const override;

private:
  /// What is kept of one node of one body.
  struct Node
  {
    TouchState   touch;
    PointCadence cadence;
    double       gap  = std::numeric_limits<double>::max(); ///< when it was last visited, m
    unsigned int hint = mesh::Projection::no_facet;         ///< facet met last
  };

  /// Sums over the nodes of a body.
  struct Resultant
  {
    dealii::Tensor<1, 3> normal;           ///< vector sum of the normal forces, N
    double               normal_force = 0; ///< sum of their sizes, N
    double               power        = 0; ///< of the normal forces, W
  };

  /// Takes over the near bodies that @p rank evaluates.
  void find_own(unsigned int rank);

  /// A node that is due.
  struct Visit
  {
    unsigned int         s; ///< its number
    dealii::Tensor<1, 3> x; ///< where it is, m, world
    scene::ContactLaw    law;
    Touch                touch;
    double               gap;               ///< from the surface where it stands undeflected, m
    double               receding  = 0.;    ///< speed at which the surface deflects, m/s
    bool                 may_touch = false; ///< it lies over the surface's width
  };

  /// Contact of body @p i with its record.
  void add_body_forces(World &world, unsigned int i, double dt);

  /// The same of all its nodes, on a surface that deflects.
  void add_forces_on_deflected(World &world, unsigned int i, double dt, Resultant &sum);

  bool is_due(const unsigned int i, const unsigned int s)
  {
    return every_step_ || node(i, s).cadence.is_due(clock_);
  }

  /// Where node @p s of body @p i is on the surface, which carries it by @p projection.
  Visit visit(const World &world, unsigned int i, unsigned int s, Surface::Projection &projection);

  /// Contact of a node of body @p i.
  void add_node_force(World                     &world,
                      unsigned int               i,
                      const Visit               &visit,
                      double                     dt,
                      const Surface::Projection &projection,
                      Resultant                 &sum);

  Node &node(const unsigned int i, const unsigned int s)
  {
    return nodes_[i * slaves_.n_nodes() + s];
  }

  /// Calls @p visit (body, node of the side, Pa) for all that touch.
  template <typename Visit>
  void for_each_pressure(const Visit &visit) const
  {
    for (const unsigned int i : own_)
      for (unsigned int s = 0; s < slaves_.n_nodes(); ++s)
        if (const double normal = nodes_[i * slaves_.n_nodes() + s].touch.normal; normal > 0.)
          visit(i, s, normal / slaves_.area(s));
  }

  /// The side as a grid, and the number in it of each node of the side.
  struct Round
  {
    mesh::CylinderGrid        grid;
    std::vector<unsigned int> place;
  };

  std::shared_ptr<const Surface> surface_;
  SlaveNodes                     slaves_;
  std::vector<unsigned int>      own_;   ///< those near that this rank evaluates
  std::vector<Node>              nodes_; ///< [body][node of the side]
  bool                           every_step_;
  SearchClock                    clock_;
  double                         unforeseen_ = 0.; ///< see unforeseen_speed(), m/s

  double                   surface_stiffness_; ///< see scene::SurfaceFamily, N/m
  double                   half_angle_;        ///< see scene::SurfaceFamily, rad
  std::vector<Visit>       visits_;            ///< of one body, on a surface that deflects
  std::vector<SpringPoint> penetrating_;       ///< nodes of it

  mutable std::unique_ptr<const Round> round_; ///< when first asked for
};
} // namespace chaindrive::contact
