// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/world/copies.h>

#include <numeric>
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

Copies::Copies(std::shared_ptr<const mesh::Part> the_part,
               std::vector<unsigned int>         the_bodies,
               const std::vector<scene::Body>   &all)
    : Copies(std::move(the_part), the_bodies, initial_frames(the_bodies, all))
{
}

Copies::Copies(std::shared_ptr<const mesh::Part> the_part,
               std::vector<unsigned int>         the_bodies,
               std::vector<Frame>                the_start)
    : part(std::move(the_part))
    , nodes(*part)
    , bodies(std::move(the_bodies))
    , mass(std::accumulate(nodes.mass.begin(), nodes.mass.end(), 0.))
    , start(std::move(the_start))
{
  const dealii::IndexSet owned = dealii::complete_index_set(n_batches() * stride());
  for (Vector *vector : {&position, &velocity, &force})
    vector->reinit(owned, MPI_COMM_SELF);

  for (unsigned int slot = 0; slot < n_batches() * n_lanes; ++slot)
    {
      const bool   empty = slot >= n_copies();
      const Frame &frame = start[empty ? 0 : slot];
      for (unsigned int node = 0; node < n_nodes(); ++node)
        {
          const dealii::Tensor<1, 3> arm =
              frame.rotation * dealii::Tensor<1, 3>(nodes.position[node]);
          const dealii::Tensor<1, 3> v =
              frame.velocity + dealii::cross_product_3d(frame.angular_velocity, arm);
          for (unsigned int d = 0; d < 3; ++d)
            {
              const std::size_t i       = index(slot, node, d);
              position.local_element(i) = frame.position[d] + arm[d];
              velocity.local_element(i) = empty ? 0. : v[d];
            }
        }
    }
}

std::size_t Copies::memory_consumption() const
{
  return position.memory_consumption() + velocity.memory_consumption() +
         force.memory_consumption() +
         nodes.size() * (2 * sizeof(unsigned int) + sizeof(dealii::Point<3>) + sizeof(double)) +
         nodes.cells.size() * sizeof(nodes.cells[0]);
}
} // namespace chaindrive
