// SPDX-License-Identifier: LGPL-2.1-or-later
// Every entry reaches its member in SI units: all are set to a value other than the default.
#include <chaindrive/model/reading.h>

#include <array>
#include <fstream>
#include <iostream>
#include <vector>

using namespace chaindrive;

int main()
{
  std::ofstream("values.prm") << R"(
# comments, tabs, continued lines and a missing blank are all fine
SUBSECTION Drive
  set Number of links = 112
  set Driver teeth=17 # a comment
  subsection Chain
    set Designation = 08B
    set Elongation in percent = 1.5
	set Pitch in mm = 12.7
    set Waist ratio = 0.8
  end
  subsection Sprockets
    set Tooth form = \
      iso max
    set Driver mesh = meshes/a b.msh
  end
  subsection Layout
    set Centre distance from = sag
    set Sag in percent = 2
    set Centre distance in mm = 500.25
    set Slack in mm = 1
    set Start phase = 0.5
  end
END
subsection Model
  set Mass per pitch in g = 10.7
  set Stiffness per pitch in N/m = 3e8
  set Driven inertia in kg m2 = 9.88e-3
end
subsection Material
  set Young's modulus in GPa = 206
end
subsection Reduction
  set Modes up to in kHz = 100
  set Highest frequency in kHz = 250.5
  set Highest frequency of links in kHz = 55
  set Highest frequency of rollers in kHz = auto
  set Harmonics of rollers and bushes = 6
  set Harmonics of pins = 2
end
subsection Contact
  set Roller-tooth stiffness in N/m = auto
  set Bush-pin friction = 0.2
end
subsection Time
  set Time step in us = 0.25
  set Energy limit in percent = 1
  set Guard = false
end
subsection Output
  set History interval in us = 5
  set Window end in ms = 20
  set Rollers = 7,3, 11
  set CSV = true
end
subsection Acoustics
  set Observers = 0.1 -0.5 2e-1;  1 2   3
  set Floor height in m = -1.2
  set Highest frequency in kHz = 8.5
  set Finite rollers = on
end)"; // without a line break at the end

  const Parameters p = model::read_parameters("values.prm").parameters;
  std::cout << std::boolalpha;
  std::cout << "number of links, teeth: "
            << (p.drive.n_links == 112 && p.drive.sprockets.driver().teeth == 17) << std::endl;
  std::cout << "chain: "
            << (p.drive.chain.designation == "08B" && p.drive.chain.elongation == 0.015 &&
                p.drive.chain.pitch == 0.0127 && p.drive.chain.waist_ratio == 0.8 &&
                !p.drive.chain.roller_diameter)
            << std::endl;
  std::cout << "sprockets: "
            << (p.drive.sprockets.tooth_form == parameters::StandardForm::iso_max &&
                p.drive.sprockets.driver().mesh == "meshes/a b.msh" &&
                p.drive.sprockets.driven().mesh.empty())
            << std::endl;
  std::cout << "layout: "
            << (p.drive.layout.centre_distance_from == parameters::CentreDistanceFrom::sag &&
                p.drive.layout.sag == 0.02 && p.drive.layout.centre_distance == 0.50025 &&
                p.drive.layout.slack == 1e-3 && p.drive.layout.start_phase == 0.5)
            << std::endl;
  std::cout << "model: "
            << (p.model.mass_per_pitch == 0.0107 && p.model.stiffness_per_pitch == 3e8 &&
                p.model.driven_inertia == 9.88e-3 && p.material.youngs_modulus == 206e9)
            << std::endl;
  std::cout << "reduction: "
            << (p.reduction.modes_up_to == 100e3 && p.reduction.highest == 250.5e3 &&
                p.reduction.fastest_of_links == 55e3 && !p.reduction.fastest_of_rollers &&
                p.reduction.tube_order == 6 && p.reduction.pin_order == 2)
            << std::endl;
  std::cout << "contact: "
            << (!p.contact.roller_tooth_stiffness && p.contact.bush_pin_friction == 0.2 &&
                p.contact.friction_coefficient == 0.1)
            << std::endl;
  std::cout << "time: " << (p.time.step == 0.25e-6 && p.time.energy_limit == 0.01 && !p.time.guard)
            << std::endl;
  std::cout << "output: "
            << (p.output.history_interval == 5e-6 && p.output.window_end == 20e-3 &&
                p.output.rollers == std::vector<unsigned int>{3, 7, 11} && p.output.csv)
            << std::endl;
  const std::vector<std::array<double, 3>> observers = {{{0.1, -0.5, 0.2}}, {{1., 2., 3.}}};
  std::cout << "acoustics: "
            << (!p.acoustics.noise && p.acoustics.observers == observers &&
                p.acoustics.floor == -1.2 && p.acoustics.highest_frequency == 8.5e3 &&
                p.acoustics.finite_rollers && p.acoustics.radius == 0.4)
            << std::endl;
}
