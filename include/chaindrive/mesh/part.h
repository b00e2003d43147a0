// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/chain.h>
#include <chaindrive/drive/solids.h>
#include <chaindrive/drive/tooth_form.h>
#include <chaindrive/utilities/mirror_symmetry.h>

#include <deal.II/grid/tria.h>

#include <array>
#include <memory>
#include <string>

namespace chaindrive::mesh
{
/// Named sides of meshes: the boundary ids of its triangulation. `first` and `second` are
/// the joints at negative and positive x of a link.
enum Surface : dealii::types::boundary_id
{
  other_surface = 0, ///< everything without a name: the ends of bushes and pins
  roller_outside,
  roller_bore,
  roller_ends,
  bush_outside_first,
  bush_outside_second,
  bush_bore_first,
  bush_bore_second,
  pin_outside_first,
  pin_outside_second,
  pin_bore,
  plate_inner_faces, ///< those that look to the chain's middle plane
  plate_outer_faces,
  plate_edges,
  tooth_flanks, ///< the whole profile: seats, flanks and tips
  sprocket_sides,
  hub,          ///< where the shaft holds a sprocket: its bore
  middle_plane, ///< z = 0, where a half part ends
  n_surfaces
};

/// Components of parts: the material ids of the triangulation.
enum Component : dealii::types::material_id
{
  roller = 0,
  inner_plate,
  bush,
  outer_plate,
  pin,
  rim,      ///< elastic zone of a sprocket
  hub_zone, ///< rigid zone of a sprocket
  n_components
};

/// The name for people, in files too: "tooth flanks".
const std::string &surface_name(unsigned int boundary_id);
const std::string &component_name(unsigned int material_id);

/// A mesh of one kind of body with its mass, made once, however many bodies share it.
///
/// Curved sides have their vertices on the exact surface, so that a mesh has not quite the volume
/// of the solid. A density factor per component makes up for it; radii are never changed.
struct Part
{
  std::string                               name;
  std::unique_ptr<dealii::Triangulation<3>> mesh; ///< hexahedra in the body frame, m

  double                           density        = 0.; ///< of the material, kg/m3
  std::array<double, n_components> density_factor = filled(1.);

  /// Only the half at z >= 0 is meshed; the body is this half and its mirror image.
  bool half = false;

  MirrorSymmetry symmetry() const { return MirrorSymmetry(half); }

  drive::MassProperties exact;  ///< of the solid
  drive::MassProperties meshed; ///< of the body as meshed, with its density factors

  /// The mesh is made of that many equal sectors about the z axis, numbered counter-clockwise: cell
  /// c of sector s has the index s * n_cells / n_sectors + c and is cell c of sector 0 turned by
  /// 2 pi s / n_sectors, with the same local numbering of its vertices.
  unsigned int n_sectors = 1;

  /// Density [kg/m3] of a component in the mesh.
  double density_of(const dealii::types::material_id component) const
  {
    return density * density_factor[component];
  }

  static constexpr std::array<double, n_components> filled(const double value)
  {
    std::array<double, n_components> a{};
    for (double &x : a)
      x = value;
    return a;
  }
};
} // namespace chaindrive::mesh
