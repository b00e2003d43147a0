// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/world.h>
#include <chaindrive/contact/closed_pair.h>
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

/// Bodies that move by shapes and the springs between them, one of each part, joined as one pitch
/// of an endless chain is: where a pair of bodies is joined twice, as inner and outer link are, the
/// second joint is that with the next pitch. Its bodies move as those of this one, or against them.
/// A body that is joined on one side only, such as a roller, is there once for each of its kinds.
class CoupledShapes
{
public:
  /// Of those of @p kinds in which bodies that move by shapes take part; nothing if there are none,
  /// or if one of them is not between two such bodies or such a body and the ground, or if bodies
  /// may meet different ones with the same side.
  static std::optional<CoupledShapes> make(const World                   &world,
                                           const std::vector<ClosedKind> &kinds);

  /// The largest dt [s] with dt^2 K + 2 dt C <= 4 M.
  double stable_step();

private:
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
    std::vector<unsigned int> motions; ///< numbers of those that take part
    std::vector<Closed>       ways;
    unsigned int              way = 0; ///< the one at present
  };

  /// Adds a part's body.
  unsigned int add_body(const ModalGroup &group);

  /// Adds the ways of @p kind to @p interface, between the bodies that begin at motions @p first.
  void add_ways(const World                       &world,
                const ClosedKind                  &kind,
                const std::array<unsigned int, 2> &first,
                bool                               closes_pitch,
                Interface                         &interface);

  /// The matrix for a step @p dt, 1/s2.
  void assemble(double dt, Matrix &matrix) const;

  /// Looks for the ways of all contacts with the largest eigenvalue for a step @p dt [s]: those
  /// with the largest Rayleigh quotients of the fastest motion, again and again, from several
  /// beginnings.
  void find_worst(double dt);

  std::vector<double>    free_; ///< squared frequencies of all motions, 1/s2
  std::vector<Interface> interfaces_;
};
} // namespace chaindrive::stability
