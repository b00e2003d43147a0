// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/node_view.h>
#include <chaindrive/mesh/nodes.h>
#include <chaindrive/scene/scene.h>
#include <chaindrive/utilities/archive.h>
#include <chaindrive/utilities/pack.h>

#include <deal.II/base/index_set.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <array>
#include <memory>
#include <vector>

namespace chaindrive
{
/// The ranks that evaluate the joints at the first and at the second end of a link.
using JointRanks = std::array<unsigned int, 2>;

/// The state of all elastic bodies of one part. n_lanes copies lie side by side in a batch, in
/// deal.II's distributed vectors numbered [batch][node][component][lane]; lanes without a body hold
/// a copy of the first body at rest, which nothing touches.
///
/// Copy k sits in batch k modulo n_batches. Copies of elastic bodies are in the order of the chain:
/// neighbours lie in the same lane of neighbouring batches, so that the joints of one batch meet
/// one other batch. Those of reduced bodies are in an order that makes neighbours lie in one batch.
///
/// Whole batches are distributed over the ranks. A rank sees of the batches of others the nodes
/// that it asked for, as ghosts: their positions and velocities come and forces that it adds to
/// them go home by NodeExchange. Ghosts that it may want have room, but travel only while it wants
/// them. Nodes of reduced bodies do not travel: batches whose nodes several ranks touch are shared,
/// which is that all ranks know their motion, and each rank places for itself the nodes that it
/// reads.
class BodyBatches
{
public:
  using Vector      = dealii::LinearAlgebra::distributed::Vector<double>;
  using Partitioner = dealii::Utilities::MPI::Partitioner;

  /// @p bodies are numbers into @p all, the scene's bodies, all made of @p part. Rank r of @p comm
  /// owns the batches from @p first_batch[r] up to first_batch[r + 1].
  BodyBatches(std::shared_ptr<const mesh::Part> part,
              const std::vector<unsigned int>  &bodies,
              const std::vector<scene::Body>   &all,
              std::vector<unsigned int>         first_batch,
              MPI_Comm                          comm);

  /// The same with copy k placed and moving as @p start[k] says; several may be of one body.
  BodyBatches(std::shared_ptr<const mesh::Part> part,
              std::vector<unsigned int>         bodies,
              std::vector<Frame>                start,
              std::vector<unsigned int>         first_batch,
              MPI_Comm                          comm);

  unsigned int n_nodes() const { return nodes.size(); }
  unsigned int n_copies() const { return static_cast<unsigned int>(bodies.size()); }
  unsigned int n_batches() const { return n_batches_of(n_copies()); }

  static unsigned int n_batches_of(const std::size_t n_copies)
  {
    return chaindrive::n_batches_of(n_copies);
  }

  unsigned int batch_of(const unsigned int copy) const { return copy % n_batches(); }
  unsigned int lane_of(const unsigned int copy) const { return copy / n_batches(); }

  unsigned int owner_of_batch(unsigned int batch) const; ///< rank
  unsigned int owner_of(const unsigned int copy) const { return owner_of_batch(batch_of(copy)); }
  bool         owns(const unsigned int copy) const { return owner_of(copy) == rank_; }

  bool owns_batch(const unsigned int batch) const
  {
    return batch >= first_owned_batch() && batch < end_of_owned_batches();
  }

  /// Whether several ranks touch nodes of @p batch, whose bodies are reduced.
  bool is_shared(const unsigned int batch) const { return is_shared_[batch] != 0; }

  /// Whether all nodes of @p batch are in this rank's share of the vectors.
  bool has_nodes(const unsigned int batch) const
  {
    return owns_batch(batch) || (counts_readers() && ghosts_.is_element(batch * stride()));
  }

  unsigned int first_owned_batch() const { return first_batch_[rank_]; }
  unsigned int end_of_owned_batches() const { return first_batch_[rank_ + 1]; }

  /// Numbers in one batch of a vector.
  std::size_t stride() const { return node_offset(n_nodes()); }

  /// Where the numbers of a batch that has_nodes() begin in this rank's share of the vectors.
  std::size_t start_of(const unsigned int batch) const
  {
    return owns_batch(batch) ?
               (batch - first_owned_batch()) * stride() :
               position.get_partitioner()->global_to_local(std::size_t(batch) * stride());
  }

  /// The index, for a NodeView, of @p node of @p copy in this rank's share of the vectors; the copy
  /// must be owned, or the node be a ghost.
  std::size_t index(const unsigned int copy, const unsigned int node) const
  {
    const unsigned int batch  = batch_of(copy);
    const std::size_t  within = node_offset(node) + lane_of(copy);
    if (owns_batch(batch))
      return start_of(batch) + within;
    return position.get_partitioner()->global_to_local(batch * stride() + within);
  }

  /// Calls @p visit (copy, lane) for the bodies in @p batch.
  template <typename Visit>
  void for_each_copy_of(const unsigned int batch, const Visit &visit) const
  {
    for (unsigned int copy = batch; copy < n_copies(); copy += n_batches())
      visit(copy, lane_of(copy));
  }

  /// From now on the columns of nodes through the part's plates stay in place along z in the mean:
  /// plates do not bend out of their planes, but may become thinner.
  void stop_plate_bending();

  /// Takes the forces along z from the nodes of a half part that stay in its middle plane, and of
  /// columns that stay what would accelerate their centre of mass. Neither does work.
  void hold_nodes(unsigned int batch);

  /// Position, and displacement since the start [m], at the present instant.
  dealii::Tensor<1, 3> position_now(unsigned int copy, unsigned int node) const;
  dealii::Tensor<1, 3> displacement_now(unsigned int copy, unsigned int node) const;

  /// Displacement of a node since the start [m] when it is at @p x [m].
  dealii::Tensor<1, 3>
  displacement_to(const dealii::Tensor<1, 3> &x, unsigned int copy, unsigned int node) const;

  /// Makes ghosts of these nodes of the batch that holds @p copy, of all its nodes if its bodies
  /// are reduced, unless this rank owns it. To be followed by make_ghosts().
  void want(unsigned int copy, const std::vector<unsigned int> &wanted);

  /// The same for nodes that travel only while want_now() asks for them. To be called by all ranks.
  void may_want(unsigned int copy, const std::vector<unsigned int> &wanted);

  /// Gives the vectors room for all ghosts that any rank wants, and finds out which batches are
  /// shared. Collective.
  void make_ghosts();

  /// A node of one copy.
  struct Place
  {
    unsigned int copy, node;
  };

  /// Of the nodes that it may want, this rank wants these from now on. Ghosts are not numbers until
  /// they are fetched: who reads others all the same does not go unnoticed. To be followed by
  /// NodeExchange::connect(). Collective.
  void want_now(const std::vector<Place> &wanted);

  /// Whether ghosts come and go by messages, and which of them do now.
  bool               nodes_travel() const { return first_batch_.size() > 2 && !counts_readers(); }
  const Partitioner &travelling() const { return *travelling_; }

  /// Of reduced bodies: from now on counts who reads which nodes on this rank. Nodes that nobody
  /// reads need not be placed. To be called before want().
  void count_readers();
  bool counts_readers() const { return !readers_.empty(); }

  /// So many more, or fewer, read the @p nodes of @p batch on this rank.
  void add_readers(unsigned int batch, const std::vector<unsigned int> &nodes, int more);

  bool is_read(const unsigned int batch, const unsigned int node) const
  {
    return readers_[batch * n_nodes() + node] > 0;
  }

  /// Of bodies whose readers are counted, 1 for each node of @p batch that may have a force in any
  /// lane: whoever adds one says so here, and who uses forces up takes it back. Null for others.
  char *pressed(const unsigned int batch)
  {
    return counts_readers() ? pressed_.data() + std::size_t(batch) * n_nodes() : nullptr;
  }

  /// The same of one node at the @p index of a NodeView, whose batch nobody knows; nothing where
  /// readers are not counted.
  void press(std::size_t index);

  /// How often readers of @p batch have come or gone.
  unsigned long reader_changes(const unsigned int batch) const { return reader_changes_[batch]; }

  /// The state between two steps, batch by batch: forces are then used up.
  void serialize(const Archive &archive);

  std::size_t memory_consumption() const;

  std::shared_ptr<const mesh::Part> part;
  mesh::Nodes                       nodes;
  std::vector<unsigned int>         bodies; ///< per copy
  double                            mass;   ///< of one copy: sum of its nodes', kg

  std::vector<unsigned int> on_middle_plane; ///< nodes of a half part that stay at z = 0

  std::vector<std::vector<unsigned int>> plate_columns; ///< of nodes, that stay; empty: none

  std::vector<Frame> start; ///< per copy, its placement at the start

  /// Per copy of reduced bodies, of joints with bores of these; empty: the owner does. Of a roller
  /// both are the same.
  std::vector<JointRanks> joint_ranks;

  Vector position; ///< world axes, m; see ElasticBodies for the instants
  Vector velocity; ///< m/s
  Vector force;    ///< of contacts, N

  /// Of reduced bodies, per copy: the most that modes can have moved a node that touches something
  /// in the last drift, m.
  std::vector<double> moved_by_modes;

  /// Of reduced bodies, what their modes do: numbers of others, which are where the last drift has
  /// left them.
  struct Modes
  {
    unsigned int  n         = 0;
    const double *amplitude = nullptr; ///< [batch][mode][lane], m sqrt(kg)
    const double *farthest  = nullptr; ///< [mode], the most that it moves a node that touches
                                       ///< something, 1/sqrt(kg)

    /// The amplitude of @p mode of the body in @p lane of @p batch.
    double of(const unsigned int batch, const unsigned int mode, const unsigned int lane) const
    {
      return amplitude[(std::size_t(batch) * n + mode) * n_lanes + lane];
    }
  };
  Modes modes;

  /// By how much positions are ahead of the present instant, s: they have moved on from it with the
  /// velocities.
  double ahead = 0.;

private:
  MPI_Comm                  comm_;
  unsigned int              rank_;
  std::vector<unsigned int> first_batch_;           ///< per rank, and their number
  dealii::IndexSet          ghosts_;                ///< all that have room
  dealii::IndexSet          always_;                ///< those that always travel
  bool                      has_more_room_ = false; ///< there are others

  std::shared_ptr<const Partitioner> travelling_;

  std::vector<char> is_shared_; ///< [batch]

  std::vector<unsigned short> readers_;        ///< [batch][node]; empty: not counted
  std::vector<unsigned long>  reader_changes_; ///< [batch]
  std::vector<char>           pressed_;        ///< [batch][node]
};
} // namespace chaindrive
