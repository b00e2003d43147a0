// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/element/kernels.h>

#include <chaindrive/utilities/simd.h>

namespace chaindrive::element
{
// Each is made in a file of its own, see there.
extern const Kernels scalar_kernels, baseline_kernels, avx2_kernels, avx512_kernels;

const Kernels *kernels(const int width)
{
  return of_width<Kernels>(width,
                           {&scalar_kernels,
                            &baseline_kernels,
#ifdef __x86_64__
                            &avx2_kernels,
                            &avx512_kernels
#endif
                           });
}

const Kernels &best_kernels() { return *kernels(simd_width()); }
} // namespace chaindrive::element
