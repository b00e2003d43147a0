// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/packed_exact_joint.h>

namespace chaindrive::contact
{
extern const JointKernels scalar_joint_kernels, baseline_joint_kernels;
const JointKernels        scalar_joint_kernels   = packed::make_joint_kernels<1>();
const JointKernels        baseline_joint_kernels = packed::make_joint_kernels<2>();
} // namespace chaindrive::contact
