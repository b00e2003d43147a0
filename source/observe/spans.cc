// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/spans.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::observe
{
Spans::Spans(const scene::Scene &scene, const dynamics::System &system)
    : scene_(scene), tension_(scene.n_joints, 0.)
{
  // The common tangents of the pitch circles touch both where their normal, turned by the angle
  // asin((r1 - r2) / c) from the perpendicular to the line of centres, does.
  const auto pitch_radius = [&](const unsigned int teeth) {
    return 0.5 * scene.pitch / std::sin(dealii::numbers::PI / teeth);
  };
  const double r1   = pitch_radius(scene.sprockets[0].teeth);
  const double r2   = pitch_radius(scene.sprockets[1].teeth);
  const double sine = (r1 - r2) / scene.centre_distance;
  const double from = r1 * sine, to = scene.centre_distance + r2 * sine;
  middle_ = 0.5 * (from + to);
  // never so short that it may hold no link
  half_length_ = std::max(0.15 * (to - from), 0.51 * scene.pitch);
  // the slack span's is the mirror image of the tight span's in the line of centres
  slack_normal_ = scene.span_normal;
  slack_normal_[0] *= -1.;

  joints_ = system.contacts.find("bush-pin");
  if (joints_.empty())
    return;
  pin_force_.resize(scene.n_joints);
  links_.resize(scene.n_joints);
  for (unsigned int b = 0; b < scene.bodies.size(); ++b)
    if (scene.bodies[b].kind == scene::Kind::inner_link ||
        scene.bodies[b].kind == scene::Kind::outer_link)
      links_[scene.bodies[b].number] = b;
}

void Spans::joint_forces(const dynamics::System &system)
{
  for (dealii::Tensor<1, 3> &force : pin_force_)
    force = dealii::Tensor<1, 3>();
  for (const contact::Family *family : joints_)
    for (const contact::Record &record : family->records())
      pin_force_[record.joint] += record.force;

  const unsigned int n = scene_.n_joints;
  for (unsigned int k = 0; k < n; ++k)
    {
      dealii::Tensor<1, 3> axis;
      if (scene_.bodies[links_[k]].motion == scene::Motion::elastic)
        { // an elastic link has no axis but the line through its joints
          axis = system.world.frames[(k + 1) % n].position - system.world.frames[k].position;
          axis /= axis.norm();
        }
      else
        for (unsigned int d = 0; d < 3; ++d)
          axis[d] = system.world.frames[links_[k]].rotation[d][0];
      // pins belong to outer links; bushes feel the opposite force
      const double sign = scene_.bodies[links_[k]].kind == scene::Kind::outer_link ? 0.5 : -0.5;
      tension_[k]       = sign * ((pin_force_[(k + 1) % n] - pin_force_[k]) * axis);
    }
}

void Spans::update(const dynamics::System &system)
{
  if (!joints_.empty())
    joint_forces(system);
  else if (system.bars.size() == scene_.n_joints)
    tension_ = system.bars.tension();

  const unsigned int n       = scene_.n_joints;
  unsigned int       n_tight = 0, n_slack = 0;
  tight_tension = slack_tension = tight_speed = tight_offset = slack_offset = 0.;
  for (unsigned int k = 0; k < n; ++k) // rollers are the bodies 0 ... n-1 in joint order
    {
      const Frame &first  = system.world.frames[k];
      const Frame &second = system.world.frames[(k + 1) % n];
      const double x      = 0.5 * (first.position[0] + second.position[0]);
      if (std::abs(x - middle_) > half_length_)
        continue;
      // joints are counted in the direction of travel, in which the two spans differ
      if ((second.position - first.position) * scene_.span_direction > 0.)
        {
          tight_tension += tension_[k];
          tight_speed += 0.5 * (first.velocity + second.velocity) * scene_.span_direction;
          tight_offset += first.position * scene_.span_normal;
          ++n_tight;
        }
      else
        {
          slack_tension += tension_[k];
          slack_offset += first.position * slack_normal_;
          ++n_slack;
        }
    }
  if (n_tight > 0)
    {
      tight_tension /= n_tight;
      tight_speed /= n_tight;
      tight_offset /= n_tight;
    }
  if (n_slack > 0)
    {
      slack_tension /= n_slack;
      slack_offset /= n_slack;
    }
}
} // namespace chaindrive::observe
