// SPDX-License-Identifier: LGPL-2.1-or-later
// The full model of a small drive with elastic sprockets from one .prm, warm enough to matter: a
// short chain brought to speed in half a millisecond. Energy closes, the driver turns as
// prescribed, the chain pulls the load round, and neither search has missed a contact. What plates
// carry, from the stress in their elements, is the tension of their links, from the contact forces
// in their joints.
#include "../support/small_drive.h"
#include "../support/table.h"

#include <cmath>

namespace
{
/// sum of a b over sum of b b, for the stress [Pa] times area and the tension of all links.
double pull_over_tension()
{
  const test::Table plates("results/histories_plates.csv"), links("results/histories_links.csv");
  // both plates of a link at their waists, m2
  const double area[]  = {2. * 0.7 * 15.09e-3 * 2e-3, 2. * 0.7 * 13.02e-3 * 2e-3};
  double       product = 0., square = 0.;
  for (unsigned int k = 0; k < 22; ++k)
    {
      const std::string column = std::to_string(k);
      for (std::size_t i = 25; i < links["time"].size(); ++i) // 0.5 ms
        {
          const double tension = links["tension " + column][i];
          product += tension * area[k % 2] * plates["axial_stress " + column][i];
          square += tension * tension;
        }
    }
  return product / square;
}
} // namespace

int main()
{
  const nlohmann::json s = test::start_small_full_drive();
  test::range("strain energy over that of pull", test::strain_over_pull(), 1., 1.5);
  test::range("pull of plates over tension of links", pull_over_tension(), 0.95, 1.05);
  test::range("contacts missed by the searches", s["contacts_missed"], 0., 0.);
}
