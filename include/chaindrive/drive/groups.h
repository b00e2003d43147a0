// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/facts.h>

#include <string>
#include <vector>

namespace chaindrive::drive
{
/// A number without dimension by which drives of different size are like each other, or not.
struct Group
{
  std::string name;    ///< member of `groups` in the facts
  std::string meaning; ///< in words
  double      value;   ///< above 0; infinite or not a number where the drive has no such thing
};

/// Those on which errors of models were expected to depend: see scripts/study/accuracy_fit.py,
/// which looks whether they do.
///
/// | group            | what |
/// |------------------|----------------------------------------------------------------------------|
/// | resonance        | tooth frequency over the frequency of the driven inertia on the tight span
/// | | centrifugal      | centrifugal over effective tension | | impact           | mass per length
/// times the square of the driver's seating velocity, over    | |                  | the effective
/// tension                                                      | | pressure         | pressure of
/// the joints over that at which chains break                     | | polygon_effect   | of the
/// driver                                                              | | sag              | of
/// the slack span over the pitch                                           |
std::vector<Group> groups_of(const Facts &facts);
} // namespace chaindrive::drive
