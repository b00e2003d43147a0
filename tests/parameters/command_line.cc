// SPDX-License-Identifier: LGPL-2.1-or-later
// Options of the program, and what is said about those it does not have.
#include <chaindrive/command_line.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/simd.h>
#include <chaindrive/version.h>

#include <deal.II/base/config.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>

using namespace chaindrive;

const char *const names[] = {"run",
                             "plan",
                             "parts",
                             "noise",
                             "study",
                             "calibrate",
                             "report",
                             "export",
                             "select",
                             "sprocket",
                             "template",
                             "document",
                             "serve",
                             "version",
                             "help"};

void parse(std::vector<const char *> arguments)
{
  arguments.insert(arguments.begin(), "chaindrive");
  try
    {
      const CommandLine c = parse_command_line(arguments.size(), arguments.data());
      std::cout << "file '" << c.parameter_file << "' output '" << c.output_directory
                << "' command " << names[static_cast<int>(c.command)] << " quiet " << c.quiet
                << std::endl;
      if (c.command == Command::study)
        {
          std::cout << "  cores " << c.cores << " quick " << c.quick << " dry run " << c.dry_run
                    << " retry " << c.retry << " rest";
          for (const std::string &word : c.rest)
            std::cout << ' ' << word;
          std::cout << std::endl;
        }
      for (const std::string &folder : c.folders)
        std::cout << "  run '" << folder << "'" << std::endl;
      for (const std::string &text : c.overrides)
        std::cout << "  override '" << text << "'" << std::endl;
    }
  catch (const InputError &error)
    {
      std::cout << error.what() << std::endl;
    }
}

int main()
{
  parse({"a.prm"});
  parse({"--set",
         "Time/End time in ms=5",
         "a.prm",
         "--set=Drive/Driver teeth=17",
         "--output",
         "there"});
  parse({"a.prm", "--plan", "--quiet"});
  parse({"run", "a.prm"});
  parse({"plan", "a.prm", "--set", "Time/End time in ms=5"});
  parse({"parts", "a.prm"});
  parse({"study", "a.prm"});
  parse({"study", "a.prm", "--quick", "--cores", "3", "--", "--slurm", "--until", "x"});
  parse({"noise", "results/simple", "--set", "Acoustics/Radius in m=1"});
  parse({"noise"});
  parse({"noise", "a", "b"});
  parse({"noise", "a", "--output", "b"});
  parse({"report", "results/a", "results/b", "--output", "both.html"});
  parse({"report"});
  parse({"report", "results/a", "--set", "Time/End time in ms=5"});
  parse({"plan", "a.prm", "--report"});
  parse({"export", "results/a", "results/b", "--as", "wav", "--output", "sound"});
  parse({"export", "--as", "csv"});
  parse({"export", "results/a"});
  parse({"export", "results/a", "--as", "mp3"});
  parse({"export", "results/a", "--as", "csv", "--resume", "auto"});
  parse({"plan", "a.prm", "--as", "csv"});
  parse({"template"});
  parse({"document"});
  parse({"./run"}); // a file
  parse({"--write-parameters"});
  parse({"--write-documentation"});
  parse({"serve", "socket"});
  parse({"serve"});
  parse({"serve", "a", "b"});
  parse({"serve", "socket", "--quick"});
  parse({"--version"});
  parse({"-h"});

  parse({});
  parse({"--plan"});
  parse({"plan"});
  parse({"template", "a.prm"});
  parse({"pln", "a.prm"});
  parse({"a.prm", "b.prm"});
  parse({"a.prm", "--pland"});
  parse({"a.prm", "--outptu", "there"});
  parse({"a.prm", "--zzzzzzzzzz"});
  parse({"a.prm", "-x"});
  parse({"a.prm", "--plan=yes"});
  parse({"a.prm", "--output"});
  parse({"a.prm", "--output", "a", "--output", "b"});
  parse({"a.prm", "--set"});
  parse({"a.prm", "--se", "x=1"});
  parse({"a.prm", "--resume", ""});
  parse({"a.prm", "--output", ""});
  parse({"a.prm", "--output", "--plan"});
  parse({"a.prm", "--set", "--quiet"});
  parse({"a.prm", "--quick"});
  parse({"a.prm", "--", "--slurm"});
  parse({"report", "--output", "b.html", "a", "--", "-dash", "--long"});
  parse({"report", "--", "-dash"});
  parse({"noise", "--", "-dash"});
  parse({"--", "-a.prm"});
  parse({"study", "a.prm", "--cores", "many"});
  parse({"study", "a.prm", "--resume", "auto"});
  parse({"calibrate", "a.prm", "--cores", "3", "--retry-failed", "--", "--slurm"});
  parse({"calibrate", "a.prm", "--quick"});
  parse({"calibrate"});
  parse({"run", "a.prm", "--man"});
  parse({"template", "--completion", "bash"});
  parse({"document", "--completion", "zsh"});
  parse({"document", "--completion", "bash", "--man"});
  parse({"plan", "a.prm", "--schema"});
  parse({"plan", "a.prm", "--picture", "a.prm"});
  parse({"plan", "a.prm", "--picture", "a.svg"});
  parse({"document", "--schema", "--man"});

  std::cout << help_text();
  if (has_simd_width(4))
    setenv("CHAINDRIVE_SIMD_WIDTH", "4", 1);
  const std::string text = version_text();
  std::cout << "version_text names version " << (text.find(version) != std::string::npos)
            << ", deal.II " << (text.find(DEAL_II_PACKAGE_VERSION) != std::string::npos)
            << ", the width of its kernels "
            << (text.find("4 numbers at a time, 256 bits, as CHAINDRIVE_SIMD_WIDTH asks") !=
                    std::string::npos ||
                !has_simd_width(4))
            << ", lines " << std::count(text.begin(), text.end(), '\n') << std::endl;
}
