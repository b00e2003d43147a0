// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/accuracy.h>
#include <chaindrive/commands.h>
#include <chaindrive/drive/facts.h>
#include <chaindrive/model/decide.h>
#include <chaindrive/model/reading.h>
#include <chaindrive/statics/part_stiffness.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/ranks.h>
#include <chaindrive/utilities/text.h>
#include <chaindrive/utilities/timing.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

namespace chaindrive
{
namespace
{
constexpr unsigned int n_phases = 4;
constexpr unsigned int run_in   = 3; ///< pitch times from the settled start to the window
constexpr unsigned int shortest = 6; ///< window, pitch times: with all phases 24 engagements

/// Whether speed or load of the drive follow a course over time, which has no settled part to judge
/// but the one that the file looks at.
bool has_course(const parameters::Input &input)
{
  for (const std::string name : {"/Changes/Times in ms = ", "/Table/File = "})
    for (std::size_t at = input.fixed.find(name); at != std::string::npos;
         at             = input.fixed.find(name, at + 1))
      if (input.fixed[at + name.size()] != '\n')
        return true;
  return input.fixed.find("Loads/Torque step time in ms = auto\n") == std::string::npos;
}

/// A rigid model that is judged.
struct RigidModel
{
  std::string name, fidelity;
  bool        oval; ///< Effects/Oval rollers
};

/// Those that can be had of this drive.
std::vector<RigidModel> rigid_models(const Parameters &parameters, const drive::Facts &facts)
{
  std::vector<RigidModel> models = {{"simple", "simple", false}, {"layered", "layered", false}};
  if (bears_ovals(parameters, facts))
    models.push_back({"oval", "layered", true});
  return models;
}

/// "path={{a|b|c}}": what @p value says of each of the @p models, and @p of_reference, which comes
/// last.
template <typename Value>
std::string of_models(const std::string             &path,
                      const std::vector<RigidModel> &models,
                      const Value                   &value,
                      const std::string             &of_reference)
{
  std::string text = path + "={{";
  for (const RigidModel &model : models)
    text += value(model) + "|";
  return text + of_reference + "}}";
}

/// Of the rigid models what the file says of @p path, of the reference auto: it has the parts' own.
std::string of_rigid_models(const parameters::Input       &input,
                            const std::string             &path,
                            const std::vector<RigidModel> &models)
{
  const std::string name  = path + " = ";
  const std::size_t begin = input.fixed.find(name) + name.size();
  std::string       value = input.fixed.substr(begin, input.fixed.find('\n', begin) - begin);
  return of_models(
      path, models, [&](const RigidModel &) { return value; }, "auto");
}

std::string in_ms(const double time) { return to_text(1e3 * time, 6); }

/// What makes a study of the drive's file.
std::vector<std::string> entries_of(const parameters::Input &input, const drive::Facts &facts)
{
  const double pitch_time = facts.pitch_time;
  const auto   models     = rigid_models(input.parameters, facts);
  std::string  names, fidelities;
  for (const RigidModel &model : models)
    {
      names += model.name + ", ";
      fidelities += model.fidelity + "|";
    }
  const auto same = [](const std::string &value) {
    return [value](const RigidModel &) { return value; };
  };
  const unsigned int       window = std::max(shortest, drive::pitches_per_resonance(facts));
  const std::string        text = "How wrong are the models for this drive? The reference, exact, "
                                  "has reduced bodies without penalty.";
  std::vector<std::string> entries = {
      "Study/Title=Calibration of " + facts.chain + ", " + std::to_string(facts.links) + " links",
      "Study/Text=" + text,
      "Study/Names=" + names + "exact",
      "Study/Reference=exact",
      "Study/Outputs=" + join(calibrated_outputs()),
      "Study/Phases=" + std::to_string(n_phases),
      "Model/Fidelity={" + fidelities + "reduced}",
      "Model/Symmetry model=auto",
      "Model/Elastic links=all",
      of_models("Contact/Enforcement", models, same("auto"), "exact"),
      of_models(
          "Effects/Oval rollers",
          models,
          [](const RigidModel &m) { return std::string(m.oval ? "on" : "off"); },
          "off"),
      "Effects/Stiffness curves=auto",
      "Effects/Tooth compliance over place=auto",
      of_rigid_models(input, "Model/Mass per pitch in g", models),
      of_rigid_models(input, "Model/Stiffness per pitch in N/m", models),
      of_rigid_models(input, "Contact/Roller-tooth stiffness in N/m", models),
      of_rigid_models(input, "Contact/Roller-bush stiffness in N/m", models),
      // as many columns around pins and bushes as in prm/paper/reduced.prm
      of_models("Mesh/Refinement", models, same("0"), "1"),
      "Time/Time step in us=auto",
      "Output/Quantities=all",
      "Output/History interval in us=" + to_text(1e6 * std::min(20e-6, 2e-3 * pitch_time), 3),
      "Output/Field interval in ms=0",
      "Output/CSV=false",
      "Output/Until=",
      "Output/Directory=",
      "Output/Resume=",
      "Acoustics/Noise=off"};
  if (!has_course(input))
    entries.insert(entries.end(),
                   {"Drive/Layout/Start=settled",
                    "Time/Start time in ms=0",
                    "Time/End time in ms=" + in_ms((run_in + window) * pitch_time),
                    "Output/Window start in ms=" + in_ms(run_in * pitch_time),
                    "Output/Window end in ms=auto"});
  return entries;
}
} // namespace

std::vector<std::string> calibrate_command(const CommandLine &command_line, const MPI_Comm comm)
{
  if (n_ranks_in(comm) > 1)
    throw InputError("A calibration starts its runs itself: start it without mpirun.");
  const double            start_up = PhaseTimer::total(); // before parts are solved
  const parameters::Input input =
      model::read_parameters(command_line.parameter_file, command_line.overrides);
  const std::vector<std::string> folders = mesh_folders(command_line.parameter_file);
  const auto                     wanted =
      model::part_stiffnesses(input.parameters, model::decide_effects(input.parameters));
  const drive::StiffnessOf stiffness =
      statics::part_stiffness(wanted, input.parameters.material, comm, [&](const auto &sentence) {
        if (!command_line.quiet)
          std::cout << sentence << std::endl;
      });
  const drive::Drive drive = drive::make_drive(input.parameters, stiffness);
  const drive::Facts facts = drive::make_facts(input.parameters, drive);
  if (!(input.parameters.loads.driver_speed > 0.))
    throw InputError("A drive that stands has no impacts by which models could be judged: "
                     "Loads/Driver speed in rad/s = 0 must be above 0.");

  CommandLine study = command_line;
  for (const std::string &entry : entries_of(input, facts))
    study.overrides.push_back(entry);
  if (study.output_directory.empty())
    study.output_directory =
        "results/calibrate-" + std::filesystem::path(command_line.parameter_file).stem().string();
  try
    {
      return study_command(
          study,
          comm,
          CalibrationFile{calibration_file(fixed_text(input, drive, folders)), start_up});
    }
  catch (const InputError &error)
    {
      throw InputError("The calibration, which takes all models, cannot begin: " +
                       std::string(error.what()));
    }
}
} // namespace chaindrive
