// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/simd.h>

#include <cstdlib>
#include <string>

namespace chaindrive
{
bool has_simd_width(const int width)
{
  switch (width)
    {
    case 1:
    case 2:
      return true;
#ifdef __x86_64__
    case 4:
      return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
             __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
    case 8:
      return has_simd_width(4) && __builtin_cpu_supports("avx512f") &&
             __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd") &&
             __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
#endif
    default:
      return false;
    }
}

int simd_width()
{
  if (const char *asked = std::getenv("CHAINDRIVE_SIMD_WIDTH"))
    {
      const std::string text  = asked;
      const int         width = text.size() == 1 ? text[0] - '0' : 0;
      if (!has_simd_width(width))
        throw InputError("The environment variable CHAINDRIVE_SIMD_WIDTH is '" + text +
                         "', but this machine has kernels for 1, 2" +
                         (has_simd_width(4) ? ", 4" : "") + (has_simd_width(8) ? ", 8" : "") +
                         " numbers at a time only.");
      return width;
    }
  return has_simd_width(8) ? 8 : has_simd_width(4) ? 4 : 2;
}
} // namespace chaindrive
