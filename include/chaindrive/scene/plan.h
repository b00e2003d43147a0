// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/scene/scene.h>

#include <iosfwd>

namespace chaindrive::scene
{
/// Prints who is there, how it moves, what touches what, and every effect with the reason why it is
/// on or off.
void print_plan(std::ostream &out, const Scene &scene);
} // namespace chaindrive::scene
