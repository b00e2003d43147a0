// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/acoustics/dipole.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace chaindrive::acoustics
{
double added_mass(const double length_over_diameter)
{
  // boundary elements of bodies of revolution, which give a sphere 0.4998
  static const std::array<std::pair<double, double>, 11> table = {{{shortest_cylinder, 0.272},
                                                                   {0.5, 0.414},
                                                                   {0.689, 0.489},
                                                                   {0.98, 0.575},
                                                                   {1., 0.580},
                                                                   {1.2, 0.623},
                                                                   {2., 0.735},
                                                                   {2.5, 0.777},
                                                                   {5., 0.878},
                                                                   {10., 0.936},
                                                                   {1e9, 1.}}};
  if (!(length_over_diameter >= table.front().first))
    throw std::logic_error("added_mass: the cylinder is a disc");
  // nearly linear in the inverse
  const auto above = std::upper_bound(
      table.begin(), table.end() - 1, length_over_diameter, [](const double x, const auto &entry) {
        return x < entry.first;
      });
  const auto  &below = *(above - 1);
  const double share =
      (1. / below.first - 1. / length_over_diameter) / (1. / below.first - 1. / above->first);
  return below.second + share * (above->second - below.second);
}

double dipole_mass(const Air &air, const double radius, const double length)
{
  const double volume = dealii::numbers::PI * radius * radius * length;
  return air.density * volume * (1. + added_mass(0.5 * length / radius));
}

void add_pressure(const Air                  &air,
                  const Source               &source,
                  const dealii::Tensor<1, 3> &observer,
                  const Grid                 &grid,
                  std::vector<double>        &pressure)
{
  if (source.position.size() != source.grid.size ||
      source.acceleration.size() != source.grid.size || pressure.size() != grid.size)
    throw std::logic_error("add_pressure: fields and grids do not belong together");
  // (n . a)/r and (n . a)/r2, by the time when they are received
  struct ReceivedSound
  {
    double time, far, near;
  };
  std::vector<ReceivedSound> received;
  received.reserve(source.grid.size);
  for (std::size_t i = 0; i < source.grid.size; ++i)
    {
      const dealii::Tensor<1, 3> arm  = observer - source.position[i];
      const double               r    = arm.norm();
      const double               far  = arm * source.acceleration[i] / (r * r);
      const double               time = source.grid.time(i) + r / air.speed;
      if (!received.empty() && !(time > received.back().time))
        throw InputError("Acoustics/Speed of sound in m/s = " + to_text(air.speed, 4) +
                         ": a roller comes faster than that at " +
                         to_text(source.grid.time(i) * 1e3, 5) +
                         " ms, and sound is computed of slower ones.");
      received.push_back({time, far, far / r});
    }
  const double factor = source.mass / (4. * dealii::numbers::PI);
  auto         next   = received.begin();
  for (std::size_t i = 0; i < grid.size; ++i)
    {
      const double time = grid.time(i);
      next =
          std::find_if(next, received.end(), [&](const ReceivedSound &h) { return h.time > time; });
      if (next == received.end())
        break;
      if (next == received.begin())
        continue;
      // the rate of change in the middles between emissions, linear between these
      const auto   first  = next - 1;
      const double middle = 0.5 * (first->time + next->time);
      const auto   rate   = [](const auto &a, const auto &b) {
        return (b.far - a.far) / (b.time - a.time);
      };
      double       change = rate(*first, *next);
      const double share  = (time - first->time) / (next->time - first->time);
      if (time < middle && first != received.begin())
        {
          const auto   before = first - 1;
          const double from   = 0.5 * (before->time + first->time);
          change += (time - middle) / (middle - from) * (change - rate(*before, *first));
        }
      else if (time > middle && next + 1 != received.end())
        {
          const auto   after = next + 1;
          const double to    = 0.5 * (next->time + after->time);
          change += (time - middle) / (to - middle) * (rate(*next, *after) - change);
        }
      const double near = first->near + share * (next->near - first->near);
      pressure[i] += factor * (change / air.speed + near);
    }
}
} // namespace chaindrive::acoustics
