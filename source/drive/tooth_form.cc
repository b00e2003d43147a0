// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/tooth_form.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace chaindrive::drive
{
using dealii::Point;
using dealii::Tensor;
using dealii::numbers::PI;
using parameters::SeatCentre;
using parameters::StandardForm;

namespace
{
std::string number_in_mm(const double length) { return to_text(length * 1e3, 7); }

constexpr double degree = PI / 180.;

/// What the three ISO 606 forms choose between their limits.
struct IsoGap
{
  double seat_radius, seat_half_angle, flank_radius;
};

IsoGap iso_gap(const StandardForm form, const double z, const double d1)
{
  const double d1_mm = d1 * 1e3;
  const IsoGap least{0.505 * d1, 0.5 * (140. - 90. / z) * degree, 0.12 * d1 * (z + 2.)};
  const IsoGap most{(0.505 * d1_mm + 0.069 * std::cbrt(d1_mm)) * 1e-3,
                    0.5 * (120. - 90. / z) * degree,
                    0.008 * d1 * (z * z + 180.)};
  if (form == StandardForm::iso_min)
    return least;
  if (form == StandardForm::iso_max)
    return most;
  return {0.5 * (least.seat_radius + most.seat_radius),
          0.5 * (least.seat_half_angle + most.seat_half_angle),
          0.5 * (least.flank_radius + most.flank_radius)};
}

/// Seat and flank of an ISO gap whose seat is centred at (@p centre, 0); the flank goes on to where
/// it is farthest from the sprocket's axis.
std::vector<Segment> iso_flank(const IsoGap &gap, const double centre)
{
  const double       angle = PI - gap.seat_half_angle;
  const Tensor<1, 2> u     = Point<2>(std::cos(angle), std::sin(angle)); // to the seat's end
  const Point<2>     seat(centre, 0.);
  const Point<2>     flank = seat + (gap.seat_radius + gap.flank_radius) * u;
  return {arc_segment(seat, gap.seat_radius, PI, angle),
          arc_segment(flank, gap.flank_radius, angle - PI, std::atan2(flank[1], flank[0]))};
}

/// Seat, working arc, straight and topping arc of ANSI/ASME B29.1 for a seat centred at (@p a, 0).
/// The names of lengths and angles are the standard's.
std::vector<Segment> ansi_flank(const double z, const double dr, const double a)
{
  const double A = (35. + 60. / z) * degree, B = (18. - 56. / z) * degree;
  const double R = 0.5 * (1.005 * dr + 0.0762e-3), E = 1.3025 * dr + 0.0381e-3;
  const double F =
      dr * (0.8 * std::cos(B) + 1.4 * std::cos((17. - 64. / z) * degree) - 1.3025) - 0.0381e-3;
  if (!(F > 0.))
    throw InputError("Drive/Sprockets/Tooth form = ansi: a roller of " + number_in_mm(dr) +
                     " mm leaves no topping arc.");
  const double   M = 0.8 * dr * std::cos(A), T = 0.8 * dr * std::sin(A);
  const double   W = 1.4 * dr * std::cos(PI / z), V = 1.4 * dr * std::sin(PI / z);
  const Point<2> working(a + T, -M), topping(a - V, W);

  // the working arc ends, and the topping arc begins, where their common tangent touches them
  const double  tangent = 0.5 * PI + A - B;
  const Segment work    = arc_segment(working, E, 0.5 * PI + A, tangent);
  const Segment top     = arc_segment(topping, F, tangent - PI, std::atan2(topping[1], topping[0]));
  return {arc_segment(Point<2>(a, 0.), R, PI, 0.5 * PI + A),
          work,
          line_segment(work.end, top.begin),
          top};
}

/// Angle on the arc @p s at which it reaches the distance @p r from the origin.
double angle_at_radius(const Segment &s, const double r)
{
  const double c      = s.centre.norm();
  const double cosine = (r * r - c * c - s.radius * s.radius) / (2. * c * s.radius);
  const double offset = std::acos(std::max(-1., std::min(1., cosine)));
  const double middle = std::atan2(s.centre[1], s.centre[0]);
  if (s.kind == Segment::Kind::convex) // distances grow with the angle up to that of the centre
    return middle - offset;
  return middle + offset; // concave: they grow while the angle falls
}

/// The part of @p s that lies within the distance @p r of the origin, which cuts it.
Segment cut_at_radius(const Segment &s, const double r)
{
  if (s.kind != Segment::Kind::line)
    {
      double end = angle_at_radius(s, r);
      while (s.kind == Segment::Kind::concave && end > s.begin_angle)
        end -= 2. * PI;
      return arc_segment(s.centre, s.radius, s.begin_angle, end);
    }
  const Tensor<1, 2> d = s.end - s.begin;
  const double       b = (s.begin * d) / d.norm_square();
  const double       t = -b + std::sqrt(b * b + (r * r - s.begin.square()) / d.norm_square());
  return line_segment(s.begin, s.begin + t * d);
}

/// Seat to tip edge: what a sprocket of the radius @p r keeps of @p flank.
std::vector<Segment> trimmed(const std::vector<Segment> &flank, const double r)
{
  std::vector<Segment> kept;
  for (const Segment &s : flank)
    {
      if (s.end.norm() >= r)
        {
          kept.push_back(cut_at_radius(s, r));
          break;
        }
      kept.push_back(s);
    }
  return kept;
}

double tip_angle(const std::vector<Segment> &flank, const double r)
{
  const Point<2> edge = trimmed(flank, r).back().end;
  return std::atan2(edge[1], edge[0]);
}

/// Largest radius of a tooth: where its last arc meets the tooth's middle line, or where that arc
/// is farthest from the axis if that comes first.
double largest_radius(const std::vector<Segment> &flank, const double half_pitch_angle)
{
  const Segment     &s     = flank.back();
  const Tensor<1, 2> e     = Point<2>(std::cos(half_pitch_angle), std::sin(half_pitch_angle));
  const double       along = e * s.centre, top = s.centre.norm() + s.radius;
  const double       square = along * along - s.centre.square() + s.radius * s.radius;
  const bool         beyond = std::atan2(s.centre[1], s.centre[0]) < half_pitch_angle;
  return beyond || square < 0. ? top : std::min(top, along + std::sqrt(square));
}

/// Outside diameter that leaves the tip land @p land.
double diameter_for_land(const std::vector<Segment> &flank,
                         const double                half_pitch_angle,
                         const double                least,
                         const double                most,
                         const double                land)
{
  double low = least, high = most;
  for (int i = 0; i < 60; ++i)
    {
      const double d                                                           = 0.5 * (low + high);
      (d * (half_pitch_angle - tip_angle(flank, 0.5 * d)) > land ? low : high) = d;
    }
  return low;
}
} // namespace

ToothForm make_tooth_form(const unsigned int           teeth,
                          const ChainDimensions       &chain,
                          const parameters::Sprockets &sprockets,
                          const unsigned int           number)
{
  const parameters::Sprocket &given = sprockets.list.at(number);
  const std::string           name  = given.in_entries();
  if (teeth < 9)
    throw InputError("Drive/" + name + " teeth = " + std::to_string(teeth) +
                     ": the tooth forms of the standards begin at 9 teeth.");
  const StandardForm form   = sprockets.tooth_form;
  const SeatCentre   centre = sprockets.seat_centre;
  const bool         ansi   = form == StandardForm::ansi;
  const double       z = teeth, p = chain.pitch, d1 = chain.roller_diameter;
  ToothForm          t;
  t.teeth           = teeth;
  t.pitch           = p;
  t.pitch_diameter  = p / std::sin(PI / z);
  t.roller_diameter = d1;

  const IsoGap gap = iso_gap(form, z, d1);
  t.seat_radius    = ansi ? 0.5 * (1.005 * d1 + 0.0762e-3) : gap.seat_radius;
  double seat_centre =
      0.5 * t.pitch_diameter; // `pitch`, and what ANSI means by a standard sprocket
  if (centre == SeatCentre::bottom_diameter)
    {
      if (!given.bottom_diameter)
        throw InputError("Drive/Sprockets/" + name +
                         " bottom diameter must be given, because Seat "
                         "centre = bottom diameter.");
      seat_centre = 0.5 * *given.bottom_diameter + t.seat_radius;
    }
  else if (centre == SeatCentre::iso && !ansi)
    seat_centre = 0.5 * (t.pitch_diameter - d1) + t.seat_radius;
  t.root_diameter = 2. * (seat_centre - t.seat_radius);
  if (!(t.root_diameter > 0.))
    throw InputError("Drive/Sprockets/" + name + " bottom diameter in mm = " +
                     number_in_mm(t.root_diameter) + " must be positive.");

  const std::vector<Segment> flank =
      ansi ? ansi_flank(z, d1, seat_centre) : iso_flank(gap, seat_centre);
  t.seat_half_angle  = PI - flank.front().end_angle;
  t.flank_radius     = flank[1].radius;
  t.pointed_diameter = 2. * largest_radius(flank, PI / z);

  const double least = 2. * flank.front().end.norm();
  if (given.outside_diameter)
    t.outside_diameter = *given.outside_diameter;
  else
    {
      const double least_iso = t.pitch_diameter + p * (1. - 1.6 / z) - d1;
      const double most_iso  = t.pitch_diameter + 1.25 * p - d1;
      const double wanted = ansi ? p * (0.6 + 1. / std::tan(PI / z)) : 0.5 * (least_iso + most_iso);
      const auto   for_land = [&](const double land) {
        return diameter_for_land(flank, PI / z, least, t.pointed_diameter, land * p);
      };
      const double limit = for_land(0.05), hard_limit = for_land(0.025);
      std::string  reason;
      if (wanted <= limit)
        reason = ansi ? "as ANSI/ASME B29.1" : "midway between the limits of ISO 606";
      else if (ansi || limit >= least_iso)
        reason = "for a tip land of 0.05 of the pitch";
      else if (hard_limit >= least_iso)
        reason = "the least of ISO 606, which leaves a tip land of less than 0.05 of the pitch";
      else
        reason = "for a tip land of 0.05 of the pitch, below the limits of ISO 606, " +
                 number_in_mm(least_iso) + " and " + number_in_mm(most_iso) + " mm";
      t.outside_diameter = !ansi && limit < least_iso && least_iso <= hard_limit ?
                               least_iso :
                               std::min(wanted, limit);
      t.derived.push_back(name + " outside diameter " + number_in_mm(t.outside_diameter) + " mm, " +
                          reason + ".");
    }
  if (!(t.outside_diameter > least && t.outside_diameter < t.pointed_diameter))
    throw InputError("Drive/Sprockets/" + name +
                     " outside diameter in mm = " + number_in_mm(t.outside_diameter) +
                     " must lie between " + to_text_at_least(1e3 * least, 7) +
                     ", where the seat ends, and " + to_text_at_most(1e3 * t.pointed_diameter, 7) +
                     ", where the tooth is pointed and its tip land zero.");

  const double radius = 0.5 * t.outside_diameter;
  t.half_profile      = trimmed(flank, radius);
  const double edge   = tip_angle(flank, radius);
  if (!(edge < PI / z))
    throw InputError("Drive/Sprockets/" + name +
                     " outside diameter in mm = " + number_in_mm(t.outside_diameter) +
                     " leaves a tip land of " + number_in_mm(t.outside_diameter * (PI / z - edge)) +
                     " mm, which must be positive; teeth are pointed at " +
                     number_in_mm(t.pointed_diameter) + " mm.");
  t.half_profile.push_back(arc_segment(Point<2>(), radius, edge, PI / z));
  t.corners.resize(t.half_profile.size() + 1, ToothForm::Corner::none);
  t.corners[t.half_profile.size() - 1] = ToothForm::Corner::convex; // the tip's edge

  for (unsigned int k = 0; k < teeth; ++k)
    t.rotations.push_back(Point<2>(std::cos(2. * PI * k / z), std::sin(2. * PI * k / z)));
  return t;
}

double joint_radius(const parameters::Flat &flat, const ChainDimensions &chain)
{
  return 0.5 * (*flat.diameter + (flat.runs_on == parameters::RunsOn::rollers ?
                                      chain.roller_diameter :
                                      chain.inner_plate_height));
}

ToothForm make_drum(const ChainDimensions       &chain,
                    const parameters::Sprockets &sprockets,
                    const unsigned int           number)
{
  const parameters::Sprocket &given = sprockets.list.at(number);
  const std::string           entry =
      "Drive/Wheels/" + given.name + "/Flat/Diameter in mm = " + number_in_mm(*given.flat.diameter);
  const double radius = joint_radius(given.flat, chain), least = chain.pitch;
  if (given.role != parameters::Role::idler)
    throw InputError(entry + " is for an idler: friction alone does not carry a load; choose Role "
                             "= idler, or none.");
  if (!(radius >= least))
    throw InputError(entry +
                     " leaves a chain of this pitch less than six joints in a turn; choose "
                     "at least " +
                     to_text_at_least(1e3 * (2. * (least - radius) + *given.flat.diameter), 7) +
                     ".");
  if (given.index_tolerance > 0. || !given.index_deviations.empty())
    throw InputError(entry + " has no teeth, but Index tolerance in um and Index deviations in um "
                             "are on where they stand; leave these at their defaults.");
  ToothForm t{};
  t.flat             = true;
  t.pitch            = chain.pitch;
  t.pitch_diameter   = 2. * radius;
  t.roller_diameter  = chain.roller_diameter;
  t.root_diameter    = *given.flat.diameter;
  t.outside_diameter = t.pointed_diameter = t.root_diameter;
  // contact of a roller is at most that on a flat: that in a seat of twice its radius
  t.seat_radius     = chain.roller_diameter;
  t.flank_radius    = 0.5 * t.root_diameter;
  t.teeth           = static_cast<unsigned int>(std::lround(t.seats()));
  const double half = PI / t.teeth;
  t.half_profile    = {arc_segment(Point<2>(), t.flank_radius, 0., half)};
  t.corners.resize(2, ToothForm::Corner::none);
  for (unsigned int k = 0; k < t.teeth; ++k)
    t.rotations.push_back(Point<2>(std::cos(2. * k * half), std::sin(2. * k * half)));
  return t;
}

double ToothForm::seats() const
{
  return flat ? PI / std::asin(pitch / pitch_diameter) : static_cast<double>(teeth);
}

double ToothForm::pitch_angle() const { return 2. * PI / teeth; }

void ToothForm::shift_gaps(const std::vector<double> &deviations)
{
  shifted.clear();
  for (unsigned int k = 0; k < deviations.size(); ++k)
    {
      const double angle = k * pitch_angle() + 2. * deviations[k] / pitch_diameter;
      shifted.push_back(Point<2>(std::cos(angle), std::sin(angle)));
    }
}

double ToothForm::tip_land() const
{
  return outside_diameter * (half_profile.back().end_angle - half_profile.back().begin_angle);
}

double ToothForm::seat_end_pressure_angle() const
{
  return 0.5 * PI - PI / teeth - seat_half_angle;
}

double ToothForm::area() const
{
  double sum = 0.;
  for (const Segment &s : half_profile)
    sum += s.area();
  return 2. * teeth * sum;
}

double ToothForm::polar_moment() const
{
  double sum = 0.;
  for (const Segment &s : half_profile)
    sum += s.polar_moment();
  return 2. * teeth * sum;
}
} // namespace chaindrive::drive
