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
  P segment; ///< the number of the segment
  P turn;    ///< how the normal turns along the tangent, 1/m
};

template <int width>
CHAINDRIVE_ALWAYS_INLINE NearestOnProfile<width>
nearest_on_profile(const PlanarTeeth &teeth, const Pack<double, width> (&p)[2])
{
  using P = Pack<double, width>;
  NearestOnProfile<width> best;
  const P                 zero(0.);
  best.distance        = P(1e300);
  best.signed_distance = best.normal[0] = best.normal[1] = best.which = best.segment = zero;
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
      keep_nearer(best.segment, P(double(i)));
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

/// The distance of the point @p p from @p s between its ends [m], with its sign; @p inside becomes
/// how far it may go before it is not between them any more or, negative, how far it is from there.
CHAINDRIVE_ALWAYS_INLINE double
distance_between_ends(const PlanarSegment &s, const double (&p)[2], double &inside)
{
  if (s.kind == 0)
    {
      const double d[2]      = {s.end[0] - s.begin[0], s.end[1] - s.begin[1]},
                   offset[2] = {p[0] - s.begin[0], p[1] - s.begin[1]};
      const double one       = 1. / __builtin_sqrt(d[0] * d[0] + d[1] * d[1]);
      const double along     = one * (offset[0] * d[0] + offset[1] * d[1]);
      inside                 = least(along, 1. / one - along);
      return one * (offset[0] * d[1] - offset[1] * d[0]);
    }
  const double w[2] = {p[0] - s.centre[0], p[1] - s.centre[1]},
               norm = __builtin_sqrt(w[0] * w[0] + w[1] * w[1]);
  // norm times the sine of the angle to the nearer end, as the centre sees it
  const double along = w[0] * s.middle[0] + w[1] * s.middle[1],
               aside = __builtin_sqrt(greatest(0., norm * norm - along * along)),
               sine  = __builtin_sqrt(greatest(0., 1. - s.half_cosine * s.half_cosine));
  inside             = sine * along - s.half_cosine * aside;
  if (sine * aside + s.half_cosine * along < 0.) // more than a right angle away from it
    inside = along - norm * s.half_cosine > 0. ? norm : -norm;
  return s.kind * (norm - s.radius);
}

/// What is nearest to a point: @p segment between its ends (@p end 0), or its begin or end (1, 2).
struct NearestPiece
{
  unsigned int segment, end;
  double       distance; ///< m
};

/// How far the point @p p may go [m] before another piece of the profile than @p nearest is
/// nearest; not positive where that is not known, as of an end, which two segments have and know
/// differently in the last digit. A template, so that each instruction set has its own.
///
/// A distance grows or falls by no more than the way. Where the profile is smooth, or has a convex
/// corner as the point sees it, the end that two segments share is never nearer than the one of
/// them between whose ends the point is.
template <int width>
double way_to_others(const PlanarTeeth &teeth, const NearestPiece &nearest, const double (&p)[2])
{
  constexpr double round_off = 1e-7; // m; where two are equally near there is no telling
  if (nearest.end != 0)
    return 0.;
  const PlanarSegment &own  = teeth.segments[nearest.segment];
  double               way  = 0.;
  const double         side = distance_between_ends(own, p, way); // positive outside of the metal
  if (own.corner[0] != 0 || own.corner[1] != 0) // which it sees otherwise from the other side
    way = least(way, greatest(side, -side));
  // whether the begin (0) or end (1) of segment i is an end of what is nearest
  const auto is_own = [&](const unsigned int i, const unsigned int e) {
    const unsigned int at = i == nearest.segment               ? e :
                            i == nearest.segment + 1 && e == 0 ? 1 :
                            i + 1 == nearest.segment && e == 1 ? 0 :
                                                                 2;
    return at < 2 && (own.corner[at] == 0 || own.corner[at] * side > 0.);
  };
  for (unsigned int i = 0; i < teeth.n_segments; ++i)
    {
      const PlanarSegment &s = teeth.segments[i];
      double               inside;
      const double         away = distance_between_ends(s, p, inside);
      if (inside > 0. && i != nearest.segment)
        way = least(way, 0.5 * (greatest(away, -away) - nearest.distance));
      for (unsigned int e = 0; e < 2; ++e)
        if (!is_own(i, e))
          {
            const double *at   = e == 0 ? s.begin : s.end;
            const double  d[2] = {p[0] - at[0], p[1] - at[1]};
            way = least(way, 0.5 * (__builtin_sqrt(d[0] * d[0] + d[1] * d[1]) - nearest.distance));
          }
    }
  return way - round_off;
}

/// Keeps what is @p nearest to the point @p p of the roller at @p place of @p teeth.
template <int width>
void keep_nearest(const PlanarTeeth  &teeth,
                  const unsigned int  place,
                  const NearestPiece &nearest,
                  const double (&p)[2])
{
  const PlanarSegment &s   = teeth.segments[nearest.segment];
  const auto           set = [&](const unsigned int entry, const double x) {
    teeth.known[entry * teeth.n + place] = x;
  };
  const double way = way_to_others<width>(teeth, nearest, p);
  set(known_room, way > 0. ? way * way : -1.);
  const bool is_line = s.kind == 0;
  set(known_radius, s.radius);
  set(known_sign, s.kind);
  // as in nearest_on_profile()
  const double  d[2]   = {s.end[0] - s.begin[0], s.end[1] - s.begin[1]};
  const double  square = d[0] * d[0] + d[1] * d[1], one = 1. / __builtin_sqrt(square);
  const double  normal[2] = {d[1] * one, -d[0] * one};
  const double *centre    = is_line ? s.begin : s.centre;
  for (unsigned int i = 0; i < 2; ++i)
    {
      set(known_at + i, p[i]);
      set(known_centre + i, centre[i]);
      set(known_normal + i, is_line ? normal[i] : 0.);
    }
}

/// Whether what is known for the roller at @p place still holds at the point @p p.
template <int width>
bool stays_near(const PlanarTeeth &teeth, const unsigned int place, const double (&p)[2])
{
  const double *at = teeth.known + place;
  const double  x = p[0] - at[known_at * teeth.n], y = p[1] - at[(known_at + 1) * teeth.n];
  return x * x + y * y <= at[known_room * teeth.n];
}

/// What nearest_on_profile() would find for the rollers from @p place on, which have stayed where
/// it is known. Returns false if one of them has not.
template <int width>
CHAINDRIVE_ALWAYS_INLINE bool nearest_as_known(const PlanarTeeth &teeth,
                                               const unsigned int place,
                                               const Pack<double, width> (&p)[2],
                                               NearestOnProfile<width> &nearest)
{
  using P             = Pack<double, width>;
  const auto entry_at = [&](const unsigned int entry) {
    return P::load(teeth.known + entry * teeth.n + place);
  };
  const P zero(0.), gone[2] = {p[0] - entry_at(known_at), p[1] - entry_at(known_at + 1)};
  if (any_less(entry_at(known_room), gone[0] * gone[0] + gone[1] * gone[1]))
    return false;
  const P w[2]            = {p[0] - entry_at(known_centre), p[1] - entry_at(known_centre + 1)};
  const P norm            = square_root(w[0] * w[0] + w[1] * w[1]);
  const P sign            = entry_at(known_sign);
  const P line[2]         = {entry_at(known_normal), entry_at(known_normal + 1)};
  const P arc             = sign * sign;
  const P outward         = sign / greatest(norm, P(1e-300));
  const P signed_distance = sign * (norm - entry_at(known_radius));
  nearest.turn            = outward;
  nearest.signed_distance = if_less(zero, arc, signed_distance, w[0] * line[0] + w[1] * line[1]);
  for (int d = 0; d < 2; ++d)
    nearest.normal[d] = if_less(zero, arc, w[d] * outward, line[d]);
  return true;
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
