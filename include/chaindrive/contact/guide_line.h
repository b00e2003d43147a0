// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/contact/surface.h>
#include <chaindrive/path/curve.h>
#include <chaindrive/scene/interface.h>

namespace chaindrive::contact
{
/// The line of a guide on a rigid body, along which the edges of plates slide.
class GuideLine : public Surface
{
public:
  explicit GuideLine(const scene::GuideFamily &family);

  /// Behind the line is a strip of twice the depth of the family, for circles of no thickness, both
  /// sides of which keep slaves off: one that has gone round an end and comes back from behind
  /// meets it as from the front, without a jump of the gap.
  Touch project(const World                &world,
                const dealii::Tensor<1, 3> &x,
                double                      radius,
                double                      within,
                unsigned int               &hint,
                Projection                 &projection) const override;

  bool needs_search() const override { return true; }
  bool is_near(const World                &world,
               const dealii::Tensor<1, 3> &x,
               double                      radius,
               double                      reach) const override;

private:
  /// An end of the line: nodes, whose plates are polygons, meet it rounded by the depth of the
  /// family, others by their own radius.
  struct End
  {
    dealii::Point<2>     at, centre; ///< of the rounding, m
    dealii::Tensor<1, 2> outwards;   ///< along the line, unit
  };

  /// A piece of the line lies within the bulge of the chord between its ends.
  struct Chord
  {
    dealii::Point<2>     from;  ///< m
    dealii::Tensor<1, 2> along; ///< to the other end, m
    double               bulge; ///< m
  };

  static double distance_from(const Chord &chord, const dealii::Point<2> &p); ///< m

  /// Whether @p p is farther than @p distance [m] from all of the line: told by its chords, which
  /// is far cheaper than to find the nearest point.
  bool is_beyond(const dealii::Point<2> &p, double distance) const;

  /// As that of the line, with its rounded ends.
  path::Nearest nearest(const dealii::Point<2> &p, unsigned int &hint) const;

  std::vector<End>                   ends_; ///< of a line for nodes
  std::vector<Chord>                 chords_;
  std::shared_ptr<const path::Curve> curve_;
  bool                               at_centres_;
  double                             depth_;  ///< see scene::GuideFamily, m
  dealii::Tensor<1, 3>               middle_; ///< in the body's frame, m
  double                             reach_;  ///< of the line about it, m
};
} // namespace chaindrive::contact
