// SPDX-License-Identifier: LGPL-2.1-or-later
// A fine chain over half a drum that turns slowly: the tensions of its two ends are in the ratio
// exp(mu theta) (Euler, Eytelwein). One end is held, the other carries a constant force.
#include "../support/capstan.h"

#include <chaindrive/contact/drum.h>

using namespace test;

int main()
{
  scene::Scene scene = capstan(1e-12);
  scene.surfaces.push_back(
      on_surface(std::make_shared<const contact::Drum>(n_on_capstan, capstan_radius),
                 capstan_law(),
                 capstan_slaves()));
  for (const int sense : {1, -1})
    compare_tensions(sense > 0 ? "held over loaded end, drum turning towards the loaded end" :
                                 "loaded over held end, drum turning towards the held end",
                     scene,
                     sense,
                     [](const dynamics::System &) {});
}
