// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/forces/force_element.h>

#include <vector>

namespace chaindrive
{
/// Resistance [N s/m] of the oil that two cylinders squeeze out of the gap between them, of the
/// relative @p radius R = 1 / (1/r_1 + 1/r_2) [m], counted negative where one is hollow: force over
/// the velocity with which the least @p thickness h [m] of the film falls. Reynolds' equation with
/// the parabola h + x^2 / 2R: a film that is long has no flow along its @p length L [m],
///   12 pi mu L (R / 2h)^(3/2),
/// one that is short no flow across it,
///   3 pi / 8 mu L^3 (2R)^(1/2) h^(-5/2),
/// and the flows of both resist side by side, so that their reciprocals add up (Pinkus and
/// Sternlicht, Theory of Hydrodynamic Lubrication, 1961, squeeze films). The gap is no wider than
/// the roller: R is at most @p roller^2 / 2h. @p viscosity mu [Pa s].
double
squeeze_resistance(double viscosity, double length, double radius, double thickness, double roller);

/// A film between two surfaces that yield with a stiffness k, that of their contact: with the gap g
/// of the surfaces as if rigid, negative where they overlap, and the thickness h of the film, it
/// bears the force k (h - g), by which it becomes thinner, h' = -k (h - g) / c(h). Where nothing is
/// left of it, h = 0, the surfaces bear on each other as contact has it, with -k g; so that the
/// film has what is left, k (h - max(g, 0)), and both together are never stiffer than the contact
/// alone. A gap that opens is full of oil at once, and oil does not pull.
struct SqueezedFilm
{
  double thickness = -1.; ///< h, m; below zero: there is no film
  double gap       = 0.;  ///< g, m
  double force     = 0.;  ///< that the film adds to that of contact, N
  double stored    = 0.;  ///< what that has bent the surfaces by, J

  /// To the @p new_gap after the time @p dt [s], under the resistance @p c at this thickness
  /// [N s/m], by the implicit Euler method. Returns what was lost meanwhile, J.
  double advance(double new_gap, double stiffness, double c, double dt);

  template <typename BoostArchive>
  void serialize(BoostArchive &archive, unsigned int)
  {
    archive &thickness &gap &force &stored;
  }
};

/// The squeeze films of a chain: of each roller on its bush, and on the tooth nearest to it of each
/// wheel. They act along the line of centres of roller and bush and along the normal of the tooth;
/// that they resist sliding is not in it, nor the time in which a gap fills.
///
/// Surfaces are rough: a film below roughness() resists as one of that thickness.
class OilFilm : public ForceElement
{
public:
  explicit OilFilm(scene::OilFilms films);

  std::unique_ptr<ForceElement> clone() const override { return std::make_unique<OilFilm>(*this); }
  std::string                   name() const override { return "oil film"; }
  void                          add_forces(World &world, double dt) override;
  std::optional<double>         lost() const override { return lost_; }

  /// None: no film is stiffer than the contact that it is before, whose spring is counted as if it
  /// were closed.
  void add_springs(const World & /*world*/, std::vector<Spring> & /*springs*/) const override {}
  void serialize(const Archive &archive) override;

  static constexpr double roughness() { return 1e-6; } ///< m, of both surfaces together

private:
  /// One film at the @p gap [m] of cylinders of the relative radius @p radius [m]; the force on the
  /// roller is along @p normal, on @p other the opposite, at @p at.
  void squeeze(SqueezedFilm               &film,
               double                      gap,
               double                      radius,
               double                      length,
               double                      stiffness,
               unsigned int                roller,
               unsigned int                other,
               const dealii::Tensor<1, 3> &normal,
               const dealii::Tensor<1, 3> &at,
               double                      dt,
               World                      &world);

  scene::OilFilms           films_;
  std::vector<SqueezedFilm> states_; ///< of bushes, then of the rollers on each wheel
  double                    lost_ = 0.;
};
} // namespace chaindrive
