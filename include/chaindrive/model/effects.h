// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/parameters/choice.h>

#include <string>
#include <utility>
#include <vector>

namespace chaindrive::model
{
/// The pieces of physics that a model may do without.
enum class Effect
{
  roller_bush_clearance,
  bush_pin_clearance,
  chain_bars,
  friction,
  contact_damping,
  chain_damping,
  gravity,
  drag,
  oil_film,
  elastic_links,
  elastic_rollers,
  elastic_sprocket, ///< decided for each sprocket
  tooth_compliance,
  tooth_places,  ///< which is larger higher up on a tooth
  tooth_inertia, ///< of the rims of rigid sprockets
  plate_bending,
  reduced_bodies,
  exact_joints, ///< roller and bush, bush and pin touch without penalty
  exact_teeth,  ///< rollers and teeth touch without penalty
  selective_mass_scaling,
  plate_faces,
  misalignment,     ///< planes of wheels are not that of the drive
  separate_strands, ///< each strand of several has bodies of its own
  symmetry_model,
  planar_motion,
  oval_rollers,
  stiffness_curves, ///< contacts of rigid rollers and joints over load and place
  yielding_shafts,
  fields,
  stress_recovery,
  start_up
};
} // namespace chaindrive::model

namespace chaindrive::parameters
{
template <>
inline constexpr Texts<model::Effect, 31> texts_of<model::Effect>{
    {{model::Effect::roller_bush_clearance, "roller-bush clearance"},
     {model::Effect::bush_pin_clearance, "bush-pin clearance"},
     {model::Effect::chain_bars, "chain bars"},
     {model::Effect::friction, "friction"},
     {model::Effect::contact_damping, "contact damping"},
     {model::Effect::chain_damping, "chain damping"},
     {model::Effect::gravity, "gravity"},
     {model::Effect::drag, "drag"},
     {model::Effect::oil_film, "oil film"},
     {model::Effect::elastic_links, "elastic links"},
     {model::Effect::elastic_rollers, "elastic rollers"},
     {model::Effect::elastic_sprocket, "elastic"},
     {model::Effect::tooth_compliance, "tooth compliance"},
     {model::Effect::tooth_places, "tooth compliance over place"},
     {model::Effect::tooth_inertia, "tooth inertia"},
     {model::Effect::plate_bending, "plate bending"},
     {model::Effect::reduced_bodies, "reduced bodies"},
     {model::Effect::exact_joints, "joints without penalty"},
     {model::Effect::exact_teeth, "teeth without penalty"},
     {model::Effect::selective_mass_scaling, "selective mass scaling"},
     {model::Effect::plate_faces, "plate faces"},
     {model::Effect::misalignment, "misalignment"},
     {model::Effect::separate_strands, "separate strands"},
     {model::Effect::symmetry_model, "symmetry model"},
     {model::Effect::planar_motion, "planar motion"},
     {model::Effect::oval_rollers, "oval rollers"},
     {model::Effect::stiffness_curves, "stiffness curves"},
     {model::Effect::yielding_shafts, "yielding shafts"},
     {model::Effect::fields, "fields"},
     {model::Effect::stress_recovery, "stress recovery"},
     {model::Effect::start_up, "start-up"}}};
} // namespace chaindrive::parameters

namespace chaindrive::model
{
/// Whether an effect is on, and why. What is off makes no object.
struct Decision
{
  Effect      effect;
  bool        on;
  std::string reason;        ///< a phrase
  std::string sprocket = {}; ///< its name, for what each sprocket has of its own

  std::string name() const; ///< of the effect, in words
};

/// All decisions on effects, in the order in which the plan lists them.
class Effects
{
public:
  Effects() = default; ///< nothing is decided
  explicit Effects(std::vector<Decision> decisions) : decisions_(std::move(decisions)) {}

  /// The decision on @p effect; of what each sprocket has of its own that for sprocket number
  /// @p sprocket of the drive. Throws std::logic_error for one that nobody decided.
  const Decision &of(Effect effect, unsigned int sprocket = 0) const;

  bool is_on(const Effect effect, const unsigned int sprocket = 0) const
  {
    return of(effect, sprocket).on;
  }

  std::vector<Decision>::const_iterator begin() const { return decisions_.begin(); }
  std::vector<Decision>::const_iterator end() const { return decisions_.end(); }

private:
  std::vector<Decision> decisions_;
};
} // namespace chaindrive::model
