// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/tensioner.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace chaindrive::drive
{
using dealii::Point;
using dealii::Tensor;
using parameters::CentreDistanceFrom;
using parameters::Holder;

namespace
{
constexpr double stop_at_the_axis = 1e6; // N/m

/// How far @p travel is beyond a stop: above zero beyond the greatest, below zero beyond the least.
double over_stop(const TensionerLaw &law, const double travel)
{
  return travel > law.most ? travel - law.most : travel < law.least ? travel - law.least : 0.;
}

Tensor<1, 2> rotated_by(const Tensor<1, 2> &v, const double angle)
{
  Tensor<1, 2> result;
  result[0] = std::cos(angle) * v[0] - std::sin(angle) * v[1];
  result[1] = std::sin(angle) * v[0] + std::cos(angle) * v[1];
  return result;
}

Tensor<1, 2> quarter_turn(const Tensor<1, 2> &v)
{
  Tensor<1, 2> result;
  result[0] = 0. - v[1];
  result[1] = v[0];
  return result;
}

Point<2> to_point(const std::array<double, 2> &p) { return Point<2>(p[0], p[1]); }
} // namespace

double TensionerLaw::elastic(const double travel) const
{
  return preload - stiffness * travel - stop_stiffness * over_stop(*this, travel);
}

double TensionerLaw::viscous(const double travel, const double speed) const
{
  const double over = over_stop(*this, travel), damper = speed > 0. ? damping : retracting_damping;
  double       stop = 0.;
  if (over != 0.) // as it lets go the damper would pull
    {
      const double sign = over > 0. ? 1. : -1.;
      stop = sign * std::max(stop_damping * sign * speed, -stop_stiffness * std::abs(over));
    }
  return damper * speed + stop;
}

double TensionerLaw::energy(const double travel) const
{
  // where nothing is left to be had of the spring, which without a stiffness is somewhere far away
  double empty = 3.;
  if (stop_stiffness > 0.)
    empty = std::min(empty, most + preload / stop_stiffness);
  if (stiffness * empty > preload)
    empty = preload / stiffness;
  const double over = over_stop(*this, travel), left = empty - travel;
  return (preload - stiffness * empty + 0.5 * stiffness * left) * left +
         0.5 * stop_stiffness * over * over;
}

double TensionerLaw::rate(const double travel) const
{
  return stiffness + (over_stop(*this, travel) != 0. ? stop_stiffness : 0.);
}

Point<2> Tensioner::centre(const double travel) const
{
  return is_arm() ? pivot + rotated_by(reference - pivot, sense * travel) :
                    reference + travel * direction;
}

Point<2> Tensioner::turned(const Point<2> &p) const
{
  return pivot + rotated_by(p - pivot, sense * travel);
}

Tensor<1, 2> Tensioner::way(const double travel) const
{
  return is_arm() ? sense * quarter_turn(centre(travel) - pivot) : direction;
}

Tensor<1, 2> Tensioner::bend(const double travel) const
{
  return is_arm() ? pivot - centre(travel) : Tensor<1, 2>();
}

void Tensioner::carry(const double wheel, const double gravity)
{
  const double moves = inertia + wheel * lever() * lever();
  weight             = gravity * (is_arm() ? wheel : moves);
  law.stop_damping   = 2. * 0.2 * std::sqrt(law.stop_stiffness * moves);
}

std::string Tensioner::with_unit(const double travel) const
{
  return is_arm() ? to_text(travel * 180. / dealii::numbers::PI, 4) + " degrees" : in_mm(travel, 4);
}

std::string Tensioner::in_words(const std::string &wheel,
                                const double       slack,
                                const unsigned int strands,
                                const std::string &point) const
{
  const std::string place = "The " + text_of(holder) + " of the " + wheel + " has " +
                            (is_arm() ? "turned by " : "moved by ") + with_unit(travel);
  if (is_clamped())
    return place + ", where it is clamped.";
  const double force = strands * law.elastic(travel);
  return place +
         (travel >= law.most ?
              " onto its greatest stop, which leaves " + in_mm(slack, 4) + " of slack" :
          travel <= law.least ? " onto its least stop" :
                                "") +
         " and presses with " + to_text(force, 4) +
         (is_arm() ? " N m, " + to_text(force / lever(), 4) + " N at " + point + "." : " N.");
}

void Tensioner::mirror()
{
  sense = -sense;
  for (double *y : {&reference[1], &pivot[1], &direction[1]})
    *y = 0. - *y; // and no negative zero
}

unsigned int tensioned_wheel(const parameters::Sprockets &sprockets)
{
  for (unsigned int i = 0; i < sprockets.list.size(); ++i)
    if (sprockets.list[i].held.holder != Holder::bearing)
      return i;
  return 0;
}

TensionerLaw make_law(const parameters::Tensioner &given, const double share, const double lever)
{
  TensionerLaw law;
  law.preload            = share * given.preload;
  law.stiffness          = share * given.stiffness;
  law.damping            = share * given.damping;
  law.retracting_damping = share * given.retracting_damping.value_or(given.damping);
  law.least              = given.least.value_or(law.least);
  law.most               = given.most.value_or(law.most);
  if (given.least || given.most)
    law.stop_stiffness = stop_at_the_axis * lever * lever;
  return law;
}

Tensioner make_tensioner(const parameters::Drive &drive, const bool reverse)
{
  Tensioner tensioner{};
  tensioner.wheel                    = tensioned_wheel(drive.sprockets);
  const parameters::Sprocket  &wheel = drive.sprockets.list[tensioner.wheel];
  const parameters::Tensioner &given = wheel.held.tensioner();
  tensioner.holder                   = wheel.held.holder;
  tensioner.reference                = to_point(*wheel.centre);
  tensioner.pivot                    = to_point(wheel.held.pivot.value_or(*wheel.centre));
  tensioner.sense                    = reverse ? -1 : 1;
  tensioner.direction[0]             = tensioner.sense * std::cos(wheel.held.direction);
  tensioner.direction[1]             = tensioner.sense * std::sin(wheel.held.direction);
  const double share                 = drive.chain.share();
  tensioner.inertia                  = share * given.inertia;
  tensioner.law                      = make_law(given, share, tensioner.lever());
  if (tensioner.is_clamped())
    tensioner.law = {0., 0., 0., 0., tensioner.law.least, tensioner.law.most};
  return tensioner;
}

void check_tensioner(const parameters::Drive &drive)
{
  std::vector<std::string> held;
  for (const parameters::Sprocket &sprocket : drive.sprockets.list)
    if (sprocket.held.holder != Holder::bearing)
      {
        held.push_back(sprocket.name);
        if (sprocket.runout > 0.)
          throw InputError("Drive/Wheels/" + sprocket.name +
                           "/Runout in um = " + to_text(1e6 * sprocket.runout) +
                           " is for wheels on bearings, whose axes stand still; choose 0, or Held "
                           "by = bearing.");
      }
  if (held.empty())
    return;
  const parameters::Sprocket &wheel   = drive.sprockets.list[tensioned_wheel(drive.sprockets)];
  const std::string           section = "Drive/Wheels/" + wheel.name + "/";
  const std::string           entry   = section + "Held by = " + text_of(wheel.held.holder);
  const bool                  arm     = turns(wheel.held.holder);
  const bool                  clamped = is_clamped(wheel.held.holder);
  if (held.size() > 1)
    throw InputError("Drive/Wheels: " + join(held, " and ") +
                     " are tensioners; one takes up the slack, so choose Held by = bearing for all "
                     "others.");
  if (wheel.role != parameters::Role::idler)
    throw InputError(entry + " is for an idler; choose bearing for a wheel with a load, or Role = "
                             "idler.");
  if (!wheel.centre)
    throw InputError(entry + " moves the wheel from where it has no travel; give " + section +
                     "Centre in mm.");
  if (arm && !wheel.held.pivot)
    throw InputError(entry + " turns about a pivot; give " + section + "Arm/Pivot in mm.");
  if (arm && to_point(*wheel.centre).distance(to_point(*wheel.held.pivot)) < 1e-3)
    throw InputError(section +
                     "Arm/Pivot in mm must be at least 1 mm from Centre in mm, or the arm "
                     "does not move the wheel.");
  if (clamped && drive.layout.centre_distance_from == CentreDistanceFrom::given)
    throw InputError(entry +
                     " is moved until the chain has a slack, a sag or a pre-tension; choose "
                     "one of these for Drive/Layout/Centre distance from, or bearing.");
  if (!clamped && (drive.layout.centre_distance_from == CentreDistanceFrom::sag ||
                   drive.layout.centre_distance_from == CentreDistanceFrom::pretension))
    throw InputError(
        "Drive/Layout/Centre distance from = " + text_of(drive.layout.centre_distance_from) +
        " cannot be with " + entry +
        ", whose spring decides tension and sag; choose given, or slack, which is that "
        "of the chain while the tensioner has no travel.");
  if (!clamped && drive.layout.start == parameters::Start::concentric)
    throw InputError("Drive/Layout/Start = concentric has no contact in its joints, so that the "
                     "chain cannot bear the spring of " +
                     entry + "; choose taut or settled.");
  const parameters::Tensioner &given = wheel.held.tensioner();
  const std::string            limit = section + (arm ? "Arm/" : "Slide/");
  if (given.least.value_or(-1e9) >= given.most.value_or(1e9))
    throw InputError(limit +
                     (arm ? "Least angle in degrees must be below Greatest angle in degrees." :
                            "Least travel in mm must be below Greatest travel in mm."));
  if (!clamped && given.preload == 0. && given.stiffness == 0.)
    throw InputError(
        limit +
        (arm ? "Moment in N m and Stiffness in N m/rad" : "Force in N and Stiffness in N/m") +
        " are both 0, so that nothing presses the wheel against the chain; give one.");
}

parameters::Drive without_tensioner(const parameters::Drive &drive)
{
  parameters::Drive entries = drive;
  for (parameters::Sprocket &sprocket : entries.sprockets.list)
    if (!is_clamped(sprocket.held.holder))
      sprocket.held.holder = Holder::bearing;
  return entries;
}
} // namespace chaindrive::drive
