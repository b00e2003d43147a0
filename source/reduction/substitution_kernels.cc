// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/reduction/substitution_kernels.h>
#include <chaindrive/utilities/simd.h>

namespace chaindrive::reduction
{
// Each is made in a file of its own, see there.
extern const SubstitutionKernels scalar_substitution_kernels, baseline_substitution_kernels,
    avx2_substitution_kernels, avx512_substitution_kernels;

const SubstitutionKernels *substitution_kernels(const int width)
{
  return of_width<SubstitutionKernels>(width,
                                       {&scalar_substitution_kernels,
                                        &baseline_substitution_kernels,
#ifdef __x86_64__
                                        &avx2_substitution_kernels,
                                        &avx512_substitution_kernels
#endif
                                       });
}
} // namespace chaindrive::reduction
