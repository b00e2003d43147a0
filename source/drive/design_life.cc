// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/design_life.h>
#include <chaindrive/drive/strands.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <optional>
#include <ostream>

namespace chaindrive::drive
{
namespace
{
/// What the standard lists.
std::optional<double> listed_strength(const ChainDimensions &chain)
{
  return has_own_dimensions(chain) ? std::nullopt : minimum_dynamic_strength(chain.designation);
}

/// The force of the chain that makes the range hole_strength() at the hole of one of its plates.
double strength_of_holes(const ChainDimensions &chain, const HoleFactors &holes)
{
  const auto force = [&chain](const Plate &plate, const double factor) {
    return 2. * hole_strength(chain.pitch) * (plate.height - plate.hole_diameter) *
           plate.thickness / factor;
  };
  return std::min(force(inner_plate(chain), holes.inner), force(outer_plate(chain), holes.outer));
}

std::string text_of(const StrengthFrom from)
{
  return from == StrengthFrom::standard ? "ISO 606" :
         from == StrengthFrom::area     ? "area of plates" :
                                          "stress at holes";
}

std::string in_mpa(const double stress) { return to_text(1e-6 * stress, 3); }
} // namespace

std::string in_hours(const double hours)
{
  return !std::isfinite(hours) ? "endless" :
         hours < 1000.         ? to_text(hours, hours < 100. ? 2 : 3) + " h" :
         hours > 1e6           ? "more than 1000000 h" :
                                 std::to_string(100 * std::lround(0.01 * hours)) + " h";
}

PlateFatigue plate_fatigue(const ChainDimensions &chain, const std::optional<HoleFactors> &holes)
{
  const CatalogueChain *row    = find_chain(chain.designation);
  const auto            listed = listed_strength(chain);
  return {listed ? *listed :
          holes  ? strength_of_holes(chain, *holes) :
                   dynamic_strength_of_plates(chain.pitch,
                                             chain.inner_plate_height,
                                             chain.inner_plate_thickness,
                                             chain.roller_diameter,
                                             chain.pin_diameter),
          row != nullptr && !has_own_dimensions(chain) ? row->tensile_strength : 0.};
}

DesignLife design_life(const Facts                      &facts,
                       const ChainDimensions            &chain,
                       const bool                        kept,
                       const std::optional<HoleFactors> &holes)
{
  const double      n_links = facts.links;
  DesignLife        life{};
  double            force_angle = 0., least = endless, most = 0.;
  unsigned int      largest = 0, smallest = 0;
  double            fastest = 0.; // of the loaded sprockets and the driver
  const std::size_t n       = facts.sprockets.size();
  // of the strand that pulls most of what loads add to the tension of the slack span
  const double more       = uneven_share(facts.strands);
  const auto   tension_of = [&](const std::size_t span) {
    const double tension = facts.spans[span].tension;
    return tension + (more - 1.) * (tension - facts.slack().tension);
  };
  for (std::size_t i = 0; i < n; ++i)
    {
      const Facts::Sprocket &sprocket = facts.sprockets[i];
      const double           tension  = tension_of(i);
      const double           turn     = sprocket.teeth > 0 ?
                                            2. * dealii::numbers::PI / sprocket.teeth :
                                            2. * std::asin(facts.loaded_pitch / sprocket.pitch_diameter);
      force_angle += turn * (tension + tension_of((i + n - 1) % n));
      least   = std::min(least, tension);
      most    = std::max(most, tension);
      largest = std::max(largest, sprocket.teeth);
      if (!sprocket.idle && (smallest == 0 || sprocket.teeth < smallest))
        {
          smallest = sprocket.teeth;
          fastest  = sprocket.speed;
        }
    }
  life.lubrication = least_lubrication(facts.pitch, facts.chain_speed);
  life.joints      = {facts.loaded_pitch, chain.pin_diameter, facts.bearing_area, n_links};
  life.elongation  = most_elongation(largest, kept);
  life.wear_rate   = life.joints.rate(force_angle, facts.tooth_frequency);
  const auto hours = [](const double seconds) { return seconds / 3600.; };
  life.wear_hours  = life.wear_rate > 0. ? hours(life.elongation / life.wear_rate) : endless;
  life.frame_hours = facts.power > 0. ?
                         frame_hours(facts.rated_power / facts.power, life.elongation, n_links) :
                         endless;

  life.plates                = plate_fatigue(chain, holes);
  life.dynamic_strength      = life.plates.dynamic_strength;
  life.strength_from         = listed_strength(chain) ? StrengthFrom::standard :
                               holes                  ? StrengthFrom::hole_stress :
                                                        StrengthFrom::area;
  const PlateFatigue &plates = life.plates;
  const double        range  = plates.from_zero(least, most);
  life.newer_power           = 0.805 * std::pow(fastest * 30. / dealii::numbers::PI, -0.04) *
                     plates.dynamic_strength * facts.chain_speed * strand_factor(facts.strands);
  life.plate_safety   = range > 0. ? plates.endurance() / range : endless;
  const auto hours_of = [&](const PlateFatigue &some) {
    return facts.tooth_frequency > 0. ?
               hours(some.cycles(least, most) * n_links / facts.tooth_frequency) :
               endless;
  };
  life.plate_hours      = hours_of(plates);
  life.plate_early      = hours_of(plates.weaker(2.));
  life.plate_late       = hours_of(plates.weaker(-2.));
  const Ratings ratings = ratings_of(facts.chain,
                                     facts.pitch,
                                     smallest,
                                     fastest * 30. / dealii::numbers::PI,
                                     more * facts.effective_tension);
  life.roller_hours =
      facts.power > 0. ?
          hours_of_rollers(ratings.rollers(), facts.power / strand_factor(facts.strands), n_links) :
          endless;
  life.capacity =
      facts.power > 0. ? ratings.rollers() * strand_factor(facts.strands) / facts.power : 0.;
  life.tension       = most;
  life.pressure      = facts.joint_pressure;
  life.galling_speed = facts.highest_speed;

  const auto stress = [most, &chain](const Plate &plate, const std::optional<double> factor) {
    return plate_stress(most,
                        plate.height,
                        chain.waist_ratio * plate.height,
                        plate.hole_diameter,
                        plate.thickness,
                        factor);
  };
  const auto factor_of = [&holes](double HoleFactors::*one) {
    return holes ? std::make_optional((*holes).*one) : std::nullopt;
  };
  life.inner        = stress(inner_plate(chain), factor_of(&HoleFactors::inner));
  life.outer        = stress(outer_plate(chain), factor_of(&HoleFactors::outer));
  life.holes_solved = holes.has_value();
  life.pin =
      pin_stress(most, chain.pin_diameter, chain.pin_bore, chain.pin_length, chain.bush_length);
  return life;
}

files::Json to_json(const DesignLife &life)
{
  files::Json json;
  json["lubrication"]      = parameters::text_of(life.lubrication);
  json["elongation"]       = life.elongation;
  json["wear_rate"]        = life.wear_rate;
  json["dynamic_strength"] = life.dynamic_strength;
  json["newer_power"]      = life.newer_power;
  json["strength_from"]    = text_of(life.strength_from);
  json["holes_from"]       = life.holes_solved ? "elastic solutions" : "formula";
  for (const auto &[name, value] : {std::make_pair("wear_hours", life.wear_hours),
                                    std::make_pair("frame_hours", life.frame_hours),
                                    std::make_pair("plate_safety", life.plate_safety),
                                    std::make_pair("plate_hours", life.plate_hours),
                                    std::make_pair("plate_hours_early", life.plate_early),
                                    std::make_pair("plate_hours_late", life.plate_late),
                                    std::make_pair("roller_hours", life.roller_hours)})
    if (std::isfinite(value)) // what is endless is left out
      json[name] = value;
  for (const auto &[name, stress] :
       {std::make_pair("inner_plate", life.inner), std::make_pair("outer_plate", life.outer)})
    json[name] = {{"waist", stress.waist}, {"net", stress.net}, {"hole", stress.hole}};
  json["pin"] = {{"bending", life.pin.bending}, {"shear", life.pin.shear}};
  return json;
}

std::vector<files::Described> described_life()
{
  std::vector<files::Described> all = {
      {"life/lubrication", "", "least that the speed asks for"},
      {"life/elongation", "1", "elongation at which the chain is replaced"},
      {"life/wear_rate", "1/s", "elongation per second by wear, closed form"},
      {"life/wear_hours", "h", "hours until that elongation, closed form"},
      {"life/frame_hours", "h", "the same in the frame of ISO 10823"},
      {"life/dynamic_strength", "N", "minimum dynamic strength of the chain"},
      {"life/newer_power",
       "W",
       "what newer editions of ASME B29.1 let plates of this strength carry, by a fit"},
      {"life/strength_from",
       "",
       "where that is from: ISO 606, the stress at the plates' holes, or the area of plates"},
      {"life/holes_from", "", "where stresses at holes are from: elastic solutions or a formula"},
      {"life/plate_safety", "1", "endurance of the plates over their load"},
      {"life/plate_hours", "h", "mean hours until plates fail"},
      {"life/plate_hours_early", "h", "the same of plates that are two deviations weaker"},
      {"life/plate_hours_late", "h", "the same of plates that are two deviations stronger"},
      {"life/certainty/*/low", "h", "hours of the run at the low end of their 95 % interval"},
      {"life/certainty/*/high", "h", "at its high end; none where that is endless"},
      {"life/certainty/*/batches",
       "1",
       "part of the interval that the run itself makes, as a factor less one"},
      {"life/roller_hours", "h", "hours until rollers or bushes fail"},
      {"life/pin/bending", "Pa", "largest bending stress of a pin"},
      {"life/pin/shear", "Pa", "mean shear stress of a pin"},
      {"life/simulated_wear_rate",
       "1/s",
       "elongation per second of the friction work in the window"},
      {"life/simulated_wear_hours", "h", "hours until that elongation by this rate"},
      {"life/simulated_roller_hours",
       "h",
       "hours until rollers or bushes fail, by the peaks of impacts on the driver"},
      {"life/impacts/peak", "N", "peak that does the damage of these impacts"},
      {"life/impacts/rated_peak", "N", "their mean at the rated power of rollers and bushes"},
      {"life/fatigue/pin/bending", "Pa", "range of the bending stress of a pin, largest"},
      {"life/fatigue/pin/pressure", "Pa", "pressure between pin and bush, largest"}};
  for (const std::string plate : {"life/fatigue/inner_plate", "life/fatigue/outer_plate"})
    for (const auto &[name, meaning] :
         {std::make_pair("waist", "largest range of the mean stress of the waist"),
          std::make_pair("hole", "largest range of the stress at the edge of the hole")})
      all.push_back({plate + "/" + name, "Pa", meaning});
  for (const std::string plate : {"life/inner_plate", "life/outer_plate"})
    for (const auto &[name, meaning] : {std::make_pair("waist", "mean stress of the waist"),
                                        std::make_pair("net", "mean stress beside the hole"),
                                        std::make_pair("hole", "largest stress at its edge")})
      all.push_back({plate + "/" + name, "Pa", meaning});
  return all;
}

void print(std::ostream &out, const DesignLife &life)
{
  const auto line = [&out](const char *name, const std::string &text) {
    out << "  " << std::left << std::setw(18) << name << std::right << text << '\n';
  };
  out << "Life without shocks, closed forms (doc/theory.md, section 9)\n";
  line("wear",
       to_text(100. * life.elongation, 3) + " % after " + in_hours(life.wear_hours) + " (" +
           in_hours(life.wear_hours / wear_scatter) + " ... " +
           in_hours(life.wear_hours * wear_scatter) + "); frame of ISO 10823 " +
           in_hours(life.frame_hours) + "; lubrication " + parameters::text_of(life.lubrication) +
           " or better, without oil 1/" +
           to_text(wear_factor(Lubrication::none, life.lubrication, 0.), 2) + " of that");
  line("plates",
       "dynamic strength " + to_text(life.dynamic_strength, 4) + " N" +
           (life.strength_from == StrengthFrom::standard ?
                "" :
                " (by the " + text_of(life.strength_from) + ")") +
           (std::isfinite(life.plate_safety) ? ", safety " + to_text(life.plate_safety, 3) : "") +
           ", " + in_hours(life.plate_hours) +
           (std::isfinite(life.plate_early) ? " (19 of 20 chains " + in_hours(life.plate_early) +
                                                  " ... " + in_hours(life.plate_late) + ")" :
                                              "") +
           ", newer ratings " + to_text(1e-3 * life.newer_power, 3) + " kW; at the hole inside " +
           in_mpa(life.inner.hole) + ", outside " + in_mpa(life.outer.hole) +
           (life.holes_solved ? "" : " (formula)") + ", at the waist " + in_mpa(life.inner.waist) +
           " and " + in_mpa(life.outer.waist) + " MPa");
  line("rollers, bushes",
       in_hours(life.roller_hours) + " of impacts; of their scatter nothing is known");
  line("pins",
       "bending " + in_mpa(life.pin.bending) + ", shear " + in_mpa(life.pin.shear) + " MPa");
}
} // namespace chaindrive::drive
