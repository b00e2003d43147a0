// SPDX-License-Identifier: LGPL-2.1-or-later
// Wheels on bearings that yield and behind couplings, of 40 random drives of two and three wheels
// while they run: springs of bearings balance what the chain pulls at each wheel, the torque at the
// driver is that of the chain, axes are where the entries put them but for the deflection; the same
// of a drive at rest with a pre-tension. Frequencies of couplings and bearings, and the lowest one
// of the drive with soft and with stiff couplings; and what is refused.
#include "compare.h"

#include <chaindrive/drive/centre_distance.h>
#include <chaindrive/drive/drive.h>
#include <chaindrive/drive/facts.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace chaindrive;
using namespace chaindrive::drive;
using Vector = dealii::Tensor<1, 2>;
using dealii::numbers::PI;

namespace
{
constexpr double pitch_stiffness = 2e7, mass = 9e-3, speed = 60.;

double cross(const Vector &a, const Vector &b) { return a[0] * b[1] - a[1] * b[0]; }

/// An 08B drive of 17 to 38 teeth, with an idler below the lower span if @p third.
Parameters a_drive(const bool third)
{
  Parameters p;
  p.model.fidelity            = "simple";
  p.model.mass_per_pitch      = mass;
  p.model.stiffness_per_pitch = pitch_stiffness;
  p.model.driven_inertia      = 0.03;
  p.drive.chain.designation   = "08B";
  p.loads.driver_speed        = speed;
  p.loads.resisting_torque    = 30.;
  p.drive.layout.start        = parameters::Start::settled;
  p.drive.layout.slack        = 2e-3;
  if (third)
    p.drive.sprockets.set_order({"driver", "idler", "driven"});
  auto &list         = p.drive.sprockets.list;
  list.front().teeth = 17;
  list.back().teeth  = 38;
  if (third)
    {
      list[1].teeth  = 13;
      list[1].turn   = -1;
      list[1].centre = std::array<double, 2>{{0.19, -0.062}};
    }
  p.drive.layout.centre_distance = 0.4;
  p.drive.n_links                = number_of_links(p.drive);
  return p;
}

/// What the chain does to wheel @p i of @p d, which turns it: force and moment about its centre.
struct Pull
{
  Vector force;
  double moment = 0.;
};

Pull pull_of(const Drive &d, const unsigned int i, const double flux)
{
  const Layout      &layout = d.layout;
  const unsigned int n      = layout.joints.size();
  const double       pitch  = d.chain.loaded_pitch();
  const auto         link   = [&](const unsigned int k) {
    const Vector way = layout.joints[(k + 1) % n].bush - layout.joints[k % n].bush;
    return Vector((pitch_stiffness * (way.norm() - pitch) - flux) / way.norm() * way);
  };
  const Layout::Span &before = layout.into(i), &after = layout.spans[i];
  const auto          centre = layout.sprockets[i].centre;
  // links from the middle of the span before it to that of the span behind it
  const unsigned int begin = before.first + before.links / 2, end = after.first + after.links / 2;
  Pull               pull;
  pull.force  = link(end) - link(begin);
  pull.moment = cross(layout.joints[end % n].bush - centre, link(end)) -
                cross(layout.joints[(begin + 1) % n].bush - centre, link(begin));
  for (unsigned int k = (begin + 1) % n; k != (end + 1) % n; k = (k + 1) % n)
    {
      pull.force[1] -= mass * 9.81;
      pull.moment -= mass * 9.81 * (layout.joints[k].bush - centre)[0];
    }
  return pull;
}

void random_drives()
{
  std::mt19937                           random(5);
  std::uniform_real_distribution<double> uniform(0., 1.);
  double worst_force = 0., worst_torque = 0., worst_place = 0., largest = 0.;
  for (unsigned int c = 0; c < 40; ++c)
    {
      Parameters p             = a_drive(c % 2 == 1);
      p.loads.resisting_torque = 5. + 40. * uniform(random);
      const Drive rigid        = make_drive(p);
      for (parameters::Sprocket &wheel : p.drive.sprockets.list)
        if (uniform(random) < 0.7)
          {
            wheel.bearing.stiffness         = std::pow(10., 5.5 + 4. * uniform(random));
            wheel.bearing.stiffness_along_y = std::pow(10., 5.5 + 4. * uniform(random));
          }
      const Drive  d = make_drive(p);
      const double flux =
          mass / d.chain.loaded_pitch() * std::pow(speed * 0.5 * d.driver().form.pitch_diameter, 2);
      // equilibria are found to 1e-3 of the tension where rollers creep over kinks of their seats
      const double tight = d.nominal_tension;
      for (unsigned int i = 0; i < d.sprockets.size(); ++i)
        {
          const double            lever  = 0.5 * d.sprockets[i].form.pitch_diameter;
          const Layout::Sprocket &wheel  = d.layout.sprockets[i];
          const Pull              pull   = pull_of(d, i, flux);
          const auto             &yields = p.drive.sprockets.list[i].bearing;
          worst_torque =
              std::max(worst_torque, std::abs(pull.moment + wheel.torque) / (tight * lever));
          worst_place = std::max(worst_place,
                                 wheel.unloaded().distance(rigid.layout.sprockets[i].unloaded()));
          if (!yields.stiffness)
            {
              worst_place = std::max(worst_place, wheel.deflection.norm());
              continue;
            }
          const Vector &u   = wheel.deflection;
          Vector        out = pull.force;
          out[0] -= *yields.stiffness * u[0];
          out[1] -= *yields.stiffness_along_y * u[1];
          worst_force = std::max(worst_force, out.norm() / tight);
          largest     = std::max(largest, u.norm());
        }
    }
  verdict("bearings balance the chain to 1e-3 of its tension", worst_force < 1e-3);
  verdict("torques of shafts are those of the chain, to 1e-3", worst_torque < 1e-3);
  // rigid bearings are where the centre distance was found; loaded ones too
  verdict("axes without load are where rigid ones are, to a nanometre", worst_place < 1e-9);
  verdict("some of them deflect by more than 1 mm", largest > 1e-3);
}

void pretension()
{
  Parameters p                        = a_drive(false);
  p.drive.layout.start                = parameters::Start::taut;
  p.drive.layout.centre_distance_from = parameters::CentreDistanceFrom::pretension;
  p.drive.layout.pretension           = 300.;
  auto &bearing                       = p.drive.sprockets.list[1].bearing;
  bearing.stiffness                   = 2e6;
  const Drive  d                      = make_drive(p);
  const Pull   pull                   = pull_of(d, 1, 0.);
  const Vector u                      = d.layout.sprockets[1].deflection;
  compare("pre-tension 300 N on 2e6 N/m, um", 1e6 * u[0], 1e6 * pull.force[0] / 2e6, 3);
  verdict("which both spans have", std::abs(pull.force[0] / -600. - 1.) < 0.01);
}

void frequencies()
{
  Parameters   p            = a_drive(false);
  auto        &driver       = p.drive.sprockets.list[0];
  auto        &driven       = p.drive.sprockets.list[1];
  const double without      = make_facts(p, make_drive(p)).driven_frequency;
  driver.coupling.stiffness = driven.coupling.stiffness = 500.;
  driver.coupling.sprocket                              = 2e-3;
  driven.coupling.sprocket                              = 6e-3;
  driven.bearing.stiffness                              = 3e6;
  driven.bearing.stiffness_along_y                      = 7e6;
  driven.bearing.mass                                   = 5.;
  Facts facts                                           = make_facts(p, make_drive(p));
  compare("coupling of a motor, Hz",
          *facts.sprockets[0].coupling_frequency,
          std::sqrt(500. / 2e-3) / (2. * PI),
          4);
  compare("coupling of a machine, Hz",
          *facts.sprockets[1].coupling_frequency,
          std::sqrt(500. * (1. / 6e-3 + 1. / 0.03)) / (2. * PI),
          4);
  for (const unsigned int i : {0U, 1U})
    compare("bearing, Hz",
            (*facts.sprockets[1].bearing_frequency)[i],
            std::sqrt((i == 0 ? 3e6 : 7e6) / 5.) / (2. * PI),
            4);
  const Drive d = make_drive(p);
  compare("damping of the motor's coupling, N m s/rad",
          d.sprockets[0].coupling->damping,
          2. * 0.05 * std::sqrt(500. * 2e-3),
          6);
  compare("damping of the bearing, N s/m",
          d.sprockets[1].bearing->damping[1],
          2. * 0.05 * std::sqrt(7e6 * 5.),
          3);

  // soft behind the driven sprocket: the machine on its coupling, all else as good as held
  p                                            = a_drive(false);
  p.loads.resisting_torque                     = 1.; // which they must not twist by half a turn
  p.drive.sprockets.list[1].coupling.stiffness = 0.5;
  compare("lowest frequency over that of the machine on a soft coupling",
          make_facts(p, make_drive(p)).driven_frequency / (std::sqrt(0.5 / 0.03) / (2. * PI)),
          1.,
          3);
  // stiff: as if the inertias were one
  p.loads.resisting_torque                     = 30.;
  p.drive.sprockets.list[1].coupling.stiffness = 1e9;
  p.drive.sprockets.list[1].coupling.sprocket  = 0.01;
  p.model.driven_inertia                       = 0.02;
  p.drive.sprockets.list[0].coupling.stiffness = 1e9;
  compare("lowest frequency with stiff couplings over that without",
          make_facts(p, make_drive(p)).driven_frequency / without,
          1.,
          4);
  // soft before the driver: all that turns on the coupling of the motor, as one
  p.loads.resisting_torque                     = 1.;
  p.drive.sprockets.list[0].coupling.stiffness = 0.5;
  p.drive.sprockets.list[0].coupling.sprocket  = 0.2;
  const double square                          = std::pow(17. / 38., 2); // of the ratio
  compare("lowest frequency over that of all on a soft coupling of the motor",
          make_facts(p, make_drive(p)).driven_frequency /
              (std::sqrt(0.5 / (0.2 + 0.03 * square)) / (2. * PI)),
          1.,
          2);
}

void refusals()
{
  const auto with = [](const auto &change) {
    Parameters p = a_drive(true);
    change(p, p.drive.sprockets.list[1], p.drive.sprockets.list[2]);
    make_drive(p);
  };
  expect_refusal("no inertia behind a coupling", [&]() {
    with([](Parameters &, auto &idler, auto &) { idler.coupling.stiffness = 100.; });
  });
  expect_refusal("none behind that of the driven sprocket", [&]() {
    with([](Parameters &p, auto &, auto &driven) {
      driven.coupling.stiffness = 100.;
      p.model.driven_inertia.reset();
    });
  });
  expect_refusal("a bearing with runout", [&]() {
    with([](Parameters &, auto &idler, auto &) {
      idler.bearing.stiffness = 1e6;
      idler.runout            = 1e-4;
    });
  });
  expect_refusal("a bearing on a slide", [&]() {
    with([](Parameters &, auto &idler, auto &) {
      idler.bearing.stiffness  = 1e6;
      idler.held.holder        = parameters::Holder::slide;
      idler.held.slide.preload = 100.;
    });
  });
  expect_refusal("along y only", [&]() {
    with([](Parameters &, auto &, auto &driven) { driven.bearing.stiffness_along_y = 1e6; });
  });
  expect_refusal("lighter than the wheel", [&]() {
    with([](Parameters &, auto &, auto &driven) {
      driven.bearing.stiffness = 1e6;
      driven.bearing.mass      = 0.01;
    });
  });
  expect_refusal("too soft a bearing", [&]() {
    with([](Parameters &, auto &, auto &driven) {
      driven.bearing.stiffness         = 1e6;
      driven.bearing.stiffness_along_y = 1e3;
    });
  });
  expect_refusal("too soft a coupling", [&]() {
    with([](Parameters &p, auto &, auto &) { p.drive.sprockets.driver().coupling.stiffness = 1.; });
  });
  expect_refusal("an imported mesh without a mass", [&]() {
    with([](Parameters &, auto &, auto &driven) {
      driven.bearing.stiffness = 1e6;
      driven.mesh              = "wheel.msh";
    });
  });
  expect_refusal("an imported mesh without an inertia", [&]() {
    with([](Parameters &, auto &, auto &driven) {
      driven.coupling.stiffness = 1e6;
      driven.mesh               = "wheel.msh";
    });
  });
}
} // namespace

int main()
{
  random_drives();
  pretension();
  frequencies();
  refusals();
}
