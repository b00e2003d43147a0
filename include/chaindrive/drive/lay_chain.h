// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/drive.h>

namespace chaindrive::drive
{
/// Lays the chain of @p d, which has its parts with their masses and stiffnesses, without load, at
/// rest with its pre-tension, or as it runs, and guides beside it. @p shifts suit a settled start
/// to elastic bodies, see make_drive(). InputError where it cannot be laid.
void lay_chain(const Parameters &parameters, const JointShifts &shifts, Drive &d);
} // namespace chaindrive::drive
