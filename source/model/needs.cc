// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/model/needs.h>

namespace chaindrive::model
{
std::string documentation_of_needs()
{
  std::string text =
      "\n## What needs what\n\nIn full fidelity these effects are on where they are `auto` and one "
      "of `Output/Quantities`\nneeds them. All others are on wherever they can act: they cost "
      "next to nothing, and all\nresults depend on them.\n\n"
      "| Quantities | Elastic links | Elastic rollers | Elastic driver, driven | Both halves | "
      "Reason |\n|---|---|---|---|---|---|\n";
  const auto cell = [](const bool needed) { return std::string(needed ? "needed" : "-") + " | "; };
  for (const Needs &needs : all_needs)
    text += "| `" + parameters::text_of(needs.group) + "` | " + cell(needs.links) +
            cell(needs.rollers) + cell(needs.sprockets) + cell(needs.both_halves) + needs.reason +
            " |\n";
  return text;
}
} // namespace chaindrive::model
