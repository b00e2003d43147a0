// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/mesh/part.h>

#include <array>

namespace chaindrive::mesh
{
/// Volume [m3] of each component of @p mesh, exact for its trilinear cells.
std::array<double, n_components> component_volumes(const dealii::Triangulation<3> &mesh);

/// Mass and inertia of @p part with its density factors, exact for its trilinear cells; of a half
/// part, of the whole body.
drive::MassProperties meshed_properties(const Part &part);

/// Mass and inertia of the point masses in the vertices when each cell gives its vertices the
/// integrals of their shape functions (row sums of the mass matrix).
drive::MassProperties lumped_properties(const Part &part);

/// Sets the density factors of @p part so that each component with a mass in @p masses [kg] has
/// it, and fills Part::meshed.
void match_masses(Part &part, const std::array<double, n_components> &masses);
} // namespace chaindrive::mesh
