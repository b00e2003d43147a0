// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace chaindrive
{
/// Whether this machine can run kernels that compute @p width numbers at a time: 1 and 2 anywhere,
/// 4 with AVX2 (x86-64-v3), 8 with AVX-512 (x86-64-v4).
bool has_simd_width(int width);

/// The widest of them, or the one that the environment variable CHAINDRIVE_SIMD_WIDTH asks for.
/// Throws InputError if this machine has none of that width.
int simd_width();
} // namespace chaindrive
