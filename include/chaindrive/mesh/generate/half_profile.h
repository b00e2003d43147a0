// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/tooth_form.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace chaindrive::mesh
{
/// The profile of a sprocket from the bottom of gap 0, on +x, to the middle of the next tooth's
/// tip, by its arc length s [m].
class HalfProfile
{
public:
  explicit HalfProfile(const drive::ToothForm &form);

  double           length() const { return ends_.back(); }
  double           tip_start() const { return ends_[ends_.size() - 2]; } ///< where the flank ends
  dealii::Point<2> at(double s) const;

  /// Unit tangent, towards the tip.
  dealii::Tensor<1, 2> tangent(double s) const;

  /// Where the tangent has turned clockwise by @p angle [rad] since the bottom; the end of an arc
  /// if that is within ten degrees.
  double where_turned_by(double angle) const;

  /// Points from @p first to @p last in steps of about @p size, with one where two arcs meet.
  std::vector<dealii::Point<2>> divide(double first, double last, double size) const;

  /// @p n equal steps from @p first to @p last.
  std::vector<dealii::Point<2>> divide(double first, double last, unsigned int n) const;

private:
  /// The segment at @p s and the fraction of it that lies before.
  const drive::Segment &find(double s, double &fraction) const;

  std::vector<drive::Segment> segments_;
  std::vector<double>         ends_; ///< arc length at the end of each segment
};
} // namespace chaindrive::mesh
