// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/parameters/run.h>

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace chaindrive::parameters
{
class Declarations;
struct Variant;

/// Section `Study` of a study file: a drive some of whose entries are loops over values. What runs
/// are made of knows nothing of it.
struct Study
{
  std::string              title, text; ///< for the page of results
  std::vector<std::string> names;       ///< of the variants; empty: from their values
  std::string              reference;   ///< name of a variant; empty: the last one
  std::vector<std::string> outputs = {"tight_tension_mean"}; ///< that are judged, study_outputs
  std::string              against;    ///< entry that outputs are drawn against; empty: their cost
  unsigned int             phases = 8; ///< start phases of each variant
  unsigned int             ranks  = 1; ///< of a run; may be a loop
  std::vector<std::string> quick;      ///< "Section/Entry=value", what `--quick` changes

  /// Declares an entry for each member, which takes every value that is set. The object must
  /// outlive @p declarations.
  void declare(Declarations &declarations);

  /// InputError when one of the #outputs does not exist or is named twice.
  void check_outputs() const;

  /// InputError when a run with @p output does not keep what one of the #outputs is made of.
  void check_quantities(const Output &output) const;

  /// InputError unless #against is empty or an entry that each of @p variants gives a number.
  void check_against(const std::vector<Variant> &variants) const;

  /// Gives @p variants their #names, if any, and names the reference. InputError when they do not
  /// fit.
  void name(std::vector<Variant> &variants);
};

/// A name that `Study/Outputs` accepts, what it means, and the quantities that it is made of.
struct StudyOutput
{
  const char                *name, *unit, *meaning;
  std::vector<QuantityGroup> needs;
};

/// All of them; scripts/study/outputs.py computes them from the results of a run.
const std::vector<StudyOutput> &study_outputs();

/// The table of them in Markdown.
std::string study_output_documentation();

/// An entry whose value is a loop, as it stands in the file.
struct Loop
{
  std::string path, text;
};

/// One combination of the values of loops.
using Choices = std::vector<std::pair<std::string, std::string>>; ///< path of an entry, its value

/// All combinations, by dealii::MultipleParameterLoop: `{a|b|c}` takes each value, in every
/// combination with those of other loops, the first loop changing fastest; the n-th combination
/// takes the n-th value of `{{a|b|c}}`, of which there must be as many as combinations. InputError
/// when there are not, or when a loop has no end.
std::vector<Choices> combinations(const std::vector<Loop> &loops);

/// Whether @p value is that of a loop.
inline bool is_loop(const std::string &value) { return value.find('{') != std::string::npos; }

/// Whether the loop takes its values together with the others: `{{a|b|c}}`.
inline bool goes_with_others(const Loop &loop)
{
  return loop.text.find("{{") != std::string::npos && loop.text.find("}}") != std::string::npos;
}

/// A name for each of @p combinations, fit for a folder: `fidelity=simple,step=0.25` from the loops
/// that make combinations.
std::vector<std::string> names_of(const std::vector<Loop>    &loops,
                                  const std::vector<Choices> &combinations);

/// One model of a study.
struct Variant
{
  std::string                        name;
  Choices                            choices; ///< what distinguishes it
  std::map<std::string, std::string> values;  ///< of all entries that are set, by path
  unsigned int                       ranks = 1;
};

/// A study file that was read.
struct StudyInput
{
  Study                    study;
  std::vector<Variant>     variants;
  std::vector<std::string> folders; ///< of the file and of those that it includes, for meshes
  std::vector<std::string> notes;   ///< names of earlier versions, a sentence each, for the log
};
} // namespace chaindrive::parameters
