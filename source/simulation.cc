// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/drive.h>
#include <chaindrive/dynamics/time_loop.h>
#include <chaindrive/element/part_report.h>
#include <chaindrive/files/console.h>
#include <chaindrive/files/directory.h>
#include <chaindrive/files/file.h>
#include <chaindrive/mesh/import/import.h>
#include <chaindrive/observe/checkpoints.h>
#include <chaindrive/observe/recorder.h>
#include <chaindrive/parameters/reader.h>
#include <chaindrive/scene/build.h>
#include <chaindrive/scene/plan.h>
#include <chaindrive/simulation.h>
#include <chaindrive/utilities/checksum.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/first_rank.h>
#include <chaindrive/utilities/ranks.h>
#include <chaindrive/utilities/signals.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/mpi.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <unistd.h>
#include <vector>

// READ THIS FILE FIRST. What flows through the program, in the order in which it does:
//
//   .prm -> Parameters -> Drive -> Scene -> System (World, forces) -> time loop -> Recorder

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

void print_step(std::ostream &log, const dynamics::StepChoice &choice, const unsigned long n)
{
  log << "Stable step (us): ";
  for (const dynamics::StepLimit &vote : choice.step_limits)
    log << vote.source << " " << to_text(vote.limit * 1e6, 4) << ", ";
  log << "all coupled " << to_text(choice.limit * 1e6, 4) << '\n'
      << "Step: " << to_text(choice.step * 1e6, 4) << " us (" << choice.reason << "), " << n
      << " steps\n";
}

/// What a resumed run must find as it was: @p fixed (parameters::Input) and the contents of meshes.
std::string with_contents(const std::string              &fixed,
                          const drive::Drive             &drive,
                          const std::vector<std::string> &folders)
{
  std::string text = fixed;
  for (const drive::Sprocket &sprocket : drive.sprockets)
    if (!sprocket.mesh.empty())
      text += "the checksum of the mesh '" + sprocket.mesh +
              "' = " + checksum(files::read_text(mesh::find_file(sprocket.mesh, folders))) + "\n";
  return text;
}

/// Whether a signal came to any rank of @p comm while the run was prepared; says so. Collective.
bool stopped_before_first_step(files::Log &log, const MPI_Comm comm)
{
  const int number = dealii::Utilities::MPI::max(stop_signal(), comm);
  if (number != 0)
    log << "Stopped by " << name_of_stop_signal(number)
        << " before the first step. Nothing was computed or written." << std::endl;
  return number != 0;
}

void warn(files::Log &log, const std::string &sentence)
{
  if (!sentence.empty())
    log.warn(sentence);
}
} // namespace

bool simulate(const CommandLine &command_line, const MPI_Comm comm)
{
  const bool     is_first_rank = rank_in(comm) == 0;
  files::Console out(STDOUT_FILENO), err(STDERR_FILENO);
  files::Log     log(command_line.quiet || !is_first_rank ? nullptr : &out,
                 is_first_rank ? &err : nullptr);

  const parameters::Input input =
      parameters::read_parameters(command_line.parameter_file, command_line.overrides);
  const Parameters  &parameters = input.parameters;
  const drive::Drive drive      = drive::make_drive(parameters);
  const std::string  folder =
      std::filesystem::path(command_line.parameter_file).parent_path().string();
  const std::vector<std::string> folders = {folder.empty() ? "." : folder, "."};
  const scene::Scene             scene   = scene::build_scene(parameters, drive, folders);
  const std::string              fixed   = with_contents(input.fixed, drive, folders);

  if (!scene.has_elastic_bodies() && !is_first_rank)
    return true;
  dynamics::System     system(scene,
                          parameters.contact.search == parameters::Search::every_step,
                          scene.has_elastic_bodies() ? comm : MPI_COMM_SELF);
  dynamics::StepChoice choice  = dynamics::choose_step(system, parameters);
  const MPI_Comm       at_work = system.world.communicator();
  if (stopped_before_first_step(log, at_work))
    return false;

  files::Directory  directory(output_directory(command_line, parameters));
  const std::string resume =
      command_line.resume.empty() ? parameters.output.resume : command_line.resume;
  on_first_rank(at_work, [&] {
    if (command_line.command != Command::plan)
      warn(log, directory.claim());
  });
  const auto checkpoint = observe::find_checkpoint(resume, directory.path(), fixed, log);
  const bool resumes    = checkpoint != nullptr;
  if (resumes)
    choice.step = checkpoint->header().dt; // the same to the last bit on any machine
  const double        start = parameters.time.start, end = parameters.time.end;
  const unsigned long n_steps = dynamics::n_steps(start, end, choice.step);

  for (const std::string &note : input.notes)
    log << note << '\n';
  for (const std::string &warning : input.warnings)
    log.warn(warning);
  if (parameters.output.history_interval < choice.step)
    log.warn(
        "Output/History interval in us = " + to_text(parameters.output.history_interval * 1e6) +
        " is shorter than the step of " + to_text(choice.step * 1e6, 4) +
        " us: every step is a sample, " + std::to_string(n_steps + 1) + " in all.");
  scene::print_plan(log, scene, system.memory_consumption(), n_steps);
  for (const auto &[kind, part] : scene.parts)
    element::print(log, element::make_report(*part, parameters.material));
  print_step(log, choice, n_steps);
  if (command_line.command == Command::plan)
    return true;

  observe::Recorder recorder(
      scene, parameters, system, n_steps, directory.path(), input.resolved, system.timer, log);
  dynamics::Guard guard(
      scene, system, parameters.time.energy_limit, choice.limit, parameters.time.guard);
  observe::Checkpoints checkpoints(
      parameters, directory.path(), fixed, n_steps, choice.step, recorder, guard, log);
  unsigned long done = resumes ? checkpoints.resume(system, *checkpoint) : 0;

  // Nothing is refused any more: from here on what an earlier run has left is replaced.
  on_first_rank(at_work, [&] {
    warn(log, directory.take_over(resumes, parameters.output.csv));
    log.open(directory.path() + "/log.txt", resumes);
    files::write_text(directory.path() + "/input.prm", input.text);
    files::write_text(directory.path() + "/parameters.prm", input.resolved);
  });
  for (files::Console *console : {&out, &err})
    console->give_up_after(std::chrono::seconds(2)); // it is all in the file

  try
    {
      done = dynamics::run(system, checkpoints, guard, start, end, choice.step, done);
    }
  catch (const dynamics::Fault &fault)
    {
      recorder.close(false);
      throw RunError(log.end_with(fault.what() + checkpoints.last_sound(fault.sound_until())));
    }
  catch (const RunError &error)
    {
      throw RunError(log.end_with(error.what() + checkpoints.last()));
    }
  const bool finished = done == n_steps;
  recorder.close(finished);
  if (!finished)
    {
      log.close();
      return false;
    }

  const auto        table   = observe::rows_of_all_ranks(system.timer, system.world.communicator());
  const files::Json summary = recorder.summary(system, guard, choice, n_steps, table);
  if (!is_first_rank)
    return true;
  files::write_json(directory.path() + "/summary.json", summary);
  observe::print_summary(log, summary);
  PhaseTimer::print(log, table);
  log << "Results: " << directory.path() << '\n';
  log.close();
  return true;
}
} // namespace chaindrive
