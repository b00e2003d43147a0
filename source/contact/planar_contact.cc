// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/planar_contact.h>
#include <chaindrive/drive/stiffness_fit.h>
#include <chaindrive/drive/tooth_form.h>
#include <chaindrive/utilities/simd.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>

namespace chaindrive::contact
{
namespace
{
/// What a place without a contact has for room, m: it never touches. Of a roller its radius.
constexpr double no_room = 1e100;

/// The number of pairs of each contact, of which the pair after pair i belongs to the same one if
/// @p same(i); 0 if there are more in one than in another.
template <typename Same>
unsigned int pairs_per_contact(const unsigned int n, const Same &same)
{
  unsigned int most = 0, run = 0;
  for (unsigned int i = 0; i < n; ++i)
    {
      ++run;
      if (i + 1 < n && same(i))
        continue;
      if (most != 0 && run != most)
        return 0;
      most = run;
      run  = 0;
    }
  return most;
}

bool same_in_plane(const dealii::Point<3> &a, const dealii::Point<3> &b)
{
  return a[0] == b[0] && a[1] == b[1];
}

bool same_in_plane(const scene::SlavePoint &a, const scene::SlavePoint &b)
{
  return a.body == b.body && a.radius == b.radius && a.joint == b.joint &&
         same_in_plane(a.point, b.point);
}

unsigned int multiplicity_of(const scene::SurfaceFamily &family)
{
  return pairs_per_contact(static_cast<unsigned int>(family.slaves.size()),
                           [&family](const unsigned int i) {
                             return same_in_plane(family.slaves[i], family.slaves[i + 1]);
                           });
}

unsigned int multiplicity_of(const scene::BoreFamily &family)
{
  return pairs_per_contact(
      static_cast<unsigned int>(family.pairs.size()), [&family](const unsigned int i) {
        const scene::BorePair &a = family.pairs[i], &b = family.pairs[i + 1];
        return a.master == b.master && a.radius == b.radius && same_in_plane(a.axis, b.axis) &&
               same_in_plane(a.slave, b.slave);
      });
}

double share_of_oval(const scene::SurfaceFamily &family, const World &world)
{
  return world.planar->oval() && family.interface.interface == scene::Interface::roller_teeth ? 1. :
                                                                                                0.;
}

double share_of_oval(const scene::BoreFamily &family, const World &world)
{
  return world.planar->oval() && family.interface == scene::Interface::roller_bush ?
             world.planar->oval()->bore :
             0.;
}
} // namespace

template <typename SceneFamily>
PlanarContact::PlanarContact(const SceneFamily                          &family,
                             const World                                &world,
                             const std::optional<drive::StiffnessCurve> &curve)
    : PointContact(family)
    , kernels_(*planar_contact_kernels(simd_width()))
    , oval_(share_of_oval(family, world))
    , curve_(curve)
    , multiplicity_(multiplicity_of(family))
{
  if (curve_ && multiplicity_ > 0)
    closed_stiffness_ = drive::stiffest(*curve_) / multiplicity_;
}

void PlanarContact::make_places(std::vector<unsigned int> first, const std::vector<double> &room)
{
  first_pair_ = std::move(first);
  touch_.resize_fast(n_planar_touch_entries * n_places());
  std::copy(room.begin(), room.end(), of(planar_touch_room));
  joint_.assign(n_places(), 0);
  slave_.assign(n_places(), 0);
  for (unsigned int place = 0; place < n_places(); ++place)
    if (first_pair_[place] != none)
      {
        joint_[place] = records_[first_pair_[place]].joint;
        slave_[place] = records_[first_pair_[place]].slave;
      }
  in_order_.clear();
  for (unsigned int place = 0; place < n_places(); ++place)
    if (first_pair_[place] != none)
      in_order_.push_back(place);
  std::sort(in_order_.begin(), in_order_.end(), [this](const unsigned int a, const unsigned int b) {
    return first_pair_[a] < first_pair_[b];
  });
  presses_are_known_ = false;
  take_states();
}

void PlanarContact::take_states()
{
  for (unsigned int place = 0; place < n_places(); ++place)
    {
      const bool       is_there             = first_pair_[place] != none;
      const Record     record               = is_there ? records_[first_pair_[place]] : Record{};
      const TouchState state                = is_there ? states_[first_pair_[place]] : TouchState{};
      of(planar_touch_aside)[place]         = 0.; // until it is evaluated
      of(planar_touch_penetration)[place]   = state.penetration;
      of(planar_touch_normal)[place]        = multiplicity_ * state.normal;
      of(planar_touch_slip)[place]          = state.slip[0];
      of(planar_touch_tangential)[place]    = multiplicity_ * state.tangential[0];
      of(planar_touch_gap)[place]           = record.gap;
      of(planar_touch_direction)[place]     = record.normal[0];
      of(planar_touch_direction + 1)[place] = record.normal[1];
      of(planar_touch_approach)[place]      = record.normal_speed;
    }
}

void PlanarContact::update_records() const
{
  const double share = 1. / multiplicity_;
  for (unsigned int place = 0; place < n_places(); ++place)
    {
      if (first_pair_[place] == none)
        continue;
      const double gap = of(planar_touch_gap)[place];
      const double x = of(planar_touch_direction)[place], y = of(planar_touch_direction + 1)[place];
      const double normal     = share * of(planar_touch_normal)[place],
                   tangential = share * of(planar_touch_tangential)[place];
      for (unsigned int i = first_pair_[place]; i < first_pair_[place] + multiplicity_; ++i)
        {
          Record     &record  = records_[i];
          TouchState &state   = states_[i];
          record.gap          = gap;
          record.normal[0]    = x;
          record.normal[1]    = y;
          record.normal_speed = of(planar_touch_approach)[place];
          record.force        = dealii::Tensor<1, 3>();
          state.penetration   = of(planar_touch_penetration)[place];
          state.normal        = normal;
          state.slip[0]       = of(planar_touch_slip)[place];
          state.tangential[0] = tangential;
          if (gap < 0.)
            {
              const double along = tangential + share * of(planar_touch_aside)[place];
              record.force[0]    = normal * x - along * y;
              record.force[1]    = normal * y + along * x;
              record.feature     = features() != nullptr ? features()[place] : 0;
            }
        }
    }
}

void PlanarContact::serialize(const Archive &archive, const unsigned int rank)
{
  PointContact::serialize(archive, rank);
  if (archive.reads())
    take_states();
}

std::vector<unsigned int>
PlanarContact::contacts_among(const std::vector<unsigned int> &pairs) const
{
  std::vector<unsigned int> first;
  for (std::size_t i = 0; i < pairs.size(); i += multiplicity_)
    first.push_back(pairs[i]);
  return first;
}

void PlanarContact::add_joint_forces(std::vector<dealii::Tensor<1, 3>> &forces) const
{
  const double *normal = of(planar_touch_normal), *tangential = of(planar_touch_tangential),
               *aside = of(planar_touch_aside), *x = of(planar_touch_direction),
               *y = of(planar_touch_direction + 1);
  for (unsigned int place = 0; place < n_places(); ++place)
    if (normal[place] > 0.) // nowhere without a contact
      {
        dealii::Tensor<1, 3> &force = forces[joint_[place]];
        const double          along = tangential[place] + aside[place];
        force[0] += normal[place] * x[place] - along * y[place];
        force[1] += normal[place] * y[place] + along * x[place];
      }
}

double PlanarContact::add_normal_forces(std::vector<double> &forces) const
{
  const double *normal = of(planar_touch_normal), *penetration = of(planar_touch_penetration);
  for (unsigned int place = 0; place < n_places(); ++place) // nothing where there is no contact
    forces[joint_[place]] += normal[place];
  std::array<double, n_lanes> deepest{}; // of every eighth, which do not wait for each other
  for (unsigned int first = 0; first < n_places(); first += n_lanes)
    for (unsigned int lane = 0; lane < n_lanes; ++lane)
      deepest[lane] = std::max(deepest[lane], penetration[first + lane]);
  return *std::max_element(deepest.begin(), deepest.end());
}

ForcesInPlaces::View PlanarContact::view() const
{
  return {n_places(),
          of(planar_touch_normal),
          of(planar_touch_tangential),
          of(planar_touch_direction),
          of(planar_touch_direction + 1),
          of(planar_touch_penetration)};
}

std::vector<unsigned int> PlanarContact::joints() const
{
  std::vector<unsigned int> joints = joint_;
  for (unsigned int place = 0; place < n_places(); ++place)
    if (first_pair_[place] == none)
      joints[place] = ForcesInPlaces::no_joint;
  return joints;
}

double PlanarContact::deepest() const
{
  const double *gap   = of(planar_touch_gap);
  double        least = std::numeric_limits<double>::max();
  for (unsigned int place = 0; place < n_places(); ++place)
    if (first_pair_[place] != none)
      least = std::min(least, gap[place]);
  return -least;
}

const std::vector<SurfaceContact::Press> &PlanarContact::presses() const
{
  if (presses_are_known_)
    return presses_;
  presses_are_known_ = true;
  presses_.clear();
  const double  share = 1. / multiplicity_;
  const double *gap = of(planar_touch_gap), *normals = of(planar_touch_normal),
               *tangentials = of(planar_touch_tangential), *asides = of(planar_touch_aside),
               *xs = of(planar_touch_direction), *ys = of(planar_touch_direction + 1);
  const unsigned int *features = this->features();
  for (const unsigned int place : in_order_)
    if (gap[place] < 0.)
      {
        const double normal = share * normals[place],
                     along  = share * (tangentials[place] + asides[place]);
        const double x = xs[place], y = ys[place];
        // where it stays: copies would wait for the numbers that make it up
        Press &press       = presses_.emplace_back();
        press.slave        = slave_[place];
        press.joint        = joint_[place];
        press.feature      = features != nullptr ? features[place] : 0;
        press.n_points     = multiplicity_;
        press.gap          = gap[place];
        press.force[0]     = normal * x - along * y;
        press.force[1]     = normal * y + along * x;
        press.direction[0] = x;
        press.direction[1] = y;
        press.normal       = press.force * press.direction;
      }
  return presses_;
}

PlanarContacts PlanarContact::arguments(const double dt)
{
  return {touch_.begin(),
          n_places(),
          law_.times(multiplicity_),
          dt,
          oval_,
          curve_ ? &*curve_ : nullptr};
}

void PlanarContact::book(const PlanarEnergies &energies, World &world)
{
  world.ledger.contact += energies.stored;
  world.ledger.contact_damping += energies.damping_loss;
  world.ledger.friction += energies.friction_loss;
}

std::unique_ptr<PlanarBores> PlanarBores::make(const scene::BoreFamily &family, const World &world)
{
  const PlanarBodies &bodies = *world.planar;
  for (const scene::BorePair &pair : family.pairs)
    if (bodies.slot_of(pair.master) == PlanarBodies::none ||
        bodies.slot_of(pair.slave.body) == PlanarBodies::none)
      return nullptr;
  std::unique_ptr<PlanarBores> made(new PlanarBores(family, world));
  return made->multiplicity() > 0 ? std::move(made) : nullptr;
}

PlanarBores::PlanarBores(const scene::BoreFamily &family, const World &world)
    : PlanarContact(family, world, family.curve)
{
  if (multiplicity() == 0)
    return;
  // runs: what has the same numbers, one after the other along both rows of slots
  const auto slots = [&](const unsigned int i) {
    const scene::BorePair &pair = family.pairs[i];
    return std::make_pair(world.planar->slot_of(pair.master),
                          world.planar->slot_of(pair.slave.body));
  };
  const auto key = [&](const unsigned int i) {
    const scene::BorePair &pair = family.pairs[i];
    const auto [master, slave]  = slots(i);
    return std::array<double, 7>{{pair.axis[0],
                                  pair.axis[1],
                                  pair.slave.point[0],
                                  pair.slave.point[1],
                                  pair.slave.radius,
                                  double(slave) - double(master),
                                  double(master)}};
  };
  std::vector<unsigned int> contacts = contacts_among(near());
  std::sort(contacts.begin(), contacts.end(), [&key](const unsigned int a, const unsigned int b) {
    return key(a) < key(b);
  });

  std::vector<unsigned int> first;
  std::vector<double>       room;
  std::array<double, 7>     next{};
  const auto                fill = [&]() {
    while (first.size() % n_lanes != 0)
      {
        first.push_back(none);
        room.push_back(no_room);
      }
    if (!runs_.empty())
      runs_.back().n = static_cast<unsigned int>(first.size()) - runs_.back().first_place;
  };
  for (const unsigned int i : contacts)
    {
      const scene::BorePair &pair = family.pairs[i];
      if (runs_.empty() || key(i) != next)
        {
          fill();
          const auto [master, slave] = slots(i);
          runs_.push_back({static_cast<unsigned int>(first.size()),
                           master,
                           slave,
                           0,
                           {pair.axis[0], pair.axis[1]},
                           {pair.slave.point[0], pair.slave.point[1]},
                           pair.slave.radius});
        }
      first.push_back(i);
      room.push_back(pair.radius - pair.slave.radius);
      next = key(i);
      next.back() += 1.;
    }
  fill();
  make_places(std::move(first), room);
}

void PlanarBores::add_forces(World &world, const double dt)
{
  PlanarEnergies energies{};
  kernels_.press_bores(world.planar->slots(),
                       arguments(dt),
                       runs_.data(),
                       static_cast<unsigned int>(runs_.size()),
                       energies);
  book(energies, world);
  forces_are_new();
}

std::unique_ptr<PlanarFlanks> PlanarFlanks::make(const scene::ToothFamily   &teeth,
                                                 const scene::SurfaceFamily &on_flanks,
                                                 const World                &world)
{
  if (teeth.facets || teeth.at_centres || teeth.slaves.empty())
    return nullptr;
  for (const scene::SlavePoint &slave : teeth.slaves)
    if (world.planar->slot_of(slave.body) == PlanarBodies::none || slave.point[0] != 0. ||
        slave.point[1] != 0. || slave.radius != teeth.slaves.front().radius ||
        std::abs(slave.point[2]) > teeth.half_width)
      return nullptr;
  std::unique_ptr<PlanarFlanks> made(new PlanarFlanks(teeth, on_flanks, world));
  return made->multiplicity() > 0 ? std::move(made) : nullptr;
}

PlanarFlanks::PlanarFlanks(const scene::ToothFamily   &teeth,
                           const scene::SurfaceFamily &on_flanks,
                           const World                &world)
    : PlanarContact(on_flanks, world, teeth.curve), bodies_(*world.planar)
{
  using drive::Segment;
  const drive::ToothForm &form = *teeth.form;
  for (std::size_t i = 0; i < form.half_profile.size(); ++i)
    {
      const Segment &from = form.half_profile[i];
      PlanarSegment  to{};
      to.kind = from.kind == Segment::Kind::line ? 0 : from.kind == Segment::Kind::convex ? 1 : -1;
      for (unsigned int d = 0; d < 2; ++d)
        {
          to.begin[d]  = from.begin[d];
          to.end[d]    = from.end[d];
          to.centre[d] = from.centre[d];
          to.middle[d] = from.middle[d];
        }
      to.radius      = from.radius;
      to.half_cosine = from.half_cosine;
      for (unsigned int e = 0; e < 2; ++e)
        {
          dealii::Tensor<1, 2> normal;
          if (to.kind == 0)
            {
              const dealii::Tensor<1, 2> along = from.end - from.begin;
              normal[0]                        = along[1];
              normal[1]                        = -along[0];
            }
          else
            normal = double(to.kind) * ((e == 0 ? from.begin : from.end) - from.centre);
          normal /= normal.norm();
          for (unsigned int d = 0; d < 2; ++d)
            to.end_normal[e][d] = normal[d];
          const drive::ToothForm::Corner corner = form.corners[i + e];
          to.corner[e]                          = corner == drive::ToothForm::Corner::none   ? 0 :
                                                  corner == drive::ToothForm::Corner::convex ? 1 :
                                                                                               -1;
        }
      segments_.push_back(to);
    }
  for (const dealii::Tensor<1, 2> &turn : form.rotations)
    turns_.insert(turns_.end(), {turn[0], turn[1]});
  for (const dealii::Tensor<1, 2> &turn : form.shifted)
    shifted_.insert(shifted_.end(), {turn[0], turn[1]});
}

void PlanarFlanks::search(const World &world, const double reach)
{
  records(); // of those that are out of reach now, too
  PlanarContact::search(world, reach);
  place_near();
}

void PlanarFlanks::serialize(const Archive &archive, const unsigned int rank)
{
  PlanarContact::serialize(archive, rank);
  if (archive.reads())
    place_near();
}

void PlanarFlanks::place_near()
{
  // places side by side have rollers side by side, in slots; those between them are idle
  const std::vector<unsigned int>      contacts = contacts_among(near());
  std::map<unsigned int, unsigned int> in_slot;
  for (const unsigned int i : contacts)
    in_slot[bodies_.slot_of(records_[i].slave)] = i;
  std::vector<unsigned int> first;
  slot_.clear();
  for (const auto &[slot, i] : in_slot)
    {
      if (slot_.empty() || slot >= slot_.back() + n_lanes)
        {
          slot_.push_back(slot);
          first.resize(first.size() + n_lanes, none);
        }
      first[first.size() - n_lanes + slot - slot_.back()] = i;
    }

  std::vector<double> room(first.size(), -no_room);
  gap_.assign(first.size(), 0);
  known_.resize_fast(n_known_nearest * first.size());
  std::fill(known_.begin(), known_.end(), 0.);
  const PlanarTeeth teeth = arguments_of_teeth();
  for (unsigned int place = 0; place < first.size(); ++place)
    {
      const bool is_there = first[place] != none;
      if (is_there)
        {
          room[place] = pairs_.front().slave.radius;
          enter_gap(teeth, place, 0);
        }
      known_of(teeth, place)[known_room * n_lanes] = is_there ? -1. : no_room; // nothing, anything
    }
  make_places(std::move(first), room);
}

PlanarTeeth PlanarFlanks::arguments_of_teeth()
{
  return {segments_.data(),
          static_cast<unsigned int>(segments_.size()),
          static_cast<unsigned int>(turns_.size() / 2),
          turns_.data(),
          shifted_.empty() ? nullptr : shifted_.data(),
          static_cast<unsigned int>(gap_.size()),
          slot_.data(),
          gap_.data(),
          known_.begin(),
          pairs_.front().slave.radius,
          {},
          {},
          {},
          0.,
          {},
          0.};
}

void PlanarFlanks::add_forces(World &world, const double dt)
{
  const unsigned int body  = master();
  const Frame       &hub   = world.frames[body];
  PlanarTeeth        teeth = arguments_of_teeth();
  for (unsigned int d = 0; d < 2; ++d)
    {
      teeth.position[d] = hub.position[d];
      teeth.velocity[d] = hub.velocity[d];
      teeth.rotation[d] = hub.rotation[d][0];
    }
  teeth.spin = hub.angular_velocity[2];
  PlanarEnergies energies{};
  kernels_.press_teeth(world.planar->slots(), arguments(dt), teeth, energies);
  for (unsigned int d = 0; d < 2; ++d)
    world.force.local_element(3 * body + d) += teeth.force[d];
  world.moment.local_element(3 * body + 2) += teeth.moment;
  book(energies, world);
  forces_are_new();
}
} // namespace chaindrive::contact
