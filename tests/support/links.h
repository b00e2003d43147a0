// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Links as section Elements makes them, at rest and at small displacements.

#include "modes.h"

#include <map>
#include <utility>

namespace test
{
/// What plates and bushes are made of, and whether plates bend (Effects/Plate bending).
struct Walls
{
  std::string             name;
  parameters::ElementType plates, bushes;
  bool                    plates_bend;

  parameters::Elements elements() const
  {
    parameters::Elements elements;
    elements.plates = plates;
    elements.bushes = bushes;
    return elements;
  }
};

/// Bricks, solid-shells, what prm/paper/full-shell.prm has, and its membranes let go.
inline const std::array<Walls, 4> kinds_of_walls{
    {{"solid", parameters::ElementType::solid, parameters::ElementType::solid, true},
     {"solid-shell",
      parameters::ElementType::solid_shell,
      parameters::ElementType::solid_shell,
      true},
     {"membrane", parameters::ElementType::membrane, parameters::ElementType::solid_shell, false},
     {"membrane not held",
      parameters::ElementType::membrane,
      parameters::ElementType::solid_shell,
      true}}};

/// The stiffness of the half z >= 0 of a link of the material of section Material, row 3 node +
/// component; its nodes are those of mesh::Nodes. Where plates do not bend, springs a thousand
/// times as stiff as the nodes hold the means of u_z over the columns through them.
inline std::unique_ptr<LinearModel> link_model(const mesh::Part &part, const Walls &walls)
{
  const mesh::Nodes          nodes(part);
  const element::ElasticPart link(part, nodes, Material(), walls.elements());
  auto                       model = std::make_unique<LinearModel>(link, nodes.mass);
  if (walls.plates_bend)
    return model;
  std::map<std::pair<long, long>, std::vector<unsigned int>> columns;
  for (const auto &cell : part.mesh->active_cell_iterators())
    if (cell->material_id() == mesh::inner_plate || cell->material_id() == mesh::outer_plate)
      for (const unsigned int v : cell->vertex_indices())
        {
          const unsigned int node   = nodes.of_vertex[cell->vertex_index(v)];
          auto              &column = columns[{std::lround(1e9 * cell->vertex(v)[0]),
                                               std::lround(1e9 * cell->vertex(v)[1])}];
          if (std::find(column.begin(), column.end(), node) == column.end())
            column.push_back(node);
        }
  for (const auto &[place, column] : columns)
    {
      double total = 0., spring = 0.;
      for (const unsigned int node : column)
        {
          total += nodes.mass[node];
          spring = std::max(spring, 1e3 * model->stiffness.diag_element(3 * node + 2));
        }
      for (const unsigned int a : column)
        for (const unsigned int b : column)
          model->stiffness.add(
              3 * a + 2, 3 * b + 2, spring * nodes.mass[a] * nodes.mass[b] / (total * total));
    }
  return model;
}
} // namespace test
