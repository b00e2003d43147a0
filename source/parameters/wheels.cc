// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/parameters/drive.h>
#include <chaindrive/parameters/entries.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/utilities.h>

#include <algorithm>

namespace chaindrive::parameters
{
namespace
{
constexpr std::size_t most_wheels = 50, longest_wheel_name = 30;

bool is_letter(const char c) { return c >= 'a' && c <= 'z'; }

/// What entries and results are called that have the names of wheels beside them: effects Elastic
/// links and Elastic rollers, history hubs/load_torque, statistics span_speed. Between two names
/// there is _to_ in that of a span.
bool is_taken(const std::string &name)
{
  return name == "links" || name == "rollers" || name == "load" || name == "span" ||
         name.find("_to_") != std::string::npos;
}

bool is_wheel_name(const std::string &name)
{
  return !name.empty() && name.size() <= longest_wheel_name && is_letter(name[0]) &&
         !is_taken(name) && std::all_of(name.begin(), name.end(), [](const char c) {
           return is_letter(c) || c == '_' || (c >= '0' && c <= '9');
         });
}

std::vector<std::string> names_in(const std::string &text)
{
  return dealii::Utilities::split_string_list(text, ',');
}

/// What is wrong with @p names, in a sentence; empty if nothing is.
std::string wrong_with(const std::vector<std::string> &names)
{
  for (std::size_t i = 0; i < names.size(); ++i)
    if (!is_wheel_name(names[i]))
      return "'" + names[i] + "' is no name of a wheel: small letters, digits and _, " +
             std::to_string(longest_wheel_name) +
             " at most, the first one a letter, but not links, rollers, load, span, nor _to_ in it";
    else if (std::find(names.begin(), names.begin() + i, names[i]) != names.begin() + i)
      return "'" + names[i] + "' is there twice";
  if (names.size() > most_wheels)
    return "there are at most " + std::to_string(most_wheels) + " wheels";
  if (names.empty() || names[0] != "driver")
    return "the first one must be the driver";
  if (std::find(names.begin(), names.end(), "driven") == names.end())
    return "the driven sprocket is missing";
  return "";
}

/// The entries of @p sprocket in Drive/Wheels; @p is_first, @p is_own: the driver, and one that
/// other sections do not describe.
void declare_wheel(Declarations &declarations,
                   Sprocket     &sprocket,
                   const bool    is_first,
                   const bool    is_own)
{
  const Subsection section(declarations, sprocket.name);
  if (is_own)
    {
      add_choice(declarations,
                 "Role",
                 text_of(sprocket.role),
                 {text_of(Role::driven), text_of(Role::idler)},
                 "driven: it turns as the chain pulls it against its torque in section Loads, and "
                 "power is split between all that are driven. idler: it turns freely.",
                 [&sprocket](const std::string &text) { sprocket.role = *value_of<Role>(text); });
      add(declarations, "Teeth", sprocket.teeth, 9, 500, "Number of its teeth.");
      add(declarations,
          "Inertia in kg m2",
          sprocket.inertia,
          unit::si,
          above(0., 1e6),
          "Of all that turns with it, or of what is behind its coupling. auto: the sprocket "
          "alone.");
    }
  if (!is_first)
    add_choice(declarations,
               "Side",
               sprocket.turn == 1 ? "inside" : "outside",
               {text_of(Side::inside), text_of(Side::outside)},
               "Whether it is inside of the chain's loop, or outside, where it turns against the "
               "others.",
               [&sprocket](const std::string &text) {
                 sprocket.turn = value_of<Side>(text) == Side::inside ? 1 : -1;
               });
  add_point(declarations,
            "Centre in mm",
            sprocket.centre,
            std::string("Of its axis, x and y, in a drive that turns counter-clockwise: with "
                        "Layout/Tight span = lower it is mirrored, y becomes -y. auto: ") +
                (is_first ? "the origin." :
                            "as far from the driver as Layout/Centre distance from says, in the "
                            "direction below; at most one wheel is found so."));
  if (!is_first)
    add_angle(
        declarations,
        "Direction in degrees",
        sprocket.direction,
        between(-180., 180.),
        "Where Centre in mm is auto: of the line from the driver to it, counter-clockwise from "
        "x.");
  add(declarations,
      "Runout in um",
      sprocket.runout,
      unit::micro,
      between(0., 10000.),
      "Radial runout of its teeth, the total indicator reading of a turn, as in ISO 606: twice the "
      "eccentricity of the pitch circle about the axis of the shaft. For wheels on bearings. "
      "Default: none.");
  add_angle(declarations,
            "Runout phase in degrees",
            sprocket.runout_phase,
            between(-360., 360.),
            "Where the teeth stand out the most at the start: direction from the axis to the "
            "centre of the pitch circle, counter-clockwise from x in a drive that turns "
            "counter-clockwise.");
  add(declarations,
      "Axial offset in mm",
      sprocket.axial_offset,
      unit::milli,
      between(-100., 100.),
      "Of its plane from that of the drive, towards those who see a drive with Layout/Tight span = "
      "upper turn counter-clockwise. What counts is how far wheels are out of line. Not in simple "
      "fidelity.");
  add_angle(
      declarations,
      "Tilt in degrees",
      sprocket.tilt,
      between(-5., 5.),
      "Of its axis from the normal of the drive's plane, about the centre of the wheel. Not in "
      "simple fidelity.");
  add_angle(
      declarations,
      "Tilt direction in degrees",
      sprocket.tilt_direction,
      between(-360., 360.),
      "To where its axis leans: counter-clockwise from x in a drive that turns "
      "counter-clockwise. Along the line of centres, 0 for most drives, the chain runs on and "
      "off askew to the wheel, by the tilt; across it, 90, both spans are offset, by the "
      "tilt times the radius.");
  add(declarations,
      "Index tolerance in um",
      sprocket.index_tolerance,
      unit::micro,
      between(0., 1000.),
      "Pitch errors of its teeth: each gap stands off its place along the pitch circle at random, "
      "evenly distributed between minus and plus this length. Rigid teeth. Default: none.");
  add(declarations,
      "Index seed",
      sprocket.index_seed,
      0,
      1000000000,
      "Which of the random wheels of that tolerance it is: the same number is, for as many teeth, "
      "the same wheel on every machine.");
  add(declarations,
      "Index deviations in um",
      sprocket.index_deviations,
      unit::micro,
      between(-1000., 1000.),
      "In place of a tolerance: by how much each gap stands off its place along the pitch circle, "
      "as measured (index deviation, ISO 1328-1), counter-clockwise positive, from one gap to the "
      "next counter-clockwise. As many as teeth, or a part of them that repeats. Rigid teeth. "
      "Default: all are in their places.");
  sprocket.bearing.declare(declarations);
  sprocket.coupling.declare(declarations);
  if (is_own)
    {
      sprocket.flat.declare(declarations);
      sprocket.held.declare(declarations);
    }
  if (!is_first)
    sprocket.swing.declare(declarations);
  sprocket.guide.declare(declarations, is_first);
}
} // namespace

void Flat::declare(Declarations &declarations)
{
  const Subsection section(declarations, "Flat");
  add(declarations,
      "Diameter in mm",
      diameter,
      unit::milli,
      above(0., 1e5),
      "Of a wheel without teeth, a drum or a flat pulley: an idler. none: the wheel has teeth.",
      "none");
  add(declarations,
      "Runs on",
      runs_on,
      "With what the chain lies on a wheel without teeth. rollers: it is narrower than the chain's "
      "inner width, and rollers roll on it; joints run on its diameter and that of a roller. "
      "plates: it is wider than the chain, and the round ends of the inner plates, the higher "
      "ones, lie on it; joints run on its diameter and the height of these plates.");
  add(declarations,
      "Friction coefficient",
      friction,
      unit::si,
      between(0., 2.),
      "Of rollers or plates on a wheel without teeth, by Coulomb's law: it is what turns the "
      "wheel. auto: Contact/Roller-tooth friction.");
  add(declarations,
      "Stiffness in N/m",
      stiffness,
      unit::si,
      above(0., 1e12),
      "Of the contact of what lies there of one joint with a wheel without teeth, where rollers "
      "are "
      "rigid or plates lie on it. auto: Contact/Roller-tooth stiffness in N/m.");
}
void Sprockets::set_order(const std::vector<std::string> &names)
{
  if (const std::string wrong = wrong_with(names); !wrong.empty())
    throw InputError(order_entry + " = " + join(names) + " is not allowed: " + wrong + ".");
  const Sprockets       defaults;
  std::vector<Sprocket> wheels;
  for (const std::string &name : names)
    {
      const auto known =
          std::find_if(defaults.list.begin(),
                       defaults.list.end(),
                       [&name](const Sprocket &sprocket) { return sprocket.name == name; });
      wheels.push_back(known != defaults.list.end() ? *known : Sprocket{name});
    }
  list = std::move(wheels);
}

void Sprockets::declare_wheels(Declarations &declarations)
{
  const Subsection section(declarations, "Wheels");
  std::string      names;
  for (const Sprocket &sprocket : list)
    names += (names.empty() ? "" : ", ") + sprocket.name;
  declarations.add(
      "Order of travel",
      names,
      "names of wheels separated by commas, each once, of small letters, digits and _ and with a "
      "letter in front, but not links, rollers, load, span, nor with _to_ in it; the first one "
      "driver, driven among them",
      "Over which wheels the chain runs, in the order in which it meets them; the slack span leads "
      "from the driver to the second one. Each has a section here and in Loads, those besides "
      "driver "
      "and driven sprocket with all that is to be said of them, which this entry comes before.",
      [](const std::string &text) { return wrong_with(names_in(text)).empty(); },
      [](const std::string &) {});
  for (Sprocket &sprocket : list)
    declare_wheel(declarations,
                  sprocket,
                  &sprocket == &list.front(),
                  sprocket.name != "driver" && sprocket.name != "driven");
}
} // namespace chaindrive::parameters
