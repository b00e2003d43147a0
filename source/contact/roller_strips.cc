// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/mobility.h>
#include <chaindrive/contact/columns.h>
#include <chaindrive/contact/elastic_flanks.h>
#include <chaindrive/contact/roller_strips.h>
#include <chaindrive/mesh/surface/cylinder_grid.h>
#include <chaindrive/reduction/basis.h>
#include <chaindrive/utilities/ranks.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace chaindrive::contact
{
namespace
{
using dealii::numbers::PI;

// m: beyond what overlaps, and as much again as the deepest does, gaps are listed that forces may
// close. What closes gaps is the bush, through the wall: less than the tooth's own force deflects.
constexpr double margin        = 3e-6;
constexpr double strip_sagitta = 1e-6; // m: more than points of a strip lie off its middle's circle
constexpr double near_centre   = 0.05; // over the radius: no modes let a circle so far away touch

/// The rings of a roller that are over teeth, by more than half of what they stand for.
struct CoveredRings
{
  CoveredRings(const mesh::CylinderGrid &grid, const double half_width)
  {
    for (unsigned int r = 0; r < grid.n_rings(); ++r)
      {
        const double z    = grid.rings[r];
        const double from = r == 0 ? z : 0.5 * (z + grid.rings[r - 1]);
        const double to   = r + 1 == grid.n_rings() ? z : 0.5 * (z + grid.rings[r + 1]);
        if (std::min(to, half_width) - std::max(from, -half_width) >= 0.5 * (to - from))
          {
            number.push_back(r);
            length.push_back(to - from);
            all += to - from;
          }
      }
  }

  std::vector<unsigned int> number;
  std::vector<double>       length; ///< m
  double                    all = 0.;
};

/// @p direction turned by a right angle about the @p axis, both unit vectors.
dealii::Tensor<1, 3> turned(const dealii::Tensor<1, 3> &axis, const dealii::Tensor<1, 3> &direction)
{
  return dealii::cross_product_3d(axis, direction);
}

/// A normal force that has been found, and whose energy has been booked.
struct KnownForce
{
  double force; ///< N
  double rate = 0.;

  double penetration() const { return force; }

  void book(const scene::ContactLaw &,
            const TouchState &,
            const TouchState &,
            double /*dt*/,
            ContactEnergies<double> &) const
  {
  }
};
} // namespace

RollerStrips::RollerStrips(const scene::Scene       &scene,
                           const scene::ToothFamily &teeth,
                           const World              &world,
                           std::vector<unsigned int> owner)
    : SurfaceContact(teeth.name,
                     {scene::Interface::roller_teeth, teeth.sprocket},
                     teeth.law,
                     pairs_on(make_flanks(teeth, world), teeth.slaves))
    , flanks_(pairs_.front().surface)
    , outside_(*scene::round_flexibility(scene, teeth.slaves.front().body, teeth.slave_surface))
    , radius_(teeth.slaves.front().radius)
    , form_(teeth.form)
    , profile_(*teeth.form, radius_)
    , group_(world.elastic_address[teeth.slaves.front().body].group)
    , rollers_(teeth.slaves.size())
{
  if (dynamic_cast<const ElasticFlanks *>(flanks_.get()) != nullptr)
    throw std::logic_error("RollerStrips: teeth without penalty must be rigid");
  if (teeth.facets)
    throw std::logic_error("RollerStrips: teeth without penalty must be arcs");
  const BodyBatches       &copies = world.copies[group_];
  const mesh::CylinderGrid grid(*copies.part, mesh::roller_outside);
  const CoveredRings       rings(grid, teeth.half_width);
  flexibility_ = std::make_unique<const StripFlexibility>(
      outside_,
      profile_.grid(),
      rings.number,
      rings.length,
      scene.material,
      StripFlexibility::Tooth{teeth.tooth_stiffness, teeth.loaded_half_angle});

  owner_ = std::move(owner);
  for (const scene::SlavePoint &slave : teeth.slaves)
    {
      bodies_.push_back(slave.body);
      copy_.push_back(world.elastic_address[slave.body].copy);
    }
  for (Roller &roller : rollers_)
    {
      roller.problem.flexibility = flexibility_.get();
      roller.force.assign(flexibility_->n(), 0.);
      roller.strips.resize(flexibility_->grid().size());
    }

  law_.damping = law_.tangential_damping = 0.;
  friction_                              = {1., 0., law_.friction, teeth.sticking_stiffness, 0.};

  length_ = rings.length;
  for (const unsigned int r : rings.number)
    for (unsigned int c = 0; c < outside_.n_columns; ++c)
      node_.push_back(outside_.node[r * outside_.n_columns + c]);
  half_angle_                    = teeth.half_angle;
  half_line_                     = teeth.half_line;
  largest_force_                 = teeth.largest_force;
  const dealii::Tensor<1, 3> tip = world.frames[flanks_->body()].position +
                                   dealii::Point<3>(0.5 * form_->outside_diameter, 0., 0.);
  mobility_ = form_->teeth * dealii::trace(Mobility(world).of_point(flanks_->body(), tip));
  find_own(rank_in(world.communicator()));
}

void RollerStrips::find_own(const unsigned int rank)
{
  own_.clear();
  for (const unsigned int i : near_)
    if (owner_[i] == rank)
      own_.push_back(i);
}

bool RollerStrips::within_reach(const unsigned int i) const
{
  return std::binary_search(near_.begin(), near_.end(), i);
}

void RollerStrips::search(const World &world, const double search_reach)
{
  SurfaceContact::search(world, search_reach);
  find_own(rank_in(world.communicator()));
  for (unsigned int i = 0; i < rollers_.size(); ++i)
    if (!within_reach(i))
      {
        rollers_[i].problem.clear();
        std::fill(rollers_[i].force.begin(), rollers_[i].force.end(), 0.);
      }
}

void RollerStrips::announce(World &world, std::optional<double> /*dt*/)
{
  BodyBatches &copies = world.copies[group_];
  if (!copies.counts_readers() || own_ == read_)
    return;
  for (const unsigned int i : read_)
    copies.add_readers(copies.batch_of(copy_[i]), node_, -1);
  for (const unsigned int i : own_)
    copies.add_readers(copies.batch_of(copy_[i]), node_, 1);
  read_ = own_;
}

StripProblem *RollerStrips::problem_of(const unsigned int body)
{
  for (const unsigned int i : own_)
    if (pairs_[i].slave.body == body)
      return &rollers_[i].problem;
  return nullptr;
}

std::size_t RollerStrips::first_number(const World &world, const unsigned int i) const
{
  const BodyBatches &copies = world.copies[group_];
  return copies.start_of(copies.batch_of(copy_[i])) + copies.lane_of(copy_[i]);
}

ClosedStrips RollerStrips::close(const std::vector<double> &middles,
                                 const double               half_width,
                                 const WallFlexibility     &wall,
                                 const unsigned int         n_bore_rings) const
{
  const StripGrid          &grid = flexibility_->grid();
  const unsigned int        m = flexibility_->n_rings(), n = outside_.n_columns;
  ClosedStrips              closed;
  std::vector<unsigned int> unknown;
  for (unsigned int s = 0; s < grid.size(); ++s)
    if (std::any_of(middles.begin(), middles.end(), [&](const double middle) {
          return std::abs(grid.middle[s] - middle) < half_width + grid.half_width[s];
        }))
      for (unsigned int r = 0; r < m; ++r)
        {
          const Columns columns(grid.middle[s], n);
          unknown.push_back(s * m + r);
          closed.places.push_back({grid.middle[s], {}, columns.weight});
          for (unsigned int k = 0; k < n_weights; ++k)
            closed.places.back().node[k] = node_[r * n + columns.number[k]];
        }
  const std::size_t n_bore = std::size_t(n_bore_rings) * n;
  closed.through.resize(unknown.size() * n_bore);
  for (unsigned int a = 0; a < unknown.size(); ++a)
    {
      for (const unsigned int b : unknown)
        closed.flexibility.push_back(flexibility_->at(unknown[a], b));
      wall.at(unknown[a], -closed.places[a].angle, 2. * PI / n, n, &closed.through[a * n_bore]);
    }
  return closed;
}

std::vector<ClosedWindow> RollerStrips::closed_windows() const
{
  ClosedWindow window;
  window.group         = group_;
  window.surface       = outside_.surface;
  window.n_columns     = outside_.n_columns;
  window.n_rings       = flexibility_->n_rings();
  window.across_middle = law_.friction > 0. ? friction_.tangential_stiffness : 0.;
  window.mobility      = mobility_;
  window.n_rings_of_through =
      static_cast<unsigned int>(outside_.to_bore.size() / outside_.node.size());

  std::vector<JointFlexibility::Place> places; // the rings of the bore themselves
  for (unsigned int q = 0; q < window.n_rings_of_through; ++q)
    places.push_back(q == 0 ? JointFlexibility::Place{0, 0.} : JointFlexibility::Place{q - 1, 1.});
  const WallFlexibility wall(outside_, flexibility_->grid(), flexibility_->rings(), places);
  const auto            add = [&](const std::vector<double> &middles, const double half_width) {
    window.strips.push_back(close(middles, half_width, wall, window.n_rings_of_through));
  };
  double all = 0.;
  for (const drive::Segment &segment : form_->half_profile)
    all += segment.length() / radius_;
  const double seat = form_->half_profile.front().length() / radius_, end = seat + half_line_,
               flank = std::max(end, 0.5 * (seat + all));
  // about the bottom and the end of the seat; on a flank; jammed between two
  add({0.}, std::min(half_angle_, end));
  add({std::max(0., end - half_angle_)}, std::min(half_angle_, end));
  add({flank}, half_line_);
  add({-end, end}, half_line_);
  add({-flank, flank}, half_line_);
  return {window};
}

void RollerStrips::lay_strips(const World &world, const unsigned int i, const double reach)
{
  Roller      &roller = rollers_[i];
  const Frame &frame = world.frames[pairs_[i].slave.body], &hub = world.frames[flanks_->body()];
  const unsigned int n      = outside_.n_columns;
  const auto         centre = dealii::transpose(hub.rotation) * (frame.position - hub.position);
  const auto        &turn =
      (form_->shifted.empty() ? form_->rotations : form_->shifted)[roller.touch.feature];
  // the centre in the frame of gap 0, and back
  dealii::Tensor<1, 2> in_gap;
  in_gap[0]           = turn[0] * centre[0] + turn[1] * centre[1];
  in_gap[1]           = turn[0] * centre[1] - turn[1] * centre[0];
  const auto in_world = [&](const dealii::Tensor<1, 2> &v) {
    dealii::Tensor<1, 3> in_hub;
    in_hub[0] = turn[0] * v[0] - turn[1] * v[1];
    in_hub[1] = turn[1] * v[0] + turn[0] * v[1];
    return hub.rotation * in_hub;
  };
  const auto   to_roller = dealii::transpose(frame.rotation);
  const double turned_by = std::atan2(frame.rotation[1][0], frame.rotation[0][0]);
  const double near      = radius_ + reach + strip_sagitta;
  for (unsigned int s = 0; s < roller.strips.size(); ++s)
    {
      const ToothStrips::Strip  &place = profile_.strips()[s];
      Strip                     &strip = roller.strips[s];
      const dealii::Tensor<1, 2> arm   = place.middle - in_gap;
      if (arm.norm_square() > near * near)
        {
          strip.gap = std::numeric_limits<double>::max();
          continue;
        }
      dealii::Tensor<1, 2> mean;
      strip.gap = -radius_;
      for (const dealii::Tensor<1, 2> &point : place.gauss)
        {
          const dealii::Tensor<1, 2> to_point = point - in_gap;
          const double               distance = to_point.norm();
          strip.gap += 0.5 * distance;
          mean += 0.5 / distance * to_point;
        }
      if (strip.gap > reach)
        continue;
      strip.distance     = arm.norm();
      strip.direction    = in_world(arm / strip.distance);
      strip.mean         = in_world(mean);
      const auto   local = to_roller * strip.direction;
      const double angle = std::atan2(local[1], local[0]);
      strip.angle        = angle + turned_by;
      const Columns columns(angle, n);
      strip.column = columns.number;
      strip.weight = columns.weight;
      strip.slope  = columns.slope;
    }
}

double RollerStrips::find_displacements(const World &world, const unsigned int i)
{
  const Frame               &frame   = world.frames[pairs_[i].slave.body];
  const BodyBatches         &copies  = world.copies[group_];
  const NodeView             at      = NodeView(copies.position);
  const unsigned int         n_rings = flexibility_->n_rings(), n = outside_.n_columns;
  const dealii::Tensor<1, 3> z    = axis_of(world.frames[flanks_->body()], 2);
  dealii::Tensor<1, 3>       tilt = axis_of(frame, 2); // of a ring's centre per length of axis
  tilt -= (tilt * z) * z;
  const std::size_t first = first_number(world, i);
  displacement_.resize(std::size_t(n_rings) * n);
  double largest = 0.;
  for (unsigned int r = 0; r < n_rings; ++r)
    for (unsigned int c = 0; c < n; ++c)
      {
        const unsigned int         number = node_[r * n + c];
        const dealii::Tensor<1, 3> rigid =
            frame.position + frame.rotation * dealii::Tensor<1, 3>(copies.nodes.position[number]);
        displacement_[r * n + c] = at[first + node_offset(number)] - rigid +
                                   outside_.rings[flexibility_->rings()[r]] * tilt;
        largest = std::max(largest, displacement_[r * n + c].norm_square());
      }
  return std::sqrt(largest);
}

void RollerStrips::list_unknowns(const World &world, const unsigned int i, const double reach)
{
  Roller                    &roller  = rollers_[i];
  StripProblem              &problem = roller.problem;
  const dealii::Tensor<1, 3> z       = axis_of(world.frames[flanks_->body()], 2);
  const unsigned int         n_rings = flexibility_->n_rings(), n = outside_.n_columns;
  roller.turning.clear();
  candidates_.clear();
  for (unsigned int s = 0; s < roller.strips.size(); ++s)
    {
      const Strip &strip = roller.strips[s];
      if (strip.gap > reach)
        continue;
      const dealii::Tensor<1, 3> round = turned(z, strip.direction);
      for (unsigned int r = 0; r < n_rings; ++r)
        {
          dealii::Tensor<1, 3> moved, more;
          for (unsigned int k = 0; k < n_weights; ++k)
            {
              const dealii::Tensor<1, 3> &u = displacement_[r * n + strip.column[k]];
              moved += strip.weight[k] * u;
              more += strip.slope[k] * u;
            }
          candidates_.push_back({s * n_rings + r,
                                 strip.angle,
                                 strip.gap - moved * strip.direction,
                                 more * strip.direction + moved * round});
        }
    }
  double penetration = 0.;
  for (const Candidate &candidate : candidates_)
    penetration = std::max(penetration, -candidate.gap);
  for (const Candidate &candidate : candidates_)
    if (candidate.gap < margin + 2. * penetration)
      {
        problem.unknown.push_back(candidate.unknown);
        problem.direction.push_back(candidate.direction);
        problem.gap.push_back(candidate.gap);
        problem.force.push_back(roller.force[candidate.unknown]);
        roller.turning.push_back(candidate.turning);
      }
}

void RollerStrips::measure(const World &world, const unsigned int i)
{
  Roller &roller = rollers_[i];
  roller.problem.clear();
  const Frame &frame = world.frames[pairs_[i].slave.body];
  // a sphere that overlaps has a normal
  const double        beyond = 4. * radius_;
  Surface::Projection none;
  unsigned int        hint = mesh::Projection::no_facet;
  roller.touch    = flanks_->project(world, frame.position, beyond, 2. * radius_, hint, none);
  records_[i].gap = roller.touch.gap < 0. ? roller.touch.gap + beyond - radius_ :
                                            std::numeric_limits<double>::max();
  if (records_[i].gap > near_centre * radius_)
    return;
  // how near modes bring strips, between nodes a little nearer than these; and the deepest overlap
  const double by_modes = 1.25 * find_displacements(world, i),
               reach    = by_modes + margin + 2. * std::max(0., by_modes - records_[i].gap);
  if (records_[i].gap > by_modes + margin)
    return;
  lay_strips(world, i, reach);
  list_unknowns(world, i, reach);
}

void RollerStrips::add_forces(World &world, const double /*dt*/)
{
  for (const unsigned int i : own_)
    measure(world, i);
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
  loads_.clear();
  std::fill(roller.force.begin(), roller.force.end(), 0.);
  for (unsigned int a = 0; a < problem.n(); ++a)
    if (problem.force[a] > 0.)
      {
        const Strip        &strip = roller.strips[problem.unknown[a] / n_rings];
        const double        force = problem.force[a];
        const unsigned int *ring  = &node_[problem.unknown[a] % n_rings * outside_.n_columns];
        roller.force[problem.unknown[a]] = force;
        pressed.sum += force;
        pressed.deepest = std::max(pressed.deepest, -problem.gap[a]);
        // by a turn of the strip about the centre
        const double of_modes = -force * roller.turning[a], of_wall = problem.couple[a];
        pressed.couple -= of_modes;
        through_wall -= of_wall;
        pressed.force -=
            force * strip.mean + (of_modes + of_wall) / strip.distance * turned(z, strip.direction);
        for (unsigned int k = 0; k < n_weights; ++k)
          loads_.push_back({first + node_offset(ring[strip.column[k]]),
                            strip.weight[k] * force,
                            strip.direction});
      }
  if (!(pressed.sum > 0.))
    return pressed;

  const BodyBatches   &copies = world.copies[group_];
  const NodeView       at     = NodeView(copies.position);
  const NodeView       force_on(world.copies[group_].force);
  char *const          is_pressed = world.copies[group_].pressed(copies.batch_of(copy_[i]));
  dealii::Tensor<1, 3> of_nodes; // the couple of what acts on them
  for (const Load &load : loads_)
    {
      if (is_pressed != nullptr)
        is_pressed[(load.node - first) / numbers_per_node] = 1;
      const dealii::Tensor<1, 3> f = -load.force * load.direction;
      force_on.add(load.node, f);
      of_nodes += dealii::cross_product_3d(at[load.node] - centre, f);
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
  const BodyBatches         &copies = world.copies[group_];
  const NodeView             at = NodeView(copies.position), velocity = NodeView(copies.velocity);
  const unsigned int         body = pairs_[i].slave.body, hub = flanks_->body();
  const dealii::Tensor<1, 3> z            = axis_of(world.frames[hub], 2);
  double                     slip_rate[2] = {0., 0.};
  for (const Load &load : loads_)
    {
      dealii::Tensor<1, 3> v =
          velocity[load.node] - world.velocity_at(hub, at[load.node], 0.5 * dt);
      world.symmetry.cancel_across(v); // the other half slips to the other side
      slip_rate[0] -= load.force / pressed.sum * (v * turned(z, load.direction));
      slip_rate[1] += load.force / pressed.sum * (v * z);
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
  dealii::Tensor<1, 3> sum;
  for (const Load &load : loads_)
    {
      const dealii::Tensor<1, 3> f =
          load.force / pressed.sum *
          (state.tangential[1] * z - state.tangential[0] * turned(z, load.direction));
      force_on.add(load.node, f);
      world.add_force(hub, -f, at[load.node]);
      sum += f;
    }
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

void RollerStrips::raise_pressures(std::vector<double> &largest) const
{
  const unsigned int n_rings = flexibility_->n_rings();
  for (const unsigned int i : own_)
    {
      if (!(states_[i].normal > 0.))
        continue;
      double             &of_joint = largest[records_[i].joint];
      const StripProblem &problem  = rollers_[i].problem; // nothing else has a force
      for (unsigned int k = 0; k < problem.n(); ++k)
        if (const unsigned int a = problem.unknown[k]; problem.force[k] > 0.)
          of_joint =
              std::max(of_joint,
                       problem.force[k] / (2. * flexibility_->grid().half_width[a / n_rings] *
                                           radius_ * length_[a % n_rings]));
    }
}

void RollerStrips::add_pressures(const World & /*world*/,
                                 std::vector<NodePressure> &pressures) const
{
  const unsigned int n_rings = flexibility_->n_rings(), n = outside_.n_columns;
  const double       width = 2. * PI * radius_ / n;
  for (const unsigned int i : own_)
    for (unsigned int a = 0; a < flexibility_->n(); ++a)
      if (const double force = rollers_[i].force[a]; force > 0.)
        {
          const Strip       &strip = rollers_[i].strips[a / n_rings];
          const unsigned int ring  = a % n_rings;
          for (unsigned int k = 0; k < n_weights; ++k)
            pressures.push_back({records_[i].slave,
                                 node_[ring * n + strip.column[k]],
                                 strip.weight[k] * force / (width * length_[ring])});
        }
}

void RollerStrips::serialize(const Archive &archive, const unsigned int rank)
{
  SurfaceContact::serialize(archive, rank);
  if (archive.reads())
    find_own(rank);
}

void RollerStrips::serialize_pair(const unsigned int i, const Archive &archive)
{
  SurfaceContact::serialize_pair(i, archive);
  archive.numbers("strips", rollers_[i].force);
}
} // namespace chaindrive::contact
