// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/dynamics/system.h>

#include <string>
#include <vector>

namespace chaindrive::dynamics
{
/// Where something is wrong.
struct FaultSite
{
  double      size;    ///< how wrong, to compare places of one kind
  std::string text;    ///< such as "node 12 of roller 5 (at ...)"
  std::string of = {}; ///< body or pair, if the text says more than that: it is named once
};

/// The first @p n of @p places as text, each named once.
std::string list_of(const std::vector<FaultSite> &places, unsigned int n);

/// What is kept of the step before a look, if any body is elastic.
struct LastStep
{
  std::vector<double> velocity, force; ///< of World, three entries per body
};

/// Mass [kg] of @p body, whole, if it moves freely; 0 if a hub holds it.
double free_mass(const World &world, unsigned int body);

// The slow search for a place, when something is known to be wrong. All functions are collective
// and give the same on all ranks, the worst places first. The first rank must have the contact
// records of all (Services::gather_records()).

/// What is not a number: nodes first, then positions of bodies, contacts, bars, velocities.
std::vector<FaultSite> faults_not_finite(const scene::Scene &scene, const System &system);

/// Bodies whose resultant is not the sum of what contacts, bars and loads report, and elastic ones
/// whose momentum has not changed in the last step @p dt [s] as the resultant says. Sizes are
/// forces, N. Leaves out what is below 1e-6 of the forces on a body. Without the step before, @p
/// last null, only the former.
std::vector<FaultSite>
faults_of_balance(const scene::Scene &scene, const System &system, const LastStep *last, double dt);

/// The largest penetration of each interface in parts of Family::penetration_limit().
std::vector<FaultSite> faults_of_penetration(const scene::Scene &scene, const System &system);

/// What moves or pulls most: the largest acceleration of a body, the largest forces of bars and
/// contacts, the fastest node relative to its body.
std::vector<FaultSite> extremes(const scene::Scene &scene, const System &system);
} // namespace chaindrive::dynamics
