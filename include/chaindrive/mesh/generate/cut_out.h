// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/mesh/part.h>

#include <functional>
#include <vector>

namespace chaindrive::mesh
{
using CellIterator = dealii::Triangulation<3>::active_cell_iterator;

/// Cell number @p i of @p mesh, which has one level only.
inline CellIterator cell_at(const dealii::Triangulation<3> &mesh, const unsigned int i)
{
  return CellIterator(&mesh, 0, static_cast<int>(i));
}

/// The cells @p chosen of @p mesh alone, in this order, with their components and named sides.
/// @p surface_of_cut names a side that was none, from the cell beyond it. Vertices are numbered in
/// the order in which the cells first use them.
std::unique_ptr<dealii::Triangulation<3>>
cut_out(const dealii::Triangulation<3>                     &mesh,
        const std::vector<unsigned int>                    &chosen,
        const std::function<Surface(const CellIterator &)> &surface_of_cut);
} // namespace chaindrive::mesh
