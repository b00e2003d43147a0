// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/modal_kernels.h>
#include <chaindrive/utilities/simd.h>

namespace chaindrive
{
// Each is made in a file of its own, see there.
extern const ModalKernels scalar_modal_kernels, baseline_modal_kernels;
#ifdef __x86_64__
extern const ModalKernels avx2_modal_kernels, avx512_modal_kernels;
#endif

const ModalKernels *modal_kernels(const int width)
{
  if (!has_simd_width(width))
    return nullptr;
  switch (width)
    {
    case 1:
      return &scalar_modal_kernels;
#ifdef __x86_64__
    case 4:
      return &avx2_modal_kernels;
    case 8:
      return &avx512_modal_kernels;
#endif
    default:
      return &baseline_modal_kernels;
    }
}
} // namespace chaindrive
