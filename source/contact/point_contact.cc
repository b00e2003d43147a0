// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/bore.h>
#include <chaindrive/contact/flat_side.h>
#include <chaindrive/contact/point_contact.h>
#include <chaindrive/contact/point_force.h>
#include <chaindrive/contact/tooth_side.h>
#include <chaindrive/mesh/surface/facet_surface.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::contact
{
namespace
{
std::vector<SurfaceContact::Pair> pairs_in(const std::vector<scene::BorePair> &bores)
{
  const auto surfaces = std::make_shared<std::vector<Bore>>(); // side by side in memory
  for (const scene::BorePair &bore : bores)
    surfaces->emplace_back(bore.master, bore.axis, bore.radius);
  std::vector<SurfaceContact::Pair> pairs;
  for (unsigned int i = 0; i < bores.size(); ++i)
    pairs.push_back({std::shared_ptr<const Surface>(surfaces, &(*surfaces)[i]), bores[i].slave});
  return pairs;
}

std::vector<SurfaceContact::Pair> pairs_in(const std::vector<scene::SidePair> &sides)
{
  const auto surfaces = std::make_shared<std::vector<FlatSide>>(); // side by side in memory
  for (const scene::SidePair &side : sides)
    surfaces->emplace_back(side.master, side.z, side.sign);
  std::vector<SurfaceContact::Pair> pairs;
  for (unsigned int i = 0; i < sides.size(); ++i)
    pairs.push_back({std::shared_ptr<const Surface>(surfaces, &(*surfaces)[i]), sides[i].slave});
  return pairs;
}

std::vector<SurfaceContact::Pair> pairs_in(const scene::ToothSideFamily &family)
{
  const std::shared_ptr<const Surface> sides[2] = {std::make_shared<const ToothSide>(family, -1),
                                                   std::make_shared<const ToothSide>(family, 1)};
  std::vector<SurfaceContact::Pair>    pairs;
  for (const scene::SlavePoint &slave : family.slaves)
    pairs.push_back({sides[slave.point[2] > 0. ? 1 : 0], slave});
  return pairs;
}
} // namespace

PointContact::PointContact(const std::string        &name,
                           const scene::InterfaceOf &interface,
                           const scene::ContactLaw  &law,
                           std::vector<Pair>         pairs)
    : SurfaceContact(name, interface, law, std::move(pairs))
    , closed_stiffness_(law.stiffness)
    , hints_(records_.size(), mesh::Projection::no_facet)
{
}

PointContact::PointContact(const scene::SurfaceFamily &scene)
    : PointContact(scene.name, scene.interface, scene.law, pairs_on(scene.surface, scene.slaves))
{
}

PointContact::PointContact(const scene::BoreFamily &scene)
    : PointContact(scene.name, {scene.interface, 0, scene.strand}, scene.law, pairs_in(scene.pairs))
{
  add_forces_ = &PointContact::add_forces_of<Bore>;
}

PointContact::PointContact(const scene::SideFamily &scene)
    : PointContact(scene.name, {scene.interface, 0, scene.strand}, scene.law, pairs_in(scene.pairs))
{
  add_forces_ = &PointContact::add_forces_of<FlatSide>;
}

PointContact::PointContact(const scene::ToothSideFamily &scene)
    : PointContact(scene.name,
                   {scene::Interface::plate_teeth, scene.sprocket, scene.strand},
                   scene.law,
                   pairs_in(scene))
{
}

void PointContact::serialize(const Archive &archive, const unsigned int rank)
{
  SurfaceContact::serialize(archive, rank);
  archive.numbers("hints", hints_);
}

void PointContact::add_forces(World &world, const double dt) { (this->*add_forces_)(world, dt); }

namespace
{
void project(const Surface              &surface,
             const World                &world,
             const dealii::Tensor<1, 3> &x,
             const double                radius,
             unsigned int               &hint,
             Surface::Projection        &projection,
             Touch                      &touch)
{
  touch = surface.is_beside(world, x) ?
              Touch() :
              surface.project(world, x, radius, 2. * radius, hint, projection);
}

void project(const Bore                 &bore,
             const World                &world,
             const dealii::Tensor<1, 3> &x,
             const double                radius,
             unsigned int &,
             Surface::Projection &,
             Touch &touch)
{
  bore.project(world, x, radius, touch);
}

void project(const FlatSide             &side,
             const World                &world,
             const dealii::Tensor<1, 3> &x,
             const double,
             unsigned int &,
             Surface::Projection &,
             Touch &touch)
{
  side.project(world, x, touch);
}
} // namespace

template <typename SurfaceType>
void PointContact::add_forces_of(World &world, const double dt)
{
  // once for all
  Surface::Projection projection;
  Touch               touch;
  for (const unsigned int i : near_)
    {
      const scene::SlavePoint &slave   = pairs_[i].slave;
      const auto              &surface = static_cast<const SurfaceType &>(*pairs_[i].surface);
      project(surface,
              world,
              to_world(world.frames[slave.body], slave.point),
              slave.radius,
              hints_[i],
              projection,
              touch);
      add_force(world, i, surface, projection, touch, dt);
    }
}

template <typename SurfaceType>
void PointContact::add_force(World                     &world,
                             const unsigned int         i,
                             const SurfaceType         &surface,
                             const Surface::Projection &projection,
                             const Touch               &touch,
                             const double               dt)
{
  const scene::SlavePoint &slave  = pairs_[i].slave;
  Record                  &record = records_[i];
  TouchState              &state  = states_[i];

  record.gap = touch.gap;
  if (touch.gap >= 0.)
    {
      record.force = dealii::Tensor<1, 3>();
      separate(law_, dt, state, world.ledger);
      return;
    }

  const dealii::Tensor<1, 3> relative = surface.relative_velocity(
      world, touch.point, projection, world.velocity_at(slave.body, touch.point, 0.5 * dt), dt);
  const PointForce force = penalty_force(law_,
                                         touch,
                                         relative,
                                         surface.slip_velocity(world, touch, projection, relative),
                                         dt,
                                         state,
                                         world.ledger);
  record.force           = world.symmetry.whole_force(force.total);
  record.feature         = touch.feature;
  record.normal          = touch.normal;
  record.normal_speed    = -(relative * touch.normal);

  // equal and opposite at one point: neither momentum nor angular momentum is made
  world.add_force(slave.body, force.total, touch.point);
  surface.add_opposite(world, touch.point, touch, projection, force);
}

void PointContact::add_springs(const World &world, std::vector<Spring> &springs) const
{
  const Mobility mobility(world);
  for (const unsigned int i : near_)
    {
      const scene::SlavePoint   &slave  = pairs_[i].slave;
      const Frame               &frame  = world.frames[slave.body];
      const dealii::Tensor<1, 3> z      = axis_of(world.frames[records_[i].master], 2);
      const dealii::Tensor<1, 3> centre = to_world(frame, slave.point);
      if (pairs_[i].surface->facing() != Surface::Facing::across_axis)
        {
          add_closed_side(world, i, z, centre, springs);
          continue;
        }
      dealii::Tensor<1, 3> along = pairs_[i].surface->main_direction(world, frame, centre);
      along -= (along * z) * z;
      add_closed(world, mobility, i, along / along.norm(), centre, slave.radius, springs);
    }
}

void PointContact::add_closed(const World                &world,
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
      const auto moving = mobility.of_point(master, centre) + mobility.of_point(slave, centre);
      const auto inverse_inertia =
          mobility.inverse_inertia(master) + mobility.inverse_inertia(slave);
      const auto size = [](const auto &tensor, const dealii::Tensor<1, 3> &axis) {
        return axis * (tensor * axis);
      };
      const double in_plane = std::max(size(moving, axes[0]), size(moving, axes[1])),
                   across   = size(moving, z),
                   tilting =
                       std::max(size(inverse_inertia, axes[0]), size(inverse_inertia, axes[1]));
      if (in_plane > 0.)
        spin = radius * radius * size(inverse_inertia, z) / in_plane;
      const double distance = z * (centre - world.frames[slave].position),
                   held     = std::max(closed_stiffness_ / kt, 1. + spin) * distance * distance;
      if (across > 0.)
        {
          const double half = 0.5 * ((radius * radius + held) * tilting / across - 1.);
          tilt              = half + std::sqrt(half * half + radius * radius * tilting / across);
        }
    }

  const auto add = [&](const unsigned int d, const double k, const double c) {
    if (k > 0. || c > 0.)
      springs.push_back({master,
                         slave,
                         axes[d],
                         centre,
                         centre,
                         world.symmetry.whole(k),
                         world.symmetry.whole(c)});
  };
  const auto add_rotation = [&](const unsigned int d, const double s) {
    const double factor = world.symmetry.whole((1. + 1. / s) * radius * radius);
    if (s > 0.)
      springs.push_back({master, slave, axes[d], centre, centre, factor * kt, factor * ct, true});
  };
  // an oval u of the roller adds to d n, and (d n + u)^2 <= (1 + s) (d n)^2 + (1 + 1/s) u^2: this s
  // makes both equally fast
  double     oval = 0.;
  const bool bore = interface_.interface == scene::Interface::roller_bush;
  if (world.planar != nullptr && world.planar->oval() &&
      (bore || interface_.interface == scene::Interface::roller_teeth))
    {
      const drive::RollerRing &ring = *world.planar->oval();
      const auto moving = mobility.of_point(master, centre) + mobility.of_point(slave, centre);
      oval =
          1. / (ring.mass * std::max(axes[0] * (moving * axes[0]), axes[1] * (moving * axes[1])));
      const double factor = world.symmetry.whole(1. + 1. / oval);
      springs.push_back({bore ? master : slave,
                         Spring::ground,
                         axes[0],
                         centre,
                         centre,
                         factor * closed_stiffness_,
                         factor * law_.damping,
                         false,
                         true});
    }
  for (const unsigned int d : {0, 1})
    add(d,
        std::max((1. + oval) * closed_stiffness_, (1. + spin) * kt),
        std::max((1. + oval) * law_.damping, (1. + spin) * ct));
  add(2, (1. + tilt) * kt, (1. + tilt) * ct);
  add_rotation(0, tilt);
  add_rotation(1, tilt);
  add_rotation(2, spin);
}

void PointContact::add_closed_side(const World                &world,
                                   const unsigned int          i,
                                   const dealii::Tensor<1, 3> &z,
                                   const dealii::Tensor<1, 3> &point,
                                   std::vector<Spring>        &springs) const
{
  // k along the normal, kt across it: where that may be any, the greater one along all directions
  const bool   anywhere = pairs_[i].surface->facing() == Surface::Facing::anywhere;
  const double kt       = law_.friction > 0. ? law_.tangential_stiffness : 0.,
               ct       = law_.friction > 0. ? law_.tangential_damping : 0.;
  dealii::Tensor<1, 3> some;
  some[std::abs(z[0]) < 0.7 ? 0 : 1] = 1.;
  dealii::Tensor<1, 3> across        = some - (some * z) * z;
  across /= across.norm();
  const dealii::Tensor<1, 3> axes[3] = {z, across, dealii::cross_product_3d(z, across)};
  for (unsigned int d = 0; d < 3; ++d)
    {
      const double k = d == 0 || anywhere ? std::max(law_.stiffness, kt) : kt,
                   c = d == 0 || anywhere ? std::max(law_.damping, ct) : ct;
      if (k > 0. || c > 0.)
        springs.push_back({records_[i].master,
                           records_[i].slave,
                           axes[d],
                           point,
                           point,
                           world.symmetry.whole(k),
                           world.symmetry.whole(c)});
    }
}
} // namespace chaindrive::contact
