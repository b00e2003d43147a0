// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/command_line.h>
#include <chaindrive/version.h>

#include <algorithm>
#include <sstream>

// The manual page and the completion of a shell, from the tables of commands and options.

namespace chaindrive
{
namespace
{
/// @p text as troff prints it: hyphens that can be copied, no requests and no escapes.
std::string troff(const std::string &text)
{
  std::string out;
  for (const char c : text)
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else if (c == '\'')
      out += "\\(aq";
    else
      out += c;
  return !out.empty() && out.front() == '.' ? "\\&" + out : out;
}

/// A paragraph with a heading: a word in bold, and what stands for its value in italics.
std::string item(const std::string &word, const std::string &value, const std::string &meaning)
{
  return ".TP\n\\fB" + troff(word) + "\\fR" +
         (value.empty() ? "" : " \\fI" + troff(value) + "\\fR") + "\n" + troff(meaning) + "\n";
}

/// What bash completes the value of @p option with, a command that fills COMPREPLY.
std::string values_of(const OptionText &option)
{
  if (option.value == "DIRECTORY")
    return "compopt -o filenames; COMPREPLY=($(compgen -d -- \"$word\"))";
  if (option.value.find("CHECKPOINT") != std::string::npos)
    return "compopt -o filenames; COMPREPLY=($(compgen -W auto -f -- \"$word\"))";
  if (option.value == "LIBRARY")
    return "compopt -o filenames; COMPREPLY=($(compgen -d -- \"$word\") $(compgen -f -X '!*.so' -- "
           "\"$word\"))";
  if (option.value == "FORM")
    return "COMPREPLY=($(compgen -W $'csv\\nwav\\nprm\\nxml\\njson' -- \"$word\"))";
  if (option.value == "SHELL")
    return "COMPREPLY=($(compgen -W bash -- \"$word\"))";
  return ":"; // numbers and names that only the user knows
}

/// Names of @p options that belong to the command @p name, or to all.
std::string options_of(const std::string &name, const std::vector<OptionText> &options)
{
  std::string names;
  for (const OptionText &option : options)
    if (const auto commands = option.commands();
        commands.empty() || std::find(commands.begin(), commands.end(), name) != commands.end())
      names += (names.empty() ? "" : " ") + option.name;
  return names;
}
} // namespace

std::string man_page()
{
  std::ostringstream out;
  out << ".TH CHAINDRIVE 1 \"\" \"chaindrive " << version << "\" \"User Commands\"\n"
      << ".SH NAME\nchaindrive \\- dynamics of roller chain drives\n"
      << ".SH SYNOPSIS\n.B chaindrive\n[\\fICOMMAND\\fR] [\\fIFILE.prm\\fR] "
         "[\\fIOPTION\\fR]...\n"
      << ".SH DESCRIPTION\n"
      << "Simulates the roller chain drive that a parameter file describes: the motion of every "
         "roller and\nlink, span tensions, tooth loads, impacts, speed ripple and losses. A "
         "command that needs a\nparameter file is shown with it.\n"
      << ".SH COMMANDS\n";
  for (const CommandText &command : command_texts())
    out << item(command.name, command.argument, command.meaning);
  out << ".SH OPTIONS\nOptions for certain commands begin with the names of these commands.\n";
  for (const OptionText &option : option_texts())
    out << item(option.name, option.value, option.meaning);
  out << ".SH EXIT STATUS\n"
      << item("0", "", "done")
      << item("2", "", "input that cannot be run; a message on standard error says why")
      << item("3", "", "a run that failed")
      << item("4", "", "a run that was stopped and can be resumed") << ".SH ENVIRONMENT\n"
      << item("CHAINDRIVE_CACHE",
              "",
              "cache of the solutions of parts, by default ~/.cache/chaindrive")
      << item("CHAINDRIVE_SIMD_WIDTH", "", "SIMD width of the kernels: 1, 2, 4 or 8")
      << ".SH SEVERAL PROCESSES\n"
      << troff("Elastic models run on several processes under mpirun. OpenMPI does not run as "
               "root, as in containers, without --allow-run-as-root, and does not start more "
               "processes than cores without --oversubscribe.")
      << "\n.SH EXAMPLES\n.nf\n"
      << troff("chaindrive template --chain 10B --teeth 21/63 --centre 500 --rpm 1450 --kW 3 > "
               "my.prm")
      << "\n"
      << troff("chaindrive plan my.prm") << "\n"
      << troff("chaindrive my.prm --set \"Contact/Friction coefficient=0.2\"") << "\n"
      << troff("mpirun -n 2 chaindrive my.prm --set Model/Fidelity=full") << "\n.fi\n"
      << ".SH SEE ALSO\n.BR mpirun (1),\n.BR paraview (1);\n"
      << troff("chaindrive document prints the reference of all entries.") << "\n";
  return out.str();
}

std::string bash_completion()
{
  const std::vector<CommandText> commands = command_texts();
  const std::vector<OptionText>  options  = option_texts();
  std::ostringstream             out;
  out << "# bash completion of chaindrive " << version
      << ", printed by: chaindrive document --completion bash\n"
      << "_chaindrive()\n{\n"
      << "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command=run i\n"
      << "  local IFS=$'\\n'\n  COMPREPLY=()\n"
      << "  for ((i = 1; i < COMP_CWORD; ++i)); do\n"
      << "    case ${COMP_WORDS[i]} in\n      ";
  for (const CommandText &command : commands)
    out << (&command == &commands.front() ? "" : " | ") << command.name;
  out << ") command=${COMP_WORDS[i]}; break ;;\n    esac\n  done\n"
      << "  case $before in\n";
  for (const OptionText &option : options)
    if (!option.value.empty())
      out << "    " << option.name << ") " << values_of(option) << "; return ;;\n";
  out << "  esac\n  local words=\n  case $word in\n    -*)\n      case $command in\n";
  for (const CommandText &command : commands)
    out << "        " << command.name << ") words='" << options_of(command.name, options)
        << "' ;;\n";
  out << "      esac\n      IFS=$' \\n'\n"
      << "      COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n      return ;;\n  esac\n"
      << "  if ((COMP_CWORD == 1)); then\n    IFS=$' \\n'\n    COMPREPLY=($(compgen -W '";
  for (const CommandText &command : commands)
    out << (&command == &commands.front() ? "" : " ") << command.name;
  out << "' -- \"$word\"))\n    IFS=$'\\n'\n  fi\n"
      << "  compopt -o filenames\n"
      << "  case $command in\n";
  for (const CommandText &command : commands)
    if (command.argument.empty())
      out << "    " << command.name << ") return ;;\n";
    else if (command.argument.rfind("DIR", 0) == 0)
      out << "    " << command.name << ") COMPREPLY+=($(compgen -d -- \"$word\")); return ;;\n";
  out << "  esac\n"
      << "  COMPREPLY+=($(compgen -d -- \"$word\") $(compgen -f -X '!*.prm' -- \"$word\") "
         "$(compgen -f -X '!*.xml' -- \"$word\") $(compgen -f -X '!*.json' -- \"$word\"))\n"
      << "}\ncomplete -F _chaindrive chaindrive\n";
  return out.str();
}
} // namespace chaindrive
