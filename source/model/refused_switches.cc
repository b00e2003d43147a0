// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/model/refused_switches.h>

#include <tuple>

namespace chaindrive::model
{
std::vector<std::string> refused_switches(const Parameters &p, const Effects &effects)
{
  std::vector<std::string> sentences;
  for (const auto &[effect, choice, entry] :
       {std::tuple{Effect::planar_motion, p.effects.planar_motion, "Planar motion"},
        {Effect::oval_rollers, p.effects.oval_rollers, "Oval rollers"},
        {Effect::stiffness_curves, p.effects.stiffness_curves, "Stiffness curves"},
        {Effect::tooth_places, p.effects.tooth_places, "Tooth compliance over place"},
        {Effect::tooth_inertia, p.effects.tooth_inertia, "Tooth inertia"}})
    if (const Decision &decision = effects.of(effect);
        choice == parameters::Switch::on && !decision.on)
      sentences.push_back(std::string("Effects/") + entry +
                          " = on is not possible: " + decision.reason + "; choose auto or off.");
  return sentences;
}
} // namespace chaindrive::model
