// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/mpi.h>

#include <cstddef>
#include <map>
#include <vector>

namespace chaindrive
{
class BodyBatches;

/// What ranks tell each other in a step of the nodes of elastic bodies: one message to every rank
/// that reads some of this rank's, with their positions and velocities in all groups of copies, and
/// one back, with the forces on them.
class NodeExchange
{
public:
  explicit NodeExchange(MPI_Comm comm) : comm_(comm) {}

  /// Finds out what travels between the @p copies: to be called when their ghosts have been made,
  /// and when BodyBatches::want_now() has changed what is wanted.
  void connect(const std::vector<BodyBatches> &copies);

  /// Fetches positions and velocities of ghosts. Collective.
  void fetch(std::vector<BodyBatches> &copies);

  /// Adds the forces on ghosts to those of their owners; ghosts have none afterwards. Collective.
  void send_forces(std::vector<BodyBatches> &copies);

private:
  /// Numbers that lie one after the other in this rank's share of the vectors.
  struct Range
  {
    std::size_t begin, size;
  };

  /// Another rank and the numbers that it shares with this one.
  struct Neighbour
  {
    std::map<unsigned int, std::vector<Range>> ranges; ///< by group of copies
    std::vector<double>                        message;

    std::size_t size() const;
  };
  using Neighbours = std::map<unsigned int, Neighbour>; ///< by rank

  /// Sends the messages of @p from, and takes those of @p to, each so many numbers for one shared
  /// one.
  void exchange(Neighbours &from, Neighbours &to, unsigned int fields, int tag);

  MPI_Comm                 comm_;
  Neighbours               readers_; ///< of this rank's nodes
  Neighbours               owners_;  ///< of its ghosts
  std::vector<MPI_Request> requests_;
};
} // namespace chaindrive
