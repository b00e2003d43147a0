// SPDX-License-Identifier: LGPL-2.1-or-later

// Every value of the chain tables: pitch, roller, inner width, pin, plate heights inner and outer,
// plate thicknesses inner and outer (mm), strength of one to three strands (kN), mass (kg/m),
// transverse pitch (mm); 0: not listed. Then what the standards say of them: names count the pitch,
// and the width of motorcycle chains, in parts of an inch; ANSI B29.1 asks for 12500 lbf at a pitch
// of an inch and more with its square; a heavy chain differs by a 32nd of an inch and more in its
// plates; the same chain of two standards differs by roundings; all chains are of one steel, so
// that each breaks of its own weight at about the same length; of several strands each breaks at no
// more than a single one; and the solids that follow from a row have about the mass that makers
// list.

#include <chaindrive/drive/catalogue.h>

#include <cmath>
#include <functional>
#include <iostream>
#include <string>

using namespace chaindrive::drive;

namespace
{
constexpr double inch = 25.4e-3, lbf = 4.4482216;

/// Prints whether a statement holds for all rows of a table, and for which it does not.
void all(const std::string                                 &what,
         const std::vector<CatalogueChain>                 &table,
         const std::function<bool(const CatalogueChain &)> &holds)
{
  std::string wrong;
  for (const CatalogueChain &chain : table)
    if (!holds(chain))
      wrong += ' ' + chain.designation;
  std::cout << what << ": " << (wrong.empty() ? "yes" : "NO, not" + wrong) << '\n';
}

/// Whether two lengths are the same but for @p part of them; what is not listed differs from
/// nothing.
bool near(const double a, const double b, const double part)
{
  return a == 0. || b == 0. || std::abs(a - b) <= part * b;
}

bool same(const CatalogueChain &a, const CatalogueChain &b, const double part)
{
  return near(a.pitch, b.pitch, 1e-9) && near(a.roller_diameter, b.roller_diameter, 1e-9) &&
         near(a.inner_width, b.inner_width, part) && near(a.pin_diameter, b.pin_diameter, part) &&
         near(a.inner_plate_height, b.inner_plate_height, part) &&
         near(a.outer_plate_height, b.outer_plate_height, part) &&
         near(a.tensile_strength, b.tensile_strength, part);
}

void judge()
{
  const auto number   = [](const CatalogueChain &c) { return std::stoi(c.designation); };
  const auto is_heavy = [](const CatalogueChain &c) { return c.designation.back() == 'H'; };
  std::cout << "== what standards say\n";
  all("ANSI: pitch of so many eighths of an inch", ansi_chains(), [&](const auto &c) {
    return near(c.pitch, number(c) / 10 * inch / 8., 1e-9);
  });
  all("ANSI: 12500 lbf at an inch, but for 41", ansi_chains(), [&](const auto &c) {
    const double inches = c.pitch / inch;
    return near(
        c.tensile_strength, number(c) == 41 ? 1500. * lbf : 12500. * lbf * inches * inches, 2e-3);
  });
  all("ANSI: plates an eighth of the pitch thick", ansi_chains(), [&](const auto &c) {
    return number(c) == 41 || is_heavy(c) || near(c.inner_plate_thickness, c.pitch / 8., 0.07);
  });
  all("ANSI: plates of heavy chains thicker by 1/32 inch, of 200H 1/16 and of 240H 1/8",
      ansi_chains(),
      [&](const auto &c) {
        if (!is_heavy(c))
          return true;
        const CatalogueChain &standard = *find_chain(std::to_string(number(c)));
        const double          more     = number(c) == 240 ? 4. : number(c) == 200 ? 2. : 1.;
        return std::abs(c.inner_plate_thickness - standard.inner_plate_thickness -
                        more * inch / 32.) < 0.05e-3 &&
               c.pitch == standard.pitch && c.roller_diameter == standard.roller_diameter &&
               c.pin_diameter == standard.pin_diameter && c.inner_width == standard.inner_width &&
               c.tensile_strength == standard.tensile_strength;
      });
  for (const auto *table : {&iso_a_chains(), &iso_b_chains()})
    all("ISO 606: pitch of so many sixteenths of an inch, but for 085 and 05B",
        *table,
        [&](const auto &c) {
          const double sixteenths = c.designation == "085" ? 8. : number(c);
          return near(c.pitch, c.designation == "05B" ? 8e-3 : sixteenths * inch / 16., 1e-9);
        });
  all("ISO 606 A: an ANSI chain to 3 %, but for 085", iso_a_chains(), [&](const auto &c) {
    for (const CatalogueChain &other : ansi_chains())
      if (same(c, other, 0.03) && c.inner_plate_thickness == other.inner_plate_thickness)
        return true;
    return c.designation == "085";
  });
  all("motorcycle: pitch of so many eighths of an inch, but for 219",
      motorcycle_chains(),
      [&](const auto &c) {
        return near(c.pitch, number(c) == 219 ? 7.774e-3 : number(c) / 100 * inch / 8., 1e-9);
      });
  all("motorcycle: so many eightieths wide, but for 219, 428 and 532",
      motorcycle_chains(),
      [&](const auto &c) {
        if (number(c) == 219)
          return true;
        const double eightieths = number(c) == 428 ? 25. : number(c) == 532 ? 30. : number(c) % 100;
        return near(c.inner_width, eightieths * inch / 80., 1e-3);
      });
  all("motorcycle: rollers of a chain of ANSI or ISO 606, but for 219 and 532",
      motorcycle_chains(),
      [&](const auto &c) {
        for (const auto *table : {&ansi_chains(), &iso_b_chains()})
          for (const CatalogueChain &other : *table)
            if (c.pitch == other.pitch && c.roller_diameter == other.roller_diameter)
              return true;
        return c.designation == "532" || c.designation == "219";
      });
  all("bicycle: widths of 1/8 and 3/32 inch between the tooth and 5 % more",
      bicycle_chains(),
      [&](const auto &c) {
        const double tooth = (number(c) == 81 ? 1. / 8. : 3. / 32.) * inch;
        return c.inner_width >= tooth - 0.01e-3 && c.inner_width < 1.05 * tooth;
      });
  for (const auto *table :
       {&ansi_chains(), &iso_a_chains(), &iso_b_chains(), &bicycle_chains(), &motorcycle_chains()})
    {
      all("  several strands break at 0.85 to 1 of as many single ones, triplex as "
          "duplex to 2 %",
          *table,
          [](const auto &c) {
            const double of_two = c.strength_of(2) / 2., of_three = c.strength_of(3) / 3.;
            return c.strength_of(1) == c.tensile_strength && c.strength_of(6) == 6. * of_three &&
                   (c.tensile_strength == 0. ||
                    (of_two <= 1.005 * c.tensile_strength && of_two > 0.85 * c.tensile_strength &&
                     of_three <= 1.02 * of_two && of_three > 0.83 * c.tensile_strength));
          });
      all("  breaks of its weight at 2 to 3.2 km, but for the light 41 and 085 and for 80H",
          *table,
          [&](const auto &c) {
            const double length = c.tensile_strength / (c.mass_per_metre * 9.81);
            return c.mass_per_metre == 0. || c.designation == "41" || c.designation == "085" ||
                   c.designation == "80H" || (length > 2e3 && length < 3.2e3);
          });
      all("  strands apart by an inner link and 0.92 to 1.2 times two outer plates, but for 05B",
          *table,
          [](const auto &c) {
            const double apart = transverse_pitch_of(c.designation),
                         room  = apart - c.inner_width - 2. * c.inner_plate_thickness;
            return apart == 0. || c.designation == "05B" ||
                   (room > 1.84 * c.outer_plate_thickness && room < 2.4 * c.outer_plate_thickness);
          });
      // the outer plates of 085 are the estimate from its pitch
      all("  pin in its roller, plates in the pitch", *table, [&](const auto &c) {
        return c.pin_diameter < 0.76 * c.roller_diameter && c.roller_diameter < 0.7 * c.pitch &&
               (c.designation == "085" || c.outer_plate_height <= c.inner_plate_height) &&
               c.inner_plate_height <= 0.96 * c.pitch &&
               c.outer_plate_thickness <= c.inner_plate_thickness &&
               c.inner_plate_thickness < 0.2 * c.pitch;
      });
    }
}
} // namespace

int main()
{
  for (const auto &[name, table] :
       {std::pair<const char *, const std::vector<CatalogueChain> &>{"ANSI", ansi_chains()},
        {"ISO 606 A", iso_a_chains()},
        {"ISO 606 B", iso_b_chains()},
        {"bicycle", bicycle_chains()},
        {"motorcycle", motorcycle_chains()}})
    {
      std::cout << "== " << name << '\n';
      for (const CatalogueChain &c : table)
        {
          std::cout << c.designation;
          for (const double length : {c.pitch,
                                      c.roller_diameter,
                                      c.inner_width,
                                      c.pin_diameter,
                                      c.inner_plate_height,
                                      c.outer_plate_height,
                                      c.inner_plate_thickness,
                                      c.outer_plate_thickness})
            std::cout << ' ' << length * 1e3;
          std::cout << ' ' << c.tensile_strength * 1e-3 << ' ' << c.strength_of(2) * 1e-3 << ' '
                    << c.strength_of(3) * 1e-3 << ' ' << c.mass_per_metre << ' '
                    << transverse_pitch_of(c.designation) * 1e3
                    << (c.has_rollers ? "" : " rollerless") << '\n';
        }
    }
  judge();
}
