// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/command_line.h>
#include <chaindrive/drive/facts.h>
#include <chaindrive/files/json.h>
#include <chaindrive/parameters/parameters.h>

#include <mpi.h>

#include <iosfwd>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace chaindrive
{
/// By how much single runs differ that start in different phases: the standard deviation of an
/// output between them over its mean.
struct Scatter
{
  double deviation = std::numeric_limits<double>::quiet_NaN(); ///< 1; not a number: not known
  double pitches   = 1.; ///< length of the windows of these runs
  double degrees   = 0.; ///< of freedom, with which the deviation is known

  /// Half of the 95 % interval in which a run with a window of @p window pitches lies about the
  /// mean of many, over that mean: Student's t times the deviation, which falls with the root of
  /// the window. 1; zero where the deviation is not known
  double half(double window) const;
};

/// What a study found of one output of one variant.
struct StudyResult
{
  std::string study, variant, reference, output;
  double      error = 0., low = 0., high = 0.; ///< against the reference, with its interval; 1
  double      cpu = 0., reference_cpu = 0.;    ///< of a run of the study, s
  std::vector<std::string> overrides;          ///< "Section/Entry=value": what the variant is
  Scatter                  scatter;            ///< of single runs of the variant

  /// How wrong the variant may be: the farther end of the interval. 1
  double bound() const;
  /// Of the CPU time of the reference: comparable between studies of runs of other lengths. 1
  double share() const;
};

/// An error of a model as those of many drives let expect it, by scripts/study/accuracy_fit.py:
/// ln(1
/// + error) = centre + slope (ln group - x_mean), and of a new drive within factor sqrt(1 + 1/n +
/// (ln group - x_mean)^2 / x_square) of that in 90 % of the cases.
struct Fit
{
  std::string  variant, output;
  std::string  group; ///< drive::Group::name, or "-": of no group, without slope
  unsigned int n_drives;
  double       centre, slope, x_mean, x_square, factor;
  double       coverage; ///< share of drives that lay within when they were left out, 1
};

/// What the program was built with.
struct Studies
{
  /// Of studies that compare fidelities with the full one. Those of a mesh, a step or a penalty say
  /// what that choice changes in one model, not how wrong the model is: they are not in here.
  std::vector<StudyResult> results;
  /// By study: the drive that it ran, as drive_in_words().
  std::map<std::string, std::vector<std::string>> drives;
  /// By study: the groups of the drive, by name.
  std::map<std::string, std::map<std::string, double>> groups;
  std::vector<Fit>                                     fits;
  /// What all studies found, those of a mesh, a step or modes included.
  std::vector<StudyResult> all;
};

/// What a plan's answer depends on of the run that is planned.
struct RunAtHand
{
  double pitches  = 1.; ///< length of its window
  double duration = 1.; ///< pitch times from its start to its end
  double sampling = 0.; ///< interval of its histories, s
  /// What Output/Until asks for, by output: half of the 95 % interval, 1. The run goes on until
  /// that is reached, so that its window is no matter.
  std::map<std::string, double> until;
};

/// That of @p parameters. A window that waits for the drive of @p facts to settle has its least
/// length, and so has one that ends when outputs are known.
RunAtHand run_at_hand(const Parameters &parameters, const drive::Facts &facts);

/// source/accuracy.tsv, which scripts/study/accuracy.py writes from studies.
Studies shipped_studies();

/// The same from the text of such a table.
Studies read_studies(const std::string &text);

/// The outputs by which `chaindrive calibrate` judges models, as Study/Outputs names them.
const std::vector<std::string> &calibrated_outputs();

/// The file in the cache for what `chaindrive calibrate` finds for the drive of this fixed_text():
/// its name is a checksum of everything in there that the drive is or carries, and of the program's
/// version; how it is modelled and computed has no part in it. InputError if there is no cache.
std::string calibration_file(const std::string &fixed);

/// What was found for that drive; nothing if it has not been calibrated, or if the file is damaged,
/// of which @p note then says so.
std::vector<StudyResult> find_calibration(const std::string &fixed, std::string &note);

/// A model as far as a calibration tells models apart.
struct CalibratedModel
{
  std::string fidelity;
  bool        exact   = false; ///< without penalty
  bool        oval    = false; ///< rollers become ovals
  bool        secants = false; ///< Effects/Stiffness curves = off, which no study judges
};

/// What @p results say of this @p model; empty: nothing.
std::vector<StudyResult> results_of(const std::vector<StudyResult> &results,
                                    const CalibratedModel          &model);

/// Two digits, or all before the point, with sign: "+2.3 %". From @p value [1].
std::string in_percent(double value);

/// These in a sentence, and as member `accuracy` of summary.json.
std::string accuracy_sentence(const std::vector<StudyResult> &results);
files::Json to_json(const std::vector<StudyResult> &results);

/// A drive as far as errors found for it depend on it: "name=value", with the unit in the name.
std::vector<std::string> drive_in_words(const drive::Facts &facts);

/// In what a drive differs from the one that was studied, in words. Less than 1 % is no difference,
/// nor are 5 % of the inertia, which differ between one that is given and one of the parts.
std::string difference(const std::vector<std::string> &studied,
                       const std::vector<std::string> &here);

/// What is wanted: an output and how wrong it may be [1]. From "NAME=PERCENT"; InputError when it
/// is not that, or when no study of @p results judges the output, with those that are judged.
std::pair<std::string, double> read_wanted(const std::string              &text,
                                           const std::vector<StudyResult> &results);

/// A model of which a plan speaks, and what errors come together in a run of it.
struct Candidate
{
  StudyResult model;    ///< the error of the model with its interval, 1
  double      run = 0.; ///< half interval of the window and start phase of the run, over the truth
  StudyResult together; ///< the error with the interval of all
  /// Window with which the interval of all lies within what is wanted, in pitches: that of the run
  /// where this suffices, infinite where none does.
  double pitches = std::numeric_limits<double>::infinity();
  double cost    = 0.; ///< of the run with that window, over that of the reference as it is

  bool suffices() const { return pitches < std::numeric_limits<double>::infinity(); }
};

/// How wide the half interval of a run of the model of @p candidate may be, over its own mean, so
/// that the interval of all lies within @p wanted [1]. 1; zero: no run suffices
double room_for_run(const Candidate &candidate, double wanted);

/// What studies answer.
struct Answer
{
  std::vector<Candidate> all;   ///< the models that were judged, in the order of their cost
  std::vector<Candidate> found; ///< those that are accurate enough, the cheapest first
  /// The one whose model is the most accurate, whatever the window.
  std::optional<Candidate> best;
};

/// Which variants of @p results give @p output within @p wanted [1] in the run @p here or in one
/// with a longer window of up to 10000 pitches. The reference counts as a model without error where
/// the scatter of its runs is known, else with the interval of its own mean.
Answer answer(const std::vector<StudyResult> &results,
              const std::string              &output,
              double                          wanted,
              const RunAtHand                &here);

/// How a rigid model did on all drives that studies ran.
struct Spread
{
  std::string  variant;
  unsigned int n_drives = 0;
  unsigned int n_within = 0;          ///< with an error of at most what was wanted
  double       least = 0., most = 0.; ///< errors, 1
};

/// That of layered and simple bodies in @p output, where more than one drive is known: says what a
/// drive that no study ran may expect, and no more than that.
std::vector<Spread>
spread_of(const std::vector<StudyResult> &results, const std::string &output, double wanted);

/// Whether the layered model of the drive of @p parameters can have rollers that become ovals, and
/// these bear its load (drive::oval_load()).
bool bears_ovals(const Parameters &parameters, const drive::Facts &facts);

/// What is expected of the models of @p studies.fits on a drive with the groups @p here, by @p
/// output: error with the interval that holds for 90 of 100 drives, the cheapest model first. Empty
/// where a fit needs a group that the drive does not have.
std::vector<StudyResult> predicted(const Studies                       &studies,
                                   const std::string                   &output,
                                   const std::map<std::string, double> &here);

/// In what groups a drive lies beyond all drives of @p studies, in words; empty: in none.
std::string beyond(const Studies &studies, const std::map<std::string, double> &here);

/// By how much the reference of calibrations may itself be wrong in @p output for what its mesh,
/// modes and step are: the root of the sum of the squares of the errors that were found, on the
/// paper's drive; those whose interval contains zero were not. 1
double of_numerics(const Studies &studies, const std::string &output);

/// By how much samples of histories @p interval [s] apart change @p output, as study `sampling`
/// found on the paper's drive: its errors over the interval, without sign, on straight lines from
/// zero on, and beyond the longest in proportion. 1; zero where that study does not judge it
double of_sampling(const Studies &studies, const std::string &output, double interval);

/// @p result with @p numerics [1] in its interval: errors that know nothing of each other add by
/// squares.
StudyResult with_numerics(StudyResult result, double numerics);

/// Says for each `--accuracy` of @p command_line what @p calibrated answers, or, if that is empty,
/// what the studies answer if they ran the drive of @p facts, or what they let expect: in the first
/// line the cheapest settings, their error with the interval of all that is known, and their cost
/// here, by measure_cost() with @p before, as drawn from a rigid model; then a table of the models.
/// Where @p estimated, the parts have not been solved yet: they are not for this answer, and their
/// stiffnesses are those of dimensions. InputError as read_wanted(). Collective.
void print_answers(std::ostream                   &out,
                   const CommandLine              &command_line,
                   const Parameters               &parameters,
                   const drive::Facts             &facts,
                   const std::vector<StudyResult> &calibrated,
                   bool                            estimated,
                   double                          before,
                   MPI_Comm                        comm);
} // namespace chaindrive
