// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/packed_modes.h>

namespace chaindrive
{
extern const ModalKernels scalar_modal_kernels, baseline_modal_kernels;
const ModalKernels        scalar_modal_kernels   = packed::make_modal_kernels<1>();
const ModalKernels        baseline_modal_kernels = packed::make_modal_kernels<2>();
} // namespace chaindrive
