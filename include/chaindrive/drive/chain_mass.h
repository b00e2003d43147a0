// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/drive.h>

namespace chaindrive::drive
{
/// Solids of the chain of @p drive, which has its dimensions, and their mass per pitch. That is the
/// mass of the chain's table [kg/m] if @p parameters ask for it and it holds for this chain: what
/// the solids lack of it, ends of pins and bushes outside of the plates and rivets, comes to
/// plates, bushes and pins by ChainDimensions::link_density_factor, which a note names. Rollers
/// have none of it, so that impacts are those of the rollers as they are.
void set_chain_mass(const Parameters &parameters, Drive &drive);
} // namespace chaindrive::drive
