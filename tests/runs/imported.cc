// SPDX-License-Identifier: LGPL-2.1-or-later
// A driver read from a mesh, elastic and whole, pulls a short elastic chain to full speed: what the
// generated one gives, whose teeth are the same, but of coarser elements. Energy closes and nothing
// is missed.
#include "../support/ranges.h"
#include "../support/small_drive.h"

namespace
{
nlohmann::json pull(const std::string &mesh)
{
  return test::run(
      "prm/paper/layered-auto.prm",
      test::small_full_drive_with({"Drive/Number of links=28",
                                   "Drive/Driver teeth=15",
                                   "Drive/Sprockets/Driver outside diameter in mm=81.8",
                                   "Drive/Sprockets/Driver hub diameter in mm=33",
                                   "Drive/Sprockets/Driver bore in mm=25",
                                   "Drive/Sprockets/Driver mesh=" + mesh,
                                   "Mesh/Refinement=0",
                                   "Loads/Ramp time in ms=0.2",
                                   "Time/End time in ms=0.4",
                                   "Output/Window start in ms=0.2",
                                   "Output/Field interval in ms=0"}));
}
} // namespace

int main()
{
  const nlohmann::json imported  = pull("../../meshes/sprocket-15.msh");
  const nlohmann::json generated = pull("");

  for (const std::string name :
       {"driven_angle_end", "drive_work", "resisting_work", "tight_tension_max_start"})
    test::range(name + ", imported over generated",
                imported[name].get<double>() / generated[name].get<double>(),
                0.99,
                1.01);
  test::range("strain energy, imported over generated",
              imported["energy"]["strain"].get<double>() /
                  generated["energy"]["strain"].get<double>(),
              0.98,
              1.02);
  test::range("energy imbalance / energy turned over", imported["energy_imbalance_max"], 0., 1e-3);
  test::range("contacts missed by the searches", imported["contacts_missed"], 0., 0.);
}
