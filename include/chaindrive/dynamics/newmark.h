// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/world.h>

#include <vector>

namespace chaindrive::dynamics
{
/// Newmark's method with beta = 0 and gamma = 1/2 (central differences) in two halves, between
/// which the forces are evaluated:
///
///   first half    v_{n+1/2} = v_n + dt/2 a_n,   x_{n+1} = x_n + dt v_{n+1/2}
///   second half   v_{n+1}   = v_{n+1/2} + dt/2 a_{n+1}
///
/// Frames hold the half-step velocities after the first half and the full-step ones after the
/// second. What elastic bodies do instead is in bodies/elastic_bodies.h; system.cc has the whole
/// step.

/// Newmark's first half: from world.time to @p step's. Forces must be those of world.time.
void first_half(World &world, const Step &step);

/// Newmark's second half, with the forces of the new time.
void second_half(World &world, const Step &step);

/// Accelerations of the centres of mass from the present forces, three entries per body, m/s2.
void accelerations(const World &world, std::vector<double> &result);
} // namespace chaindrive::dynamics
