// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/utilities/packed_complementarity.h>

namespace chaindrive
{
extern const ComplementarityKernels scalar_complementarity_kernels,
    baseline_complementarity_kernels;
const ComplementarityKernels scalar_complementarity_kernels =
    packed::make_complementarity_kernels<1>();
const ComplementarityKernels baseline_complementarity_kernels =
    packed::make_complementarity_kernels<2>();
} // namespace chaindrive
