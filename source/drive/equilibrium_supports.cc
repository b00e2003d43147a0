// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/equilibrium.h>

// What bearings that yield and a tensioner add to the energy of a drive at rest.

namespace chaindrive::drive
{
void Equilibrium::add_axis(const OnBearing                            &on,
                           const unsigned int                          k,
                           const unsigned int                          f,
                           const std::array<double, 3>                &gradient,
                           const std::array<std::array<double, 3>, 3> &second)
{
  for (unsigned int a = 0; a < 2; ++a)
    {
      wheel_gradient_[on.first + a] -= gradient[a];
      wheel_diagonal_[on.first + a] += second[a][a];
      for (unsigned int j = 0; j < 2; ++j)
        to_wheel_[on.first + a][k][j] -= 0.5 * (second[a][j] + second[j][a]);
      if (!wheels_[on.wheel].held)
        between_[on.first + a][f] -= 0.5 * (second[2][a] + second[a][2]);
    }
  between_[on.first + 1][on.first] += 0.5 * (second[0][1] + second[1][0]);
}

void Equilibrium::add_bearings()
{
  for (const OnBearing &on : on_bearings_)
    {
      Layout::Sprocket &wheel = frames_[on.wheel];
      wheel.centre += on.way - wheel.deflection;
      wheel.deflection = on.way;
      for (unsigned int d = 0; d < 2; ++d)
        {
          const double stiffness = (*wheels_[on.wheel].bearing)[d];
          energy_ += 0.5 * stiffness * on.way[d] * on.way[d];
          wheel_gradient_.push_back(stiffness * on.way[d]);
          wheel_diagonal_[on.first + d] = stiffness;
        }
    }
}

// The wheel's centre moves by w per unit of its way. What a contact's energy is of the joint's
// position it is of minus the centre's.
void Equilibrium::add_travel(const unsigned int                          k,
                             const std::array<double, 3>                &gradient,
                             const std::array<std::array<double, 3>, 3> &second)
{
  const Tensioner &tensioner = *moving_;
  const double     lever     = tensioner.lever();
  const Vector     w = tensioner.way(travel_) / lever, b = tensioner.bend(travel_);
  for (unsigned int i = 0; i < 2; ++i)
    {
      wheel_gradient_.back() -= w[i] * gradient[i];
      wheel_diagonal_.back() -= b[i] * gradient[i] / (lever * lever);
      for (unsigned int j = 0; j < 2; ++j)
        {
          to_wheel_.back()[k][i] -= second[i][j] * w[j];
          wheel_diagonal_.back() += w[i] * second[i][j] * w[j];
        }
      if (!wheels_[tensioner.wheel].held)
        wheel_to_travel_ -= second[2][i] * w[i];
    }
}
} // namespace chaindrive::drive
