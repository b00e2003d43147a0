// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/joint_kernels.h>
#include <chaindrive/utilities/simd.h>

namespace chaindrive::contact
{
// Each is made in a file of its own, see there.
extern const JointKernels scalar_joint_kernels, baseline_joint_kernels;
#ifdef __x86_64__
extern const JointKernels avx2_joint_kernels, avx512_joint_kernels;
#endif

const JointKernels *joint_kernels(const int width)
{
  if (!has_simd_width(width))
    return nullptr;
  switch (width)
    {
    case 1:
      return &scalar_joint_kernels;
#ifdef __x86_64__
    case 4:
      return &avx2_joint_kernels;
    case 8:
      return &avx512_joint_kernels;
#endif
    default:
      return &baseline_joint_kernels;
    }
}
} // namespace chaindrive::contact
