// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/scene/scene.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace chaindrive::scene
{
using parameters::Role;

bool Scene::has_elastic_bodies() const
{
  return std::any_of(
      bodies.begin(), bodies.end(), [](const Body &body) { return deforms(body.motion); });
}

double Scene::nominal_energy() const
{
  if (n_joints == 0 || sprockets.empty())
    return 0.;
  const double pitch_radius =
      0.5 * pitch / std::sin(dealii::numbers::PI / with(Role::driver).teeth);
  const double speed = pitch_radius * loads.driver_speed;
  return 0.5 * n_joints * mass_per_pitch * speed * speed;
}

const Sprocket &Scene::with(const Role role) const
{
  for (const Sprocket &sprocket : sprockets)
    if (sprocket.role == role)
      return sprocket;
  throw std::logic_error("the scene has no such sprocket");
}

std::string Scene::name_of(const unsigned int b) const
{
  const std::string number = std::to_string(bodies[b].number);
  switch (bodies[b].kind)
    {
    case Kind::roller:
      return "roller " + number;
    case Kind::inner_link:
      return "inner link " + number;
    case Kind::outer_link:
      return "outer link " + number;
    case Kind::sprocket:
      return in_words(sprockets.at(bodies[b].number).role);
    }
  return "";
}
} // namespace chaindrive::scene
