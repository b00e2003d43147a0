// SPDX-License-Identifier: LGPL-2.1-or-later
// What `plan --accuracy` answers from a table of studies: the cheapest variant whose error lies
// within the wanted one with its whole interval, or that there is none.
#include <chaindrive/accuracy.h>
#include <chaindrive/utilities/errors.h>

#include <cmath>
#include <iostream>

using namespace chaindrive;

// study, variant, reference, output, error, low, high (percent), CPU, that of the reference (s)
const char *const table =
    "# a comment\n"
    "ladder\tfast\tslow\ttension\t-3\t-6\t-1\t2\t900\tModel/Fidelity=simple\n"
    "ladder\tmiddle\tslow\ttension\t1\t-1\t2\t7\t900\tModel/Fidelity=layered\t"
    "Contact/Damping ratio=0.1\n"
    "ladder\tlucky\tslow\ttension\t0\t-9\t9\t1\t900\tModel/Fidelity=simple\n"
    "ladder\tslow\tslow\ttension\t0\t-0.5\t0.5\t900\t900\tModel/Fidelity=full\n"
    "ladder\tfast\tslow\tpeak\t40\t30\t50\t2\t900\tModel/Fidelity=simple\n"
    "mesh\tcoarse\tfine\ttension\t0.1\t0\t0.2\t60\t300\tMesh/Refinement=0\n"
    "mesh\tfine\tfine\ttension\t0\t-0.1\t0.1\t300\t300\tMesh/Refinement=2\n";

void ask(const std::string &text)
{
  const std::vector<StudyResult> results = read_results(table);
  std::cout << text << std::endl;
  try
    {
      const auto [output, wanted] = read_wanted(text, results);
      for (const Answer &answer : answers(results, output, wanted))
        std::cout << "  " << answer.study << ": "
                  << (answer.found ? answer.found->variant + ", " + answer.found->overrides.back() :
                                     "none, best is " + answer.best.variant)
                  << std::endl;
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
                           "torque=5",
                           "tension",
                           "tension=0",
                           "tension=many"})
    ask(text);
  unsigned int wrong = 0;
  for (const StudyResult &result : shipped_results())
    if (!std::isfinite(result.bound()) || !(result.cpu > 0.) || result.overrides.empty())
      ++wrong;
  std::cout << "rows of the program's own table that are wrong: " << wrong << std::endl;
}
