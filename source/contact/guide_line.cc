// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/guide_line.h>
#include <chaindrive/path/curve.h>

#include <algorithm>
#include <utility>

namespace chaindrive::contact
{
GuideLine::GuideLine(const scene::GuideFamily &family)
    : Surface(family.body)
    , curve_(family.curve)
    , at_centres_(family.at_centres)
    , depth_(family.depth)
    , reach_(0.)
{
  const dealii::Point<2> middle = curve_->at(0.5 * curve_->n_pieces());
  for (unsigned int d = 0; d < 2; ++d)
    middle_[d] = middle[d];
  constexpr unsigned int n = 8;
  for (unsigned int i = 0; i <= n * curve_->n_pieces(); ++i)
    reach_ = std::max(reach_, middle.distance(curve_->at(static_cast<double>(i) / n)));
  reach_ *= 1.05; // between these points
  for (unsigned int piece = 0; piece < curve_->n_pieces(); ++piece)
    {
      Chord chord{curve_->at(piece), curve_->at(piece + 1.) - curve_->at(piece), 0.};
      constexpr unsigned int n_points = 64;
      for (unsigned int i = 1; i < n_points; ++i)
        chord.bulge =
            std::max(chord.bulge, distance_from(chord, curve_->at(piece + double(i) / n_points)));
      chord.bulge *= 1.05; // between these points
      chords_.push_back(chord);
    }
  if (depth_ == 0.)
    return;
  const double last = curve_->n_pieces(), near = 1e-6;
  for (const auto &[end, beside] : {std::make_pair(0., near), {last, last - near}})
    {
      End          rounded;
      unsigned int hint = curve_->n_pieces();
      const auto   at   = curve_->at(end);
      rounded.outwards  = at - curve_->at(beside);
      rounded.outwards /= rounded.outwards.norm();
      rounded.at     = at;
      rounded.centre = at - depth_ * curve_->nearest(curve_->at(beside), hint).normal;
      ends_.push_back(rounded);
    }
}

double GuideLine::distance_from(const Chord &chord, const dealii::Point<2> &p)
{
  const dealii::Tensor<1, 2> arm  = p - chord.from;
  const double               part = arm * chord.along / chord.along.norm_square();
  return (arm - std::clamp(part, 0., 1.) * chord.along).norm();
}

bool GuideLine::is_beyond(const dealii::Point<2> &p, const double distance) const
{
  return std::all_of(chords_.begin(), chords_.end(), [&](const Chord &chord) {
    return distance_from(chord, p) > distance + chord.bulge;
  });
}

path::Nearest GuideLine::nearest(const dealii::Point<2> &p, unsigned int &hint) const
{
  for (const End &end : ends_)
    if ((p - end.at) * end.outwards > 0. && p.distance(end.at) < 4. * depth_)
      {
        const dealii::Tensor<1, 2> arm = p - end.centre;
        const double               r   = arm.norm();
        if (r > 0.)
          return {r - depth_, arm / r};
      }
  return curve_->nearest(p, hint);
}

Touch GuideLine::project(const World                &world,
                         const dealii::Tensor<1, 3> &x,
                         const double                radius,
                         double /*within*/,
                         unsigned int &hint,
                         Projection & /*projection*/) const
{
  const Frame               &frame = world.frames[body()];
  const dealii::Tensor<1, 3> local = transpose(frame.rotation) * (x - frame.position);
  const dealii::Point<2>     p(local[0], local[1]);
  Touch                      touch;
  if (is_beyond(p, 2. * depth_ + radius))
    return touch;
  const path::Nearest nearest = this->nearest(p, hint);
  const double        middle = nearest.distance + depth_, side = middle < 0. ? -1. : 1.;
  touch.gap = side * middle - depth_ - radius;
  if (touch.gap < 0.)
    {
      dealii::Tensor<1, 3> normal;
      normal[0]    = side * nearest.normal[0];
      normal[1]    = side * nearest.normal[1];
      touch.normal = frame.rotation * normal;
      touch.point  = at_centres_ ? x : x - radius * touch.normal;
      set_tangents(touch, frame);
    }
  return touch;
}

bool GuideLine::is_near(const World                &world,
                        const dealii::Tensor<1, 3> &x,
                        const double                radius,
                        const double                reach) const
{
  const Frame         &frame = world.frames[body()];
  dealii::Tensor<1, 3> arm   = transpose(frame.rotation) * (x - frame.position) - middle_;
  arm[2]                     = 0.;
  return arm.norm() < reach_ + radius + reach;
}
} // namespace chaindrive::contact
