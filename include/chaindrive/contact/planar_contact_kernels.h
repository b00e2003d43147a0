// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Plain structures and plain pointers only: the kernels are compiled for several instruction sets
// (see utilities/pack.h).

#include <chaindrive/bodies/planar_kernels.h>
#include <chaindrive/drive/stiffness_curve.h>
#include <chaindrive/scene/contact_law.h>
#include <chaindrive/utilities/pack.h>

namespace chaindrive::contact
{
/// What is known of a contact in the plane, [PlanarTouchEntry][place]: TouchStateOf with one
/// tangent and what Record has of its last evaluation. Rows that Rows finds for nothing, but for
/// the one with the number 3, which few contacts have.
enum PlanarTouchEntry : unsigned int
{
  planar_touch_room = 0, ///< what its gap begins with: of a cylinder in a bore the clearance,
                         ///< of a roller on teeth its radius, m; of a place without a pair
                         ///< so that it never touches
  planar_touch_penetration = 1, ///< m
  planar_touch_normal      = 2, ///< force along the normal, N
  planar_touch_aside      = 3, ///< force along the tangent besides friction, of ovals and curves, N
  planar_touch_slip       = 4, ///< m
  planar_touch_tangential = 5, ///< N
  planar_touch_gap        = 6, ///< m
  planar_touch_direction  = 7, ///< of the normal of the last touch, x and y, unit
  planar_touch_approach   = 9, ///< along that normal, m/s
  n_planar_touch_entries  = 10
};

/// Energies that an evaluation adds to, J.
struct PlanarEnergies
{
  double stored, damping_loss, friction_loss;
};

/// What all contacts of a family have in common.
struct PlanarContacts
{
  double           *touch; ///< [PlanarTouchEntry][place], aligned to 64 bytes
  unsigned int      n_places;
  scene::ContactLaw law;  ///< of all points of a pair together
  double            dt;   ///< since the last evaluation, s
  double            oval; ///< how much of the oval of a roller (drive::RollerRing) the touched side
                          ///< of it has: 1 outside, RollerRing::bore in the bore; 0: none
  const drive::StiffnessCurve *curve; ///< of all points of a pair together; null: the law's spring
};

/// A run of cylinders in bores: the pair at place first_place + i is the bore of the body in slot
/// master + i and the cylinder of that in slot slave + i.
struct PlanarRun
{
  unsigned int first_place, master, slave;
  unsigned int n;                             ///< a multiple of n_lanes
  double       master_axis[2], slave_axis[2]; ///< in the bodies' frames, m
  double       radius;                        ///< of the cylinders, m
};

/// A piece of the profile of a sprocket: drive::Segment in numbers, with what is needed of its
/// ends.
struct PlanarSegment
{
  int    kind; ///< 0: straight, 1: convex, -1: concave arc
  double begin[2], end[2], centre[2], radius, middle[2], half_cosine; ///< as drive::Segment
  double end_normal[2][2]; ///< out of the metal at its begin and end
  int    corner[2];        ///< at its begin and end; 0: none, 1: convex, -1: concave
};

/// Of a roller near teeth the gap that it is in and the piece of the profile that is nearest,
/// [place / n_lanes][KnownNearest][place % n_lanes]: as long as the roller stays near the place
/// where that was found, no other piece need be looked at. An end of a segment is an arc without a
/// radius.
enum KnownNearest : unsigned int
{
  known_at      = 0,  ///< that place, folded into the half sector of the profile, x and y, m
  known_room    = 2,  ///< square of how far the roller may go from there, m2; negative: nowhere
  known_centre  = 3,  ///< of the arc, x and y, or a point of the line, m
  known_radius  = 5,  ///< m
  known_sign    = 6,  ///< 1: convex, -1: concave arc, 0: line
  known_normal  = 7,  ///< out of the metal, x and y, where it does not turn with the roller, else 0
  known_turn    = 9,  ///< cosine and sine of the angle of the gap's sector
  known_shifted = 11, ///< the same of the gap itself, if it is another
  n_known_nearest = 13
};

/// Rollers near the teeth of a sprocket.
struct PlanarTeeth
{
  const PlanarSegment *segments; ///< of half a gap with half a tooth, see drive::ToothForm
  unsigned int         n_segments;
  unsigned int         n_teeth;
  const double        *turns;   ///< cosine and sine of the angle of each gap's sector
  const double        *shifted; ///< the same of the gaps themselves, if others, or null
  unsigned int         n;       ///< places, a multiple of n_lanes
  const unsigned int  *slot;    ///< [place / n_lanes], of the roller at the first of these places;
                                ///< the others are in the slots that follow
  unsigned int *gap;            ///< [place], the gap that the roller is in, kept fresh
  double       *known;          ///< see KnownNearest, kept fresh, aligned to 64 bytes; of a place
                                ///< without a contact all is 0 but for room without an end
  double radius;                ///< of the rollers, m

  double position[2], velocity[2], rotation[2], spin; ///< of the sprocket; rotation: cosine, sine
  double force[2], moment;                            ///< on it, are set; N, N m
};

/// What is known of the roller at @p place.
CHAINDRIVE_ALWAYS_INLINE double *known_of(const PlanarTeeth &teeth, const unsigned int place)
{
  const unsigned int lane = place % n_lanes;
  return teeth.known + (place - lane) * n_known_nearest + lane;
}

/// The roller at @p place is in the gap @p gap now.
CHAINDRIVE_ALWAYS_INLINE void
enter_gap(const PlanarTeeth &teeth, const unsigned int place, const unsigned int gap)
{
  teeth.gap[place]     = gap;
  double       *known  = known_of(teeth, place);
  const double *actual = teeth.shifted != nullptr ? teeth.shifted : teeth.turns;
  for (unsigned int d = 0; d < 2; ++d)
    {
      known[(known_turn + d) * n_lanes]    = teeth.turns[2 * gap + d];
      known[(known_shifted + d) * n_lanes] = actual[2 * gap + d];
    }
}

/// The kernels of one instruction set.
struct PlanarContactKernels
{
  int width; ///< numbers that the machine computes at a time
  /// Of so many runs.
  void (*press_bores)(
      PlanarSlots, const PlanarContacts &, const PlanarRun *, unsigned int, PlanarEnergies &);
  void (*press_teeth)(PlanarSlots, const PlanarContacts &, PlanarTeeth &, PlanarEnergies &);
};

/// Kernels of @p width 1, 2, 4 or 8 numbers; null where this machine has none, as with
/// element::kernels().
const PlanarContactKernels *planar_contact_kernels(int width);
} // namespace chaindrive::contact
