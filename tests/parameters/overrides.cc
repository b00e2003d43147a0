// SPDX-License-Identifier: LGPL-2.1-or-later
// Overrides from the command line, applied in their order after the file.
#include <chaindrive/model/reading.h>
#include <chaindrive/utilities/errors.h>

#include <fstream>
#include <iostream>

using namespace chaindrive;

int main()
{
  std::ofstream("drive.prm") << "subsection Contact\n  set Friction coefficient = 0.3\nend\n";

  const auto        input = model::read_parameters("drive.prm",
                                            {"Contact/Friction coefficient=0.2",
                                                    "Drive/Layout/Slack in mm = 1.5",
                                                    "Contact/Roller-tooth stiffness in N/m=2e8",
                                                    "Loads/Driver speed in rad/s=10",
                                                    "Loads/Driver speed in rad/s=20"});
  const Parameters &p     = input.parameters;
  std::cout << "friction " << p.contact.friction_coefficient << ", slack "
            << p.drive.layout.slack * 1e3 << " mm, stiffness " << *p.contact.roller_tooth_stiffness
            << " N/m, speed " << p.loads.driver_speed << " rad/s, notes " << input.notes.size()
            << std::endl;

  for (const char *text : {"Contact/Friction coefficent=0.2",
                           "Friction coefficient=0.2",
                           "Contact/Friction coefficient",
                           "Contact/Friction coefficient=-1",
                           "Contact/Friction coefficient=",
                           "Slack in mm=1",
                           "Time/End=5",
                           "Drive/Layout/Slak=5",
                           "Time/End time in us=5",
                           "nonsense=1",
                           ""})
    try
      {
        model::read_parameters("drive.prm", {text});
        std::cout << "accepted" << std::endl;
      }
    catch (const InputError &error)
      {
        std::cout << error.what() << std::endl;
      }
}
