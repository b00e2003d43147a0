// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/parameters/choice.h>

#include <optional>
#include <string>
#include <vector>

namespace chaindrive::parameters
{
class Declarations;

/// Section `Time`.
struct Time
{
  double                start = 0.;           ///< s
  double                end   = 30e-3;        ///< s
  std::optional<double> step;                 ///< s; auto: from accuracy and the critical time step
  double                safety_factor = 0.9;  ///< largest accepted step / critical time step
  double                energy_limit  = 0.05; ///< imbalance / drive work at which a run stops
  bool                  guard         = true; ///< whether dynamics::Guard looks at more than that

  /// Declares an entry for each member, which takes every value that is set. The object must
  /// outlive @p declarations.
  void declare(Declarations &declarations);
};

/// What a run may be asked for: a group of quantities, or fields.
enum class QuantityGroup
{
  speeds,
  tensions,
  tooth_forces,
  joint_forces,
  roller_motion,
  engagements,
  surface_velocity,
  plate_stress,
  energy,
  fields
};

template <>
inline constexpr Texts<QuantityGroup, 10> texts_of<QuantityGroup>{
    {{QuantityGroup::speeds, "speeds"},
     {QuantityGroup::tensions, "tensions"},
     {QuantityGroup::tooth_forces, "tooth forces"},
     {QuantityGroup::joint_forces, "joint forces"},
     {QuantityGroup::roller_motion, "roller motion"},
     {QuantityGroup::engagements, "engagements"},
     {QuantityGroup::surface_velocity, "surface velocity"},
     {QuantityGroup::plate_stress, "plate stress"},
     {QuantityGroup::energy, "energy"},
     {QuantityGroup::fields, "fields"}}};

/// With how many digits the histories of single rollers, links, joints and teeth are stored.
enum class Precision
{
  single,
  full
};

template <>
inline constexpr Texts<Precision, 2> texts_of<Precision>{
    {{Precision::single, "single"}, {Precision::full, "double"}}};

/// Section `Output`.
/// A mean value of the summary, and how exactly it is to be known.
struct Wanted
{
  std::string output;      ///< such as driver_peak_mean
  double      uncertainty; ///< half of the 95 % confidence interval over the mean
};

struct Output
{
  std::vector<QuantityGroup> quantities; ///< that are asked for; empty: all that the scene has

  /// Whether @p group is asked for by its name.
  bool names(QuantityGroup group) const;

  /// Whether it is asked for, by its name or among all.
  bool asks_for(const QuantityGroup group) const { return quantities.empty() || names(group); }

  std::string               directory;                ///< empty: results/<name of the .prm file>
  double                    history_interval = 20e-6; ///< s
  Precision                 precision        = Precision::single;
  std::optional<double>     field_interval   = 1e-3; ///< s; 0: none; empty: auto
  std::vector<unsigned int> rollers;                 ///< chosen rollers; empty: all
  bool                      csv          = false;    ///< histories as CSV beside HDF5
  std::optional<double>     window_start = 10e-3;    ///< s, of the averages; empty: when settled
  std::optional<double>     window_end;              ///< s; auto: the end of the run
  unsigned int              window_pitches = 10;     ///< length of a window that waits
  std::vector<Wanted>       until; ///< the run ends when all are known; empty: at its end time
  double                    checkpoint_interval = 0.;   ///< s, simulated; 0: none at such times
  double                    checkpoint_wait     = 600.; ///< s, elapsed; 0: none at such times
  double                    wall_clock_limit    = 0.;   ///< s, elapsed; 0: none
  std::string               resume; ///< empty: a new run; auto: the newest checkpoint; its file

  /// Declares an entry for each member, which takes every value that is set. The object must
  /// outlive @p declarations.
  void declare(Declarations &declarations);
};
} // namespace chaindrive::parameters
