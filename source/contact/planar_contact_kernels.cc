// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/planar_contact_kernels.h>
#include <chaindrive/utilities/simd.h>

namespace chaindrive::contact
{
// Each is made in a file of its own, see there.
extern const PlanarContactKernels scalar_planar_contact_kernels, baseline_planar_contact_kernels;
#ifdef __x86_64__
extern const PlanarContactKernels avx2_planar_contact_kernels, avx512_planar_contact_kernels;
#endif

const PlanarContactKernels *planar_contact_kernels(const int width)
{
  if (!has_simd_width(width))
    return nullptr;
  switch (width)
    {
    case 1:
      return &scalar_planar_contact_kernels;
#ifdef __x86_64__
    case 4:
      return &avx2_planar_contact_kernels;
    case 8:
      return &avx512_planar_contact_kernels;
#endif
    default:
      return &baseline_planar_contact_kernels;
    }
}
} // namespace chaindrive::contact
