// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/element/hexahedron_kernels.h>

namespace chaindrive::element
{
extern const Kernels scalar_kernels, baseline_kernels;
const Kernels        scalar_kernels   = packed::make_kernels<1>("scalar");
const Kernels        baseline_kernels = packed::make_kernels<2>("baseline (SSE2 on x86-64)");
} // namespace chaindrive::element
