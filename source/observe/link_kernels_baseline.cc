// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/packed_links.h>

namespace chaindrive::observe
{
extern const LinkKernels scalar_link_kernels, baseline_link_kernels;
const LinkKernels        scalar_link_kernels   = packed::make_link_kernels<1>();
const LinkKernels        baseline_link_kernels = packed::make_link_kernels<2>();
} // namespace chaindrive::observe
