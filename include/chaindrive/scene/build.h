// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/drive.h>
#include <chaindrive/scene/scene.h>

namespace chaindrive::scene
{
/// The scene of the fidelity that @p parameters ask for. A fidelity is nothing but a choice of
/// bodies, motions and interfaces; what comes after knows only those. Imported meshes are looked
/// for in @p folders. Throws InputError for masses or meshes that cannot be.
Scene build_scene(const Parameters               &parameters,
                  const drive::Drive             &drive,
                  const std::vector<std::string> &folders);

/// The simple model: one lumped roller of the mass of a pitch per joint, elastic bars between them.
void add_simple_chain(const Parameters &parameters, const drive::Drive &drive, Scene &scene);

/// The layered model: rigid rollers, inner and outer links with clearances between them. Plates and
/// joint contact act in series in the bush-pin interface.
void add_layered_chain(const Parameters &parameters, const drive::Drive &drive, Scene &scene);

/// Both sprockets and the interfaces of the rollers, which must be there, with their teeth.
void add_sprockets(const Parameters               &parameters,
                   const drive::Drive             &drive,
                   const std::vector<std::string> &folders,
                   Scene                          &scene);

/// Meshes of parts at the refinement of section Mesh.
std::shared_ptr<const mesh::Part> make_roller_part(const Parameters &, const drive::Drive &);
std::shared_ptr<const mesh::Part>
make_link_part(const Parameters &, const drive::Drive &, bool inner);
std::shared_ptr<const mesh::Part>
make_sprocket_part(const Parameters &, const drive::Drive &, bool driver);

/// A penalty law for an interface of stiffness @p k [N/m] between bodies whose reduced mass is
/// @p mass [kg]: damping and tangential terms from section Contact, zero where effects are off.
Law make_law(const Parameters          &parameters,
             const std::vector<Effect> &effects,
             double                     k,
             double                     mass,
             std::optional<double>      friction);
} // namespace chaindrive::scene
