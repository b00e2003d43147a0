// SPDX-License-Identifier: LGPL-2.1-or-later
// Compiled for this instruction set. No header of a library comes in here: an inline function of it
// could be linked into the program in its widest form.
#include <chaindrive/reduction/packed_substitution.h>

namespace chaindrive::reduction
{
extern const SubstitutionKernels avx2_substitution_kernels;
const SubstitutionKernels        avx2_substitution_kernels = packed::make_substitution_kernels<4>();
} // namespace chaindrive::reduction
