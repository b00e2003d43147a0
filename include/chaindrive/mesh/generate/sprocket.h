// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/mesh/generate/sweep.h>
#include <chaindrive/mesh/part.h>

namespace chaindrive::mesh
{
/// Sizes of a sprocket besides its teeth.
struct SprocketDimensions
{
  double bore;         ///< diameter, m
  double hub_diameter; ///< of the zone that is rigid in elastic models, m; inside the root circle
  double width;        ///< along the axis, m
};

/// The cross-section of a sprocket with one of its z equal sectors after the other; their points
/// and quadrilaterals correspond. Gap 0 is centred on +x. Vertices of the profile lie on its arcs,
/// some of them where two arcs meet.
///
/// A sector is symmetric about its gap. Each half has a block for the tooth, one below it and one
/// below the seat; the three meet in a point of the profile at angles of about 60 degrees. Rings
/// follow below the teeth, down to the hub circle and the bore. A @p picture has the same outline,
/// but one row of cells where there are several rings.
PlanarMesh sprocket_section(const drive::ToothForm   &form,
                            const SprocketDimensions &dimensions,
                            unsigned int              refinement,
                            bool                      picture = false);

/// A sprocket of hexahedra, exactly cyclic (see Part::n_sectors): origin on the axis in the middle
/// plane, gap 0 centred on +x. Throws InputError for sizes that do not fit. Refinement levels 0
/// to 4. For @p half see Part::half. A @p picture has one cell from face to face, and
/// few between its teeth and its bore.
Part make_sprocket(const drive::ToothForm   &form,
                   const SprocketDimensions &dimensions,
                   double                    density,
                   unsigned int              refinement,
                   bool                      half    = false,
                   bool                      picture = false);
} // namespace chaindrive::mesh
