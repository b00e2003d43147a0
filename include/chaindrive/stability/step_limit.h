// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/world.h>
#include <chaindrive/contact/contacts.h>
#include <chaindrive/forces/bars.h>
#include <chaindrive/statics/cache.h>

#include <string>
#include <vector>

namespace chaindrive::parameters
{
struct Time;
}

/// The largest time step with which central differences remain bounded.
///
/// With stiffness K, mass M and damping C at the velocities of half a step before, linear vibration
/// remains bounded while 4 M - 2 dt C - dt^2 K is positive (doc/theory.md, section 6). The limit is
/// that of the state at the start with all contacts closed. What each part of it is, and how far
/// from the limit of that linear system:
///
/// | part                       | where                | what it is                              |
/// |----------------------------|----------------------|-----------------------------------------|
/// | bars                       | critical_time_step.h | exact to 1e-6, for their present axes   |
/// | contacts of rigid bodies   | critical_time_step.h | bound for every normal (theory.md);     |
/// |                            |                      | 1.7 % below in a layered drive          |
/// | force elements             | critical_time_step.h | exact to 1e-6; stops as if they acted   |
/// | elements                   | ElasticGroup         | exact to 1e-6, without strain; of a rim |
/// |                            | (elastic_group.h)    | a bound, 0.3 % below                    |
/// | contacts of nodes          | closed_contact.h     | bound for every split of a spring       |
/// |                            |                      | (theory.md); up to 15 % below           |
/// | drag                       | step_limit()         | bound, up to drag dt / 4 below: 1e-5    |
/// | contacts of reduced bodies | coupled_modes.h      | estimate, from above: a search among    |
/// |                            |                      | the ways in which contacts close        |
///
/// "Exact" is largest_eigenvalue(): a Ritz value of Lanczos' method and its residual. Not linear,
/// and so beyond all of this, are impacts; that is what `Safety factor` is for.
namespace chaindrive::stability
{
/// One source's limit.
struct TimeStepLimit
{
  std::string source;
  double      limit; ///< s
};

/// The limit of each kind of spring of @p bars, of each of @p forces, of the elements and of @p
/// contacts alone. @p kept: see closed_windows.h.
std::vector<TimeStepLimit> step_limits(const World             &world,
                                       const Bars              &bars,
                                       const ForceElements     &forces,
                                       const contact::Contacts &contacts,
                                       statics::Cache          *kept = nullptr);

/// The limit [s] of all of them together, of bodies with this @p drag [1/s].
///
/// Where 4 M - 2 s C - s^2 K is positive semidefinite, so is 4 M - 2 dt (C + drag M) - dt^2 K for
/// dt = s / (1 + drag s / 2): with r = dt / s below 1, r^2 s^2 K + 2 r s C is at most 4 r M, and
/// 4 r + 2 drag r s = 4.
double step_limit(const World             &world,
                  const Bars              &bars,
                  const ForceElements     &forces,
                  const contact::Contacts &contacts,
                  double                   drag,
                  statics::Cache          *kept = nullptr);

/// The chosen step and why.
struct TimeStepChoice
{
  std::vector<TimeStepLimit> step_limits; ///< of each kind of spring alone
  double                     limit;       ///< of all coupled, s
  double                     step;        ///< s
  std::string                reason;
};

/// The step of a run with this @p drag [1/s]: the one asked for, if it does not exceed the safety
/// factor times the limit (InputError otherwise, with both numbers); or, when none is asked for,
/// the smaller of that product and a twelfth of the shortest period.
TimeStepChoice choose_time_step(const World             &world,
                                const Bars              &bars,
                                const ForceElements     &forces,
                                const contact::Contacts &contacts,
                                double                   drag,
                                const parameters::Time  &time,
                                statics::Cache          *kept = nullptr);
} // namespace chaindrive::stability
