// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/mesh/part.h>

#include <string>
#include <vector>

namespace chaindrive::mesh
{
/// A sprocket from the Gmsh file @p file (format 2.2 or 4.1, ASCII or binary, lengths in mm).
///
/// The file holds hexahedra and a physical surface `tooth flanks`, the whole profile with its tips,
/// and a physical surface `hub`, where the shaft holds the sprocket; a physical surface `sides` and
/// physical volumes `rim` (elastic zone) and `hub zone` (rigid zone) may be there. The axis is the
/// z axis, gap 0 is centred on +x; the mesh is moved along z so that its middle plane is z = 0.
/// Mass and inertia are those of the mesh.
///
/// Throws InputError for a file that is missing, is no Gmsh mesh, has cells other than hexahedra,
/// inverted cells or no surface of the required names, or whose teeth are elsewhere than those of
/// @p form: it says where the largest deviation is. A vertex of the flanks may lie up to five
/// percent of the pitch off the profile of @p form, so that real tooth shapes can be imported. The
/// area of the flanks in every gap must be that of the whole profile within a fifth. The mesh is
/// one body without coincident vertices; outer faces in no physical surface look along the axis.
///
/// For @p half see Part::half; the mesh must then be symmetric about its middle plane and have
/// vertices in it.
Part import_sprocket(const std::string      &file,
                     const drive::ToothForm &form,
                     double                  density,
                     bool                    half = false);

/// Width of the teeth of the imported @p sprocket: how far its flanks reach to both sides of z = 0,
/// of the whole sprocket where the part is a half. [m]
double flank_width(const Part &sprocket);
} // namespace chaindrive::mesh
