// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/facts.h>

#include <iosfwd>

namespace chaindrive::drive
{
/// Draws @p drive as it is laid, as SVG with a millimetre for a unit: teeth and bores of all wheels
/// with their names and the senses of their rotation, rollers and links, the straight spans with
/// the tensions of @p facts, and arrows for what chain and wheels press on their shafts.
void draw(std::ostream &out, const Drive &drive, const Facts &facts);
} // namespace chaindrive::drive
