// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// An elastic roller at gap 0 of a sprocket whose hub is held, and checks of their contact that hold
// for every mesh of the sprocket.

#include "scenes.h"

#include <chaindrive/bodies/make_world.h>
#include <chaindrive/contact/elastic_flanks.h>
#include <chaindrive/contact/node_contact.h>
#include <chaindrive/mesh/generate/links.h>
#include <chaindrive/mesh/generate/sprocket.h>
#include <chaindrive/mesh/import/import.h>
#include <chaindrive/mesh/sector.h>

#include <map>

namespace test
{
enum class Sprocket
{
  generated, ///< contact with its exact arcs
  imported   ///< meshes/sprocket-15.msh, contact with its facets
};

struct Tooth
{
  Sprocket     sprocket   = Sprocket::generated;
  bool         elastic    = true; ///< sprocket
  unsigned int refinement = 1;    ///< of a generated sprocket
  double       softness   = 1.;   ///< of the contact springs
  double       friction   = 0.;
  double       stiffness  = 0.; ///< with which rigid teeth deflect, N/m; 0: they do not
  double       turned     = 0.; ///< sprocket, rad
  Vector3      moved;           ///< roller, from 5 um above the bottom of gap 0, m
  Vector3      velocity = vector(-1.3, 0.);
  double       spin     = 0.;
};

inline drive::ToothForm tooth_form(const drive::ChainDimensions &chain, const double scale = 1.)
{
  parameters::Sprockets sprockets;
  sprockets.driver().outside_diameter = scale * 81.8e-3;
  return drive::make_tooth_form(15, chain, sprockets, 0);
}

/// Mesh of the sprocket, its sector and the facets of an imported one; each made once.
struct SprocketMesh
{
  std::shared_ptr<const mesh::Part>         whole;
  std::shared_ptr<const mesh::Sector>       sector;
  std::shared_ptr<const mesh::FacetSurface> facets;
};

inline const SprocketMesh &
sprocket_mesh(const Tooth &c, const drive::ToothForm &form, const double density)
{
  static std::map<std::pair<Sprocket, unsigned int>, SprocketMesh> made;
  SprocketMesh &it = made[{c.sprocket, c.refinement}];
  if (it.whole)
    return it;
  const bool imported = c.sprocket == Sprocket::imported;
  it.whole            = std::make_shared<const mesh::Part>(
      imported ? mesh::import_sprocket(SOURCE_DIR "/../../meshes/sprocket-15.msh", form, density) :
                            mesh::make_sprocket(form, {25e-3, 33e-3, 7.2e-3}, density, c.refinement));
  it.sector = std::make_shared<const mesh::Sector>(*it.whole);
  if (imported)
    it.facets = std::make_shared<const mesh::FacetSurface>(*it.sector->part, mesh::tooth_flanks);
  return it;
}

inline scene::Scene make_scene(const Tooth &c)
{
  scene::Scene scene = empty_scene();
  const auto   chain = drive::make_chain(parameters::Chain());
  const auto   form  = std::make_shared<const drive::ToothForm>(tooth_form(chain));
  const auto   part  = std::make_shared<const mesh::Part>(
      mesh::make_roller(chain, scene.material.density, mesh::RollerGrid(1, 32, 4)));
  scene.parts[scene::Kind::roller] = part;

  const double start = 0.5 * form->root_diameter + 0.5 * chain.roller_diameter + 5e-6;
  scene.bodies       = {body(scene::Motion::elastic,
                       scene::Mount::free(),
                       part->meshed.mass,
                       vector(1., 1., 1.),
                       vector(start, 0.) + c.moved,
                       c.velocity),
                        ground()};
  scene.bodies[0].initial.angular_velocity = vector(0., 0., c.spin);
  scene.bodies[1].initial.rotation         = to_matrix(rotation_about_z(c.turned));
  const auto &[whole, sector, facets]      = sprocket_mesh(c, *form, scene.material.density);
  if (c.elastic)
    {
      scene.parts[scene::Kind::sprocket]   = whole;
      scene.sectors[scene::Kind::sprocket] = sector;
      scene.bodies[1].kind                 = scene::Kind::sprocket;
      scene.bodies[1].motion               = scene::Motion::elastic;
    }
  const double      wall = 0.5 * (chain.roller_diameter - chain.roller_bore);
  scene::ContactLaw law;
  law.stiffness = 0.5 * c.softness * scene.material.youngs_modulus / wall;
  if (c.friction > 0.)
    {
      law.friction             = c.friction;
      law.tangential_stiffness = 0.8 * law.stiffness;
    }
  scene::ToothFamily family;
  family.name            = "roller-driver";
  family.sprocket        = 1;
  family.form            = form;
  family.facets          = facets;
  family.teeth           = form->teeth;
  family.outer_radius    = 0.5 * form->outside_diameter;
  family.half_width      = 3.6e-3;
  family.law             = law;
  family.slaves          = {{0, dealii::Point<3>(), 0.5 * chain.roller_diameter, 0}};
  family.elastic         = true;
  family.slave_surface   = mesh::roller_outside;
  family.tooth_stiffness = c.stiffness;
  scene.teeth            = {family};
  return scene;
}

/// Force [N] on the roller where it stands after @p deform has moved the nodes of the rim, and the
/// energy [J] of the contact.
template <typename Deform>
inline std::pair<Vector3, double> force_and_energy(Tooth c, const Deform &deform)
{
  c.velocity                 = Vector3();
  const scene::Scene   scene = make_scene(c);
  World                world = make_world(scene);
  contact::NodeContact family(contact::on_flanks(scene.teeth[0], world), world, true);
  deform(world);
  family.search(world, 1e-3);
  family.add_forces(world, 0.);
  return {family.records()[0].force, world.ledger.contact};
}

template <typename Deform>
inline Vector3 force(const Tooth &c, const Deform &deform)
{
  return force_and_energy(c, deform).first;
}

inline Vector3 force(const Tooth &c)
{
  return force(c, [](World &) {});
}

/// Adds @p u (position relative to the hub) to the positions of all nodes of the rim.
template <typename Field>
inline void displace(World &world, const Field &u)
{
  BodyBatches &copies = world.copies[world.rims[0].group];
  for (unsigned int s = 0; s < copies.n_copies(); ++s)
    for (unsigned int n = 0; n < copies.n_nodes(); ++n)
      {
        Vector3 x;
        for (unsigned int d = 0; d < 3; ++d)
          x[d] = NodeView(copies.position).component(copies.index(s, n), d);
        const Vector3 add = u(x - world.frames[1].position);
        for (unsigned int d = 0; d < 3; ++d)
          NodeView(copies.position).component(copies.index(s, n), d) += add[d];
      }
}

inline double error(const Vector3 &a, const Vector3 &b) { return (a - b).norm() / b.norm(); }

/// Undeformed teeth give the forces of a rigid sprocket, displaced and turned ones those of a rigid
/// one displaced and turned with them; on strained ones the force is the derivative of the
/// contact's energy.
inline void check_geometry(const Sprocket sprocket)
{
  Tooth flank; // in the seat, off its middle
  flank.sprocket = sprocket;
  flank.moved    = vector(-8e-6, 4e-6);
  Tooth rigid    = flank;

  rigid.elastic = false;
  verdict("undeformed teeth: force of a rigid sprocket to 1e-9",
          error(force(flank), force(rigid)) < 1e-9);

  const Vector3 u       = vector(2e-6, -1e-6, 0.);
  Tooth         shifted = rigid;
  shifted.moved -= u;
  verdict("displaced by 2 um: that of a rigid one there to 1e-9",
          error(force(flank, [&](World &w) { displace(w, [&](const Vector3 &) { return u; }); }),
                force(shifted)) < 1e-9);

  // u = R(a) x - x about the axis: the tangents turn as well
  const double angle  = 1e-4;
  Tooth        turned = rigid;
  turned.turned       = angle;
  const auto    turn  = to_matrix(rotation_about_z(angle));
  const Vector3 bent =
      force(flank, [&](World &w) { displace(w, [&](const Vector3 &x) { return turn * x - x; }); });
  verdict("turned by 1e-4: that of a rigid one turned to 1 %", error(bent, force(turned)) < 1e-2);
  std::cout << "  which differs from that of one not turned by " << std::fixed
            << std::setprecision(0) << 100. * error(force(rigid), force(turned)) << " %\n"
            << std::defaultfloat;

  // strains and turns of 2e-3 about the bottom of the seat
  const double seat   = 33.1e-3; // m
  const auto   strain = [&](World &w) {
    displace(w, [&](const Vector3 &x) {
      return 2e-3 * vector(x[1] + 0.5 * x[2], x[0] - seat - x[2], x[1]);
    });
  };
  const Vector3 f = force(flank, strain);
  Vector3       difference;
  for (unsigned int d = 0; d < 3; ++d)
    {
      Tooth before = flank, after = flank;
      before.moved[d] -= 1e-9;
      after.moved[d] += 1e-9;
      difference[d] =
          (force_and_energy(before, strain).second - force_and_energy(after, strain).second) / 2e-9;
    }
  verdict("strained: the force is the energy's derivative to 1e-4", error(difference, f) < 1e-4);
}

/// Forces of a spinning roller with friction cancel in sum and moment while it is pressed in.
inline void check_balance(const Sprocket sprocket)
{
  Tooth c;
  c.sprocket = sprocket;
  c.moved    = vector(0., 3e-6);
  c.friction = 0.2;
  c.spin     = 500.;
  dynamics::System system(make_scene(c), true);
  const double     dt    = 0.5 * system.critical_time_step();
  World           &world = system.world;
  double           worst = 0., moment = 0., largest = 0.;
  advance(system, 300, dt, [&]() {
    // forces of the contact alone; the hub's couple without the reaction of the rim
    world.clear_forces();
    Ledger kept = world.ledger;
    system.contacts.add_forces(world, 0.);
    world.ledger = kept;
    Vector3 f, m;
    double  size = 0.;
    m[2] += world.moment.local_element(3 * 1 + 2);
    m[1] += world.moment.local_element(3 * 1 + 1);
    m[0] += world.moment.local_element(3 * 1);
    for (unsigned int g = 0; g < 2; ++g)
      {
        BodyBatches &copies = world.copies[g];
        for (unsigned int k = 0; k < copies.n_copies(); ++k)
          for (unsigned int n = 0; n < copies.n_nodes(); ++n)
            {
              Vector3 at, x;
              for (unsigned int d = 0; d < 3; ++d)
                {
                  at[d] = NodeView(copies.force).component(copies.index(k, n), d);
                  x[d]  = NodeView(copies.position).component(copies.index(k, n), d);
                }
              f += at;
              m += cross_product_3d(x, at);
              size += at.norm();
            }
      }
    largest = std::max(largest, size);
    worst   = std::max(worst, f.norm());
    moment  = std::max(moment, m.norm());
  });
  verdict("forces cancel in sum to 1e-12", largest > 100. && worst < 1e-12 * largest);
  verdict("and in moment", moment < 1e-12 * 0.04 * largest);
}
/// What happens in 150 us.
struct Outcome
{
  double peak = 0., worst = 0., impulse = 0., strain = 0., speed = 0.;
};

inline Outcome press(const Tooth &c)
{
  dynamics::System system(make_scene(c), false);
  const double     dt = 5e-8;
  Outcome          outcome;
  advance(system, 3000, dt, [&]() {
    const Vector3 &f = system.contacts.families()[0]->records()[0].force;
    outcome.impulse += dt * f[0];
    outcome.peak   = std::max(outcome.peak, f.norm());
    outcome.worst  = std::max(outcome.worst, std::abs(system.world.ledger.imbalance()));
    outcome.strain = std::max(outcome.strain, system.world.ledger.strain);
  });
  outcome.worst /= system.world.ledger.initial;
  outcome.speed = system.world.frames[0].velocity[0] / 1.3;
  return outcome;
}
} // namespace test
