// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/groups.h>
#include <chaindrive/drive/stiffness.h>

#include <cmath>

namespace chaindrive::drive
{
std::vector<Group> groups_of(const Facts &facts)
{
  const Facts::Sprocket &driver  = facts.driver();
  const double           tension = facts.effective_tension;
  return {
      {"resonance",
       "tooth frequency over that of the driven inertia on the tight span",
       facts.tooth_frequency / facts.driven_frequency},
      {"centrifugal", "centrifugal over effective tension", facts.centrifugal_tension / tension},
      {"impact",
       "mass per length times square of the driver's seating velocity over effective tension",
       facts.mass_per_metre * std::pow(driver.seating_velocity, 2) / tension},
      {"pressure",
       "joint pressure over that at which chains break",
       facts.joint_pressure / breaking_pressure},
      {"polygon_effect", "polygon effect of the driver", driver.polygon_effect},
      {"sag", "sag of the slack span over the pitch", facts.slack().sag / facts.pitch}};
}
} // namespace chaindrive::drive
