// SPDX-License-Identifier: LGPL-2.1-or-later
// What `plan --accuracy` answers from a table of studies: the cheapest variant whose error lies
// within the wanted one with its whole interval, or that there is none; only studies that compare
// fidelities answer, and only for the drive that they ran.
#include <chaindrive/accuracy.h>
#include <chaindrive/utilities/errors.h>

#include <cmath>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace chaindrive;

// study, variant, reference, output, error, low, high (percent), CPU, that of the reference (s)
const char *const table =
    "# a comment\n"
    "drive\tladder\tlinks=110\tspeed in rpm=1153\n"
    "ladder\tfast\tslow\ttension\t-3\t-6\t-1\t2\t900\tModel/Fidelity=simple\n"
    "ladder\tmiddle\tslow\ttension\t1\t-1\t2\t7\t900\tModel/Fidelity=layered\t"
    "Contact/Damping ratio=0.1\n"
    "ladder\tlucky\tslow\ttension\t0\t-9\t9\t1\t900\tModel/Fidelity=simple\n"
    "ladder\tslow\tslow\ttension\t0\t-0.5\t0.5\t900\t900\tModel/Fidelity=full\n"
    "ladder\tfast\tslow\tpeak\t40\t30\t50\t2\t900\tModel/Fidelity=simple\n"
    // a run of half the length: of the CPU time it takes more than fast, less than middle
    "other\tshapes\tslow\ttension\t1\t-2\t2\t3\t450\tModel/Fidelity=reduced\n"
    "other\tslow\tslow\ttension\t0\t-0.5\t0.5\t450\t450\tModel/Fidelity=full\n"
    // says what the mesh changes in one model, and nothing of the model
    "mesh\tcoarse\tfine\ttension\t0.1\t0\t0.2\t60\t300\tModel/Fidelity=full\t"
    "Mesh/Refinement=0\n"
    "mesh\tfine\tfine\ttension\t0\t-0.1\t0.1\t300\t300\tModel/Fidelity=full\t"
    "Mesh/Refinement=2\n"
    "mesh\tcoarse\tfine\tstress\t0.1\t0\t0.2\t60\t300\tModel/Fidelity=full\n";

void ask(const std::string &text)
{
  const std::vector<StudyResult> results = read_studies(table).results;
  std::cout << text << std::endl;
  try
    {
      const auto [output, wanted] = read_wanted(text, results);
      const auto [found, best]    = answer(results, output, wanted);
      if (found.empty())
        std::cout << "  none, best is " << best->variant << std::endl;
      for (const StudyResult &result : found)
        std::cout << "  " << result.study << ' ' << result.variant << ", "
                  << result.overrides.back() << std::endl;
    }
  catch (const InputError &error)
    {
      std::cout << "  " << error.what() << std::endl;
    }
}

int main()
{
  for (const char *text : {"tension=10",
                           "tension=6",
                           "tension=5",
                           "tension=1",
                           "tension=0.15",
                           "tension=0.01",
                           "peak=50",
                           "peak=49",
                           "stress=5",
                           "torque=5",
                           "tension",
                           "tension=0",
                           "tension=many"})
    ask(text);
  std::cout << "the same drive, nearly the same, others:" << std::endl;
  const std::vector<std::string> studied = read_studies(table).drives.at("ladder");
  for (const char *speed : {"1153", "1154", "1200"})
    std::cout << "  " << difference(studied, {"links=110", std::string("speed in rpm=") + speed})
              << std::endl;
  std::cout << "  " << difference(studied, {"links=111", "speed in rpm=1153"}) << std::endl;

  const Studies shipped = shipped_studies();
  unsigned int  wrong   = 0;
  // what a variant is must tell it from the others of its study
  std::map<std::pair<std::string, std::vector<std::string>>, std::set<std::string>> variants;
  for (const StudyResult &result : shipped.results)
    {
      variants[{result.study, result.overrides}].insert(result.variant);
      if (!std::isfinite(result.bound()) || !(result.cpu > 0.) || result.overrides.empty() ||
          shipped.drives.count(result.study) == 0)
        ++wrong;
    }
  for (const auto &[entries, names] : variants)
    wrong += names.size() - 1;
  std::cout << "rows of the program's own table that are wrong: " << wrong << std::endl;
}
