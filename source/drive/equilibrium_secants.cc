// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/equilibrium.h>
#include <chaindrive/drive/stiffness_fit.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::drive
{
double Equilibrium::place_on(const unsigned int    k,
                             const unsigned int    i,
                             const double          depth,
                             const Vector         &normal,
                             const StiffnessCurve &curve) const
{
  const Vector from  = at_[k] - (contact_radius_ - depth) * normal - centre(i, 0.);
  const double polar = std::atan2(from[1], from[0]) - frames_[i].angle - turned_[i];
  const double gap   = 2. * dealii::numbers::PI / wheels_[i].seats;
  return (from.norm() * std::cos(std::remainder(polar, gap)) - curve.bottom) / curve.unit;
}

double Equilibrium::take_secants()
{
  const StiffnessCurves &curves     = chain_.curves;
  double                 change     = 0.;
  const auto             set_secant = [&change](double &spring, const double secant) {
    change = std::max(change, std::abs(secant / spring - 1.));
    spring = secant;
  };
  for (unsigned int k = 0; k < n_; ++k)
    {
      if (const double pull = tension(k); k % 2 == 1 && curves.per_pitch && pull > 0.)
        set_secant(of_links_[k],
                   0.5 * pull / approach_of(*curves.per_pitch, 0., pull)); // two joints
      for (unsigned int i = 0; i < n_wheels_; ++i)
        {
          Vector       normal;
          const double depth = overlap(i, at_[k], 0., normal), force = seat_force(k, i, depth);
          const bool   of_tooth = i < curves.roller_tooth.size() && curves.roller_tooth[i];
          if (wheels_[i].plates || !(force > 0.) || !(of_tooth || curves.roller_bush))
            continue;
          if (curves.roller_bush)
            set_secant(of_bushes_[k], force / approach_of(*curves.roller_bush, 0., force));
          const StiffnessCurve *tooth = of_tooth ? &*curves.roller_tooth[i] : nullptr;
          const double          approach =
              tooth != nullptr ? approach_of(*tooth, place_on(k, i, depth, normal, *tooth), force) :
                                          force / chain_.tooth_stiffness;
          set_secant(
              of_seats_[k * wheels_.size() + i],
              1. / (approach / force + (chain_.bush_clearance > 0. ? 1. / of_bushes_[k] : 0.)));
        }
    }
  return change;
}
} // namespace chaindrive::drive
