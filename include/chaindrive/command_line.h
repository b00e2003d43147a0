// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace chaindrive
{
/// What the program is to do. A new one is a row of the table in command_line.cc and a case in
/// main.cc.
enum class Command
{
  run,           ///< compute the drive of a .prm file
  plan,          ///< say what would be computed and what it costs
  parts,         ///< print masses and stiffnesses of the parts
  noise,         ///< compute the noise of a run that has ended
  study,         ///< run the variants of a study file and compare them
  calibrate,     ///< find the errors of the models for a drive
  report,        ///< write a page on runs
  export_files,  ///< write results for other programs
  select,        ///< which chains would do
  sprocket,      ///< draw a sprocket
  template_file, ///< print a .prm file to begin with
  document,      ///< print doc/parameters.md
  serve,         ///< be ready for many starts
  version,
  help
};

/// What the user asked for on the command line.
struct CommandLine
{
  Command                  command = Command::run;
  std::string              parameter_file;   ///< noise: the directory of a run; serve: the socket
  std::vector<std::string> overrides;        ///< "Section/Entry=value", in the order given
  std::vector<std::string> plugins;          ///< shared libraries to load, in the order given
  std::string              output_directory; ///< empty: what the .prm file says
  std::string              resume;           ///< empty: what the .prm file says
  bool                     quiet  = false;   ///< warnings and errors only
  bool                     strict = false;   ///< run, plan: no drive that a check finds fault with
  bool                     report = false;   ///< run: a page on it at its end
  std::string              picture;          ///< plan: SVG file of the layout; empty: none
  std::string              chart;            ///< select: SVG file; empty: none
  std::vector<std::string> accuracy;         ///< plan: "OUTPUT=PERCENT"
  std::string              wheel;            ///< sprocket: its name; empty: the driver
  unsigned int             cores   = 0;      ///< study: runs at a time; 0: as many as there are
  bool                     quick   = false;  ///< study: with the changes of Study/Quick
  bool                     dry_run = false;  ///< study: say what would be run
  bool                     retry   = false;  ///< study: run those again that failed
  /// template: the drive that it is for; select: what is asked of it.
  struct Design
  {
    std::optional<std::string> chain, teeth;          ///< such as 10B and 21/63
    std::optional<double>      centre, rpm, kilowatt; ///< mm; of the driver; of the load
    std::optional<double>      torque;                ///< at the driver, N m, instead of the power
    std::optional<std::string> fidelity;              ///< of the model

    std::optional<double>       ratio, hours;
    std::optional<unsigned int> strands; ///< of the chain; of a selection at most
    std::optional<std::string>  motor, shock, lubrication;

    bool is_given() const { return chain || teeth || centre || rpm || kilowatt || torque; }
    /// kW of the load, given or by the torque; complete designs and demands have one.
    double power() const;

    bool is_complete() const { return chain && teeth && centre && rpm && (kilowatt || torque); }
  };
  Design                   design;
  bool                     man    = false; ///< document: as the manual page
  bool                     schema = false; ///< document: what is in the results
  std::string              completion;     ///< document: as the completion of this shell
  std::vector<std::string> folders;        ///< report, export: those of the runs
  std::string              kind;           ///< export: csv or wav; template: prm, xml or json
  std::vector<std::string> rest;           ///< study: options of Snakemake, after `--`
};

/// Reads the arguments of main(): `chaindrive [COMMAND] [FILE.prm] [OPTION]...`, where the command
/// may be left out for run. Throws InputError for an unknown command or option, naming the nearest
/// one, and when there is no .prm file although the command needs one, or one that it does not
/// take, and for options that the command has no use for.
CommandLine parse_command_line(int argc, const char *const *argv);

/// A command as `--help` lists it.
struct CommandText
{
  std::string name;
  std::string argument; ///< that it needs, FILE.prm or DIR; empty: it takes none
  std::string meaning;
};

/// An option as `--help` lists it.
struct OptionText
{
  std::string name;    ///< with its dashes
  std::string value;   ///< what stands for its value; empty: it takes none
  std::string meaning; ///< "COMMAND, COMMAND: ..." where it belongs to these only

  /// The commands of its meaning; empty: all.
  std::vector<std::string> commands() const;
};

/// All commands and options in the order of `--help`.
std::vector<CommandText> command_texts();
std::vector<OptionText>  option_texts();

/// The manual page (troff, section 1) and the completion for bash, made from these two tables.
std::string man_page();
std::string bash_completion();

/// What `--help` prints.
std::string help_text();

/// What `--version` prints: versions of the program and of deal.II, the SIMD instructions of this
/// processor, the width of the kernels that run on it (utilities/simd.h, whose InputError it
/// throws), and the number of MPI ranks.
std::string version_text();
} // namespace chaindrive
