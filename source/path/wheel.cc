// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/path/wheel.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace chaindrive::path
{
using dealii::Point;
using dealii::numbers::PI;

double LinkLengths::sum(const unsigned int first, const unsigned int n) const
{
  const unsigned int pairs = n / 2;
  return pairs * (inner + outer) + (n % 2 == 1 ? of(first) : 0.);
}

Wheel::Wheel(const unsigned int n_teeth,
             const Point<2>    &position,
             const LinkLengths &lengths,
             const int          turns)
    : teeth(n_teeth), pitch_angle(2. * PI / n_teeth)
{
  const double half = PI / n_teeth;
  roller_radius     = 0.5 * lengths.mean() / std::sin(half);
  set(position, lengths, turns, half);
}

Wheel Wheel::flat(const double       seats,
                  const Point<2>    &position,
                  const LinkLengths &lengths,
                  const int          turns)
{
  Wheel        wheel;
  const double half   = std::asin(0.5 * lengths.mean() / seats);
  wheel.teeth         = 0;
  wheel.pitch_angle   = 2. * half;
  wheel.roller_radius = seats;
  wheel.set(position, lengths, turns, half);
  return wheel;
}

void Wheel::set(const Point<2>    &position,
                const LinkLengths &lengths,
                const int          turns,
                const double       half)
{
  // inner = 2 r sin(half - shift), outer = 2 r sin(half + shift)
  turn        = turns;
  centre      = position;
  shift       = std::atan(std::tan(half) * 0.5 * (lengths.outer - lengths.inner) / lengths.mean());
  bush_radius = 0.5 * lengths.inner / std::sin(half - shift);
}

Point<2> Wheel::roller(const double seat) const
{
  return Point<2>(centre[0] + roller_radius * std::cos(seat),
                  centre[1] + roller_radius * std::sin(seat));
}

Point<2> Wheel::bush(const double seat, const unsigned int joint) const
{
  const double angle = joint % 2 == 0 ? seat + turn * shift : seat - turn * shift;
  return Point<2>(centre[0] + bush_radius * std::cos(angle),
                  centre[1] + bush_radius * std::sin(angle));
}

double Wheel::direction(const double angle) const { return angle + turn * (0.5 * PI); }
} // namespace chaindrive::path
