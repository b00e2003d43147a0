// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/sprocket_files.h>
#include <chaindrive/drive/sprocket_solid.h>
#include <chaindrive/files/file.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <utility>

namespace chaindrive::drive
{
namespace
{
using dealii::Point;
using dealii::numbers::PI;

constexpr double millimetres = 1e3, degrees = 180. / PI;

/// @p segment turned about the origin by @p angle.
Segment turned(const Segment &segment, const double angle)
{
  const auto turn = [c = std::cos(angle), s = std::sin(angle)](const Point<2> &p) {
    return Point<2>(c * p[0] - s * p[1], s * p[0] + c * p[1]);
  };
  return segment.kind == Segment::Kind::line ?
             line_segment(turn(segment.begin), turn(segment.end)) :
             arc_segment(turn(segment.centre),
                         segment.radius,
                         segment.begin_angle + angle,
                         segment.end_angle + angle);
}

/// The mirror image of @p segment in the axis x, run through backwards.
Segment mirrored(const Segment &segment)
{
  const auto mirror = [](const Point<2> &p) { return Point<2>(p[0], 0. - p[1]); };
  return segment.kind == Segment::Kind::line ?
             line_segment(mirror(segment.end), mirror(segment.begin)) :
             arc_segment(mirror(segment.centre),
                         segment.radius,
                         0. - segment.end_angle,
                         0. - segment.begin_angle);
}

/// Appends @p next, to the last of @p all if both are arcs of one circle.
void append(std::vector<Segment> &all, const Segment &next)
{
  constexpr double tolerance = 1e-9; // m
  if (!all.empty() && all.back().kind == next.kind && next.kind != Segment::Kind::line &&
      all.back().centre.distance(next.centre) < tolerance &&
      std::abs(all.back().radius - next.radius) < tolerance)
    all.back() = arc_segment(next.centre,
                             next.radius,
                             all.back().begin_angle,
                             all.back().end_angle + next.end_angle - next.begin_angle);
  else
    all.push_back(next);
}

void write_table(std::ostream &out, const ToothForm &form)
{
  out << "kind,begin x (mm),begin y (mm),end x (mm),end y (mm),centre x (mm),centre y (mm),"
         "radius (mm),begin angle (deg),end angle (deg)\n"
      << std::setprecision(12);
  for (const Segment &s : form.half_profile)
    {
      const bool is_line = s.kind == Segment::Kind::line;
      out << (is_line ? "line" : s.kind == Segment::Kind::convex ? "convex arc" : "concave arc");
      for (const Point<2> &p : {s.begin, s.end})
        out << ',' << millimetres * p[0] << ',' << millimetres * p[1];
      if (is_line)
        out << ",,,,,\n";
      else
        out << ',' << millimetres * s.centre[0] << ',' << millimetres * s.centre[1] << ','
            << millimetres * s.radius << ',' << degrees * s.begin_angle << ','
            << degrees * s.end_angle << '\n';
    }
}

/// Drawing interchange format of release 12, which every program reads: pairs of a group code and a
/// value, a line each.
class Dxf
{
public:
  explicit Dxf(std::ostream &out) : out_(out) { out_ << std::fixed << std::setprecision(9); }

  template <typename Value>
  Dxf &group(const int code, const Value &value)
  {
    out_ << std::setw(3) << code << '\n' << value << '\n';
    return *this;
  }
  Dxf &point(const int first, const Point<2> &p)
  {
    return group(first, millimetres * p[0])
        .group(first + 10, millimetres * p[1])
        .group(first + 20, 0.);
  }
  Dxf &entity(const char *kind, const char *layer) { return group(0, kind).group(8, layer); }

private:
  std::ostream &out_;
};

void write_dxf(std::ostream &out, const Sprocket &sprocket)
{
  Dxf dxf(out);
  dxf.group(0, "SECTION").group(2, "HEADER").group(9, "$ACADVER").group(1, "AC1009");
  dxf.group(9, "$INSUNITS").group(70, 4); // mm
  dxf.group(0, "ENDSEC").group(0, "SECTION").group(2, "ENTITIES");
  for (const Segment &s : outline(sprocket.form))
    if (s.kind == Segment::Kind::line)
      dxf.entity("LINE", "PROFILE").point(10, s.begin).point(11, s.end);
    else // arcs run counter-clockwise
      dxf.entity("ARC", "PROFILE")
          .point(10, s.centre)
          .group(40, millimetres * s.radius)
          .group(50, degrees * std::min(s.begin_angle, s.end_angle))
          .group(51, degrees * std::max(s.begin_angle, s.end_angle));
  for (const auto &[diameter, layer] : {std::make_pair(sprocket.bore, "BORE"),
                                        std::make_pair(sprocket.form.pitch_diameter, "PITCH")})
    dxf.entity("CIRCLE", layer).point(10, Point<2>()).group(40, 0.5 * millimetres * diameter);
  dxf.group(0, "ENDSEC").group(0, "EOF");
}

void write_svg(std::ostream &out, const Sprocket &sprocket)
{
  const auto   mm   = [](const double length) { return to_text(millimetres * length, 9); };
  const auto   at   = [&mm](const Point<2> &p) { return mm(p[0]) + " " + mm(0. - p[1]); };
  const double half = 0.55 * sprocket.form.outside_diameter;
  const std::vector<Segment> pieces = outline(sprocket.form);
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << mm(2. * half) << "mm\" height=\""
      << mm(2. * half) << "mm\" viewBox=\"" << mm(-half) << ' ' << mm(-half) << ' ' << mm(2. * half)
      << ' ' << mm(2. * half)
      << "\" fill=\"none\" stroke=\"black\" stroke-width=\"0.2\">\n  <path d=\"M"
      << at(pieces.front().begin);
  for (const Segment &s : pieces)
    if (s.kind == Segment::Kind::line)
      out << " L" << at(s.end);
    else // the axis y is downwards: what is counter-clockwise here is clockwise there
      out << " A" << mm(s.radius) << ' ' << mm(s.radius) << " 0 0 "
          << (s.end_angle > s.begin_angle ? 0 : 1) << ' ' << at(s.end);
  out << " Z\"/>\n  <circle r=\"" << mm(0.5 * sprocket.bore) << "\"/>\n  <circle r=\""
      << mm(0.5 * sprocket.form.pitch_diameter)
      << "\" stroke-dasharray=\"4 1 1 1\" stroke=\"grey\"/>\n</svg>\n";
}
} // namespace

std::vector<Segment> outline(const ToothForm &form)
{
  std::vector<Segment> all;
  for (unsigned int gap = 0; gap < form.teeth; ++gap)
    {
      const double angle = gap * form.pitch_angle();
      for (auto segment = form.half_profile.rbegin(); segment != form.half_profile.rend();
           ++segment)
        append(all, turned(mirrored(*segment), angle));
      for (const Segment &segment : form.half_profile)
        append(all, turned(segment, angle));
    }
  return all;
}

double distance_over_pins(const ToothForm &form)
{
  const double centres = form.root_diameter + form.roller_diameter; // 2 c
  return centres * (form.teeth % 2 == 0 ? 1. : std::cos(0.5 * PI / form.teeth)) +
         form.roller_diameter;
}

const std::vector<std::string> &sprocket_file_suffixes()
{
  static const std::vector<std::string> suffixes{".csv", ".dxf", ".svg", ".step", ".stl"};
  return suffixes;
}

void write_sprocket(const Sprocket    &sprocket,
                    const double       width,
                    const std::string &path,
                    const std::string &folder)
{
  const auto  dot    = path.rfind('.');
  std::string suffix = dot == std::string::npos ? "" : path.substr(dot);
  if (suffix == ".csv")
    files::write_file(path, [&](std::ostream &out) { write_table(out, sprocket.form); });
  else if (suffix == ".dxf")
    files::write_file(path, [&](std::ostream &out) { write_dxf(out, sprocket); });
  else if (suffix == ".svg")
    files::write_file(path, [&](std::ostream &out) { write_svg(out, sprocket); });
  else if (suffix == ".step" || suffix == ".stl")
    write_solid(outline(sprocket.form), sprocket.bore, width, path, folder);
  else
    throw InputError("A sprocket cannot be written as '" + path +
                     "': choose a name that ends in one of " + join(sprocket_file_suffixes()) +
                     ".");
}
} // namespace chaindrive::drive
