// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/family.h>

#include <algorithm>

namespace chaindrive::contact
{
unsigned int Family::n_touching() const
{
  return static_cast<unsigned int>(std::count_if(
      states_.begin(), states_.end(), [](const TouchState &s) { return s.normal > 0.; }));
}

void Family::clear_peaks()
{
  for (Record &record : records_)
    record.peak = 0.;
}

namespace
{
/// Hands every number of @p record that other ranks need to @p exchange.
template <typename Exchange>
void visit(Record &record, const Exchange &exchange)
{
  exchange(record.gap);
  exchange(record.normal_speed);
  for (unsigned int d = 0; d < 3; ++d)
    {
      exchange(record.force[d]);
      exchange(record.normal[d]);
    }
  double feature = record.feature;
  exchange(feature);
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

void Family::exchange(const Archive &archive, const unsigned int rank)
{
  archive.numbers("records", records_);
  if (!is_dealt_out())
    archive.numbers("states", states_);
  for (unsigned int i = 0; i < owner_.size(); ++i)
    if (owner_[i] == rank)
      exchange_pair(i, archive.of_this_rank() / ("pair " + std::to_string(i)));
}

void Family::apply(World &world, const unsigned int i, const Touch &touch, const double dt)
{
  Record     &record = records_[i];
  TouchState &state  = states_[i];
  record.gap         = touch.gap;
  if (touch.gap >= 0.)
    {
      record.force = dealii::Tensor<1, 3>();
      if (state.overlap > 0.) // it has just come apart: let the law book what the spring gave back
        update_touch(law_, touch.gap, 0., dealii::Tensor<1, 2>(), dt, state, world.ledger);
      return;
    }

  const dealii::Tensor<1, 3> relative = world.velocity_at(record.slave, touch.point, 0.5 * dt) -
                                        world.velocity_at(record.master, touch.point, 0.5 * dt);
  const double         gap_rate = relative * touch.normal;
  dealii::Tensor<1, 2> slip_rate;
  slip_rate[0] = relative * touch.along;
  slip_rate[1] = relative * touch.across;

  update_touch(law_, touch.gap, gap_rate, slip_rate, dt, state, world.ledger);
  record.force = state.normal * touch.normal;
  if (law_.friction > 0.)
    record.force += state.tangential[0] * touch.along + state.tangential[1] * touch.across;
  record.feature      = touch.feature;
  record.normal       = touch.normal;
  record.normal_speed = -gap_rate;
  record.peak         = std::max(record.peak, state.normal);

  // equal and opposite at one point: neither momentum nor moment of momentum is made
  world.add_force(record.slave, record.force, touch.point);
  world.add_force(record.master, -record.force, touch.point);
}

void Family::add_closed(const World                &world,
                        const unsigned int          i,
                        const dealii::Tensor<1, 3> &normal,
                        const dealii::Tensor<1, 3> &point,
                        std::vector<Spring>        &springs) const
{
  Touch touch;
  touch.normal = normal;
  set_tangents(touch, world.frames[records_[i].master]);

  const auto add = [&](const dealii::Tensor<1, 3> &direction, const double k, const double c) {
    springs.push_back({records_[i].master, records_[i].slave, direction, point, point, k, c});
  };
  add(touch.normal, law_.stiffness, law_.damping);
  if (law_.friction > 0.)
    {
      add(touch.along, law_.tangential_stiffness, law_.tangential_damping);
      add(touch.across, law_.tangential_stiffness, law_.tangential_damping);
    }
}
} // namespace chaindrive::contact
