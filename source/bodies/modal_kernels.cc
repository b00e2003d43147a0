// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/modal_kernels.h>
#include <chaindrive/utilities/simd.h>

namespace chaindrive
{
// Each is made in a file of its own, see there.
extern const ModalKernels scalar_modal_kernels, baseline_modal_kernels, avx2_modal_kernels,
    avx512_modal_kernels;

const ModalKernels *modal_kernels(const int width)
{
  return of_width<ModalKernels>(width,
                                {&scalar_modal_kernels,
                                 &baseline_modal_kernels,
#ifdef __x86_64__
                                 &avx2_modal_kernels,
                                 &avx512_modal_kernels
#endif
                                });
}
} // namespace chaindrive
