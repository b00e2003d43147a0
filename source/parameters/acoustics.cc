// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/parameters/acoustics.h>
#include <chaindrive/parameters/entries.h>

#include <deal.II/base/utilities.h>

#include <cmath>
#include <sstream>
#include <string>

namespace chaindrive::parameters
{
namespace
{
using Point = std::array<double, 3>;

/// Points "x y z; x y z", in m; empty if @p text is something else.
std::optional<std::vector<Point>> read_points(const std::string &text)
{
  std::vector<Point> points;
  for (const std::string &words : dealii::Utilities::split_string_list(text, ';'))
    {
      std::istringstream in(words);
      std::string        word;
      Point              point{};
      for (double &coordinate : point)
        {
          in >> word;
          const auto number = in ? from_entry_text(word, unit::si) : std::nullopt;
          if (!number || !(std::abs(*number) <= 1e3))
            return {};
          coordinate = *number;
        }
      if (in >> word)
        return {};
      points.push_back(point);
    }
  return points.empty() ? std::nullopt : std::make_optional(points);
}

void add_switch(Declarations      &declarations,
                const std::string &name,
                bool              &member,
                const std::string &meaning)
{
  add_choice(declarations,
             name,
             member ? "on" : "off",
             {"on", "off"},
             meaning,
             [&member](const std::string &text) { member = text == "on"; });
}
} // namespace

void Acoustics::declare(Declarations &declarations)
{
  const Subsection section(declarations, "Acoustics", OnResume::may_change);
  add_switch(declarations,
             "Noise",
             noise,
             "Whether a run computes the noise of its rollers in its window at its end, as the "
             "command noise does for the directory of a run (doc/theory.md). The histories must "
             "contain the motion of all rollers.");
  declarations.add(
      "Observers",
      "auto",
      "auto, or points in m, three numbers each, separated by semicolons",
      "Points where the pressure is computed, such as 0.1 0.5 0; 0.1 -0.5 0.2 in the axes of the "
      "results: the driver rotates about the origin, the driven sprocket is at positive x, shafts "
      "are along z. auto: a microphone on the normal of the tight span, and twelve points on half "
      "a cylinder, both around the point where rollers meet the driver.",
      [](const std::string &text) { return text == "auto" || read_points(text).has_value(); },
      [this](const std::string &text) {
        observers = text == "auto" ? std::vector<Point>() : *read_points(text);
      });
  add(declarations,
      "Radius in m",
      radius,
      unit::si,
      between(0.05, 1e3),
      "Distance of the microphone, and radius of the half cylinder and of the arc of the "
      "directivity. Default: as measured by Zheng, Wang and Quek.");
  add(declarations,
      "Floor height in m",
      floor,
      unit::si,
      between(-1e3, 1e3),
      "y of a rigid floor, below the drive and all observers. off: none, as in a fully anechoic "
      "room.",
      "off");
  add(declarations,
      "Highest frequency in kHz",
      highest_frequency,
      unit::kilo,
      above(0., 1e3),
      "Highest frequency of the pressure; a zero-phase low-pass filter removes the rest within a "
      "tenth of it. auto: the edge of the 20 kHz band, or as far as the samples of the histories "
      "allow.");
  add_switch(declarations,
             "Finite rollers",
             finite_rollers,
             "Whether rollers radiate as spheres of finite size with the same dipole: 0.3 dB less "
             "at 8 kHz and 6 dB less at 20 kHz for a roller of 10 mm. off: compact dipoles.");
  add(declarations,
      "Air density in kg/m3",
      air_density,
      unit::si,
      above(0., 1e3),
      "Default: at 20 degrees Celsius and 1013 hPa.");
  add(declarations,
      "Speed of sound in m/s",
      speed_of_sound,
      unit::si,
      between(100., 1e4),
      "Default: in this air.");
}
} // namespace chaindrive::parameters
