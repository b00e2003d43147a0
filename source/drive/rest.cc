// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/equilibrium.h>
#include <chaindrive/drive/facts.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace chaindrive::drive
{
using dealii::Point;
using dealii::Tensor;
using dealii::numbers::PI;

namespace
{
using Vector = Tensor<1, 2>;

/// Gives wheel @p i the @p speed, and the chain in the spans beside it its share of the change.
void set_speed(Layout &layout, const unsigned int i, const double speed)
{
  Layout::Sprocket  &wheel  = layout.sprockets[i];
  const double       factor = speed / wheel.speed;
  const unsigned int n      = layout.joints.size();
  for (const Layout::Span &span : layout.spans)
    {
      const unsigned int last  = (span.first + span.links) % n;
      const bool         leads = layout.joints[last].sprocket == static_cast<int>(i);
      if (!leads && layout.joints[span.first].sprocket != static_cast<int>(i))
        continue;
      const Vector change = (factor - 1.) * layout.joints[leads ? last : span.first].velocity;
      for (unsigned int k = 1; k < span.links; ++k)
        layout.joints[(span.first + k) % n].velocity +=
            static_cast<double>(leads ? k : span.links - k) / span.links * change;
    }
  for (Layout::Joint &joint : layout.joints)
    if (joint.sprocket == static_cast<int>(i))
      joint.velocity *= factor;
  wheel.speed = speed;
}

/// Lets the joints in @p span run along their polygon, with speeds that change linearly from that
/// of one end along it to that of the other.
void run_along(Layout &layout, const Layout::Span &span)
{
  const unsigned int n     = layout.joints.size();
  const auto         joint = [&](const unsigned int i) -> Layout::Joint         &{
    return layout.joints[(span.first + i) % n];
  };
  const auto along = [&](const unsigned int from, const unsigned int to) {
    const Vector way = joint(to).bush - joint(from).bush;
    return way / way.norm();
  };
  const double before = joint(0).velocity * along(0, 1),
               behind = joint(span.links).velocity * along(span.links - 1, span.links);
  for (unsigned int i = 1; i < span.links; ++i)
    joint(i).velocity =
        (before + static_cast<double>(i) / span.links * (behind - before)) * along(i - 1, i + 1);
}

/// Of its spring at the axis of its wheel or the middle of its guide, N.
double force_of(const Tensioner &tensioner)
{
  return std::abs(tensioner.law.elastic(tensioner.travel)) / tensioner.lever();
}
} // namespace

void bring_to_rest(Layout                          &layout,
                   const RestingChain              &chain,
                   const std::vector<RestingWheel> &wheels,
                   const double                     tension)
{
  const Layout::Span &tight = layout.tight();

  Equilibrium  equilibrium(layout, chain, wheels);
  const double tolerance = 1e-6 * tension + 1e-3;
  // tension over the shaft's way: first that of two straight spans, then secants
  double slope  = 2. / (1. / chain.inner_stiffness + 1. / chain.outer_stiffness) / tight.links;
  double before = 0., moved = 0.;
  bool   found = false;
  for (unsigned int iteration = 0; iteration < 60 && !found; ++iteration)
    {
      if (!equilibrium.solve(tolerance) && equilibrium.largest_force() > creeping * tension)
        {
          // too far: with almost no tension left rollers are free to move
          if (std::abs(moved) < 1e-9)
            break;
          moved *= 0.5;
          equilibrium.move_shaft(-moved);
          continue;
        }
      double now = 0.;
      for (const Layout::Span &span : layout.spans)
        now += equilibrium.tension(span.first + span.links / 2);
      now /= layout.spans.size();
      found = std::abs(now - tension) < 1e-3 * tension;
      if (found)
        break;
      if (moved != 0. && (now - before) / moved > 0.)
        slope = (now - before) / moved;
      before = now;
      moved  = std::clamp((tension - now) / slope, -1e-3, 1e-3);
      equilibrium.move_shaft(moved);
    }
  if (!found)
    throw InputError("Drive/Layout/Pretension in N = " + to_text(tension) +
                     ": no state of rest with this tension in both spans is found; choose another "
                     "one that is well above the weight of a span, " +
                     to_text(chain.weight * tight.links, 3) +
                     " N, and below the working tension, or Centre distance from = slack or sag.");
  equilibrium.store();
}

void bring_to_rest(Layout                          &layout,
                   const RestingChain              &chain,
                   const std::vector<RestingWheel> &wheels)
{
  if (layout.tensioner->travel >= layout.tensioner->law.most)
    return; // it leans on its stop, and the chain has slack
  const double scale = force_of(*layout.tensioner);
  Equilibrium  equilibrium(layout, chain, wheels);
  if (!equilibrium.solve(1e-6 * scale + 1e-3) && equilibrium.largest_force() > creeping * scale)
    throw InputError("Drive/Wheels: no balance of the tensioner's spring, " + to_text(scale, 4) +
                     " N at the wheel's axis, with the tension of the chain is found; choose "
                     "another force of the spring, or Drive/Layout/Start = settled.");
  equilibrium.store();
}

void bring_to_rest(Layout                          &layout,
                   const RestingChain              &chain,
                   const std::vector<RestingWheel> &wheels,
                   const RestingGuide              &guide)
{
  const double scale = force_of(*guide.held);
  Equilibrium  equilibrium(layout, chain, wheels, 0., &guide);
  if (!equilibrium.solve(1e-6 * scale + 1e-3) && equilibrium.largest_force() > creeping * scale)
    throw InputError("Drive/Wheels/driver/Guide: no balance of its spring, " + to_text(scale, 4) +
                     " N at the middle of its line, with the tension of the chain is found; choose "
                     "another force of the spring, or less slack.");
  equilibrium.store();
}

void settle(Layout                          &layout,
            const RestingChain              &chain,
            const std::vector<RestingWheel> &wheels,
            const Operation                 &operation,
            const RestingGuide              *guide)
{
  // a chain that runs takes m v^2 of its tension to turn its own momentum
  const double speed = wheels[0].lever * operation.driver_speed;
  const double pitch = 0.5 * (chain.length.inner + chain.length.outer);
  const double flux  = operation.mass_per_pitch / pitch * speed * speed;

  Equilibrium equilibrium(layout, chain, wheels, flux, guide);
  double      scale = flux;
  if (layout.tensioner)
    scale += force_of(*layout.tensioner);
  if (guide != nullptr)
    scale += force_of(*guide->held);
  const double without_load = scale;
  for (const RestingWheel &wheel : wheels)
    scale += std::abs(wheel.torque) / wheel.lever;
  if (!equilibrium.solve(1e-6 * scale + 1e-3) && equilibrium.largest_force() > creeping * scale)
    throw InputError("Drive/Layout/Start = settled: no balance of the load torque, the tension of "
                     "the chain and the forces of the teeth is found for this drive; choose taut, "
                     "which comes to speed and load in a ramp." +
                     std::string(scale > without_load ? "" :
                                                        " There is no load, and without one no "
                                                        "span is tight: most drives that carry "
                                                        "one settle."));
  equilibrium.store();
  set_in_motion(layout, operation.driver_speed);
  // above the resonance the inertia keeps its mean speed, whatever the polygon
  if (!operation.follows_polygon && operation.driver_speed > 0.)
    for (unsigned int i = 1; i < wheels.size(); ++i)
      set_speed(layout,
                i,
                layout.sprockets[i].turn * layout.sprockets[0].speed * wheels[0].seats /
                    wheels[i].seats);
  // a span cannot swing with its end rollers above its own frequency
  const double mass      = operation.mass_per_pitch / pitch;
  const double frequency = wheels[0].seats * std::abs(layout.sprockets[0].speed) / (2. * PI);
  for (const Layout::Span &span : layout.spans)
    if ((guide != nullptr && &span == &layout.slack()) ||
        frequency >
            string_frequency(
                span.links * pitch, mass, equilibrium.tension(span.first + span.links / 2), speed))
      run_along(layout, span);
}
} // namespace chaindrive::drive
