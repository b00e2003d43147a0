// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/commands.h>
#include <chaindrive/cost.h>
#include <chaindrive/files/console.h>
#include <chaindrive/files/data_folder.h>
#include <chaindrive/files/file.h>
#include <chaindrive/files/json.h>
#include <chaindrive/files/log.h>
#include <chaindrive/files/temporary_directory.h>
#include <chaindrive/model/decide.h>
#include <chaindrive/model/reading.h>
#include <chaindrive/observe/progress.h>
#include <chaindrive/packages.h>
#include <chaindrive/parameters/entries.h>
#include <chaindrive/parameters/reader.h>
#include <chaindrive/plugins.h>
#include <chaindrive/scene/build.h>
#include <chaindrive/simulation.h>
#include <chaindrive/statics/part_stiffness.h>
#include <chaindrive/utilities/checksum.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/processes.h>
#include <chaindrive/utilities/ranks.h>
#include <chaindrive/utilities/signals.h>
#include <chaindrive/utilities/text.h>
#include <chaindrive/utilities/timing.h>
#include <chaindrive/version.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <iomanip>
#include <map>
#include <new>
#include <optional>
#include <sstream>
#include <string>
#include <sys/file.h>
#include <thread>
#include <unistd.h>
#include <vector>

// A study up to the point where its runs can begin: which runs there are, whether each can run, a
// folder with its .prm file for each. Snakemake takes over from there, with
// scripts/study/Snakefile.

namespace chaindrive
{
namespace
{
namespace fs = std::filesystem;

constexpr const char *phase_entry = "Drive/Layout/Start phase";

/// One run of a variant.
struct Run
{
  std::string                        folder; ///< within that of the study
  double                             phase;
  std::map<std::string, std::string> values;
  std::string                        text; ///< of its .prm file
};

/// A variant with its runs.
struct Model
{
  const parameters::Variant *variant;
  std::vector<Run>           runs;
  files::Json                estimate; ///< what a run costs; null: nobody has asked
};

/// What estimates of the cost of runs need, which copies of this process make.
struct Estimating
{
  std::string folder;   ///< a temporary one; empty: nothing is to be estimated
  double      cpu = 0.; ///< that this process has taken until then, as each run will, s
};

/// How many are at work at a time.
unsigned int n_cores(const CommandLine &c)
{
  return c.cores > 0 ? c.cores : std::max(1U, std::thread::hardware_concurrency());
}

std::string study_directory(const CommandLine &c)
{
  return !c.output_directory.empty() ?
             c.output_directory :
             "results/" + fs::path(c.parameter_file).stem().string() + (c.quick ? "-quick" : "");
}

/// The runs of @p variant: from @p n start phases, evenly distributed from its own on.
std::vector<Run> make_runs(const parameters::Variant &variant, const unsigned int n)
{
  const auto   given = variant.values.find(phase_entry);
  const double first =
      given == variant.values.end() ?
          0. :
          parameters::from_entry_text(given->second, parameters::unit::si).value_or(0.);
  std::vector<Run> runs;
  for (unsigned int i = 0; i < n; ++i)
    {
      const std::string phase = to_text(std::fmod(first + double(i) / n, 1.));
      Run run = {variant.name + "/phase-" + phase, std::stod(phase), variant.values, {}};
      if (n > 1)
        run.values[phase_entry] = phase;
      runs.push_back(run);
    }
  return runs;
}

/// Whether the entry @p path names a file that a run reads: a mesh or a table.
bool names_a_file(const std::string &path)
{
  const auto between = [&path](const std::string &begin, const std::string &end) {
    return path.size() > begin.size() + end.size() && path.compare(0, begin.size(), begin) == 0 &&
           path.compare(path.size() - end.size(), end.size(), end) == 0;
  };
  return between("Drive/Sprockets/", " mesh") || between("Loads/", "/Table/File");
}

/// Names files that are read by their whole paths in @p run, and says their checksums in the
/// returned comment: a mesh that changes is another run.
std::string settle_files(Run &run, const std::vector<std::string> &folders)
{
  std::string comment;
  for (auto &[path, value] : run.values)
    if (names_a_file(path) && !value.empty())
      {
        std::string file;
        try
          {
            file = files::find_file(value, folders);
          }
        catch (const InputError &error)
          {
            throw InputError(path + " = " + value + ": " + error.what());
          }
        value = fs::absolute(file).lexically_normal().string();
        comment += "# " + path + ": checksum " + checksum(files::read_text(file)) + "\n";
      }
  return comment;
}

/// Everything about @p run: a run that is finished is repeated when this text changes.
std::string text_of(const Run                 &run,
                    const parameters::Variant &variant,
                    const parameters::Study   &study,
                    const std::string         &meshes)
{
  const parameters::Input input = model::read_entries(run.values);
  study.check_quantities(input.parameters.output);
  std::ostringstream plugins;
  print_plugins(plugins, "# ");
  return "# " + variant.name + ", start phase " + to_text(run.phase) + ", for chaindrive " +
         version + (variant.ranks > 1 ? " on " + std::to_string(variant.ranks) + " ranks" : "") +
         "\n" + meshes + plugins.str() + "\n" + input.resolved;
}

/// Whether @p run stands in @p directory as it is: then it was checked when it was written.
bool is_known(const Run &run, const std::string &directory)
{
  const std::string file = directory + "/" + run.folder + "/variant.prm";
  return fs::exists(file) && files::read_text(file) == run.text;
}

/// Prepares @p run, all of it or only its drive and scene. How elastic bodies settle takes long,
/// and is found when the run begins. Returns what the run costs if @p estimating asks for it.
/// InputError when it cannot run.
files::Json prepare(const Run &run, const bool all, const Estimating &estimating)
{
  parameters::Input    input   = model::read_entries(run.values);
  const model::Effects effects = model::decide_effects(input.parameters);
  const drive::Drive   drive =
      drive::make_drive(input.parameters,
                        statics::part_stiffness(model::part_stiffnesses(input.parameters, effects),
                                                input.parameters.material,
                                                MPI_COMM_SELF));
  scene::build_scene(model::make_model(input.parameters, drive, effects), drive, {"."});
  if (!all)
    return {};
  const auto &wheels = input.parameters.drive.sprockets.list;
  if (input.parameters.model.capabilities().is_elastic &&
      std::none_of(wheels.begin(), wheels.end(), [](const parameters::Sprocket &wheel) {
        return is_sprung(wheel.held.holder); // its spring has to be borne
      }))
    input.parameters.drive.layout.start = parameters::Start::taut;
  Simulation simulation(input.parameters, {"."}, MPI_COMM_SELF);
  simulation.n_steps();
  if (estimating.folder.empty())
    return {};
  ::setenv("TMPDIR", estimating.folder.c_str(), 1); // of a process that ends with this check
  const Cost cost = measure_cost(simulation, {"."}, estimating.cpu);
  return {{"cpu", cost.total()}, {"memory", cost.memory}};
}

/// Completes and checks all runs of @p model. Returns the sentences of those that cannot run: one
/// if the first cannot. Start phases differ in where bodies begin, and no more of the others is
/// prepared. Estimates what a run costs if @p estimating asks for it and it is not known.
std::string check(Model                        &model,
                  const parameters::StudyInput &input,
                  const std::string            &directory,
                  const Estimating             &estimating)
{
  std::map<std::string, std::string> phases_of; // by sentence
  for (Run &run : model.runs)
    try
      {
        const std::string meshes = settle_files(run, input.folders);
        run.text                 = text_of(run, *model.variant, input.study, meshes);
        const bool first         = &run == &model.runs.front();
        const bool unknown       = !is_known(run, directory);
        if (first && unknown)
          model.estimate = nullptr; // what is there is of another run
        const bool asked = first && !estimating.folder.empty() && model.estimate.is_null();
        if (stop_signal() == 0 && (unknown || asked))
          if (const files::Json cost = prepare(run, first, asked ? estimating : Estimating());
              !cost.is_null())
            model.estimate = cost;
      }
    catch (const InputError &error)
      {
        if (&run == &model.runs.front())
          return "\n" + model.variant->name + ": " + error.what();
        std::string &phases = phases_of[error.what()];
        phases += (phases.empty() ? "" : ", ") + to_text(run.phase);
      }
  std::string sentences;
  for (const auto &[sentence, phases] : phases_of)
    sentences += "\n" + model.variant->name + " from start phase " + phases + ": " + sentence;
  return sentences;
}

/// check() in another process, and what it has found out there.
std::string check_elsewhere(Model                         model,
                            const parameters::StudyInput &input,
                            const std::string            &directory,
                            const Estimating             &estimating)
{
  files::Json found = {{"sentences", check(model, input, directory, estimating)},
                       {"texts", files::Json::array()},
                       {"estimate", model.estimate}};
  for (const Run &run : model.runs)
    found["texts"].push_back(run.text);
  const std::vector<std::uint8_t> bytes = files::Json::to_cbor(found); // texts may be no UTF-8
  return {bytes.begin(), bytes.end()};
}

/// Takes what check_elsewhere() has found out about @p model; returns the sentences.
std::string adopt_result(Model &model, const WorkResult &result)
{
  using End = WorkResult::End;
  if (result.end == End::input)
    throw InputError(result.text);
  if (result.end == End::memory)
    throw std::bad_alloc();
  if (result.end == End::exception)
    throw RunError(model.variant->name + ": " + result.text);
  if (result.end != End::good)
    throw RunError("The variant " + model.variant->name +
                   " could not be checked, nor once more alone: " + result.text +
                   ". There may be too little memory for it.");
  const files::Json found = files::Json::from_cbor(result.text);
  for (std::size_t i = 0; i < model.runs.size(); ++i)
    model.runs[i].text = found["texts"][i];
  model.estimate = found["estimate"];
  return found["sentences"];
}

/// How far the checks are: a line that is rewritten on a terminal, elsewhere one now and then.
class CheckProgress
{
public:
  CheckProgress(files::Log &log, const std::size_t n)
      : log_(log), n_(n), terminal_(observe::Progress::console_is_terminal())
  {
  }
  ~CheckProgress() { log_.show_status(""); }
  CheckProgress(const CheckProgress &)            = delete;
  CheckProgress &operator=(const CheckProgress &) = delete;

  void operator()(const std::size_t done)
  {
    using namespace std::chrono_literals;
    const auto now = Clock::now();
    if (done == n_ || now - said_ < (terminal_ ? 200ms : 10s))
      return;
    said_                = now;
    const double elapsed = std::chrono::duration<double>(now - began_).count();
    std::string  text    = std::to_string(done) + " of " + std::to_string(n_) + " variants checked";
    if (done > 0)
      text += ", left " + observe::duration_text(elapsed * static_cast<double>(n_ - done) /
                                                 static_cast<double>(done));
    if (terminal_)
      log_.show_status(text);
    else
      log_ << "  " << text << std::endl;
  }

private:
  using Clock = std::chrono::steady_clock;

  files::Log             &log_;
  const std::size_t       n_;
  const bool              terminal_;
  const Clock::time_point began_ = Clock::now();
  Clock::time_point       said_  = began_;
};

/// Tells @p models what was found earlier, by the study in @p directory, of the cost of runs.
void recall_estimates(std::vector<Model> &models, const std::string &directory)
{
  const std::string file = directory + "/study.json";
  if (!fs::exists(file))
    return;
  const files::Json about = files::Json::parse(files::read_text(file), nullptr, false);
  if (!about.is_object() || !about.contains("variants") || !about["variants"].is_array())
    return;
  std::map<std::string, files::Json> known;
  for (const files::Json &variant : about["variants"])
    if (variant.is_object() && variant.contains("name") && variant["name"].is_string() &&
        variant.contains("estimate") && variant["estimate"].is_object() &&
        variant["estimate"].value("cpu", files::Json()).is_number() &&
        variant["estimate"].value("memory", files::Json()).is_number())
      known[variant["name"]] = variant["estimate"];
  for (Model &model : models)
    if (const auto found = known.find(model.variant->name); found != known.end())
      model.estimate = found->second;
}

/// Completes and checks all @p models, several at a time; with the CPU time @p start_up [s] that a
/// program takes before it computes anything it also estimates what runs cost. InputError with the
/// sentences of all that cannot run, in their order. Returns early after a stop signal.
void check_all(std::vector<Model>           &models,
               const parameters::StudyInput &input,
               const std::string            &directory,
               const CommandLine            &command_line,
               const std::optional<double>   start_up,
               files::Log                   &log)
{
  std::vector<WorkResult> results;
  {
    std::optional<files::TemporaryDirectory> scratch; // in which copies of this process may die
    if (start_up)
      scratch.emplace(MPI_COMM_SELF);
    const Estimating estimating = scratch ? Estimating{scratch->path(), *start_up} : Estimating();
    recall_estimates(models, directory);
    CheckProgress progress(log, models.size());
    results = do_in_processes(
        models.size(),
        n_cores(command_line),
        [&](const std::size_t i) {
          return check_elsewhere(models[i], input, directory, estimating);
        },
        [&](const std::size_t done) { progress(done); });
  }
  if (stop_signal() != 0)
    return;
  std::string refused;
  std::size_t n_refused = 0;
  for (std::size_t i = 0; i < models.size(); ++i)
    {
      const std::string sentences = adopt_result(models[i], results[i]);
      refused += sentences;
      n_refused += sentences.empty() ? 0 : 1;
      if (command_line.dry_run)
        log << "  " << models[i].variant->name << (sentences.empty() ? "" : "  cannot run") << '\n';
    }
  log << std::flush;
  if (n_refused > 0)
    throw InputError(std::to_string(n_refused) + " of " + std::to_string(models.size()) +
                     " variants cannot run; nothing was started:" + refused);
}

/// One study works in a directory at a time. The lock is not given back: Snakemake inherits it with
/// this process, and it ends with that, however it ends.
void claim(const std::string &directory)
{
  std::error_code error;
  fs::create_directories(directory, error);
  const std::string file       = directory + "/study.lock";
  const int         descriptor = ::open(file.c_str(), O_RDWR | O_CREAT, 0666);
  if (descriptor < 0)
    throw InputError("The study cannot write into the directory '" + directory +
                     "': " + std::strerror(errno) + ". Choose another one with --output.");
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    throw InputError("Another study is at work in '" + directory +
                     "'. Wait for its end, or choose another directory with --output.");
}

files::Json as_json(const parameters::StudyInput         &input,
                    const std::vector<Model>             &models,
                    const CommandLine                    &command_line,
                    const std::optional<CalibrationFile> &calibration)
{
  const parameters::Study &study = input.study;
  files::Json              json;
  json["file"] = command_line.parameter_file;
  json["title"] =
      study.title.empty() ? fs::path(command_line.parameter_file).stem().string() : study.title;
  json["text"]    = study.text;
  json["quick"]   = command_line.quick;
  json["program"] = fs::read_symlink("/proc/self/exe").string();
  json["version"] = version;
  json["plugins"] = files::Json::array();
  for (const Plugin &plugin : loaded_plugins())
    json["plugins"].push_back(plugin.path);
  json["reference"] = study.reference;
  json["outputs"]   = study.outputs;
  json["against"]   = study.against;
  for (const parameters::StudyOutput &output : parameters::study_outputs())
    json["units"][output.name] = output.unit;
  if (calibration)
    json["calibration"] = calibration->path;
  for (const Model &model : models)
    {
      files::Json variant = {{"name", model.variant->name}, {"ranks", model.variant->ranks}};
      for (const auto &[path, value] : model.variant->choices)
        variant["changes"][path] = value;
      if (!model.estimate.is_null())
        variant["estimate"] = model.estimate;
      for (const Run &run : model.runs)
        variant["runs"].push_back({{"phase", run.phase}, {"folder", run.folder}});
      json["variants"].push_back(variant);
    }
  return json;
}

/// Says what all runs of @p models take on @p cores.
void print_estimates(const std::vector<Model> &models, const unsigned int cores, files::Log &log)
{
  double sum = 0., longest = 0.;
  for (const Model &model : models)
    if (!model.estimate.is_null())
      {
        const double cpu = model.estimate["cpu"];
        log << "  " << model.variant->name << ": " << model.runs.size() << " runs of "
            << observe::duration_text(cpu) << "\n";
        sum += cpu * static_cast<double>(model.runs.size());
        longest = std::max(longest, cpu);
      }
  log << "All of them take " << observe::duration_text(std::max(sum / cores, longest)) << " on "
      << cores << (cores == 1 ? " core" : " cores") << " or a little more" << std::endl;
}

/// Forgets how a run in @p folder ended if that cannot be read, its results are gone, or it failed
/// and is to be tried again. Returns whether it has to be computed.
bool forget(const std::string &folder, const bool retry)
{
  const std::string end = folder + "/result.json";
  if (!fs::exists(end))
    return true;
  const files::Json result = files::Json::parse(files::read_text(end), nullptr, false);
  const bool        known  = result.is_object() && result.contains("status") &&
                     result["status"].is_number_integer() && result.contains("error") &&
                     result["error"].is_string();
  if (known && (result["status"] == 0 ? fs::exists(folder + "/summary.json") : !retry))
    return false;
  fs::remove(end);
  return true;
}

/// Writes the .prm file of each run that is new or another, and forgets what has to be computed
/// again: with it the pages, since Snakemake leaves out what only an up-to-date page was made of.
void write(const std::string        &directory,
           const std::vector<Model> &models,
           const files::Json        &json,
           const bool                retry)
{
  bool is_complete = true;
  for (const Model &model : models)
    for (const Run &run : model.runs)
      {
        const std::string folder = directory + "/" + run.folder;
        fs::create_directories(folder);
        if (!is_known(run, directory))
          files::write_text(folder + "/variant.prm", run.text);
        if (forget(folder, retry))
          is_complete = false;
      }
  if (!is_complete)
    fs::remove(directory + "/study.html");
  files::write_json(directory + "/study.json", json);
}

/// Whether there is a program of this name to start.
bool is_installed(const std::string &program)
{
  const char        *path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "/bin:/usr/bin" : path);
  for (std::string folder; std::getline(folders, folder, ':');)
    if (::access((fs::path(folder) / program).c_str(), X_OK) == 0)
      return true;
  return false;
}

std::vector<std::string> snakemake(const CommandLine &c, const std::string &directory)
{
  const std::string        scripts = files::data_folder("scripts");
  std::vector<std::string> words   = {"snakemake",
                                      "--snakefile",
                                      scripts + "/study/Snakefile",
                                      "--directory",
                                      directory,
                                      "--cores",
                                      std::to_string(n_cores(c)),
                                      "--keep-going",
                                      "--ignore-incomplete", // result.json is written at once
                                      "--rerun-triggers", // variant.prm is new when it is another
                                      "mtime",
                                      "--nolock", // claim() has locked the directory
                                      "--scheduler",
                                      "greedy"};
  if (c.quiet)
    words.insert(words.end(), {"--quiet", "all"});
  words.insert(words.end(), c.rest.begin(), c.rest.end());
  return words;
}
} // namespace

std::vector<std::string> study_command(const CommandLine                    &command_line,
                                       const MPI_Comm                        comm,
                                       const std::optional<CalibrationFile> &calibration)
{
  if (n_ranks_in(comm) > 1)
    throw InputError("A study starts its runs itself, each on Study/Ranks processes: start it "
                     "without mpirun.");
  const parameters::StudyInput input = parameters::read_study(
      command_line.parameter_file, command_line.overrides, command_line.quick);
  const std::string directory = study_directory(command_line);
  files::Console    out(STDOUT_FILENO);
  files::Log        log(command_line.quiet ? nullptr : &out);

  for (const std::string &note : input.notes)
    log << note << '\n';
  std::vector<Model> models;
  for (const parameters::Variant &variant : input.variants)
    {
      if (input.study.phases > 1 &&
          std::any_of(variant.choices.begin(), variant.choices.end(), [](const auto &choice) {
            return choice.first == phase_entry;
          }))
        throw InputError("Both " + std::string(phase_entry) +
                         " and Study/Phases = " + std::to_string(input.study.phases) +
                         " vary the start phase: set Study/Phases = 1.");
      models.push_back({&variant, make_runs(variant, input.study.phases), {}});
    }
  if (!command_line.dry_run && !is_installed("snakemake"))
    throw RunError("Snakemake, which runs the variants, is not installed. " +
                   packages_of_studies());
  log << models.size() << " variants from " << input.study.phases
      << " start phases each: checking all before the first begins" << std::endl;
  std::optional<double> start_up;
  if (calibration)
    start_up = calibration->start_up;
  else if (!command_line.rest.empty() && !command_line.dry_run) // for a cluster
    start_up = PhaseTimer::total();
  check_all(models, input, directory, command_line, start_up, log);
  if (stop_signal() != 0)
    return {};
  if (calibration)
    print_estimates(models, n_cores(command_line), log);
  if (command_line.dry_run)
    return {};
  claim(directory);
  write(directory, models, as_json(input, models, command_line, calibration), command_line.retry);
  std::error_code missing;
  if (calibration) // is kept anew, for the cache may have lost it
    std::filesystem::remove(directory + "/calibration.txt", missing);
  log << "Results: " << directory << std::endl;
  return snakemake(command_line, directory);
}
} // namespace chaindrive
