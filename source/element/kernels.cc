// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/element/kernels.h>

#include <chaindrive/utilities/simd.h>

namespace chaindrive::element
{
// Each is made in a file of its own, see there.
extern const Kernels scalar_kernels, baseline_kernels;
#ifdef __x86_64__
extern const Kernels avx2_kernels, avx512_kernels;
#endif

const Kernels *kernels(const int width)
{
  if (!has_simd_width(width))
    return nullptr;
  switch (width)
    {
    case 1:
      return &scalar_kernels;
#ifdef __x86_64__
    case 4:
      return &avx2_kernels;
    case 8:
      return &avx512_kernels;
#endif
    default:
      return &baseline_kernels;
    }
}

const Kernels &best_kernels() { return *kernels(simd_width()); }
} // namespace chaindrive::element
