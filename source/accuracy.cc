// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/accuracy.h>
#include <chaindrive/accuracy_table.h>
#include <chaindrive/drive/oval_load.h>
#include <chaindrive/files/file.h>
#include <chaindrive/model/decide.h>
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
#include <map>
#include <set>
#include <sstream>

namespace chaindrive
{
namespace
{
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

std::string error_text(const StudyResult &result)
{
  return in_percent(result.error) + " (" + in_percent(result.low) + " ... " +
         in_percent(result.high) + ")";
}
} // namespace

std::string in_percent(const double value)
{
  const double percent = 100. * value;
  return (value < 0. ? "" : "+") +
         (std::abs(percent) < 99.5 ? to_text(percent, 2) : to_text(std::round(percent), 9)) + " %";
}

double StudyResult::bound() const { return std::max(std::abs(low), std::abs(high)); }
double StudyResult::share() const { return cpu / reference_cpu; }

Studies read_studies(const std::string &text)
{
  Studies                                      studies;
  std::vector<StudyResult>                     results;
  std::map<std::string, Scatter>               scatters; // by study, variant and output
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
      if (cells.front() == "scatter" && cells.size() == 7)
        {
          scatters[cells[1] + '\t' + cells[2] + '\t' + cells[3]] = {
              0.01 * number(cells[4]), number(cells[5]), number(cells[6]) - 1.};
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
  for (StudyResult &result : results)
    if (const auto its = scatters.find(result.study + '\t' + result.variant + '\t' + result.output);
        its != scatters.end())
      result.scatter = its->second;
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

bool bears_ovals(const Parameters &parameters, const drive::Facts &facts)
{
  Parameters layered           = parameters;
  layered.model.fidelity       = "layered";
  layered.effects.oval_rollers = parameters::Switch::on;
  return model::decide_effects(layered).is_on(model::Effect::oval_rollers) &&
         drive::oval_load(parameters, facts) <= 1.;
}

std::vector<StudyResult> results_of(const std::vector<StudyResult> &results,
                                    const CalibratedModel          &model)
{
  const auto has = [](const StudyResult &result, const std::string &entry) {
    return std::find(result.overrides.begin(), result.overrides.end(), entry) !=
           result.overrides.end();
  };
  std::vector<StudyResult> found;
  for (const StudyResult &result : results)
    if (has(result, "Model/Fidelity=" + model.fidelity) &&
        has(result, "Contact/Enforcement=exact") == model.exact &&
        has(result, "Effects/Oval rollers=on") == model.oval &&
        has(result, "Effects/Stiffness curves=off") == model.secants)
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

} // namespace chaindrive
