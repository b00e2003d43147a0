// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/tooth_form.h>
#include <chaindrive/material/material.h>
#include <chaindrive/mesh/generate/sprocket.h>

#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

namespace chaindrive::reduction
{
/// Natural modes of unit mass of the toothed rim of a sprocket that is held at its hub, in its
/// plane, and what they move points of its profile by. All teeth being alike, a mode has so many
/// waves k round the z teeth: points about gap j move, in the frame of that gap, by
///
///   u_j = c cos(2 pi k j / z) - s sin(2 pi k j / z).
struct RimModes
{
  unsigned int        teeth = 0;
  std::vector<double> along;        ///< of points of the profile from the bottom of the gap, to the
                                    ///< middle of the teeth on either side, ascending, m
  std::vector<double>       omega;  ///< of each mode, rad/s
  std::vector<unsigned int> waves;  ///< k of each
  std::vector<double>       cosine; ///< c: [mode][point][x and y in the frame of the gap],
                                    ///< 1/sqrt(kg)
  std::vector<double> sine;         ///< s, likewise

  unsigned int n_modes() const { return static_cast<unsigned int>(omega.size()); }
  unsigned int n_points() const { return static_cast<unsigned int>(along.size()); }
  double       highest_frequency() const; ///< rad/s; of no modes 0

  /// Where on the profile something is: after a point, by a part of the way to the next one.
  struct Place
  {
    unsigned int first = 0;
    double       part  = 0.;
  };
  Place place_at(double at) const; ///< m along the profile; the nearest one beyond the ends

  /// What forces [point][x, y] on one gap displace these points by along themselves, J per N2 of
  /// their unit, twice the energy of the modes.
  double compliance(const std::vector<double> &forces) const;
};

/// The modes up to @p modes_up_to [rad/s] of a rim without its rigid zone, by bilinear
/// quadrilaterals with incompatible modes (Taylor, Beresford and Wilson 1976) in plane stress and
/// lumped masses on the mesh that mesh::sprocket_section() makes with this @p refinement; one
/// sector of it for each number of waves. Throws InputError for sizes that cannot be meshed.
RimModes make_rim_modes(const drive::ToothForm         &form,
                        const mesh::SprocketDimensions &dimensions,
                        const Material                 &material,
                        double                          modes_up_to,
                        unsigned int                    refinement = 1);
} // namespace chaindrive::reduction
