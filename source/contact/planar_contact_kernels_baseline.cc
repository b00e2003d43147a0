// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/packed_planar_contact.h>

namespace chaindrive::contact
{
extern const PlanarContactKernels scalar_planar_contact_kernels, baseline_planar_contact_kernels;
const PlanarContactKernels scalar_planar_contact_kernels = packed::make_planar_contact_kernels<1>();
const PlanarContactKernels baseline_planar_contact_kernels =
    packed::make_planar_contact_kernels<2>();
} // namespace chaindrive::contact
