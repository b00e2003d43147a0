// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace chaindrive
{
struct Parameters;
}

namespace chaindrive::scene
{
/// A piece of physics that a scene may call for or not. One that is off makes no object.
struct Effect
{
  std::string name;
  bool        on;
  std::string reason; ///< a phrase: why it is on or off
};

/// Decides each effect from its `auto | on | off` entry and the coefficients behind it.
std::vector<Effect> decide_effects(const Parameters &parameters);

/// Whether the effect called @p name is on; throws std::logic_error for a name nobody decided.
bool is_on(const std::vector<Effect> &effects, const std::string &name);
} // namespace chaindrive::scene
