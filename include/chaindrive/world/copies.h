// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/mesh/nodes.h>
#include <chaindrive/scene/scene.h>
#include <chaindrive/utilities/pack.h>

#include <deal.II/base/aligned_vector.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <memory>
#include <vector>

namespace chaindrive
{
/// The state of all elastic bodies of one part. n_lanes copies lie side by side in a batch, in
/// deal.II's distributed vectors numbered [batch][node][component][lane]; lanes without a body hold
/// a copy of the first body at rest, which nothing touches.
///
/// Copy k sits in batch k modulo n_batches: neighbours along the chain lie in the same lane of
/// neighbouring batches, so that the joints of one batch meet one other batch.
class Copies
{
public:
  using Vector = dealii::LinearAlgebra::distributed::Vector<double>;

  /// @p bodies are numbers into @p all, the scene's bodies, all made of @p part.
  Copies(std::shared_ptr<const mesh::Part> part,
         std::vector<unsigned int>         bodies,
         const std::vector<scene::Body>   &all);

  /// The same with copy k placed and moving as @p start[k] says; several may be of one body.
  Copies(std::shared_ptr<const mesh::Part> part,
         std::vector<unsigned int>         bodies,
         std::vector<Frame>                start);

  unsigned int n_nodes() const { return nodes.size(); }
  unsigned int n_copies() const { return static_cast<unsigned int>(bodies.size()); }
  unsigned int n_batches() const { return (n_copies() + n_lanes - 1) / n_lanes; }

  unsigned int batch_of(const unsigned int copy) const { return copy % n_batches(); }
  unsigned int lane_of(const unsigned int copy) const { return copy / n_batches(); }

  /// Numbers in one batch of a vector.
  std::size_t stride() const { return std::size_t(3) * n_nodes() * n_lanes; }

  /// Where the value of @p component at @p node of @p copy stands in the vectors.
  std::size_t
  index(const unsigned int copy, const unsigned int node, const unsigned int component) const
  {
    return batch_of(copy) * stride() + (3 * node + component) * n_lanes + lane_of(copy);
  }

  std::size_t memory_consumption() const;

  std::shared_ptr<const mesh::Part> part;
  mesh::Nodes                       nodes;
  std::vector<unsigned int>         bodies; ///< per copy
  double                            mass;   ///< of one copy: sum of its nodes', kg

  std::vector<Frame> start; ///< per copy, its placement at the start

  Vector position; ///< world axes, m
  Vector velocity; ///< m/s; see element::Elastic for the instant
  Vector force;    ///< of contacts, N
};
} // namespace chaindrive
