// SPDX-License-Identifier: LGPL-2.1-or-later
// Compiled for this instruction set. No header of a library comes in here: an inline function of it
// could be linked into the program in its widest form.
#include <chaindrive/element/hexahedron_kernels.h>

namespace chaindrive::element
{
extern const Kernels avx512_kernels;
const Kernels        avx512_kernels = packed::make_kernels<8>("AVX-512 (x86-64-v4)");
} // namespace chaindrive::element
