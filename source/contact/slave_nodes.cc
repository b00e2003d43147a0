// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/slave_nodes.h>

#include <algorithm>
#include <utility>

namespace chaindrive::contact
{
namespace
{
/// How far the share of each node of a side reaches below and above it along z: half way to the
/// next ring of nodes, m.
std::vector<std::array<double, 2>> extents(const mesh::Nodes               &nodes,
                                           const std::vector<unsigned int> &side)
{
  std::vector<double> rings;
  rings.reserve(side.size());
  for (const unsigned int node : side)
    rings.push_back(nodes.position[node][2]);
  std::sort(rings.begin(), rings.end());
  const double same = 1e-9 * (rings.back() - rings.front());
  rings.erase(std::unique(rings.begin(),
                          rings.end(),
                          [same](const double a, const double b) { return b - a <= same; }),
              rings.end());

  std::vector<std::array<double, 2>> result;
  for (const unsigned int node : side)
    {
      const double z     = nodes.position[node][2];
      const auto   below = std::lower_bound(rings.begin(), rings.end(), z - same);
      const auto   above = std::upper_bound(rings.begin(), rings.end(), z + same);
      result.push_back({{below == rings.begin() ? 0. : 0.5 * (z - *(below - 1)),
                         above == rings.end() ? 0. : 0.5 * (*above - z)}});
    }
  return result;
}
} // namespace

SlaveNodes::SlaveNodes(const World                     &world,
                       const std::vector<unsigned int> &bodies,
                       const unsigned int               surface,
                       const std::vector<unsigned int> &chosen)
    : group_(world.elastic_address[bodies.front()].group), surface_(surface)
{
  const BodyBatches &copies = world.copies[group_];
  auto               side   = std::make_unique<mesh::SurfaceNodes>(
      *copies.part, copies.nodes, static_cast<mesh::Surface>(surface));
  side->keep(chosen);
  extent_ = extents(copies.nodes, side->node);
  side_   = std::move(side);
  for (const unsigned int body : bodies)
    {
      copy_.push_back(world.elastic_address[body].copy);
      first_.push_back(copies.owns(copy_.back()) ? copies.index(copy_.back(), 0) : 0);
    }
}

void SlaveNodes::announce(World &world, const std::vector<unsigned int> &bodies)
{
  BodyBatches &copies = world.copies[group_];
  if (!copies.counts_readers() || bodies == read_)
    return;
  for (const unsigned int body : read_)
    copies.add_readers(copies.batch_of(copy_[body]), side_->node, -1);
  for (const unsigned int body : bodies)
    copies.add_readers(copies.batch_of(copy_[body]), side_->node, 1);
  read_ = bodies;
}

double SlaveNodes::cover(const double z, const double half_width, const unsigned int s) const
{
  const double from = std::max(z - extent_[s][0], -half_width);
  const double to   = std::min(z + extent_[s][1], half_width);
  return std::max(0., to - from) / (extent_[s][0] + extent_[s][1]);
}
} // namespace chaindrive::contact
