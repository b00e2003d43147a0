// SPDX-License-Identifier: LGPL-2.1-or-later
// Compiled for this instruction set. No header of a library comes in here: an inline function of it
// could be linked into the program in its widest form.
#include <chaindrive/bodies/packed_modes.h>

namespace chaindrive
{
extern const ModalKernels avx2_modal_kernels;
const ModalKernels        avx2_modal_kernels = packed::make_modal_kernels<4>();
} // namespace chaindrive
