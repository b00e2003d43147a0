// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/reduction/packed_substitution.h>

namespace chaindrive::reduction
{
extern const SubstitutionKernels scalar_substitution_kernels, baseline_substitution_kernels;
const SubstitutionKernels scalar_substitution_kernels   = packed::make_substitution_kernels<1>();
const SubstitutionKernels baseline_substitution_kernels = packed::make_substitution_kernels<2>();
} // namespace chaindrive::reduction
