// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <initializer_list>

namespace chaindrive
{
/// Whether this machine can run kernels that compute @p width numbers at a time: 1 and 2 anywhere,
/// 4 with AVX2 (x86-64-v3), 8 with AVX-512 (x86-64-v4).
bool has_simd_width(int width);

/// The widest of them, or the one that the environment variable CHAINDRIVE_SIMD_WIDTH asks for.
/// Throws InputError if this machine has none of that width.
int simd_width();

/// Of @p kernels, made to compute 1, 2, 4 and 8 numbers at a time, those that compute @p width;
/// null if this machine has none of that width. Elsewhere than on x86-64 there are the first two
/// only.
template <typename Kernels>
const Kernels *of_width(const int width, const std::initializer_list<const Kernels *> kernels)
{
  if (!has_simd_width(width))
    return nullptr;
  auto chosen = kernels.begin();
  for (int i = 1; i < width; i *= 2)
    ++chosen;
  return *chosen;
}
} // namespace chaindrive
