// SPDX-License-Identifier: LGPL-2.1-or-later
// Two hundred random drives of sprockets, and fifty with drums among them, on which rollers or
// plates lie, of three to eight wheels, inside and outside of the loop, one of them found from
// slack: each link of the chain has its length, spans are common tangents, each wheel has as many
// seats as its tangents leave, to a pitch, all teeth are met in their gaps, and the chain is as
// long as tangents and arcs together and the slack that was asked for. These are computed here from
// the centres alone.
#include <chaindrive/drive/centre_distance.h>
#include <chaindrive/drive/drive.h>
#include <chaindrive/utilities/errors.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>
#include <string>
#include <vector>

using namespace chaindrive;
using dealii::Point;
using dealii::numbers::PI;

namespace
{
/// A wheel as a circle that the chain runs round counter-clockwise (+1) or clockwise.
struct Circle
{
  double x, y, radius;
  int    turn;
  double seats; ///< joints on a whole turn
};

/// The direction of the line that leaves @p a and arrives at @p b: with n to its right, the line
/// keeps r_a turn_a from one centre and r_b turn_b from the other.
double direction(const Circle &a, const Circle &b)
{
  const double dx = b.x - a.x, dy = b.y - a.y, d = std::hypot(dx, dy);
  return std::atan2(dy, dx) - std::asin((b.turn * b.radius - a.turn * a.radius) / d);
}

double length(const Circle &a, const Circle &b)
{
  const double d = std::hypot(b.x - a.x, b.y - a.y), c = a.turn * a.radius - b.turn * b.radius;
  return std::sqrt(d * d - c * c);
}

/// The angle by which the chain wraps wheel @p i.
double wrap(const std::vector<Circle> &wheels, const std::size_t i)
{
  const std::size_t n     = wheels.size();
  double            angle = wheels[i].turn * (direction(wheels[i], wheels[(i + 1) % n]) -
                                   direction(wheels[(i + n - 1) % n], wheels[i]));
  return angle - 2. * PI * std::floor(angle / (2. * PI));
}

/// Wheels on an ellipse in the order of travel, some of those in between pushed in from outside;
/// where @p drums are wanted, those that are neither driver nor driven.
Parameters random_drive(std::mt19937 &random, const bool drums)
{
  const auto uniform = [&random](const double low, const double high) {
    return low + (high - low) * (random() / 4294967296.);
  };
  Parameters               p;
  auto                    &list = p.drive.sprockets.list;
  const unsigned           n    = 3 + random() % 6;
  std::vector<std::string> names{"driver"};
  for (unsigned i = 1; i < n; ++i)
    names.push_back(i == n / 2 ? "driven" : "wheel" + std::to_string(i));
  p.drive.sprockets.set_order(names);
  p.drive.sprockets.tooth_form = parameters::StandardForm::iso_max;
  p.drive.chain.designation    = "08B";
  p.model.fidelity             = random() % 2 == 0 ? "simple" : "layered";
  p.drive.layout.start_phase   = uniform(0., 1.);
  p.drive.layout.tight_span =
      random() % 2 == 0 ? parameters::TightSide::upper : parameters::TightSide::lower;
  p.drive.layout.slack     = uniform(1e-3, 8e-3);
  p.loads.resisting_torque = 5.;
  const double a = uniform(0.3, 0.5), b = uniform(0.2, 0.4);
  for (unsigned i = 0; i < n; ++i)
    {
      const double at     = 2. * PI * (i + uniform(-0.1, 0.1)) / n - 0.5 * PI;
      list[i].teeth       = 13 + random() % 12;
      list[i].centre      = std::array<double, 2>{{a * std::cos(at), b * std::sin(at)}};
      const bool may_push = n > 4 && i > 0 && i % 2 == 1 && i != n / 2 && i + 1 < n;
      if (may_push && random() % 2 == 0)
        {
          list[i].turn = -1;
          list[i].centre =
              std::array<double, 2>{{0.62 * a * std::cos(at), 0.62 * b * std::sin(at)}};
        }
    }
  for (unsigned i = 1; drums && i < n; ++i)
    if (i != n / 2)
      {
        list[i].flat.diameter = uniform(30e-3, 90e-3);
        list[i].flat.runs_on =
            random() % 2 == 0 ? parameters::RunsOn::rollers : parameters::RunsOn::plates;
      }
  // the driven sprocket is found, or a wheel outside: along the line to it from the driver
  unsigned found = n / 2;
  for (unsigned i = 1; i < n; ++i)
    if (list[i].turn < 0 && random() % 2 == 0)
      found = i;
  const double dx                = (*list[found].centre)[0] - (*list[0].centre)[0],
               dy                = (*list[found].centre)[1] - (*list[0].centre)[1];
  list[found].direction          = std::atan2(dy, dx);
  p.drive.layout.centre_distance = std::hypot(dx, dy);
  list[found].centre.reset();
  return p;
}

void verdict(const std::string &what, const bool holds)
{
  std::cout << what << ": " << (holds ? "yes" : "NO") << '\n';
}

void lay(const unsigned int wanted, const bool drums)
{
  std::mt19937 random(11);
  unsigned int on_plates = 0, on_rollers = 0;
  unsigned int laid = 0, outside = 0, refused = 0, largest = 0;
  double worst_link = 0., worst_length = 0., worst_wrap = 0., worst_tangent = 0., worst_seat = 0.;
  std::string why;
  while (laid < wanted && refused < 2000)
    {
      Parameters p = random_drive(random, drums);
      try
        {
          // a chain that reaches: from the drawing above, to an even number of links
          p.drive.n_links             = 0;
          p.drive.n_links             = drive::number_of_links(p.drive);
          const drive::Drive   d      = drive::make_drive(p);
          const drive::Layout &layout = d.layout;
          const double         pitch  = d.chain.loaded_pitch();
          const std::size_t    n      = layout.sprockets.size();
          std::vector<Circle>  wheels;
          for (const auto &sprocket : layout.sprockets)
            {
              const std::size_t           i     = wheels.size();
              const parameters::Sprocket &given = p.drive.sprockets.list[i];
              const parameters::Flat     &flat  = given.flat;
              const bool plates = flat.diameter && flat.runs_on == parameters::RunsOn::plates;
              on_plates += plates;
              on_rollers += flat.diameter && !plates;
              // 08B: plates of inner links 11.81 mm high, rollers of 8.51 mm
              const double radius = flat.diameter ?
                                        0.5 * (*flat.diameter + (plates ? 11.81e-3 : 8.51e-3)) :
                                        0.5 * pitch / std::sin(PI / given.teeth);
              wheels.push_back({sprocket.centre[0],
                                layout.sense * sprocket.centre[1],
                                radius,
                                sprocket.turn,
                                PI / std::asin(0.5 * pitch / radius)});
              outside += sprocket.turn < 0 ? 1 : 0;
            }
          // bars between bushes, all but those of the slack span straight
          for (unsigned int k = 0; k < layout.joints.size(); ++k)
            {
              const auto &one  = layout.joints[k],
                         &next = layout.joints[(k + 1) % layout.joints.size()];
              const double wants =
                  p.model.capabilities().has_clearances ?
                      (k % 2 == 0 ? d.chain.loaded_inner_pitch() : d.chain.loaded_outer_pitch()) :
                      pitch;
              worst_link = std::max(worst_link, std::abs(one.bush.distance(next.bush) - wants));
              if (one.sprocket >= 0)
                {
                  const auto &at = layout.sprockets[one.sprocket];
                  worst_seat     = std::max(
                      worst_seat,
                      std::abs(one.roller.distance(at.centre) - wheels[one.sprocket].radius));
                }
            }
          double whole = 0.;
          for (std::size_t i = 0; i < n; ++i)
            {
              const double angle = wrap(wheels, i);
              whole += length(wheels[i], wheels[(i + 1) % n]) +
                       angle / (2. * PI) * wheels[i].seats * pitch;
              if (i > 1) // the slack span arrives and leaves as it hangs
                worst_wrap = std::max(worst_wrap,
                                      std::abs((layout.sprockets[i].seats - 1.) -
                                               angle / (2. * PI) * wheels[i].seats));
              const double along = direction(wheels[i], wheels[(i + 1) % n]);
              if (i > 0) // within half a pitch of the tangent's ends, over the length of the span
                worst_tangent =
                    std::max(worst_tangent,
                             std::abs(std::remainder(
                                 along - std::atan2(layout.sense * layout.spans[i].direction[1],
                                                    layout.spans[i].direction[0]),
                                 2. * PI)) *
                                 layout.spans[i].links);
            }
          // how far length and slack fit: wraps are polygons, which changes a span by some
          // hundredths
          worst_length = std::max(worst_length,
                                  std::abs(p.drive.n_links * pitch - whole - layout.slack().slack) /
                                      (n * pitch));
          largest      = std::max<unsigned int>(largest, n);
          ++laid;
        }
      catch (const InputError &error)
        {
          ++refused;
          why = error.what();
        }
    }
  std::cout << laid << " drives of up to " << largest << " wheels\n";
  verdict("some wheels are outside", outside > wanted / 5);
  if (drums)
    verdict("there are drums on which rollers lie, and such on which plates do",
            on_rollers > 30 && on_plates > 30);
  verdict("more are laid than refused", refused < laid);
  if (refused >= laid)
    std::cout << why << '\n';
  verdict("links have their lengths to 1 nm", worst_link < 1e-9);
  verdict("rollers lie on the pitch circles to 1 nm", worst_seat < 1e-9);
  verdict("seats between straight spans are what tangents leave, to one", worst_wrap < 1.);
  verdict("spans are along the tangents, to half a pitch at their ends", worst_tangent < 0.5);
  verdict(
      "the chain is as long as tangents, arcs and slack, to a twentieth of a pitch at each wheel",
      worst_length < 0.05);
}
} // namespace

int main()
{
  lay(200, false);
  std::cout << "with drums: ";
  lay(50, true);
}
