// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/family.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::contact
{
unsigned int Family::n_touching() const
{
  return static_cast<unsigned int>(std::count_if(
      states_.begin(), states_.end(), [](const TouchState &s) { return s.normal > 0.; }));
}

namespace
{
/// Hands every number of @p record that other ranks need to @p item.
template <typename Item>
void visit(Record &record, const Item &item)
{
  item(record.gap);
  item(record.normal_speed);
  for (unsigned int d = 0; d < 3; ++d)
    {
      item(record.force[d]);
      item(record.normal[d]);
    }
  double feature = record.feature;
  item(feature);
  record.feature = static_cast<unsigned int>(feature);
}
} // namespace

void Family::pack_records(const unsigned int rank, std::vector<double> &numbers) const
{
  for (unsigned int i = 0; i < owner_.size(); ++i)
    if (owner_[i] == rank && within_reach(i))
      {
        Record record = records_[i];
        visit(record, [&numbers](const double value) { numbers.push_back(value); });
      }
}

void Family::unpack_records(const unsigned int         rank,
                            const std::vector<double> &numbers,
                            std::size_t               &position)
{
  for (unsigned int i = 0; i < owner_.size(); ++i)
    if (owner_[i] == rank && within_reach(i))
      visit(records_[i], [&](double &value) { value = numbers[position++]; });
}

void Family::serialize(const Archive &archive, const unsigned int rank)
{
  archive.numbers("records", records_);
  if (!is_dealt_out())
    archive.numbers("states", states_);
  for (unsigned int i = 0; i < owner_.size(); ++i)
    if (owner_[i] == rank)
      serialize_pair(i, archive.of_this_rank() / ("pair " + std::to_string(i)));
}

void Family::apply(World &world, const unsigned int i, const Touch &touch, const double dt)
{
  Record     &record = records_[i];
  TouchState &state  = states_[i];
  record.gap         = touch.gap;
  if (touch.gap >= 0.)
    {
      record.force = dealii::Tensor<1, 3>();
      come_apart(law_, dt, state, world.ledger);
      return;
    }

  const dealii::Tensor<1, 3> relative = world.velocity_at(record.slave, touch.point, 0.5 * dt) -
                                        world.velocity_at(record.master, touch.point, 0.5 * dt);
  record.force        = press(law_, touch, relative, relative, dt, state, world.ledger).total;
  record.feature      = touch.feature;
  record.normal       = touch.normal;
  record.normal_speed = -(relative * touch.normal);

  // equal and opposite at one point: neither momentum nor moment of momentum is made
  world.add_force(record.slave, record.force, touch.point);
  world.add_force(record.master, -record.force, touch.point);
}

void Family::add_closed(const World                &world,
                        const Mobility             &mobility,
                        const unsigned int          i,
                        const dealii::Tensor<1, 3> &along,
                        const dealii::Tensor<1, 3> &centre,
                        const double                radius,
                        std::vector<Spring>        &springs) const
{
  // With d the displacement of the slave's axis relative to the master's material there, w the
  // relative turn, a normal n and the tangent t = z x n, the energy is half of
  //   k (d n)^2 + kt (d t - r w_z)^2 + kt (d_z - r (w x n)_z)^2,
  // and for any s > 0 (d t - r w)^2 <= (1 + s) (d t)^2 + (1 + 1/s) r^2 w^2: what is on the right
  // does not depend on n when all of d in the plane feels the stiffer of the two.
  const unsigned int         master = records_[i].master, slave = records_[i].slave;
  const dealii::Tensor<1, 3> z       = axis_of(world.frames[master], 2);
  const dealii::Tensor<1, 3> axes[3] = {along, dealii::cross_product_3d(z, along), z};
  const double               kt      = law_.friction > 0. ? law_.tangential_stiffness : 0.,
               ct                    = law_.friction > 0. ? law_.tangential_damping : 0.;

  // the s of the spin and that of the tilt make displacement and turn of a free slave equally fast;
  // tilting moves the centre too, by its distance from the slave's along z
  double spin = 0., tilt = 0.;
  if (kt > 0. && radius > 0.)
    {
      const auto moving  = mobility.of_point(master, centre) + mobility.of_point(slave, centre);
      const auto turning = mobility.turning(master) + mobility.turning(slave);
      const auto size    = [](const auto &tensor, const dealii::Tensor<1, 3> &axis) {
        return axis * (tensor * axis);
      };
      const double in_plane = std::max(size(moving, axes[0]), size(moving, axes[1])),
                   across   = size(moving, z),
                   tilting  = std::max(size(turning, axes[0]), size(turning, axes[1]));
      if (in_plane > 0.)
        spin = radius * radius * size(turning, z) / in_plane;
      const double distance = z * (centre - world.frames[slave].position),
                   held     = std::max(law_.stiffness / kt, 1. + spin) * distance * distance;
      if (across > 0.)
        {
          const double half = 0.5 * ((radius * radius + held) * tilting / across - 1.);
          tilt              = half + std::sqrt(half * half + radius * radius * tilting / across);
        }
    }

  const auto add = [&](const unsigned int d, const double k, const double c) {
    if (k > 0. || c > 0.)
      springs.push_back({master, slave, axes[d], centre, centre, k, c});
  };
  const auto add_turning = [&](const unsigned int d, const double s) {
    const double factor = (1. + 1. / s) * radius * radius;
    if (s > 0.)
      springs.push_back({master, slave, axes[d], centre, centre, factor * kt, factor * ct, true});
  };
  for (const unsigned int d : {0, 1})
    add(d, std::max(law_.stiffness, (1. + spin) * kt), std::max(law_.damping, (1. + spin) * ct));
  add(2, (1. + tilt) * kt, (1. + tilt) * ct);
  add_turning(0, tilt);
  add_turning(1, tilt);
  add_turning(2, spin);
}
} // namespace chaindrive::contact
