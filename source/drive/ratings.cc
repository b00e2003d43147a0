// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/ratings.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace chaindrive::drive
{
namespace
{
constexpr double horsepower = 745.7; // W
} // namespace

double Ratings::plates() const
{
  return horsepower * (0.004 * std::pow(teeth, 1.08) * std::pow(rpm, 0.9) *
                       std::pow(pitch, 3. - 0.07 * pitch) * (light ? 0.55 : 1.));
}

double Ratings::rollers() const
{
  const double factor = light ? 3.4 : (rollerless ? 29. : 17.);
  return horsepower * (1000. * factor * std::pow(teeth, 1.5) * std::pow(pitch, 0.8) /
                       std::pow(std::max(rpm, 1.), 1.5));
}

double Ratings::power() const { return std::min(plates(), rollers()); }

double Ratings::speed() const
{
  const double inside =
      82.5 / (std::pow(7.95, pitch) * std::pow(1.0278, teeth) * std::pow(1.323, tension / 1000.));
  return 1000. * std::pow(inside, 1. / (1.59 * std::log10(pitch) + 1.873));
}

Ratings ratings_of(const std::string &designation,
                   const double       pitch,
                   const double       teeth,
                   const double       rpm,
                   const double       tension)
{
  return {pitch / 0.0254,
          teeth,
          rpm,
          tension / 4.448,
          designation == "41" || designation == "085",
          pitch < 10e-3};
}

double hours_of_rollers(const double rating, const double power, const double links)
{
  return 15000. * (links / 100.) * std::pow(rating / power, 2.5);
}

double strand_factor(const unsigned int strands)
{
  constexpr std::array<double, most_strands> factors = {{1., 1.7, 2.5, 3.3, 3.9, 4.6}};
  return factors.at(strands - 1);
}

double service_factor(const Motor motor, const Shock shock)
{
  constexpr double factors[3][3] = {{1., 1.3, 1.5}, {1., 1.2, 1.4}, {1.2, 1.4, 1.7}};
  return factors[static_cast<int>(motor)][static_cast<int>(shock)];
}

Lubrication least_lubrication(const double pitch, const double speed)
{
  // 300 ft/min at half an inch and 100 at two; 2300 and 1000
  const double inches = pitch / 0.0254, foot_per_minute = 0.3048 / 60.;
  const double manual = 300. * std::pow(inches / 0.5, -std::log(3.) / std::log(4.)),
               bath   = 2300. * std::pow(inches / 0.5, -std::log(2.3) / std::log(4.)),
               v      = speed / foot_per_minute;
  return v <= manual                   ? Lubrication::manual :
         v <= std::sqrt(manual * bath) ? Lubrication::drip :
         v <= bath                     ? Lubrication::bath :
                                         Lubrication::forced;
}

std::optional<double> minimum_dynamic_strength(const std::string &designation)
{
  static const std::map<std::string, double> table = {
      {"04C", 630.},    {"06C", 1410.},   {"085", 1340.},   {"08A", 2480.},   {"10A", 3850.},
      {"12A", 5490.},   {"16A", 9550.},   {"20A", 14600.},  {"24A", 20500.},  {"28A", 27300.},
      {"32A", 34800.},  {"36A", 44500.},  {"40A", 53600.},  {"48A", 73100.},  {"05B", 820.},
      {"06B", 1290.},   {"08B", 2480.},   {"10B", 3330.},   {"12B", 3720.},   {"16B", 9530.},
      {"20B", 13500.},  {"24B", 19700.},  {"28B", 27100.},  {"32B", 29900.},  {"40B", 41800.},
      {"48B", 63600.},  {"60H", 6320.},   {"80H", 10700.},  {"100H", 16000.}, {"120H", 22200.},
      {"140H", 29200.}, {"160H", 36900.}, {"180H", 45400.}, {"200H", 56500.}, {"240H", 81400.}};
  static const std::map<std::string, std::string> ansi  = {{"25", "04C"},
                                                           {"35", "06C"},
                                                           {"41", "085"},
                                                           {"40", "08A"},
                                                           {"50", "10A"},
                                                           {"60", "12A"},
                                                           {"80", "16A"},
                                                           {"100", "20A"},
                                                           {"120", "24A"},
                                                           {"140", "28A"},
                                                           {"160", "32A"},
                                                           {"180", "36A"},
                                                           {"200", "40A"},
                                                           {"240", "48A"}};
  const auto                                      other = ansi.find(designation);
  const auto found = table.find(other == ansi.end() ? designation : other->second);
  return found == table.end() ? std::nullopt : std::make_optional(found->second);
}

double dynamic_strength_of_plates(const double pitch,
                                  const double height,
                                  const double thickness,
                                  const double roller_diameter,
                                  const double pin_diameter)
{
  const double p    = 1e3 * pitch;
  const double bush = 1e3 * pin_diameter * std::pow(roller_diameter / pin_diameter, 0.475);
  const double area = 2e3 * thickness * (0.99e3 * height - bush); // mm2
  return 134.5 * area * std::pow(p, -0.0008 * p);
}
} // namespace chaindrive::drive
