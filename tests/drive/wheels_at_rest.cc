// SPDX-License-Identifier: LGPL-2.1-or-later
// Three and four wheels in equilibrium while the drive runs: an idler without a torque has the same
// moment from both spans, each wheel balances its torque, spans pull in the order that the torques
// ask for, and wheels turn as the straight spans between them say, those outside the other way.
#include <chaindrive/drive/outline.h>
#include <chaindrive/drive/rest.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

using namespace chaindrive;
using namespace chaindrive::drive;
using dealii::Point;

namespace
{
constexpr double pitch = 12.7e-3, stiffness = 2e7;

ChainDimensions size_08b()
{
  parameters::Chain chain;
  chain.designation = "08B";
  return make_chain(chain);
}

struct Wheel
{
  unsigned int teeth; ///< 0: flat
  double       x, y;  ///< mm
  int          turn;
  double       torque; ///< against the drive, N m
};

void verdict(const std::string &what, const bool holds)
{
  std::cout << "  " << what << ": " << (holds ? "yes" : "NO") << '\n';
}

void examine(const std::string &name, const std::vector<Wheel> &given, const ChainDimensions &size)
{
  const path::LinkLengths  lengths{pitch, pitch};
  std::vector<path::Wheel> wheels;
  std::vector<ToothForm>   forms(given.size());
  for (unsigned int i = 0; i < given.size(); ++i)
    {
      const Wheel   &w = given[i];
      const Point<2> centre(1e-3 * w.x, 1e-3 * w.y);
      if (w.teeth > 0)
        {
          wheels.emplace_back(w.teeth, centre, lengths, w.turn);
          forms[i] = make_tooth_form(w.teeth, size, {}, 0);
        }
      else
        wheels.push_back(path::Wheel::flat(30e-3, centre, lengths, w.turn));
    }
  std::vector<RestingWheel> resting;
  for (unsigned int i = 0; i < given.size(); ++i)
    if (given[i].teeth > 0)
      resting.push_back(resting_sprocket(forms[i], i == 0, -given[i].torque * given[i].turn));
    else
      resting.push_back({std::make_shared<path::Disc>(30e-3 - 0.5 * size.roller_diameter),
                         30e-3,
                         2. * dealii::numbers::PI / wheels[i].pitch_angle,
                         false,
                         0.});

  // as many links as leave slack, of which the distance of wheel 1 leaves 3 mm
  path::Chain  chain{20, lengths, lengths, lengths, 0.4, 1};
  const double wanted = 3e-3;
  const auto   slack  = [&](const double distance) {
    wheels[1].centre =
        Point<2>(distance / 0.42 * 1e-3 * given[1].x, distance / 0.42 * 1e-3 * given[1].y);
    const auto all = path::lay_all(wheels, chain, true, 4);
    return all.empty() ? -1. : all.front().slack.slack;
  };
  while (slack(0.42) < wanted)
    chain.n_links += 2;
  double near = 0.42, far = 0.46;
  for (unsigned int k = 0; k < 50; ++k)
    {
      const double middle                   = 0.5 * (near + far);
      (slack(middle) > wanted ? near : far) = middle;
    }
  const path::Laid laid   = path::lay_all(wheels, chain, false, 4).front();
  Layout           layout = to_layout(wheels, chain, laid);

  RestingChain at_rest{};
  at_rest.length          = lengths;
  at_rest.inner_stiffness = at_rest.outer_stiffness = stiffness;
  at_rest.roller_radius                             = 0.5 * size.roller_diameter;
  at_rest.tooth_stiffness                           = 1e8;
  const double speed = 40., mass = 9e-3;
  at_rest.weight = mass * 9.81;
  settle(layout, at_rest, resting, {speed, mass, true});

  const unsigned int n    = layout.joints.size();
  const double       flux = mass / pitch * std::pow(resting[0].lever * speed, 2);
  // force of the link from joint k on, less what turns its own momentum
  const auto link = [&](const unsigned int k) {
    const dealii::Tensor<1, 2> way = layout.joints[(k + 1) % n].bush - layout.joints[k].bush;
    return dealii::Tensor<1, 2>((stiffness * (way.norm() - pitch) - flux) / way.norm() * way);
  };
  double              worst_moment = 0., worst_speed = 0., worst_ratio = 0.;
  bool                sense = true;
  std::vector<double> tension;
  for (unsigned int i = 0; i < given.size(); ++i)
    {
      const Layout::Span &before = layout.spans[(i + given.size() - 1) % given.size()],
                         &after  = layout.spans[i];
      // all that acts on the chain between the middles of both spans but for the wheel's teeth
      const Point<2>     centre = layout.sprockets[i].centre;
      const unsigned int begin  = (before.first + before.links / 2) % n;
      const unsigned int end    = after.first + after.links / 2;
      double             moment = cross(layout.joints[end % n].bush - centre, link(end % n)) -
                      cross(layout.joints[(begin + 1) % n].bush - centre, link(begin));
      for (unsigned int k = (begin + 1) % n; k != (end + 1) % n; k = (k + 1) % n)
        moment -= at_rest.weight * (layout.joints[k].bush - centre)[0];
      if (i > 0)
        worst_moment = std::max(worst_moment, std::abs(moment + resting[i].torque));
      tension.push_back(link(after.first + after.links / 2).norm() + flux);

      const double ratio = layout.sprockets[i].speed / layout.sprockets[0].speed;
      const double by_teeth =
          given[i].turn * resting[0].seats / resting[i].seats; // where the span is straight
      if (tension.back() > 50.)
        worst_ratio = std::max(worst_ratio, std::abs(ratio / by_teeth - 1.));
      else
        sense = sense && ratio * by_teeth > 0.;
      if (i > 0)
        {
          const auto v = [&](const unsigned int k) { return layout.joints[k % n].velocity; };
          const dealii::Tensor<1, 2> along =
              layout.joints[(after.first + after.links) % n].bush - layout.joints[after.first].bush;
          worst_speed = std::max(worst_speed,
                                 std::abs((v(after.first + after.links) - v(after.first)) * along) /
                                     along.norm() / (resting[0].lever * speed));
        }
    }
  std::cout << name << ", " << n << " links; tensions of spans in N:";
  for (const double t : tension)
    std::cout << ' ' << std::lround(t);
  std::cout << '\n';
  verdict("every wheel balances its torque to 1e-3 N m", worst_moment < 1e-3);
  verdict("it turns as the span after it lets it, to 1e-3", worst_speed < 1e-3);
  verdict("and as its teeth do within 4 %, in its sense", worst_ratio < 0.04 && sense);
}
} // namespace

int main()
{
  const ChainDimensions size = size_08b();
  examine("two", {{19, 0, 0, 1, 0}, {38, 420, 0, 1, 40}}, size);
  examine("an idler in the tight part",
          {{19, 0, 0, 1, 0}, {38, 420, 0, 1, 40}, {17, 200, 150, 1, 0}},
          size);
  examine(
      "power taken at two", {{19, 0, 0, 1, 0}, {38, 420, 0, 1, 25}, {25, 300, 260, 1, 15}}, size);
  examine("an idler outside", {{19, 0, 0, 1, 0}, {38, 420, 0, 1, 40}, {13, 200, 30, -1, 0}}, size);
  examine("a flat idler", {{19, 0, 0, 1, 0}, {38, 420, 0, 1, 40}, {0, 200, 130, 1, 0}}, size);
  examine("four",
          {{19, 0, 0, 1, 0}, {13, 200, -20, -1, 0}, {38, 420, 0, 1, 10}, {25, 250, 260, 1, 5}},
          size);
}
