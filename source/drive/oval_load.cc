// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/chain.h>
#include <chaindrive/drive/oval_load.h>
#include <chaindrive/drive/roller_ring.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace chaindrive::drive
{
double oval_load(const Parameters &parameters, const Facts &facts)
{
  const ChainDimensions chain = make_chain(parameters.drive.chain);
  if (!chain.has_rollers)
    return 0.;
  const double     degree = dealii::numbers::PI / 180.;
  const double     teeth  = facts.driver().teeth;
  const double     turn   = 360. / teeth * degree;
  const double     angle  = (35. - 120. / teeth) * degree;
  const double     pull   = facts.tight().tension - facts.centrifugal_tension;
  const double     force  = pull * std::sin(turn) / std::sin(turn + angle);
  const RollerRing ring   = roller_ring(chain, parameters.material);
  return 4. * ring.bore * ring.bore * force / (ring.stiffness * chain.roller_clearance());
}
} // namespace chaindrive::drive
