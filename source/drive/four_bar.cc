// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/four_bar.h>
#include <chaindrive/drive/outline.h>
#include <chaindrive/path/span.h>
#include <chaindrive/utilities/errors.h>

namespace chaindrive::drive
{
using dealii::Point;
using dealii::Tensor;

double four_bar_ratio(const double       centre_distance,
                      const double       pitch,
                      const unsigned int driver_teeth,
                      const unsigned int driven_teeth,
                      const double       phase)
{
  const path::LinkLengths lengths{pitch, pitch};
  const path::Wheel       driver(driver_teeth, Point<2>(), lengths);
  const path::Wheel       driven(driven_teeth, Point<2>(centre_distance, 0.), lengths);
  const auto              spans = path::taut_spans(
      driven, driver, lengths, 1000000, path::entries_near_tangent(driven, driver, phase));
  if (spans.empty())
    throw InputError("No straight span fits between the sprockets.");
  const path::TautSpan span  = spans.front();
  const Tensor<1, 2>   along = span.to - span.from;
  // both ends have the same velocity along the rigid span
  return cross(span.to - driver.centre, along) / cross(span.from - driven.centre, along);
}

std::vector<double> four_bar_ratios(const double       centre_distance,
                                    const double       pitch,
                                    const unsigned int driver_teeth,
                                    const unsigned int driven_teeth,
                                    const unsigned int n)
{
  std::vector<double> ratios;
  for (unsigned int i = 0; i < n; ++i)
    ratios.push_back(four_bar_ratio(
        centre_distance, pitch, driver_teeth, driven_teeth, static_cast<double>(i) / n));
  return ratios;
}
} // namespace chaindrive::drive
