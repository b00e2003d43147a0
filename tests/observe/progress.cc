// SPDX-License-Identifier: LGPL-2.1-or-later
// What is said where: a log, a terminal, with --quiet; and how durations read.
#include <chaindrive/files/file.h>
#include <chaindrive/observe/progress.h>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <regex>
#include <sstream>
#include <thread>

using namespace chaindrive;

/// Makes control characters visible and seconds alike.
std::string visible(const std::string &text)
{
  const std::string plain = std::regex_replace(
      std::regex_replace(text, std::regex("\r"), "<return>"), std::regex("\x1b\\[K"), "<clear>");
  return std::regex_replace(plain, std::regex("[0-9]+ s"), "# s");
}

void run(std::ostream *console, const bool terminal, const std::string &file)
{
  files::Log log(console);
  log << "before the file" << std::endl;
  log.open(file);
  {
    observe::Progress progress(log, 0.01, 0.03, terminal);
    for (unsigned int i = 0; i <= 4000; ++i)
      {
        if (terminal && i == 1010)
          std::this_thread::sleep_for(std::chrono::milliseconds(210));
        progress.update(0.01 + 0.02 * i / 4000);
      }
  }
  log << "afterwards" << std::endl;
  log.close();
}

int main()
{
  std::ostringstream console;
  run(&console, false, "plain.txt");
  std::cout << visible(console.str()) << "the file says the same: "
            << (files::read_text("plain.txt") == console.str() ? "yes" : "no") << std::endl;

  console.str("");
  run(&console, true, "terminal.txt");
  // on a slow machine the line is rewritten more than once
  const std::regex expected(
      "before the file\n"
      "(<return> *[0-9]+ %  t = .* of 30.000 ms  elapsed # s, left # s<clear>)+"
      "<return><clear>afterwards\n");
  std::cout << "a terminal shows one line that is rewritten and vanishes: "
            << (std::regex_match(visible(console.str()), expected) ? "yes" : "no") << std::endl;
  std::cout << "the file says the same as without a terminal: "
            << (visible(files::read_text("terminal.txt")) ==
                        visible(files::read_text("plain.txt")) ?
                    "yes" :
                    "no")
            << std::endl;

  run(nullptr, true, "quiet.txt");
  std::cout << "and when quiet: "
            << (visible(files::read_text("quiet.txt")) == visible(files::read_text("plain.txt")) ?
                    "yes" :
                    "no")
            << std::endl;

  std::ostringstream errors;
  {
    files::Log log(nullptr, &errors);
    log << "what is quiet" << std::endl;
    log.warn("a warning");
  }
  std::cout << "when quiet, this is said: " << errors.str();

  setenv("OMPI_COMM_WORLD_SIZE", "2", 1);
  std::cout << "under mpirun, standard output is a terminal: "
            << (observe::Progress::console_is_terminal() ? "yes" : "no") << std::endl;

  for (const double seconds : {0.4, 59.4, 59.6, 200., 3599.6, 7500., 1e6})
    std::cout << observe::duration_text(seconds) << std::endl;
}
