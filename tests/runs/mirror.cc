// SPDX-License-Identifier: LGPL-2.1-or-later
// Without gravity a drive whose lower span is tight is the mirror image of one whose
// upper span is. Both models give the same energies until contacts have amplified round-off. A
// lumped roller starts with its seat just in touch: round-off decides whether it meets the dashpot
// of the contact at the first step or the second, which is seen in the fifth digit of the energy in
// contacts.
#include "../support/ranges.h"

int main()
{
  for (const std::string model : {"simple", "layered"})
    {
      const std::vector<std::string> common   = {"Effects/Gravity=off",
                                                 "Drive/Layout/Centre distance from=slack",
                                                 "Drive/Layout/Slack in mm=1",
                                                 "Time/End time in ms=0.3",
                                                 "Output/Window start in ms=0",
                                                 "Output/Window end in ms=auto",
                                                 "Output/Field interval in ms=0"};
      std::vector<std::string>       mirrored = common;
      mirrored.push_back("Drive/Layout/Tight span=lower");
      const auto upper = test::run("prm/paper/" + model + ".prm", common);
      const auto lower = test::run("prm/paper/" + model + ".prm", mirrored);
      for (const std::string energy : {"kinetic", "contact", "friction_loss"})
        test::range(model + ": " + energy + " energy, lower / upper",
                    lower["energy"][energy].get<double>() / upper["energy"][energy].get<double>(),
                    1. - 1e-4,
                    1. + 1e-4);
      test::range(model + ": drive work, lower / upper",
                  lower["drive_work"].get<double>() / upper["drive_work"].get<double>(),
                  1. - 1e-4,
                  1. + 1e-4);
    }
}
