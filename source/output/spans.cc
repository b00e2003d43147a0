// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/output/spans.h>

namespace chaindrive::output
{
Spans::Spans(const scene::Scene &scene, const dynamics::System &system)
    : scene_(scene), tension_(scene.n_joints, 0.)
{
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

  const double       from = 0.35 * scene_.centre_distance, to = 0.65 * scene_.centre_distance;
  const unsigned int n       = scene_.n_joints;
  unsigned int       n_tight = 0, n_slack = 0;
  tight_tension = slack_tension = tight_speed = tight_offset = slack_offset = 0.;
  for (unsigned int k = 0; k < n; ++k) // rollers are the bodies 0 ... n-1 in joint order
    {
      const Frame &first  = system.world.frames[k];
      const Frame &second = system.world.frames[(k + 1) % n];
      const double x      = 0.5 * (first.position[0] + second.position[0]);
      if (x < from || x > to)
        continue;
      const bool tight = (first.position * scene_.span_normal) > 0.;
      if (tight)
        {
          tight_tension += tension_[k];
          tight_speed += 0.5 * (first.velocity + second.velocity) * scene_.span_direction;
          tight_offset += first.position * scene_.span_normal;
          ++n_tight;
        }
      else
        {
          slack_tension += tension_[k];
          slack_offset += first.position * scene_.span_normal;
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
} // namespace chaindrive::output
