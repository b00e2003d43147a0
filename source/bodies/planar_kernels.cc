// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/planar_kernels.h>
#include <chaindrive/utilities/simd.h>

namespace chaindrive
{
// Each is made in a file of its own, see there.
extern const PlanarKernels scalar_planar_kernels, baseline_planar_kernels, avx2_planar_kernels,
    avx512_planar_kernels;

const PlanarKernels *planar_kernels(const int width)
{
  return of_width<PlanarKernels>(width,
                                 {&scalar_planar_kernels,
                                  &baseline_planar_kernels,
#ifdef __x86_64__
                                  &avx2_planar_kernels,
                                  &avx512_planar_kernels
#endif
                                 });
}
} // namespace chaindrive
