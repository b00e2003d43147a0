// SPDX-License-Identifier: LGPL-2.1-or-later
// Every boundary face of the parts belongs to its named surface: areas against the solids'.

#include <chaindrive/element/part_report.h>
#include <chaindrive/mesh/generate/links.h>
#include <chaindrive/mesh/generate/sprocket.h>

#include <iomanip>
#include <iostream>
#include <map>

using namespace chaindrive;

namespace
{
const double pi = dealii::numbers::PI;

void compare(const mesh::Part &part, const std::map<std::string, double> &exact)
{
  std::cout << part.name << ": areas of mesh / solid\n";
  for (const auto &side : element::make_report(part, Material()).sides)
    std::cout << "  " << side.name << ": "
              << (exact.count(side.name) ? side.area / exact.at(side.name) : -1.) << '\n';
}
} // namespace

int main()
{
  const auto chain = drive::make_chain(parameters::Chain());
  std::cout << std::fixed << std::setprecision(4);

  const auto ring = [](const double outside, const double bore) {
    return 0.25 * pi * (outside * outside - bore * bore);
  };
  compare(mesh::make_roller(chain, 7600., 4),
          {{"roller outside", pi * chain.roller_diameter * chain.roller_length},
           {"roller bore", pi * chain.roller_bore * chain.roller_length},
           {"roller ends", 2. * ring(chain.roller_diameter, chain.roller_bore)}});

  const auto link = [&](const bool inner) {
    const drive::Plate plate   = inner ? drive::inner_plate(chain) : drive::outer_plate(chain);
    const double       outside = inner ? chain.bush_diameter : chain.pin_diameter,
                 bore          = inner ? chain.bush_bore : chain.pin_bore,
                 length        = inner ? chain.bush_length : chain.pin_length;
    double perimeter           = 0.;
    for (const drive::Segment &segment : plate.outline())
      perimeter += segment.length();
    const double face                   = 2. * plate.area();
    const double shell                  = pi * outside * (length - plate.thickness),
                 hole                   = pi * bore * (length + plate.thickness);
    std::map<std::string, double> exact = {{"plate inner faces", face},
                                           {"plate outer faces", face},
                                           {"plate edges", 2. * perimeter * plate.thickness},
                                           {"other", 4. * ring(outside, bore)},
                                           {"pin bore", 2. * hole}};
    for (const std::string joint : {"first", "second"})
      {
        const std::string name                        = inner ? "bush" : "pin";
        exact[name + " outside, " + joint + " joint"] = shell;
        exact["bush bore, " + joint + " joint"]       = hole;
      }
    return exact;
  };
  compare(mesh::make_inner_link(chain, 7600., {64, 1, 4, 1, 2}), link(true));
  compare(mesh::make_outer_link(chain, 7600., {64, 1, 4, 1, 2}), link(false));

  const auto   form = drive::make_tooth_form(15, chain, parameters::Sprockets(), 0);
  const double bore = 25e-3, width = 7.2e-3;
  double       perimeter = 0.;
  for (const drive::Segment &segment : form.half_profile)
    perimeter += 30. * segment.length();
  compare(mesh::make_sprocket(form, {bore, 33e-3, width}, 7600., 2),
          {{"tooth flanks", perimeter * width},
           {"hub", pi * bore * width},
           {"sprocket sides", 2. * (form.area() - ring(bore, 0.))}});
}
