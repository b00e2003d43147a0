// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/shaft.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace chaindrive::drive
{
using dealii::numbers::PI;

double Coupling::frequency() const
{
  return std::sqrt(stiffness * (1. / before + (behind > 0. ? 1. / behind : 0.))) / (2. * PI);
}

double Bearing::frequency(const unsigned int d) const
{
  return std::sqrt(stiffness[d] / mass) / (2. * PI);
}

std::optional<Coupling> make_coupling(const parameters::Sprocket  &wheel,
                                      const double                 share,
                                      const double                 solid,
                                      const std::optional<double> &behind)
{
  const parameters::Coupling &given = wheel.coupling;
  if (!given.stiffness)
    return {};
  const bool        motor   = wheel.role == parameters::Role::driver;
  const std::string section = "Drive/Wheels/" + wheel.name + "/";
  if (!motor && !behind)
    throw InputError(
        section + "Coupling/Stiffness in N m/rad = " + to_text(*given.stiffness) +
        " needs an inertia behind it; give " +
        (wheel.name == "driven" ? "Model/Driven inertia in kg m2" : section + "Inertia in kg m2") +
        ", or choose rigid.");
  if (!wheel.mesh.empty() && !given.sprocket)
    throw InputError(section +
                     "Coupling/Inertia of sprocket in kg m2 = auto is that of a sprocket "
                     "of the program's own; give that of " +
                     wheel.mesh + ".");
  Coupling     coupling{share * *given.stiffness,
                    0.,
                    given.sprocket ? share * *given.sprocket : solid,
                    motor ? 0. : *behind};
  const double omega = 2. * PI * coupling.frequency();
  coupling.damping   = given.damping ? share * *given.damping :
                                       2. * given.damping_ratio * coupling.stiffness / omega;
  return coupling;
}

std::optional<Bearing>
make_bearing(const parameters::Sprocket &wheel, const double share, const double solid)
{
  const parameters::Bearing &given   = wheel.bearing;
  const std::string          section = "Drive/Wheels/" + wheel.name + "/";
  const std::string          entry   = section + "Bearing/Stiffness in N/m";
  if (!given.stiffness)
    {
      if (given.stiffness_along_y)
        throw InputError(
            section + "Bearing/Stiffness along y in N/m = " + to_text(*given.stiffness_along_y) +
            " is of a bearing that yields along x too; give " + entry + ", or choose auto.");
      return {};
    }
  const std::string is_given = entry + " = " + to_text(*given.stiffness);
  if (wheel.held.holder != parameters::Holder::bearing)
    throw InputError(is_given + " cannot be with " + section + "Held by = " +
                     text_of(wheel.held.holder) + "; choose rigid, or Held by = bearing.");
  if (wheel.runout > 0.)
    throw InputError(is_given + " cannot be with " + section +
                     "Runout in um = " + to_text(1e6 * wheel.runout) +
                     ", whose axis stands still; choose rigid, or no runout.");
  if (!wheel.mesh.empty() && !given.mass)
    throw InputError(section +
                     "Bearing/Mass in kg = auto is that of a sprocket of the program's "
                     "own; give that of " +
                     wheel.mesh + ".");
  if (given.mass && wheel.mesh.empty() && share * *given.mass < solid)
    throw InputError(section + "Bearing/Mass in kg = " + to_text(*given.mass) +
                     " is less than that of the sprocket alone, " +
                     to_text_at_least(solid / share, 4) + " kg; choose a greater value or auto.");
  Bearing bearing;
  bearing.mass         = given.mass ? share * *given.mass : solid;
  bearing.stiffness[0] = share * *given.stiffness;
  bearing.stiffness[1] = share * given.stiffness_along_y.value_or(*given.stiffness);
  for (unsigned int d = 0; d < 2; ++d)
    bearing.damping[d] =
        given.damping ? share * *given.damping :
                        2. * given.damping_ratio * std::sqrt(bearing.stiffness[d] * bearing.mass);
  return bearing;
}

void refuse_soft_shaft(const std::string             &name,
                       const std::optional<Bearing>  &bearing,
                       const std::optional<Coupling> &coupling,
                       const double                   tension,
                       const double                   torque,
                       const double                   pitch)
{
  const std::string section = "Drive/Wheels/" + name + "/";
  for (const unsigned int d : {0U, 1U})
    if (bearing && tension > 0.5 * pitch * bearing->stiffness[d])
      throw InputError(section + "Bearing/Stiffness " + (d == 0 ? "" : "along y ") + "in N/m = " +
                       to_text(bearing->stiffness[d]) + " lets the tension of the load, " +
                       to_text(tension, 4) + " N, move the wheel by " +
                       in_mm(tension / bearing->stiffness[d], 4) + "; at most half a pitch, " +
                       in_mm(0.5 * pitch, 4) + ", is accepted. Choose at least " +
                       to_text_at_least(2. * tension / pitch, 4) + " N/m, or a smaller load.");
  if (coupling && torque > PI * coupling->stiffness)
    throw InputError(section + "Coupling/Stiffness in N m/rad = " + to_text(coupling->stiffness) +
                     " lets the torque of the load, " + to_text(torque, 4) +
                     " N m, twist it by more than half a turn. Choose at least " +
                     to_text_at_least(torque / PI, 4) + " N m/rad, or a smaller load.");
}
} // namespace chaindrive::drive
