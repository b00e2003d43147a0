// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/geometry.h>
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

/// From the line to the other end of a span to where it touches, in the sense against which the
/// chain leaves: the line touches @p along [m] it.
double touching(const scene::Sprocket &sprocket, const double along)
{
  return sprocket.sense * std::acos(std::clamp(along / sprocket.pitch_radius, -1., 1.));
}

/// @p angle between -pi and pi.
double wrapped(const double angle) { return std::remainder(angle, 2. * PI); }
} // namespace

Wrap::Wrap(const scene::Scene &scene, const unsigned int sprocket)
    : scene_(scene)
    , body_(scene.drive.sprockets.at(sprocket).body)
    , teeth_(scene.drive.sprockets.at(sprocket).teeth)
    , position_(scene.drive.n_joints, not_there)
{
  const scene::DriveView &drive = scene.drive;
  const std::size_t       n     = drive.sprockets.size();
  const scene::Sprocket  &self  = drive.sprockets[sprocket];
  sense_                        = self.sense;
  // from where the chain arrives to where it leaves, in the sense of the rotation
  const auto angle_of       = [](const dealii::Tensor<1, 3> &v) { return std::atan2(v[1], v[0]); };
  const scene::Span &before = drive.spans[(sprocket + n - 1) % n], &behind = drive.spans[sprocket];
  const double       in = angle_of(-before.along) + touching(self, before.length - before.end),
               out      = angle_of(behind.along) - touching(self, behind.begin);
  double arc            = sense_ * (out - in);
  arc -= 2. * PI * std::floor(arc / (2. * PI));
  const double middle = in + 0.5 * sense_ * arc, pitch = 2. * PI / teeth_, wrap = 0.5 * arc;
  middle_[0]  = std::cos(middle);
  middle_[1]  = std::sin(middle);
  half_angle_ = std::max(wrap - pitch, std::min(wrap, pitch));

  const auto family =
      std::find_if(scene.teeth.begin(), scene.teeth.end(), [&](const scene::ToothFamily &teeth) {
        return teeth.sprocket == body_;
      });
  Assert(family != scene.teeth.end(), dealii::ExcInternalError());
  outer_radius_  = family->outer_radius;
  half_width_    = family->half_width;
  z_             = family->z;
  roller_radius_ = 0.5 * family->form->roller_diameter;
}

std::vector<Wrap::Place> Wrap::places(const World &world) const
{
  const Frame               &sprocket = world.frames[body_];
  const dealii::Tensor<1, 3> axis     = contact::axis_of(sprocket, 2);
  const double               turned = std::atan2(sprocket.rotation[1][0], sprocket.rotation[0][0]);
  const double               middle = std::atan2(middle_[1], middle_[0]);
  const double               farthest     = outer_radius_ + 2. * scene_.drive.pitch;
  const double               least_cosine = std::cos(half_angle_);
  std::vector<Place>         found;
  Frame                      room;
  for (unsigned int k = 0; k < scene_.drive.n_joints; ++k)
    {
      const dealii::Tensor<1, 3> arm =
          scene_.drive.roller(k, world.frames, room).position - sprocket.position;
      // the square tells of most, but for round-off
      if (arm[0] * arm[0] + arm[1] * arm[1] > (1. + 1e-9) * farthest * farthest)
        continue;
      const double radius = std::hypot(arm[0], arm[1]);
      if (radius > farthest || arm * middle_ < radius * least_cosine)
        continue;
      const double angle = middle + wrapped(std::atan2(arm[1], arm[0]) - middle);
      const double gap   = sense_ * (angle - turned) * teeth_ / (2. * PI);
      found.push_back({k, gap - k, radius, arm * axis - z_});
    }
  return found;
}

void Wrap::follow(std::vector<Place> &places)
{
  const unsigned int  n = scene_.drive.n_joints;
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

void Wrap::update(const World &world)
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
