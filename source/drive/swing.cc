// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/swing.h>
#include <chaindrive/files/file.h>
#include <chaindrive/functions/csv.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/rotation.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace chaindrive::drive
{
using dealii::Point;

namespace
{
constexpr double one_degree = dealii::numbers::PI / 180.; // rad

/// Half cosine waves from one of the angles to the next.
functions::Pointer waves(const parameters::Swing &given, const std::string &section, double start)
{
  if (given.times.size() != given.angles.size())
    throw InputError(section + "Angles in degrees has " + std::to_string(given.angles.size()) +
                     " values, but Times in ms has " + std::to_string(given.times.size()) +
                     "; give one for each time.");
  if (given.times.empty())
    throw InputError(section + "Pivot in mm is given, but nothing says how the arm turns; give "
                               "Times in ms and Angles in degrees, or File.");
  std::vector<functions::Pointer> waves;
  double                          time = 0., angle = 0.;
  for (std::size_t i = 0; i < given.times.size(); ++i)
    {
      if (given.times[i] - time < 1e-6)
        throw InputError(section + "Times in ms: " + to_text(1e3 * given.times[i], 7) +
                         " must be later than " + (i == 0 ? "the start, 0," : "the one before it") +
                         " by at least 0.001 ms: until then the arm turns.");
      waves.push_back(std::make_shared<functions::Ramp>(
          given.angles[i] - angle, start + time, given.times[i] - time, functions::Rise::cosine));
      time  = given.times[i];
      angle = given.angles[i];
    }
  return std::make_shared<functions::Sum>(waves);
}

functions::Pointer
table(const parameters::Swing &given, const std::string &section, const Parameters &p, Swing &swing)
{
  const std::string entry = section + "File = " + given.file;
  if (!given.times.empty() || !given.angles.empty())
    throw InputError(entry + " takes the place of Times in ms and Angles in degrees; leave these "
                             "empty, or the file.");
  try
    {
      swing.file       = files::find_file(given.file, p.folders);
      const auto found = functions::read_csv(swing.file, 1e-3, one_degree, p.time.start);
      for (const double angle : found->y())
        if (std::abs(angle) > dealii::numbers::PI)
          throw InputError("'" + swing.file + "' has the angle " + to_text(angle / one_degree) +
                           " degrees; numbers from -180 to 180 are allowed.");
      for (std::size_t i = 1; i < found->x().size(); ++i)
        if (found->x()[i] - found->x()[i - 1] < 1e-6)
          throw InputError("'" + swing.file + "' has points " + std::to_string(i) + " and " +
                           std::to_string(i + 1) +
                           " less than 0.001 ms apart; leave one of them out.");
      return found;
    }
  catch (const InputError &error)
    {
      throw InputError(entry + ": " + error.what());
    }
}
} // namespace

Point<2> Swing::centre(const Point<2> &start, const double turned) const
{
  const double               c = std::cos(turned), s = std::sin(turned);
  const dealii::Tensor<1, 2> arm = start - pivot;
  return {pivot[0] + c * arm[0] - s * arm[1], pivot[1] + s * arm[0] + c * arm[1]};
}

Swing make_swing(const Parameters &parameters, const unsigned int i, const Layout &layout)
{
  const parameters::Sprocket &wheel   = parameters.drive.sprockets.list[i];
  const parameters::Swing    &given   = wheel.swing;
  const std::string           of      = "Drive/Wheels/" + wheel.name + "/";
  const std::string           section = of + "Swing/";
  if (wheel.held.holder != parameters::Holder::bearing)
    throw InputError(section + "Pivot in mm is for wheels on bearings; choose auto for one with " +
                     of + "Held by = " + text_of(wheel.held.holder) + ".");
  if (wheel.bearing.stiffness)
    throw InputError(section + "Pivot in mm cannot be with " + of +
                     "Bearing/Stiffness in N/m = " + to_text(*wheel.bearing.stiffness) +
                     "; choose rigid, or Swing/Pivot in mm = auto.");
  if (wheel.runout > 0.)
    throw InputError(of + "Runout in um = " + to_text(1e6 * wheel.runout) +
                     " is for wheels whose axes stand still; choose 0, or Swing/Pivot in mm = "
                     "auto.");
  Swing swing;
  swing.pivot = {(*given.pivot)[0], layout.sense * (*given.pivot)[1]};
  if (swing.pivot.distance(layout.sprockets[i].centre) < 1e-3)
    throw InputError(section + "Pivot in mm must be at least 1 mm from the wheel's centre, or the "
                               "arm does not move the wheel.");
  swing.angle = given.file.empty() ? waves(given, section, parameters.time.start) :
                                     table(given, section, parameters, swing);
  if (layout.sense < 0)
    swing.angle = std::make_shared<functions::Product>(std::make_shared<functions::Constant>(-1.),
                                                       swing.angle);
  constexpr unsigned int n_looks = 1000;
  const double           start = parameters.time.start, length = parameters.time.end - start;
  for (unsigned int k = 0; k <= n_looks; ++k)
    {
      const double turned =
          swing.angle->value(start + k * length / n_looks) - swing.angle->value(start);
      swing.least = std::min(swing.least, turned);
      swing.most  = std::max(swing.most, turned);
    }
  return swing;
}

std::string in_words(const Swing                 &swing,
                     const parameters::Sprockets &wheels,
                     const unsigned int           i,
                     const Layout                &layout)
{
  constexpr unsigned int    n_looks = 100;
  const auto               &at      = layout.sprockets;
  const auto                n       = static_cast<unsigned int>(at.size());
  std::vector<unsigned int> neighbours{(i + n - 1) % n};
  if (n > 2)
    neighbours.push_back((i + 1) % n);
  std::string words = "The arm of the " + wheels.list[i].name + " turns between " +
                      to_text(swing.least / one_degree, 4) + " and " +
                      to_text(swing.most / one_degree, 4) + " degrees";
  for (const unsigned int other : neighbours)
    {
      double least = at[other].centre.distance(at[i].centre), most = least;
      words += "; from the " + wheels.list[other].name + " the wheel is " + in_mm(least, 6) +
               " away at the start";
      for (unsigned int k = 0; k <= n_looks; ++k)
        {
          const double turned   = swing.least + k * (swing.most - swing.least) / n_looks;
          const double distance = at[other].centre.distance(swing.centre(at[i].centre, turned));
          least                 = std::min(least, distance);
          most                  = std::max(most, distance);
        }
      words += ", then " + in_mm(least, 6) + " to " + in_mm(most, 6);
    }
  return words + ".";
}
} // namespace chaindrive::drive
