// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/outline.h>

#include <string>
#include <vector>

namespace chaindrive::drive
{
/// Writes the solid between z = -width / 2 and width / 2 within the closed @p outline, but for a
/// hole of diameter @p bore about the axis z, as a STEP or STL file in mm, as the end of @p path
/// says. All in m. @p folder is for a file that nobody needs afterwards. Throws InputError where
/// deal.II has no OpenCASCADE, RunError where the file cannot be written.
void write_solid(const std::vector<Segment> &outline,
                 double                      bore,
                 double                      width,
                 const std::string          &path,
                 const std::string          &folder);
} // namespace chaindrive::drive
