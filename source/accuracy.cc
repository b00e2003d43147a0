// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/accuracy.h>
#include <chaindrive/accuracy_table.h>
#include <chaindrive/commands.h>
#include <chaindrive/cost.h>
#include <chaindrive/drive/centre_distance.h>
#include <chaindrive/parameters/entries.h>
#include <chaindrive/parameters/reader.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <cmath>
#include <optional>
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

bool is_cheaper(const StudyResult &a, const StudyResult &b) { return a.cpu < b.cpu; }
bool is_better(const StudyResult &a, const StudyResult &b) { return a.bound() < b.bound(); }

std::string in_percent(const double value)
{
  return (value < 0. ? "" : "+") + to_text(100. * value, 2) + " %";
}

std::string error_text(const StudyResult &result)
{
  return in_percent(result.error) + " (" + in_percent(result.low) + " ... " +
         in_percent(result.high) + ")";
}

std::string entries_text(const StudyResult &result)
{
  std::string text;
  for (const std::string &entry : result.overrides)
    text += (text.empty() ? "" : "; ") + entry;
  return text;
}

/// CPU time of the drive of @p command_line as the variant of @p result, s; or why it cannot run.
std::string cost_here(const StudyResult &result,
                      const CommandLine &command_line,
                      const double       before,
                      const MPI_Comm     comm)
{
  std::vector<std::string> overrides = command_line.overrides;
  overrides.insert(overrides.end(), result.overrides.begin(), result.overrides.end());
  try
    {
      const parameters::Input input = parameters::read_parameters(
          command_line.parameter_file, overrides, drive::number_of_links);
      const std::vector<std::string> folders = mesh_folders(command_line.parameter_file);
      Simulation                     simulation(input.parameters, folders, comm);
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

std::vector<StudyResult> read_results(const std::string &text)
{
  std::vector<StudyResult> results;
  std::istringstream       in(text);
  std::string              line;
  while (std::getline(in, line))
    {
      if (line.empty() || line.front() == '#')
        continue;
      const std::vector<std::string> cells = split(line, '\t');
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
      results.push_back(result);
    }
  return results;
}

std::vector<StudyResult> shipped_results() { return read_results(accuracy_table); }

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

std::vector<Answer>
answers(const std::vector<StudyResult> &results, const std::string &output, const double wanted)
{
  std::vector<Answer> all;
  for (const StudyResult &result : results)
    {
      if (result.output != output)
        continue;
      auto answer = std::find_if(
          all.begin(), all.end(), [&](const Answer &a) { return a.study == result.study; });
      if (answer == all.end())
        answer = all.insert(all.end(), {result.study, std::nullopt, result});
      if (is_better(result, answer->best))
        answer->best = result;
      if (!(result.bound() <= wanted))
        continue;
      if (!answer->found || is_cheaper(result, *answer->found))
        answer->found = result;
    }
  return all;
}

void print_answers(std::ostream      &out,
                   const CommandLine &command_line,
                   const double       before,
                   const MPI_Comm     comm)
{
  const std::vector<StudyResult> results = shipped_results();
  for (const std::string &text : command_line.accuracy)
    {
      const auto [output, wanted] = read_wanted(text, results);
      out << "Accuracy: " << output << " within " << to_text(100. * wanted)
          << " %, as studies of the drive in prm/paper found\n";
      for (const Answer &answer : answers(results, output, wanted))
        {
          const StudyResult &result = answer.found.value_or(answer.best);
          out << "  " << answer.study << ": " << (answer.found ? "" : "no variant; the best is ")
              << result.variant
              << (result.variant == result.reference ? ", the reference, itself known within " :
                                                       " against " + result.reference + " ")
              << error_text(result) << "; " << entries_text(result);
          if (answer.found)
            out << "; " << cost_here(result, command_line, before, comm);
          out << '\n';
        }
    }
}
} // namespace chaindrive
