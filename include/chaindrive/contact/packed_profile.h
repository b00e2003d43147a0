// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Where `width` points are nearest to the profile of a sprocket: drive::ToothForm::closest_point(),
// for the kernels of planar_contact_kernels.h.

#include <chaindrive/contact/planar_contact_kernels.h>

namespace chaindrive::contact::packed
{
/// The numbers of an array at the places stride * @p slots + @p first.
template <int width, unsigned int stride = 1>
CHAINDRIVE_ALWAYS_INLINE Pack<double, width>
gather_slots(const double *from, const unsigned int *slots, const unsigned int first = 0)
{
  const double *at[width];
  for (int i = 0; i < width; ++i)
    at[i] = from + stride * slots[i];
  return gather<double, width>(at, first);
}

/// Nearest points of a profile, for a pack of points.
template <int width>
struct NearestOnProfile
{
  using P = Pack<double, width>;

  P distance;                   ///< not signed, m
  P signed_distance, normal[2]; ///< where it is between the ends of a segment
  P which; ///< 0: between the ends of a segment; 2 i + 1 or 2 i + 2: the begin or end of segment i
  P turn;  ///< how the normal turns along the tangent, 1/m
};

template <int width>
CHAINDRIVE_ALWAYS_INLINE NearestOnProfile<width>
nearest_on_profile(const PlanarTeeth &teeth, const Pack<double, width> (&p)[2])
{
  using P = Pack<double, width>;
  NearestOnProfile<width> best;
  const P                 zero(0.);
  best.distance        = P(1e300);
  best.signed_distance = best.normal[0] = best.normal[1] = best.which = zero;
  P curved(0.);           // 1: an arc
  P length(1.), sign(1.); // what normals are still to be divided by and multiplied with
  for (unsigned int i = 0; i < teeth.n_segments; ++i)
    {
      const PlanarSegment &s             = teeth.segments[i];
      const P              from_begin[2] = {p[0] - P(s.begin[0]), p[1] - P(s.begin[1])},
              from_end[2]                = {p[0] - P(s.end[0]), p[1] - P(s.end[1])};
      const P begin = from_begin[0] * from_begin[0] + from_begin[1] * from_begin[1],
              end   = from_end[0] * from_end[0] + from_end[1] * from_end[1];
      P signed_distance, normal[2], norm(1.), inside; // inside: not negative between the ends
      if (s.kind == 0)
        {
          const double d[2]   = {s.end[0] - s.begin[0], s.end[1] - s.begin[1]};
          const double square = d[0] * d[0] + d[1] * d[1], one = 1. / __builtin_sqrt(square);
          const P      along = from_begin[0] * P(d[0]) + from_begin[1] * P(d[1]);
          inside             = least(along, P(square) - along);
          normal[0]          = P(d[1] * one);
          normal[1]          = P(-d[0] * one);
          signed_distance    = from_begin[0] * normal[0] + from_begin[1] * normal[1];
        }
      else
        {
          const P w[2]    = {p[0] - P(s.centre[0]), p[1] - P(s.centre[1])};
          norm            = square_root(w[0] * w[0] + w[1] * w[1]);
          inside          = w[0] * P(s.middle[0]) + w[1] * P(s.middle[1]) - norm * P(s.half_cosine);
          normal[0]       = w[0];
          normal[1]       = w[1];
          signed_distance = P(double(s.kind)) * (norm - P(s.radius));
        }
      const P to_end = square_root(least(begin, end));
      const P distance =
          if_less(zero, inside, greatest(signed_distance, zero - signed_distance), to_end);
      const P which = if_less(
          zero, inside, zero, if_less(begin, end, P(double(2 * i + 1)), P(double(2 * i + 2))));
      const auto keep_nearer = [&](P &to, const P &what) {
        to = if_less(distance, best.distance, what, to);
      };
      keep_nearer(best.signed_distance, signed_distance);
      keep_nearer(best.normal[0], normal[0]);
      keep_nearer(best.normal[1], normal[1]);
      keep_nearer(best.which, which);
      keep_nearer(length, norm);
      keep_nearer(sign, P(s.kind == 0 ? 1. : double(s.kind)));
      keep_nearer(curved, P(s.kind == 0 ? 0. : 1.));
      best.distance = least(distance, best.distance);
    }
  const P outward = sign / greatest(length, P(1e-300));
  best.turn       = if_less(P(0.), curved, outward, P(0.));
  for (P &component : best.normal)
    component = component * outward;
  return best;
}

/// Signed distance and normal of the point @p p, whose nearest point is the end @p which of the
/// profile, as in NearestOnProfile.
CHAINDRIVE_ALWAYS_INLINE double end_of_profile(const PlanarTeeth &teeth,
                                               const unsigned int which,
                                               const double (&p)[2],
                                               const double distance,
                                               double (&normal)[2])
{
  const PlanarSegment &s   = teeth.segments[(which - 1) / 2];
  const unsigned int   end = (which - 1) % 2;
  const double        *at = end == 0 ? s.begin : s.end, *n = s.end_normal[end];
  const double         away[2] = {p[0] - at[0], p[1] - at[1]};
  double               result  = distance;
  if (s.corner[end] < 0 || (s.corner[end] == 0 && away[0] * n[0] + away[1] * n[1] < 0.))
    result = -distance;
  const bool turns = s.corner[end] != 0 && result != 0.;
  normal[0]        = turns ? away[0] / result : n[0];
  normal[1]        = turns ? away[1] / result : n[1];
  return result;
}

/// Folds points @p p in the sprocket's frame into the sector of half a gap with half a tooth:
/// @p folded; @p turn becomes cosine and sine of the gap's angle, @p side the sign of the mirror.
template <int width>
CHAINDRIVE_ALWAYS_INLINE void fold(const PlanarTeeth &teeth,
                                   unsigned int      *gap,
                                   const Pack<double, width> (&p)[2],
                                   Pack<double, width> (&folded)[2],
                                   Pack<double, width> (&turn)[2],
                                   Pack<double, width> &side)
{
  using P = Pack<double, width>;
  const P    zero(0.), flat(1. + teeth.turns[2]), steep(teeth.turns[3]);
  P          y;
  const auto unturn = [&](const double *angles) {
    turn[0]   = gather_slots<width, 2>(angles, gap);
    turn[1]   = gather_slots<width, 2>(angles, gap, 1);
    folded[0] = turn[0] * p[0] + turn[1] * p[1];
    y         = turn[0] * p[1] - turn[1] * p[0];
  };
  for (unsigned int tries = 0; tries <= teeth.n_teeth; ++tries)
    {
      unturn(teeth.turns);
      // the middle of the tooth is where y / x = tan(pi / z)
      const P beyond = greatest(y, zero - y) * flat - folded[0] * steep;
      if (!any_less(zero, beyond))
        break;
      for (int i = 0; i < width; ++i)
        if (beyond[i] > 0.)
          {
            const unsigned int last = teeth.n_teeth - 1;
            gap[i] =
                y[i] < 0. ? (gap[i] == 0 ? last : gap[i] - 1) : (gap[i] == last ? 0 : gap[i] + 1);
          }
    }
  if (teeth.shifted != nullptr)
    unturn(teeth.shifted);
  side      = if_less(y, zero, P(-1.), P(1.));
  folded[1] = side * y;
}
} // namespace chaindrive::contact::packed
