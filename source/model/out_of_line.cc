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
} // namespace

std::vector<std::string> against_misalignment(const Parameters &p, const Effects &effects)
{
  std::vector<std::string> sentences;
  if (!effects.is_on(Effect::misalignment))
    return sentences;
  const auto refuse = [&](const bool found, const std::string &sentence) {
    if (found)
      sentences.push_back(sentence);
  };
  std::string entry;
  for (const parameters::Sprocket &wheel : p.drive.sprockets.list)
    if (entry.empty() && wheel.is_out_of_line())
      entry = entry_of(wheel);

  const auto [has_clearances, is_elastic, is_reduced] = p.model.capabilities();
  const std::string chosen                            = "Model/Fidelity = " + p.model.fidelity;
  refuse(!has_clearances,
         entry + " needs plates that teeth guide, but in " + chosen +
             " links are bars; choose Model/Fidelity = layered, or 0.");
  refuse(is_elastic,
         entry + " is for rigid links, whose faces meet the sides of teeth; " + chosen +
             " has none; choose Model/Fidelity = layered, or 0.");
  refuse(is_elastic && p.model.half == parameters::SymmetryModel::yes,
         "Model/Symmetry model = true has a half of each body, but " + entry +
             " leaves no plane of symmetry; choose auto or false.");
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
