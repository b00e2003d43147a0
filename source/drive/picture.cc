// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/picture.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>

namespace chaindrive::drive
{
namespace
{
using dealii::Point;
using dealii::Tensor;
using dealii::numbers::PI;

/// A length as SVG has it, mm.
std::string mm(const double length) { return to_text(std::round(length * 1e6) * 1e-3, 8); }

/// A point, whose y axis is downwards there.
std::string at(const Point<2> &p) { return mm(p[0]) + " " + mm(0. - p[1]); }

Point<2> turned(const Point<2> &p, const double angle, const Point<2> &centre)
{
  const double c = std::cos(angle), s = std::sin(angle);
  return Point<2>(centre[0] + c * p[0] - s * p[1], centre[1] + s * p[0] + c * p[1]);
}

std::string text(const Point<2> &p, const double size, const std::string &words)
{
  return "  <text x=\"" + mm(p[0]) + "\" y=\"" + mm(0. - p[1]) + "\" font-size=\"" + mm(size) +
         "\" text-anchor=\"middle\">" + words + "</text>\n";
}

/// Words in the direction @p away of @p p, which they keep clear of by @p gap.
std::string text_beside(const Point<2>     &p,
                        const Tensor<1, 2> &away,
                        const double        gap,
                        const double        size,
                        const std::string  &words)
{
  const double   wide = 0.28 * size * words.size(), high = 0.36 * size; // half of each, about
  const Point<2> middle = p + (gap + wide * std::abs(away[0]) + high * std::abs(away[1])) * away;
  return text(Point<2>(middle[0], middle[1] - high), size, words);
}

/// Whether any wheel is out of line, which pulls strands unevenly.
bool is_out_of_line(const Drive &drive)
{
  return std::any_of(drive.sprockets.begin(), drive.sprockets.end(), [](const Sprocket &sprocket) {
    return sprocket.axial_offset != 0. || sprocket.tilt != 0.;
  });
}

/// An arrow along @p by, whose head is at @p tip.
std::string arrow(const Point<2> &tip, const Tensor<1, 2> &by, const double head, const char *what)
{
  const Tensor<1, 2> along = by / by.norm();
  Tensor<1, 2>       across;
  across[0]             = -along[1];
  across[1]             = along[0];
  const Point<2> behind = tip - head * along;
  return std::string("  <path class=\"") + what + "\" d=\"M" + at(tip - by) + "L" + at(tip) + "M" +
         at(behind + 0.4 * head * across) + "L" + at(tip) + "L" + at(behind - 0.4 * head * across) +
         "\"/>\n";
}

/// An arc below the centre of @p wheel with an arrow that says how it turns.
std::string sense_of(const Facts::Sprocket &wheel, const double letter)
{
  const double radius = 0.33 * wheel.pitch_diameter, half = PI / 4.;
  const auto   on = [&](const double angle) {
    return Point<2>(wheel.centre[0] + radius * std::cos(angle),
                    wheel.centre[1] + radius * std::sin(angle));
  };
  const Point<2> from = on(-0.5 * PI - wheel.sense * half), to = on(-0.5 * PI + wheel.sense * half);
  Tensor<1, 2>   by; // along the arc at its end
  by[0] = wheel.sense * std::cos(half);
  by[1] = std::sin(half);
  return "  <path class=\"sense\" d=\"M" + at(from) + "A" + mm(radius) + " " + mm(radius) +
         " 0 0 " + (wheel.sense > 0 ? "0 " : "1 ") + at(to) + "\"/>\n" +
         arrow(to, 0.1 * letter * by, 0.8 * letter, "sense");
}

/// What @p tensioner moves its wheel on: the arm with its pivot, or the line of the slide; where
/// the wheel's centre may be between the stops, or within a @p letter [m] of travel where there are
/// none; and with what it presses on all @p strands.
std::string track_of(const Tensioner &tensioner, const double letter, const unsigned int strands)
{
  const double reach   = 3. * letter / tensioner.lever();
  const double from    = std::max(tensioner.law.least, tensioner.travel - reach),
               to      = std::min(tensioner.law.most, tensioner.travel + reach);
  const Point<2> now   = tensioner.centre(tensioner.travel);
  std::string    path  = "  <path class=\"tensioner\" d=\"M" + at(tensioner.centre(from));
  constexpr int  parts = 16;
  for (int i = 1; i <= parts; ++i)
    path += "L" + at(tensioner.centre(from + (to - from) * i / parts));
  for (const double end : {from, to}) // the stops
    {
      const Tensor<1, 2> way = 0.4 * letter / tensioner.lever() * tensioner.way(end);
      const Point<2>     p   = tensioner.centre(end);
      if (end == tensioner.law.least || end == tensioner.law.most)
        path += "M" + at(Point<2>(p[0] - way[1], p[1] + way[0])) + "L" +
                at(Point<2>(p[0] + way[1], p[1] - way[0]));
    }
  if (tensioner.is_arm())
    path += "M" + at(tensioner.pivot) + "L" + at(now);
  path += "\"/>\n";
  if (tensioner.is_arm())
    path += "  <circle class=\"tensioner\" cx=\"" + mm(tensioner.pivot[0]) + "\" cy=\"" +
            mm(0. - tensioner.pivot[1]) + "\" r=\"" + mm(0.4 * letter) + "\"/>\n";
  if (tensioner.is_clamped())
    return path;
  const double       force = strands * tensioner.law.elastic(tensioner.travel);
  const Tensor<1, 2> way   = tensioner.way(tensioner.travel) / tensioner.lever();
  const Tensor<1, 2> by    = 3. * letter * way;
  path += arrow(now + by, by, 0.8 * letter, "tensioner");
  const Point<2> label = tensioner.is_arm() ? tensioner.pivot : now - 4. * letter * way;
  return path + text(Point<2>(label[0], label[1] - 1.4 * letter),
                     0.8 * letter,
                     to_text(force, 4) + (tensioner.is_arm() ? " N m" : " N"));
}

/// The arm of @p swing and the way of its wheel, whose axis is at @p now.
std::string track_of(const Swing &swing, const Point<2> &now, const double letter)
{
  constexpr int parts = 16;
  std::string   path = "  <path class=\"tensioner\" d=\"M" + at(swing.pivot) + "L" + at(now) + "M" +
                     at(swing.centre(now, swing.least));
  for (int i = 1; i <= parts; ++i)
    path += "L" + at(swing.centre(now, swing.least + (swing.most - swing.least) * i / parts));
  return path + "\"/>\n  <circle class=\"tensioner\" cx=\"" + mm(swing.pivot[0]) + "\" cy=\"" +
         mm(0. - swing.pivot[1]) + "\" r=\"" + mm(0.4 * letter) + "\"/>\n";
}

/// The line of @p guide where it is, and what holds it.
std::string line_of(const Guide &guide, const double letter, const unsigned int strands)
{
  std::string path = "  <path class=\"guide\" d=\"";
  for (const Point<2> &p : guide.polyline(8))
    path += (path.back() == '"' ? "M" : "L") + at(p);
  path += "\"/>\n";
  if (!guide.held)
    return path;
  Tensioner held = *guide.held;
  held.reference = guide.curve.at(0.5 * guide.curve.n_pieces());
  return path + track_of(held, letter, strands);
}

/// The resultant of the spans at its two ends on the shaft of wheel @p i, N.
Tensor<1, 2> load_on(const Facts &facts, const std::size_t i)
{
  const std::size_t  n  = facts.spans.size();
  const Facts::Span &in = facts.spans[(i + n - 1) % n], &out = facts.spans[i];
  const auto         pull = [&facts](const Facts::Span &span) {
    const Tensor<1, 2> along = span.end - span.begin;
    return facts.strands * span.tension / along.norm() * along;
  };
  return pull(out) - pull(in);
}
} // namespace

void draw(std::ostream &out, const Drive &drive, const Facts &facts)
{
  const Layout &layout = drive.layout;
  double        left = 1e9, right = -1e9, low = 1e9, high = -1e9, most_load = 0.;
  const auto    see = [&](const Point<2> &p, const double around) {
    left  = std::min(left, p[0] - around);
    right = std::max(right, p[0] + around);
    low   = std::min(low, p[1] - around);
    high  = std::max(high, p[1] + around);
  };
  for (std::size_t i = 0; i < drive.sprockets.size(); ++i)
    {
      see(layout.sprockets[i].centre, 0.5 * drive.sprockets[i].form.outside_diameter);
      most_load = std::max(most_load, load_on(facts, i).norm());
    }
  for (const Layout::Joint &joint : layout.joints)
    see(joint.roller, drive.chain.roller_diameter);
  const std::optional<Tensioner> &held = layout.clamped ? layout.clamped : layout.tensioner;
  if (held && held->is_arm())
    see(held->pivot, 0.);
  for (const auto &[wheel, swing] : drive.swings)
    for (const double turned : {swing.least, swing.most})
      {
        see(swing.pivot, 0.);
        see(swing.centre(layout.sprockets[wheel].centre, turned),
            0.5 * drive.sprockets[wheel].form.outside_diameter);
      }
  for (const Guide &guide : drive.guides)
    if (guide.held && guide.held->is_arm())
      see(guide.held->pivot, 0.);
  const double size = std::max(right - left, high - low), letter = 0.022 * size;
  const double margin = 4. * letter;

  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"" << mm(left - margin) << ' '
      << mm(0. - high - margin) << ' ' << mm(right - left + 2. * margin) << ' '
      << mm(high - low + 2. * margin) << "\" font-family=\"sans-serif\">\n"
      << "  <title>" << facts.chain << ", " << facts.links << " links</title>\n"
      << "  <style>path, circle { fill: none; stroke: #333; stroke-width: " << mm(0.002 * size)
      << " } .wheel { fill: #e8ecef } .chain { stroke: #1c6aa8 } .load { stroke: #b3261e; "
      << "stroke-width: " << mm(0.004 * size)
      << " } .tensioner { stroke: #8a5a00; stroke-width: " << mm(0.004 * size)
      << " } .guide { stroke: #6a3d9a; stroke-width: " << mm(0.004 * size)
      << " } .sense { stroke: #2d7d46 } text { paint-order: stroke; "
      << "stroke: #fff; stroke-linejoin: round; stroke-width: " << mm(0.2 * letter)
      << " }</style>\n";

  for (std::size_t i = 0; i < drive.sprockets.size(); ++i)
    {
      const Layout::Sprocket &wheel    = layout.sprockets[i];
      const Sprocket         &sprocket = drive.sprockets[i];
      const Point<2>          axis     = wheel.axis();
      out << "  <path class=\"wheel\" d=\"M";
      const char *between = "";
      for (const Point<2> &p : sprocket.form.polyline(4))
        {
          out << between << at(turned(p, wheel.angle, wheel.centre));
          between = "L";
        }
      out << "Z\"/>\n  <circle cx=\"" << mm(axis[0]) << "\" cy=\"" << mm(0. - axis[1]) << "\" r=\""
          << mm(0.5 * sprocket.bore) << "\"/>\n";
    }

  out << "  <path class=\"chain\" d=\"";
  for (std::size_t k = 0; k < layout.joints.size(); ++k)
    out << (k == 0 ? "M" : "L") << at(layout.joints[k].bush);
  out << "Z\"/>\n";
  for (const Layout::Joint &joint : layout.joints)
    out << "  <circle class=\"chain\" cx=\"" << mm(joint.roller[0]) << "\" cy=\""
        << mm(0. - joint.roller[1]) << "\" r=\"" << mm(0.5 * drive.chain.roller_diameter)
        << "\"/>\n";

  for (const Guide &guide : drive.guides)
    out << line_of(guide, letter, drive.strands);
  if (held)
    out << track_of(*held, letter, drive.strands);
  for (const auto &[wheel, swing] : drive.swings)
    out << track_of(swing, layout.sprockets[wheel].centre, letter);
  for (std::size_t i = 0; i < facts.spans.size(); ++i)
    {
      const Layout::Span &span = layout.spans[i];
      out << text_beside(layout.joints[(span.first + span.links / 2) % layout.joints.size()].bush,
                         span.normal,
                         0.5 * drive.chain.roller_diameter + 0.4 * letter,
                         0.8 * letter,
                         to_text(facts.spans[i].tension, 4) +
                             (facts.strands == 1    ? " N" :
                              is_out_of_line(drive) ? " N in a strand in the mean" :
                                                      " N in each strand"));
    }
  for (std::size_t i = 0; i < facts.sprockets.size(); ++i)
    {
      const Facts::Sprocket &wheel = facts.sprockets[i];
      const Tensor<1, 2>     load  = load_on(facts, i);
      out << sense_of(wheel, letter);
      if (load.norm() > 1e-3 * most_load && most_load > 0.)
        {
          const Tensor<1, 2> by    = 6. * letter / most_load * load;
          const double       head  = std::min(letter, 0.5 * by.norm());
          const std::string  words = to_text(load.norm(), 4) + " N";
          out << arrow(wheel.centre + by, by, head, "load")
              << (by.norm() < 2.5 * letter ? // else it would lie on the name below
                      text(Point<2>(wheel.centre[0], wheel.centre[1] + 0.8 * letter),
                           0.8 * letter,
                           words) :
                      text_beside(wheel.centre + by,
                                  load / load.norm(),
                                  0.3 * letter,
                                  0.8 * letter,
                                  words));
        }
      out << text(Point<2>(wheel.centre[0], wheel.centre[1] - 1.2 * letter), letter, wheel.name);
    }
  out << "</svg>\n";
}
} // namespace chaindrive::drive
