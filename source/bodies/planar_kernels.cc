// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/planar_kernels.h>
#include <chaindrive/utilities/simd.h>

namespace chaindrive
{
// Each is made in a file of its own, see there.
extern const PlanarKernels scalar_planar_kernels, baseline_planar_kernels;
#ifdef __x86_64__
extern const PlanarKernels avx2_planar_kernels, avx512_planar_kernels;
#endif

const PlanarKernels *planar_kernels(const int width)
{
  if (!has_simd_width(width))
    return nullptr;
  switch (width)
    {
    case 1:
      return &scalar_planar_kernels;
#ifdef __x86_64__
    case 4:
      return &avx2_planar_kernels;
    case 8:
      return &avx512_planar_kernels;
#endif
    default:
      return &baseline_planar_kernels;
    }
}
} // namespace chaindrive
