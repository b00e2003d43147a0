// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/planar_contact_kernels.h>
#include <chaindrive/utilities/simd.h>

namespace chaindrive::contact
{
// Each is made in a file of its own, see there.
extern const PlanarContactKernels scalar_planar_contact_kernels, baseline_planar_contact_kernels,
    avx2_planar_contact_kernels, avx512_planar_contact_kernels;

const PlanarContactKernels *planar_contact_kernels(const int width)
{
  return of_width<PlanarContactKernels>(width,
                                        {&scalar_planar_contact_kernels,
                                         &baseline_planar_contact_kernels,
#ifdef __x86_64__
                                         &avx2_planar_contact_kernels,
                                         &avx512_planar_contact_kernels
#endif
                                        });
}
} // namespace chaindrive::contact
