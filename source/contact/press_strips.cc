// SPDX-License-Identifier: LGPL-2.1-or-later
// What strips of teeth do to rollers, once their forces are known: of class RollerStrips.
#include <chaindrive/contact/roller_strips.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace chaindrive::contact
{
namespace
{
/// @p v turned by a right angle.
dealii::Tensor<1, 2> turned(const dealii::Tensor<1, 2> &v)
{
  return dealii::Tensor<1, 2>({-v[1], v[0]});
}

/// A normal force that has been found, and whose energy has been booked.
struct KnownForce
{
  double force; ///< N
  double rate = 0.;

  double penetration() const { return force; }
  double spring(const scene::ContactLaw &law, const double d) const { return law.stiffness * d; }

  void book(const scene::ContactLaw &,
            const TouchState &,
            const TouchState &,
            double /*dt*/,
            ContactEnergies<double> &) const
  {
  }
};
} // namespace

void RollerStrips::carry(const Strip &strip, const unsigned int ring, const double force)
{
  for (unsigned int k = 0; k < n_weights; ++k)
    {
      const unsigned int place  = ring * outside_.n_columns + strip.column[k];
      unsigned int      &number = load_of_[place];
      if (number == no_load)
        {
          number = static_cast<unsigned int>(loads_.size());
          loads_.push_back({place, 0., {}});
        }
      loads_[number].force += strip.weight[k] * force;
      loads_[number].normal += strip.weight[k] * force * strip.direction;
    }
}

RollerStrips::Pressed RollerStrips::press(World &world, const unsigned int i)
{
  Roller                    &roller  = rollers_[i];
  const StripProblem        &problem = roller.problem;
  const unsigned int         body = pairs_[i].slave.body, hub = flanks_->body();
  const unsigned int         n_rings = flexibility_->n_rings();
  const dealii::Tensor<1, 3> z       = axis_of(world.frames[hub], 2),
                             centre  = world.frames[body].position;
  const std::size_t first            = first_number(world, i);
  Pressed           pressed;
  double            through_wall = 0.; // couple on the bush
  for (const Load &load : loads_)
    load_of_[load.place] = no_load;
  loads_.clear();
  roller.touching.clear();
  dealii::Tensor<1, 2> on_roller; // in the frame of the gap
  for (unsigned int a = 0; a < problem.n(); ++a)
    if (problem.force[a] > 0.)
      {
        const Unknown &unknown = roller.unknowns[a];
        const Strip   &strip   = roller.strips[unknown.strip];
        const double   force   = problem.force[a];
        roller.touching.push_back({problem.unknown[a], unknown.strip, force});
        pressed.sum += force;
        pressed.deepest = std::max(pressed.deepest, -problem.gap[a]);
        // by a turn of the strip about the centre
        const double of_modes = -force * unknown.turning, of_wall = problem.couple[a];
        pressed.couple -= of_modes;
        through_wall -= of_wall;
        const dealii::Tensor<1, 2> on_strip =
            force * strip.mean + (of_modes + of_wall) / strip.distance * turned(strip.direction);
        on_roller -= on_strip;
        if (rim_)
          push(problem.unknown[a] / n_rings, on_strip);
        carry(strip, problem.unknown[a] % n_rings, force);
      }
  roller.change  = std::abs(pressed.deepest - roller.deepest);
  roller.deepest = pressed.deepest;
  if (!(pressed.sum > 0.))
    return pressed;
  pressed.force = roller.frame.in_world(on_roller);
  if (rim_)
    {
      world.teeth_of(hub)->add_forces(roller.touch.feature, on_teeth_);
      on_teeth_.clear();
    }

  const BodyBatches   &copies = world.copies[group_];
  const NodeView       at     = NodeView(copies.position);
  const NodeView       force_on(world.copies[group_].force);
  char *const          is_pressed = world.copies[group_].pressed(copies.batch_of(copy_[i]));
  dealii::Tensor<1, 3> of_nodes; // the couple of what acts on them
  for (const Load &load : loads_)
    {
      const unsigned int number = node_[load.place];
      const std::size_t  node   = first + node_offset(number);
      if (is_pressed != nullptr)
        is_pressed[number] = 1;
      const dealii::Tensor<1, 3> f = -roller.frame.in_world(load.normal);
      force_on.add(node, f);
      of_nodes += dealii::cross_product_3d(at[node] - centre, f);
    }
  const double         too_much = of_nodes * z - pressed.couple;
  dealii::Tensor<1, 3> on_hub   = -of_nodes + too_much * z - through_wall * z;
  world.add_force(hub, -pressed.force, centre);
  for (unsigned int d = 0; d < 3; ++d)
    {
      world.force.local_element(3 * body + d) += pressed.force[d];
      world.moment.local_element(3 * body + d) -= too_much * z[d];
      world.moment.local_element(3 * hub + d) += on_hub[d];
      world.moment.local_element(3 * problem.bush + d) += through_wall * z[d];
    }
  return pressed;
}

void RollerStrips::add_friction(World             &world,
                                const double       dt,
                                const unsigned int i,
                                Pressed           &pressed)
{
  if (!(pressed.sum > 0. || states_[i].normal > 0.))
    return;
  const BodyBatches &copies = world.copies[group_];
  const NodeView     at = NodeView(copies.position), velocity = NodeView(copies.velocity);
  const unsigned int body = pairs_[i].slave.body, hub = flanks_->body();
  const GapFrame    &gap          = rollers_[i].frame;
  const std::size_t  first        = first_number(world, i);
  double             slip_rate[2] = {0., 0.};
  for (const Load &load : loads_)
    {
      const std::size_t    node = first + node_offset(node_[load.place]);
      dealii::Tensor<1, 3> v    = velocity[node] - world.velocity_at(hub, at[node], 0.5 * dt);
      world.symmetry.cancel_across(v); // the other half slips to the other side
      slip_rate[0] -= v * gap.in_world(turned(load.normal)) / pressed.sum;
      slip_rate[1] += load.force / pressed.sum * (v * gap.z);
    }
  ContactEnergies<double> energies{
      world.ledger.contact, world.ledger.contact_damping, world.ledger.friction};
  TouchState &state = states_[i];
  update_touch(
      friction_, KnownForce{pressed.sum}, slip_rate, dt, friction_.friction > 0., state, energies);
  world.ledger.contact  = energies.stored;
  world.ledger.friction = energies.friction_loss;
  if (!(pressed.sum > 0.) || !(friction_.friction > 0.))
    return;
  const NodeView       force_on(world.copies[group_].force);
  dealii::Tensor<1, 3> sum, couple; // about the centre of the hub
  for (const Load &load : loads_)
    {
      const std::size_t          node = first + node_offset(node_[load.place]);
      const dealii::Tensor<1, 3> f    = (load.force * state.tangential[1] * gap.z -
                                      state.tangential[0] * gap.in_world(turned(load.normal))) /
                                     pressed.sum;
      force_on.add(node, f);
      sum += f;
      couple += dealii::cross_product_3d(at[node] - world.frames[hub].position, f);
    }
  world.add_force(hub, -sum, world.frames[hub].position);
  for (unsigned int d = 0; d < 3; ++d)
    world.moment.local_element(3 * hub + d) -= couple[d];
  for (unsigned int d = 0; d < 3; ++d)
    world.force.local_element(3 * body + d) += sum[d];
  pressed.force += sum;
}

void RollerStrips::finish_forces(World &world, const double dt)
{
  for (const unsigned int i : own_)
    {
      Record                    &record  = records_[i];
      Pressed                    pressed = press(world, i);
      const dealii::Tensor<1, 3> normal  = pressed.force;
      add_friction(world, dt, i, pressed);
      record.force  = world.symmetry.whole_force(pressed.force);
      most_pressed_ = std::max(most_pressed_, record.force.norm() / largest_force_);
      if (!(pressed.sum > 0.))
        {
          // strips that do not touch are at least as far away as nothing; round it might overlap
          const std::vector<double> &gaps = rollers_[i].problem.gap;
          record.gap =
              std::max(0., gaps.empty() ? record.gap : *std::min_element(gaps.begin(), gaps.end()));
          continue;
        }
      // how bodies have been placed, before they deflect
      record.gap     = dt == 0. ? -pressed.deepest : 0.;
      record.feature = rollers_[i].touch.feature;
      record.normal  = normal / normal.norm();
      record.normal_speed =
          -(world.frames[record.slave].velocity -
            world.velocity_at(flanks_->body(), world.frames[record.slave].position, 0.5 * dt)) *
          record.normal;
    }
}
} // namespace chaindrive::contact
