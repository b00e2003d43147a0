// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/world.h>
#include <chaindrive/contact/closed_pair.h>
#include <chaindrive/contact/family.h>
#include <chaindrive/scene/contact_law.h>

#include <deal.II/lac/full_matrix.h>

#include <array>
#include <optional>
#include <vector>

namespace chaindrive::stability
{
/// One kind of contact, all of it closed.
struct ClosedKind
{
  contact::ClosedPair sides;
  scene::ContactLaw   law;
  double              time = 0.; ///< damping time c/k, s
};

/// All kinds of contact of @p family, closed.
std::vector<ClosedKind> closed_kinds(const World &world, const contact::Family &family);

/// Modal bodies and the springs between them: a Floquet analysis of one pitch.
///
/// An endless straight chain, all of whose pitches are closed alike, vibrates in waves: each pitch
/// moves as the one before times exp(i q). Here one body of each part is joined as one pitch is;
/// where a pair of bodies is joined twice, as inner and outer link are, the second joint is that
/// with the next pitch, and closes with q = 0, the next pitch moves alike, or q = pi, it moves in
/// opposition. By symmetry (q and -q are waves in opposite directions) the largest frequency is
/// stationary at both. If a single spring joins the pitches it is monotone in cos q, so that one of
/// the two is the largest of all. A joint is many springs of about the same motion: waves between
/// the two, and chains whose pitches are closed in different ways, may be faster. doc/theory.md has
/// what has been measured. A body that is joined on one side only, such as a roller, is there once
/// for each of its kinds.
///
/// Where a contact touches in part, it does so about one of n_directions: one way to close. The
/// limit is that of the ways found by find_worst().
class CoupledModes
{
public:
  using Matrix = dealii::FullMatrix<double>;

  /// One way in which a contact may be closed.
  struct Closed
  {
    Matrix matrix; ///< in terms of the motions of the interface, 1/s2
    double time;   ///< damping time, s
  };

  /// The contact of two bodies, or of one with the ground.
  struct Interface
  {
    std::vector<unsigned int>
                        motions; ///< numbers of those that take part: the slave's, the master's
    std::vector<Closed> ways;
    unsigned int        n_slave_motions = 0;
    bool                closes_pitch    = false; ///< ways with q = 0, then those with pi
  };

  using Ways = std::vector<unsigned int>; ///< one of each interface

  /// Of those of @p kinds in which modal bodies take part; nothing if there are none,
  /// or if one of them is not between two such bodies or such a body and the ground, or if bodies
  /// may meet different ones with the same side.
  static std::optional<CoupledModes> make(const World &world, const std::vector<ClosedKind> &kinds);

  /// The largest dt [s] with dt^2 K + 2 dt C <= 4 M for the ways of find_worst().
  double critical_time_step() const;

  /// The step without contacts [s], for which critical_time_step() looks for the worst ways: these
  /// matter more than how strong the dampers are.
  double free_step() const;

  /// Looks for the ways of all contacts with the largest eigenvalue for a step @p dt [s]: those
  /// with the largest Rayleigh quotients of the fastest motion, again and again, from several
  /// beginnings. A local maximum, and so a lower estimate of the largest frequency.
  Ways find_worst(double dt) const;

  /// The largest eigenvalue when contacts close in @p ways, for a step @p dt [s], 1/s2.
  double eigenvalue(const Ways &ways, double dt) const;

  const std::vector<double>    &free() const { return free_; } ///< see below
  const std::vector<Interface> &interfaces() const { return interfaces_; }

private:
  /// Adds a part's body.
  unsigned int add_body(const ModalGroup &group);

  /// Adds the ways of @p kind to @p interface, between the bodies that begin at motions @p first.
  void add_ways(const World                       &world,
                const ClosedKind                  &kind,
                const std::array<unsigned int, 2> &first,
                bool                               closes_pitch,
                Interface                         &interface);

  /// The matrix of @p ways for a step @p dt, 1/s2.
  void assemble(const Ways &ways, double dt, Matrix &matrix) const;

  std::vector<double>    free_; ///< squared frequencies of all motions without contacts, 1/s2
  std::vector<Interface> interfaces_;
};
} // namespace chaindrive::stability
