// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/accuracy.h>
#include <chaindrive/commands.h>
#include <chaindrive/cost.h>
#include <chaindrive/drive/checks.h>
#include <chaindrive/drive/facts.h>
#include <chaindrive/drive/picture.h>
#include <chaindrive/element/part_report.h>
#include <chaindrive/files/console.h>
#include <chaindrive/files/directory.h>
#include <chaindrive/files/file.h>
#include <chaindrive/model/decide.h>
#include <chaindrive/model/reading.h>
#include <chaindrive/observe/checkpoints.h>
#include <chaindrive/observe/field_output.h>
#include <chaindrive/observe/progress.h>
#include <chaindrive/observe/until.h>
#include <chaindrive/plugins.h>
#include <chaindrive/scene/plan.h>
#include <chaindrive/simulated_life.h>
#include <chaindrive/simulation.h>
#include <chaindrive/statics/part_stiffness.h>
#include <chaindrive/utilities/announce.h>
#include <chaindrive/utilities/checksum.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/first_rank.h>
#include <chaindrive/utilities/ranks.h>
#include <chaindrive/utilities/signals.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/mpi.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string>
#include <unistd.h>
#include <vector>

// A simulation with all that surrounds it: the .prm file, the output directory and what goes there,
// what was there before, the console, signals.

namespace chaindrive
{
namespace
{
std::string output_directory(const CommandLine &command_line, const Parameters &parameters)
{
  if (!command_line.output_directory.empty())
    return command_line.output_directory;
  if (!parameters.output.directory.empty())
    return parameters.output.directory;
  return "results/" + std::filesystem::path(command_line.parameter_file).stem().string();
}

/// Says where results go if the .prm file alone sends them outside of its folder and of that of the
/// call: it may be somebody else's.
std::string far_away(const CommandLine &command_line, const std::string &output)
{
  namespace fs = std::filesystem;
  if (output.empty() || !command_line.output_directory.empty())
    return "";
  const auto inside = [](const fs::path &inner, const fs::path &outer) {
    const fs::path path = fs::weakly_canonical(fs::absolute(inner))
                              .lexically_relative(fs::weakly_canonical(fs::absolute(outer)));
    return !path.empty() && *path.begin() != "..";
  };
  const fs::path folder = fs::path(command_line.parameter_file).parent_path();
  if (inside(output, fs::current_path()) || inside(output, folder.empty() ? "." : folder))
    return "";
  return "Output/Directory = " + output +
         " of the parameter file lies outside of its folder and of the present one: the results go "
         "there.";
}

/// All entries as a .prm file, which says with which plug-ins they were read.
std::string record_of(const parameters::Input &input)
{
  std::ostringstream text;
  print_plugins(text, "# ");
  text << input.resolved;
  return text.str();
}

/// The loaded plug-ins, as summary.json has them.
files::Json plugins_as_json()
{
  files::Json all = files::Json::array();
  for (const Plugin &plugin : loaded_plugins())
    all.push_back({{"name", plugin.name},
                   {"version", plugin.version},
                   {"path", plugin.path},
                   {"checksum", plugin.checksum}});
  return all;
}

/// Prints the drive's block at once, before any part is solved; returns what it says. Nothing on
/// other ranks than the first, and of a drive that cannot be: the simulation refuses it.
std::optional<drive::Facts>
print_first_facts(const Parameters &parameters, files::Log &log, const MPI_Comm comm)
{
  if (rank_in(comm) != 0)
    return std::nullopt;
  try
    {
      const model::Effects effects = model::decide_effects(parameters);
      const auto           wanted  = model::part_stiffnesses(parameters, effects);
      const drive::Drive   drive =
          drive::make_drive(parameters, statics::quick_part_stiffness(wanted, parameters.material));
      const drive::Facts facts = drive::make_facts(parameters, drive);
      drive::print(log, facts);
      log << std::flush;
      return facts;
    }
  catch (const InputError &)
    {
      return std::nullopt;
    }
}

/// Says on @p log what takes long.
Announce announce_on(files::Log &log)
{
  return [&log](const std::string &sentence) { log << sentence << std::endl; };
}

/// A .prm file that can be run, and a log that says so.
struct Prepared
{
  Prepared(const CommandLine &command_line, const MPI_Comm comm)
      : out(STDOUT_FILENO)
      , err(STDERR_FILENO)
      , log(command_line.quiet || rank_in(comm) != 0 ? nullptr : &out,
            rank_in(comm) == 0 ? &err : nullptr)
      , input(model::read_parameters(command_line.parameter_file, command_line.overrides))
      , folders(mesh_folders(command_line.parameter_file))
      , first_facts(print_first_facts(input.parameters, log, comm))
      , simulation(input.parameters, folders, comm, announce_on(log))
      , fixed(fixed_text(input, simulation.drive, folders))
      , resume(command_line.resume.empty() ? input.parameters.output.resume : command_line.resume)
      , directory(output_directory(command_line, input.parameters))
      , strict(command_line.strict)
  {
  }

  files::Console                 out, err;
  files::Log                     log;
  const parameters::Input        input;
  const std::vector<std::string> folders;
  std::optional<drive::Facts>    first_facts; ///< printed before anything elastic was solved
  Simulation                     simulation;
  const std::string              fixed;  ///< fixed_text()
  const std::string              resume; ///< from what the run is to go on, if from anything
  files::Directory               directory;
  const bool                     strict; ///< whether what the checks find is not run
};

/// The answers to `--accuracy`, if it is given: the first lines of a plan.
void answer_first(const CommandLine &command_line, const double before, const MPI_Comm comm)
{
  if (command_line.accuracy.empty())
    return;
  const parameters::Input input =
      model::read_parameters(command_line.parameter_file, command_line.overrides);
  const auto wanted =
      model::part_stiffnesses(input.parameters, model::decide_effects(input.parameters));
  const drive::Drive drive = drive::make_drive(
      input.parameters, statics::quick_part_stiffness(wanted, input.parameters.material));
  files::Console out(STDOUT_FILENO), err(STDERR_FILENO);
  files::Log     log(command_line.quiet || rank_in(comm) != 0 ? nullptr : &out,
                 rank_in(comm) == 0 ? &err : nullptr);
  std::string note;
  const auto  calibrated =
      find_calibration(fixed_text(input, drive, mesh_folders(command_line.parameter_file)), note);
  print_answers(log,
                command_line,
                input.parameters,
                drive::make_facts(input.parameters, drive),
                calibrated,
                statics::is_estimated(drive.notes),
                before,
                comm);
  log << std::flush;
}

/// Whether a signal came to any rank while the run was prepared; says so. Collective.
bool stopped_before_first_step(Prepared &prepared)
{
  const int number = dealii::Utilities::MPI::max(stop_signal(), prepared.simulation.communicator());
  if (number != 0)
    prepared.log << "Stopped by " << name_of_stop_signal(number)
                 << " before the first step. Nothing was computed or written." << std::endl;
  return number != 0;
}

/// The checkpoint that the run goes on from, if any, whose step it then has: the same to the last
/// bit on any machine.
std::unique_ptr<files::CheckpointFile> find_checkpoint(Prepared &prepared)
{
  auto checkpoint = observe::find_checkpoint(
      prepared.resume, prepared.directory.path(), prepared.fixed, prepared.log);
  if (checkpoint != nullptr)
    prepared.simulation.step.step = checkpoint->header().dt;
  return checkpoint;
}

void print_step(std::ostream &log, const stability::TimeStepChoice &choice, const unsigned long n)
{
  log << "Critical time step (us): ";
  for (const stability::TimeStepLimit &limit : choice.step_limits)
    log << limit.source << " " << to_text(limit.limit * 1e6, 4) << ", ";
  log << "all coupled " << to_text(choice.limit * 1e6, 4) << '\n'
      << "Step: " << to_text(choice.step * 1e6, 4) << " us (" << choice.reason << "), " << n
      << " steps\n";
}

/// Says what the checks of the drive find. InputError if that is not to be run.
void print_checks(Prepared &prepared)
{
  const auto checks =
      drive::check_design(prepared.simulation.parameters, prepared.simulation.facts);
  for (const drive::Check &check : checks)
    prepared.log.warn(check.sentence);
  if (prepared.strict && !checks.empty())
    throw InputError("With --strict a drive with warnings is not run; there are " +
                     std::to_string(checks.size()) + ", above.");
}

/// The drive, notes, warnings, and what will be computed.
void print_plan(Prepared &prepared)
{
  Simulation         &simulation = prepared.simulation;
  const Parameters   &parameters = simulation.parameters;
  files::Log         &log        = prepared.log;
  const double        step       = simulation.step.step;
  const unsigned long n_steps    = simulation.n_steps();
  if (parameters.acoustics.noise)
    check_noise(simulation.drive, simulation.facts, parameters);
  if (prepared.first_facts)
    drive::print_changes(log, *prepared.first_facts, simulation.facts);
  else
    drive::print(log, simulation.facts);
  drive::print(log, simulation.life());
  print_plugins(log);
  for (const std::string &note : prepared.input.notes)
    log << note << '\n';
  for (const std::string &warning : prepared.input.warnings)
    log.warn(warning);
  if (parameters.output.history_interval < step)
    log.warn(
        "Output/History interval in us = " + to_text(parameters.output.history_interval * 1e6) +
        " is shorter than the step of " + to_text(step * 1e6, 4) + " us: every step is a sample, " +
        std::to_string(n_steps + 1) + " in all.");
  print_checks(prepared);
  scene::print_plan(log, simulation.scene);
  print_step(log, simulation.step, n_steps);
}

/// The meshes, for who wants to know.
void print_meshes(Prepared &prepared)
{
  std::vector<element::PartReport> reports;
  for (const auto &[of, part] : prepared.simulation.scene.parts)
    reports.push_back(element::make_report(*part, prepared.simulation.parameters.material));
  if (!reports.empty())
    element::print(prepared.log, reports);
}

void warn(files::Log &log, const std::string &sentence)
{
  if (!sentence.empty())
    log.warn(sentence);
}

/// Nothing is refused any more: from here on what an earlier run has left is replaced. Collective.
void begin_files(Prepared &prepared, const bool resumes)
{
  files::Directory        &directory = prepared.directory;
  const parameters::Input &input     = prepared.input;
  on_first_rank(prepared.simulation.communicator(), [&] {
    warn(prepared.log, directory.take_over(resumes, input.parameters.output.csv));
    prepared.log.open(directory.path() + "/log.txt", resumes);
    files::write_text(directory.path() + "/input.prm", input.text);
    files::write_text(directory.path() + "/parameters.prm", record_of(input));
  });
  for (files::Console *console : {&prepared.out, &prepared.err})
    console->give_up_after(std::chrono::seconds(2)); // it is all in the file
}

/// What is to be said of a window that waits for the drive to settle and has not become full.
std::string window_sentence(const Simulation &simulation)
{
  const observe::Window &window = simulation.window();
  const double           time   = simulation.system().world.time;
  if (!window.waits() || window.is_full(time) ||
      (window.settled() && !simulation.model.output.until.empty()))
    return "";
  const std::string end = "Time/End time in ms = " + to_text(simulation.parameters.time.end * 1e3);
  return window.settled() ?
             "The window of the averages, from " + to_text(window.start() * 1e3, 5) +
                 " ms on, is not full at " + end + ": it would end at " +
                 to_text(window.end() * 1e3, 5) + " ms." :
             "The drive has not settled before " + end +
                 ": there are no means over a window. It is judged over " +
                 std::to_string(window.judged_pitches()) +
                 " pitch times, so that the window can be full at " +
                 to_text(window.earliest_end() * 1e3, 5) +
                 " ms at the earliest. Run longer, or give Output/Window start in ms a time.";
}

/// Says what makes key figures of the run meaningless.
void warn_of_events(files::Log &log, const files::Json &summary)
{
  if (!summary.contains("events"))
    return;
  for (const files::Json &event : summary["events"])
    log.warn(event["sentence"].get<std::string>() +
             (event["in_window"].get<bool>() ?
                  " It was so in the window: means over it are not valid." :
                  " It was not so in the window of the means."));
}

/// What is to be said of elements whose stiffness against hourglassing has a part in the results.
std::string hourglass_sentence(const files::Json &summary)
{
  constexpr double most = 0.05; // as is usual for elements of one point
  if (!summary.contains("artificial_energy") || !summary["artificial_energy"].is_number() ||
      summary["artificial_energy"].get<double>() <= most)
    return "";
  return to_text(100. * summary["artificial_energy"].get<double>(), 2) +
         " % of the energy of elastic bodies, in the mean over the run, is that of hourglass modes "
         "and "
         "stands for nothing in them; up to " +
         to_text(100. * most) +
         " % is usual. Choose a greater Mesh/Refinement, or Elements/Formulation = enhanced.";
}

/// What @p calibrated says of the model of this run.
std::vector<StudyResult> results_here(const Prepared                 &prepared,
                                      const std::vector<StudyResult> &calibrated)
{
  const model::Model &model = prepared.simulation.model;
  return results_of(
      calibrated,
      {prepared.simulation.parameters.model.fidelity,
       model.effects.is_on(model::Effect::exact_joints),
       model.effects.is_on(model::Effect::oval_rollers),
       prepared.simulation.parameters.effects.stiffness_curves == parameters::Switch::off});
}

/// Computes the noise of the run that has just ended; says why if that cannot be.
void try_noise(Prepared &prepared)
{
  try
    {
      write_noise(prepared.directory.path(), prepared.simulation.parameters, prepared.log);
    }
  catch (const InputError &error)
    {
      prepared.log.warn(std::string("There is no noise: ") + error.what());
    }
}

/// Writes summary.json and the end of the log. Collective.
void end_files(Prepared &prepared)
{
  observe::Summary  summary = prepared.simulation.summary();
  const auto       &system  = prepared.simulation.system();
  const auto       &step    = prepared.simulation.step;
  const std::string overload =
      system.contacts.overload_sentence(system.world, step.step / step.limit);
  if (!prepared.simulation.system().world.is_first_rank())
    return;
  files::Log &log = prepared.log;
  if (!loaded_plugins().empty())
    summary.values["plugins"] = plugins_as_json();
  std::string note;
  const auto  errors = results_here(prepared, find_calibration(prepared.fixed, note));
  warn(log, note);
  if (!errors.empty())
    summary.values["accuracy"] = to_json(errors);
  files::write_json(prepared.directory.path() + "/summary.json", summary.values);
  if (const std::string sentence =
          observe::until_sentence(summary.values, prepared.simulation.system().world.time);
      !sentence.empty())
    log << sentence << '\n';
  warn(log, window_sentence(prepared.simulation));
  warn_of_events(log, summary.values);
  warn(log, hourglass_sentence(summary.values));
  warn(log, overload);
  observe::print_summary(log, summary.values);
  log << simulated_life_in_words(summary.values["life"]);
  if (!errors.empty())
    log << accuracy_sentence(errors) << '\n';
  PhaseTimer::print(log, summary.phases);
  observe::print_ranks(log, summary.ranks);
  if (prepared.simulation.parameters.acoustics.noise)
    try_noise(prepared);
  log << "Results: " << prepared.directory.path() << '\n';
  log.close();
}
} // namespace

std::string fixed_text(const parameters::Input        &input,
                       const drive::Drive             &drive,
                       const std::vector<std::string> &folders)
{
  std::string text = plugins_text() + "\n" + input.fixed;
  for (const drive::Sprocket &sprocket : drive.sprockets)
    if (!sprocket.mesh.empty())
      text += "the checksum of the mesh '" + sprocket.mesh +
              "' = " + checksum(files::read_text(files::find_file(sprocket.mesh, folders))) + "\n";
  for (const drive::Sprocket &sprocket : drive.sprockets)
    for (const std::string &file : sprocket.program.files)
      text += "the checksum of the table '" + std::filesystem::path(file).filename().string() +
              "' of the " + sprocket.title + " = " + checksum(files::read_text(file)) + "\n";
  return text;
}

std::vector<std::string> mesh_folders(const std::string &parameter_file)
{
  const std::string folder = std::filesystem::path(parameter_file).parent_path().string();
  return {folder.empty() ? "." : folder, "."};
}

bool plan_command(const CommandLine &command_line, const MPI_Comm comm)
{
  const double before = PhaseTimer::total();
  answer_first(command_line, before, comm);
  Prepared prepared(command_line, comm);
  if (prepared.simulation.is_idle())
    return true;
  if (stopped_before_first_step(prepared))
    return false;
  find_checkpoint(prepared);
  print_plan(prepared);
  Simulation &simulation = prepared.simulation;
  print(prepared.log,
        measure_cost(simulation, prepared.folders, before),
        n_ranks_in(simulation.communicator()));
  std::string note;
  const auto  calibrated = find_calibration(prepared.fixed, note);
  warn(prepared.log, note);
  if (const std::string sentence = accuracy_sentence(results_here(prepared, calibrated));
      !sentence.empty())
    prepared.log << sentence << '\n';
  if (!command_line.picture.empty())
    {
      std::ostringstream picture;
      drive::draw(picture, simulation.drive, simulation.facts);
      files::write_text(command_line.picture, picture.str());
      prepared.log << "Picture: " << command_line.picture << '\n';
    }
  print_meshes(prepared);
  return true;
}

std::optional<std::string> run_command(const CommandLine &command_line, const MPI_Comm comm)
{
  Prepared    prepared(command_line, comm);
  Simulation &simulation = prepared.simulation;
  if (simulation.is_idle())
    return prepared.directory.path();
  if (stopped_before_first_step(prepared))
    return std::nullopt;
  on_first_rank(simulation.communicator(), [&] {
    prepared.directory.spare(command_line.parameter_file);
    warn(prepared.log, far_away(command_line, prepared.input.parameters.output.directory));
    warn(prepared.log, prepared.directory.strangers());
    warn(prepared.log, prepared.directory.claim());
  });
  const auto checkpoint = find_checkpoint(prepared);
  print_plan(prepared);
  print_meshes(prepared);

  const Parameters  &parameters = simulation.parameters;
  dynamics::System  &system     = simulation.system();
  observe::Recorder &recorder   = simulation.recorder();
  files::Log        &log        = prepared.log;
  const std::string &path       = prepared.directory.path();
  recorder.write_histories(path, record_of(prepared.input), simulation.n_steps());
  observe::FieldOutput field_output(simulation.scene, simulation.model, system, path, system.timer);
  observe::Progress    progress(log, parameters.time.start, parameters.time.end);

  std::vector<dynamics::Observer *> others = {&field_output, &progress},
                                    saved  = simulation.observers();
  saved.insert(saved.end(), others.begin(), others.end());
  observe::Checkpoints checkpoints(parameters.time,
                                   parameters.output,
                                   path,
                                   prepared.fixed,
                                   simulation.n_steps(),
                                   simulation.step.step,
                                   saved,
                                   log);
  others.push_back(&checkpoints);
  const unsigned long done = checkpoint != nullptr ? checkpoints.resume(system, *checkpoint) : 0;
  begin_files(prepared, checkpoint != nullptr);

  try
    {
      simulation.run(others, done);
    }
  catch (const dynamics::Fault &fault)
    {
      recorder.close(false);
      throw RunError(log.end_with(fault.what() +
                                  std::string(" Histories up to this moment are complete.") +
                                  checkpoints.last_valid(fault.valid_until())));
    }
  catch (const RunError &error)
    {
      throw RunError(log.end_with(error.what() + checkpoints.last()));
    }
  const bool finished = simulation.is_finished();
  warn(log, recorder.close(finished));
  if (finished)
    end_files(prepared);
  else
    log.close();
  return finished ? std::make_optional(path) : std::nullopt;
}
} // namespace chaindrive
