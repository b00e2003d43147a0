// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/element/elastic_part.h>
#include <chaindrive/element/hexahedra.h>
#include <chaindrive/mesh/wall_columns.h>

namespace chaindrive::element
{
// A kind of element is chosen here and nowhere else, by the material ids of the part's cells: today
// all cells but those of a rigid zone are hexahedra.
ElasticPart::ElasticPart(const mesh::Part           &part,
                         const mesh::Nodes          &nodes,
                         const Material             &material,
                         const parameters::Elements &elements)
    : masses_(elements.column_mass_scaling > 0. ?
                  ColumnMasses(nodes,
                               mesh::wall_columns(part, nodes, mesh::roller_bore),
                               elements.column_mass_scaling) :
                  ColumnMasses(nodes.mass))
{
  blocks_.push_back(std::make_unique<Hexahedra>(
      part, nodes, material, elements.formulation, elements.hourglass_coefficient));
}

void ElasticPart::add_forces(const BatchState &batch) const
{
  BatchState state = batch; // only the last block fetches what comes after it
  for (const auto &block : blocks_)
    {
      state.n_next = block == blocks_.back() ? batch.n_next : 0;
      block->add_forces(state);
    }
}

double ElasticPart::largest_frequency(const std::vector<double> &springs) const
{
  std::vector<const ElementBlock *> blocks;
  for (const auto &block : blocks_)
    blocks.push_back(block.get());
  return element::largest_frequency(blocks, masses_, springs);
}

std::size_t ElasticPart::memory_consumption() const
{
  std::size_t bytes = masses_.memory_consumption();
  for (const auto &block : blocks_)
    bytes += block->memory_consumption();
  return bytes;
}
} // namespace chaindrive::element
