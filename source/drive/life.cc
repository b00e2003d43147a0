// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/life.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace chaindrive::drive
{
using dealii::numbers::PI;

namespace
{
constexpr double test_cycles  = 3e6; // of the dynamic strength
constexpr double limit_cycles = 1e7; // below the force of which plates do not fail
} // namespace

double wear_factor(const Lubrication given, const Lubrication least, const double speed)
{
  if (given == Lubrication::none)
    return 1. / 0.15;
  return given >= least ? 1. : speed <= 4. ? 1. / 0.6 : 1. / 0.3;
}

double
JointWear::rate(const double force_angle, const double pitches, const double coefficient) const
{
  const double path = coefficient * force_angle * 0.5 * pin_diameter / bearing_area; // of a turn
  return path * pitches / links / pitch; // pins and bushes of two joints lengthen two pitches
}

double
JointWear::rate_of_losses(const double power, const double mu, const double coefficient) const
{
  return coefficient * power / (mu * links * bearing_area) / pitch;
}

double most_elongation(const unsigned int largest_teeth, const bool kept)
{
  return std::min(kept ? 0.015 : 0.03, 2. / largest_teeth);
}

double frame_hours(const double capacity, const double elongation, const double links)
{
  return 15000. * capacity * elongation / 0.03 * (links / 120.);
}

double PlateFatigue::from_zero(const double least, const double most) const
{
  const double part = tensile_strength > 0. ? std::max(least, 0.) / tensile_strength : 0.;
  return part < 1. ? (most - least) / (1. - part) : endless;
}

double PlateFatigue::endurance() const
{
  return dynamic_strength * std::pow(test_cycles / limit_cycles, 1. / plate_exponent);
}

PlateFatigue PlateFatigue::weaker(const double deviations) const
{
  return {dynamic_strength * (1. - deviations * plate_scatter), tensile_strength};
}

double PlateFatigue::cycles(const double least, const double most) const
{
  const double force = from_zero(least, most);
  return force <= endurance() ? endless :
                                test_cycles * std::pow(dynamic_strength / force, plate_exponent);
}

void add_turning_point(std::vector<double> &points, const double value)
{
  const std::size_t n = points.size();
  if (n > 0 && value == points[n - 1])
    return;
  // what goes on in the same direction replaces the last value
  if (n > 1 && (value > points[n - 1]) == (points[n - 1] > points[n - 2]))
    points.back() = value;
  else
    points.push_back(value);
}

std::vector<Cycle> rainflow(const std::vector<double> &history)
{
  std::vector<double> points;
  for (const double value : history)
    add_turning_point(points, value);
  std::vector<Cycle>  cycles;
  std::vector<double> open; // turning points that belong to no cycle yet
  const auto range = [&open](const std::size_t i) { return std::abs(open[i + 1] - open[i]); };
  const auto count = [&](const std::size_t i, const double n) {
    cycles.push_back({range(i), 0.5 * (open[i] + open[i + 1]), n});
  };
  for (const double point : points)
    {
      open.push_back(point);
      while (open.size() > 2 && range(open.size() - 2) >= range(open.size() - 3))
        if (const std::size_t n = open.size(); n == 3) // contains the start: half a cycle
          {
            count(0, 0.5);
            open.erase(open.begin());
          }
        else
          {
            count(n - 3, 1.);
            open.erase(open.end() - 3, open.end() - 1);
          }
    }
  for (std::size_t i = 0; i + 1 < open.size(); ++i)
    count(i, 0.5);
  return cycles;
}

std::vector<Cycle> rainflow_of_turn(const std::vector<double> &turn)
{
  std::vector<double> values = turn;
  std::rotate(values.begin(), std::max_element(values.begin(), values.end()), values.end());
  if (!values.empty())
    values.push_back(values.front());
  return rainflow(values);
}

double turns_of(const PlateFatigue &plates, const std::vector<Cycle> &cycles)
{
  double damage = 0.;
  for (const Cycle &cycle : cycles)
    damage +=
        cycle.count / plates.cycles(cycle.mean - 0.5 * cycle.range, cycle.mean + 0.5 * cycle.range);
  return damage > 0. ? 1. / damage : endless;
}

PlateStress plate_stress(const double                tension,
                         const double                height,
                         const double                waist_height,
                         const double                hole,
                         const double                thickness,
                         const std::optional<double> factor)
{
  const double force = 0.5 * tension, x = hole / height;
  const double net      = force / ((height - hole) * thickness);
  const double straight = 12.882 + x * (-52.714 + x * (89.762 - 51.667 * x)); // 0.15 <= x <= 0.75
  return {force / (waist_height * thickness), net, factor.value_or(straight) * net};
}

double hole_strength(const double pitch)
{
  const double p = 1e3 * pitch; // mm
  return 515e6 * std::pow(p, -0.0008 * p);
}

double seat_force(const double tension, const double teeth)
{
  const double a = 2. * PI / teeth, phi = PI / 180. * (35. - 120. / teeth);
  return tension * std::sin(a) / std::sin(a + phi);
}

PeakLife life_of_peaks(const std::vector<double> &peaks,
                       const double               seat,
                       const double               capacity,
                       const double               links)
{
  double mean = 0., damage = 0.;
  for (const double peak : peaks)
    {
      mean += peak / static_cast<double>(peaks.size());
      damage += std::pow(peak, roller_exponent) / static_cast<double>(peaks.size());
    }
  const double peak  = std::pow(damage, 1. / roller_exponent);
  const double rated = std::min(mean + (capacity - 1.) * seat, capacity * mean);
  return {peak,
          rated,
          peak > 0. ? 15000. * (links / 100.) * std::pow(rated / peak, roller_exponent) : endless};
}

PinStress pin_stress(const double tension,
                     const double diameter,
                     const double bore,
                     const double length,
                     const double bush_length)
{
  const double area    = 0.25 * PI * (diameter * diameter - bore * bore);
  const double modulus = PI / 32. * (std::pow(diameter, 4) - std::pow(bore, 4)) / diameter;
  const double moment  = 0.5 * tension * (0.5 * length - 0.25 * bush_length);
  return {moment / modulus, 0.5 * tension / area};
}
} // namespace chaindrive::drive
