// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

namespace chaindrive::drive
{
/// Speed ratio driven/driver of a drive whose tight span is a rigid straight line: the sprockets
/// and the span are a four-bar linkage until the next roller seats or leaves (Bouillon and Tordion
/// 1965; Chen and Freudenstein 1988). Rollers are on the circles of radius pitch / (2 sin(pi/z)).
///
/// @param phase  of a driver pitch: 0 where the driver's entry roller stands half a pitch angle
///   before the tangent point
double four_bar_ratio(double       centre_distance,
                      double       pitch,
                      unsigned int driver_teeth,
                      unsigned int driven_teeth,
                      double       phase);

/// The ratio at @p n equally spaced phases of one driver pitch, beginning at phase 0. Its mean is
/// driver_teeth / driven_teeth, its first harmonic is that of the tooth frequency.
std::vector<double> four_bar_ratios(double       centre_distance,
                                    double       pitch,
                                    unsigned int driver_teeth,
                                    unsigned int driven_teeth,
                                    unsigned int n);
} // namespace chaindrive::drive
