// SPDX-License-Identifier: LGPL-2.1-or-later
// Compiled for this instruction set. No header of a library comes in here: an inline function of it
// could be linked into the program in its widest form.
#include <chaindrive/bodies/packed_planar.h>

namespace chaindrive
{
extern const PlanarKernels avx512_planar_kernels;
const PlanarKernels        avx512_planar_kernels = packed::make_planar_kernels<8>();
} // namespace chaindrive
