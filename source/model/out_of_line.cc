// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/model/out_of_line.h>
#include <chaindrive/parameters/entries.h>

namespace chaindrive::model
{
namespace
{
/// The entry that takes @p wheel out of line, with its value.
std::string entry_of(const parameters::Sprocket &wheel)
{
  namespace unit       = parameters::unit;
  const std::string of = "Drive/Wheels/" + wheel.name + "/";
  return wheel.axial_offset != 0. ? of + "Axial offset in mm = " +
                                        parameters::to_entry_text(wheel.axial_offset, unit::milli) :
                                    of + "Tilt in degrees";
}

/// Calls @p refuse with what cannot be with strands that are separate, or asked to be.
template <typename Refuse>
void against_separate_strands(const Parameters &p, const Effects &effects, const Refuse &refuse)
{
  const Decision &separate = effects.of(Effect::separate_strands);
  refuse(p.effects.separate_strands == parameters::Switch::on && !separate.on,
         "Effects/Separate strands = on is not possible: " + separate.reason +
             "; choose auto or off, or Model/Fidelity = layered and Drive/Chain/Strands above 1.");
  for (const parameters::Sprocket &wheel : p.drive.sprockets.list)
    refuse(
        separate.on && !wheel.mesh.empty(),
        "Separate strands (Effects/Separate strands: " + separate.reason +
            ") need a row of teeth for each, but the " + wheel.in_words() +
            " has the flanks of its mesh; leave the mesh out, or choose Separate strands = off.");
}
} // namespace

std::vector<std::string> against_misalignment(const Parameters &p, const Effects &effects)
{
  std::vector<std::string> sentences;
  const auto               refuse = [&](const bool found, const std::string &sentence) {
    if (found)
      sentences.push_back(sentence);
  };
  against_separate_strands(p, effects, refuse);
  if (!effects.is_on(Effect::misalignment))
    return sentences;
  std::string entry;
  for (const parameters::Sprocket &wheel : p.drive.sprockets.list)
    if (entry.empty() && wheel.is_out_of_line())
      entry = entry_of(wheel);

  const auto [has_clearances, is_elastic, is_reduced] = p.model.capabilities();
  const std::string chosen                            = "Model/Fidelity = " + p.model.fidelity;
  refuse(!has_clearances,
         entry + " needs plates that teeth guide, but in " + chosen +
             " links are bars; choose Model/Fidelity = layered, or 0.");
  for (const auto &[name, effect] :
       {std::pair<const char *, Effect>{"Elastic links", Effect::elastic_links},
        {"Elastic rollers", Effect::elastic_rollers}})
    refuse(is_elastic && !effects.is_on(effect),
           entry + " in " + chosen +
               " needs elastic links and rollers, whose nodes meet the sides " +
               "of teeth, but Effects/" + name + " is off (" + effects.of(effect).reason +
               "); choose on, Model/Fidelity = layered, or 0.");
  refuse(is_elastic && p.model.elastic_links == parameters::ElasticLinks::region_of_interest,
         entry + " in " + chosen +
             " needs elastic links everywhere, but Model/Elastic links = region of interest; "
             "choose all, Model/Fidelity = layered, or 0.");
  refuse(is_elastic && effects.is_on(Effect::elastic_links) && !effects.is_on(Effect::plate_faces),
         entry + " needs the faces of plates, which keep links beside each other, but "
                 "Contact/Plate faces = off; choose auto, or 0 for the wheels.");
  refuse(is_elastic && !is_reduced && p.contact.side_stiffness,
         "Contact/Side stiffness in N/m is for plates that do not bend or move by modes; in " +
             chosen + " leave it auto and choose Penalty factor.");
  refuse(is_elastic && p.effects.plate_bending == parameters::Switch::off,
         entry + " bends plates out of their planes, but Effects/Plate bending = off; choose auto, "
                 "or 0 for the wheels.");
  refuse(is_elastic && p.model.half == parameters::SymmetryModel::yes,
         "Model/Symmetry model = true has a half of each body, but " + entry +
             " leaves no plane of symmetry; choose auto or false.");
  const std::string strands = "Drive/Chain/Strands = " + std::to_string(p.drive.chain.strands);
  refuse(p.drive.chain.strands > 1 && is_elastic &&
             p.effects.separate_strands != parameters::Switch::off,
         entry + " pulls the strands of " + strands +
             " unevenly, which needs strands with bodies of their own, but in " + chosen +
             " one stands for all; choose Model/Fidelity = layered, or Effects/Separate strands = "
             "off for strands that share the load equally.");
  for (const parameters::Sprocket &wheel : p.drive.sprockets.list)
    {
      const std::string of = "Drive/Wheels/" + wheel.name + "/";
      refuse(!wheel.mesh.empty(),
             entry + " needs the sides of teeth, but the " + wheel.in_words() +
                 " has the flanks of its mesh alone; leave the mesh out.");
      refuse(wheel.tilt != 0. && wheel.runout != 0.,
             of + "Tilt in degrees cannot be with Runout in um; choose 0 for one of them.");
      refuse(wheel.tilt != 0. && is_sprung(wheel.held.holder),
             of + "Tilt in degrees is for wheels on bearings, but Held by = " +
                 text_of(wheel.held.holder) +
                 " moves it in the plane of the drive; choose 0, or Held by = bearing.");
    }
  return sentences;
}
} // namespace chaindrive::model
