// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/body_batches.h>
#include <chaindrive/utilities/ranks.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <tuple>
#include <utility>

namespace chaindrive
{
namespace
{
std::vector<Frame> initial_frames(const std::vector<unsigned int> &bodies,
                                  const std::vector<scene::Body>  &all)
{
  std::vector<Frame> frames;
  frames.reserve(bodies.size());
  for (const unsigned int body : bodies)
    frames.push_back(all[body].initial);
  return frames;
}
} // namespace

BodyBatches::BodyBatches(std::shared_ptr<const mesh::Part> the_part,
                         const std::vector<unsigned int>  &the_bodies,
                         const std::vector<scene::Body>   &all,
                         std::vector<unsigned int>         first_batch,
                         const MPI_Comm                    comm)
    : BodyBatches(std::move(the_part),
                  the_bodies,
                  initial_frames(the_bodies, all),
                  std::move(first_batch),
                  comm)
{
}

BodyBatches::BodyBatches(std::shared_ptr<const mesh::Part> the_part,
                         std::vector<unsigned int>         the_bodies,
                         std::vector<Frame>                the_start,
                         std::vector<unsigned int>         first_batch,
                         const MPI_Comm                    comm)
    : part(std::move(the_part))
    , nodes(*part)
    , bodies(std::move(the_bodies))
    , mass(std::accumulate(nodes.mass.begin(), nodes.mass.end(), 0.))
    , start(std::move(the_start))
    , comm_(comm)
    , rank_(rank_in(comm))
    , first_batch_(std::move(first_batch))
    , ghosts_(n_batches() * stride())
    , always_(n_batches() * stride())
    , is_shared_(n_batches(), 0)
{
  dealii::IndexSet owned(n_batches() * stride());
  owned.add_range(first_owned_batch() * stride(), end_of_owned_batches() * stride());
  for (Vector *vector : {&position, &velocity, &force})
    vector->reinit(owned, comm_);

  if (part->half)
    for (unsigned int node = 0; node < n_nodes(); ++node)
      if (nodes.position[node][2] == 0.)
        on_middle_plane.push_back(node);

  for (unsigned int slot = 0; slot < n_computed_of(n_copies()); ++slot)
    if (owns(slot))
      {
        const bool   empty = slot >= n_copies();
        const Frame &frame = start[empty ? 0 : slot];
        for (unsigned int node = 0; node < n_nodes(); ++node)
          {
            const dealii::Tensor<1, 3> arm =
                frame.rotation * dealii::Tensor<1, 3>(nodes.position[node]);
            const dealii::Tensor<1, 3> v =
                frame.velocity + dealii::cross_product_3d(frame.angular_velocity, arm);
            const std::size_t at = index(slot, node);
            NodeView(position).set(at, frame.position + arm);
            NodeView(velocity).set(at, empty ? dealii::Tensor<1, 3>() : v);
          }
      }
}

unsigned int BodyBatches::owner_of_batch(const unsigned int batch) const
{
  return static_cast<unsigned int>(
      std::upper_bound(first_batch_.begin(), first_batch_.end(), batch) - first_batch_.begin() - 1);
}

void BodyBatches::want(const unsigned int copy, const std::vector<unsigned int> &wanted)
{
  if (owns(copy))
    return;
  if (counts_readers())
    {
      const std::size_t first = batch_of(copy) * stride();
      ghosts_.add_range(first, first + stride());
      return;
    }
  for (const unsigned int node : wanted)
    {
      const std::size_t first = batch_of(copy) * stride() + node_offset(node);
      always_.add_range(first, first + numbers_per_node);
    }
}

void BodyBatches::may_want(const unsigned int copy, const std::vector<unsigned int> &wanted)
{
  has_more_room_ = true;
  if (owns(copy))
    return;
  for (const unsigned int node : wanted)
    {
      const std::size_t first = batch_of(copy) * stride() + node_offset(node);
      ghosts_.add_range(first, first + numbers_per_node);
    }
}

void BodyBatches::make_ghosts()
{
  if (first_batch_.size() == 2) // one rank
    return;
  ghosts_.add_indices(always_);
  for (Vector *vector : {&position, &velocity, &force})
    {
      Vector with_ghosts(vector->locally_owned_elements(), ghosts_, comm_);
      with_ghosts.copy_locally_owned_data_from(*vector);
      vector->swap(with_ghosts);
    }
  travelling_ = position.get_partitioner();
  if (has_more_room_)
    want_now({});
  if (nodes_travel())
    return;
  std::vector<unsigned int> wanted(n_batches());
  for (unsigned int batch = 0; batch < n_batches(); ++batch)
    wanted[batch] = ghosts_.is_element(batch * stride()) ? 1 : 0;
  dealii::Utilities::MPI::max(wanted, comm_, wanted);
  is_shared_.assign(wanted.begin(), wanted.end());
}

void BodyBatches::want_now(const std::vector<Place> &wanted)
{
  if (first_batch_.size() == 2) // one rank
    return;
  std::vector<std::size_t> numbers;
  for (const auto &[copy, node] : wanted)
    if (!owns(copy))
      for (unsigned int d = 0; d < 3; ++d)
        numbers.push_back(batch_of(copy) * stride() + node_offset(node) + component_offset(d) +
                          lane_of(copy));
  std::sort(numbers.begin(), numbers.end());
  dealii::IndexSet now(always_.size());
  now.add_indices(numbers.begin(), numbers.end());
  now.add_indices(always_);

  const auto partitioner = std::make_shared<Partitioner>(position.locally_owned_elements(), comm_);
  partitioner->set_ghost_indices(now, position.get_partitioner()->ghost_indices());
  travelling_ = partitioner;
  std::fill_n(position.begin() + position.locally_owned_size(),
              position.get_partitioner()->n_ghost_indices(),
              std::numeric_limits<double>::quiet_NaN());
}

void BodyBatches::count_readers()
{
  readers_.assign(std::size_t(n_batches()) * n_nodes(), 0);
  reader_changes_.assign(n_batches(), 0);
  pressed_.assign(readers_.size(), 0);
  moved_by_modes.assign(n_copies(), 0.);
}

void BodyBatches::press(const std::size_t index)
{
  if (!counts_readers())
    return;
  const std::size_t node = index / node_offset(1) + first_owned_batch() * n_nodes(),
                    end  = end_of_owned_batches() * n_nodes();
  if (node < end)
    pressed_[node] = 1;
  else // of another rank: any may be it
    std::fill(pressed_.begin(), pressed_.end(), 1);
}

void BodyBatches::add_readers(const unsigned int               batch,
                              const std::vector<unsigned int> &nodes,
                              const int                        more)
{
  if (!counts_readers())
    return;
  for (const unsigned int node : nodes)
    readers_[batch * n_nodes() + node] += more;
  ++reader_changes_[batch];
}

void BodyBatches::stop_plate_bending()
{
  // columns of one plate: nodes that differ in z only, to a millionth of the part's size
  std::map<std::tuple<bool, long, long>, std::set<unsigned int>> columns;
  for (const auto &cell : part->mesh->active_cell_iterators())
    if (cell->material_id() == mesh::inner_plate || cell->material_id() == mesh::outer_plate)
      for (const unsigned int v : cell->vertex_indices())
        {
          const dealii::Point<3> &x = cell->vertex(v);
          columns[{cell->center()[2] > 0., std::lround(x[0] * 1e9), std::lround(x[1] * 1e9)}]
              .insert(nodes.of_vertex[cell->vertex_index(v)]);
        }
  plate_columns.clear();
  for (const auto &[place, column] : columns)
    plate_columns.emplace_back(column.begin(), column.end());
}

void BodyBatches::hold_nodes(const unsigned int batch)
{
  const NodeView on(force.begin() + start_of(batch));
  for (const unsigned int node : on_middle_plane)
    on.clear_all_lanes(node_offset(node), 2);
  for (const std::vector<unsigned int> &column : plate_columns)
    {
      double total = 0.;
      for (const unsigned int node : column)
        total += nodes.mass[node];
      for (unsigned int lane = 0; lane < n_lanes; ++lane)
        {
          double sum = 0.;
          for (const unsigned int node : column)
            sum += on.component(node_offset(node) + lane, 2);
          for (const unsigned int node : column)
            on.component(node_offset(node) + lane, 2) -= nodes.mass[node] / total * sum;
        }
    }
}

dealii::Tensor<1, 3> BodyBatches::position_now(const unsigned int copy,
                                               const unsigned int node) const
{
  const std::size_t at = index(copy, node);
  return NodeView(position)[at] - ahead * NodeView(velocity)[at];
}

dealii::Tensor<1, 3> BodyBatches::displacement_now(const unsigned int copy,
                                                   const unsigned int node) const
{
  return displacement_to(position_now(copy, node), copy, node);
}

dealii::Tensor<1, 3> BodyBatches::displacement_to(const dealii::Tensor<1, 3> &x,
                                                  const unsigned int          copy,
                                                  const unsigned int          node) const
{
  return x - start[copy].position -
         start[copy].rotation * dealii::Tensor<1, 3>(nodes.position[node]);
}

void BodyBatches::serialize(const Archive &archive)
{
  archive("ahead", ahead);
  for (unsigned int batch = first_owned_batch(); batch < end_of_owned_batches(); ++batch)
    {
      const Archive own = archive.of_this_rank() / ("batch " + std::to_string(batch));
      own.numbers("position", position.begin() + start_of(batch), stride());
      own.numbers("velocity", velocity.begin() + start_of(batch), stride());
    }
  if (archive.reads())
    force = 0.;
}

std::size_t BodyBatches::memory_consumption() const
{
  return position.memory_consumption() + velocity.memory_consumption() +
         force.memory_consumption() +
         nodes.size() * (2 * sizeof(unsigned int) + sizeof(dealii::Point<3>) + sizeof(double)) +
         nodes.cells.size() * sizeof(nodes.cells[0]) + readers_.size() * sizeof(unsigned short) +
         pressed_.size() + reader_changes_.size() * sizeof(unsigned long);
}
} // namespace chaindrive
