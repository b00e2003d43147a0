// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/packed_modes.h>
#include <chaindrive/utilities/simd.h>

namespace chaindrive
{
namespace
{
// The same source for each instruction set: what these functions call is inlined into them and so
// takes over their target.
// NOLINTBEGIN(bugprone-macro-parentheses): attributes stand in none
#define CHAINDRIVE_KERNELS(name, width, attributes)                                                \
  attributes void        place_##name(const PlaceArguments &arg) { packed::place<width>(arg); }    \
  attributes void        gather_##name(const GatherArguments &arg) { packed::gather<width>(arg); } \
  constexpr ModalKernels name{width, place_##name, gather_##name};
// NOLINTEND(bugprone-macro-parentheses)

CHAINDRIVE_KERNELS(scalar, 1, )
CHAINDRIVE_KERNELS(baseline, 2, )
#ifdef __x86_64__
CHAINDRIVE_KERNELS(avx2, 4, __attribute__((target("arch=x86-64-v3"))))
CHAINDRIVE_KERNELS(avx512, 8, __attribute__((target("arch=x86-64-v4"))))
#endif
#undef CHAINDRIVE_KERNELS
} // namespace

const ModalKernels *modal_kernels(const int width)
{
  if (!has_simd_width(width))
    return nullptr;
  switch (width)
    {
    case 1:
      return &scalar;
#ifdef __x86_64__
    case 4:
      return &avx2;
    case 8:
      return &avx512;
#endif
    default:
      return &baseline;
    }
}
} // namespace chaindrive
