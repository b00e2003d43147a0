// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/scene/scene.h>
#include <chaindrive/simulated_life.h>
#include <chaindrive/utilities/batch_means.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace chaindrive
{
namespace
{
constexpr std::size_t fewest_impacts = 4; // fewer tell nothing of their scatter

/// Adds the interval of @p hours, which the logarithms @p of_run and @p of_others widen: of batches
/// of the run, and of what is known of the material.
void add_interval(files::Json &life,
                  const char  *name,
                  const double hours,
                  const double of_run,
                  const double of_others)
{
  if (!std::isfinite(of_run)) // fewer than four batches
    return;
  const double factor     = std::exp(std::hypot(of_run, of_others));
  life["certainty"][name] = {{"low", hours / factor}, {"batches", std::expm1(of_run)}};
  if (std::isfinite(hours * factor))
    life["certainty"][name]["high"] = hours * factor;
}

/// The plates' interval: of their scatter, which is not even about the mean, and of the turns.
void add_plate_interval(files::Json &life)
{
  if (!life.contains("fatigue") || !life["fatigue"]["damage_uncertainty"].is_number() ||
      !life.contains("early_plate_hours"))
    return;
  const double damage = life["fatigue"]["damage"], spread = life["fatigue"]["damage_uncertainty"];
  if (!std::isfinite(spread))
    return;
  const double of_run = damage > 0. ? std::log1p(spread / damage) : 0.;
  const double early  = life["early_plate_hours"];
  files::Json  found  = {{"low", early * std::exp(-of_run)}, {"batches", std::expm1(of_run)}};
  if (life.contains("simulated_plate_hours"))
    {
      const double hours = life["simulated_plate_hours"];
      found["low"]       = hours * std::exp(-std::hypot(of_run, std::log(hours / early)));
      if (life.contains("late_plate_hours"))
        found["high"] =
            hours *
            std::exp(std::hypot(of_run, std::log(life["late_plate_hours"].get<double>() / hours)));
    }
  life["certainty"]["plates"] = found;
}

/// What the friction work of the joints of all @p strands in the window says of their wear.
void add_wear(files::Json             &values,
              const drive::DesignLife &life,
              const double             mu,
              const unsigned int       strands)
{
  const std::string joint = parameters::text_of(scene::Interface::bush_pin);
  if (!(mu > 0.) || !values.contains("losses") || !values["losses"].contains(joint))
    return;
  const files::Json &work = values["losses"][joint]["friction"];
  const double       time = values["window_energy"]["duration"];
  if (!work.is_number() || !std::isfinite(work.get<double>()) || !(time > 0.))
    return;
  // of separate strands the one that pulls most rubs most
  double share = 1. / strands;
  if (values.contains("strands") && values["strands"]["uneven"].is_number() &&
      std::isfinite(values["strands"]["uneven"].get<double>()))
    share *= values["strands"]["uneven"].get<double>();
  const double rate = life.joints.rate_of_losses(share * work.get<double>() / time, mu);
  values["life"]["simulated_wear_rate"] = rate;
  if (!(rate > 0.))
    return;
  const double hours                     = life.elongation / rate / 3600.;
  values["life"]["simulated_wear_hours"] = hours;
  const files::Json &loss                = values["losses"][joint];
  if (loss["uncertainty"].is_number() && loss["power"].is_number())
    add_interval(values["life"],
                 "wear",
                 hours,
                 std::log1p(loss["uncertainty"].get<double>() / loss["power"].get<double>()),
                 std::log(drive::wear_scatter));
}

/// Stresses, which are as the tension that makes them.
void add_stresses(files::Json &values, const drive::DesignLife &life)
{
  if (!values["life"].contains("fatigue") || !(life.tension > 0.))
    return;
  files::Json &fatigue = values["life"]["fatigue"];
  const double most    = fatigue["most"].get<double>() / life.tension,
               range   = most - fatigue["least"].get<double>() / life.tension;
  const auto ranges    = [range](const drive::PlateStress &stress) {
    return files::Json{{"waist", range * stress.waist}, {"hole", range * stress.hole}};
  };
  fatigue["inner_plate"] = ranges(life.inner);
  fatigue["outer_plate"] = ranges(life.outer);
  fatigue["pin"] = {{"bending", range * life.pin.bending}, {"pressure", most * life.pressure}};
}

/// Peak forces [N] of the impacts on the driver in the window.
std::vector<double> peaks_on_driver(const files::Json &values, const std::string &driver)
{
  std::vector<double> peaks;
  const files::Json  &start = values["window"]["start"], &end = values["window"]["end"];
  if (!values.contains("engagements") || !start.is_number() || !end.is_number())
    return peaks;
  for (const files::Json &one : values["engagements"])
    if (one["sprocket"] == driver && one["complete"].get<bool>() &&
        one["time"].get<double>() >= start.get<double>() &&
        one["time"].get<double>() <= end.get<double>())
      peaks.push_back(one["peak_force"]);
  return peaks;
}

void add_impacts(files::Json &values, const drive::DesignLife &life, const drive::Facts &facts)
{
  const std::vector<double> peaks = peaks_on_driver(values, facts.driver().name);
  if (peaks.size() < fewest_impacts || !(life.capacity > 0.))
    return;
  const double seat =
      drive::seat_force(facts.tight().tension - facts.centrifugal_tension, facts.driver().teeth);
  const drive::PeakLife found = drive::life_of_peaks(peaks, seat, life.capacity, facts.links);
  values["life"]["impacts"]   = {{"peak", found.peak}, {"rated_peak", found.rated}};
  if (!std::isfinite(found.hours))
    return;
  values["life"]["simulated_roller_hours"] = found.hours;
  // the same of parts of the window: of four impacts or more each
  std::vector<double> parts;
  const std::size_t   length = std::max(fewest_impacts, (peaks.size() + 19) / 20);
  for (auto end = peaks.begin(); std::size_t(peaks.end() - end) >= length;)
    {
      const auto begin = end;
      end += static_cast<std::ptrdiff_t>(length);
      parts.push_back(
          std::log(drive::life_of_peaks({begin, end}, seat, life.capacity, facts.links).hours));
    }
  add_interval(values["life"], "rollers", found.hours, uncertainty_of_mean(parts), 0.);
}
} // namespace

void add_simulated_life(files::Json             &values,
                        const drive::DesignLife &life,
                        const drive::Facts      &facts,
                        const double             mu)
{
  add_wear(values, life, mu, facts.strands);
  add_stresses(values, life);
  add_plate_interval(values["life"]);
  add_impacts(values, life, facts);
}

std::string simulated_life_in_words(const files::Json &life)
{
  const auto hours = [&life](const char *name) {
    return life.contains(name) ? drive::in_hours(life[name]) : "endless";
  };
  const auto mpa = [](const files::Json &stress) {
    return to_text(1e-6 * stress.get<double>(), 3);
  };
  // "(low ... high)", or that nobody knows
  const auto interval = [&life](const char *name) {
    if (!life.contains("certainty") || !life["certainty"].contains(name))
      return std::string(" (interval not known: fewer than four batches)");
    const files::Json &found = life["certainty"][name];
    return " (95 % " + drive::in_hours(found["low"]) + " ... " +
           (found.contains("high") ? drive::in_hours(found["high"]) : "endless") + ")";
  };
  std::string text;
  if (life.contains("simulated_wear_rate"))
    text += "  wear              " + to_text(100. * life["elongation"].get<double>(), 3) +
            " % after " + hours("simulated_wear_hours") + interval("wear") + " by friction work\n";
  if (life.contains("fatigue"))
    {
      const files::Json &fatigue = life["fatigue"];
      const double       pitches = fatigue["pitches"];
      text +=
          "  plates            " +
          (life.contains("simulated_plate_safety") ?
               "safety " + to_text(life["simulated_plate_safety"].get<double>(), 3) + ", " :
               std::string()) +
          hours("simulated_plate_hours") +
          (life.contains("early_plate_hours") ? interval("plates") : std::string()) +
          ", weak ones " + hours("early_plate_hours") + "; ranges at the hole inside " +
          mpa(fatigue["inner_plate"]["hole"]) + ", outside " + mpa(fatigue["outer_plate"]["hole"]) +
          ", at the waist " + mpa(fatigue["inner_plate"]["waist"]) + " and " +
          mpa(fatigue["outer_plate"]["waist"]) + " MPa; most on link " +
          std::to_string(fatigue["link"].get<std::size_t>()) + "\n                    from " +
          to_text(pitches) + " pitches of each link, joined to turns; steps between them up to " +
          to_text(100. * fatigue["step"].get<double>(), 2) + " % of the range\n";
    }
  if (life.contains("impacts"))
    text += "  rollers, bushes   " + hours("simulated_roller_hours") + interval("rollers") +
            " without their scatter; peaks of " +
            to_text(life["impacts"]["peak"].get<double>(), 4) + " N, " +
            to_text(life["impacts"]["rated_peak"].get<double>(), 4) + " N at the rated power\n";
  if (life.contains("fatigue"))
    text += "  pins              bending " + mpa(life["fatigue"]["pin"]["bending"]) +
            " MPa, pressure " + mpa(life["fatigue"]["pin"]["pressure"]) + " MPa at most\n";
  return text.empty() ? text : "Life by what the run found in its window\n" + text;
}
} // namespace chaindrive
