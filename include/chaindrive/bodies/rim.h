// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/body_batches.h>
#include <chaindrive/mesh/sector.h>

#include <memory>
#include <utility>
#include <vector>

namespace chaindrive
{
/// The elastic rim of a sprocket: copies of one sector round a rigid hub.
///
/// Nodes between two sectors are there twice, each with its own share of the mass; they get the
/// mean of both forces and move alike, as long as what pushes one of them pushes both by half.
/// Nodes that the hub holds follow it; they keep the velocity 0 and have no part in energies and
/// momenta of the rim, but their mass is part of the hub's.
struct Rim
{
  /// Evens out in @p copies, those of @p sector, what round-off makes different between nodes that
  /// are the same.
  Rim(unsigned int                        body,
      unsigned int                        group,
      std::shared_ptr<const mesh::Sector> sector,
      BodyBatches                        &copies);

  /// Finds the nodes between two sectors once the ghosts of @p copies have been made.
  void find_seam(const BodyBatches &copies);

  /// Gives both of two nodes that are one the mean of the forces on them. Where one of them is
  /// another rank's, its half waits on a ghost until NodeExchange::send_forces().
  void even_out_forces(BodyBatches &copies) const;

  /// Places the nodes that the hub holds as the sprocket's @p frame says.
  void fix_to_hub(BodyBatches &copies, const Frame &frame) const;

  unsigned int                        body;
  unsigned int                        group; ///< in World::copies: sector s is copy s
  std::shared_ptr<const mesh::Sector> sector;
  std::vector<unsigned int>           border; ///< nodes of a sector that the hub holds
  double               inertia;  ///< about the axis, of all nodes that the hub does not hold, kg m2
  dealii::Tensor<1, 3> momentum; ///< of the nodes that the hub does not hold, kg m/s

private:
  /// Calls @p visit (copy, node, copy, node) for every two nodes that are one.
  template <typename Visit>
  void for_each_pair(const BodyBatches &copies, const Visit &visit) const;

  /// Indices of two nodes that are one. Of the second kind this rank owns the first node only.
  std::vector<std::pair<std::size_t, std::size_t>> seam_, seam_with_others_;
};
} // namespace chaindrive
