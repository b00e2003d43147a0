// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/packed_planar.h>

namespace chaindrive
{
extern const PlanarKernels scalar_planar_kernels, baseline_planar_kernels;
const PlanarKernels        scalar_planar_kernels   = packed::make_planar_kernels<1>();
const PlanarKernels        baseline_planar_kernels = packed::make_planar_kernels<2>();
} // namespace chaindrive
