// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/tooth_form.h>
#include <chaindrive/observe/wrap.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace chaindrive::observe
{
using dealii::numbers::PI;

namespace
{
constexpr double not_there = std::numeric_limits<double>::quiet_NaN();
constexpr double far = 0.75; // of the way to the next gap, from where a roller does not return
constexpr double tip = 0.2;  // pitches on either side of the middle of a tooth

/// @p angle between -pi and pi.
double wrapped(const double angle) { return std::remainder(angle, 2. * PI); }
} // namespace

Wrap::Wrap(const scene::Scene &scene, const unsigned int sprocket)
    : scene_(scene)
    , body_(scene.sprockets.at(sprocket).body)
    , teeth_(scene.sprockets.at(sprocket).teeth)
    , position_(scene.n_joints, not_there)
{
  const auto pitch_radius = [&](const unsigned int teeth) {
    return 0.5 * scene.pitch / std::sin(PI / teeth);
  };
  const scene::Sprocket &other = scene.sprockets.at(1 - sprocket);
  middle_ = scene.bodies[body_].initial.position - scene.bodies[other.body].initial.position;
  const double distance = middle_.norm();
  middle_ /= distance;
  const double pitch = 2. * PI / teeth_;
  const double wrap =
      0.5 * PI + std::asin((pitch_radius(teeth_) - pitch_radius(other.teeth)) / distance);
  half_angle_ = std::max(wrap - pitch, std::min(wrap, pitch));

  const auto family =
      std::find_if(scene.teeth.begin(), scene.teeth.end(), [&](const scene::ToothFamily &teeth) {
        return teeth.sprocket == body_;
      });
  Assert(family != scene.teeth.end(), dealii::ExcInternalError());
  outer_radius_  = family->outer_radius;
  half_width_    = family->half_width;
  roller_radius_ = 0.5 * family->form->roller_diameter;
}

std::vector<Wrap::Place> Wrap::places(const World &world) const
{
  const Frame       &sprocket = world.frames[body_];
  const double       turned   = std::atan2(sprocket.rotation[1][0], sprocket.rotation[0][0]);
  const double       middle   = std::atan2(middle_[1], middle_[0]);
  std::vector<Place> found;
  for (unsigned int k = 0; k < scene_.n_joints; ++k) // rollers are the bodies 0 ... n-1
    {
      const dealii::Tensor<1, 3> arm    = world.frames[k].position - sprocket.position;
      const double               radius = std::hypot(arm[0], arm[1]);
      if (radius > outer_radius_ + 2. * scene_.pitch ||
          arm * middle_ < radius * std::cos(half_angle_))
        continue;
      const double angle = middle + wrapped(std::atan2(arm[1], arm[0]) - middle);
      const double gap   = scene_.sense * (angle - turned) * teeth_ / (2. * PI);
      found.push_back({k, gap - k, radius, arm[2]});
    }
  return found;
}

void Wrap::follow(std::vector<Place> &places)
{
  const unsigned int  n = scene_.n_joints;
  std::vector<double> now(n, not_there);
  const auto          move_near = [](double &position, const double expected) {
    position += std::round(expected - position);
  };
  for (Place &place : places)
    if (!std::isnan(position_[place.joint]))
      {
        move_near(place.position, position_[place.joint]);
        now[place.joint] = place.position;
      }
  // those that have come onto the arc, next to others; twice, for the list begins anywhere
  for (unsigned int i = 0; i < 2; ++i)
    for (Place &place : places)
      for (const unsigned int beside : {(place.joint + 1) % n, (place.joint + n - 1) % n})
        if (std::isnan(now[place.joint]) && !std::isnan(now[beside]))
          {
            move_near(place.position, now[beside]);
            now[place.joint] = place.position;
          }
  for (Place &place : places)
    if (std::isnan(now[place.joint]))
      {
        move_near(place.position, slip_);
        now[place.joint] = place.position;
      }
  position_ = now;
}

void Wrap::look(const World &world)
{
  std::vector<Place> found = places(world);
  follow(found);
  off_ = !found.empty();
  on_tips_.clear();
  if (found.empty())
    return;

  const auto is_within = [this](const Place &place) {
    return place.radius < outer_radius_ && std::abs(place.across) < half_width_;
  };
  std::vector<double> positions;
  for (const Place &place : found)
    {
      positions.push_back(place.position);
      const double from_gap = std::abs(std::remainder(place.position, 1.));
      if (is_within(place))
        off_ = false;
      else if (from_gap > 0.5 - tip && place.radius < outer_radius_ + roller_radius_)
        on_tips_.push_back(place.joint);
    }
  const auto middle = positions.begin() + positions.size() / 2;
  std::nth_element(positions.begin(), middle, positions.end());
  slip_ = *middle;
  if (std::abs(slip_ - jumped_) > far)
    jumped_ = static_cast<int>(std::lround(slip_));
}

void Wrap::serialize(const Archive &archive)
{
  archive.numbers("position", position_);
  archive("slip", slip_);
  archive("jumped", jumped_);
}
} // namespace chaindrive::observe
