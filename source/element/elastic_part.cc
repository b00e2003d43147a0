// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/element/elastic_part.h>
#include <chaindrive/element/hexahedra.h>
#include <chaindrive/mesh/thickness_columns.h>

#include <array>

namespace chaindrive::element
{
namespace
{
using Component = dealii::types::material_id;

/// Direction away from the axis of the bush on whose side of x = 0 a point is, in all of a part:
/// its axis is where its vertices have their mean.
std::function<dealii::Tensor<1, 3>(const dealii::Point<3> &)> away_from_axis(const mesh::Part &part)
{
  std::array<double, 2>       sum{};
  std::array<unsigned int, 2> n{};
  for (const auto &cell : part.mesh->active_cell_iterators())
    if (cell->material_id() == mesh::bush)
      {
        const unsigned int side = cell->center()[0] > 0. ? 1 : 0;
        sum[side] += cell->center()[0];
        ++n[side];
      }
  for (const unsigned int side : {0, 1})
    sum[side] /= std::max(1U, n[side]);
  return [sum](const dealii::Point<3> &x) {
    dealii::Tensor<1, 3> away;
    away[0] = x[0] - sum[x[0] > 0. ? 1 : 0];
    away[1] = x[1];
    return away;
  };
}

/// What is to be a block of its own: plates and bushes that are solid-shells or membranes, and
/// solid elements.
std::vector<Selection> selections(const mesh::Part &part, const parameters::Elements &elements)
{
  std::array<bool, mesh::n_components> has{};
  for (const auto &cell : part.mesh->active_cell_iterators())
    has[cell->material_id()] = true;
  const auto element_type_of = [&elements](const Component component) {
    return component == mesh::bush ? elements.bushes :
           component == mesh::inner_plate || component == mesh::outer_plate ?
                                     elements.plates :
                                     parameters::ElementType::solid;
  };
  std::vector<Selection> blocks;
  Selection              solids;
  for (Component component = 0; component < mesh::n_components; ++component)
    if (has[component] && component != mesh::hub_zone)
      {
        const parameters::ElementType element_type = element_type_of(component);
        if (element_type == parameters::ElementType::solid)
          solids.components.push_back(component);
        else if (component == mesh::bush)
          blocks.push_back({{component}, element_type, away_from_axis(part)});
        else
          blocks.push_back({{component}, element_type, [](const dealii::Point<3> &x) {
                              return dealii::Tensor<1, 3>(
                                  dealii::Point<3>(0., 0., x[2] < 0. ? -1. : 1.));
                            }});
      }
  if (!solids.components.empty())
    blocks.insert(blocks.begin(), solids);
  return blocks;
}
} // namespace

// A kind of element is chosen here and nowhere else, by the material ids of the part's cells.
ElasticPart::ElasticPart(const mesh::Part           &part,
                         const mesh::Nodes          &nodes,
                         const Material             &material,
                         const parameters::Elements &elements)
    : masses_(elements.selective_mass_scaling > 0. ?
                  SelectiveMasses(nodes,
                                  mesh::thickness_columns(part, nodes, mesh::roller_bore),
                                  elements.selective_mass_scaling) :
                  SelectiveMasses(nodes.mass))
{
  for (const Selection &selection : selections(part, elements))
    blocks_.push_back(std::make_unique<Hexahedra>(part,
                                                  nodes,
                                                  material,
                                                  static_cast<Formulation>(elements.formulation),
                                                  elements.hourglass_coefficient,
                                                  Shape::symmetric_prism,
                                                  selection));
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
