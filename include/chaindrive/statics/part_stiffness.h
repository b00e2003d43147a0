// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/drive.h>
#include <chaindrive/model/model.h>
#include <chaindrive/statics/library.h>

#include <optional>
#include <string>
#include <vector>

namespace chaindrive::statics
{
/// How the parts of a drive of @p steel deflect at the reference load: what is @p wanted from
/// elastic solutions, all else estimated; empty if nothing is. @p announce is told of each part
/// before it is solved. Collective over @p comm.
drive::StiffnessOf part_stiffness(const std::optional<model::PartStiffnesses> &wanted,
                                  const Material                              &steel,
                                  MPI_Comm                                     comm,
                                  const Announce                              &announce = {});

/// The same at once: from the cache if all that is wanted is there, else estimated, which a note
/// says. Not collective.
drive::StiffnessOf quick_part_stiffness(const std::optional<model::PartStiffnesses> &wanted,
                                        const Material                              &steel);

/// Whether one of the @p notes of a drive says that quick_part_stiffness() has estimated.
bool is_estimated(const std::vector<std::string> &notes);

/// The contact of @p make (number of patches about the line of pressure) under @p force [N]: with
/// as many patches as it needs.
ContactSolution at_force(const std::function<ContactProblem(unsigned int)> &make, double force);
} // namespace chaindrive::statics
