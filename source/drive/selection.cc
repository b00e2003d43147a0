// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/catalogue.h>
#include <chaindrive/drive/chain.h>
#include <chaindrive/drive/rules_of_thumb.h>
#include <chaindrive/drive/selection.h>
#include <chaindrive/utilities/option_range.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>
#include <ostream>
#include <tuple>
#include <utility>

namespace chaindrive::drive
{
using dealii::numbers::PI;

namespace
{
// Rules of thumb, as those of rules_of_thumb.h.
constexpr double       most_pitches     = 80.; // of the centre distance
constexpr double       most_ratio_error = 0.03;
constexpr unsigned int largest_sprocket = 120;

/// Number of links and centre distance in pitches for sprockets of these teeth about @p wanted
/// pitches apart, with an even number of links (Shigley, chapter 17).
std::pair<unsigned int, double>
links_and_centre(const double z1, const double z2, const double wanted)
{
  const double step  = std::pow((z2 - z1) / (2. * PI), 2);
  const double exact = 2. * wanted + 0.5 * (z1 + z2) + step / wanted;
  const auto   links = 2 * static_cast<unsigned int>(std::lround(0.5 * exact));
  const double a     = 0.5 * (z1 + z2) - links;
  return {links, 0.25 * (-a + std::sqrt(std::max(0., a * a - 8. * step)))};
}

class Judge
{
public:
  Judge(const Demand &demand, const CatalogueChain &row)
      : demand_(demand), row_(row), mass_per_metre_(row.mass_per_metre)
  {
    parameters::Chain chain;
    chain.designation = row.designation;
    chain_            = make_chain(chain);
  }

  /// Empty where the sprockets would overlap or the chain does not reach.
  std::optional<Candidate>
  operator()(const unsigned int strands, const unsigned int z1, const unsigned int z2) const
  {
    Candidate    c{};
    const double p = row_.pitch, share = strand_factor(strands);
    const auto [links, pitches] = links_and_centre(z1, z2, demand_.centre_distance / p);
    c.chain                     = row_.designation;
    c.strands                   = strands;
    c.driver_teeth              = z1;
    c.driven_teeth              = z2;
    c.links                     = links;
    c.centre_distance           = pitches * p;
    const double r1 = 0.5 * p / std::sin(PI / z1), r2 = 0.5 * p / std::sin(PI / z2);
    // overlap, or what is asked for is too near for the formula
    if (!(c.centre_distance > r1 + r2 + 2. * p) ||
        std::abs(c.centre_distance - demand_.centre_distance) > 1.5 * p)
      return {};
    const double frequency = z1 * demand_.speed / (2. * PI); // pitches in a second
    const double speed     = p * frequency;
    c.chain_speed          = speed;
    c.lubrication          = least_lubrication(p, speed);

    const double  factor  = service_factor(demand_.motor, demand_.shock);
    const double  force   = demand_.power / speed / share; // of the strand that pulls most
    const double  flung   = mass_per_metre_ * speed * speed;
    const double  small   = std::min(z1, z2);
    const double  rpm     = demand_.speed * 30. / PI * z1 / small;
    const Ratings ratings = ratings_of(c.chain, p, small, rpm, force * factor);
    const double  strand  = demand_.power * factor / share; // W
    c.capacity            = ratings.power() / strand;
    c.breaking            = row_.strength_of(strands) /
                 (demand_.power / speed * factor + strands * flung); // of all strands
    const double area = chain_.pin_diameter * (chain_.bush_length + chain_.inner_plate_thickness);
    c.pressure        = (force + flung) / area;

    const PlateFatigue plates{minimum_dynamic_strength(c.chain).value_or(
                                  dynamic_strength_of_plates(p,
                                                             row_.inner_plate_height,
                                                             row_.inner_plate_thickness,
                                                             row_.roller_diameter,
                                                             row_.pin_diameter)),
                              row_.tensile_strength};
    const double       turns = frequency / links * 3600.; // of the chain in an hour
    const double       top   = force * factor + flung;
    c.dynamic                = plates.endurance() / plates.from_zero(flung, top);
    c.plate_hours            = plates.cycles(flung, top) / turns;
    c.roller_hours           = hours_of_rollers(ratings.rollers(), strand, links);

    // pulled at one side of each sprocket, flung at both
    const double    angle = 2. * PI / z1 + 2. * PI / z2;
    const JointWear wear{p, chain_.pin_diameter, area, static_cast<double>(links)};
    const double    most = most_elongation(std::max(z1, z2));
    const double    faster =
        wear_factor(demand_.lubrication.value_or(c.lubrication), c.lubrication, speed);
    c.wear_hours  = most / (faster * wear.rate((force + 2. * flung) * angle, frequency)) / 3600.;
    c.frame_hours = frame_hours(c.capacity, most, links) / faster;

    const double              w2      = demand_.speed * z1 / z2;
    const std::vector<double> impacts = {impact_speed(p, z1, demand_.speed),
                                         impact_speed(p, z2, w2)};
    c.impact                          = std::max(impacts[0], impacts[1]);
    c.sound = sound_estimate(mass_per_metre_ * p * strands, impacts, frequency);
    c.mass  = strands * (mass_per_metre_ * p * links +
                        7850. * 0.95 * row_.inner_width * PI * (r1 * r1 + r2 * r2));
    find_faults(c, ratings, r1, r2);
    return c;
  }

private:
  void find_faults(Candidate &c, const Ratings &ratings, const double r1, const double r2) const
  {
    const auto add = [&c](const bool is_fault, const std::string &sentence) {
      if (is_fault)
        c.faults.push_back(sentence);
    };
    const auto   text = [](const double x) { return to_text(x, 3); };
    const double wrap = PI - 2. * std::asin(std::abs(r2 - r1) / c.centre_distance);
    add(c.capacity < 1., "carries only " + text(100. * c.capacity) + " % of the power");
    add(c.breaking < least_safety,
        "breaking safety " + text(c.breaking) + ", below " + text(least_safety));
    add(c.dynamic < 1. && c.plate_hours < demand_.hours,
        "plates last " + text(c.plate_hours) + " h");
    add(c.roller_hours < demand_.hours, "rollers last " + text(c.roller_hours) + " h");
    add(c.wear_hours < demand_.hours, "joints last " + text(c.wear_hours) + " h");
    add(c.pressure > usual_pressure,
        "joint pressure " + text(1e-6 * c.pressure) + " MPa, above " + text(1e-6 * usual_pressure));
    add(ratings.rpm > ratings.speed(), "joints gall above " + text(ratings.speed()) + " rpm");
    add(wrap < least_wrap,
        "wrap " + text(wrap * 180. / PI) + " degrees, below " + text(least_wrap * 180. / PI));
    add(c.centre_distance > most_pitches * row_.pitch, "centre distance above 80 pitches");
    add(demand_.lubrication && *demand_.lubrication < c.lubrication,
        "needs lubrication " + parameters::text_of(c.lubrication));
  }

  const Demand          demand_;
  const CatalogueChain &row_;
  const double          mass_per_metre_;
  ChainDimensions       chain_;
};

auto rank_of(const Candidate &c)
{
  const double size = c.mass * (0.9 + 0.1 * c.strands);
  return std::make_tuple(c.faults.size(), c.faults.empty() ? size : -c.capacity);
}
} // namespace

double Candidate::hours() const { return std::min({wear_hours, roller_hours, plate_hours}); }

double impact_speed(const double pitch, const double teeth, const double speed)
{
  const double degrees = 35. - 120. / teeth + 360. / teeth;
  return pitch * speed * std::sin(degrees * PI / 180.);
}

double
sound_estimate(const double mass, const std::vector<double> &impacts, const double per_second)
{
  const auto power = [](const double m, const std::vector<double> &all, const double rate) {
    double sum = 0.;
    for (const double impact : all)
      sum += 0.5 * m * impact * impact * rate;
    return sum;
  };
  constexpr double pitch = 25.4e-3, teeth = 16., level = 57.; // RS80 has 2.515 kg/m
  const double     speed = 123. * PI / 30., impact = impact_speed(pitch, teeth, speed);
  return level +
         10. * std::log10(power(mass, impacts, per_second) /
                          power(2.515 * pitch, {impact, impact}, teeth * speed / (2. * PI)));
}

std::vector<Candidate> select_drives(const Demand &demand)
{
  check_option("--kW", 1e-3 * demand.power, 1e-3, 1e6);
  check_option("--rpm", demand.speed * 30. / PI, 0.01, 9e5);
  check_option("--ratio", demand.ratio, 0.1, 10.);
  check_option("--centre", 1e3 * demand.centre_distance, 1., 1e5);
  check_option("--hours", demand.hours, 1., 1e6);
  check_option("--strands", demand.strands, 1, most_strands);
  std::map<std::pair<std::string, unsigned int>, Candidate> best; // by chain and strands
  for (const auto *table : {&iso_b_chains(), &iso_a_chains()})
    for (const CatalogueChain &row : *table)
      {
        const Judge judge(demand, row);
        for (unsigned int strands = 1; strands <= demand.strands; ++strands)
          for (unsigned int small = 13; small <= 31; small += 2)
            {
              const double       step  = std::max(demand.ratio, 1. / demand.ratio);
              const auto         large = static_cast<unsigned int>(std::lround(small * step));
              const unsigned int z1    = demand.ratio >= 1. ? small : large,
                                 z2    = demand.ratio >= 1. ? large : small;
              const double speed       = row.pitch * z1 * demand.speed / (2. * PI);
              if (large > largest_sprocket || (small < 17 && speed > 1.) ||
                  std::abs(large / (small * step) - 1.) > most_ratio_error)
                continue;
              const std::optional<Candidate> candidate = judge(strands, z1, z2);
              if (!candidate)
                continue;
              const auto place = best.emplace(std::make_pair(row.designation, strands), *candidate);
              if (rank_of(*candidate) < rank_of(place.first->second))
                place.first->second = *candidate;
            }
      }
  std::vector<Candidate> all;
  all.reserve(best.size());
  for (const auto &entry : best)
    all.push_back(entry.second);
  std::stable_sort(all.begin(), all.end(), [](const Candidate &a, const Candidate &b) {
    return rank_of(a) < rank_of(b);
  });
  return all;
}

void print(std::ostream                 &out,
           const Demand                 &demand,
           const std::vector<Candidate> &candidates,
           const unsigned int            rows)
{
  const double factor = service_factor(demand.motor, demand.shock);
  out << to_text(1e-3 * demand.power) << " kW at " << to_text(demand.speed * 30. / PI)
      << " rpm, ratio " << to_text(demand.ratio) << ", centre distance about "
      << to_text(1e3 * demand.centre_distance) << " mm, " << to_text(demand.hours)
      << " h; service factor " << to_text(factor) << " (motor " << parameters::text_of(demand.motor)
      << ", load " << parameters::text_of(demand.shock) << ")\n";
  const auto hours = [](const double value) {
    if (value > 99999.)
      return std::string("> 99999");
    return value < 100. ? to_text(value, 2) : std::to_string(100 * std::lround(0.01 * value));
  };
  const auto cell = [&out](const std::string &text, const int width) {
    out << std::setw(width) << text;
  };
  const std::pair<const char *, int> heads[] = {{"chain", 8},
                                                {"teeth", 8},
                                                {"links", 6},
                                                {"mm", 8},
                                                {"m/s", 6},
                                                {"oil", 7},
                                                {"kg", 7},
                                                {"power", 6},
                                                {"break", 6},
                                                {"plates", 7},
                                                {"wear h", 9},
                                                {"frame h", 9},
                                                {"rollers h", 10},
                                                {"impact", 7},
                                                {"dB(A)", 6}};
  for (const auto &[head, width] : heads)
    cell(head, width);
  out << '\n';
  for (std::size_t i = 0; i < std::min<std::size_t>(rows, candidates.size()); ++i)
    {
      const Candidate  &c       = candidates[i];
      const std::string texts[] = {c.chain + "-" + std::to_string(c.strands),
                                   std::to_string(c.driver_teeth) + "/" +
                                       std::to_string(c.driven_teeth),
                                   std::to_string(c.links),
                                   to_text(1e3 * c.centre_distance, 5),
                                   to_text(c.chain_speed, 3),
                                   parameters::text_of(c.lubrication),
                                   to_text(c.mass, 3),
                                   to_text(c.capacity, 3),
                                   to_text(c.breaking, 3),
                                   to_text(c.dynamic, 3),
                                   hours(c.wear_hours),
                                   hours(c.frame_hours),
                                   hours(c.roller_hours),
                                   to_text(c.impact, 3),
                                   to_text(c.sound, 3)};
      int               column  = 0;
      for (const std::string &text : texts)
        cell(text, heads[column++].second);
      if (!c.faults.empty())
        out << "  " << join(c.faults);
      out << '\n';
    }
}
} // namespace chaindrive::drive
