// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// How the numbers of nodes lie in memory. This header and the kernels
// (element/hexahedron_kernels.h, contact/packed_*.h) know it; everyone else names a node by its
// index and reads it through a view.

#include <chaindrive/utilities/pack.h>

#include <deal.II/base/tensor.h>

#include <cstddef>

namespace chaindrive
{
/// n_lanes bodies lie side by side: [batch][node][component][lane]. The index of a node is where
/// its x component stands; the numbers of one node of all lanes are this many.
constexpr std::size_t numbers_per_node = 3 * n_lanes;

/// From the index of a body's first node to that of its node number @p node.
constexpr std::size_t node_offset(const std::size_t node) { return numbers_per_node * node; }

/// From the index of a node to where its component @p d stands.
constexpr std::size_t component_offset(const unsigned int d) { return d * n_lanes; }

/// One nodal field, such as velocities, seen as one vector per node. The view does not own the
/// numbers. Number is double, or const double to read only.
template <typename Number>
class NodeView
{
public:
  explicit NodeView(Number *numbers) : numbers_(numbers) {}

  /// The field of a deal.II vector: what this rank owns, then its ghosts.
  template <typename Vector>
  explicit NodeView(Vector &vector) : numbers_(vector.begin())
  {
  }

  Number &component(const std::size_t node, const unsigned int d) const
  {
    return numbers_[node + component_offset(d)];
  }

  dealii::Tensor<1, 3> operator[](const std::size_t node) const
  {
    dealii::Tensor<1, 3> v;
    for (unsigned int d = 0; d < 3; ++d)
      v[d] = component(node, d);
    return v;
  }

  void set(const std::size_t node, const dealii::Tensor<1, 3> &v) const
  {
    for (unsigned int d = 0; d < 3; ++d)
      component(node, d) = v[d];
  }

  void add(const std::size_t node, const dealii::Tensor<1, 3> &v) const
  {
    for (unsigned int d = 0; d < 3; ++d)
      component(node, d) += v[d];
  }

  /// The value, which becomes zero.
  dealii::Tensor<1, 3> extract(const std::size_t node) const
  {
    const dealii::Tensor<1, 3> v = (*this)[node];
    set(node, dealii::Tensor<1, 3>());
    return v;
  }

  /// Sets component @p d of a node to zero in all bodies of a batch; @p node is that of lane 0.
  void clear_all_lanes(const std::size_t node, const unsigned int d) const
  {
    for (unsigned int lane = 0; lane < n_lanes; ++lane)
      component(node + lane, d) = 0.;
  }

private:
  Number *numbers_;
};

template <typename Vector>
NodeView(Vector &) -> NodeView<double>;
template <typename Vector>
NodeView(const Vector &) -> NodeView<const double>;
} // namespace chaindrive
