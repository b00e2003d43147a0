// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/link_kernels.h>
#include <chaindrive/utilities/simd.h>

namespace chaindrive::observe
{
// Each is made in a file of its own, see there.
extern const LinkKernels scalar_link_kernels, baseline_link_kernels, avx2_link_kernels,
    avx512_link_kernels;

const LinkKernels *link_kernels(const int width)
{
  return of_width<LinkKernels>(width,
                               {&scalar_link_kernels,
                                &baseline_link_kernels,
#ifdef __x86_64__
                                &avx2_link_kernels,
                                &avx512_link_kernels
#endif
                               });
}
} // namespace chaindrive::observe
