// SPDX-License-Identifier: LGPL-2.1-or-later
// Compiled for this instruction set. No header of a library comes in here: an inline function of it
// could be linked into the program in its widest form.
#include <chaindrive/utilities/packed_complementarity.h>

namespace chaindrive
{
extern const ComplementarityKernels avx2_complementarity_kernels;
const ComplementarityKernels        avx2_complementarity_kernels =
    packed::make_complementarity_kernels<4>();
} // namespace chaindrive
