// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/chain.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace chaindrive::drive
{
namespace
{
/// The chain whose joint is documented in full: Table 2 of Zheng, Wang, Quek, Shock and Vibration
/// 11 (2004) 573-584, in m. Other sizes scale from it.
namespace reference
{
constexpr const char *designation     = parameters::reference_chain;
constexpr double      roller_diameter = 10.16e-3, roller_length = 7.00e-3;
constexpr double      bush_diameter = 7.43e-3, pin_diameter = 5.24e-3, pin_bore = 2.68e-3;
constexpr double      inner_width = 7.94e-3, plate_thickness = 2.0e-3, plate_gap = 0.5e-3;
constexpr double      clearance = 0.045e-3; // radial, of both joints, kept in every size
} // namespace reference

const CatalogueChain &look_up(const std::string &designation)
{
  if (const CatalogueChain *row = find_chain(designation))
    return *row;
  // makers write the number of strands behind the size: 08B-2
  const std::size_t dash = designation.rfind('-');
  if (dash != std::string::npos && dash + 1 < designation.size() &&
      designation.find_first_not_of("0123456789", dash + 1) == std::string::npos)
    if (const std::string size = designation.substr(0, dash); find_chain(size) != nullptr)
      throw InputError("Drive/Chain/Designation = " + designation +
                       ": the number of strands has an entry of its own. Choose Designation = " +
                       size + " and Strands = " + designation.substr(dash + 1) + ".");
  const std::vector<std::string> known   = chain_designations();
  const std::string              nearest = nearest_name(designation, known);
  std::string                    list;
  for (const std::string &name : known)
    list += (list.empty() ? "" : ", ") + name;
  throw InputError(
      "Drive/Chain/Designation = " + designation + " is not a chain this program knows" +
      (nearest.empty() ? "." : "; did you mean " + nearest + "?") + " Known are: " + list + ".");
}

/// Takes a value from its entry, else from the table, else from a rule, which it then states.
class Filler
{
public:
  Filler(std::vector<std::string> &derived, const std::string &designation)
      : derived_(derived), designation_(designation)
  {
  }

  double operator()(const std::string           &name,
                    const std::optional<double> &entry,
                    const double                 listed,
                    const double                 rule,
                    const std::string           &reason)
  {
    if (entry)
      return *entry;
    if (listed > 0.)
      return listed;
    derived_.push_back("Chain " + designation_ + ": " + name + " " + in_mm(rule, 5) + ", " +
                       reason + ".");
    return rule;
  }

private:
  std::vector<std::string> &derived_;
  std::string               designation_;
};

void require_inside(const std::string &inner_name,
                    const double       inner,
                    const std::string &outer_name,
                    const double       outer,
                    const std::string &what)
{
  if (!(inner < outer))
    throw InputError("Drive/Chain: " + inner_name + " = " + in_mm(inner, 5) + " and " + outer_name +
                     " = " + in_mm(outer, 5) + " leave " + what + " of " +
                     in_mm(0.5 * (outer - inner), 5) + "; the first must be less than the second.");
}

/// Walls of tubes thinner than a thousandth of their diameter are no parts of a chain, and the
/// vertices of their meshes would fall together.
void require_wall(const std::string &inner_name,
                  const double       inner,
                  const std::string &outer_name,
                  const double       outer,
                  const std::string &what)
{
  require_inside(inner_name, inner, outer_name, outer, what);
  if (outer - inner < 2e-3 * outer)
    throw InputError(
        "Drive/Chain: " + inner_name + " = " + to_text(inner * 1e3, 12) + " mm and " + outer_name +
        " = " + in_mm(outer, 5) + " leave " + what + " of " + in_mm(0.5 * (outer - inner), 5) +
        "; at least a thousandth of the diameter is accepted, " + in_mm(1e-3 * outer, 5) + ".");
}

void check(const ChainDimensions &c)
{
  for (const auto &[name, value] : {std::pair<const char *, double>{"Pitch", c.pitch},
                                    {"Roller length", c.roller_length},
                                    {"Pin diameter", c.pin_diameter},
                                    {"Inner plate thickness", c.inner_plate_thickness},
                                    {"Outer plate thickness", c.outer_plate_thickness}})
    if (!(value > 0.))
      throw InputError(std::string("Drive/Chain: ") + name + " = " + in_mm(value, 5) +
                       " must be positive.");

  if (c.has_rollers)
    require_wall(
        "Roller bore", c.roller_bore, "Roller diameter", c.roller_diameter, "a roller wall");
  require_wall("Bush bore", c.bush_bore, "Bush diameter", c.bush_diameter, "a bush wall");
  require_wall("Pin bore", c.pin_bore, "Pin diameter", c.pin_diameter, "a pin wall");
  require_inside("Bush diameter",
                 c.bush_diameter,
                 "Inner plate height",
                 c.inner_plate_height,
                 "beside the hole a strip");
  require_inside("Pin diameter",
                 c.pin_diameter,
                 "Outer plate height",
                 c.outer_plate_height,
                 "beside the hole a strip");
  require_inside(
      "Roller diameter", c.roller_diameter, "Pitch", c.pitch, "half a space between rollers");
  require_inside("Inner plate height",
                 c.inner_plate_height,
                 "Pitch",
                 c.pitch,
                 "half a space between neighbouring inner plates");
  require_inside("Outer plate height",
                 c.outer_plate_height,
                 "Pitch",
                 c.pitch,
                 "half a space between neighbouring outer plates");
  if (c.has_rollers)
    require_inside("Roller length",
                   c.roller_length,
                   "width between the inner plates",
                   c.inner_width,
                   "beside the roller a space");
  require_inside("outside of the inner plates",
                 2. * c.inner_plate_z + c.inner_plate_thickness,
                 "inside of the outer plates",
                 2. * c.outer_plate_z - c.outer_plate_thickness,
                 "between the plates a gap");
  if (!(c.waist_ratio > 0. && c.waist_ratio <= 1.))
    throw InputError("Drive/Chain/Waist ratio = " + to_text(c.waist_ratio) +
                     " must be greater than 0 and at most 1.");
}

/// Clearances must not be negative; where section Effects has none, the bore fits.
void set_clearances(ChainDimensions &c, const parameters::Effects &effects)
{
  using parameters::Switch;
  const auto set = [](const Switch       choice,
                      const std::string &inner_name,
                      const double       inner,
                      const std::string &outer_name,
                      double            &outer,
                      const std::string &what) {
    if (choice == Switch::off)
      outer = inner;
    else
      require_inside(inner_name, inner, outer_name, outer, what);
  };
  set(c.has_rollers ? effects.roller_bush_clearance : Switch::off,
      "Bush diameter",
      c.bush_diameter,
      "Roller bore",
      c.roller_bore,
      "a radial clearance between bush and roller");
  set(effects.bush_pin_clearance,
      "Pin diameter",
      c.pin_diameter,
      "Bush bore",
      c.bush_bore,
      "a radial clearance between pin and bush");
}

void set_hole_pitches(ChainDimensions &c, const parameters::Chain &chain)
{
  if (!(chain.elongation >= 0. && chain.elongation < 0.2))
    throw InputError("Drive/Chain/Elongation in percent = " + to_text(chain.elongation * 1e2) +
                     " must be at least 0 and less than 20.");
  const double longer = 1. + chain.elongation, clearance = 2. * c.pin_clearance();
  c.inner_hole_pitch = longer * c.pitch;
  c.outer_hole_pitch = chain.pitch_set == parameters::PitchSet::standard ?
                           longer * c.pitch - clearance :
                           longer * (c.pitch + clearance) - clearance;
}

/// What a bush chain asks for with entries of rollers, which it has not.
void refuse_rollers(const parameters::Chain &chain)
{
  const std::string no_rollers =
      ": a chain without rollers (Drive/Chain/Rollers) has nothing of the kind; choose ";
  if (chain.roller_bore)
    throw InputError("Drive/Chain/Roller bore in mm = " + to_text(1e3 * *chain.roller_bore) +
                     no_rollers + "auto.");
  if (chain.roller_length)
    throw InputError("Drive/Chain/Roller length in mm = " + to_text(1e3 * *chain.roller_length) +
                     no_rollers + "auto.");
  if (chain.roller_diameter && chain.bush_diameter &&
      *chain.roller_diameter != *chain.bush_diameter)
    throw InputError(
        "Drive/Chain/Roller diameter in mm = " + to_text(1e3 * *chain.roller_diameter) +
        " and Bush diameter in mm = " + to_text(1e3 * *chain.bush_diameter) +
        " are one in a chain without rollers (Drive/Chain/Rollers); choose auto for "
        "one of them.");
}
} // namespace

bool has_rollers(const parameters::Chain &chain)
{
  if (chain.rollers != parameters::Switch::automatic)
    return chain.rollers == parameters::Switch::on;
  const CatalogueChain *row = find_chain(chain.designation);
  return row == nullptr || row->has_rollers;
}

ChainDimensions make_chain(const parameters::Chain &chain, const parameters::Effects &effects)
{
  const CatalogueChain &row = look_up(chain.designation);
  ChainDimensions       c;
  Filler                fill(c.derived, row.designation);

  const bool documented = row.designation == reference::designation;
  c.designation         = row.designation;
  c.pitch               = chain.pitch.value_or(row.pitch);
  c.has_rollers         = has_rollers(chain);
  c.roller_diameter     = chain.roller_diameter.value_or(row.roller_diameter);
  if (!c.has_rollers)
    {
      refuse_rollers(chain);
      c.roller_diameter = chain.bush_diameter.value_or(c.roller_diameter);
    }
  c.waist_ratio               = chain.waist_ratio;
  const double      scale     = c.roller_diameter / reference::roller_diameter;
  const std::string scaled    = "scaled by the roller diameter from the reference chain's joint";
  const std::string clearance = "for the radial clearance 0.045 mm";
  if (!c.has_rollers)
    c.derived.push_back("Chain " + row.designation + " has no rollers: its bushes, diameter " +
                        in_mm(c.roller_diameter, 5) + ", meet the teeth.");

  // the joint, from the outside inwards; Table 2 holds in every digit for the reference chain
  const auto listed = [&](const double value) { return documented ? value : 0.; };
  if (c.has_rollers)
    {
      c.bush_diameter = fill("bush diameter",
                             chain.bush_diameter,
                             listed(reference::bush_diameter),
                             scale * reference::bush_diameter,
                             scaled);
      c.roller_bore   = fill("roller bore",
                           chain.roller_bore,
                           listed(reference::bush_diameter + 2. * reference::clearance),
                           c.bush_diameter + 2. * reference::clearance,
                           clearance);
    }
  else
    c.bush_diameter = c.roller_bore = c.roller_diameter;
  c.pin_diameter = fill("pin diameter",
                        chain.pin_diameter,
                        row.pin_diameter,
                        scale * reference::pin_diameter,
                        scaled);
  c.bush_bore    = fill("bush bore",
                     chain.bush_bore,
                     listed(reference::pin_diameter + 2. * reference::clearance),
                     c.pin_diameter + 2. * reference::clearance,
                     clearance);
  c.pin_bore     = chain.pin_bore.value_or(listed(reference::pin_bore));

  c.inner_plate_height    = fill("inner plate height",
                              chain.inner_plate_height,
                              row.inner_plate_height,
                              0.95 * c.pitch,
                              "0.95 of the pitch");
  c.outer_plate_height    = fill("outer plate height",
                              chain.outer_plate_height,
                              row.outer_plate_height,
                              0.82 * c.pitch,
                              "0.82 of the pitch");
  c.inner_plate_thickness = fill("inner plate thickness",
                                 chain.inner_plate_thickness,
                                 row.inner_plate_thickness,
                                 scale * reference::plate_thickness,
                                 scaled);
  c.outer_plate_thickness = fill("outer plate thickness",
                                 chain.outer_plate_thickness,
                                 row.outer_plate_thickness,
                                 scale * reference::plate_thickness,
                                 scaled);

  // the stack of parts along the pins
  c.bush_length      = chain.bush_length.value_or(row.inner_width + c.inner_plate_thickness);
  c.inner_width      = c.bush_length - c.inner_plate_thickness;
  c.inner_plate_z    = 0.5 * c.bush_length;
  c.roller_length    = !c.has_rollers ?
                           c.inner_width :
                           fill("roller length",
                             chain.roller_length,
                             listed(reference::roller_length),
                             c.inner_width * reference::roller_length / reference::inner_width,
                             "the reference chain's part of the inner width");
  const double gap   = scale * reference::plate_gap;
  const double stack = c.bush_length + c.inner_plate_thickness + c.outer_plate_thickness + 2. * gap;
  c.pin_length       = fill("pin length between plate mid-surfaces",
                      chain.pin_length,
                      listed(stack), // 14.94 mm in Table 2
                      stack,
                      "with a gap of " + in_mm(gap, 5) + " between inner and outer plates");
  c.outer_plate_z    = 0.5 * c.pin_length;

  if (chain.strands > 1)
    c.transverse_pitch = fill("transverse pitch",
                              chain.transverse_pitch,
                              transverse_pitch_of(row.designation),
                              c.pin_length + c.outer_plate_thickness + gap,
                              "two outer plates beside each other, " + in_mm(gap, 5) + " apart");

  set_clearances(c, effects);
  set_hole_pitches(c, chain);
  check(c);
  if (chain.strands > 1)
    require_inside("outside of the inner plates",
                   2. * c.inner_plate_z + c.inner_plate_thickness,
                   "Transverse pitch",
                   c.transverse_pitch,
                   "between two strands a gap");
  return c;
}

bool has_own_dimensions(const ChainDimensions &chain)
{
  parameters::Chain plain;
  plain.designation            = chain.designation;
  const ChainDimensions listed = make_chain(plain);
  const auto            values = [](const ChainDimensions &c) {
    return std::array<double, 10>{{c.pitch,
                                   c.roller_diameter,
                                   c.bush_diameter,
                                   c.pin_diameter,
                                   c.pin_bore,
                                   c.inner_plate_height,
                                   c.inner_plate_thickness,
                                   c.outer_plate_height,
                                   c.outer_plate_thickness,
                                   c.waist_ratio}};
  };
  const auto own = values(chain), of_table = values(listed);
  return chain.has_rollers != listed.has_rollers ||
         !std::equal(own.begin(), own.end(), of_table.begin(), [](const double a, const double b) {
           return std::abs(a - b) <= 1e-3 * b;
         });
}
} // namespace chaindrive::drive
