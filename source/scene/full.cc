// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/stiffness.h>
#include <chaindrive/element/elastic_part.h>
#include <chaindrive/mesh/surface/surface_nodes.h>
#include <chaindrive/scene/build.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace chaindrive::scene
{
using model::Effect;

namespace
{
/// Thickness of the elements below one side of a part, m.
double thickness(const Scene &scene, const Kind kind, const mesh::Surface side)
{
  const mesh::Part &part = *scene.parts.at(kind);
  return mesh::SurfaceNodes(part, mesh::Nodes(part), side).thickness;
}
/// Puts the local compliance of the rigid one of roller and bush in series with the penalty:
/// else it would be lost. A cylinder of radius R that approaches the wall of a hole wider by c by d
/// would overlap by d cos t - c (1 - cos t) at the angle t, up to cos a = c / (c + d). When two
/// foundations of the modulus K [N/m3] share that, the load per length is
///
///   q = K/2 R ((c + d) (a + sin(2 a)/2) - 2 c sin a),
///
/// from which K follows with the approach d under q of conforming contact, in which equal materials
/// deflect alike.
void add_foundation(const drive::Drive &drive, Scene &scene, ContactLaw &law)
{
  const drive::ChainDimensions  &chain  = drive.chain;
  const double                   radius = 0.5 * chain.bush_diameter, c = chain.roller_clearance();
  const double                   q       = drive.reference_load / chain.roller_length;
  const drive::ConformingContact contact = drive::conforming_contact(radius, c, q, scene.material);
  const double                   d = contact.approach, a = std::acos(c / (c + d));
  const double                   modulus =
      2. * q / (radius * ((c + d) * (a + 0.5 * std::sin(2. * a)) - 2. * c * std::sin(a)));
  law = in_series(law, modulus);
  scene.notes.push_back("One of roller and bush is rigid: a foundation of " + to_text(modulus, 4) +
                        " N/m3, its local compliance, is in series with the penalty of their "
                        "contact");
}

/// Joints without penalty stick by springs so much softer than their contact is across: as stiff as
/// that, they would shorten the step by a third and change losses by 0.3 %. How fast rollers turn
/// depends on theirs, little on those of pins, which twist fast (doc/theory.md).
constexpr double softer_sticking_of_rollers = 0.4, softer_sticking_of_pins = 0.2;

/// What joints without penalty, pins of a @p diameter that bear on a @p length, have in place of
/// its springs and dampers: forces up to a @p pressure [Pa], for which the step holds, and friction
/// that sticks by springs of the stiffness of the contact under the reference load, times
/// Contact/Tangential ratio, @p softer.
void hold_without_penalty(const model::Model &model,
                          const drive::Drive &drive,
                          const double        diameter,
                          const double        clearance,
                          const double        length,
                          const double        pressure,
                          const double        softer,
                          BoreFamily         &joints)
{
  joints.largest_force = pressure * diameter * length;
  joints.law.damping = joints.law.tangential_damping = 0.;
  if (joints.law.friction > 0.)
    joints.law.tangential_stiffness =
        softer * model.contact.tangential_ratio *
        drive::contact_modulus(
            0.5 * diameter, clearance, drive.reference_load / length, model.material);
}

/// Says by how much selective mass scaling increases the inertia of a roller about its axis.
void note_selective_masses(Scene &scene)
{
  const mesh::Part          &part = *scene.parts.at(Kind::roller);
  const mesh::Nodes          nodes(part);
  const element::ElasticPart elastic(part, nodes, scene.material, scene.elements);
  dealii::Vector<double>     rotation(3 * nodes.size());
  double                     inertia = 0.;
  for (unsigned int n = 0; n < nodes.size(); ++n)
    {
      const dealii::Point<3> &x = nodes.position[n];
      rotation[3 * n]           = -x[1];
      rotation[3 * n + 1]       = x[0];
      inertia += nodes.mass[n] * (x[0] * x[0] + x[1] * x[1]);
    }
  scene.notes.push_back(
      "Selective mass scaling increases the inertia of rollers about their axes by " +
      to_text(100. * elastic.masses().added(rotation) / inertia, 2) + " %");
}
} // namespace

void add_full_chain(const model::Model &model, const drive::Drive &drive, Scene &scene)
{
  add_chain_bodies(model, drive, model.elastic_joints, scene);
  const bool has_rollers = drive.chain.has_rollers;
  if (has_rollers)
    scene.parts[Kind::roller] = make_roller_part(model.meshes, drive);
  scene.parts[Kind::inner_link] = make_link_part(model.meshes, drive, true);
  scene.parts[Kind::outer_link] = make_link_part(model.meshes, drive, false);

  weigh_reduced_bodies(scene);
  if (model.effects.is_on(Effect::selective_mass_scaling))
    note_selective_masses(scene);

  // the softer of two surfaces decides how far they may overlap
  const auto law = [&](const Kind          master,
                       const mesh::Surface bore,
                       const Kind          slave,
                       const mesh::Surface cylinder,
                       const double        friction) {
    return make_area_law(
        model.contact,
        model.material,
        std::max(thickness(scene, master, bore), thickness(scene, slave, cylinder)),
        friction);
  };
  BoreFamily rollers = bores_of(Interface::roller_bush), pins = bores_of(Interface::bush_pin);
  rollers.elastic = true;
  if (has_rollers)
    rollers.law = law(Kind::roller,
                      mesh::roller_bore,
                      Kind::inner_link,
                      mesh::bush_outside_first,
                      model.contact.roller_bush_friction);
  if (has_rollers &&
      model.effects.is_on(Effect::elastic_rollers) != model.effects.is_on(Effect::elastic_links))
    add_foundation(drive, scene, rollers.law);
  pins.elastic                        = true;
  pins.law                            = law(Kind::inner_link,
                 mesh::bush_bore_first,
                 Kind::outer_link,
                 mesh::pin_outside_first,
                 model.contact.bush_pin_friction);
  const drive::ChainDimensions &chain = drive.chain;
  const bool                    exact = model.effects.is_on(Effect::exact_joints);
  const double                  pressure =
      exact ? drive::working_pressure(chain, drive.reference_load) : drive::breaking_pressure;
  rollers.half_angle = drive::largest_half_angle(
      0.5 * chain.bush_diameter, chain.roller_clearance(), pressure, scene.material);
  pins.half_angle = drive::largest_half_angle(
      0.5 * chain.pin_diameter, chain.pin_clearance(), pressure, scene.material);
  if (exact)
    {
      hold_without_penalty(model,
                           drive,
                           chain.bush_diameter,
                           chain.roller_clearance(),
                           chain.roller_length,
                           pressure,
                           softer_sticking_of_rollers,
                           rollers);
      hold_without_penalty(model,
                           drive,
                           chain.pin_diameter,
                           chain.pin_clearance(),
                           chain.bush_length,
                           pressure,
                           softer_sticking_of_pins,
                           pins);
    }
  else
    scene.notes.push_back(
        "Penalty per area (N/m3): " +
        (has_rollers ? "roller-bush " + to_text(rollers.law.stiffness, 4) + ", " : "") +
        "bush-pin " + to_text(pins.law.stiffness, 4));

  const auto is_elastic = [&scene](const unsigned int body) {
    return deforms(scene.bodies[body].motion);
  };
  for (unsigned int k = 0; k < scene.drive.n_joints; ++k)
    {
      const Joint joint     = joint_of(k, drive, scene.drive);
      const bool  at_first  = joint.bush_x < 0.; // of the inner link's two bushes
      const bool  pin_first = joint.pin_x < 0.;
      if (has_rollers && (is_elastic(joint.roller) || is_elastic(joint.inner)))
        rollers.pairs.push_back({joint.roller,
                                 dealii::Point<3>(),
                                 0.5 * chain.roller_bore,
                                 {joint.inner, dealii::Point<3>(), 0.5 * chain.bush_diameter, k},
                                 mesh::roller_bore,
                                 at_first ? mesh::bush_outside_first : mesh::bush_outside_second});
      if (is_elastic(joint.inner) || is_elastic(joint.outer))
        pins.pairs.push_back({joint.inner,
                              dealii::Point<3>(joint.bush_x, 0., 0.),
                              0.5 * chain.bush_bore,
                              {joint.outer, dealii::Point<3>(), 0.5 * chain.pin_diameter, k},
                              at_first ? mesh::bush_bore_first : mesh::bush_bore_second,
                              pin_first ? mesh::pin_outside_first : mesh::pin_outside_second});
    }
  for (BoreFamily *family : {&rollers, &pins})
    if (!family->pairs.empty())
      scene.bores.push_back(std::move(*family));
  if (model.effects.is_on(Effect::plate_faces))
    {
      FaceFamily plates;
      plates.interface = Interface::plate_faces;
      plates.name      = parameters::text_of(plates.interface);
      plates.radius    = 0.5 * std::min(chain.inner_plate_height, chain.outer_plate_height);
      plates.law =
          make_face_law(model,
                        drive,
                        ring_area(plates.radius, 0.5 * chain.bush_diameter),
                        std::max(thickness(scene, Kind::outer_link, mesh::plate_inner_faces),
                                 thickness(scene, Kind::inner_link, mesh::plate_outer_faces)));
      for (unsigned int k = 0; k < scene.drive.n_joints; ++k)
        {
          const Joint joint = joint_of(k, drive, scene.drive);
          if (is_elastic(joint.inner) && is_elastic(joint.outer))
            plates.pairs.push_back({joint.outer,
                                    joint.inner,
                                    mesh::plate_inner_faces,
                                    mesh::plate_outer_faces,
                                    dealii::Point<3>(joint.pin_x, 0., 0.),
                                    dealii::Point<3>(joint.bush_x, 0., 0.),
                                    k});
        }
      scene.faces.push_back(std::move(plates));
    }
  add_rigid_joints(model, drive, scene);
}
} // namespace chaindrive::scene
