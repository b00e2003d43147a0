// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/spans.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::observe
{
namespace
{
/// A point of the axis about which @p body turns.
dealii::Tensor<1, 3> shaft_of(const scene::Body &body)
{
  return body.mount.pivot ? dealii::Tensor<1, 3>(*body.mount.pivot) : body.initial.position;
}
} // namespace

Spans::Spans(const scene::Scene &scene, const dynamics::System &system)
    : scene_(scene)
    , spans_(scene.drive.spans.size())
    , tension_(scene.drive.n_joints, 0.)
    , n_links_(scene.drive.spans.size())
{
  const scene::DriveView &drive = scene.drive;
  if (drive.spans.empty())
    return;
  for (const scene::Span &span : drive.spans)
    {
      const scene::Sprocket &from = drive.sprockets[span.from];
      // never so short that it may hold no link
      const double middle = std::max(0.15 * (span.end - span.begin), 0.51 * drive.pitch);
      places_.push_back({shaft_of(scene.bodies[from.body]),
                         0.5 * (span.begin + span.end),
                         std::max(0.5 * (span.end - span.begin), middle),
                         middle,
                         // inside of the normal where the sprocket turns against the drive
                         from.sense * drive.sense * from.pitch_radius});
    }
  driver_   = shaft_of(scene.bodies[drive.driver().body]);
  mirrored_ = drive.tight().normal -
              2. * (drive.tight().normal * drive.tight().along) * drive.tight().along;
  joints_ = system.contacts.find(scene::Interface::bush_pin);
  if (!joints_.empty())
    pin_force_.resize(drive.n_joints);
}

void Spans::joint_forces(const dynamics::System &system)
{
  for (dealii::Tensor<1, 3> &force : pin_force_)
    force = dealii::Tensor<1, 3>();
  for (const contact::Family *family : joints_)
    family->add_joint_forces(pin_force_);

  const unsigned int n = scene_.drive.n_joints;
  Frame              here, there;
  for (unsigned int k = 0; k < n; ++k)
    {
      dealii::Tensor<1, 3> axis;
      const unsigned int   link = scene_.drive.links[k];
      if (scene_.bodies[link].motion == scene::Motion::elastic)
        { // an elastic link has no axis but the line through its joints
          axis = scene_.drive.roller((k + 1) % n, system.world.frames, there).position -
                 scene_.drive.roller(k, system.world.frames, here).position;
          axis /= axis.norm();
        }
      else
        for (unsigned int d = 0; d < 3; ++d)
          axis[d] = system.world.frames[link].rotation[d][0];
      // pins belong to outer links; bushes feel the opposite force
      const double sign = scene_.bodies[link].kind == scene::Kind::outer_link ? 0.5 : -0.5;
      tension_[k]       = sign * ((pin_force_[(k + 1) % n] - pin_force_[k]) * axis);
    }
}

unsigned int Spans::span_of(const Frame &first, const Frame &second) const
{
  const scene::DriveView    &drive  = scene_.drive;
  const dealii::Tensor<1, 3> middle = 0.5 * (first.position + second.position),
                             travel = second.position - first.position;
  const auto   none                 = static_cast<unsigned int>(drive.spans.size());
  unsigned int found                = none;
  double       nearest              = 0.;
  bool         counts               = false;
  for (unsigned int s = 0; s < none; ++s)
    {
      const scene::Span         &span  = drive.spans[s];
      const Place               &place = places_[s];
      const dealii::Tensor<1, 3> arm   = middle - place.from;
      const double               aside = std::abs(arm * span.along - place.middle);
      if (aside > place.half_length || travel * span.direction <= 0.)
        continue;
      const double away = std::abs(arm * span.normal - place.straight);
      if (found == none || away < nearest)
        {
          found   = s;
          nearest = away;
          counts  = aside <= place.half_middle;
        }
    }
  return counts ? found : none;
}

void Spans::update(const dynamics::System &system)
{
  const unsigned int n = scene_.drive.n_joints;
  if (!joints_.empty())
    joint_forces(system);
  else if (system.bars.size() == n)
    tension_ = system.bars.tension();

  std::fill(spans_.begin(), spans_.end(), Span());
  std::fill(n_links_.begin(), n_links_.end(), 0);
  Frame here, there;
  for (unsigned int k = 0; k < n; ++k)
    {
      const Frame       &first  = scene_.drive.roller(k, system.world.frames, here);
      const Frame       &second = scene_.drive.roller((k + 1) % n, system.world.frames, there);
      const unsigned int s      = span_of(first, second);
      if (s == spans_.size())
        continue;
      const scene::Span &along = scene_.drive.spans[s];
      Span              &span  = spans_[s];
      span.tension += tension_[k];
      span.speed += 0.5 * (first.velocity + second.velocity) * along.direction;
      span.offset += (first.position - driver_) * along.normal;
      span.inward += (first.position - driver_) * mirrored_;
      ++n_links_[s];
    }
  for (unsigned int s = 0; s < spans_.size(); ++s)
    if (n_links_[s] > 0)
      for (double Span::*mean : {&Span::tension, &Span::speed, &Span::offset, &Span::inward})
        spans_[s].*mean /= n_links_[s];
}
} // namespace chaindrive::observe
