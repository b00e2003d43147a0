// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/element/element_block.h>
#include <chaindrive/element/selective_masses.h>
#include <chaindrive/parameters/model.h>

#include <memory>
#include <vector>

namespace chaindrive::element
{
/// What all elastic bodies of one part have in common: blocks of elements, one for each kind, and
/// the masses of their nodes.
class ElasticPart
{
public:
  /// @p nodes are those of @p part. Both are read, not kept.
  ElasticPart(const mesh::Part           &part,
              const mesh::Nodes          &nodes,
              const Material             &material,
              const parameters::Elements &elements);

  const std::vector<std::unique_ptr<const ElementBlock>> &blocks() const { return blocks_; }

  /// Masses of its nodes; with Elements/Selective mass scaling, of the columns through a roller's
  /// wall.
  const SelectiveMasses &masses() const { return masses_; }

  /// Adds the internal forces of all blocks to those of one batch.
  void add_forces(const BatchState &batch) const;

  /// Largest natural frequency [rad/s] of the free part at small amplitudes, from above. @p springs
  /// [N/m], if not empty, hold each node in all directions.
  double largest_frequency(const std::vector<double> &springs = {}) const;

  std::size_t memory_consumption() const;

private:
  std::vector<std::unique_ptr<const ElementBlock>> blocks_;
  SelectiveMasses                                  masses_;
};
} // namespace chaindrive::element
