// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/contact/search_cadence.h>
#include <chaindrive/contact/slave_nodes.h>
#include <chaindrive/contact/surface_contact.h>
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
class NodeContact : public SurfaceContact
{
public:
  /// The slaves are bodies of one part.
  NodeContact(const scene::SurfaceFamily &scene, const World &world, bool search_every_step);

  void search(const World &world, double reach) override;
  void add_forces(World &world, double dt) override;
  void add_springs(const World &, std::vector<Spring> &) const override {}

  std::vector<ClosedPair> closed_pairs(const World &world) const override;

  std::optional<unsigned int> deepest_node(unsigned int i) const override;

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

  /// Contact of body @p i with its record.
  void add_body_forces(World &world, unsigned int i, double dt);

  /// Contact of its node @p s, which is due.
  void add_node_force(World               &world,
                      unsigned int         i,
                      unsigned int         s,
                      double               dt,
                      Surface::Projection &projection,
                      Resultant           &sum);

  Node &node(const unsigned int i, const unsigned int s)
  {
    return nodes_[i * slaves_.n_nodes() + s];
  }

  std::shared_ptr<const Surface> surface_;
  SlaveNodes                     slaves_;
  std::vector<unsigned int>      own_;   ///< those near that this rank evaluates
  std::vector<Node>              nodes_; ///< [body][node of the side]
  bool                           every_step_;
  SearchClock                    clock_;
  double                         unforeseen_ = 0.; ///< see unforeseen_speed(), m/s
};
} // namespace chaindrive::contact
