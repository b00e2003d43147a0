// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/drive.h>
#include <chaindrive/parameters/parameters.h>
#include <chaindrive/statics/library.h>

namespace chaindrive::statics
{
/// How the parts of a drive give way at the reference load, from elastic solutions. What
/// @p parameters give is not computed. Collective over @p comm.
drive::StiffnessOf part_stiffness(const Parameters &parameters, MPI_Comm comm);

/// The contact of @p make (number of patches about the line of pressure) under @p force [N]: with
/// as many patches as it needs.
Pressed at_force(const std::function<Press(unsigned int)> &make, double force);
} // namespace chaindrive::statics
