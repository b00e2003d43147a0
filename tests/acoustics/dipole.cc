// SPDX-License-Identifier: LGPL-2.1-or-later
// Sound of small bodies that oscillate: a sphere of 5.08 mm at 0.4 m against its exact solution,
// whose ka is small, near and far, over the angle; one that flies past at a tenth of the speed of
// sound against retarded times by Newton's method, to the second order in the step; the added mass
// of a short cylinder at and between the entries of its table.
#include <chaindrive/acoustics/dipole.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <complex>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

using namespace chaindrive::acoustics;
using Vector3 = dealii::Tensor<1, 3>;

namespace
{
constexpr double pi = dealii::numbers::PI;
const Air        air;

void verdict(const std::string &what, const bool holds)
{
  std::cout << what << ": " << (holds ? "yes" : "NO") << '\n';
}

Vector3 vector(const double x, const double y)
{
  Vector3 v;
  v[0] = x;
  v[1] = y;
  return v;
}

Source source_of(const double                          mass,
                 const Grid                           &grid,
                 const std::function<Vector3(double)> &position,
                 const std::function<Vector3(double)> &acceleration)
{
  Source source{grid, {}, {}, mass};
  for (std::size_t i = 0; i < grid.size; ++i)
    {
      source.position.push_back(position(grid.time(i)));
      source.acceleration.push_back(acceleration(grid.time(i)));
    }
  return source;
}

/// Amplitude [Pa] of a sphere of @p radius with 1 m/s2 at distance @p r [m] in the direction at @p
/// angle from its motion, found over whole periods.
double amplitude(const double radius, const double r, const double angle, const double frequency)
{
  const double omega = 2. * pi * frequency;
  const Grid   grid{0., 1. / (400. * frequency), 4000};
  const Source source = source_of(
      2. * pi * air.density * std::pow(radius, 3),
      grid,
      [](double) { return Vector3(); },
      [&](const double t) { return vector(std::cos(omega * t), 0.); });
  const Grid          received{r / air.speed + 1. / frequency, 1. / (400. * frequency), 2000};
  std::vector<double> pressure(received.size, 0.);
  add_pressure(air, source, r * vector(std::cos(angle), std::sin(angle)), received, pressure);
  std::complex<double> sum;
  for (std::size_t i = 0; i < received.size; ++i)
    sum += 2. / received.size * pressure[i] * std::polar(1., -omega * received.time(i));
  return std::abs(sum);
}

/// That of the exact solution: physics of an oscillating rigid sphere, Pierce, Acoustics, 4-2.
double exact(const double radius, const double r, const double angle, const double frequency)
{
  const std::complex<double> s(0., 2. * pi * frequency * radius / air.speed);
  return std::abs(air.density * std::cos(angle) * std::pow(radius, 3) / (r * r) *
                  (1. + s * r / radius) / (s * s + 2. * s + 2.));
}

void listen_to_sphere()
{
  double worst = 0., over_angle = 0.;
  for (const double frequency : {100., 288.25, 1000., 2000.})
    for (const double r : {0.05, 0.4, 5.})
      worst = std::max(worst,
                       std::abs(20. * std::log10(amplitude(5.08e-3, r, 0., frequency) /
                                                 exact(5.08e-3, r, 0., frequency))));
  for (const double angle : {0.3, 0.7, 1.2})
    over_angle =
        std::max(over_angle,
                 std::abs(amplitude(5.08e-3, 0.4, angle, 1e3) / amplitude(5.08e-3, 0.4, 0., 1e3) -
                          std::cos(angle)));
  verdict("a sphere, near and far, to 0.1 dB", worst < 0.1);
  verdict("its cosine over the angle to 1e-12", over_angle < 1e-12);
  std::cout << "at 288.25 Hz and 0.4 m " << std::round(1e11 * amplitude(5.08e-3, 0.4, 0., 288.25))
            << " e-11 Pa of 1 m/s2\n";
}

/// Largest error over the largest pressure of a body that flies past, with a @p step [s].
double past(const double step)
{
  const double  omega    = 2. * pi * 1000.;
  const Vector3 observer = vector(0., 0.4), velocity = vector(0.1 * air.speed, 0.);
  const auto    position  = [&](const double t) { return vector(-0.3, 0.) + t * velocity; };
  const auto acceleration = [&](const double t) { return std::sin(omega * t) * vector(0.6, 0.8); };
  const auto emitted      = [&](const double t) {
    double e = t;
    for (unsigned int i = 0; i < 50; ++i)
      {
        const Vector3 arm = observer - position(e);
        e -= (e + arm.norm() / air.speed - t) / (1. - velocity * arm / arm.norm() / air.speed);
      }
    return e;
  };
  const auto far = [&](const double t) {
    const double  e   = emitted(t);
    const Vector3 arm = observer - position(e);
    return arm * acceleration(e) / arm.norm_square();
  };
  const Grid          grid{0., step, static_cast<std::size_t>(0.02 / step)};
  const Grid          received{0.003, 1.1 * step, static_cast<std::size_t>(0.012 / step)};
  std::vector<double> pressure(received.size, 0.);
  add_pressure(air, source_of(1e-6, grid, position, acceleration), observer, received, pressure);
  double worst = 0., largest = 0.;
  for (std::size_t i = 0; i < received.size; ++i)
    {
      const double t = received.time(i), h = 1e-7;
      const double r = (observer - position(emitted(t))).norm();
      const double p =
          1e-6 / (4. * pi) * ((far(t + h) - far(t - h)) / (2. * h * air.speed) + far(t) / r);
      largest = std::max(largest, std::abs(p));
      worst   = std::max(worst, std::abs(pressure[i] - p));
    }
  return worst / largest;
}
} // namespace

int main()
{
  listen_to_sphere();
  const double coarse = past(5e-6), fine = past(2.5e-6);
  verdict("a body that flies past, to 1e-3 with 200 steps per period", coarse < 1e-3);
  verdict("of the second order in the step", coarse > 3.8 * fine && coarse < 4.2 * fine);
  std::cout << "added mass of a roller " << added_mass(0.689) << ", of a disc " << added_mass(0.25)
            << ", of a long cylinder " << std::round(1e3 * added_mass(1e6)) / 1e3 << '\n';
  bool grows = true;
  for (double x = 0.26; x < 20.; x *= 1.01)
    grows = grows && added_mass(x) > added_mass(x / 1.01);
  verdict("it grows with the length", grows);
}
