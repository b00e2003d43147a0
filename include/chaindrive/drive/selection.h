// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/life.h>
#include <chaindrive/drive/ratings.h>

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace chaindrive::drive
{
/// What a designer begins with.
struct Demand
{
  double                     power;           ///< of the load, W
  double                     speed;           ///< of the driver, rad/s
  double                     ratio;           ///< speed of the driver over that of the driven shaft
  double                     centre_distance; ///< about, m
  double                     hours = 15000.;  ///< how long the chain is to last
  Motor                      motor = Motor::electric; ///< what drives
  Shock                      shock = Shock::smooth;   ///< how the load pulls
  std::optional<Lubrication> lubrication;             ///< empty: what the speed asks for

  unsigned int strands = 3; ///< at most
};

/// A drive for that, judged by closed forms. SI units.
struct Candidate
{
  std::string  chain;
  unsigned int strands, driver_teeth, driven_teeth, links;
  double       centre_distance, chain_speed;
  Lubrication  lubrication; ///< the least that the speed asks for
  double       mass;        ///< of chain and sprockets, discs as wide as their teeth, kg

  double capacity;   ///< rated power of all strands over the power with its service factor
  double breaking;   ///< tensile strength over the force with its service factor, of all strands
  double dynamic;    ///< endurance of the plates over that force
  double pressure;   ///< of a joint without the service factor, Pa
  double wear_hours; ///< until its elongation is most_elongation()
  double
      frame_hours; ///< the same in the frame of ISO 10823: 15,000 hours of 3 % at the rated power
  double roller_hours, plate_hours; ///< until rollers or bushes, until plates fail
  double impact;                    ///< largest speed at which a roller meets a tooth, m/s
  double sound;                     ///< dB(A) at 0.3 m, see below

  double hours() const; ///< the shortest of wear_hours, roller_hours and plate_hours

  /// What speaks against it, a sentence each.
  std::vector<std::string> faults;
};

/// Speed [m/s] at which a roller meets a tooth along the normal: p w sin(phi + 360 / z) with the
/// pressure angle phi = 35 - 120 / z degrees (Binder and Covert 1948).
double impact_speed(double pitch, double teeth, double speed);

/// Sound level [dB(A)] at 0.3 m of an oiled chain: impacts of a pitch of chain of this @p mass [kg]
/// at these @p impacts [m/s] on two sprockets, so many a second, radiate the same part of their
/// power as in the one level that Tsubaki's Complete Guide to Chain has: RS80, 16 teeth, 123 rpm,
/// 57 dB(A).
double sound_estimate(double mass, const std::vector<double> &impacts, double per_second);

/// All chains of ISO 606 with one and more strands and 13 to 31 teeth, judged, those without faults
/// first. Among these the order is that of mass, which counts a tenth more for each further strand;
/// of each chain and number of strands there is the lightest one alone. Others come in the order of
/// the number of their faults and their capacity. InputError for a demand that has no sense.
std::vector<Candidate> select_drives(const Demand &demand);

/// The table of the best, at most @p rows.
void print(std::ostream                 &out,
           const Demand                 &demand,
           const std::vector<Candidate> &candidates,
           unsigned int                  rows);

/// A chart of the same as SVG: bars of life, safety, size, speed of impact and sound for each.
void draw(std::ostream                 &out,
          const Demand                 &demand,
          const std::vector<Candidate> &candidates,
          unsigned int                  rows);
} // namespace chaindrive::drive
