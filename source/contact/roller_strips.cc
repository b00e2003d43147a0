// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/elastic_flanks.h>
#include <chaindrive/contact/roller_strips.h>
#include <chaindrive/mesh/surface/cylinder_grid.h>
#include <chaindrive/reduction/basis.h>
#include <chaindrive/utilities/ranks.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace chaindrive::contact
{
namespace
{
using dealii::numbers::PI;

constexpr double reach       = 20e-6; // m: strips with a wider gap cannot touch now
constexpr double near_centre = 1e-4;  // m: nor does a roller whose circle is so far away

/// What the rollers of @p teeth deflect outside without inertia; null if none of them does.
const reduction::RoundFlexibility *outside_of(const scene::Scene       &scene,
                                              const scene::ToothFamily &teeth)
{
  if (teeth.slaves.empty())
    return nullptr;
  const scene::Body &body  = scene.bodies[teeth.slaves.front().body];
  const auto         basis = scene.bases.find(body.part());
  if (body.motion == scene::Motion::reduced && basis != scene.bases.end())
    for (const reduction::RoundFlexibility &side : basis->second->joints)
      if (side.surface == teeth.slave_surface)
        return &side;
  return nullptr;
}

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

/// Weights of the cubic polynomial through four equidistant points, at the part @p t of the way
/// from the second to the third one.
std::array<double, 4> cubic_weights(const double t)
{
  return {{-t * (t - 1.) * (t - 2.) / 6.,
           (t + 1.) * (t - 1.) * (t - 2.) / 2.,
           -(t + 1.) * t * (t - 2.) / 2.,
           (t + 1.) * t * (t - 1.) / 6.}};
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
            ContactEnergies<double> &) const
  {
  }
};
} // namespace

bool RollerStrips::is_exact(const scene::Scene &scene, const scene::ToothFamily &teeth)
{
  return teeth.elastic && outside_of(scene, teeth) != nullptr;
}

RollerStrips::RollerStrips(const scene::Scene       &scene,
                           const scene::ToothFamily &teeth,
                           const World              &world,
                           std::vector<unsigned int> owner)
    : SurfaceContact(teeth.name,
                     {scene::Interface::roller_teeth, teeth.sprocket},
                     teeth.law,
                     pairs_on(make_flanks(teeth, world), teeth.slaves))
    , flanks_(pairs_.front().surface)
    , outside_(*outside_of(scene, teeth))
    , radius_(teeth.slaves.front().radius)
    , group_(world.elastic_address[teeth.slaves.front().body].group)
    , rollers_(teeth.slaves.size())
{
  if (dynamic_cast<const ElasticFlanks *>(flanks_.get()) != nullptr)
    throw std::logic_error("RollerStrips: teeth without penalty must be rigid");
  const BodyBatches       &copies = world.copies[group_];
  const mesh::CylinderGrid grid(*copies.part, mesh::roller_outside);
  const CoveredRings       rings(grid, teeth.half_width);
  flexibility_ = std::make_unique<const StripFlexibility>(
      outside_,
      graded_strips(radius_, teeth.half_angle),
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

  // as springs of friction beside a penalty, a tenth as stiff, on all that may touch at a time
  law_.damping = law_.tangential_damping = 0.;
  law_.tangential_stiffness *= 0.1;
  friction_ = {1.,
               0.,
               law_.friction,
               law_.tangential_stiffness * 2. * teeth.half_angle * radius_ * rings.all,
               0.};

  window_.group      = group_;
  window_.surface    = outside_.surface;
  window_.n_columns  = outside_.n_columns;
  window_.n_rings    = static_cast<unsigned int>(rings.number.size());
  window_.half_angle = teeth.half_angle;
  window_.across.assign(window_.n_rings, 0.);
  window_.across_middle = law_.friction > 0. ? friction_.tangential_stiffness : 0.;
  const unsigned int n_bore =
      static_cast<unsigned int>(outside_.to_bore.size() / outside_.node.size());
  window_.n_rings_of_through = n_bore;
  for (const unsigned int r : rings.number)
    {
      for (unsigned int c = 0; c < outside_.n_columns; ++c)
        window_.node.push_back(outside_.node[r * outside_.n_columns + c]);
      for (const unsigned int s : rings.number)
        for (unsigned int d = 0; d < outside_.n_columns; ++d)
          window_.flexibility.push_back(outside_.at(r, s, d));
      const auto first = outside_.to_bore.begin() + std::size_t(r) * n_bore * outside_.n_columns;
      window_.through.insert(window_.through.end(), first, first + n_bore * outside_.n_columns);
    }
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
    copies.add_readers(copies.batch_of(copy_[i]), window_.node, -1);
  for (const unsigned int i : own_)
    copies.add_readers(copies.batch_of(copy_[i]), window_.node, 1);
  read_ = own_;
}

StripProblem *RollerStrips::problem_of(const unsigned int body)
{
  for (const unsigned int i : own_)
    if (pairs_[i].slave.body == body)
      return &rollers_[i].problem;
  return nullptr;
}

std::size_t RollerStrips::node(const World       &world,
                               const unsigned int i,
                               const unsigned int ring,
                               const unsigned int column) const
{
  const BodyBatches &copies = world.copies[group_];
  return copies.start_of(copies.batch_of(copy_[i])) +
         node_offset(window_.node[ring * window_.n_columns + column]) + copies.lane_of(copy_[i]);
}

bool RollerStrips::project(const World                &world,
                           const dealii::Tensor<1, 3> &x,
                           Roller                     &roller,
                           Touch                      &touch,
                           double                     &distance) const
{
  // a sphere that overlaps has a normal
  const double        beyond = 4. * radius_;
  Surface::Projection none;
  touch    = flanks_->project(world, x, beyond, 2. * radius_, roller.hint, none);
  distance = touch.gap + beyond;
  return touch.gap < 0.;
}

bool RollerStrips::lay(const World       &world,
                       const unsigned int i,
                       const unsigned int s,
                       const double       direction,
                       const double       angle)
{
  Roller                    &roller = rollers_[i];
  Strip                     &strip  = roller.strips[s];
  const StripGrid           &grid   = flexibility_->grid();
  const dealii::Tensor<1, 3> centre = world.frames[pairs_[i].slave.body].position;
  strip.gap                         = 0.;
  strip.normal                      = dealii::Tensor<1, 3>();
  for (const double side : {-1., 1.}) // Gauss points
    {
      const double at = direction + grid.middle[s] + side * grid.half_width[s] / std::sqrt(3.);
      dealii::Tensor<1, 3> x = centre;
      x[0] += radius_ * std::cos(at);
      x[1] += radius_ * std::sin(at);
      Touch  touch;
      double distance = 0.;
      if (!project(world, x, roller, touch, distance))
        return false;
      strip.gap += 0.5 * distance;
      strip.normal += touch.normal;
    }
  strip.normal /= strip.normal.norm();
  if (strip.gap > 2. * reach) // modes do not bring it so near
    return false;

  const unsigned int n      = window_.n_columns;
  const double       place  = (angle + grid.middle[s]) * n / (2. * PI);
  const double       before = std::floor(place);
  strip.weight              = cubic_weights(place - before);
  for (unsigned int k = 0; k < n_weights; ++k)
    {
      const int column = (static_cast<int>(before) + static_cast<int>(k) - 1) % static_cast<int>(n);
      strip.column[k] =
          static_cast<unsigned int>(column < 0 ? column + static_cast<int>(n) : column);
    }
  return true;
}

void RollerStrips::measure(const World &world, const unsigned int i)
{
  Roller       &roller  = rollers_[i];
  StripProblem &problem = roller.problem;
  problem.clear();
  const Frame &frame    = world.frames[pairs_[i].slave.body];
  double       distance = 0.;
  records_[i].gap       = std::numeric_limits<double>::max();
  if (!project(world, frame.position, roller, roller.touch, distance))
    return;
  records_[i].gap = distance - radius_;
  if (distance > radius_ + near_centre)
    return;
  const dealii::Tensor<1, 3> down      = -roller.touch.normal,
                             z         = axis_of(world.frames[flanks_->body()], 2);
  const dealii::Tensor<1, 3> local     = dealii::transpose(frame.rotation) * down;
  const double               direction = std::atan2(down[1], down[0]);
  problem.normal                       = direction;
  dealii::Tensor<1, 3> tilt            = axis_of(frame, 2); // of a ring's centre per length of axis
  tilt -= (tilt * z) * z;

  const BodyBatches &copies  = world.copies[group_];
  const NodeView     at      = NodeView(copies.position);
  const unsigned int n_rings = flexibility_->n_rings();
  for (unsigned int s = 0; s < roller.strips.size(); ++s)
    {
      if (!lay(world, i, s, direction, std::atan2(local[1], local[0])))
        continue;
      const Strip &strip = roller.strips[s];
      for (unsigned int r = 0; r < n_rings; ++r)
        {
          double moved = outside_.rings[flexibility_->rings()[r]] * (tilt * strip.normal);
          for (unsigned int k = 0; k < n_weights; ++k)
            {
              const unsigned int number = window_.node[r * window_.n_columns + strip.column[k]];
              const dealii::Tensor<1, 3> rigid =
                  frame.position +
                  frame.rotation * dealii::Tensor<1, 3>(copies.nodes.position[number]);
              moved += strip.weight[k] *
                       ((at[node(world, i, r, strip.column[k])] - rigid) * strip.normal);
            }
          const double gap = strip.gap + moved;
          if (gap > reach)
            continue;
          problem.unknown.push_back(s * n_rings + r);
          problem.gap.push_back(gap);
          problem.force.push_back(roller.force[s * n_rings + r]);
        }
    }
}

void RollerStrips::add_forces(World &world, const double /*dt*/)
{
  for (const unsigned int i : own_)
    measure(world, i);
}

void RollerStrips::finish_forces(World &world, const double dt)
{
  const BodyBatches &copies = world.copies[group_];
  const NodeView     at = NodeView(copies.position), velocity = NodeView(copies.velocity);
  const unsigned int n_rings = flexibility_->n_rings(), hub = flanks_->body();
  for (const unsigned int i : own_)
    {
      Roller       &roller  = rollers_[i];
      StripProblem &problem = roller.problem;
      Record       &record  = records_[i];
      std::fill(roller.force.begin(), roller.force.end(), 0.);
      double               sum = 0., deepest = 0.;
      dealii::Tensor<1, 3> normal, slip; // sum of normal forces, N; mean velocity, m/s
      const auto           for_each_node = [&](const auto &visit) {
        for (unsigned int a = 0; a < problem.n(); ++a)
          if (problem.force[a] > 0.)
            {
              const Strip       &strip = roller.strips[problem.unknown[a] / n_rings];
              const unsigned int ring  = problem.unknown[a] % n_rings;
              for (unsigned int k = 0; k < n_weights; ++k)
                visit(strip,
                      strip.weight[k] * problem.force[a],
                      node(world, i, ring, strip.column[k]));
            }
      };
      for (unsigned int a = 0; a < problem.n(); ++a)
        if (problem.force[a] > 0.)
          {
            roller.force[problem.unknown[a]] = problem.force[a];
            sum += problem.force[a];
            deepest = std::max(deepest, -problem.gap[a]);
          }
      for_each_node([&](const Strip &strip, const double force, const std::size_t n) {
        normal += force * strip.normal;
        slip += force / sum * (velocity[n] - world.velocity_at(hub, at[n], 0.5 * dt));
      });

      dealii::Tensor<1, 3> friction; // over the normal force
      if (sum > 0. || states_[i].normal > 0.)
        {
          const double along[2] = {slip * roller.touch.along, slip * roller.touch.across};
          ContactEnergies<double> energies{
              world.ledger.contact, world.ledger.contact_damping, world.ledger.friction};
          update_touch(
              friction_, KnownForce{sum}, along, dt, friction_.friction > 0., states_[i], energies);
          world.ledger.contact  = energies.stored;
          world.ledger.friction = energies.friction_loss;
          if (sum > 0.)
            friction = (states_[i].tangential[0] * roller.touch.along +
                        states_[i].tangential[1] * roller.touch.across) /
                       sum;
        }
      record.force = dealii::Tensor<1, 3>();
      const NodeView force_on(world.copies[group_].force);
      for_each_node([&](const Strip &strip, const double force, const std::size_t n) {
        const dealii::Tensor<1, 3> f = force * (strip.normal + friction);
        force_on.add(n, f);
        world.add_force(hub, -f, at[n]);
        record.force += f;
      });
      for (unsigned int d = 0; d < 3; ++d) // for the motion of the centre of mass
        world.force.local_element(3 * record.slave + d) += record.force[d];
      record.force = world.symmetry.whole_force(record.force);
      if (sum > 0.)
        {
          // how bodies have been placed, before they deflect
          record.gap          = dt == 0. ? -deepest : 0.;
          record.feature      = roller.touch.feature;
          record.normal       = normal / normal.norm();
          record.normal_speed = -(slip * record.normal);
        }
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
  archive("hint", rollers_[i].hint);
}
} // namespace chaindrive::contact
