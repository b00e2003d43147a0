// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/command_line.h>

#include <mpi.h>

#include <iosfwd>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace chaindrive
{
/// What a study found of one output of one variant.
struct StudyResult
{
  std::string study, variant, reference, output;
  double      error = 0., low = 0., high = 0.; ///< against the reference, with its interval; 1
  double      cpu = 0., reference_cpu = 0.;    ///< of a run of the study, s
  std::vector<std::string> overrides;          ///< "Section/Entry=value": what the variant is

  /// How wrong the variant may be: the farther end of the interval. 1
  double bound() const;
};

/// The table of results that the program was built with: source/accuracy.tsv, which
/// scripts/study/accuracy.py writes from studies.
std::vector<StudyResult> shipped_results();

/// The same from the text of such a table.
std::vector<StudyResult> read_results(const std::string &text);

/// What is wanted: an output and how wrong it may be [1]. From "NAME=PERCENT"; InputError when it
/// is not that, or when no study of @p results judges the output, with those that are judged.
std::pair<std::string, double> read_wanted(const std::string              &text,
                                           const std::vector<StudyResult> &results);

/// What one study answers.
struct Answer
{
  std::string study;
  /// The cheapest variant that is accurate enough; the reference counts, with the interval of its
  /// own mean. Empty if none is.
  std::optional<StudyResult> found;
  StudyResult                best; ///< the most accurate one
};

/// The answer of each study that judges @p output, within @p wanted [1].
std::vector<Answer>
answers(const std::vector<StudyResult> &results, const std::string &output, double wanted);

/// Says for each `--accuracy` of @p command_line what the studies answer, and what the variants
/// that they name cost for its drive, by measure_cost() with @p before. InputError as
/// read_wanted(). Collective.
void print_answers(std::ostream      &out,
                   const CommandLine &command_line,
                   double             before,
                   MPI_Comm           comm);
} // namespace chaindrive
