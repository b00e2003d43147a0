// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/accuracy.h>
#include <chaindrive/accuracy_table.h>
#include <chaindrive/commands.h>
#include <chaindrive/cost.h>
#include <chaindrive/drive/groups.h>
#include <chaindrive/files/file.h>
#include <chaindrive/model/reading.h>
#include <chaindrive/parameters/entries.h>
#include <chaindrive/statics/cache.h>
#include <chaindrive/utilities/checksum.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>
#include <chaindrive/version.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <sstream>

namespace chaindrive
{
namespace
{
constexpr const char *calibration = "calibration"; ///< what scripts/study/accuracy.py calls it
constexpr const char *prediction  = "prediction";  ///< what predicted() calls it

std::vector<std::string> split(const std::string &line, const char separator)
{
  std::vector<std::string> words;
  std::istringstream       in(line);
  for (std::string word; std::getline(in, word, separator);)
    words.push_back(word);
  return words;
}

double number(const std::string &text)
{
  return parameters::from_entry_text(text, parameters::unit::si).value_or(std::nan(""));
}

bool is_cheaper(const StudyResult &a, const StudyResult &b) { return a.share() < b.share(); }
bool is_better(const StudyResult &a, const StudyResult &b) { return a.bound() < b.bound(); }

/// Two digits, or all before the point.
std::string in_percent(const double value)
{
  const double percent = 100. * value;
  return (value < 0. ? "" : "+") +
         (std::abs(percent) < 99.5 ? to_text(percent, 2) : to_text(std::round(percent), 9)) + " %";
}

std::string error_text(const StudyResult &result)
{
  return in_percent(result.error) + " (" + in_percent(result.low) + " ... " +
         in_percent(result.high) + ")";
}

std::string in_words(const StudyResult &result)
{
  return result.variant +
         (result.study == calibration ? ", calibrated on this drive" :
          result.study == prediction  ? ", as other drives let expect" :
                                        " of study " + result.study) +
         (result.variant == result.reference ? ", the reference, itself known within " :
                                               ", against " + result.reference + " ") +
         error_text(result);
}

/// What tells the variant of @p result from the program's own choices.
std::string entries_text(const StudyResult &result)
{
  const std::string automatic = "=auto";
  std::string       text;
  for (const std::string &entry : result.overrides)
    if (entry.size() < automatic.size() ||
        entry.compare(entry.size() - automatic.size(), automatic.size(), automatic) != 0)
      text += (text.empty() ? "" : "; ") + entry;
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

/// CPU time of the drive of @p command_line as the variant of @p result, s; or why it cannot run.
std::string cost_here(const StudyResult &result,
                      const CommandLine &command_line,
                      const double       before,
                      const MPI_Comm     comm,
                      std::ostream      &out)
{
  std::vector<std::string> overrides = command_line.overrides;
  overrides.insert(overrides.end(), result.overrides.begin(), result.overrides.end());
  try
    {
      const parameters::Input input =
          model::read_parameters(command_line.parameter_file, overrides);
      const std::vector<std::string> folders = mesh_folders(command_line.parameter_file);
      Simulation simulation(input.parameters, folders, comm, [&out](const std::string &sentence) {
        out << sentence << std::endl;
      });
      return simulation.is_idle() ?
                 "" :
                 "it takes " + to_text(measure_cost(simulation, folders, before).total(), 3) +
                     " s here";
    }
  catch (const InputError &error)
    {
      return std::string("here it cannot run: ") + error.what();
    }
}
} // namespace

double StudyResult::bound() const { return std::max(std::abs(low), std::abs(high)); }
double StudyResult::share() const { return cpu / reference_cpu; }

Studies read_studies(const std::string &text)
{
  Studies                                      studies;
  std::vector<StudyResult>                     results;
  std::map<std::string, std::set<std::string>> fidelities;
  std::istringstream                           in(text);
  std::string                                  line;
  while (std::getline(in, line))
    {
      if (line.empty() || line.front() == '#')
        continue;
      const std::vector<std::string> cells = split(line, '\t');
      if (cells.front() == "drive" && cells.size() > 2)
        {
          studies.drives[cells[1]].assign(cells.begin() + 2, cells.end());
          continue;
        }
      if (cells.front() == "groups" && cells.size() > 2)
        {
          for (std::size_t i = 2; i < cells.size(); ++i)
            studies.groups[cells[1]][cells[i].substr(0, cells[i].find('='))] =
                number(cells[i].substr(cells[i].find('=') + 1));
          continue;
        }
      if (cells.front() == "fit" && cells.size() == 11)
        {
          studies.fits.push_back({cells[1],
                                  cells[2],
                                  cells[3],
                                  static_cast<unsigned int>(number(cells[4])),
                                  number(cells[5]),
                                  number(cells[6]),
                                  number(cells[7]),
                                  number(cells[8]),
                                  number(cells[9]),
                                  0.01 * number(cells[10])});
          continue;
        }
      AssertThrow(cells.size() >= 9, dealii::ExcMessage("accuracy.tsv: " + line));
      StudyResult result;
      result.study         = cells[0];
      result.variant       = cells[1];
      result.reference     = cells[2];
      result.output        = cells[3];
      result.error         = 0.01 * number(cells[4]);
      result.low           = 0.01 * number(cells[5]);
      result.high          = 0.01 * number(cells[6]);
      result.cpu           = number(cells[7]);
      result.reference_cpu = number(cells[8]);
      result.overrides.assign(cells.begin() + 9, cells.end());
      for (const std::string &entry : result.overrides)
        if (entry.rfind("Model/Fidelity=", 0) == 0)
          fidelities[result.study].insert(entry);
      results.push_back(result);
    }
  for (const StudyResult &result : results)
    if (fidelities[result.study].size() > 1)
      studies.results.push_back(result);
  studies.all = std::move(results);
  return studies;
}

Studies shipped_studies()
{
  std::string text;
  for (const char *line : accuracy_table)
    text.append(line).append("\n");
  return read_studies(text);
}

std::vector<std::string> drive_in_words(const drive::Facts &facts)
{
  const drive::Facts::Sprocket &driver = facts.driver(), &driven = facts.loaded();
  return {"chain=" + facts.chain,
          "links=" + std::to_string(facts.links),
          "driver teeth=" + std::to_string(driver.teeth),
          "driven teeth=" + std::to_string(driven.teeth),
          "driver speed in rpm=" + to_text(30. / dealii::numbers::PI * std::abs(driver.speed), 5),
          "driven torque in N m=" + to_text(std::abs(driven.torque), 5),
          "centre distance in mm=" + to_text(1e3 * facts.centre_distance, 6),
          "driven inertia in kg m2=" + to_text(facts.driven_inertia, 4)};
}

std::string difference(const std::vector<std::string> &studied,
                       const std::vector<std::string> &here)
{
  std::string text;
  for (std::size_t i = 0; i < std::max(studied.size(), here.size()); ++i)
    {
      const std::string a      = i < studied.size() ? studied[i] : "",
                        b      = i < here.size() ? here[i] : "";
      const std::size_t equals = a.find('=');
      const std::string name   = a.substr(0, equals);
      if (a == b)
        continue;
      AssertThrow(b.compare(0, name.size() + 1, name + "=") == 0,
                  dealii::ExcMessage("accuracy.tsv: " + a + " is not " + b));
      const std::string was = a.substr(equals + 1), is = b.substr(equals + 1);
      // of whole numbers and names every difference counts
      const bool   continuous = name.find(" in ") != std::string::npos;
      const double tolerance  = name.find("inertia") != std::string::npos ? 0.05 : 0.01;
      if (continuous && std::abs(number(is) - number(was)) <= tolerance * std::abs(number(was)))
        continue;
      text += (text.empty() ? "" : ", ") + name + " " + was + " there and " + is + " here";
    }
  return text;
}

std::pair<std::string, double> read_wanted(const std::string              &text,
                                           const std::vector<StudyResult> &results)
{
  const std::size_t equals  = text.find('=');
  const std::string name    = text.substr(0, equals);
  const double      percent = equals == std::string::npos ? -1. : number(text.substr(equals + 1));
  if (!(percent > 0. && percent <= 100.))
    throw InputError("--accuracy \"" + text +
                     "\" is not understood: write OUTPUT=PERCENT, such as tight_tension_mean=5, "
                     "with a number above 0 and up to 100.");
  std::set<std::string> judged;
  for (const StudyResult &result : results)
    judged.insert(result.output);
  if (judged.count(name) == 0)
    {
      std::string all;
      for (const std::string &output : judged)
        all += (all.empty() ? "" : ", ") + output;
      throw InputError("--accuracy \"" + text + "\": no study that this program knows judges '" +
                       name + "', so that it cannot say which model reaches " + to_text(percent) +
                       " %. Known are: " + (all.empty() ? "none" : all) + ".");
    }
  return {name, 0.01 * percent};
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

Answer answer(const std::vector<StudyResult> &results, const std::string &output, double wanted)
{
  Answer answer;
  for (const StudyResult &result : results)
    {
      if (result.output != output)
        continue;
      if (!answer.best || is_better(result, *answer.best))
        answer.best = result;
      if (result.bound() <= wanted)
        answer.found.push_back(result);
    }
  std::stable_sort(answer.found.begin(), answer.found.end(), is_cheaper);
  return answer;
}

const std::vector<std::string> &calibrated_outputs()
{
  static const std::vector<std::string> all = {"tight_tension_mean",
                                               "slack_tension_mean",
                                               "tight_tension_ripple",
                                               "driver_peak_mean",
                                               "driver_impulse_mean",
                                               "driver_normal_speed_mean",
                                               "driven_peak_mean",
                                               "driven_impulse_mean",
                                               "roller_velocity_rms",
                                               "losses"};
  return all;
}

namespace
{
/// Whether an entry says what the drive is or carries, and not how it is modelled and computed.
bool is_of_drive(const std::string &line)
{
  const auto begins = [&line](const char *text) { return line.rfind(text, 0) == 0; };
  for (const char *start : {"Drive/Layout/Start = ", "Drive/Layout/Start phase = "})
    if (begins(start))
      return false;
  for (const char *mine : {"Drive/",
                           "Loads/",
                           "Material/",
                           "Model/Driven inertia in kg m2 = ",
                           "Contact/Damping ratio = ",
                           "Contact/Friction coefficient = ",
                           "Contact/Roller-tooth friction = ",
                           "Contact/Roller-bush friction = ",
                           "Contact/Bush-pin friction = ",
                           "the checksum of "})
    if (begins(mine))
      return true;
  return false;
}
} // namespace

std::string calibration_file(const std::string &fixed)
{
  const std::string folder = statics::Cache::usual_folder();
  if (folder.empty())
    throw InputError("There is no folder to keep a calibration in: set CHAINDRIVE_CACHE to one "
                     "that can be written.");
  std::string        text = std::string("chaindrive ") + version + "\n";
  std::istringstream lines(fixed);
  for (std::string line; std::getline(lines, line);)
    if (is_of_drive(line))
      text += line + "\n";
  return folder + "/drives/" + checksum(text) + ".tsv";
}

std::vector<StudyResult> find_calibration(const std::string &fixed, std::string &note)
{
  if (statics::Cache::usual_folder().empty())
    return {};
  const std::string file = calibration_file(fixed);
  std::error_code   error; // a folder that cannot be looked into has none
  if (!std::filesystem::exists(file, error))
    return {};
  try
    {
      const std::string text = files::read_text(file),
                        end  = "\n# complete, of " + std::filesystem::path(file).stem().string() +
                              "\n";
      std::vector<StudyResult> results;
      if (text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0)
        results = read_studies(text).results;
      for (const StudyResult &result : results)
        if (!std::isfinite(result.error) || !std::isfinite(result.bound()) ||
            !(result.share() > 0.))
          throw RunError("a figure is not a number");
      if (!results.empty())
        return results;
    }
  catch (const std::exception &)
    {
    }
  note = "The calibration of this drive, '" + file +
         "', is damaged or of another drive, and not used. Start chaindrive calibrate again.";
  return {};
}

std::vector<StudyResult> results_of(const std::vector<StudyResult> &results,
                                    const std::string              &fidelity,
                                    const bool                      exact,
                                    const bool                      oval)
{
  const auto has = [](const StudyResult &result, const std::string &entry) {
    return std::find(result.overrides.begin(), result.overrides.end(), entry) !=
           result.overrides.end();
  };
  std::vector<StudyResult> found;
  for (const StudyResult &result : results)
    if (has(result, "Model/Fidelity=" + fidelity) &&
        has(result, "Contact/Enforcement=exact") == exact &&
        has(result, "Effects/Oval rollers=on") == oval)
      found.push_back(result);
  return found;
}

std::string accuracy_sentence(const std::vector<StudyResult> &results)
{
  if (results.empty())
    return "";
  const StudyResult &first = results.front();
  std::string        text =
      first.variant == first.reference ?
                 "How well this model, the reference, is known on this drive:" :
                 "How wrong this model is on this drive, against " + first.reference + " contact:";
  for (const StudyResult &result : results)
    text += (&result == &first ? " " : ", ") + result.output + " " + error_text(result);
  return text + ".";
}

files::Json to_json(const std::vector<StudyResult> &results)
{
  files::Json values;
  for (const StudyResult &result : results)
    values[result.output] = {{"error", result.error}, {"low", result.low}, {"high", result.high}};
  return values;
}

void print_answers(std::ostream                   &out,
                   const CommandLine              &command_line,
                   const drive::Facts             &facts,
                   const std::vector<StudyResult> &calibrated,
                   const double                    before,
                   const MPI_Comm                  comm)
{
  const Studies                  studies = shipped_studies();
  const std::vector<std::string> here    = drive_in_words(facts);
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
            (!calibrated.empty() || difference(studies.drives.at(result.study), here).empty()))
          results.push_back(result);
      const double      numerics = of_numerics(studies, output);
      const std::string outside  = results.empty() ? beyond(studies, groups) : "";
      if (results.empty() && outside.empty())
        results = predicted(studies, output, groups);
      for (StudyResult &result : results)
        result = with_numerics(result, numerics);
      const auto [found, best] = answer(results, output, wanted);
      if (!outside.empty() || results.empty())
        line << "no answer for this drive." << on_others(studies.results, output, wanted)
             << (outside.empty() ? "" : " Not measured on a drive like this: " + outside + ".")
             << " This finds one: " << calibration_call(command_line) << '\n';
      else if (found.empty() && best->study == prediction)
        {
          line << "no answer for this drive." << on_others(studies.results, output, wanted);
          for (const StudyResult &result : results)
            line << ' ' << in_words(result) << '.';
          line << " This finds one: " << calibration_call(command_line) << '\n';
        }
      else if (found.empty())
        line << "no model; the best is " << in_words(*best) << "; " << entries_text(*best) << '\n';
      for (std::size_t i = 0; i < found.size(); ++i)
        {
          const StudyResult &result = found[i];
          const std::string cost = i == 0 ? cost_here(result, command_line, before, comm, out) : "";
          line << (i == 0 ? "" : "  or ") << in_words(result) << "; "
               << (cost.empty() ? to_text(100. * result.share(), 3) + " % of the CPU time of " +
                                      result.reference :
                                  cost)
               << "; " << entries_text(result) << '\n';
        }
      if (!found.empty() && found.front().study == prediction)
        line << "  Such intervals hold 90 of 100 drives. This measures yours: "
             << calibration_call(command_line) << '\n';
      if (numerics > 0. && !results.empty())
        line << "  Intervals include " << to_text(100. * numerics, 2)
             << " % for meshes, modes and step of the reference, as found on the drive of "
                "prm/paper; "
                "a run's own window and phase scatter besides: see Output/Until.\n";
      out << line.str();
    }
}
} // namespace chaindrive
