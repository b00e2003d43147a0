// SPDX-License-Identifier: LGPL-2.1-or-later
// Blades on arms and shoes on slides that press the slack span of 50 random drives, from inside and
// outside of the loop, in both fidelities, at rest and while the drive runs: spring and weights
// balance the span's ends, the chain lies along the guide, and travel and tension are those of an
// independent solution, a band round pitch circles and the guide's. Those that cannot be are
// refused.
#include "compare.h"

#include <chaindrive/drive/drive.h>
#include <chaindrive/drive/equilibrium.h>
#include <chaindrive/drive/facts.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <array>
#include <functional>
#include <random>
#include <vector>

using namespace chaindrive;
using dealii::Point;
using dealii::numbers::PI;
using Vector = dealii::Tensor<1, 2>;

namespace
{
constexpr double pitch = 12.7e-3, stiffness = 2e7, speed = 60., half_plate = 0.5 * 11.81e-3; // 08B

double cross(const Vector &a, const Vector &b) { return a[0] * b[1] - a[1] * b[0]; }

double radius_of(const unsigned int teeth) { return 0.5 * pitch / std::sin(PI / teeth); }

/// On which joints run; its radius is below zero where they do clockwise.
struct Circle
{
  Point<2> centre;
  double   radius;
};

/// A band round driver, guide and driven sprocket.
struct Band
{
  double              length = 0.;    ///< of the chain on it, m
  std::vector<double> straight, wrap; ///< of it, by circle, from which a span leads, m
  std::vector<Vector> along;          ///< of spans
  std::vector<double> leaves;         ///< the normal of spans, polar angle
};

Band band(const std::vector<Circle> &circles)
{
  const std::size_t n = circles.size();
  Band              found;
  for (std::size_t i = 0; i < n; ++i)
    {
      const Circle &from = circles[i], &to = circles[(i + 1) % n];
      const Vector  line    = to.centre - from.centre;
      const double  rise    = from.radius - to.radius;
      const double  heading = std::atan2(line[1], line[0]) + std::asin(rise / line.norm());
      found.along.push_back(Point<2>(std::cos(heading), std::sin(heading)));
      found.leaves.push_back(heading);
      found.straight.push_back(std::sqrt(line.norm_square() - rise * rise));
    }
  for (std::size_t i = 0; i < n; ++i)
    {
      const double r      = circles[i].radius;
      const double turned = (r > 0. ? 1. : -1.) * (found.leaves[i] - found.leaves[(i + n - 1) % n]);
      // chords as long as a pitch
      found.wrap.push_back((turned - 2. * PI * std::floor(turned / (2. * PI))) * 0.5 * pitch /
                           std::asin(0.5 * pitch / std::abs(r)));
      found.length += found.straight[i] + found.wrap[i];
    }
  return found;
}

/// A drive, and the circle of its guide without travel.
struct Case
{
  Parameters p;
  Circle     guide;
  Vector     middle;     ///< from its centre to that of the line, unit
  double     half_angle; ///< of the line
};

Case random_case(std::mt19937 &random)
{
  const auto between = [&random](const double low, const double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto  yes = [&random]() { return std::bernoulli_distribution(0.5)(random); };
  Case        c;
  Parameters &p             = c.p;
  p.drive.chain.designation = "08B";
  auto &list                = p.drive.sprockets.list;
  list[0].teeth             = 17;
  list[1].teeth             = 25 + random() % 20;
  const double r0 = radius_of(17), r1 = radius_of(list[1].teeth);

  // an even number of links leaves some mm of slack
  double       x     = between(0.35, 0.5);
  const double slack = between(1e-3, 4e-3);
  const auto   links = [&]() { return band({{{}, r0}, {{x, 0.}, r1}}).length / pitch; };
  p.drive.n_links    = 2 * static_cast<unsigned int>(std::ceil(0.5 * links()));
  for (unsigned int k = 0; k < 20; ++k)
    x += 0.5 * (pitch * p.drive.n_links - pitch * links() - slack);
  list[1].centre                      = std::array<double, 2>{{x, 0.}};
  p.drive.layout.centre_distance_from = parameters::CentreDistanceFrom::given;

  // an arc beside the lower span, round towards it
  const double angle     = -std::asin((r1 - r0) / x);
  const Vector along     = Point<2>(std::cos(angle), std::sin(angle)),
               down      = Point<2>(std::sin(angle), -std::cos(angle));
  const bool     outside = yes();
  const Vector   away    = outside ? down : -down;
  const double   radius = between(0.15, 0.4), reach = 0.3 * x;
  const Point<2> top = Point<2>() + r0 * down + (0.5 * x + between(-0.02, 0.02)) * along +
                       (half_plate + between(1.2e-3, 3e-3)) * away;
  const auto on = [&](const double at) {
    const Point<2> q = top + at * along + (radius - std::sqrt(radius * radius - at * at)) * away;
    return std::array<double, 2>{{q[0], q[1]}};
  };
  const double length     = std::min(reach, 0.6 * radius);
  list[0].guide.points    = {on(-length), on(0.), on(length)};
  list[0].guide.stiffness = 1e7;
  c.guide                 = {top + radius * away, (outside ? -1. : 1.) * (radius + half_plate)};
  c.middle                = -away;
  c.half_angle            = std::asin(length / radius);

  parameters::Holders &held = list[0].guide.held;
  held.holder               = yes() ? parameters::Holder::arm : parameters::Holder::slide;
  const double   end        = yes() ? 1. : -1.;
  const Point<2> pivot      = top + end * between(0.08, 0.15) * along + between(5e-3, 30e-3) * away;
  held.pivot                = std::array<double, 2>{{pivot[0], pivot[1]}};
  held.direction            = angle + 0.5 * PI + between(-0.4, 0.4);
  held.slide.preload        = between(100., 250.);
  held.slide.stiffness      = between(200., 1000.);
  held.slide.inertia        = between(0.05, 0.3);
  const double lever        = pivot.distance(top);
  held.arm.preload          = held.slide.preload * lever;
  held.arm.stiffness        = held.slide.stiffness * lever * lever;
  held.arm.inertia          = 1e-3;

  p.drive.layout.tight_span   = yes() ? parameters::TightSide::upper : parameters::TightSide::lower;
  p.drive.layout.start        = yes() ? parameters::Start::taut : parameters::Start::settled;
  p.drive.layout.start_phase  = between(0., 0.99);
  p.model.fidelity            = yes() ? "simple" : "layered";
  p.model.stiffness_per_pitch = stiffness;
  p.model.driven_inertia      = 0.02;
  p.loads.driver_speed        = speed;
  p.loads.resisting_torque    = between(5., 40.);
  return c;
}

/// A drive as the first of the random ones, changed.
void refuse(const std::string &what, const std::function<void(parameters::Drive &)> &change)
{
  expect_refusal(what, [&change]() {
    Parameters            p;
    parameters::Sprocket &driver    = p.drive.sprockets.list[0];
    p.model.fidelity                = "simple";
    driver.teeth                    = 19;
    p.drive.sprockets.list[1].teeth = 19;
    p.drive.chain.designation       = "08B";
    p.drive.n_links                 = 66;
    p.drive.layout.slack            = 2e-3;
    driver.guide.points             = {{{0.05, -0.047}}, {{0.15, -0.046}}, {{0.25, -0.047}}};
    driver.guide.held.holder        = parameters::Holder::arm;
    driver.guide.held.pivot         = std::array<double, 2>{{0.25, -0.06}};
    driver.guide.held.arm.preload   = 5.;
    driver.guide.held.arm.inertia   = 1e-3;
    driver.guide.held.slide.preload = 100.;
    driver.guide.held.slide.inertia = 0.1;
    driver.guide.held.direction     = 0.5 * PI;
    change(p.drive);
    drive::make_drive(p);
  });
}
} // namespace

int main()
{
  std::mt19937 random(36);
  double       worst_balance = 0., worst_way = 0., worst_tension = 0., worst_facts = 0.;
  double       sum_way = 0., sum_tension = 0., furthest = 0., deepest = 0.;
  unsigned int arms = 0, mirrored = 0, settled = 0, layered = 0, outside = 0, along = 0,
               compared = 0;
  for (unsigned int i = 0; i < 50; ++i)
    {
      const Case              c      = random_case(random);
      const Parameters       &p      = c.p;
      const drive::Drive      d      = drive::make_drive(p);
      const drive::Layout    &layout = d.layout;
      const drive::Guide     &guide  = d.guides.at(0);
      const drive::Tensioner &held   = *guide.held;
      const bool              runs   = p.drive.layout.start == parameters::Start::settled;
      const unsigned int      n      = static_cast<unsigned int>(layout.joints.size());
      const int               sense  = layout.sense;
      arms += held.is_arm();
      mirrored += sense < 0;
      settled += runs;
      layered += p.model.fidelity == "layered";
      outside += c.guide.radius < 0.;

      // the force of an outer link, less what turns its own momentum
      const bool   joints = p.model.capabilities().has_clearances;
      const double v      = d.sprockets[0].form.pitch_diameter / 2. * speed;
      const double flux   = runs ? d.mass_per_pitch / d.chain.loaded_pitch() * v * v : 0.;
      const auto   link   = [&](const unsigned int k) {
        const Vector way = layout.joints[(k + 1) % n].bush - layout.joints[k].bush;
        const double pull = joints ? 0.5 * stiffness * (way.norm() - d.chain.loaded_outer_pitch()) :
                                         stiffness * (way.norm() - d.chain.loaded_pitch());
        return Vector((pull - flux) / way.norm() * way);
      };
      // chain between an outer link near either end of the span, and the guide: moment about the
      // pivot, or force along the slide
      const drive::Layout::Span &span = layout.spans[0];
      const auto         outer = [&](const unsigned int k) { return k % 2 == 1 ? k : k + 1; };
      const unsigned int begin = outer(span.first + 1), end = outer(span.first + span.links - 3);
      const auto         acts = [&](const Vector &force, const Point<2> &at) {
        return held.is_arm() ? held.sense * cross(at - held.pivot, force) : held.direction * force;
      };
      const double force = held.law.force(held.travel, 0.);
      double       sum   = force - acts(link(begin % n), layout.joints[(begin + 1) % n].bush) +
                   acts(link(end % n), layout.joints[end % n].bush);
      if (!held.is_arm())
        sum += held.direction * Point<2>(0., -held.weight);
      const double weight = d.mass_per_pitch * p.loads.gravity;
      for (unsigned int k = begin + 1; k <= end; ++k)
        sum += acts(Point<2>(0., -weight), layout.joints[k % n].bush);
      worst_balance = std::max(worst_balance, std::abs(sum / force));

      // the band: as the drive is without mirror
      const auto circles = [&](const double travel) {
        Circle         at    = c.guide;
        const Point<2> pivot = Point<2>(held.pivot[0], sense * held.pivot[1]);
        if (held.is_arm())
          {
            const double turn = sense * held.sense * travel;
            const Vector arm  = at.centre - pivot;
            at.centre         = pivot + Point<2>(std::cos(turn) * arm[0] - std::sin(turn) * arm[1],
                                         std::sin(turn) * arm[0] + std::cos(turn) * arm[1]);
          }
        else
          at.centre += travel * Point<2>(held.direction[0], sense * held.direction[1]);
        const Point<2> driven((*p.drive.sprockets.list[1].centre)[0], 0.);
        return std::vector<Circle>{
            {{}, radius_of(17)}, at, {driven, radius_of(p.drive.sprockets.list[1].teeth)}};
      };
      // of spans beside the guide against its travel at 1 N of tension in both
      const auto pull_of = [&](const double travel) {
        const double h = 1e-6;
        return (band(circles(travel + h)).length - band(circles(travel - h)).length) / (2. * h);
      };
      const auto pull = [&](const double travel) {
        const double of_weight = held.is_arm() ? 0. : -held.weight * held.direction[1];
        return (held.law.force(travel, 0.) + of_weight) / pull_of(travel);
      };
      const double load =
          runs ? p.loads.resisting_torque / (0.5 * d.sprockets[1].form.pitch_diameter) : 0.;
      const auto excess = [&](const double travel) {
        const Band   round   = band(circles(travel));
        const double pulled  = round.straight[2] + 0.5 * (round.wrap[0] + round.wrap[2]);
        const double tension = pull(travel) + flux;
        return n * d.chain.loaded_pitch() - round.length +
               (tension * round.length + load * pulled) / (stiffness * d.chain.loaded_pitch());
      };
      double low = held.travel - 6e-3 / held.lever(), high = held.travel + 6e-3 / held.lever();
      for (unsigned int k = 0; k < 60; ++k)
        (excess(0.5 * (low + high)) > 0. ? low : high) = 0.5 * (low + high);
      // where it would leave the line at its end
      const Band   at_rest = band(circles(low));
      const Circle at      = circles(low)[1];
      const double turned  = held.is_arm() ? sense * held.sense * low : 0.;
      const Vector middle =
          Point<2>(std::cos(turned) * c.middle[0] - std::sin(turned) * c.middle[1],
                   std::sin(turned) * c.middle[0] + std::cos(turned) * c.middle[1]);
      bool within = true;
      for (const unsigned int k : {0, 1})
        {
          const Vector &u       = at_rest.along[k];
          const Vector  touches = (at.radius > 0. ? 1. : -1.) * Point<2>(u[1], -u[0]);
          within = within && std::abs(std::atan2(cross(middle, touches), middle * touches)) <
                                 c.half_angle - pitch / std::abs(at.radius);
        }
      const double obtained = 0.5 * (link(begin % n).norm() + link(end % n).norm());
      const double way = std::abs(low - held.travel) * held.lever(), expected = pull(low);
      furthest = std::max(furthest, held.travel * held.lever());
      if (within)
        {
          ++compared;
          worst_way        = std::max(worst_way, way);
          const double off = std::abs(obtained / expected - 1.);
          worst_tension    = std::max(worst_tension, off);
          sum_way += way;
          sum_tension += off;
        }
      const drive::Facts facts = drive::make_facts(p, d);
      worst_facts              = std::max(
          worst_facts,
          std::abs((facts.spans[0].tension - (runs ? facts.centrifugal_tension : flux)) / obtained -
                   1.));

      // plates lie on the line where it is
      const Circle line = circles(held.travel)[1];
      unsigned int on   = 0;
      for (unsigned int k = begin; k <= end; ++k)
        {
          const Point<2> &q   = layout.joints[k % n].bush;
          const Vector    arm = Point<2>(q[0], sense * q[1]) - line.centre;
          if (std::abs(std::atan2(cross(middle, arm), middle * arm)) > c.half_angle)
            continue; // beyond its end
          const double away = arm.norm() - std::abs(line.radius);
          deepest           = std::max(deepest, -away);
          on += std::abs(away) < 30e-6;
        }
      along += on > 1;
    }
  std::cout << "50 drives: " << arms << " arms, " << outside << " outside of the loop, " << layered
            << " layered, " << settled << " settled, " << mirrored << " mirrored\n";
  verdict("spring and weights balance the span's ends to twice what the solver takes for creeping",
          worst_balance < 2. * drive::creeping);
  verdict("some guides have moved by more than 5 mm", furthest > 5e-3);
  verdict("plates are in none by more than 10 um", deepest < 10e-6);
  verdict("at least two joints lie on each", along == 50);
  verdict("on 30 or more the chain leaves before the ends", compared >= 30);
  // the band knows neither how rollers climb in their seats nor at which phase they are
  verdict("where the guide is as a band would have it to 2.5 mm, in the mean to 1 mm",
          worst_way < 2.5e-3 && sum_way < 1e-3 * compared);
  verdict("the tension is that of a band to 10 %, in the mean to 5 %",
          worst_tension < 0.1 && sum_tension < 0.05 * compared);
  verdict("facts have it to 20 %", worst_facts < 0.2);

  using Drive = parameters::Drive;
  refuse("no pivot", [](Drive &d) { d.sprockets.list[0].guide.held.pivot.reset(); });
  refuse("no inertia", [](Drive &d) { d.sprockets.list[0].guide.held.arm.inertia = 0.; });
  refuse("no mass", [](Drive &d) {
    d.sprockets.list[0].guide.held.holder        = parameters::Holder::slide;
    d.sprockets.list[0].guide.held.slide.inertia = 0.;
  });
  refuse("no spring", [](Drive &d) { d.sprockets.list[0].guide.held.arm.preload = 0.; });
  refuse("stops the wrong way round", [](Drive &d) {
    d.sprockets.list[0].guide.held.arm.least = 0.2;
    d.sprockets.list[0].guide.held.arm.most  = 0.1;
  });
  refuse("through the straight span", [](Drive &d) {
    for (auto &point : d.sprockets.list[0].guide.points)
      point[1] += 6e-3;
  });
  refuse("along the chain", [](Drive &d) {
    d.sprockets.list[0].guide.held.holder    = parameters::Holder::slide;
    d.sprockets.list[0].guide.held.direction = 0.;
  });
  refuse("far away", [](Drive &d) {
    d.sprockets.list[0].guide.held.holder = parameters::Holder::slide;
    for (auto &point : d.sprockets.list[0].guide.points)
      point[1] -= 2.;
  });
  refuse("sag",
         [](Drive &d) { d.layout.centre_distance_from = parameters::CentreDistanceFrom::sag; });
  refuse("concentric", [](Drive &d) { d.layout.start = parameters::Start::concentric; });
}
