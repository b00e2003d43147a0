// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/strands.h>
#include <chaindrive/scene/addition.h>
#include <chaindrive/scene/build.h>
#include <chaindrive/scene/fidelity.h>
#include <chaindrive/scene/placement.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace chaindrive::scene
{
using model::Effect;

namespace
{
Tensor3 embed(const dealii::Tensor<1, 2> &v)
{
  Tensor3 result;
  result[0] = v[0];
  result[1] = v[1];
  return result;
}

/// The drive without its bodies. A straight line touches two pitch circles of the radii r1 and r2,
/// below zero where the chain runs round them against the sense of the drive, at the distance d
/// where the line of their centres, measured from the first one, has gone (r1 - r2) r1 / d and
/// d + (r1 - r2) r2 / d.
void describe(const drive::Drive &drive, DriveView &view)
{
  const drive::Layout &layout = drive.layout;
  view.strands                = drive.strands;
  view.n_joints               = static_cast<unsigned int>(layout.joints.size());
  view.sense                  = layout.sense;
  view.pitch                  = drive.chain.loaded_pitch();
  view.stiffness_per_pitch    = drive.stiffness_per_pitch;
  for (const drive::Layout::Joint &joint : layout.joints)
    view.seated.push_back(joint.tooth_gap >= 0);
  const auto n      = static_cast<unsigned int>(drive.sprockets.size());
  const auto radius = [&](const unsigned int i) {
    const drive::ToothForm &form = drive.sprockets[i].form;
    return form.flat ? 0.5 * form.pitch_diameter : view.pitch_radius_of(form.teeth);
  };
  for (unsigned int i = 0; i < n; ++i)
    {
      const unsigned int         j    = (i + 1) % n;
      const drive::Layout::Span &span = layout.spans[i];
      const dealii::Tensor<1, 2> line = layout.sprockets[j].axis() - layout.sprockets[i].axis();
      const double               d    = line.norm();
      const double               r1   = layout.sprockets[i].turn * radius(i),
                   r2                 = layout.sprockets[j].turn * radius(j);
      const double sine               = (r1 - r2) / d;
      view.spans.push_back({drive.sprockets[i].name + "_to_" + drive.sprockets[j].name,
                            i,
                            j,
                            embed(line / d),
                            d,
                            r1 * sine,
                            d + r2 * sine,
                            embed(span.direction),
                            embed(span.normal)});
    }
}
} // namespace

ContactLaw
make_law(const model::Contact &contact, const double k, const double mass, const double friction)
{
  ContactLaw law;
  law.stiffness = k;
  law.damping   = 2. * contact.damping_ratio * std::sqrt(k * mass);
  law.friction  = friction;
  if (law.friction > 0.)
    {
      law.tangential_stiffness = contact.tangential_ratio * k;
      law.tangential_damping   = contact.tangential_ratio * law.damping;
    }
  return law;
}

ContactLaw make_area_law(const model::Contact &contact,
                         const Material       &steel,
                         const double          thickness,
                         const double          friction)
{
  // what moves with a surface at the frequency of its penalty is half an element
  return make_law(contact,
                  contact.penalty_factor * steel.bulk_modulus() / thickness,
                  0.5 * steel.density * thickness,
                  friction);
}

ContactLaw in_series(const ContactLaw &law, const double modulus)
{
  const double softer = modulus / (modulus + law.stiffness);
  return {law.stiffness * softer,
          law.damping * std::sqrt(softer),
          law.friction,
          law.tangential_stiffness * softer,
          law.tangential_damping * std::sqrt(softer)};
}

Scene build_scene(const model::Model             &model,
                  const drive::Drive             &drive,
                  const std::vector<std::string> &folders,
                  const BasisOf                  &basis_of)
{
  Scene scene;
  scene.start_time = model.time.start;
  scene.material   = model.material;
  scene.elements   = model.elements;
  scene.effects    = model.effects;
  scene.loads      = model.loads;
  scene.half       = model.effects.is_on(Effect::symmetry_model);
  scene.planar     = model.effects.is_on(Effect::planar_motion);
  if (model.effects.is_on(Effect::oval_rollers))
    scene.oval = drive::roller_ring(drive.chain, model.material);
  scene.plates_bend = model.effects.is_on(Effect::plate_bending);
  scene.at_speed    = !model.effects.is_on(Effect::start_up);
  if (drive.strands > 1 && !model.effects.is_on(Effect::separate_strands))
    scene.notes.push_back(drive::in_words_of_strands(drive.strands));
  scene.notes.insert(scene.notes.end(), drive.notes.begin(), drive.notes.end());
  scene.notes.insert(scene.notes.end(), model.notes.begin(), model.notes.end());
  scene.prestress = drive.layout.prestress;
  describe(drive, scene.drive);

  Fidelity::builder_of(model.fidelity)(model, drive, scene);
  add_sprockets(model, drive, folders, scene);
  add_tensioner(drive, scene);
  add_swings(drive, scene);
  add_shafts(drive, scene);
  add_guides(model, drive, scene);
  if (model.effects.is_on(Effect::oil_film))
    add_oil_films(model, drive, scene);
  if (model.effects.is_on(Effect::misalignment))
    add_sides(model, drive, scene);
  if (model.effects.is_on(Effect::separate_strands))
    separate_strands(drive, scene);
  if (model.effects.is_on(Effect::misalignment))
    move_out_of_line(drive, scene);
  add_additions(model.sections, scene);
  if (model.effects.is_on(Effect::reduced_bodies) && basis_of)
    add_bases(basis_of, scene);
  return scene;
}
} // namespace chaindrive::scene
