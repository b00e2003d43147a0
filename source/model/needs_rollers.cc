// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/chain.h>
#include <chaindrive/model/needs_rollers.h>
#include <chaindrive/utilities/text.h>

namespace chaindrive::model
{
std::vector<std::string> against_bush_chain(const Parameters &p)
{
  using parameters::Enforcement;
  using parameters::QuantityGroup;
  std::vector<std::string> sentences;
  if (drive::has_rollers(p.drive.chain))
    return sentences;
  const std::string chain = "Drive/Chain/Designation = " + p.drive.chain.designation +
                            " with Rollers = " + text_of(p.drive.chain.rollers) + " has not";
  const Enforcement enforcement = p.contact.enforcement;
  if (enforcement != Enforcement::automatic && enforcement != Enforcement::penalty)
    sentences.push_back("Contact/Enforcement = " + text_of(enforcement) +
                        " is for chains with rollers, which " + chain +
                        "; choose penalty or auto.");
  if (p.output.names(QuantityGroup::surface_velocity))
    sentences.push_back("Output/Quantities = " + text_of(QuantityGroup::surface_velocity) +
                        " is for rollers, which " + chain + "; leave it out.");
  return sentences;
}

std::vector<std::string> against_oil_film(const Parameters &p, const Effects &effects)
{
  if (p.effects.oil_film == parameters::Switch::on && p.contact.oil_viscosity == 0.)
    return {"Effects/Oil film = on contradicts Contact/Oil viscosity in mPa s = 0; give a value "
            "above zero, or choose auto or off."};
  if (!effects.is_on(Effect::oil_film))
    return {};
  const std::string entry =
      "Contact/Oil viscosity in mPa s = " + to_text(1e3 * p.contact.oil_viscosity);
  const auto [has_clearances, is_elastic, is_reduced] = p.model.capabilities();
  std::vector<std::string> sentences;
  if (!has_clearances || is_elastic)
    sentences.push_back(entry + " needs rigid rollers on bushes, which Model/Fidelity = " +
                        p.model.fidelity + " has not; choose layered, or 0.");
  if (!drive::has_rollers(p.drive.chain))
    sentences.push_back(
        entry + " is for rollers, which Drive/Chain/Designation = " + p.drive.chain.designation +
        " with Rollers = " + text_of(p.drive.chain.rollers) + " has not; choose 0.");
  if (p.effects.roller_bush_clearance == parameters::Switch::off)
    sentences.push_back(entry + " needs room for oil, but Effects/Roller-bush clearance = off; "
                                "choose auto, or 0.");
  if (effects.is_on(Effect::misalignment))
    sentences.push_back(entry + " is for wheels in the plane of the drive; choose 0, or 0 for "
                                "their offsets and tilts.");
  return sentences;
}
} // namespace chaindrive::model
