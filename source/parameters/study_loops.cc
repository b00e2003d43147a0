// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/parameters/study.h>
#include <chaindrive/utilities/errors.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cctype>
#include <sstream>

// What the notation of loops means is left to deal.II's class for it, which here knows nothing but
// the entries that are loops, each as a text by its number. It complains to the console where we
// throw, so what it would complain about is refused before.

namespace chaindrive::parameters
{
namespace
{
constexpr std::size_t most_variants = 10000;

/// Notes the values of each run.
class Collector : public dealii::MultipleParameterLoop::UserClass
{
public:
  explicit Collector(const std::vector<Loop> &loops) : loops_(loops) {}

  void create_new(const unsigned int) override {}

  void run(dealii::ParameterHandler &prm) override
  {
    Choices choices;
    for (std::size_t i = 0; i < loops_.size(); ++i)
      choices.emplace_back(loops_[i].path, prm.get(std::to_string(i)));
    combinations.push_back(choices);
  }

  std::vector<Choices> combinations;

private:
  const std::vector<Loop> &loops_;
};

std::size_t n_values(const Loop &loop)
{
  return 1 + std::count(loop.text.begin(), loop.text.end(), '|');
}

void check(const std::vector<Loop> &loops)
{
  std::size_t n      = 1;
  bool        varies = false;
  for (const Loop &loop : loops)
    {
      const auto count = [&](const char c) {
        return std::count(loop.text.begin(), loop.text.end(), c);
      };
      const std::size_t opens = count('{'), closes = count('}');
      const bool        together = goes_with_others(loop);
      if (opens != closes || opens != (together ? 2U : 1U) ||
          loop.text.rfind('{') > loop.text.find('}'))
        throw InputError(loop.path + " = " + loop.text +
                         " is no loop: write {a | b} for values that are taken in turn, or "
                         "{{a | b}} for values that go with those of other entries.");
      if (together)
        continue;
      varies = true;
      n *= n_values(loop);
      if (n > most_variants)
        throw InputError("The loops make more than " + std::to_string(most_variants) +
                         " variants; leave some values out.");
    }
  if (!varies)
    throw InputError("There is nothing to compare: no entry is a loop. Write the values of at "
                     "least one as {a | b}.");
  for (const Loop &loop : loops)
    if (goes_with_others(loop) && n_values(loop) != n)
      throw InputError(loop.path + " = " + loop.text + " has " + std::to_string(n_values(loop)) +
                       " values, but there are " + std::to_string(n) +
                       " variants: {{a | b}} needs a value for each.");
}

/// @p text with what is awkward in names of folders as single hyphens.
std::string plain(const std::string &text)
{
  std::string word;
  for (const unsigned char c : text)
    if (std::isalnum(c) || std::string("_.+").find(static_cast<char>(c)) != std::string::npos)
      word += static_cast<char>(std::tolower(c));
    else if (!word.empty() && word.back() != '-')
      word += '-';
  while (!word.empty() && word.back() == '-')
    word.pop_back();
  return word.empty() ? "none" : word;
}

std::string without_sections(const std::string &path)
{
  // a unit may contain a slash
  const std::string without_unit = path.substr(0, path.find(" in "));
  return without_unit.substr(without_unit.rfind('/') + 1);
}
} // namespace

std::vector<Choices> combinations(const std::vector<Loop> &loops)
{
  check(loops);
  dealii::MultipleParameterLoop prm;
  std::string                   text;
  for (std::size_t i = 0; i < loops.size(); ++i)
    {
      prm.declare_entry(std::to_string(i), "");
      text += "set " + std::to_string(i) + " = " + loops[i].text + "\n";
    }
  std::istringstream in(text);
  prm.parse_input(in, "loops");
  Collector collector(loops);
  prm.loop(collector);
  return collector.combinations;
}

std::vector<std::string> names_of(const std::vector<Loop>    &loops,
                                  const std::vector<Choices> &combinations)
{
  std::vector<std::string> names;
  for (const Choices &choices : combinations)
    {
      std::string name;
      for (std::size_t i = 0; i < loops.size(); ++i)
        if (!goes_with_others(loops[i]))
          {
            const bool alone =
                std::count_if(loops.begin(), loops.end(), [&](const Loop &other) {
                  return without_sections(other.path) == without_sections(loops[i].path);
                }) == 1;
            name += (name.empty() ? "" : ",") +
                    plain(alone ? without_sections(loops[i].path) : loops[i].path) + "=" +
                    plain(choices[i].second);
          }
      names.push_back(name);
    }
  return names;
}
} // namespace chaindrive::parameters
