// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/chain.h>
#include <chaindrive/drive/outline.h>
#include <chaindrive/parameters/drive.h>

#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace chaindrive::drive
{
/// The point of a sprocket's profile that is nearest to a given point, in the sprocket's frame.
struct Projection
{
  double               distance; ///< m, positive outside of the metal, negative inside
  dealii::Point<2>     point;    ///< on the profile
  dealii::Tensor<1, 2> normal;   ///< unit, out of the metal
  unsigned int tooth_gap; ///< the tooth gap, 0 ... teeth - 1, whose sector holds the given point
};

/// The exact profile of a sprocket: tooth gap 0 is centred on +x, gap k follows at the angle
/// 2 pi k / z, and half a gap with half a tooth is a short list of arcs and straight pieces.
/// Lengths in m.
struct ToothForm
{
  unsigned int teeth;
  double       pitch;          ///< nominal pitch of the chain
  double       pitch_diameter; ///< p / sin(pi / z); of a drum twice the radius on which joints run
  double       outside_diameter;
  double       root_diameter; ///< of the bottoms of the gaps
  double       roller_diameter;
  double       seat_radius;      ///< of the arc at the bottom of a gap
  double       seat_half_angle;  ///< rad, that arc ends so far from its middle on either side
  double       flank_radius;     ///< of the arc that follows the seat
  double       pointed_diameter; ///< where the flanks of a tooth would meet

  /// From the bottom of gap 0, on +x, to the middle of the tooth at the polar angle pi / z: seat,
  /// flank (ISO) or working arc, straight and topping arc (ANSI) as far as the outside diameter
  /// leaves them, tip arc. Of faceted() the chords.
  std::vector<Segment> half_profile;

  /// Where the outline has a corner: before segment i at the place i, after the last at the end.
  enum class Corner : unsigned char
  {
    none,
    convex, ///< only points outside are nearest to it
    concave ///< only points inside are nearest to it
  };
  std::vector<Corner> corners;

  std::vector<std::string> derived; ///< sentences on values that no entry gave

  /// A drum: the profile is a circle, #teeth are the equal sectors in which it is described, and
  /// of the members on gaps only the root diameter, its own, has a meaning.
  bool flat = false;

  /// Joints on a whole turn: teeth, or as many of the pitch as a drum has room for, no whole
  /// number.
  double seats() const;

  /// Angle between two gaps, rad.
  double pitch_angle() const;

  /// Length of the tip arc of a tooth, m.
  double tip_land() const;

  /// Angle between the span's direction and the normal of the tooth for a roller of a new chain
  /// that bears at the end of its seat: 90 deg - 180 deg / z - seat_half_angle. [rad]
  double seat_end_pressure_angle() const;

  /// Area within the profile, no bore cut out. [m2]
  double area() const;

  /// Polar second moment of that area about the sprocket's axis. [m4]
  double polar_moment() const;

  /// The profile point nearest to @p p. Exact for any point but the axis itself; the distance is
  /// continuous everywhere, the normal wherever the nearest point is unique. No allocation.
  Projection closest_point(const dealii::Point<2> &p) const;

  /// The form with @p n chords, an even number, in place of the arcs from the bottom of a gap to
  /// that of the next. Each arc and straight piece has at least one, and those of an arc are
  /// equally long: one after the other they go to where chords are longest, so that all become
  /// about equally long, as the edges of a mesh of one size are. Corners of convex arcs lie on the
  /// arcs. Those of concave arcs, the seats, stand back into the metal by r (1/cos(a/2) - 1), a the
  /// angle of a chord, so that its middle touches the arc: with corners on it the gaps would be too
  /// small for the rollers of a new chain. The faceted tooth is thus nowhere outside of the smooth
  /// one, and inside by no more than about h^2/8r, h the length of a chord.
  ToothForm faceted(unsigned int n) const;

  /// Turns gap k by what moves it by @p deviations[k] [m] along the pitch circle,
  /// counter-clockwise. Sectors stay: the middle of each tooth is where it was, on the arc of its
  /// tip.
  void shift_gaps(const std::vector<double> &deviations);

  /// Points of the half profile, from the bottom of gap 0 to the middle of the tooth, with
  /// @p per_segment equal intervals in every segment.
  std::vector<dealii::Point<2>> half_polyline(unsigned int per_segment) const;

  /// Points of the whole profile, counter-clockwise from the bottom of gap 0; the last point joins
  /// the first.
  std::vector<dealii::Point<2>> polyline(unsigned int per_segment) const;

  /// Rotations by k pitch angles as (cos, sin), filled by make_tooth_form().
  std::vector<dealii::Tensor<1, 2>> rotations;

  /// Those of the gaps that shift_gaps() has turned; empty where these are #rotations.
  std::vector<dealii::Tensor<1, 2>> shifted;
};

/// The profile of a sprocket with @p teeth teeth for @p chain, whose diameters are those of
/// sprocket number @p number of @p sprockets.
///
/// ISO 606 forms min, mid and max: seat radius 0.505 d1 ... 0.505 d1 + 0.069 d1^(1/3) (d1 in mm),
/// seating angle 140 deg - 90 deg/z ... 120 deg - 90 deg/z, flank radius 0.12 d1 (z + 2) ...
/// 0.008 d1 (z^2 + 180); mid takes the means of the three. The seat's centre lies
///   iso              where the bottom of the gap is on the root circle, diameter d - d1
///   pitch            on the pitch circle
///   bottom diameter  where the bottom of the gap is on the given diameter
/// ANSI/ASME B29.1: seat, working arc, straight and topping arc; its seat is centred on the pitch
/// circle unless a bottom diameter is given.
///
/// Outside diameter, if not given: ANSI p (0.6 + cot(pi/z)); ISO the mean of the least and the
/// greatest that the standard allows, but small enough to leave a tip land of 0.05 p.
///
/// @throws InputError for less than 9 teeth, a tooth without tip land, an outside diameter that
/// leaves no flank or a missing bottom diameter.
ToothForm make_tooth_form(unsigned int                 teeth,
                          const ChainDimensions       &chain,
                          const parameters::Sprockets &sprockets,
                          unsigned int                 number);

/// Radius on which the joints of @p chain run round the drum @p flat, whose diameter is given, m:
/// its own and that of the rollers, or half the height of the inner plates, which lie on it.
double joint_radius(const parameters::Flat &flat, const ChainDimensions &chain);

/// The drum of sprocket number @p number of @p sprockets for @p chain.
/// @throws InputError for one with a load, on which less than six joints have room in a turn, or
/// with entries on teeth.
ToothForm make_drum(const ChainDimensions       &chain,
                    const parameters::Sprockets &sprockets,
                    unsigned int                 number);
} // namespace chaindrive::drive
