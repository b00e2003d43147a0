// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/joint_kernels.h>
#include <chaindrive/utilities/simd.h>

namespace chaindrive::contact
{
// Each is made in a file of its own, see there.
extern const JointKernels scalar_joint_kernels, baseline_joint_kernels, avx2_joint_kernels,
    avx512_joint_kernels;

const JointKernels *joint_kernels(const int width)
{
  return of_width<JointKernels>(width,
                                {&scalar_joint_kernels,
                                 &baseline_joint_kernels,
#ifdef __x86_64__
                                 &avx2_joint_kernels,
                                 &avx512_joint_kernels
#endif
                                });
}
} // namespace chaindrive::contact
