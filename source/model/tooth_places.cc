// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/model/tooth_places.h>

namespace chaindrive::model
{
Decision tooth_places(const Parameters &p, const Decision &compliance, const Decision &exact)
{
  using parameters::Switch;
  const auto off = [](const std::string &why) {
    return Decision{Effect::tooth_places, false, why};
  };
  if (!compliance.on)
    return off("teeth do not deflect beside the contact: " + compliance.reason);
  if (!exact.on)
    return off("rollers and teeth touch by penalty: " + exact.reason);
  if (p.effects.tooth_places == Switch::off)
    return off("switched off in section Effects");
  if (p.contact.tooth_stiffness)
    return off("Contact/Tooth stiffness in N/m is one number");
  if (p.model.stiffness_from == parameters::StiffnessFrom::dimensions)
    return off("Model/Stiffness from = dimensions knows one stiffness of teeth");
  return {Effect::tooth_places,
          true,
          p.effects.tooth_places == Switch::on ? "switched on in section Effects" :
                                                 "a tooth is softer the higher a roller bears"};
}

Decision tooth_inertia(const Parameters &p, const Decision &places)
{
  using parameters::Switch;
  constexpr Effect effect = Effect::tooth_inertia;
  if (!places.on)
    return {effect, false, "it needs tooth compliance over place: " + places.reason};
  if (p.effects.tooth_inertia != Switch::on)
    return {effect,
            false,
            p.effects.tooth_inertia == Switch::off ? "switched off in section Effects" :
                                                     "teeth deflect at once"};
  return {effect, true, "switched on in section Effects"};
}
} // namespace chaindrive::model
