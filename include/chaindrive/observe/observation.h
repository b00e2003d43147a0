// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/dynamics/services.h>
#include <chaindrive/dynamics/system.h>
#include <chaindrive/model/model.h>
#include <chaindrive/observe/spans.h>
#include <chaindrive/observe/window.h>
#include <chaindrive/scene/scene.h>
#include <chaindrive/utilities/signal_statistics.h>
#include <chaindrive/utilities/to_first_rank.h>

#include <vector>

namespace chaindrive::observe
{
/// What quantities look at: the system after a step, and what several of them need of it, found
/// once.
class Observation
{
public:
  /// @p pitches_per_period: whole pitch times that hold a period of the drive's slowest resonance.
  Observation(const scene::Scene     &scene,
              const model::Model     &model,
              const dynamics::System &system,
              unsigned int            pitches_per_period = 1);
  Observation(const Observation &)            = delete;
  Observation &operator=(const Observation &) = delete;

  /// The system has gone a step of @p dt [s]; with @p services, of which not all bodies may be up
  /// to date. Collective.
  void next(double dt, dynamics::Services *services = nullptr);

  /// dynamics::Services::update_bodies().
  void update_bodies() const
  {
    if (services_ != nullptr)
      services_->update_bodies();
  }

  double time() const { return system.world.time; } ///< s
  double dt() const { return dt_; }                 ///< the step that led here, 0 at the start, s

  /// Tensions of links and the state of the spans. First rank only, which has all records of
  /// contacts.
  const Spans &spans() const;

  /// The pieces of the step that lie in the window, each within a tooth period: the phase is the
  /// driver's angle times its number of teeth. To be asked for at every step, or at none.
  const std::vector<WholeRevolutions::Piece> &tooth_pieces() const;

  /// What that counts.
  WholeRevolutions &tooth_periods() const { return tooth_periods_; }

  /// The largest contact pressure [family][joint] by all families of contacts, Pa; empty of those
  /// that know none: of all ranks on the first one. Collective once a step.
  const std::vector<std::vector<double>> &pressures() const;

  /// Of the averages.
  const Window &window() const { return window_; }

  /// What it remembers from step to step. Collective.
  void serialize(const Archive &archive) { window_.serialize(archive / "window"); }

  const scene::Scene       &scene;
  const model::Model       &model;
  const dynamics::System   &system;
  std::vector<unsigned int> rollers;       ///< joints whose rollers histories are asked for
  std::vector<unsigned int> roller_bodies; ///< their bodies

private:
  double              dt_       = 0.;
  dynamics::Services *services_ = nullptr; ///< of the present step
  mutable Spans       spans_;
  mutable bool        spans_known_ = false, pressures_known_ = false, tooth_pieces_known_ = false;
  mutable std::vector<std::vector<double>> pressures_;
  mutable SumOnFirstRank                   on_first_rank_; ///< of pressures
  Window                                   window_;
  const World::Hub                        *driver_ = nullptr; ///< null in a scene without
  double                   teeth_ = 0.; ///< of the driver, positive where its angle grows
  mutable WholeRevolutions tooth_periods_;
  mutable const std::vector<WholeRevolutions::Piece> *tooth_pieces_ = nullptr;
};
} // namespace chaindrive::observe
