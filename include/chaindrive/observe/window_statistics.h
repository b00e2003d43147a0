// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/files/described.h>
#include <chaindrive/files/json.h>
#include <chaindrive/observe/observation.h>
#include <chaindrive/utilities/archive.h>
#include <chaindrive/utilities/batch_means.h>
#include <chaindrive/utilities/signal_statistics.h>

#include <initializer_list>
#include <string>
#include <vector>

namespace chaindrive::observe
{
/// What the summary says of signals over the window of the averages (Window): `statistics`. The
/// harmonics are those of the tooth frequency: their phase is the driver's angle times its number
/// of teeth. The uncertainty of a mean is that of means over tooth periods, in batches of at least
/// a period of the drive's slowest resonance.
class WindowStatistics
{
public:
  /// What a signal is called in files, its unit, and what it is called in sentences.
  struct Signal
  {
    std::string name, unit, title = {};
  };

  /// Members of the summary for @p signals.
  static std::vector<files::Described> members(const std::vector<Signal> &signals);

  /// Of @p signals of the run that @p now observes, which must outlive this.
  WindowStatistics(const Observation &now, const std::vector<Signal> &signals);

  /// Their @p values at the end of a step, in the same order.
  void add(const std::vector<double> &values) { add(values.data(), values.size()); }
  void add(const std::initializer_list<double> values) { add(values.begin(), values.size()); }

  /// The pieces of the last step in whole tooth periods of the window, for means over these.
  const std::vector<WholeRevolutions::Piece> &pieces() const { return *pieces_; }

  /// The mean of a signal; not a number when nothing fell into the window.
  double mean(const std::string &name) const;

  /// Adds to `statistics` a member for each signal, and the number of whole tooth periods.
  void summarize(files::Json &summary) const;

  /// InputError when the run that goes on has another window, as far as the run has gone.
  void serialize(const Archive &archive);

private:
  void add(const double *values, std::size_t n);

  struct Item
  {
    Signal           signal;
    SignalStatistics statistics;
    RevolutionMeans  tooth_periods; ///< its means in them
  };

  const Observation &now_;
  const World::Hub  *driver_ = nullptr; ///< null in a scene without
  double             teeth_  = 0.;      ///< of the driver, positive where its angle grows
  WholeRevolutions   tooth_periods_;
  std::vector<Item>  items_;

  const std::vector<WholeRevolutions::Piece> *pieces_ = nullptr;
};
} // namespace chaindrive::observe
