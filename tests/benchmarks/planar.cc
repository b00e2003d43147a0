// SPDX-License-Identifier: LGPL-2.1-or-later
// What a time step of rigid drives costs, beside a plain program of the same planar model.
//
// Usage: planar_benchmark FILE.prm [STEPS]. Prints nanoseconds of CPU time per link and step of
//
//   plain    circles in circles and on arcs, penalty, damping and friction, leapfrog: one body and
//            one contact after the other, without any library in the loop
//   planar   the program's steps with Effects/Planar motion = auto, without observers
//   spatial  with off
//
// and how far the driven sprocket and the chain's tension at the end of all three agree. Rows
// alternate five times; figures are medians.
#include <chaindrive/drive/tooth_form.h>
#include <chaindrive/model/reading.h>
#include <chaindrive/scene/scene.h>
#include <chaindrive/simulation.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

using namespace chaindrive;

namespace
{
struct Body
{
  double x, y, c, s, vx, vy, w, fx, fy, m, inverse_mass, inverse_inertia;
  bool   turns;
};

struct Touch
{
  double penetration = 0., normal = 0., slip = 0., tangential = 0.;
};

struct Law
{
  double k, c, mu, kt, ct;
};

struct Joint // a cylinder in a bore
{
  unsigned int bore, cylinder;
  double       bore_x, cylinder_x, clearance, radius;
  Touch        touch;
};

struct Bar
{
  unsigned int first, second;
  double       length, k, c;
};

/// The pair that touches at (x, y) with the gap @p gap and the normal (nx, ny) on the slave.
void press(const Law   &law,
           Body        &master,
           Body        &slave,
           const double gap,
           const double nx,
           const double ny,
           const double x,
           const double y,
           const double dt,
           Touch       &touch)
{
  const auto velocity = [&](const Body &body, double &vx, double &vy) {
    const double ax = x - body.x, ay = y - body.y, turned = 0.5 * dt * body.w;
    vx = body.vx - body.w * (ay - turned * ax);
    vy = body.vy + body.w * (ax + turned * ay);
  };
  double ux, uy, vx, vy;
  velocity(slave, ux, uy);
  velocity(master, vx, vy);
  ux -= vx;
  uy -= vy;
  touch.penetration = -gap;
  touch.normal      = std::max(0., -law.k * gap - law.c * (ux * nx + uy * ny));
  const double rate = uy * nx - ux * ny, limit = law.mu * touch.normal;
  touch.slip += dt * rate;
  if (law.kt * std::abs(touch.slip) > limit)
    touch.slip *= limit / (law.kt * std::abs(touch.slip));
  touch.tangential = std::clamp(-law.kt * touch.slip - law.ct * rate, -limit, limit);
  const double fx  = touch.normal * nx - touch.tangential * ny,
               fy  = touch.normal * ny + touch.tangential * nx;
  slave.fx += fx;
  slave.fy += fy;
  slave.m += (x - slave.x) * fy - (y - slave.y) * fx;
  master.fx -= fx;
  master.fy -= fy;
  master.m -= (x - master.x) * fy - (y - master.y) * fx;
}

class Plain
{
public:
  explicit Plain(const scene::Scene &scene) : scene_(scene), gravity_(scene.loads.gravity)
  {
    for (const scene::Body &body : scene.bodies)
      {
        const bool free = body.mount.is_free();
        bodies_.push_back({body.initial.position[0],
                           body.initial.position[1],
                           body.initial.rotation[0][0],
                           body.initial.rotation[1][0],
                           body.initial.velocity[0],
                           body.initial.velocity[1],
                           body.initial.angular_velocity[2],
                           0.,
                           0.,
                           0.,
                           free ? 1. / body.mass : 0.,
                           free && body.inertia[2] > 0. ? 1. / body.inertia[2] : 0.,
                           body.motion == scene::Motion::rigid});
      }
    for (const scene::BoreFamily &family : scene.bores)
      {
        joints_.emplace_back();
        laws_.push_back(law_of(family.law.times(2.)));
        for (std::size_t i = 0; i < family.pairs.size(); i += 2) // two points of each cylinder
          {
            const scene::BorePair &pair = family.pairs[i];
            joints_.back().push_back({pair.master,
                                      pair.slave.body,
                                      pair.axis[0],
                                      pair.slave.point[0],
                                      pair.radius - pair.slave.radius,
                                      pair.slave.radius,
                                      {}});
          }
      }
    for (const scene::Bar &bar : scene.bars)
      bars_.push_back({bar.first, bar.second, bar.length, bar.stiffness, bar.damping});
    for (const scene::ToothFamily &teeth : scene.teeth)
      {
        const double n = double(teeth.slaves.size()) / scene.drive.n_joints;
        tooth_laws_.push_back(law_of(teeth.law.times(n)));
        teeth_.emplace_back(scene.drive.n_joints);
        angle_.push_back(0.);
        speed_.push_back(0.);
      }
    near_.resize(teeth_.size());
    forces(0., 0.);
  }

  void step(const double dt, const double time)
  {
    kick(0.5 * dt);
    for (Body &b : bodies_)
      {
        b.x += dt * b.vx;
        b.y += dt * b.vy;
        if (!b.turns)
          continue;
        const double a = dt * b.w, c = 1. - 0.5 * a * a, s = a - a * a * a / 6., cosine = b.c;
        b.c = c * b.c - s * b.s;
        b.s = c * b.s + s * cosine;
      }
    for (std::size_t i = 0; i < teeth_.size(); ++i)
      {
        const auto &program = scene_.shafts[i].program;
        if (program.speed)
          {
            angle_[i] = program.speed->integral(0., time);
            speed_[i] = program.speed->value(time - 0.5 * dt);
          }
        else
          angle_[i] += dt * speed_[i];
        Body        &hub  = bodies_[scene_.teeth[i].sprocket];
        const double turn = scene_.shafts[i].sense * angle_[i];
        hub.w             = scene_.shafts[i].sense * speed_[i];
        hub.c             = std::cos(turn + start_of(i));
        hub.s             = std::sin(turn + start_of(i));
      }
    forces(dt, time);
    kick(0.5 * dt);
  }

  double driven_angle() const { return angle_.back(); }

private:
  static Law law_of(const scene::ContactLaw &law)
  {
    return {
        law.stiffness, law.damping, law.friction, law.tangential_stiffness, law.tangential_damping};
  }

  double start_of(const std::size_t i) const
  {
    const auto &r = scene_.bodies[scene_.teeth[i].sprocket].initial.rotation;
    return std::atan2(r[1][0], r[0][0]);
  }

  void kick(const double h)
  {
    for (Body &b : bodies_)
      {
        b.vx += h * b.inverse_mass * b.fx;
        b.vy += h * b.inverse_mass * b.fy;
        b.w += h * b.inverse_inertia * b.m;
      }
    for (std::size_t i = 0; i < teeth_.size(); ++i)
      if (!scene_.shafts[i].program.speed)
        {
          const unsigned int hub   = scene_.teeth[i].sprocket;
          const int          sense = scene_.shafts[i].sense;
          speed_[i] += h / scene_.bodies[hub].inertia[2] * (sense * bodies_[hub].m - torque_);
        }
  }

  void forces(const double dt, const double time)
  {
    for (Body &b : bodies_)
      {
        b.fx = b.m = 0.;
        b.fy       = b.inverse_mass > 0. ? -gravity_ / b.inverse_mass : 0.;
      }
    for (std::size_t i = 0; i < bars_.size(); ++i)
      {
        const Bar   &bar = bars_[i];
        Body        &a = bodies_[bar.first], &b = bodies_[bar.second];
        const double x = b.x - a.x, y = b.y - a.y, length = std::sqrt(x * x + y * y);
        const double pull = bar.k * (length - bar.length) +
                            bar.c * (x * (b.vx - a.vx) + y * (b.vy - a.vy)) / length;
        a.fx += pull * x / length;
        a.fy += pull * y / length;
        b.fx -= pull * x / length;
        b.fy -= pull * y / length;
      }
    for (std::size_t f = 0; f < joints_.size(); ++f)
      for (Joint &joint : joints_[f])
        {
          Body        &bore = bodies_[joint.bore], &cylinder = bodies_[joint.cylinder];
          const double cx = cylinder.x + joint.cylinder_x * cylinder.c,
                       cy = cylinder.y + joint.cylinder_x * cylinder.s;
          const double x  = cx - bore.x - joint.bore_x * bore.c,
                       y = cy - bore.y - joint.bore_x * bore.s, square = x * x + y * y;
          if (square < joint.clearance * joint.clearance)
            {
              joint.touch = {};
              continue;
            }
          const double distance = std::sqrt(square), nx = -x / distance, ny = -y / distance;
          press(laws_[f],
                bore,
                cylinder,
                joint.clearance - distance,
                nx,
                ny,
                cx - joint.radius * nx,
                cy - joint.radius * ny,
                dt,
                joint.touch);
        }
    const bool search = left_ <= 0.;
    if (search)
      left_ = 1e-3;
    double fastest = 0.;
    for (const Body &b : bodies_)
      fastest = std::max(fastest, b.vx * b.vx + b.vy * b.vy);
    left_ -= 2. * std::sqrt(fastest) * dt;
    for (std::size_t i = 0; i < teeth_.size(); ++i)
      press_teeth(i, search, dt);
    for (std::size_t i = 0; i < teeth_.size(); ++i)
      if (!scene_.shafts[i].program.speed)
        torque_ = scene_.shafts[i].program.resisting_torque(angle_[i], time, speed_[i]);
  }

  void press_teeth(const std::size_t i, const bool search, const double dt)
  {
    const scene::ToothFamily &teeth = scene_.teeth[i];
    Body                     &hub   = bodies_[teeth.sprocket];
    const double              r     = teeth.slaves.front().radius;
    if (search)
      {
        near_[i].clear();
        for (unsigned int k = 0; k < teeth_[i].size(); ++k)
          if (std::hypot(bodies_[scene_.drive.rollers[k]].x - hub.x,
                         bodies_[scene_.drive.rollers[k]].y - hub.y) <
              teeth.outer_radius + r + 1e-3)
            near_[i].push_back(k);
      }
    for (const unsigned int k : near_[i])
      {
        Body        &roller = bodies_[scene_.drive.rollers[k]];
        const double dx = roller.x - hub.x, dy = roller.y - hub.y;
        const double px = hub.c * dx + hub.s * dy, py = hub.c * dy - hub.s * dx;
        const double part = 2. * dealii::numbers::PI / teeth.teeth;
        const double gap  = part * std::round(std::atan2(py, px) / part);
        const double tc = std::cos(gap), ts = std::sin(gap);
        const double x = tc * px + ts * py, side = tc * py - ts * px < 0. ? -1. : 1.,
                     y = side * (tc * py - ts * px);
        double best = 1e9, sign = 1., nx = 0., ny = 0.;
        for (const drive::Segment &arc : teeth.form->half_profile)
          {
            const double ax = x - arc.centre[0], ay = y - arc.centre[1];
            const double norm = std::sqrt(ax * ax + ay * ay);
            const double away = std::abs(norm - arc.radius);
            if (away < best && ax * arc.middle[0] + ay * arc.middle[1] > norm * arc.half_cosine)
              {
                const double out = arc.kind == drive::Segment::Kind::convex ? 1. : -1.;
                best             = away;
                sign             = out * (norm - arc.radius) < 0. ? -1. : 1.;
                nx               = out * ax / norm;
                ny               = out * ay / norm;
              }
          }
        if (best > 1e8 || sign * best > r)
          {
            teeth_[i][k] = {};
            continue;
          }
        ny *= side;
        const double sx = tc * nx - ts * ny, sy = ts * nx + tc * ny;
        const double wx = hub.c * sx - hub.s * sy, wy = hub.s * sx + hub.c * sy;
        press(tooth_laws_[i],
              hub,
              roller,
              sign * best - r,
              wx,
              wy,
              roller.x - r * wx,
              roller.y - r * wy,
              dt,
              teeth_[i][k]);
      }
  }

  const scene::Scene                    &scene_;
  double                                 gravity_;
  std::vector<Body>                      bodies_;
  std::vector<std::vector<Joint>>        joints_;
  std::vector<Law>                       laws_, tooth_laws_;
  std::vector<Bar>                       bars_;
  std::vector<std::vector<Touch>>        teeth_; ///< by sprocket and roller
  std::vector<std::vector<unsigned int>> near_;
  std::vector<double>                    angle_, speed_; ///< of sprockets, in their senses
  double                                 torque_ = 0., left_ = 0.;
};

/// CPU seconds of this thread that @p run takes.
double seconds(const std::function<void()> &run)
{
  const auto now = [] {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
  };
  const double start = now();
  run();
  return now() - start;
}

double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void compare(const std::string &file, const unsigned long n_steps)
{
  constexpr unsigned int runs = 5;
  const auto             read = [&file](const std::string &planar) {
    return model::read_parameters(
        file, {"Effects/Planar motion=" + planar, "Output/Field interval in ms=0"});
  };
  const auto          in_plane = read("auto"), in_space = read("off");
  std::vector<double> taken[3];
  double              angle[3] = {};
  unsigned int        n_links  = 0;
  for (unsigned int i = 0; i < runs; ++i)
    {
      const auto time_of = [&](const Parameters &parameters, double &driven) {
        Simulation        simulation(parameters, {"."}, MPI_COMM_SELF);
        dynamics::System &system = simulation.system();
        const double      dt     = simulation.step.step;
        n_links                  = simulation.scene.drive.n_joints;
        const double result      = seconds([&]() {
          for (unsigned long n = 1; n <= n_steps; ++n)
            system.advance_without_update(dt, double(n) * dt);
        });
        driven                   = std::abs(system.world.hubs.back().angle);
        return result;
      };
      {
        const Simulation simulation(in_space.parameters, {"."}, MPI_COMM_SELF);
        Plain            plain(simulation.scene);
        const double     dt = simulation.step.step;
        taken[0].push_back(seconds([&]() {
          for (unsigned long n = 1; n <= n_steps; ++n)
            plain.step(dt, double(n) * dt);
        }));
        angle[0] = plain.driven_angle();
      }
      taken[1].push_back(time_of(in_plane.parameters, angle[1]));
      taken[2].push_back(time_of(in_space.parameters, angle[2]));
    }
  std::printf("%s: %u links, %lu steps\n", file.c_str(), n_links, n_steps);
  const char *names[] = {"plain", "planar", "spatial"};
  for (unsigned int i = 0; i < 3; ++i)
    std::printf("  %-8s %8.2f ns per link and step, %7.3f us per step, driven angle %.9g rad\n",
                names[i],
                1e9 * median(taken[i]) / double(n_steps) / n_links,
                1e6 * median(taken[i]) / double(n_steps),
                angle[i]);
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  try
    {
      if (argc < 2)
        throw std::runtime_error("Usage: planar_benchmark FILE.prm [STEPS]");
      compare(argv[1], argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 20000);
    }
  catch (const std::exception &error)
    {
      std::cerr << error.what() << '\n';
      return 1;
    }
  return 0;
}
