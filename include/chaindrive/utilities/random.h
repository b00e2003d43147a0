// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>
#include <random>

namespace chaindrive
{
/// The next number of @p generator as one from 0 to below 1: its leading 53 bits. A seed means the
/// same numbers on every machine, while the distributions of the standard library differ from one
/// implementation to the next.
inline double even_random(std::mt19937_64 &generator)
{
  return std::ldexp(static_cast<double>(generator() >> 11), -53);
}
} // namespace chaindrive
