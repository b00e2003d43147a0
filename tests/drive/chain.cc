// SPDX-License-Identifier: LGPL-2.1-or-later

// Dimensions of chains: Table 2 of Zheng et al. (2004) for the 525, hole pitches of the pitch sets,
// what holds for every chain of the tables, derived values, refusals; mm.

#include "compare.h"

#include <chaindrive/drive/chain.h>

using namespace chaindrive;

namespace
{
void print_pitches(const parameters::PitchSet set, const double elongation)
{
  parameters::Chain chain;
  chain.pitch_set  = set;
  chain.elongation = elongation;
  const auto c     = drive::make_chain(chain);
  std::cout << std::fixed << std::setprecision(5) << text_of(set) << ", elongation " << elongation
            << ": holes " << c.inner_hole_pitch * 1e3 << ' ' << c.outer_hole_pitch * 1e3
            << ", loaded " << c.loaded_inner_pitch() * 1e3 << ' ' << c.loaded_outer_pitch() * 1e3
            << ", mean " << c.loaded_pitch() * 1e3 << '\n';
}

void refuse(const std::string &what, void (*change)(parameters::Chain &))
{
  expect_refusal(what, [&] {
    parameters::Chain chain;
    change(chain);
    drive::make_chain(chain);
  });
}
} // namespace

int main()
{
  const auto c = drive::make_chain(parameters::Chain());
  std::cout << "== 525\n";
  compare("roller diameter", c.roller_diameter * 1e3, 10.16, 6);
  compare("roller bore", c.roller_bore * 1e3, 7.52, 6);
  compare("roller length", c.roller_length * 1e3, 7.0, 6);
  compare("bush diameter", c.bush_diameter * 1e3, 7.43, 6);
  compare("bush bore", c.bush_bore * 1e3, 5.33, 6);
  compare("bush length", c.bush_length * 1e3, 9.94, 6);
  compare("pin diameter", c.pin_diameter * 1e3, 5.24, 6);
  compare("pin bore", c.pin_bore * 1e3, 2.68, 6);
  compare("pin length", c.pin_length * 1e3, 14.94, 6);
  compare("inner plates at", c.inner_plate_z * 1e3, 4.97, 6);
  compare("outer plates at", c.outer_plate_z * 1e3, 7.47, 6);
  compare("radial clearance of roller and bush", c.roller_clearance() * 1e3, 0.045, 6);
  compare("radial clearance of bush and pin", c.pin_clearance() * 1e3, 0.045, 6);

  std::cout << "== pitches\n";
  for (const auto set : {parameters::PitchSet::standard,
                         parameters::PitchSet::paper_literal,
                         parameters::PitchSet::nominal})
    for (const double elongation : {0., 0.01})
      print_pitches(set, elongation);

  std::cout << "== no play: bores fit, and the standard chain keeps its loaded pitch\n";
  parameters::Effects effects;
  effects.roller_bush_clearance = effects.bush_pin_clearance = parameters::Switch::off;
  for (const auto &[set, name] : parameters::texts_of<parameters::PitchSet>)
    {
      parameters::Chain chain;
      chain.pitch_set = set;
      const auto with = drive::make_chain(chain), without = drive::make_chain(chain, effects);
      std::cout << name << ": clearances " << 1e6 * without.roller_clearance() << ' '
                << 1e6 * without.pin_clearance() << ", diameters of bush and pin stay: "
                << (with.bush_diameter == without.bush_diameter &&
                    with.pin_diameter == without.pin_diameter)
                << ", loaded pitch over that with play "
                << without.loaded_pitch() / with.loaded_pitch() << '\n';
    }

  std::cout << "== every chain of the tables: clearances, walls, order along the pin\n";
  unsigned int chains = 0, sound = 0;
  for (const std::string &name : drive::chain_designations())
    {
      parameters::Chain chain;
      chain.designation = name;
      const auto d      = drive::make_chain(chain);
      ++chains;
      if (std::abs(d.roller_clearance() - (d.has_rollers ? 0.045e-3 : 0.)) < 1e-12 &&
          std::abs(d.pin_clearance() - 0.045e-3) < 1e-12 &&
          (d.has_rollers ? d.roller_diameter > d.roller_bore && d.roller_length < d.inner_width :
                           d.roller_diameter == d.bush_diameter) &&
          d.bush_diameter > d.bush_bore && d.pin_diameter > d.pin_bore &&
          2. * d.inner_plate_z + d.inner_plate_thickness <
              2. * d.outer_plate_z - d.outer_plate_thickness)
        ++sound;
      if (!(name == "525" || d.derived.size() >= (d.has_rollers ? 4U : 3U)))
        std::cout << name << " does not say what is derived\n";
    }
  std::cout << chains << " chains, " << sound << " sound\n";

  std::cout << "== what the log says of derived values\n";
  for (const std::string name : {"08B", "25", "428", "525"})
    {
      parameters::Chain chain;
      chain.designation = name;
      for (const std::string &sentence : drive::make_chain(chain).derived)
        std::cout << sentence << '\n';
    }

  std::cout << "== refused\n";
  refuse("pin wall of a tenth of a nanometre",
         [](parameters::Chain &chain) { chain.pin_bore = 5.2399998e-3; });
  refuse("unknown chain", [](parameters::Chain &p) { p.designation = "08C"; });
  refuse("two strands", [](parameters::Chain &p) { p.designation = "08B-2"; });
  refuse("negative clearance", [](parameters::Chain &p) {
    p.bush_diameter = 7.6e-3;
    p.roller_bore   = 7.52e-3;
  });
  refuse("pin in bush", [](parameters::Chain &p) {
    p.pin_diameter = 5.4e-3;
    p.bush_bore    = 5.33e-3;
  });
  refuse("no wall", [](parameters::Chain &p) { p.bush_bore = 7.5e-3; });
  refuse("roller too long", [](parameters::Chain &p) { p.roller_length = 8e-3; });
  refuse("plates intersect", [](parameters::Chain &p) { p.pin_length = 13e-3; });
  refuse("plates meet", [](parameters::Chain &p) { p.inner_plate_height = 16e-3; });
  refuse("waist", [](parameters::Chain &p) { p.waist_ratio = 1.2; });
  refuse("elongation", [](parameters::Chain &p) { p.elongation = -0.1; });
}
