// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/observe/roller_motion.h>
#include <chaindrive/observe/spans.h>

#include <algorithm>
#include <cmath>
#include <limits>

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

Spans::Spans(const scene::Scene     &scene,
             const scene::DriveView &strand,
             const dynamics::System &system)
    : drive_(strand)
    , spans_(strand.spans.size())
    , tension_(strand.n_joints, 0.)
    , n_links_(strand.spans.size())
    , member_(strand.n_joints)
{
  if (strand.spans.empty())
    return;
  for (const scene::Span &span : strand.spans)
    {
      const scene::Sprocket &from = strand.sprockets[span.from];
      // never so short that it may hold no link
      const double middle = std::max(0.15 * (span.end - span.begin), 0.51 * strand.pitch);
      places_.push_back({shaft_of(scene.bodies[from.body]),
                         0.5 * (span.begin + span.end),
                         std::max(0.5 * (span.end - span.begin), middle),
                         middle,
                         // inside of the normal where the sprocket turns against the drive
                         from.sense * strand.sense * from.pitch_radius});
    }
  for (const scene::Span &span : strand.spans)
    for (const dealii::Tensor<1, 3> &axis : {span.along, span.normal, span.direction})
      steepest_ = std::max(steepest_, axis.norm());
  driver_   = shaft_of(scene.bodies[strand.driver().body]);
  mirrored_ = strand.tight().normal -
              2. * (strand.tight().normal * strand.tight().along) * strand.tight().along;
  const PlanarBodies *in_plane = system.world.planar;
  bool                flat     = in_plane != nullptr && strand.bushes.empty() && mirrored_[2] == 0.;
  for (const scene::Span &span : strand.spans)
    flat = flat && span.normal[2] == 0. && span.direction[2] == 0.;
  for (unsigned int k = 0; flat && k < strand.n_joints; ++k)
    {
      slots_.push_back(in_plane->slot_of(strand.rollers[k]));
      flat = slots_.back() != PlanarBodies::none;
    }
  if (!flat)
    slots_.clear();
  joints_ = system.contacts.find({scene::Interface::bush_pin, 0, strand.strand});
  if (joints_.empty())
    return;
  pin_force_.resize(strand.n_joints);
  for (const unsigned int link : strand.links)
    {
      const scene::Body &body = scene.bodies[link];
      // pins belong to outer links; bushes feel the opposite force
      const PlanarBodies *planar = system.world.planar;
      links_.push_back({link,
                        planar != nullptr ? planar->slot_of(link) : PlanarBodies::none,
                        body.motion == scene::Motion::elastic,
                        body.kind == scene::Kind::outer_link ? 0.5 : -0.5});
    }
  const auto *in_places = dynamic_cast<const contact::ForcesInPlaces *>(joints_.front());
  if (joints_.size() == 1 && in_places != nullptr &&
      std::all_of(links_.begin(), links_.end(), [](const Link &link) {
        return link.slot != PlanarBodies::none;
      }))
    place_ = places_of_joints(*in_places, strand.n_joints);
  if (place_.empty())
    return;
  place_.push_back(place_.front());
  in_places_ = in_places;
  for (std::vector<double> *forces : {&force_x_, &force_y_})
    forces->resize(in_places_->forces_in_places().n);
}

void Spans::joint_forces_in_places(const PlanarBodies &planar)
{
  const contact::ForcesInPlaces::View at = in_places_->forces_in_places();
  for (unsigned int i = 0; i < at.n; ++i)
    {
      const double x = at.normal[i] * at.x[i] - at.tangential[i] * at.y[i],
                   y = at.normal[i] * at.y[i] + at.tangential[i] * at.x[i];
      force_x_[i]    = at.normal[i] > 0. ? x : 0.;
      force_y_[i]    = at.normal[i] > 0. ? y : 0.;
    }
  for (unsigned int k = 0; k < drive_.n_joints; ++k)
    {
      const unsigned int         first = place_[k], last = place_[k + 1];
      const dealii::Tensor<1, 2> axis = planar.rotation(links_[k].slot);
      tension_[k] = links_[k].share * ((force_x_[last] - force_x_[first]) * axis[0] +
                                       (force_y_[last] - force_y_[first]) * axis[1]);
    }
}

void Spans::joint_forces(const dynamics::System &system)
{
  if (in_places_ != nullptr)
    {
      joint_forces_in_places(*system.world.planar);
      return;
    }
  for (dealii::Tensor<1, 3> &force : pin_force_)
    force = dealii::Tensor<1, 3>();
  for (const contact::Family *family : joints_)
    family->add_joint_forces(pin_force_);

  const unsigned int  n      = drive_.n_joints;
  const PlanarBodies *planar = system.world.planar;
  for (unsigned int k = 0; k < n; ++k)
    {
      const Link                 &link  = links_[k];
      const dealii::Tensor<1, 3> &first = pin_force_[k], &last = pin_force_[k + 1 < n ? k + 1 : 0];
      if (link.slot != PlanarBodies::none) // has forces in the plane alone
        {
          const dealii::Tensor<1, 2> axis = planar->rotation(link.slot);
          tension_[k] =
              link.share * ((last[0] - first[0]) * axis[0] + (last[1] - first[1]) * axis[1]);
          continue;
        }
      dealii::Tensor<1, 3> axis;
      if (link.elastic)
        { // an elastic link has no axis but the line through its joints
          axis = roller_position(drive_, system.world, (k + 1) % n) -
                 roller_position(drive_, system.world, k);
          axis /= axis.norm();
        }
      else
        for (unsigned int d = 0; d < 3; ++d)
          axis[d] = system.world.frames[link.body].rotation[d][0];
      tension_[k] = link.share * ((last - first) * axis);
    }
}

unsigned int Spans::span_of(const dealii::Tensor<1, 3> &first,
                            const dealii::Tensor<1, 3> &second,
                            double                     &holds) const
{
  const scene::DriveView    &drive  = drive_;
  const dealii::Tensor<1, 3> middle = 0.5 * (first + second), travel = second - first;
  const auto                 none    = static_cast<unsigned int>(drive.spans.size());
  unsigned int               found   = none;
  double                     nearest = 0.;
  bool                       counts  = false;
  holds                              = std::numeric_limits<double>::max();
  for (unsigned int s = 0; s < none; ++s)
    {
      const scene::Span         &span    = drive.spans[s];
      const Place               &place   = places_[s];
      const dealii::Tensor<1, 3> arm     = middle - place.from;
      const double               aside   = std::abs(arm * span.along - place.middle);
      const double               forward = travel * span.direction;
      if (aside > place.half_length || forward <= 0.)
        { // as long as one of the two is so
          holds = std::min(holds, std::max(aside - place.half_length, -0.5 * forward));
          continue;
        }
      holds = std::min(
          {holds, place.half_length - aside, std::abs(place.half_middle - aside), 0.5 * forward});
      const double away = std::abs(arm * span.normal - place.straight);
      if (found != none)
        holds = std::min(holds, 0.5 * std::abs(away - nearest));
      if (found == none || away < nearest)
        {
          found   = s;
          nearest = away;
          counts  = aside <= place.half_middle;
        }
    }
  holds /= steepest_;
  return counts ? found : none;
}

void Spans::find_members(const World &world)
{
  // bushes go farther than the middles of their links, by which travelled() counts
  const bool   knows_way = world.planar != nullptr && drive_.bushes.empty();
  const double way       = knows_way ? world.planar->travelled() : 0.;
  if (knows_way && way < first_to_look_at_)
    return;
  constexpr double   round_off = 1e-9; // of places, m
  const unsigned int n         = drive_.n_joints;
  members_.clear();
  first_to_look_at_ = std::numeric_limits<double>::max();
  for (unsigned int k = 0; k < n; ++k)
    {
      Member &member = member_[k];
      if (!knows_way || way >= member.until)
        {
          double holds;
          member.span  = span_of(roller_position(drive_, world, k),
                                roller_position(drive_, world, k + 1 < n ? k + 1 : 0),
                                holds);
          member.until = way + std::max(0., holds - round_off);
        }
      if (member.span < spans_.size())
        members_.emplace_back(k, member.span);
      first_to_look_at_ = std::min(first_to_look_at_, member.until);
    }
}

void Spans::add_link(const World       &world,
                     const unsigned int k,
                     Span              &span,
                     const scene::Span &along) const
{
  const unsigned int         next = k + 1 < drive_.n_joints ? k + 1 : 0;
  const dealii::Tensor<1, 3> arm  = roller_position(drive_, world, k) - driver_;
  span.tension += tension_[k];
  span.speed += 0.5 * (roller_velocity(drive_, world, k) + roller_velocity(drive_, world, next)) *
                along.direction;
  span.offset += arm * along.normal;
  span.inward += arm * mirrored_;
}

inline void Spans::add_link_in_plane(const PlanarBodies &planar,
                                     const unsigned int  k,
                                     Span               &span,
                                     const scene::Span  &along) const
{
  const unsigned int         next  = k + 1 < drive_.n_joints ? k + 1 : 0;
  const dealii::Tensor<1, 2> at    = planar.position(slots_[k]);
  const dealii::Tensor<1, 2> speed = planar.velocity(slots_[k]),
                             then  = planar.velocity(slots_[next]);
  const double x = at[0] - driver_[0], y = at[1] - driver_[1];
  span.tension += tension_[k];
  span.speed += 0.5 * (speed[0] + then[0]) * along.direction[0] +
                0.5 * (speed[1] + then[1]) * along.direction[1];
  span.offset += x * along.normal[0] + y * along.normal[1];
  span.inward += x * mirrored_[0] + y * mirrored_[1];
}

void Spans::update(const dynamics::System &system)
{
  const unsigned int n = drive_.n_joints;
  if (!joints_.empty())
    joint_forces(system);
  else if (system.bars.size() == n)
    tension_ = system.bars.tension();

  find_members(system.world);
  std::fill(spans_.begin(), spans_.end(), Span());
  std::fill(n_links_.begin(), n_links_.end(), 0);
  for (auto member = members_.begin(); member != members_.end();)
    {
      // those of one span follow each other
      const unsigned int s    = member->second;
      Span               span = spans_[s];
      for (; member != members_.end() && member->second == s; ++member, ++n_links_[s])
        if (slots_.empty())
          add_link(system.world, member->first, span, drive_.spans[s]);
        else
          add_link_in_plane(*system.world.planar, member->first, span, drive_.spans[s]);
      spans_[s] = span;
    }
  for (unsigned int s = 0; s < spans_.size(); ++s)
    if (n_links_[s] > 0)
      for (double Span::*mean : {&Span::tension, &Span::speed, &Span::offset, &Span::inward})
        spans_[s].*mean /= n_links_[s];
}
} // namespace chaindrive::observe
