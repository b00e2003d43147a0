// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/forces/oil_film.h>

#include <deal.II/base/numbers.h>

#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace chaindrive
{
namespace
{
/// Gaps wider than this part of a roller's radius hold no film that matters.
constexpr double widest = 0.1;

/// Relative radius of a roller and the profile of @p form where @p near is: the seat is hollow,
/// what follows it is taken for flat.
double radius_on(const drive::ToothForm &form, const drive::Projection &near, const double roller)
{
  if (form.flat)
    return 1. / (1. / roller + 2. / form.pitch_diameter);
  const double angle = 2. * dealii::numbers::PI / form.teeth;
  // the seat's middle is on the line of the gap's bottom
  const double turn   = std::atan2(near.point[1], near.point[0]) - angle * near.tooth_gap;
  const double middle = 0.5 * form.root_diameter + form.seat_radius;
  const double x = near.point.norm() * std::cos(turn), y = near.point.norm() * std::sin(turn);
  const bool   in_seat = std::abs(std::atan2(y, middle - x)) < form.seat_half_angle;
  return in_seat && form.seat_radius > roller ?
             roller * form.seat_radius / (form.seat_radius - roller) :
             roller;
}
} // namespace

double squeeze_resistance(const double viscosity,
                          const double length,
                          const double radius,
                          const double thickness,
                          const double roller)
{
  using dealii::numbers::PI;
  const double wide     = std::min(radius, roller * roller / (2. * thickness));
  const double ratio    = wide / (2. * thickness);
  const double is_long  = 12. * PI * viscosity * length * ratio * std::sqrt(ratio);
  const double is_short = 3. * PI / 8. * viscosity * length * length * length *
                          std::sqrt(2. * wide / thickness) / (thickness * thickness);
  return is_long * is_short / (is_long + is_short);
}

double
SqueezedFilm::advance(const double new_gap, const double stiffness, const double c, const double dt)
{
  const double before = gap, force_before = force, stored_before = stored;
  gap = new_gap;
  if (thickness < gap || dt == 0.)
    thickness = std::max(gap, 0.); // it is full
  else
    {
      const double share = stiffness * dt / c;
      thickness          = std::max((thickness + share * gap) / (1. + share), 0.);
    }
  const double open = std::max(gap, 0.);
  force             = stiffness * std::max(thickness - open, 0.);
  stored            = force * (0.5 * (thickness + open) - gap);
  return 0.5 * (force_before + force) * (before - gap) - (stored - stored_before);
}

OilFilm::OilFilm(scene::OilFilms films)
    : films_(std::move(films)), states_(films_.rollers.size() * (1 + films_.wheels.size()))
{
}

void OilFilm::squeeze(SqueezedFilm               &film,
                      const double                gap,
                      const double                radius,
                      const double                length,
                      const double                stiffness,
                      const unsigned int          roller,
                      const unsigned int          other,
                      const dealii::Tensor<1, 3> &normal,
                      const dealii::Tensor<1, 3> &at,
                      const double                dt,
                      World                      &world)
{
  if (gap > widest * films_.roller_radius)
    {
      film = SqueezedFilm(); // nothing is left in it: it has parted from a surface that was nearer
      return;
    }
  const bool   is_new    = film.thickness < 0.;
  const double thickness = std::max(is_new ? gap : film.thickness, roughness());
  const double c =
      squeeze_resistance(films_.viscosity, length, radius, thickness, films_.roller_radius);
  const double lost  = film.advance(gap, stiffness, c, is_new ? 0. : dt);
  const double share = world.symmetry.share(1.);
  world.ledger.spring += share * film.stored;
  if (!is_new)
    {
      world.ledger.spring_damping += share * lost;
      lost_ += share * lost;
    }
  if (film.force == 0.)
    return;
  world.add_force(roller, share * film.force * normal, at);
  world.add_force(other, -share * film.force * normal, at);
}

void OilFilm::add_forces(World &world, const double dt)
{
  const double      clearance = films_.bore_radius - films_.bush_radius;
  const double      in_bore   = films_.bore_radius * films_.bush_radius / clearance;
  const std::size_t n         = films_.rollers.size();
  for (std::size_t k = 0; k < n; ++k)
    {
      const scene::OilFilms::Roller &one = films_.rollers[k];
      const Frame               &roller = world.frames[one.roller], &link = world.frames[one.link];
      const dealii::Tensor<1, 3> bush =
          link.position + link.rotation * dealii::Tensor<1, 3>({one.bush_x, 0., 0.});
      dealii::Tensor<1, 3> way = roller.position - bush; // of the roller from the bush's axis
      way[2]                   = 0.;
      if (const double away = way.norm(); away > 0.)
        squeeze(states_[k],
                clearance - away,
                in_bore,
                films_.length,
                films_.bush_stiffness,
                one.roller,
                one.link,
                -way / away,
                bush - films_.bush_radius / away * way,
                dt,
                world);
      for (std::size_t i = 0; i < films_.wheels.size(); ++i)
        {
          const scene::OilFilms::Wheel &wheel = films_.wheels[i];
          const Frame                  &frame = world.frames[wheel.body];
          const dealii::Tensor<1, 3>    there =
              transpose(frame.rotation) * (roller.position - frame.position);
          SqueezedFilm &film  = states_[n * (1 + i) + k];
          const double  reach = 0.5 * wheel.form.outside_diameter + 1.2 * films_.roller_radius;
          if (there[0] * there[0] + there[1] * there[1] > reach * reach)
            {
              film = SqueezedFilm();
              continue;
            }
          const drive::Projection    near = wheel.form.closest_point({there[0], there[1]});
          const dealii::Tensor<1, 3> normal =
              frame.rotation * dealii::Tensor<1, 3>({near.normal[0], near.normal[1], 0.});
          squeeze(film,
                  near.distance - films_.roller_radius,
                  radius_on(wheel.form, near, films_.roller_radius),
                  wheel.length,
                  films_.tooth_stiffness,
                  one.roller,
                  wheel.body,
                  normal,
                  roller.position - films_.roller_radius * normal,
                  dt,
                  world);
        }
    }
}

void OilFilm::serialize(const Archive &archive)
{
  archive("states", states_);
  archive("lost", lost_);
}
} // namespace chaindrive
