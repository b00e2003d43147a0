// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/reduction/symmetry.h>

#include <deal.II/numerics/rtree.h>

#include <boost/geometry/index/predicates.hpp>

#include <stdexcept>

namespace chaindrive::reduction
{
unsigned int Symmetry::image(unsigned int node, const unsigned int g) const
{
  for (unsigned int r = 0; r < axis.size(); ++r)
    if ((g >> r & 1u) != 0)
      node = mirror[r][node];
  return node;
}

unsigned int Symmetry::reflection(const unsigned int d) const
{
  for (unsigned int r = 0; r < axis.size(); ++r)
    if (axis[r] == d)
      return 1u << r;
  return 0;
}

std::vector<unsigned int> mirror_images(const mesh::Nodes &nodes, const unsigned int axis)
{
  namespace index        = boost::geometry::index;
  const auto   tree      = dealii::pack_rtree_of_indices(nodes.position);
  const double tolerance = 1e-6 * dealii::BoundingBox<3>(nodes.position).side_length(0);
  std::vector<unsigned int> images;
  for (dealii::Point<3> at : nodes.position)
    {
      at[axis] = -at[axis];
      for (auto nearest = tree.qbegin(index::nearest(at, 1)); nearest != tree.qend(); ++nearest)
        if (nodes.position[*nearest].distance(at) < tolerance)
          images.push_back(static_cast<unsigned int>(*nearest));
    }
  return images.size() == nodes.size() ? images : std::vector<unsigned int>();
}

Symmetry make_symmetry(const mesh::Nodes &nodes, const std::vector<unsigned int> &axis)
{
  Symmetry symmetry;
  for (const unsigned int a : axis)
    {
      symmetry.axis.push_back(a);
      symmetry.mirror.push_back(mirror_images(nodes, a));
      if (symmetry.mirror.back().empty())
        throw std::logic_error("These nodes are not symmetric.");
    }
  return symmetry;
}
} // namespace chaindrive::reduction
