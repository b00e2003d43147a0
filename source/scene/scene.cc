// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/scene/scene.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace chaindrive::scene
{
dealii::Tensor<1, 3> Mount::along_z()
{
  dealii::Tensor<1, 3> z;
  z[2] = 1.;
  return z;
}

double Scene::pitch_time() const
{
  return 2. * dealii::numbers::PI / (drive.driver().teeth * loads.driver_speed);
}

bool Scene::has_elastic_bodies() const
{
  return std::any_of(
      bodies.begin(), bodies.end(), [](const Body &body) { return deforms(body.motion); });
}

double Scene::nominal_energy() const
{
  if (drive.n_joints == 0 || drive.sprockets.empty())
    return 0.;
  const double speed = drive.driver().pitch_radius * loads.driver_speed;
  return 0.5 * n_strands() * drive.n_joints * drive.mass_per_pitch * speed * speed;
}

const Frame &
DriveView::roller(const unsigned int joint, const std::vector<Frame> &frames, Frame &room) const
{
  const Frame &body = frames[rollers[joint]];
  if (bushes.empty())
    return body;
  const dealii::Tensor<1, 3> arm = body.rotation * bushes[joint];
  room                           = body;
  room.position += arm;
  room.velocity += cross_product_3d(body.angular_velocity, arm);
  return room;
}

double DriveView::pitch_radius_of(const unsigned int n_teeth) const
{
  return 0.5 * pitch / std::sin(dealii::numbers::PI / n_teeth);
}

const Sprocket &DriveView::driven() const
{
  for (const Sprocket &sprocket : sprockets)
    if (sprocket.role == parameters::Role::driven)
      return sprocket;
  throw std::logic_error("no sprocket of the drive has a load");
}

std::string Scene::name_of(const unsigned int b) const
{
  const std::string number =
      std::to_string(bodies[b].number) +
      (bodies[b].strand > 0 ? " of strand " + std::to_string(bodies[b].strand) : "");
  switch (bodies[b].kind)
    {
    case Kind::roller:
      return "roller " + number;
    case Kind::inner_link:
      return "inner link " + number;
    case Kind::outer_link:
      return "outer link " + number;
    case Kind::sprocket:
      return drive.sprockets.at(bodies[b].number).title;
    case Kind::tensioner:
      return (bodies[b].mount.kind == Mount::Kind::motor ? "arm of the " : "tensioner of the ") +
             drive.sprockets.at(bodies[b].number).title;
    case Kind::guide:
      return "guide of " + drive.spans.at(bodies[b].number).name;
    case Kind::bearing:
      return "bearing of the " + drive.sprockets.at(bodies[b].number).title;
    case Kind::machine:
      return "machine behind the coupling of the " + drive.sprockets.at(bodies[b].number).title;
    }
  return "";
}
} // namespace chaindrive::scene
