// SPDX-License-Identifier: LGPL-2.1-or-later
// Compiled for this instruction set. No header of a library comes in here: an inline function of it
// could be linked into the program in its widest form.
#include <chaindrive/contact/packed_exact_joint.h>

namespace chaindrive::contact
{
extern const JointKernels avx2_joint_kernels;
const JointKernels        avx2_joint_kernels = packed::make_joint_kernels<4>();
} // namespace chaindrive::contact
