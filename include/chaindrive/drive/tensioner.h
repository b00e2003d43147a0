// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/parameters/drive.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <limits>
#include <string>

namespace chaindrive::drive
{
/// The force of a tensioner over its travel q and its speed: a spring with a damper, which may be
/// another one while it retracts, between two stops. Positive forces and travel take up slack:
///
///   F = F0 - k q - c(q') q' + stops,  c = c1 for q' > 0, c2 for q' < 0
///
/// A stop is a spring with a damper beyond its place, which never pulls. Of an arm q is an angle
/// [rad] and F a moment [N m], of a slide a way [m] and a force [N].
struct TensionerLaw
{
  double preload = 0., stiffness = 0.;          ///< F0, k
  double damping = 0., retracting_damping = 0.; ///< c1, c2
  double least          = -std::numeric_limits<double>::infinity();
  double most           = std::numeric_limits<double>::infinity();
  double stop_stiffness = 0., stop_damping = 0.;

  double elastic(double travel) const;               ///< of spring and stops
  double viscous(double travel, double speed) const; ///< what dampers take of that
  double energy(double travel) const;                ///< stored, J; not below zero
  double rate(double travel) const;                  ///< -d elastic / d travel
  double force(const double travel, const double speed) const
  {
    return elastic(travel) - viscous(travel, speed);
  }

  /// Largest stiffness and damping that it can have at a travel.
  double stiffest() const { return stiffness + stop_stiffness; }
  double most_damping() const
  {
    return (damping > retracting_damping ? damping : retracting_damping) + stop_damping;
  }
};

/// A wheel of a drive whose axis is on an arm or a slide; law, inertia and weight are the share of
/// one strand.
struct Tensioner
{
  unsigned int         wheel;
  parameters::Holder   holder;    ///< any but a bearing
  dealii::Point<2>     reference; ///< of the wheel's centre without travel, m
  dealii::Point<2>     pivot;     ///< of an arm, m
  dealii::Tensor<1, 2> direction; ///< of a slide, unit: the one that takes up slack
  int                  sense;     ///< of an arm, +1: counter-clockwise takes up slack
  TensionerLaw         law;
  double               inertia;     ///< of the arm about its pivot, kg m2, or of the slide, kg
  double               weight = 0.; ///< of all that moves with the wheel's centre, along -y, N
  double               travel = 0.; ///< at the start

  bool is_arm() const { return parameters::turns(holder); }
  bool is_clamped() const { return parameters::is_clamped(holder); }

  /// Way of the wheel's centre per travel: the length of the arm, m, or 1.
  double lever() const { return is_arm() ? reference.distance(pivot) : 1.; }

  /// The wheel's centre at @p travel, and its first and second derivative.
  dealii::Point<2>     centre(double travel) const;
  dealii::Tensor<1, 2> way(double travel) const;
  dealii::Tensor<1, 2> bend(double travel) const;

  /// Where the arm has taken what is at @p p without travel.
  dealii::Point<2> turned(const dealii::Point<2> &p) const;

  /// Takes the mass of its wheel [kg], of which its weight and the damping of its stops follow: a
  /// fifth of critical damping.
  void carry(double wheel, double gravity);

  /// A travel with the unit of its entry, such as "12 degrees".
  std::string with_unit(double travel) const;

  /// A sentence that says where it is and how it presses on all @p strands, with this @p slack [m]
  /// in the chain; @p point is where an arm's lever ends.
  std::string in_words(const std::string &wheel,
                       double             slack,
                       unsigned int       strands,
                       const std::string &point = "the wheel's axis") const;

  /// y -> -y.
  void mirror();
};

/// Number of the wheel of @p sprockets that is a tensioner; 0, that of the driver: there is none.
unsigned int tensioned_wheel(const parameters::Sprockets &sprockets);

/// The law that entries ask for, of which a strand has its @p share; @p lever as
/// Tensioner::lever(). Without the damping of its stops, see Tensioner::carry().
TensionerLaw make_law(const parameters::Tensioner &given, double share, double lever);

/// The tensioner of @p drive, which has one, in a drive that turns counter-clockwise, before it is
/// known which way it takes up slack: @p reverse tells.
Tensioner make_tensioner(const parameters::Drive &drive, bool reverse);

/// Refuses (InputError) a tensioner that its wheel or @p drive cannot have.
void check_tensioner(const parameters::Drive &drive);

/// The same drive with the wheel of a spring standing still where its centre is given.
parameters::Drive without_tensioner(const parameters::Drive &drive);
} // namespace chaindrive::drive
