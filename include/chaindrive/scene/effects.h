// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/parameters/drive.h>

#include <string>
#include <vector>

namespace chaindrive
{
struct Parameters;
}

namespace chaindrive::scene
{
/// The pieces of physics that a scene may call for or not.
enum class EffectKind
{
  roller_bush_clearance,
  bush_pin_clearance,
  chain_bars,
  friction,
  contact_damping,
  chain_damping,
  gravity,
  drag,
  elastic_links,
  elastic_rollers,
  elastic_sprocket,
  tooth_compliance,
  plate_bending,
  reduced_bodies,
  column_mass_scaling,
  plate_faces,
  half_model,
  fields,
  stress_recovery,
  start_up
};

/// One of them, decided. What is off makes no object.
struct Effect
{
  EffectKind  kind;
  bool        on;
  std::string reason;        ///< a phrase: why it is on or off
  std::string sprocket = {}; ///< of which it is, for what each sprocket has of its own

  std::string name() const; ///< in words
};

/// Decides each effect from its `auto | on | off` entry and the coefficients behind it.
std::vector<Effect> decide_effects(const Parameters &parameters);

/// Whether the effect @p kind is on, of the @p sprocket of this name if each has its own; throws
/// std::logic_error for one that nobody decided.
bool is_on(const std::vector<Effect> &effects, EffectKind kind, const std::string &sprocket = {});
} // namespace chaindrive::scene
