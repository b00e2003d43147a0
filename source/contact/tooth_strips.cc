// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/tooth_strips.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::contact
{
namespace
{
using dealii::Tensor;
using drive::ToothForm;

// over the radius of a roller
constexpr double narrow = 0.0125, wide = 0.09, growth = 0.25;
constexpr double beyond          = 0.2; ///< the middle of a tooth
constexpr double strip_round_off = 1e-12;

constexpr unsigned int n_in_block = 8; ///< strips whose distances are compared side by side

/// The point of the half profile @p length [m] from the bottom of the gap; it goes on beyond the
/// middle of the tooth as its mirror image, and before the bottom likewise.
Tensor<1, 2> point_at(const ToothForm &form, const double length)
{
  if (length < 0.)
    {
      Tensor<1, 2> x = point_at(form, -length);
      x[1]           = -x[1];
      return x;
    }
  double left = length;
  for (const drive::Segment &segment : form.half_profile)
    {
      const double whole = segment.length();
      if (whole > 0. && left <= (1. + strip_round_off) * whole)
        return segment.point(std::min(1., left / whole));
      left -= std::max(0., whole);
    }
  // mirrored across the middle of the tooth
  double all = 0.;
  for (const drive::Segment &segment : form.half_profile)
    all += segment.length();
  const Tensor<1, 2> x      = point_at(form, std::min(all, std::max(0., 2. * all - length)));
  const double       angle  = form.pitch_angle(); // twice that of the middle
  const double       cosine = std::cos(angle), sine = std::sin(angle);
  Tensor<1, 2>       mirrored;
  mirrored[0] = cosine * x[0] + sine * x[1];
  mirrored[1] = sine * x[0] - cosine * x[1];
  return mirrored;
}

/// Ends of strips from the bottom of a gap, 0, to beyond the middle of the tooth, m; one is there.
std::vector<double> ends_of(const ToothForm &form, const double radius)
{
  double all = 0.;
  for (const drive::Segment &segment : form.half_profile)
    all += segment.length();
  const double seat = form.flat ? 0. : form.half_profile.front().length();
  // from the end of the seat to the bottom wider and wider, made up to a whole number
  std::vector<double> widths;
  double              sum = 0.;
  for (double width = narrow; sum < seat; sum += width * radius)
    {
      width = std::min(wide, width * (1. + growth));
      widths.push_back(width * radius);
    }
  std::vector<double> ends = {0.};
  for (std::size_t i = widths.size(); i-- > 0;)
    ends.push_back(ends.back() + widths[i] * seat / sum);
  const auto   n    = static_cast<unsigned int>(std::ceil((all - seat) / (narrow * radius)));
  const double flat = (all - seat) / n;
  const auto   more = static_cast<unsigned int>(std::ceil(beyond / narrow));
  for (unsigned int i = 1; i <= n + more; ++i)
    ends.push_back(seat + i * flat);
  return ends;
}
} // namespace

ToothStrips::ToothStrips(const ToothForm &form, const double radius)
{
  const std::vector<double> half = ends_of(form, radius);
  const drive::Segment     &seat = form.half_profile.front();
  std::vector<double>       ends;
  for (std::size_t i = half.size(); i-- > 1;)
    ends.push_back(-half[i]);
  ends.insert(ends.end(), half.begin(), half.end());
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    {
      const double middle = 0.5 * (ends[i] + ends[i + 1]), wide = 0.5 * (ends[i + 1] - ends[i]);
      grid_.middle.push_back(middle / radius);
      grid_.half_width.push_back(wide / radius);
      slopes_.push_back(std::clamp(middle, -seat.length(), seat.length()) / seat.radius);
      Strip strip;
      strip.middle = point_at(form, middle);
      for (const unsigned int g : {0u, 1u})
        {
          strip.gauss[g] = point_at(form, middle + (g == 0 ? -wide : wide) / std::sqrt(3.));
          strip.ends[g]  = point_at(form, ends[i + g]);
        }
      strips_.push_back(strip);
      x_.push_back(strip.middle[0]);
      y_.push_back(strip.middle[1]);
    }
  for (std::size_t first = 0; first < x_.size(); first += n_in_block)
    {
      const std::size_t end = std::min(x_.size(), first + n_in_block);
      Block             block{0.5 * (strips_[first].middle + strips_[end - 1].middle), 0.};
      for (std::size_t i = first; i < end; ++i)
        block.radius = std::max(block.radius, (strips_[i].middle - block.centre).norm());
      blocks_.push_back(block);
    }
  constexpr double far_away = 1e6; // m
  x_.resize((x_.size() + n_in_block - 1) / n_in_block * n_in_block, far_away);
  y_.resize(x_.size(), far_away);
}

void ToothStrips::find_near(const Tensor<1, 2>        &centre,
                            const double               distance,
                            std::vector<unsigned int> &numbers) const
{
  const double square = distance * distance, x = centre[0], y = centre[1];
  numbers.clear();
  for (unsigned int first = 0; first < x_.size(); first += n_in_block)
    {
      const Block &block = blocks_[first / n_in_block];
      const double reach = (1. + strip_round_off) * (distance + block.radius);
      if ((block.centre - centre).norm_square() > reach * reach)
        continue;
      double       of[n_in_block];
      unsigned int any = 0;
      for (unsigned int i = 0; i < n_in_block; ++i)
        {
          const double dx = x_[first + i] - x, dy = y_[first + i] - y;
          of[i] = dx * dx + dy * dy;
        }
      for (const double d : of)
        any |= d <= square ? 1U : 0U;
      for (unsigned int i = 0; any != 0 && i < n_in_block; ++i)
        if (of[i] <= square)
          numbers.push_back(first + i);
    }
}
} // namespace chaindrive::contact
