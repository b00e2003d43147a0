// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/command_line.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/simd.h>
#include <chaindrive/utilities/text.h>
#include <chaindrive/version.h>

#include <deal.II/base/config.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <cstdlib>
#include <iomanip>
#include <sstream>

namespace chaindrive
{
namespace
{
namespace options = boost::program_options;

/// The commands, as the user names them.
struct CommandName
{
  Command     command;
  const char *name;
  const char *argument; ///< that it needs; null: it takes none
  const char *meaning;
};

constexpr CommandName commands[] = {
    {Command::run,
     "run",
     "FILE.prm",
     "simulate the drive of FILE.prm; the word run may be omitted"},
    {Command::plan,
     "plan",
     "FILE.prm",
     "print design data, what would be computed and its cost; write nothing"},
    {Command::parts,
     "parts",
     "FILE.prm",
     "print masses, stiffnesses and plate stresses of the parts; write nothing"},
    {Command::noise,
     "noise",
     "DIR",
     "compute the noise of the run whose results are in DIR, and write it there"},
    {Command::study,
     "study",
     "FILE.prm",
     "run the variants of a study file and compare them; options after -- go to Snakemake"},
    {Command::calibrate,
     "calibrate",
     "FILE.prm",
     "find by runs how wrong each model is for this drive; plans and runs then say it"},
    {Command::report,
     "report",
     "DIR...",
     "write a report on the runs in these folders, report.html in the first"},
    {Command::export_files,
     "export",
     "DIR...",
     "write histories (csv) or sound (wav) of the runs in these folders for other programs"},
    {Command::select,
     "select",
     nullptr,
     "print which chains would do for a power, a speed, a ratio and a centre distance"},
    {Command::sprocket,
     "sprocket",
     "FILE.prm",
     "print the dimensions of a sprocket, or write it to a file for CAD: csv, dxf, svg, step, stl"},
    {Command::template_file,
     "template",
     nullptr,
     "print a commented parameter file to start from, or FILE in another form (--as)"},
    {Command::document, "document", nullptr, "print the reference of all entries (Markdown)"},
    {Command::serve,
     "serve",
     "SOCKET",
     "for scripts: start as often as asked on SOCKET, loading the libraries once"},
};

const CommandName *find_command(const std::string &name)
{
  for (const CommandName &command : commands)
    if (name == command.name)
      return &command;
  return nullptr;
}

/// Options that stand for a command.
struct Switches
{
  bool plan = false, write_parameters = false, write_documentation = false, version = false,
       help = false;
};

/// The value of an option that is known to be given.
template <typename Value>
options::typed_value<Value> *value_of(std::optional<Value> &member)
{
  return options::value<Value>()->notifier([&member](const Value &value) { member = value; });
}

options::options_description visible_options(CommandLine &c, Switches &switches)
{
  options::options_description visible(/*line_length=*/100);
  const auto                   add = [&](const char *name, bool &flag, const char *meaning) {
    visible.add_options()(name, options::bool_switch(&flag), meaning);
  };
  visible.add_options()(
      "set",
      options::value(&c.overrides)->value_name("\"SECTION/ENTRY=VALUE\""),
      "run, plan, parts, noise, study, calibrate, sprocket: override an entry of the file; may be "
      "repeated");
  visible.add_options()(
      "output",
      options::value(&c.output_directory)->value_name("DIRECTORY"),
      "run, plan, study, calibrate, export, report, select, sprocket: write the results there, or "
      "the report, the parameter file of the best drive or the sprocket, to this file");
  visible.add_options()(
      "as",
      options::value(&c.kind)->value_name("FORM"),
      "export, template: histories (csv) or, after the command noise, sound (wav); "
      "of parameter files prm, xml (for deal.II's parameter_gui) or json");
  visible.add_options()(
      "resume",
      options::value(&c.resume)->value_name("auto|CHECKPOINT"),
      "run, plan: resume from the newest checkpoint in the directory, or from this one");
  visible.add_options()("picture",
                        options::value(&c.picture)->value_name("FILE"),
                        "plan: draw wheels, chain and shaft loads into this SVG file");
  visible.add_options()("chart",
                        options::value(&c.chart)->value_name("FILE"),
                        "select: draw life, safety, size, impacts and sound into this SVG file");
  visible.add_options()(
      "accuracy",
      options::value(&c.accuracy)->value_name("\"OUTPUT=PERCENT\""),
      "plan: print which models reach this accuracy, from the drive's calibration "
      "or from the studies");
  visible.add_options()("wheel",
                        options::value(&c.wheel)->value_name("NAME"),
                        "sprocket: which one, by default the driver");
  visible.add_options()("cores",
                        options::value(&c.cores)->value_name("N"),
                        "study, calibrate: number of cores to use, all by default");
  add("quick", c.quick, "study: apply the changes in Study/Quick");
  add("dry-run", c.dry_run, "study, calibrate: check all variants and print what would be run");
  add("retry-failed", c.retry, "study, calibrate: run failed variants again");
  visible.add_options()("chain",
                        value_of(c.design.chain)->value_name("NAME"),
                        "template: chain of the drive, such as 10B");
  visible.add_options()("teeth",
                        value_of(c.design.teeth)->value_name("Z1/Z2"),
                        "template: teeth of driver and driven sprocket");
  visible.add_options()("centre",
                        value_of(c.design.centre)->value_name("MM"),
                        "template, select: centre distance, approximated with an even number of "
                        "links");
  visible.add_options()(
      "rpm", value_of(c.design.rpm)->value_name("RPM"), "template, select: speed of the driver");
  visible.add_options()(
      "kW", value_of(c.design.kilowatt)->value_name("KW"), "template, select: power of the load");
  visible.add_options()("Nm",
                        value_of(c.design.torque)->value_name("NM"),
                        "template, select: torque at the driver instead of the power");
  visible.add_options()("fidelity",
                        value_of(c.design.fidelity)->value_name("NAME"),
                        "template: fidelity of the model, simple by default");
  visible.add_options()("ratio",
                        value_of(c.design.ratio)->value_name("RATIO"),
                        "select: speed of the driver over that of the driven shaft");
  visible.add_options()("hours",
                        value_of(c.design.hours)->value_name("HOURS"),
                        "select: how long the chain is to last, 15000 by default");
  visible.add_options()("motor",
                        value_of(c.design.motor)->value_name("NAME"),
                        "select: electric (default), hydraulic or engine");
  visible.add_options()("shock",
                        value_of(c.design.shock)->value_name("NAME"),
                        "select: of the load, smooth (default), moderate or heavy");
  visible.add_options()("lubrication",
                        value_of(c.design.lubrication)->value_name("NAME"),
                        "select: none, manual, drip, bath or forced; by default as the speed asks");
  visible.add_options()(
      "strands",
      value_of(c.design.strands)->value_name("N"),
      "template, select: strands of the chain, 1 by default; of a selection at most so many, 3 by "
      "default");
  visible.add_options()(
      "plugin",
      options::value(&c.plugins)->value_name("LIBRARY"),
      "run, plan, parts, noise, study, calibrate, sprocket, template, document: load this shared "
      "library, which adds to the program; may be repeated");
  add("man", c.man, "document: print the manual page (troff)");
  add("schema", c.schema, "document: print all histories and summary members of runs (JSON)");
  visible.add_options()("completion",
                        options::value(&c.completion)->value_name("SHELL"),
                        "document: print the completion script for a shell (bash)");
  add("plan", switches.plan, "run, plan: the same as the command plan");
  add("quiet",
      c.quiet,
      "run, plan, noise, study, calibrate, report, export: print warnings and errors only");
  add("report", c.report, "run: write a report at its end, report.html in the output directory");
  add("strict", c.strict, "run, plan: refuse a drive with design-check warnings");
  add("version", switches.version, "print versions and SIMD and MPI support");
  add("help", switches.help, "print this text");
  return visible;
}

std::vector<std::string> long_names(const options::options_description &description)
{
  std::vector<std::string> names;
  for (const auto &option : description.options())
    names.push_back("--" + option->long_name());
  return names;
}

/// Refuses a value that is empty, as of an unset variable of a shell, or looks like the next
/// option.
void check_values(const options::variables_map &values, const CommandLine &c)
{
  const auto check = [](const char *name, const std::string &value, const char *meaning) {
    const std::string sentence =
        std::string("The option --") + name + " needs a value after it, " + meaning;
    if (value.empty())
      throw InputError(sentence + "; it is empty.");
    if (value.compare(0, 2, "--") == 0)
      throw InputError(sentence + ", not the option " + value + ".");
  };
  if (values.count("output") > 0)
    check("output", c.output_directory, "a directory");
  if (values.count("resume") > 0)
    check("resume", c.resume, "auto or a checkpoint");
  if (values.count("picture") > 0)
    check("picture", c.picture, "a file");
  if (values.count("chart") > 0)
    check("chart", c.chart, "a file");
  for (const std::string &text : c.overrides)
    check("set", text, "Section/Entry=value");
  for (const std::string &file : c.plugins)
    check("plugin", file, "a shared library");
}

/// The widest vector instructions of this processor that a compiler of today would use.
std::string processor_simd()
{
#if defined(__x86_64__) || defined(__i386__)
  if (__builtin_cpu_supports("avx512f"))
    return "AVX-512, 512 bits";
  if (__builtin_cpu_supports("avx2"))
    return "AVX2, 256 bits";
  if (__builtin_cpu_supports("avx"))
    return "AVX, 256 bits";
  if (__builtin_cpu_supports("sse2"))
    return "SSE2, 128 bits";
  return "none";
#elif defined(__aarch64__)
  return "NEON, 128 bits";
#else
  return "not known for this processor";
#endif
}

/// Those that this program chooses here: elastic bodies and joints have them for each width.
std::string kernels_text()
{
  const int width = simd_width();
  return (width == 1 ? "one number at a time" :
                       std::to_string(width) + " numbers at a time, " + std::to_string(64 * width) +
                           " bits") +
         (std::getenv("CHAINDRIVE_SIMD_WIDTH") != nullptr ? ", as CHAINDRIVE_SIMD_WIDTH asks" : "");
}

/// Takes the command from the front of @p words, if there is one, else from the options.
Command take_command(std::vector<std::string> &words, const Switches &switches)
{
  if (switches.help)
    return Command::help;
  if (switches.version)
    return Command::version;
  if (switches.write_parameters)
    return Command::template_file;
  if (switches.write_documentation)
    return Command::document;
  Command command = Command::run;
  if (const CommandName *named = words.empty() ? nullptr : find_command(words.front()))
    {
      command = named->command;
      words.erase(words.begin());
    }
  return switches.plan && command == Command::run ? Command::plan : command;
}

/// Whether @p command starts several runs, by Snakemake.
bool is_of_runs(const Command command)
{
  return command == Command::study || command == Command::calibrate;
}

/// Whether @p command is for several runs that have ended.
bool takes_folders(const Command command)
{
  return command == Command::report || command == Command::export_files;
}

/// Refuses more files than @p command takes, or fewer than it needs; returns the file.
std::string file_of(const Command command, const std::vector<std::string> &words)
{
  for (const CommandName &named : commands)
    {
      if (named.command != command)
        continue;
      if (takes_folders(command))
        {
          if (words.empty())
            throw InputError(std::string("Which runs? Name the folders of their results: "
                                         "chaindrive ") +
                             named.name + " DIRECTORY...");
          return "";
        }
      if (named.argument == nullptr && !words.empty() && command != Command::template_file)
        throw InputError(std::string("The command ") + named.name +
                         " takes no file, but there is '" + words.front() + "'.");
      if (command == Command::noise && words.empty())
        throw InputError("Which run? Name the directory of its results: chaindrive noise DIR.");
      if (command == Command::noise && words.size() > 1)
        throw InputError("The command noise takes one directory, but there are '" + words[0] +
                         "' and '" + words[1] + "'.");
      if (command == Command::serve && words.size() != 1)
        throw InputError(
            "The command serve takes the path of one socket: chaindrive serve SOCKET.");
      if (named.argument != nullptr && words.empty())
        throw InputError("Which drive? Name a parameter file: chaindrive " +
                         (command == Command::run ? std::string() : named.name + std::string(" ")) +
                         "FILE.prm. chaindrive --help says more.");
    }
  if (words.size() > 1)
    {
      std::vector<std::string> names;
      for (const CommandName &named : commands)
        names.emplace_back(named.name);
      const std::string nearest = nearest_name(words.front(), names);
      throw InputError("One run takes one parameter file, but there are '" + words[0] + "' and '" +
                       words[1] + "'. " +
                       (nearest.empty() ? "An override needs --set before it, and quotes if it "
                                          "contains blanks." :
                                          "Did you mean the command " + nearest + "?"));
    }
  return words.empty() ? "" : words.front();
}

/// Refuses options that @p c.command has no use for: who gives one expects that it does something.
void refuse_useless(const options::variables_map &values, const CommandLine &c)
{
  if (c.command == Command::help || c.command == Command::version)
    return;
  const auto *named = std::find_if(std::begin(commands), std::end(commands), [&](const auto &row) {
    return row.command == c.command;
  });
  for (const OptionText &option : option_texts())
    {
      const auto                     value = values.find(option.name.substr(2));
      const std::vector<std::string> of    = option.commands();
      if (value == values.end() || value->second.defaulted() || of.empty() ||
          std::find(of.begin(), of.end(), named->name) != of.end())
        continue;
      std::string list;
      for (const std::string &name : of)
        list += (list.empty() ? "" : name == of.back() ? " and " : ", ") + name;
      throw InputError("The option " + option.name + " belongs to " + list + "; the command " +
                       named->name + " has no use for it.");
    }
}

constexpr unsigned int most_cores = 100000; // below what a negative number is read as

/// Refuses options of a study or a plan without one, and the other way round.
void check_belonging(const CommandLine &c)
{
  const bool is_study = is_of_runs(c.command);
  for (const auto &[given, name] : {std::pair<bool, const char *>{c.cores > 0, "--cores"},
                                    {c.dry_run, "--dry-run"},
                                    {c.retry, "--retry-failed"},
                                    {!c.rest.empty(), "--"}})
    if (given && !is_study && c.command != Command::help)
      throw InputError(
          std::string("The option ") + name +
          " belongs to studies and calibrations: chaindrive study FILE.prm, chaindrive "
          "calibrate FILE.prm.");
  if (!c.accuracy.empty() && c.command != Command::plan && c.command != Command::help)
    throw InputError("The option --accuracy belongs to plans: chaindrive plan FILE.prm.");
  if (!c.picture.empty() && c.command != Command::plan && c.command != Command::help)
    throw InputError("The option --picture belongs to plans: chaindrive plan FILE.prm.");
  if (!c.chart.empty() && c.command != Command::select && c.command != Command::help)
    throw InputError("The option --chart belongs to selections: chaindrive select.");
  // a picture replaces the file of its name, which might be that of the parameters
  for (const auto &[option, file] : {std::make_pair("--picture", c.picture), {"--chart", c.chart}})
    if (!file.empty() && (file.size() < 4 || file.compare(file.size() - 4, 4, ".svg") != 0))
      throw InputError(std::string("The option ") + option + " writes an SVG file, but '" + file +
                       "' is not called so; choose a name that ends in .svg.");
  if (c.design.is_given() && c.command != Command::template_file && c.command != Command::select &&
      c.command != Command::help)
    throw InputError("The options --chain, --teeth, --centre, --rpm, --kW and --Nm belong to "
                     "templates and selections: chaindrive template, chaindrive select.");
  if (c.design.kilowatt && c.design.torque)
    throw InputError("The options --kW and --Nm say the same: take one.");
  if (c.strict && c.command != Command::run && c.command != Command::plan &&
      c.command != Command::help)
    throw InputError("The option --strict belongs to runs and plans.");
  const char *const document = c.man ? "--man" : c.schema ? "--schema" : "--completion";
  if ((c.man || c.schema || !c.completion.empty()) && c.command != Command::document &&
      c.command != Command::help)
    throw InputError(std::string("The option ") + document +
                     " belongs to documents: chaindrive document.");
  if (!c.completion.empty() && c.completion != "bash")
    throw InputError("The option --completion = " + c.completion + " must be bash.");
  if (int(c.man) + int(c.schema) + int(!c.completion.empty()) > 1)
    throw InputError("The options --man, --schema and --completion print different documents: take "
                     "one.");
  if (c.command == Command::noise && (!c.output_directory.empty() || !c.resume.empty()))
    throw InputError("The options --output and --resume belong to runs: chaindrive noise DIR "
                     "writes into DIR.");
  if (c.report && c.command != Command::run && c.command != Command::help)
    throw InputError(
        "The option --report belongs to runs. The command for those that have ended is "
        "chaindrive report DIRECTORY.");
  if (takes_folders(c.command) && (!c.overrides.empty() || !c.resume.empty()))
    throw InputError(
        std::string("The option ") + (c.overrides.empty() ? "--resume" : "--set") +
        " belongs to runs: " + (c.command == Command::report ? "a report" : "an export") +
        " does not change them.");
  if (c.command == Command::export_files && c.kind.empty())
    throw InputError("The command export needs the option --as: csv for histories, wav for sound.");
  if (c.command == Command::export_files && c.kind != "csv" && c.kind != "wav")
    throw InputError("The option --as = " + c.kind +
                     " must be csv for histories or wav for sound.");
  if (c.quick && c.command != Command::study && c.command != Command::help)
    throw InputError("The option --quick belongs to studies: chaindrive study FILE.prm.");
  if (c.cores > most_cores)
    throw InputError("The option --cores takes 1 to " + std::to_string(most_cores) + ".");
  if (is_study && !c.resume.empty())
    throw InputError(
        "The option --resume belongs to runs: a study resumes when it is started again.");
}
} // namespace

double CommandLine::Design::power() const
{
  return kilowatt ? *kilowatt : 1e-3 * torque.value() * rpm.value() * dealii::numbers::PI / 30.;
}

CommandLine parse_command_line(const int argc, const char *const *const argv)
{
  CommandLine                  c;
  const char *const *const     end  = argv + argc;
  const char *const *const     rest = std::find(argv, end, std::string("--"));
  Switches                     switches;
  std::vector<std::string>     words;
  options::options_description visible = visible_options(c, switches), all;
  all.add(visible);
  bool       short_help = false;
  const auto add_hidden = [&all](const char *name, bool &flag) {
    all.add_options()(name, options::bool_switch(&flag));
  };
  add_hidden(",h", short_help);
  add_hidden("write-parameters", switches.write_parameters); // as the commands were called once
  add_hidden("write-documentation", switches.write_documentation);
  all.add_options()("word", options::value(&words));
  options::positional_options_description positional;
  options::variables_map                  values;
  positional.add("word", -1);

  namespace style = options::command_line_style;
  try
    {
      options::store(options::command_line_parser(static_cast<int>(rest - argv), argv)
                         .options(all)
                         .positional(positional)
                         .style(style::unix_style & ~style::allow_guessing)
                         .run(),
                     values);
      options::notify(values);
      check_values(values, c);
    }
  catch (const options::unknown_option &error)
    {
      const std::string name    = error.get_option_name();
      const std::string nearest = nearest_name(name, long_names(visible));
      throw InputError("There is no option " + name + ". " +
                       (nearest.empty() ? "chaindrive --help lists the options." :
                                          "Did you mean " + nearest + "?"));
    }
  catch (const options::multiple_occurrences &error)
    {
      throw InputError("The option " + error.get_option_name() + " may be given only once.");
    }
  catch (const options::invalid_command_line_syntax &error)
    {
      const bool missing =
          error.kind() == options::invalid_command_line_syntax::missing_parameter ||
          error.kind() == options::invalid_command_line_syntax::empty_adjacent_parameter;
      throw InputError("The option " + error.get_option_name() +
                       (missing ? " needs a value after it." : " takes no value."));
    }
  catch (const options::validation_error &error)
    {
      throw InputError("The option " + error.get_option_name() + " needs a number after it.");
    }
  catch (const options::error &)
    {
      throw InputError("The options are not understood. chaindrive --help lists them.");
    }

  switches.help = switches.help || short_help;
  c.command     = take_command(words, switches);
  // What follows -- names files although it begins with a dash; of a study it is for Snakemake.
  const bool takes_words = takes_folders(c.command) || words.empty();
  if (rest != end && !is_of_runs(c.command) && takes_words)
    words.insert(words.end(), rest + 1, end);
  else
    c.rest.assign(rest == end ? end : rest + 1, end);
  c.parameter_file = file_of(c.command, words);
  if (takes_folders(c.command))
    c.folders = words;
  check_belonging(c);
  refuse_useless(values, c);
  return c;
}

std::vector<std::string> OptionText::commands() const
{
  std::vector<std::string> found;
  std::istringstream       names(meaning.substr(0, std::min(meaning.find(':'), meaning.size())));
  for (std::string name; std::getline(names >> std::ws, name, ',');)
    if (find_command(name) == nullptr)
      return {};
    else
      found.push_back(name);
  return found;
}

std::vector<CommandText> command_texts()
{
  std::vector<CommandText> texts;
  for (const CommandName &command : commands)
    texts.push_back(
        {command.name, command.argument != nullptr ? command.argument : "", command.meaning});
  return texts;
}

std::vector<OptionText> option_texts()
{
  CommandLine                        defaults;
  Switches                           switches;
  const options::options_description visible = visible_options(defaults, switches);
  std::vector<OptionText>            texts;
  for (const auto &option : visible.options())
    texts.push_back({"--" + option->long_name(),
                     option->semantic()->max_tokens() > 0 ? option->format_parameter() : "",
                     option->description()});
  return texts;
}

std::string help_text()
{
  CommandLine        defaults;
  Switches           switches;
  std::ostringstream out;
  out << "usage: chaindrive [COMMAND] FILE.prm [OPTION]...\n\n"
         "Simulates the roller chain drive that FILE.prm describes.\n\nCommands:\n";
  for (const CommandName &command : commands)
    out << "  " << std::left << std::setw(17)
        << command.name + (command.argument != nullptr ? std::string(" ") + command.argument : "")
        << "  " << command.meaning << '\n';
  out << "\nOptions:\n"
      << visible_options(defaults, switches)
      << "\nExample: chaindrive prm/paper/simple.prm --set \"Contact/Friction coefficient=0.2\"\n";
  return out.str();
}

std::string version_text()
{
  std::ostringstream out;
  out << "chaindrive " << version << '\n'
      << "deal.II    " << DEAL_II_PACKAGE_VERSION << '\n'
      << "processor  " << processor_simd() << '\n'
      << "kernels    " << kernels_text() << '\n'
      << "MPI ranks  "
      << (dealii::Utilities::MPI::job_supports_mpi() ?
              dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) :
              1)
      << '\n';
  return out.str();
}
} // namespace chaindrive
