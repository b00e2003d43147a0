// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/reduction/round_flexibility.h>

#include <deal.II/base/aligned_vector.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace chaindrive::contact
{
/// By how much gaps between a cylinder and its bore grow under the normal forces between them
/// without any inertia: what both sides deflect beside their modes, at the nodes of the cylinder
/// that the bore covers. It is the same wherever around the axis the window is that may touch.
class JointFlexibility
{
public:
  /// Flexibilities of the two sides. Nodes of the cylinder lie between rings of the bore and, where
  /// these are others in number, between its columns.
  JointFlexibility(const reduction::RoundFlexibility &bore,
                   const reduction::RoundFlexibility &cylinder);

  /// Rings of the cylinder inside the bore.
  const std::vector<unsigned int> &rings() const { return rings_; }
  unsigned int n_rings() const { return static_cast<unsigned int>(rings_.size()); }
  unsigned int n_columns() const { return n_columns_; }

  /// Where ring k of rings() is along the bore: between its rings first and first + 1, at this part
  /// of the way.
  struct Place
  {
    unsigned int first;
    double       part;
  };
  const std::vector<Place> &places() const { return places_; }

  /// Between two of rings(), by number, so many columns apart, at most a round, m/N.
  double at(const unsigned int r, const unsigned int s, const unsigned int columns) const
  {
    return sum_[(std::size_t(r) * n_rings() + s) * n_columns_ + columns % n_columns_];
  }

  /// The matrix of so many columns side by side, [column][ring] twice, m/N: rows as
  /// ComplementarityProblem wants them.
  struct Matrix
  {
    unsigned int                  n = 0, stride = 0;
    dealii::AlignedVector<double> number;
  };
  const Matrix &of_columns(unsigned int count) const;

private:
  unsigned int                                 n_columns_;
  std::vector<unsigned int>                    rings_;
  std::vector<Place>                           places_;
  std::vector<double>                          sum_;      ///< [ring][ring][columns between]
  mutable std::vector<std::unique_ptr<Matrix>> matrices_; ///< by columns, once needed
};
} // namespace chaindrive::contact
