// SPDX-License-Identifier: LGPL-2.1-or-later
// Starts chaindrive many times without loading its libraries many times. For each line of its
// input,
//
//   FOLDER <tab> SECONDS <tab> BYTES <tab> ARGUMENT <tab> ARGUMENT ...
//
// it makes a copy of itself, which goes to FOLDER, sends what it says to the files stdout and
// stderr there, and does what chaindrive does with these arguments, in at most so many seconds and
// bytes of memory (0: any). The answer is a line: the exit status, or -N if signal N ended it,
// and the largest memory of the copy in kilobytes.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

int program_main(int argc, char **argv); // that of source/main.cc, by another name

namespace
{
std::vector<std::string> split(const std::string &line)
{
  std::vector<std::string> words;
  std::istringstream       in(line);
  for (std::string word; std::getline(in, word, '\t');)
    words.push_back(word);
  return words;
}

void limit(const __rlimit_resource resource, const rlim_t value)
{
  const rlimit both = {value, value};
  setrlimit(resource, &both);
}

[[noreturn]] void run(std::vector<std::string> words)
{
  if (chdir(words[0].c_str()) != 0 || std::freopen("/dev/null", "r", stdin) == nullptr ||
      std::freopen("stdout", "w", stdout) == nullptr ||
      std::freopen("stderr", "w", stderr) == nullptr)
    std::exit(100);
  limit(RLIMIT_CORE, 0);
  if (words[2] != "0")
    limit(RLIMIT_AS, std::stoull(words[2]));
  alarm(std::stoul(words[1]));

  std::vector<char *> arguments = {words[2].data()}; // in place of the program's name
  for (std::size_t i = 3; i < words.size(); ++i)
    arguments.push_back(words[i].data());
  arguments.push_back(nullptr);
  std::exit(program_main(static_cast<int>(arguments.size()) - 1, arguments.data()));
}
} // namespace

int main()
{
  for (std::string line; std::getline(std::cin, line);)
    {
      const auto  words = split(line);
      const pid_t child = words.size() < 3 ? -1 : fork();
      if (child == 0)
        run(words);
      int    status = 0;
      rusage usage{};
      if (child < 0 || wait4(child, &status, 0, &usage) != child)
        return 1;
      std::cout << (WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status)) << ' '
                << usage.ru_maxrss << std::endl;
    }
}
