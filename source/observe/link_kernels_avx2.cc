// SPDX-License-Identifier: LGPL-2.1-or-later
// Compiled for this instruction set. No header of a library comes in here: an inline function of it
// could be linked into the program in its widest form.
#include <chaindrive/observe/packed_links.h>

namespace chaindrive::observe
{
extern const LinkKernels avx2_link_kernels;
const LinkKernels        avx2_link_kernels = packed::make_link_kernels<4>();
} // namespace chaindrive::observe
