// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/rest.h>

#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

namespace chaindrive::drive
{
/// Of the largest tension: the forces left over at which a search ends that comes no further,
/// because a roller creeps over a kink in the curvature of its seat.
inline constexpr double creeping = 1e-3;

/// Energy, forces and stiffness of a drive at rest, and its minimum by Newton's method. Unknowns
/// are the joints, the angles of wheels that are free, the axes of wheels on bearings that yield,
/// and the travel of a tensioner.
class Equilibrium
{
public:
  using Vector = dealii::Tensor<1, 2>;
  using Matrix = dealii::Tensor<2, 2>;

  Equilibrium(Layout                          &layout,
              const RestingChain              &chain,
              const std::vector<RestingWheel> &wheels,
              double                           centrifugal = 0.,
              const RestingGuide              *guide       = nullptr);

  /// Moves the shaft that the layout found away from that of wheel 0, and the chain with it, as if
  /// what leads to it were stretched alike.
  void move_shaft(double by);

  /// Finds the equilibrium to @p tolerance [N]; false if there seems to be none. Stiff seats are
  /// approached from soft ones: on these, fewer rollers are about to leave their teeth. What has a
  /// curve of stiffness is a spring with its secant, until that is the one at its force.
  bool solve(double tolerance);

  /// By which something is out of balance, N.
  double largest_force() const;

  /// Of the link from joint @p k on, N.
  double tension(unsigned int k) const;

  /// Puts what was found into the layout.
  void store() const;

private:
  static constexpr double largest_move = 0.5e-3; // m, of a joint in one iteration
  static constexpr double nudge        = 1e-9;   // m, for differences of contact forces

  /// The same with springs as they are, from where the chain is.
  bool minimize(double tolerance);

  /// Gives springs the secants of their curves at their forces; returns by which share one has
  /// changed at most.
  double take_secants();

  /// Where joint @p k, which overlaps wheel @p i by @p depth along @p normal, touches it: the place
  /// of @p curve, one of teeth.
  double place_on(unsigned int          k,
                  unsigned int          i,
                  double                depth,
                  const Vector         &normal,
                  const StiffnessCurve &curve) const;

  double stiffness(unsigned int k) const { return of_links_[k]; }

  /// Of the link from joint @p k on, without load, m. Joints are at the ends of outer links.
  double length(unsigned int k) const;

  /// Of joint @p k on wheel @p i, which it overlaps by @p depth, N.
  double seat_force(unsigned int k, unsigned int i, double depth) const;

  /// Of the contact of joint @p k with wheel @p i, N/m.
  double contact_stiffness(unsigned int k, unsigned int i) const;

  /// The guide's arm turns as a wheel does, by the moment of its spring.
  bool   is_arm(const unsigned int i) const { return guide_ && i == n_wheels_ && !wheels_[i].held; }
  double travel_of_guide() const;

  /// Of the pitch circle of wheel @p i, turned on by @p turn.
  dealii::Point<2> centre(unsigned int i, double turn) const;

  /// By how much a joint's point at @p p overlaps wheel @p i, turned on by @p turn; very negative
  /// where it is far from it. @p normal points away from the wheel.
  double overlap(unsigned int i, const dealii::Point<2> &p, double turn, Vector &normal) const;

  /// Where the roller of joint @p k is: a loaded one lies on the tooth, and the bush in
  /// it, along one normal; one that hangs on its bush beside the teeth takes the room that they
  /// leave.
  dealii::Point<2> roller(unsigned int k) const;

  /// Derivatives of a contact's energy by the joint's position and the wheel's way at its lever;
  /// returns the energy.
  double contact(unsigned int            k,
                 unsigned int            i,
                 const dealii::Point<2> &p,
                 double                  turn,
                 std::array<double, 3>  &gradient) const;

  /// Of joint @p k with wheel @p i, which is unknown @p f if it is not held.
  void add_contact(unsigned int k, unsigned int i, unsigned int f);

  /// Energy [J] at the present state; its derivatives become members.
  double assemble();

  /// Adds to the derivatives by the travel of the tensioner what those of its wheel's contact with
  /// joint @p k are: @p gradient and @p second ones by the joint's position and the wheel's way at
  /// its lever.
  void add_travel(unsigned int                                k,
                  const std::array<double, 3>                &gradient,
                  const std::array<std::array<double, 3>, 3> &second);

  /// Moves the wheel of the tensioner, or the guide on a slide, to its present travel.
  void place_tensioner();

  /// A wheel whose axis yields.
  struct OnBearing
  {
    unsigned int wheel;
    unsigned int first; ///< of its two unknowns
    Vector       way;   ///< of its axis from where nothing pulls at it, m
  };

  /// Moves the wheels on bearings to where they are, and adds what their springs store to the
  /// energy and its derivatives.
  void add_bearings();

  /// Adds to the derivatives by the place of the axis of @p on what those of its wheel's contact
  /// with joint @p k are, the wheel being unknown @p f if it is not held: @p gradient and
  /// @p second ones as in add_travel().
  void add_axis(const OnBearing                            &on,
                unsigned int                                k,
                unsigned int                                f,
                const std::array<double, 3>                &gradient,
                const std::array<std::array<double, 3>, 3> &second);

  /// What the contacts of all joints turn wheel @p i by, counter-clockwise, N m.
  double moment_on(unsigned int i) const;

  /// Solves (H + shift) step = -gradient: joints 1 ... n-1 are a block tridiagonal matrix, joint 0
  /// and the free wheels, the unknowns without neighbours on one side, its border. False where the
  /// matrix is not positive definite.
  bool newton_step(double shift);

  Layout                       &layout_;
  const RestingChain           &chain_;
  std::vector<RestingWheel>     wheels_; ///< behind those of the layout the guide
  const unsigned int            n_, n_wheels_;
  const RestingGuide           *guide_;
  const Tensioner              *moving_ = nullptr; ///< what moves by travel_
  std::vector<Layout::Sprocket> frames_;           ///< of wheels, and the guide
  const double                  contact_radius_;
  std::vector<double>           of_links_;    ///< behind each joint, N/m
  std::vector<double>           of_seats_;    ///< of each joint on each wheel and guide, N/m
  std::vector<double>           of_bushes_;   ///< of each joint, N/m
  const double                  centrifugal_; ///< what turning its momentum takes of the tension, N

  std::vector<unsigned int>     free_;        ///< wheels that are not held
  std::vector<dealii::Point<2>> at_;          ///< of the joints, m
  std::vector<double>           turned_;      ///< per wheel and guide, rad
  double                        travel_ = 0.; ///< of the tensioner
  std::vector<OnBearing>        on_bearings_;
  double                        energy_ = 0.;

  // unknowns besides joints: the ways of free wheels at their levers, of axes on bearings, and of
  // the tensioner, m
  std::vector<Vector>              gradient_;
  std::vector<std::vector<Vector>> to_wheel_; ///< second derivatives by an unknown and a joint
  std::vector<Matrix>              diagonal_, to_next_;
  std::vector<double>              wheel_gradient_, wheel_diagonal_; ///< per unknown
  double                           wheel_to_travel_ = 0.; ///< of the tensioner and its wheel
  std::vector<std::vector<double>> between_; ///< per unknown of bearings and earlier unknown
  std::vector<Vector>              step_;
  std::vector<double>              wheel_step_;
};
} // namespace chaindrive::drive
