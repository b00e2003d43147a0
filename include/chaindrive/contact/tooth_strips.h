// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/contact/strip_flexibility.h>
#include <chaindrive/drive/tooth_form.h>

#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

namespace chaindrive::contact
{
/// The profile about a gap between two teeth in strips side by side, from a little beyond the
/// middle of one tooth to beyond that of the other, in the frame of gap 0. They are narrow where
/// the profile is convex or straight, so that rollers of @p radius [m] touch it in a line, and wide
/// in the seat.
class ToothStrips
{
public:
  ToothStrips(const drive::ToothForm &form, double radius);

  struct Strip
  {
    dealii::Tensor<1, 2>                middle; ///< m
    std::array<dealii::Tensor<1, 2>, 2> gauss;  ///< points of the rule of Gauss, m
    std::array<dealii::Tensor<1, 2>, 2> ends;   ///< m
  };

  const std::vector<Strip> &strips() const { return strips_; }

  /// Sets @p numbers to those of the strips whose middles are no farther than @p distance [m] from
  /// the point @p centre [m], ascending.
  void find_near(const dealii::Tensor<1, 2> &centre,
                 double                      distance,
                 std::vector<unsigned int>  &numbers) const;

  /// Of each strip the angle between the normal of the seat there and that at the bottom of the
  /// gap, with the sign of its side; on flanks that of the end of the seat, rad.
  const std::vector<double> &slopes() const { return slopes_; }

  /// Where they are round a roller that rolls along the profile, from the bottom of the gap.
  const StripGrid &grid() const { return grid_; }

private:
  std::vector<Strip>  strips_;
  StripGrid           grid_;
  std::vector<double> slopes_;
  std::vector<double> x_, y_; ///< of their middles, made up to blocks by points far away, m

  /// A circle about the middles of a block.
  struct Block
  {
    dealii::Tensor<1, 2> centre; ///< m
    double               radius; ///< m
  };
  std::vector<Block> blocks_;
};
} // namespace chaindrive::contact
