// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/dynamics/fault_diagnosis.h>
#include <chaindrive/dynamics/observer.h>
#include <chaindrive/dynamics/system.h>
#include <chaindrive/utilities/archive.h>
#include <chaindrive/utilities/errors.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace chaindrive::dynamics
{
/// A run has gone wrong: the message says what, where and when, and what to try. All ranks throw it
/// at the same step.
class Fault : public RunError
{
public:
  /// @p valid_until [s] is the an instant long enough ago that nothing was wrong then: a fault is
  /// found within 100 steps.
  Fault(const std::string &message, const double valid_until)
      : RunError(message), valid_until_(valid_until)
  {
  }

  double valid_until() const { return valid_until_; } ///< s; a later checkpoint is not to be used

private:
  double valid_until_;
};

/// Keeps the energy turned over and the largest imbalance of the ledger, and tells when it does not
/// close.
///
/// Of every energy that a run turns over there is one line of the ledger that it comes from and one
/// that it goes to. So the energy turned over is half of the sum of the sizes of all lines, stored
/// energies, that at the start, losses and works, and the largest that this has been so far: it
/// never falls, and what one line gains from another does not cancel in it.
class EnergyGuard
{
public:
  /// @p limit is the accepted |imbalance| / energy turned over.
  explicit EnergyGuard(double limit) : limit_(limit) {}

  /// False when the balance is off by more than the limit, or is not a number. @p floor [J] is an
  /// energy below which nothing is judged, so that the first moments of a run are not divided by
  /// nearly zero: so much at least counts as turned over.
  bool closes(const Ledger &ledger, double floor);

  double limit() const { return limit_; }
  double turned_over() const { return turned_over_; }   ///< J
  double largest_imbalance() const { return largest_; } ///< |imbalance|, J

  void serialize(const Archive &archive)
  {
    archive("turned over", turned_over_);
    archive("largest", largest_);
  }

private:
  double limit_;
  double turned_over_ = 0.;
  double largest_     = 0.;
};

/// Stops a run that has gone wrong, and says where it did.
///
/// At every step the ledger must close (EnergyGuard), which nothing passes that is not a number. At
/// every 16th step there is a closer look, at numbers that World::sum_over_ranks() has made the
/// same on all ranks:
///
/// - Momentum. When all forces between bodies are equal and opposite,
///     sum m v - sum m v at the start + integral of (force on hubs - gravity - drag) dt
///   is zero to round-off with central differences, whatever the step: a reaction that is lost or
///   has the wrong sign stays in it. Only along x and y in symmetry models and where plates do not
///   bend out of their planes.
/// - Energy. No loss and no stored energy is negative, the imbalance does not jump from one look to
///   the next by more than the step explains, and the losses do not fall.
/// - Penetration. No surfaces overlap by Family::penetration_limit(): a contact that pulls instead
///   of pushing gets there in a few steps. What one rank sees is a Request::alarm, and all ranks
///   stop at the next step.
///
/// A step above the critical one is found when something blows up: in the simple and full models
/// within 32 steps at 1.3 times the limit, in the layered one within 100 at 1.6 times, since the
/// bound of rigid joints takes all of them for closed at once, along the worst of directions.
/// Moment of momentum is not balanced:
/// a lost moment is found when its work is too much of the energy, or not at all; the tests
/// contact/forces_cancel, joint_forces_cancel and plate_faces look at moments.
///
/// The limits and what valid runs come to are at the top of guard.cc.
class Guard : public Observer
{
public:
  /// @p limit as in EnergyGuard; @p critical_time_step [s] is that of @p system. When not @p on,
  /// the ledger must close, that is all. @p overload: what is known before the run of loads that
  /// the drive does not stand, in sentences; a message names it before it advises on steps and
  /// contacts. @p scene must outlive this.
  Guard(const scene::Scene &scene,
        const System       &system,
        double              limit,
        double              critical_time_step,
        bool                on       = true,
        std::string         overload = "");

  /// Checks the state after a step; throws Fault. Collective.
  void observe(const System &system, unsigned long step, double dt, Services &services) override;

  bool        asks_for_bodies() const override { return true; }
  std::string name() const override { return "guard"; }
  void        serialize(const Archive &archive, const System &system) override;

  const EnergyGuard &energy() const { return energy_; }

  /// Whether there is a closer look, and the largest error of the balance of momentum that it has
  /// found, over the largest sum of all |m v| so far.
  bool   looks() const { return on_; }
  double largest_momentum_error() const { return largest_error_; }

  /// The largest jump of the imbalance from one look to the next, or fall of a loss, or energy
  /// below zero, over the energy of springs.
  double largest_energy_jump() const { return largest_jump_; }

private:
  using Vector3 = dealii::Tensor<1, 3>;

  struct Finding
  {
    std::string            what, hint;
    std::vector<FaultSite> places;
  };

  Finding ledger_does_not_close(const System &system, Services &services) const;

  /// What is wrong at a look, @p dt [s] after the step before it.
  std::optional<Finding> update(const System &system, double dt, Services &services);
  std::optional<Finding> look_at_momentum(const System &system, double dt, Services &services);
  std::optional<Finding> look_at_energy(const System &system, double dt, Services &services);

  /// What the step @p dt [s] makes wrong of the energy of the fastest vibration.
  double error_of_step(double dt) const;

  /// Energy [J] that is the least to count as turned over.
  double smallest_turned_over(double dt) const;

  /// Whether this rank sees surfaces that overlap too far.
  bool overlaps(const System &system) const;

  /// Where forces do not balance; or else, what moves and pulls most. @p last as in
  /// faults_of_balance().
  std::vector<FaultSite>
  suspects(const System &system, const LastStep *last, double dt, Services &services) const;

  /// Momentum of all that moves freely [kg m/s]; @p size becomes the sum of its parts' sizes.
  Vector3 momentum(const World &world, double &size) const;

  /// Sum of m u [kg m], whose rate drag acts on.
  Vector3 moved(const World &world) const;

  static Vector3 force_on_hubs(const World &world);

  /// Remembers velocities and forces of @p world for faults_of_balance(), which needs those of
  /// elastic bodies.
  void remember(const World &world);

  const scene::Scene &scene_;
  EnergyGuard         energy_;
  double              least_energy_;       ///< that is judged, J
  double              critical_time_step_; ///< s; infinite where bodies have nodes of their own
  bool                on_;
  std::string         overload_;
  unsigned int        calls_ = 0; ///< since the last look
  double              valid_until_;

  std::array<double, 8> looked_; ///< instants of the last looks, s

  std::vector<double> mass_; ///< of each body that moves freely, whole, kg; 0: of hubs
  double              total_mass_;
  double              start_time_;
  Vector3             start_momentum_, start_moved_;
  double              largest_momentum_;   ///< sum of the sizes so far, kg m/s
  double              largest_error_ = 0.; ///< of the balance, over that
  double              largest_jump_  = 0.; ///< of energy, over that of springs
  Vector3             hub_force_;          ///< after the last step, N
  Vector3             hub_impulse_;        ///< N s
  Ledger              before_;             ///< at the last look
  LastStep            last_;               ///< the step before a look; empty: nothing is elastic
};
} // namespace chaindrive::dynamics
