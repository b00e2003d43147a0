// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/commands.h>
#include <chaindrive/files/data_folder.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/ranks.h>

#include <string>
#include <unistd.h>
#include <vector>

// The page on runs is made by python/chaindrive/report, files for other programs by
// python/chaindrive/export.py; python/start.py starts both.

namespace chaindrive
{
namespace
{
/// Debian's Python, which has Debian's packages, where there is one.
std::string python()
{
  const char *debian = "/usr/bin/python3";
  return ::access(debian, X_OK) == 0 ? debian : "python3";
}

/// -B: the folder of the package may belong to others.
std::vector<std::string> first_words(const std::string &command)
{
  return {python(), "-B", files::data_folder("python") + "/start.py", command};
}

/// The words after @p words that options and folders of the command line give.
std::vector<std::string> with_options(std::vector<std::string> words,
                                      const CommandLine       &command_line)
{
  if (command_line.quiet)
    words.emplace_back("--quiet");
  if (!command_line.output_directory.empty())
    words.push_back("--output=" + command_line.output_directory); // it may begin with a dash
  words.emplace_back("--");
  words.insert(words.end(), command_line.folders.begin(), command_line.folders.end());
  return words;
}
} // namespace

std::vector<std::string> report_command(const CommandLine &command_line, const MPI_Comm comm)
{
  if (n_ranks_in(comm) > 1)
    throw InputError("A report is written by one process: start it without mpirun.");
  return with_options(first_words("report"), command_line);
}

std::vector<std::string> export_command(const CommandLine &command_line, const MPI_Comm comm)
{
  if (n_ranks_in(comm) > 1)
    throw InputError("Files are exported by one process: start it without mpirun.");
  std::vector<std::string> words = first_words("export");
  words.insert(words.end(), {"--as", command_line.kind});
  return with_options(words, command_line);
}

std::vector<std::string> report_after_run(const std::string &directory)
{
  std::vector<std::string> words = first_words("report");
  words.insert(words.end(), {"--after-run", "--", directory});
  return words;
}
} // namespace chaindrive
