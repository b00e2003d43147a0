// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/spring.h>
#include <chaindrive/bodies/world.h>

#include <vector>

namespace chaindrive::stability
{
/// The critical time step [s] of central differences for the bodies of @p world joined by
/// @p springs, damping included; infinite without springs.
///
/// With K = sum k_i b_i b_i^T the squared frequencies are the eigenvalues of the matrix
/// G_ij = sqrt(k_i k_j) b_i^T M^-1 b_j; largest_eigenvalue() finds the largest one. Damping,
/// evaluated at the velocity of the half step before, makes the step dt stable while
/// 4 M - 2 dt C - dt^2 K is positive: as if the springs had k_i + 2 c_i / dt.
double critical_time_step(const World &world, const std::vector<Spring> &springs);

/// The same [s] from the largest eigenvalues of M^-1 K [1/s2] and of M^-1 C [1/s] alone: the
/// largest dt with dt^2 @p stiffness + 2 dt @p damping <= 4. For one mode it is 2/w (sqrt(1 + xi^2)
/// - xi) (Belytschko, Liu, Moran, Nonlinear Finite Elements, 6.2).
double critical_time_step_of(double stiffness, double damping);
} // namespace chaindrive::stability
