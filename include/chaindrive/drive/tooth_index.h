// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/parameters/drive.h>

#include <string>
#include <vector>

namespace chaindrive::drive
{
/// Index deviations of the tooth gaps of @p wheel, as ISO 1328-1 calls them: by how much each
/// stands off its place along the pitch circle, counter-clockwise, from gap 0 on. m. Empty where
/// all stand in their places.
///
/// They are listed, or random: evenly distributed between plus and minus the tolerance, gap by gap
/// from a Mersenne twister, so that a seed means one wheel of so many teeth on every machine.
///
/// @throws InputError, naming the entry, when a list does not go into the number of teeth, stands
/// beside a tolerance, or is for a wheel whose teeth come from a mesh.
std::vector<double> index_deviations(const parameters::Sprocket &wheel);

/// What there is to say of the @p deviations [m], not empty, of the wheel called @p title: a
/// sentence with their range and with the largest difference of neighbours, which is the deviation
/// of a single pitch.
std::string in_words(const std::string &title, const std::vector<double> &deviations);
} // namespace chaindrive::drive
