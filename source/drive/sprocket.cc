// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/sprocket.h>
#include <chaindrive/drive/tooth_index.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>

namespace chaindrive::drive
{
Sprocket make_sprocket(const unsigned int           number,
                       const parameters::Sprockets &sprockets,
                       const ChainDimensions       &chain,
                       const std::optional<double> &driven_inertia,
                       const double                 share)
{
  const parameters::Sprocket &given = sprockets.list[number];
  Sprocket                    sprocket;
  sprocket.name       = given.name;
  sprocket.title      = given.in_words();
  sprocket.in_entries = given.in_entries();
  sprocket.role       = given.role;
  sprocket.flat       = given.flat;
  sprocket.form       = given.is_flat() ? make_drum(chain, sprockets, number) :
                                          make_tooth_form(given.teeth, chain, sprockets, number);
  if (const std::vector<double> index = index_deviations(given); !index.empty())
    {
      sprocket.form.shift_gaps(index);
      sprocket.form.derived.push_back(in_words(sprocket.title, index));
    }
  sprocket.mesh           = given.mesh;
  sprocket.axial_offset   = given.axial_offset;
  sprocket.tilt           = given.tilt;
  sprocket.tilt_direction = given.tilt_direction;
  sprocket.given_inertia =
      given.name == sprockets.driven().name && driven_inertia ? driven_inertia : given.inertia;
  if (sprocket.given_inertia)
    *sprocket.given_inertia *= share;
  const double root     = sprocket.form.root_diameter;
  sprocket.bore         = given.bore.value_or(root / 3.);
  sprocket.hub_diameter = given.hub_diameter.value_or(std::max(sprocket.bore, 0.6 * root));
  return sprocket;
}

void check_hub(const Sprocket             &sprocket,
               const parameters::Sprocket &given,
               std::vector<std::string>   &notes)
{
  const std::string name = given.in_entries();
  const double      bore = sprocket.bore, hub = sprocket.hub_diameter,
               root = sprocket.form.root_diameter;
  if (!given.bore)
    notes.push_back(name + " bore " + in_mm(bore, 5) + ", a third of the root diameter.");
  if (!given.hub_diameter)
    notes.push_back(name + " rigid zone up to the diameter " + in_mm(hub, 5) + ".");
  if (!(bore > 0. && bore <= hub && hub < root))
    throw InputError("Drive/Sprockets: " + name + " bore " + in_mm(bore, 5) + " and hub diameter " +
                     in_mm(hub, 5) +
                     " must be positive, the bore not larger than the hub, the hub "
                     "smaller than the root diameter " +
                     in_mm(root, 5) + ".");
}
} // namespace chaindrive::drive
