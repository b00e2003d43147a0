// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/command_line.h>
#include <chaindrive/drive/drive.h>
#include <chaindrive/drive/facts.h>
#include <chaindrive/parameters/reader.h>

#include <mpi.h>

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace chaindrive
{
/// Where a calibration is kept, and what each of its runs takes before it computes anything.
struct CalibrationFile
{
  std::string path;
  double      start_up; ///< CPU time of a start of the program, s
};

/// Where the meshes that @p parameter_file names are looked for.
std::vector<std::string> mesh_folders(const std::string &parameter_file);

/// What a resumed run must find as it was: plug-ins, parameters::Input::fixed and the contents of
/// meshes and tables.
std::string fixed_text(const parameters::Input        &input,
                       const drive::Drive             &drive,
                       const std::vector<std::string> &folders);

/// Runs the .prm file named on the command line: a Simulation with its files, its checkpoints, the
/// log and the console. Throws InputError for input that cannot be run and RunError for a run that
/// failed. Returns the directory of the results of a run that came to its end: none when a signal
/// or the wall-clock limit stopped it, after a checkpoint was written. Collective.
std::optional<std::string> run_command(const CommandLine &command_line, MPI_Comm comm);

/// Prints what that run would compute and what it costs. Returns whether it came to its end; throws
/// as run_command().
bool plan_command(const CommandLine &command_line, MPI_Comm comm);

/// Prints what the parts of that drive weigh, how they deflect and how they vibrate: masses,
/// inertias, stiffness over the load, stresses of side plates, natural frequencies, from elastic
/// solutions that are kept in the cache. Writes no other file. Throws as run_command(). Collective.
void parts_command(const CommandLine &command_line, MPI_Comm comm);

/// Computes the noise of the run whose directory is named on the command line, writes
/// acoustics.json and acoustics.h5 there (doc/output.md) and prints a table. Throws InputError for
/// a directory, a summary or histories that it cannot be computed from, naming file and dataset.
void noise_command(const CommandLine &command_line);

/// The same for a run at hand that has ended in @p directory; the table goes to @p out.
void write_noise(const std::string &directory, const Parameters &parameters, std::ostream &out);

/// InputError, before a run, where its noise could not be computed whatever the rollers do.
void check_noise(const drive::Drive &drive,
                 const drive::Facts &facts,
                 const Parameters   &parameters);

/// Writes a .prm file to begin with to @p out: one that can be run for @p design, whose number of
/// links is the even one that comes nearest to its centre distance; without a design every entry
/// with its default. In the form that CommandLine::kind asks for; so is a parameter file that the
/// command line names. Throws InputError for a drive that cannot be, and a form that there is not.
void template_command(const CommandLine &command_line, std::ostream &out);

/// Prints a table of the drives that would do for what the command line asks of them
/// (drive/selection.h), the best first, which is written as a .prm file where a name for it is
/// given. Throws InputError for a demand that has no sense, or that no drive meets where a file was
/// asked for.
void select_command(const CommandLine &command_line, std::ostream &out);

/// Prints the dimensions of a sprocket of the parameter file, and writes it as a drawing or a solid
/// where a file name is given (drive/sprocket_files.h). Throws InputError for a wheel that there is
/// not, for one whose teeth come from a file, and for other kinds of files.
void sprocket_command(const CommandLine &command_line, std::ostream &out);

/// Expands the study file named on the command line, prepares the first run of every variant as
/// plan_command() does, of the other start phases the drive and the scene, and throws InputError
/// with a sentence for each variant that cannot run, before anything is written; then writes a
/// folder with its .prm file for each run. Returns the words of the command that runs them, which
/// is to take this process's place: Snakemake; nothing for `--dry-run`. Of a @p calibration it says
/// first what the runs take.
std::vector<std::string> study_command(const CommandLine                    &command_line,
                                       MPI_Comm                              comm,
                                       const std::optional<CalibrationFile> &calibration = {});

/// The same for the study that finds the errors of the models on the drive of the parameter file:
/// simple, layered and reduced bodies without penalty, the reference, from four start phases each,
/// settled, over as many pitch times as its slowest resonance takes, at least six; a drive whose
/// speed or load follows a course of its own runs as its file says. What it finds is kept in the
/// cache for plans and runs of this drive. InputError for a drive that stands, or that the
/// reference cannot compute.
std::vector<std::string> calibrate_command(const CommandLine &command_line, MPI_Comm comm);

/// The words of the command that writes a page on the runs whose folders are named on the command
/// line, and is to take this process's place: Python, with the package chaindrive. InputError on
/// several ranks.
std::vector<std::string> report_command(const CommandLine &command_line, MPI_Comm comm);

/// The words of the command that writes histories or sound of the runs whose folders are named on
/// the command line for other programs, likewise.
std::vector<std::string> export_command(const CommandLine &command_line, MPI_Comm comm);

/// Those of a report for the run that has just left its results in @p directory: it ends well
/// whatever becomes of the page.
std::vector<std::string> report_after_run(const std::string &directory);
} // namespace chaindrive
