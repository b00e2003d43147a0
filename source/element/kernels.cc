// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/element/hexahedron_kernels.h>

#include <chaindrive/utilities/errors.h>

#include <cstdlib>
#include <string>

namespace chaindrive::element
{
namespace
{
// The same source for each instruction set: what these functions call is inlined into them and so
// takes over their target.
#define CHAINDRIVE_KERNELS(name, title, width, attributes)                                         \
  template <Formulation formulation>                                                               \
  attributes void forces_##name(const ForceArguments &arg)                                         \
  {                                                                                                \
    bodies::add_internal_forces<width, formulation>(arg);                                          \
  }                                                                                                \
  attributes void   update_##name(const UpdateArguments &arg) { bodies::update<width>(arg); }      \
  constexpr Kernels name{title,                                                                    \
                         width,                                                                    \
                         {forces_##name<Formulation::one_point>,                                   \
                          forces_##name<Formulation::enhanced>,                                    \
                          forces_##name<Formulation::full>},                                       \
                         update_##name};

CHAINDRIVE_KERNELS(scalar, "scalar", 1, )
CHAINDRIVE_KERNELS(baseline, "baseline (SSE2 on x86-64)", 2, )
#ifdef __x86_64__
CHAINDRIVE_KERNELS(avx2, "AVX2 (x86-64-v3)", 4, __attribute__((target("arch=x86-64-v3"))))
CHAINDRIVE_KERNELS(avx512, "AVX-512 (x86-64-v4)", 8, __attribute__((target("arch=x86-64-v4"))))
#endif
#undef CHAINDRIVE_KERNELS
} // namespace

const Kernels *kernels(const int width)
{
  switch (width)
    {
    case 1:
      return &scalar;
    case 2:
      return &baseline;
#ifdef __x86_64__
    case 4:
      return __builtin_cpu_supports("x86-64-v3") ? &avx2 : nullptr;
    case 8:
      return __builtin_cpu_supports("x86-64-v4") ? &avx512 : nullptr;
#endif
    default:
      return nullptr;
    }
}

const Kernels &best_kernels()
{
  if (const char *asked = std::getenv("CHAINDRIVE_SIMD_WIDTH"))
    {
      const std::string text = asked;
      const Kernels    *found =
          text.size() == 1 && text[0] >= '1' && text[0] <= '8' ? kernels(text[0] - '0') : nullptr;
      if (found == nullptr)
        throw InputError("The environment variable CHAINDRIVE_SIMD_WIDTH is '" + text +
                         "', but this machine has kernels for 1, 2" +
                         (kernels(4) != nullptr ? ", 4" : "") +
                         (kernels(8) != nullptr ? ", 8" : "") + " numbers at a time only.");
      return *found;
    }
  for (const int width : {8, 4})
    if (const Kernels *found = kernels(width))
      return *found;
  return baseline;
}
} // namespace chaindrive::element
