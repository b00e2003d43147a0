// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/body_batches.h>
#include <chaindrive/bodies/node_exchange.h>
#include <chaindrive/utilities/message_tags.h>
#include <chaindrive/utilities/timing.h>

#include <algorithm>
#include <utility>

namespace chaindrive
{
namespace
{
using Pairs = std::vector<std::pair<unsigned int, unsigned int>>;

/// Calls @p visit (rank, begin, size) for the index ranges @p ranges, each from a begin to an end,
/// which belong to the ranks @p targets, so many indices to each.
template <typename Visit>
void for_each_range(const Pairs &targets, const Pairs &ranges, const Visit &visit)
{
  auto target = targets.begin();
  auto left   = target == targets.end() ? 0 : target->second;
  for (auto [begin, end] : ranges)
    while (begin < end)
      {
        for (; left == 0; left = target->second)
          ++target;
        const unsigned int size = std::min(left, end - begin);
        visit(target->first, begin, size);
        begin += size;
        left -= size;
      }
}
} // namespace

std::size_t NodeExchange::Neighbour::size() const
{
  std::size_t size = 0;
  for (const auto &[group, numbers] : ranges)
    for (const Range &range : numbers)
      size += range.size;
  return size;
}

void NodeExchange::connect(const std::vector<BodyBatches> &copies)
{
  readers_.clear();
  owners_.clear();
  for (unsigned int group = 0; group < copies.size(); ++group)
    if (copies[group].nodes_travel())
      {
        const BodyBatches::Partitioner &travelling = copies[group].travelling();
        const std::size_t               owned      = travelling.locally_owned_size();
        for_each_range(travelling.import_targets(),
                       travelling.import_indices(),
                       [&](unsigned int rank, std::size_t begin, std::size_t size) {
                         readers_[rank].ranges[group].push_back({begin, size});
                       });
        for_each_range(travelling.ghost_targets(),
                       travelling.ghost_indices_within_larger_ghost_set(),
                       [&](unsigned int rank, std::size_t begin, std::size_t size) {
                         owners_[rank].ranges[group].push_back({owned + begin, size});
                       });
      }
}

void NodeExchange::exchange(Neighbours        &from,
                            Neighbours        &to,
                            const unsigned int fields,
                            const int          tag)
{
  requests_.clear();
  const auto begin_all = [&](Neighbours &neighbours, const auto &begin) {
    for (auto &[rank, other] : neighbours)
      {
        requests_.emplace_back();
        const int status = begin(other.message.data(),
                                 int(other.message.size()),
                                 MPI_DOUBLE,
                                 int(rank),
                                 tag,
                                 comm_,
                                 &requests_.back());
        AssertThrowMPI(status);
      }
  };
  for (auto &[rank, other] : to)
    other.message.resize(fields * other.size());
  begin_all(to, MPI_Irecv);
  begin_all(from, MPI_Isend);
  if (requests_.empty()) // on one rank there need be no MPI
    return;
  const Waiting waiting;
  const int     status = MPI_Waitall(int(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE);
  AssertThrowMPI(status);
}

void NodeExchange::fetch(std::vector<BodyBatches> &copies)
{
  for (auto &[rank, reader] : readers_)
    {
      reader.message.clear();
      for (const auto &[group, numbers] : reader.ranges)
        for (const BodyBatches::Vector *vector : {&copies[group].position, &copies[group].velocity})
          for (const Range &range : numbers)
            reader.message.insert(reader.message.end(),
                                  vector->begin() + range.begin,
                                  vector->begin() + range.begin + range.size);
    }
  exchange(readers_, owners_, 2, tag_node_positions);
  for (const auto &[rank, owner] : owners_)
    {
      auto next = owner.message.begin();
      for (const auto &[group, numbers] : owner.ranges)
        for (BodyBatches::Vector *vector : {&copies[group].position, &copies[group].velocity})
          for (const Range &range : numbers)
            {
              std::copy_n(next, range.size, vector->begin() + range.begin);
              next += range.size;
            }
    }
}

void NodeExchange::send_forces(std::vector<BodyBatches> &copies)
{
  for (auto &[rank, owner] : owners_)
    {
      owner.message.clear();
      for (const auto &[group, numbers] : owner.ranges)
        for (const Range &range : numbers)
          {
            double *first = copies[group].force.begin() + range.begin;
            owner.message.insert(owner.message.end(), first, first + range.size);
            std::fill_n(first, range.size, 0.);
          }
    }
  exchange(owners_, readers_, 1, tag_node_forces);
  for (const auto &[rank, reader] : readers_) // in the order of ranks: always the same sum
    {
      auto next = reader.message.begin();
      for (const auto &[group, numbers] : reader.ranges)
        for (const Range &range : numbers)
          for (std::size_t i = 0; i < range.size; ++i)
            copies[group].force.local_element(range.begin + i) += *next++;
    }
}
} // namespace chaindrive
