// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace chaindrive
{
/// What a message from rank to rank is about: its tag, one for each kind, since messages of several
/// kinds may be on their way at once.
enum MessageTag : int
{
  tag_sum = 1, ///< of two ranks, at every step
  tag_contact_records,
  tag_checkpoint,
  tag_node_positions, ///< and velocities
  tag_node_forces,
  tag_pressures, ///< this one and the following at samples
  tag_roller_spins,
  tag_surface_velocities,
  tag_plate_stresses
};
} // namespace chaindrive
