// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/accuracy.h>
#include <chaindrive/commands.h>
#include <chaindrive/cost.h>
#include <chaindrive/drive/groups.h>
#include <chaindrive/model/reading.h>
#include <chaindrive/observe/settling.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <optional>
#include <sstream>
#include <vector>

namespace chaindrive
{
namespace
{
constexpr const char *calibration = "calibration"; ///< what scripts/study/accuracy.py calls it
constexpr const char *prediction  = "prediction";  ///< what predicted() calls it
constexpr double      longest     = 1e4;           ///< window that is advised, pitches
constexpr double      infinite    = std::numeric_limits<double>::infinity();

std::string interval_text(const StudyResult &result)
{
  return in_percent(result.low) + " ... " + in_percent(result.high);
}

std::string in_words(const Candidate &candidate)
{
  const StudyResult &model = candidate.model;
  return model.variant +
         (model.study == calibration ? ", calibrated on this drive" :
          model.study == prediction  ? ", as other drives let expect" :
                                       " of study " + model.study) +
         (model.variant == model.reference ? ", the reference, itself known within " :
                                             ", against " + model.reference + " ");
}

bool needs_ovals(const StudyResult &result)
{
  return std::find(result.overrides.begin(), result.overrides.end(), "Effects/Oval rollers=on") !=
         result.overrides.end();
}

/// What tells the variant of @p result from the program's own choices, and from one of
/// @p parameters that no study judges.
std::string entries_text(const StudyResult &result, const Parameters &parameters)
{
  const std::string automatic = "=auto";
  std::string       text;
  for (const std::string &entry : result.overrides)
    if (entry.size() < automatic.size() ||
        entry.compare(entry.size() - automatic.size(), automatic.size(), automatic) != 0)
      text += (text.empty() ? "" : "; ") + entry;
  if (parameters.effects.stiffness_curves == parameters::Switch::off &&
      text.find("Model/Fidelity=layered") != std::string::npos)
    text += "; Effects/Stiffness curves=auto";
  return text;
}

/// How models did on the drives of @p results, in sentences, each after a blank.
std::string
on_others(const std::vector<StudyResult> &results, const std::string &output, const double wanted)
{
  std::string text;
  for (const Spread &spread : spread_of(results, output, wanted))
    text += " On " + std::to_string(spread.n_drives) + " others " + spread.variant +
            " was within it on " +
            (spread.n_within == 0 ? "none" : std::to_string(spread.n_within)) + ", with " +
            in_percent(spread.least) + " to " + in_percent(spread.most) + ".";
  return text;
}

/// What a user types to calibrate the drive of @p command_line.
std::string calibration_call(const CommandLine &command_line)
{
  std::string text = "chaindrive calibrate " + command_line.parameter_file;
  for (const std::string &entry : command_line.overrides)
    text += " --set \"" + entry + "\"";
  return text;
}

bool is_rigid(const StudyResult &result)
{
  return std::any_of(
      result.overrides.begin(), result.overrides.end(), [](const std::string &entry) {
        return entry == "Model/Fidelity=simple" || entry == "Model/Fidelity=layered";
      });
}

/// CPU time of the drive of @p command_line as the variant of @p result; InputError: it cannot run.
/// Where the parts are not solved yet, with stiffnesses that are @p estimated from dimensions. None
/// on ranks that are idle.
std::optional<Cost> cost_here(const StudyResult &result,
                              const CommandLine &command_line,
                              const bool         estimated,
                              const double       before,
                              const MPI_Comm     comm,
                              std::ostream      &out)
{
  std::vector<std::string> overrides = command_line.overrides;
  overrides.insert(overrides.end(), result.overrides.begin(), result.overrides.end());
  if (estimated)
    overrides.insert(overrides.end(),
                     {"Model/Stiffness from=dimensions", "Effects/Stiffness curves=auto"});
  const parameters::Input input = model::read_parameters(command_line.parameter_file, overrides);
  const std::vector<std::string> folders = mesh_folders(command_line.parameter_file);
  Simulation simulation(input.parameters, folders, comm, [&out](const std::string &sentence) {
    out << sentence << std::endl;
  });
  if (simulation.is_idle())
    return {};
  return measure_cost(simulation, folders, before);
}

/// What runs of this drive cost here, from that of one rigid model and from what the studies say of
/// the others.
class Costs
{
public:
  Costs(const Answer      &answer,
        const CommandLine &command_line,
        const bool         estimated,
        const double       before,
        const MPI_Comm     comm,
        std::ostream      &out)
  {
    // the first that is named, or the cheapest
    const auto measured = [](const std::vector<Candidate> &all) {
      return std::find_if(
          all.begin(), all.end(), [](const Candidate &one) { return is_rigid(one.model); });
    };
    const bool in_found = !answer.found.empty() && is_rigid(answer.found.front().model);
    const auto it       = measured(answer.all);
    if (!in_found && it == answer.all.end())
      return;
    const Candidate &chosen = in_found ? answer.found.front() : *it;
    try
      {
        cost_  = cost_here(chosen.model, command_line, estimated, before, comm, out);
        share_ = chosen.model.share();
      }
    catch (const InputError &error)
      {
        refusal_ = std::string("here it cannot run: ") + error.what();
      }
  }

  /// CPU time of a run of this model, whose window is as it suffices, s; not a number: not known.
  double of(const Candidate &candidate) const
  {
    return cost_ ? cost_->start_up + (cost_->loop() + cost_->outputs()) * candidate.cost / share_ :
                   std::nan("");
  }

  std::string text_of(const Candidate &candidate) const
  {
    if (!refusal_.empty())
      return refusal_;
    return std::isfinite(of(candidate)) ? "it takes " + to_text(of(candidate), 3) + " s here" :
                                          to_text(100. * candidate.cost, 3) +
                                              " % of the CPU time of " + candidate.model.reference;
  }

private:
  std::optional<Cost> cost_;
  double              share_ = 1.;
  std::string         refusal_;
};

/// What makes the window of the run @p here as long as @p candidate needs it for @p output, each
/// after "; ". Empty: it is.
std::string window_entries(const Candidate   &candidate,
                           const RunAtHand   &here,
                           const Parameters  &parameters,
                           const double       pitch_time,
                           const double       wanted,
                           const std::string &output)
{
  if (!candidate.suffices() || candidate.pitches <= here.pitches)
    return "";
  const auto   in_ms = [](const double time) { return to_text(std::ceil(1e4 * time) / 10., 9); };
  const double more =
      (std::ceil(candidate.pitches) - std::floor(here.pitches)) * pitch_time; // s, at least
  const parameters::Output &its = parameters.output;
  if (here.until.count(output) > 0)
    return "; Output/Until with " + output + "=" +
           to_text(100. * room_for_run(candidate, wanted), 2);
  if (!its.window_start)
    return "; Output/Window length in pitches=" + to_text(std::ceil(candidate.pitches)) +
           "; Time/End time in ms=" + in_ms(parameters.time.end + more);
  const double end = *its.window_start + std::ceil(candidate.pitches) * pitch_time;
  return (its.window_end ? "; Output/Window end in ms=" + in_ms(end) : std::string()) +
         (end > parameters.time.end ? "; Time/End time in ms=" + in_ms(end) : std::string());
}

/// The models in a table: what each is wrong by, and by what a run of it.
void print_table(std::ostream    &out,
                 const Answer    &answer,
                 const RunAtHand &here,
                 const Costs     &costs,
                 const double     wanted,
                 const bool       until) // whether Output/Until asks for it
{
  std::size_t width = 5;
  for (const Candidate &one : answer.all)
    width = std::max(width, one.model.variant.size());
  const std::vector<int> columns = {static_cast<int>(width) + 2, 10, 24, 14, 24, 10};
  const auto             row     = [&](const std::vector<std::string> &cells) {
    out << std::left << std::setw(columns[0]) << "  " + cells[0] << std::right;
    for (std::size_t i = 1; i < columns.size(); ++i)
      out << std::setw(columns[i]) << cells[i];
    out << "  " << cells[6] << '\n';
  };
  row({"model",
       "error",
       "of model and reference",
       "of this run",
       "together",
       "CPU (s)",
       "within " + to_text(100. * wanted) + " %"});
  for (const Candidate &one : answer.all)
    {
      const double cost = costs.of(one);
      row({one.model.variant,
           in_percent(one.model.error),
           interval_text(one.model),
           one.run > 0. ? "+-" + in_percent(one.run).substr(1) : "not known",
           interval_text(one.together),
           std::isfinite(cost) ? to_text(cost, 2) : "-",
           !one.suffices()             ? "no" :
           one.pitches <= here.pitches ? "yes" :
           until ? "yes, with Output/Until of " + to_text(100. * room_for_run(one, wanted), 2) +
                       " %" :
                   "yes, with a window of " + to_text(std::ceil(one.pitches)) + " pitches"});
    }
}

/// What the columns of the table are made of.
std::string sources_text(const RunAtHand &here,
                         const double     numerics,
                         const double     sampling,
                         const bool       estimated)
{
  std::string text = "  Of model and reference: ";
  text += numerics > 0. ? "with " + to_text(100. * numerics, 2) +
                              " % for meshes, modes and step of the reference, as found on the "
                              "drive of prm/paper" :
                          "of meshes, modes and step of the reference nothing was found";
  if (sampling > 0.)
    text += ", and " + to_text(100. * sampling, 2) + " % for histories with a value every " +
            to_text(1e6 * here.sampling, 3) + " us, as found there";
  text += ". Of this run: its window of " + to_text(here.pitches, 3) +
          " pitches and its start phase, as runs from several phases scatter; it falls with the "
          "root of the window, and summary.json has it as uncertainty.";
  if (estimated)
    text += " CPU times are without the solutions of the parts, which runs keep for later ones.";
  return text + '\n';
}
} // namespace

double Scatter::half(const double window) const
{
  if (!(deviation > 0.) || !(degrees > 0.))
    return 0.;
  return boost::math::quantile(boost::math::students_t(degrees), 0.975) * deviation *
         std::sqrt(pitches / window);
}

RunAtHand run_at_hand(const Parameters &parameters, const drive::Facts &facts)
{
  const parameters::Output &output = parameters.output;
  const unsigned int        period = drive::pitches_per_resonance(facts);
  RunAtHand                 here;
  here.sampling = output.history_interval;
  if (!std::isfinite(facts.pitch_time) || !(facts.pitch_time > 0.)) // it stands
    return here;
  here.duration = (parameters.time.end - parameters.time.start) / facts.pitch_time;
  for (const parameters::Wanted &one : output.until)
    here.until[one.output] = one.uncertainty;
  if (!output.until.empty())
    here.pitches = 8. * period;
  else if (output.window_start)
    here.pitches =
        (output.window_end.value_or(parameters.time.end) - *output.window_start) / facts.pitch_time;
  else
    here.pitches =
        std::max(output.window_pitches, period > 1 ? observe::Settling::n_periods * period : 1);
  return here;
}

double room_for_run(const Candidate &candidate, const double wanted)
{
  const StudyResult &model = candidate.model;
  const double       low = model.error - model.low, high = model.high - model.error;
  const double       below = wanted + model.error, above = wanted - model.error;
  if (below < low || above < high)
    return 0.;
  return std::sqrt(std::min(below * below - low * low, above * above - high * high)) /
         (1. + model.error);
}

Answer answer(const std::vector<StudyResult> &results,
              const std::string              &output,
              const double                    wanted,
              const RunAtHand                &here)
{
  Answer     answer;
  const auto until = here.until.find(output);
  for (const StudyResult &result : results)
    {
      if (result.output != output)
        continue;
      Candidate one;
      one.model             = result;
      const double of_model = 1. + result.error; // its runs over the truth
      const double alone =
          until == here.until.end() ? result.scatter.half(here.pitches) : until->second;
      one.run      = of_model * alone;
      one.together = with_numerics(result, one.run);
      // of less than a pitch there is no mean, so that no scatter is known of
      if (one.together.bound() <= wanted && here.pitches >= 1.)
        one.pitches = here.pitches;
      else if (const double room = room_for_run(one, wanted); room > 0.)
        {
          // a little more: the window is a whole number of pitches
          const double pitches = here.pitches * std::pow(alone / room, 2);
          if (pitches <= longest)
            one.pitches = std::max(pitches, here.pitches + 1.);
        }
      const double window = one.suffices() ? one.pitches : here.pitches;
      one.cost = result.share() * (here.duration + window - here.pitches) / here.duration;
      answer.all.push_back(one);
      if (!answer.best || result.bound() < answer.best->model.bound())
        answer.best = one;
    }
  std::stable_sort(answer.all.begin(),
                   answer.all.end(),
                   [](const Candidate &a, const Candidate &b) { return a.cost < b.cost; });
  for (const Candidate &one : answer.all)
    if (one.suffices())
      answer.found.push_back(one);
  return answer;
}

std::vector<Spread>
spread_of(const std::vector<StudyResult> &results, const std::string &output, const double wanted)
{
  std::vector<Spread> spreads;
  for (const char *variant : {"layered", "simple"})
    {
      Spread spread{variant};
      for (const StudyResult &result : results)
        if (result.variant == variant && result.output == output)
          {
            const bool first = spread.n_drives++ == 0;
            spread.least     = first ? result.error : std::min(spread.least, result.error);
            spread.most      = first ? result.error : std::max(spread.most, result.error);
            spread.n_within += std::abs(result.error) <= wanted ? 1 : 0;
          }
      if (spread.n_drives > 1)
        spreads.push_back(spread);
    }
  return spreads;
}

void print_answers(std::ostream                   &out,
                   const CommandLine              &command_line,
                   const Parameters               &parameters,
                   const drive::Facts             &facts,
                   const std::vector<StudyResult> &calibrated,
                   const bool                      estimated,
                   const double                    before,
                   const MPI_Comm                  comm)
{
  const Studies                  studies = shipped_studies();
  const std::vector<std::string> words   = drive_in_words(facts);
  const RunAtHand                here    = run_at_hand(parameters, facts);
  std::map<std::string, double>  groups;
  for (const drive::Group &group : drive::groups_of(facts))
    groups[group.name] = group.value;
  for (const std::string &text : command_line.accuracy)
    {
      const auto [output, wanted] =
          read_wanted(text, calibrated.empty() ? studies.results : calibrated);
      std::ostringstream line;
      line << "Accuracy: " << output << " within " << to_text(100. * wanted) << " %: ";
      std::vector<StudyResult> results;
      for (const StudyResult &result : calibrated.empty() ? studies.results : calibrated)
        if (result.output == output &&
            (!calibrated.empty() || difference(studies.drives.at(result.study), words).empty()))
          results.push_back(result);
      const double numerics     = of_numerics(studies, output),
                   sampling     = of_sampling(studies, output, here.sampling);
      const std::string outside = results.empty() ? beyond(studies, groups) : "";
      if (results.empty() && outside.empty())
        {
          results = predicted(studies, output, groups);
          if (!bears_ovals(parameters, facts))
            results.erase(std::remove_if(results.begin(), results.end(), needs_ovals),
                          results.end());
        }
      // models scatter alike: that of the reference for one whose own is not known
      Scatter of_reference;
      for (const StudyResult &result : results)
        if (result.variant == result.reference)
          of_reference = result.scatter;
      for (StudyResult &result : results)
        {
          if (!(result.scatter.half(1.) > 0.))
            result.scatter = of_reference;
          if (result.variant == result.reference && result.scatter.half(1.) > 0.)
            result.low = result.high = 0.; // the interval of a mean is that of its runs
          result = with_numerics(result, std::hypot(numerics, sampling));
        }
      const Answer answer = chaindrive::answer(results, output, wanted, here);
      if (!outside.empty() || answer.all.empty())
        {
          out << line.str() << "no answer for this drive."
              << on_others(studies.results, output, wanted)
              << (outside.empty() ? "" : " Not measured on a drive like this: " + outside + ".")
              << " This finds one: " << calibration_call(command_line) << '\n';
          continue;
        }
      const Costs costs(answer, command_line, estimated, before, comm, out);
      const bool  expected = answer.best->model.study == prediction;
      if (!answer.found.empty())
        {
          const Candidate &first = answer.found.front();
          // with the window that suffices
          const StudyResult all = with_numerics(
              first.model,
              first.run * std::sqrt(here.pitches / std::max(here.pitches, first.pitches)));
          line << in_words(first) << in_percent(all.error) << " (" << interval_text(all) << "); "
               << costs.text_of(first) << "; " << entries_text(first.model, parameters)
               << window_entries(first, here, parameters, facts.pitch_time, wanted, output) << '\n';
        }
      else if (expected)
        line << "no answer for this drive." << on_others(studies.results, output, wanted)
             << " This finds one: " << calibration_call(command_line) << '\n';
      else
        line << "no model; the best is " << in_words(*answer.best)
             << in_percent(answer.best->model.error) << " (" << interval_text(answer.best->model)
             << ") in a long window; " << entries_text(answer.best->model, parameters) << '\n';
      print_table(line, answer, here, costs, wanted, here.until.count(output) > 0);
      line << sources_text(here, numerics, sampling, estimated);
      if (expected && !answer.found.empty())
        line << "  Such intervals hold 90 of 100 drives. This measures yours: "
             << calibration_call(command_line) << '\n';
      out << line.str();
    }
}
} // namespace chaindrive
