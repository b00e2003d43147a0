// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/drive.h>
#include <chaindrive/model/effects.h>
#include <chaindrive/parameters/parameters.h>

#include <string>
#include <vector>

namespace chaindrive::model
{
/// Per joint, whether its roller and bush are elastic in an elastic model: all of them, or for
/// Model/Elastic links = region of interest those that reach the driver in Output's window, from
/// the first bush of an inner link to the second one of another; says so in @p notes. InputError
/// when these are the whole chain.
std::vector<char> elastic_joints(const Parameters         &parameters,
                                 const drive::Drive       &drive,
                                 const Effects            &effects,
                                 std::vector<std::string> &notes);
} // namespace chaindrive::model
