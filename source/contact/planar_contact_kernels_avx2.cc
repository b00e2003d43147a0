// SPDX-License-Identifier: LGPL-2.1-or-later
// Compiled for this instruction set. No header of a library comes in here: an inline function of it
// could be linked into the program in its widest form.
#include <chaindrive/contact/packed_planar_contact.h>

namespace chaindrive::contact
{
extern const PlanarContactKernels avx2_planar_contact_kernels;
const PlanarContactKernels avx2_planar_contact_kernels = packed::make_planar_contact_kernels<4>();
} // namespace chaindrive::contact
