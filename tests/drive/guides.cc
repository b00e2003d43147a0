// SPDX-License-Identifier: LGPL-2.1-or-later
// Guides beside the spans of a drive: their material is where the chain is not, also in a mirrored
// drive; those that cannot be are refused with the entry and what is wrong.
#include "compare.h"

#include <chaindrive/drive/drive.h>
#include <chaindrive/drive/guide.h>

#include <array>
#include <functional>

using namespace chaindrive;
using dealii::Point;

namespace
{
using Points = std::vector<std::array<double, 2>>;

/// Two sprockets of 19 teeth, 300 mm apart, with 1 mm of slack: the upper span is a horizontal line
/// between joints at the height of their pitch radius. Its guide is on the driven sprocket, from
/// which it leads back to the driver.
Parameters drive_with(const Points &points, const parameters::GuideLine line)
{
  Parameters p;
  p.model.fidelity                       = "simple";
  p.drive.chain.designation              = "08B";
  p.drive.sprockets.list[0].teeth        = 19;
  p.drive.sprockets.list[1].teeth        = 19;
  p.drive.n_links                        = 66;
  p.drive.layout.centre_distance_from    = parameters::CentreDistanceFrom::slack;
  p.drive.layout.slack                   = 1e-3;
  p.drive.sprockets.list[1].guide.points = points;
  p.drive.sprockets.list[1].guide.line   = line;
  return p;
}

/// Points at @p gap [m] above the plates of the upper span, or below them where it is negative, the
/// outer ones further away by @p bend [m].
Points along_the_span(const double gap, const double bend)
{
  const Parameters           p    = drive_with({}, parameters::GuideLine::arc);
  const drive::Drive         d    = drive::make_drive(p);
  const drive::Layout::Span &span = d.layout.spans[1];
  const Point<2>             from = d.layout.joints[span.first].bush,
                 to               = d.layout.joints[(span.first + span.links) % 66].bush;
  const double away               = gap + (gap > 0. ? 0.5 : -0.5) * d.chain.inner_plate_height;
  Points       points;
  for (const int i : {-1, 0, 1})
    {
      const Point<2> at = from + (0.5 + 0.25 * i) * (to - from) +
                          (away + std::abs(i) * (gap > 0. ? bend : -bend)) * span.normal;
      points.push_back({{at[0], at[1]}});
    }
  return points;
}

void refuse(const std::string &what, const std::function<void(Parameters &)> &change)
{
  expect_refusal(what, [&change]() {
    Parameters p = drive_with(along_the_span(1e-3, 1e-3), parameters::GuideLine::arc);
    change(p);
    drive::make_drive(p);
  });
}
} // namespace

int main()
{
  for (const double gap : {0.5e-3, -0.5e-3})
    for (const bool mirrored : {false, true})
      for (const auto line : {parameters::GuideLine::arc, parameters::GuideLine::spline})
        {
          Parameters p = drive_with(along_the_span(gap, 0.2e-3), line);
          if (mirrored)
            p.drive.layout.tight_span = parameters::TightSide::lower;
          const drive::Drive         d     = drive::make_drive(p);
          const drive::Guide        &guide = d.guides.at(0);
          double                     least = 1.;
          const drive::Layout::Span &span  = d.layout.spans[1];
          for (unsigned int i = 0; i <= span.links; ++i)
            {
              unsigned int hint = 1000;
              least             = std::min(
                  least,
                  guide.curve.nearest(d.layout.joints[(span.first + i) % 66].bush, hint).distance);
            }
          const double wanted = 0.5 * d.chain.inner_plate_height + 0.5e-3;
          // the nearest joint is at most half a pitch from the middle of the guide
          verdict(std::string(gap > 0. ? "above" : "below") + (mirrored ? ", mirrored" : "") +
                      (line == parameters::GuideLine::arc ? ", arc" : ", spline") +
                      ": the nearest joint is 0.5 mm and half a plate in front of it",
                  guide.span == 1 && std::abs(least - wanted) < 5e-6);
        }

  refuse("through the chain", [](Parameters &p) {
    p.drive.sprockets.list[1].guide.points = along_the_span(1e-3, -2e-3);
  });
  // within the teeth, where no plates are
  refuse("through a sprocket", [](Parameters &p) {
    p.drive.sprockets.list[1].guide.line   = parameters::GuideLine::spline;
    p.drive.sprockets.list[1].guide.points = {{{0.31, 0.03}}, {{0.29, 0.03}}};
    p.drive.sprockets.list[1].centre       = std::array<double, 2>{{0.3, 0.}};
    p.drive.layout.centre_distance_from    = parameters::CentreDistanceFrom::given;
    p.drive.n_links                        = 68;
  });
  refuse("arc through two points",
         [](Parameters &p) { p.drive.sprockets.list[1].guide.points.pop_back(); });
  refuse("arc through points of a line",
         [](Parameters &p) { p.drive.sprockets.list[1].guide.points = along_the_span(1e-3, 0.); });
  refuse("the same point twice", [](Parameters &p) {
    auto &points = p.drive.sprockets.list[1].guide.points;
    points[1]    = points[0];
  });
}
