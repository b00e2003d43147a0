// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Where `width` points are nearest to the profile of a sprocket: drive::ToothForm::closest_point(),
// for the kernels of planar_contact_kernels.h.

#include <chaindrive/contact/planar_contact_kernels.h>
#include <chaindrive/utilities/rows.h>

namespace chaindrive::contact::packed
{
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
/// An end that two segments share is that of the first of them.
struct NearestPiece
{
  unsigned int segment, end;
  double       distance; ///< m
};

/// The distance of the point @p p from an end of @p s, 1: its begin, 2: its end [m].
CHAINDRIVE_ALWAYS_INLINE double
distance_from_end(const PlanarSegment &s, const unsigned int end, const double (&p)[2])
{
  const double *at   = end == 1 ? s.begin : s.end;
  const double  d[2] = {p[0] - at[0], p[1] - at[1]};
  return __builtin_sqrt(d[0] * d[0] + d[1] * d[1]);
}

/// The piece of the profile that is nearest to the point @p p. A template, so that each instruction
/// set has its own.
template <int width>
NearestPiece nearest_piece(const PlanarTeeth &teeth, const double (&p)[2])
{
  NearestPiece best{0, 1, distance_from_end(teeth.segments[0], 1, p)};
  for (unsigned int i = 0; i < teeth.n_segments; ++i)
    {
      const PlanarSegment &s = teeth.segments[i];
      double               inside;
      const double         away = distance_between_ends(s, p, inside), from = greatest(away, -away),
                   from_end = distance_from_end(s, 2, p);
      if (from_end < best.distance)
        best = {i, 2, from_end};
      if (inside > 0. && from <= best.distance)
        best = {i, 0, from};
    }
  return best;
}

/// How far the point @p p may go [m] before another piece of the profile than @p nearest is
/// nearest; not positive where that is not known, as of an end without a corner. A template, so
/// that each instruction set has its own.
///
/// A distance grows or falls by no more than the way. Where the profile is smooth, or has a convex
/// corner as the point sees it, the end that two segments share is never nearer than the one of
/// them between whose ends the point is. From a corner that is nearest the point comes to the
/// segments on both sides of it where it gets between their ends.
template <int width>
double way_to_others(const PlanarTeeth &teeth, const NearestPiece &nearest, const double (&p)[2])
{
  constexpr double     round_off = 1e-11; // m; where two are equally near there is no telling
  const PlanarSegment &own       = teeth.segments[nearest.segment];
  double               way       = nearest.distance, inside;
  if (nearest.end != 0 && own.corner[nearest.end - 1] == 0)
    return 0.;
  const double side = distance_between_ends(own, p, inside); // positive outside of the metal
  if (nearest.end == 0)
    way = own.corner[0] != 0 || own.corner[1] != 0 ? // which it sees otherwise from the other side
              least(inside, greatest(side, -side)) :
              inside;
  // the number of the end between segments: the begin of the first has 0, the end of segment i i +
  // 1
  const unsigned int corner = nearest.end == 1 ? 0 : nearest.segment + 1;
  const auto         is_own = [&](const unsigned int end) {
    if (nearest.end != 0)
      return end == corner;
    const unsigned int at = end - nearest.segment; // 0, 1: begin or end of the nearest
    return at < 2 && (own.corner[at] == 0 || own.corner[at] * side > 0.);
  };
  for (unsigned int i = 0; i < teeth.n_segments; ++i)
    {
      const PlanarSegment &s    = teeth.segments[i];
      const double         away = distance_between_ends(s, p, inside);
      if (nearest.end != 0 && (i == corner || i + 1 == corner))
        way = least(way, -inside);
      else if (inside > 0. && (nearest.end != 0 || i != nearest.segment))
        way = least(way, 0.5 * (greatest(away, -away) - nearest.distance));
      for (unsigned int e = i == 0 ? 0 : 1; e < 2; ++e)
        if (!is_own(i + e))
          way = least(way, 0.5 * (distance_from_end(s, e + 1, p) - nearest.distance));
    }
  return way - round_off;
}

/// Finds what is nearest to the point @p p of the roller at @p place of @p teeth, and keeps it.
template <int width>
void keep_nearest(const PlanarTeeth &teeth, const unsigned int place, const double (&p)[2])
{
  const NearestPiece   nearest = nearest_piece<width>(teeth, p);
  const PlanarSegment &s       = teeth.segments[nearest.segment];
  double              *known   = known_of(teeth, place);
  const auto           set     = [known](const unsigned int entry, const double x, const double y) {
    known[entry * n_lanes]       = x;
    known[(entry + 1) * n_lanes] = y;
  };
  const double way            = way_to_others<width>(teeth, nearest, p);
  known[known_room * n_lanes] = way > 0. ? way * way : -1.;
  set(known_at, p[0], p[1]);
  const auto be = [&](const double *centre, const double radius, const int sign) {
    set(known_centre, centre[0], centre[1]);
    known[known_radius * n_lanes] = radius;
    known[known_sign * n_lanes]   = sign;
  };
  if (nearest.end != 0) // an arc about a corner; the normal of an end that is none does not turn
    {
      const unsigned int e  = nearest.end - 1;
      const double      *at = e == 0 ? s.begin : s.end, *n = s.end_normal[e];
      const double       side  = (p[0] - at[0]) * n[0] + (p[1] - at[1]) * n[1];
      const bool         turns = s.corner[e] != 0;
      be(at, 0., turns ? s.corner[e] : side < 0. ? -1 : 1);
      set(known_normal, turns ? 0. : n[0], turns ? 0. : n[1]);
    }
  else if (s.kind == 0)
    {
      be(s.begin, 0., 0);
      set(known_normal, s.end_normal[0][0], s.end_normal[0][1]);
    }
  else
    {
      be(s.centre, s.radius, s.kind);
      set(known_normal, 0., 0.);
    }
}

/// Whether what is known for the rollers from @p known on still holds at the points @p p.
template <int width>
CHAINDRIVE_ALWAYS_INLINE bool stay_near(const double *known, const Pack<double, width> (&p)[2])
{
  using P   = Pack<double, width>;
  const P x = p[0] - P::load(known + known_at * n_lanes),
          y = p[1] - P::load(known + (known_at + 1) * n_lanes);
  return !any_negative(P::load(known + known_room * n_lanes) - (x * x + y * y));
}

/// Looks again at the rollers from @p place on, now at (@p x, @p y), that have gone too far.
template <int width>
__attribute__((noinline)) void
look_again(const PlanarTeeth &teeth, const unsigned int place, const double *x, const double *y)
{
  for (unsigned int i = 0; i < width; ++i)
    {
      const double  p[2]  = {x[i], y[i]};
      const double *known = known_of(teeth, place + i);
      const double a = p[0] - known[known_at * n_lanes], b = p[1] - known[(known_at + 1) * n_lanes];
      if (!(a * a + b * b <= known[known_room * n_lanes]))
        keep_nearest<width>(teeth, place + i, p);
    }
}

/// Nearest points of a profile, for a pack of points.
template <int width>
struct NearestOnProfile
{
  using P = Pack<double, width>;

  /// On the pieces that are @p known to be nearest to the points @p p.
  CHAINDRIVE_ALWAYS_INLINE NearestOnProfile(const double *known, const P (&p)[2])
  {
    const auto entry_at = [known](const unsigned int entry) {
      return P::load(known + entry * n_lanes);
    };
    const P zero(0.);
    const P w[2]    = {p[0] - entry_at(known_centre), p[1] - entry_at(known_centre + 1)};
    const P norm    = square_root(w[0] * w[0] + w[1] * w[1]);
    const P sign    = entry_at(known_sign);
    const P line[2] = {entry_at(known_normal), entry_at(known_normal + 1)};
    const P arc = sign * sign, fixed = line[0] * line[0] + line[1] * line[1];
    turn = if_less(zero, fixed, zero, sign / greatest(norm, P(1e-300)));
    signed_distance =
        if_less(zero, arc, sign * (norm - entry_at(known_radius)), w[0] * line[0] + w[1] * line[1]);
    for (int d = 0; d < 2; ++d)
      normal[d] = if_less(zero, fixed, line[d], w[d] * turn);
  }

  P signed_distance, normal[2]; ///< m, positive outside of the metal; unit, out of it
  P turn;                       ///< how the normal turns along the tangent, 1/m
};

/// Folds points @p p in the sprocket's frame, of the rollers from @p place on, into the sector of
/// half a gap with half a tooth: @p folded; @p turn becomes cosine and sine of the gap's angle,
/// @p side the sign of the mirror.
template <int width>
CHAINDRIVE_ALWAYS_INLINE void fold(const PlanarTeeth &teeth,
                                   const unsigned int place,
                                   const double      *known,
                                   const Pack<double, width> (&p)[2],
                                   Pack<double, width> (&folded)[2],
                                   Pack<double, width> (&turn)[2],
                                   Pack<double, width> &side)
{
  using P = Pack<double, width>;
  const P    zero(0.), flat(1. + teeth.turns[2]), steep(teeth.turns[3]);
  P          y;
  const auto unturn = [&](const unsigned int angle) {
    turn[0]   = P::load(known + angle * n_lanes);
    turn[1]   = P::load(known + (angle + 1) * n_lanes);
    folded[0] = turn[0] * p[0] + turn[1] * p[1];
    y         = turn[0] * p[1] - turn[1] * p[0];
  };
  for (unsigned int tries = 0; tries <= teeth.n_teeth; ++tries)
    {
      unturn(known_turn);
      // the middle of the tooth is where y / x = tan(pi / z)
      const P beyond = greatest(y, zero - y) * flat - folded[0] * steep;
      if (!any_negative(zero - beyond))
        break;
      for (int i = 0; i < width; ++i)
        if (beyond[i] > 0.)
          {
            const unsigned int last = teeth.n_teeth - 1, gap = teeth.gap[place + i];
            enter_gap(teeth,
                      place + i,
                      y[i] < 0. ? (gap == 0 ? last : gap - 1) : (gap == last ? 0 : gap + 1));
          }
    }
  if (teeth.shifted != nullptr)
    unturn(known_shifted);
  side      = if_less(y, zero, P(-1.), P(1.));
  folded[1] = side * y;
}
} // namespace chaindrive::contact::packed
