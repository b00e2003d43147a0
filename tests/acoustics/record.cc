// SPDX-License-Identifier: LGPL-2.1-or-later
// From recorded velocities to accelerations on a fine grid: times of whole steps made equal, means
// over samples made good, what lies above the highest frequency left out; and the sound of a sphere
// of finite size, whose numbers are those of the exact solution.
#include <chaindrive/acoustics/dipole.h>
#include <chaindrive/acoustics/record.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

using namespace chaindrive::acoustics;

namespace
{
constexpr double pi = dealii::numbers::PI;

void verdict(const std::string &what, const bool holds)
{
  std::cout << what << ": " << (holds ? "yes" : "NO") << '\n';
}

/// Times of the first whole steps at or after multiples of @p sample.
std::vector<double> recorded_times(const double sample, const double step, const std::size_t n)
{
  std::vector<double> times;
  for (std::size_t i = 0; i < n; ++i)
    times.push_back(step * std::ceil(sample * i / step - 1e-9));
  return times;
}

/// Largest error of the acceleration, of amplitude 1, that comes out of the velocity at @p
/// frequency, in the middle of the record.
double error_of_tone(const double frequency, const double step)
{
  const double        omega = 2. * pi * frequency, sample = 20e-6;
  const auto          times = recorded_times(sample, step, 1000);
  std::vector<double> velocity;
  for (const double t : times)
    velocity.push_back(std::sin(omega * t) / omega);
  const Regular     regular(times);
  const double      h     = regular.grid().step;
  const std::size_t n     = 18;
  const auto        fine  = refine(differences(regular(velocity), h), h, n, [h](const double f) {
    return passed(f, 22.4e3, h);
  });
  double            worst = 0.;
  for (std::size_t i = fine.size() / 4; i < 3 * fine.size() / 4; ++i)
    {
      const double t = regular.grid().start + 0.5 * h + h * i / n;
      worst          = std::max(worst, std::abs(fine[i] - std::cos(omega * t)));
    }
  return worst;
}

/// Amplitude [Pa] of a sphere of 5.08 mm with 1 m/s2 on its axis at 0.4 m, through the filter.
double sphere(const double frequency)
{
  const Air           air;
  const double        radius = 5.08e-3, r = 0.4, omega = 2. * pi * frequency;
  const std::size_t   per_period = 400;
  const double        step       = 1. / (frequency * per_period);
  std::vector<double> record(20 * per_period);
  for (std::size_t i = 0; i < record.size(); ++i)
    record[i] = std::cos(omega * step * i);
  const auto filtered = refine(record, step, 1, [&](const double f) {
    return f < 0.4 / step ? sphere_response(f, radius, air.speed) : 0.;
  });
  Source source{{0., step, filtered.size()}, {}, {}, 2. * pi * air.density * std::pow(radius, 3)};
  source.position.resize(filtered.size());
  source.acceleration.resize(filtered.size());
  for (std::size_t i = 0; i < filtered.size(); ++i)
    source.acceleration[i][0] = filtered[i];
  dealii::Tensor<1, 3> observer;
  observer[0] = r;
  const Grid          received{r / air.speed + 8. / frequency, step, 4 * per_period};
  std::vector<double> pressure(received.size, 0.);
  add_pressure(air, source, observer, received, pressure);
  double square = 0.;
  for (const double p : pressure)
    square += 2. * p * p / received.size;
  return std::sqrt(square);
}
} // namespace

int main()
{
  double low = 0., high = 0., whole = 0.;
  for (const double f : {500., 3000., 8000.})
    low = std::max(low, error_of_tone(f, 0.25e-6 * 1.01));
  for (const double f : {16e3, 20e3, 22e3})
    high = std::max(high, error_of_tone(f, 0.25e-6 * 1.01));
  for (const double f : {500., 8000., 20e3, 22e3})
    whole = std::max(whole, error_of_tone(f, 0.25e-6));
  verdict("a tone in samples of whole steps up to 22 kHz, to 1e-4", whole < 1e-4);
  verdict("of steps that do not divide the sample up to 8 kHz, to 5e-4", low < 5e-4);
  verdict("up to 22 kHz, to 0.03", high < 0.03);
  verdict("what is above a tenth more than the highest frequency is left out",
          error_of_tone(24.7e3, 0.25e-6) > 0.999 && error_of_tone(24.7e3, 0.25e-6) < 1.001);
  const double shift = Regular(recorded_times(20e-6, 0.7e-6, 141)).largest_shift();
  std::cout << "steps of 0.7 us shift samples by up to " << std::round(1e3 * shift) / 1e3
            << " of their distance\n";
  const double        h = 20e-6;
  std::vector<double> mean;
  const auto          velocity = [](const double t) { return std::pow(t, 3); };
  std::vector<double> recorded;
  for (std::size_t i = 0; i < 50; ++i)
    recorded.push_back(velocity(h * i));
  verdict("differences are means: their sum is the change of velocity",
          std::abs([&] {
            double sum = 0.;
            for (const double a : differences(recorded, h))
              sum += a * h;
            return sum / velocity(49 * h);
          }() - 1.) < 1e-12);
  // exact amplitudes, Pa per m/s2
  for (const auto &[frequency, exact] : {std::pair(288.25, 1.15221e-6),
                                         {1e3, 3.64590e-6},
                                         {4e3, 1.44235e-5},
                                         {10e3, 3.31593e-5},
                                         {20e3, 3.61585e-5}})
    verdict("a sphere at " + std::to_string(static_cast<int>(frequency)) + " Hz to 0.02 dB",
            std::abs(20. * std::log10(sphere(frequency) / exact)) < 0.02);
}
