// SPDX-License-Identifier: LGPL-2.1-or-later
// Terms of speeds and torques from entries: which sections there are, what they become, and what is
// refused with the entry, the value and what is allowed.
#include <chaindrive/functions/terms.h>
#include <chaindrive/utilities/errors.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

using namespace chaindrive;
using functions::Of;
using functions::Term;
using functions::Variable;

namespace
{
constexpr double pi = 3.14159265358979323846;

using Values = std::vector<std::pair<std::string, std::string>>;

/// The terms of a shaft whose entries have these values: "Section/Entry".
std::vector<Term> terms_of(const Of of, const Values &values)
{
  parameters::Sections     sections(functions::set_of(of));
  parameters::Declarations declarations;
  {
    const parameters::Subsection section(declarations, "shaft");
    sections.declare(declarations);
  }
  for (const auto &[path, value] : values)
    {
      const std::size_t slash = path.find('/');
      declarations.set(
          *declarations.find("shaft/" + path.substr(0, slash), path.substr(slash + 1)), value, "");
    }
  return functions::make_terms(of, sections, {"Loads/shaft", {"."}, 0.5, 0.6, 100.});
}

void refuse(const Of of, const Values &values)
{
  try
    {
      terms_of(of, values);
      std::cout << "ACCEPTED\n";
    }
  catch (const InputError &error)
    {
      std::cout << error.what() << '\n';
    }
}

void verdict(const std::string &what, const bool holds)
{
  std::cout << what << ": " << (holds ? "yes" : "NO") << '\n';
}
} // namespace

int main()
{
  for (const Of of : {Of::speed, Of::torque})
    {
      parameters::Sections     sections(functions::set_of(of));
      parameters::Declarations declarations;
      sections.declare(declarations);
      std::cout << functions::set_of(of) << '\n';
      for (const parameters::Entry &entry : declarations.entries())
        std::cout << "  " << entry.path() << " = " << entry.default_value << '\n';
      verdict("  nothing of it by default", terms_of(of, {}).empty());
    }

  const auto waves = terms_of(Of::torque,
                              {{"Harmonics/Orders", "2, 0.5"},
                               {"Harmonics/Amplitudes in N m", "7, 3"},
                               {"Harmonics/Phases in degrees", "90, -30"}});
  verdict("waves over the angle",
          waves.size() == 1 && waves[0].variable == Variable::angle &&
              std::abs(waves[0].function->value(0.3) - 7. * std::cos(2. * 0.3 + pi / 2.) -
                       3. * std::cos(0.5 * 0.3 - pi / 6.)) < 1e-14);
  const auto ripple =
      terms_of(Of::speed, {{"Harmonics/Orders", "2"}, {"Harmonics/Amplitudes in percent", "5"}});
  verdict("waves of a speed are parts of it",
          ripple.size() == 1 && std::abs(ripple[0].function->value(0.) - 0.05) < 1e-16);
  const auto fan = terms_of(
      Of::torque, {{"Of speed/Linear in N m s", "0.1"}, {"Of speed/Quadratic in N m s2", "0.02"}});
  verdict("a torque over the speed",
          fan.size() == 1 && fan[0].variable == Variable::speed &&
              std::abs(fan[0].function->value(-10.) + 1. + 2.) < 1e-14);

  const auto stop = terms_of(Of::speed,
                             {{"Changes/Times in ms", "200, 800"},
                              {"Changes/Durations in ms", "100, 300"},
                              {"Changes/Speeds in rad/s", "0, -50"},
                              {"Changes/Course", "linear"}});
  verdict("a stop and a reversal, added to the speed before",
          stop.size() == 1 && stop[0].function->value(0.7) == 0. &&
              std::abs(stop[0].function->value(0.75) + 50.) < 1e-9 &&
              std::abs(stop[0].function->value(1.) + 100.) < 1e-9 &&
              std::abs(stop[0].function->value(2.) + 150.) < 1e-9);

  std::ofstream("load.csv") << "angle,torque\n0,10\n90,20\n360,10\n";
  std::ofstream("speed.csv") << "0 1000\n50 2000\n100 1500\n";
  const auto table = terms_of(Of::torque,
                              {{"Table/File", "load.csv"},
                               {"Table/Variable", "angle in degrees"},
                               {"Table/Repeats", "true"}});
  verdict("a table over the angle, over and over",
          table.size() == 1 && table[0].variable == Variable::angle &&
              std::abs(table[0].function->value(pi / 2.) - 20.) < 1e-12 &&
              std::abs(table[0].function->value(pi / 2. - 6. * pi) - 20.) < 1e-12 &&
              std::abs(table[0].function->value(20. * pi) - 10.) < 1e-12);
  const auto speed = terms_of(Of::speed, {{"Table/File", "speed.csv"}, {"Table/Value", "rpm"}});
  verdict("a table of the speed from the start on, in its place",
          speed.size() == 1 && speed[0].replaces &&
              std::abs(speed[0].function->value(0.55) - 2000. * pi / 30.) < 1e-11 &&
              std::filesystem::equivalent(speed[0].file, "speed.csv"));

  std::cout << "refused\n";
  refuse(Of::torque, {{"Harmonics/Orders", "2, 4"}, {"Harmonics/Amplitudes in N m", "7"}});
  refuse(Of::torque,
         {{"Harmonics/Orders", "2"},
          {"Harmonics/Amplitudes in N m", "7"},
          {"Harmonics/Phases in degrees", "0, 1"}});
  refuse(Of::speed, {{"Harmonics/Orders", "2, 4"}, {"Harmonics/Amplitudes in percent", "60, 50"}});
  refuse(Of::torque, {{"Harmonics/Orders", "0"}});
  refuse(Of::torque, {{"Harmonics/Orders", "2,,4"}});
  refuse(Of::torque, {{"Harmonics/Orders", "2; 4"}});
  refuse(Of::speed, {{"Changes/Times in ms", "200"}, {"Changes/Durations in ms", "100"}});
  refuse(Of::speed,
         {{"Changes/Times in ms", "50"},
          {"Changes/Durations in ms", "100"},
          {"Changes/Speeds in rad/s", "0"}});
  refuse(Of::speed,
         {{"Changes/Times in ms", "200, 250"},
          {"Changes/Durations in ms", "100, 10"},
          {"Changes/Speeds in rad/s", "0, 5"}});
  std::ofstream("one.csv") << "0,10\n";
  std::ofstream("falls.csv") << "0,10\n2,10\n1,10\n";
  std::ofstream("words.csv") << "0,10\n2,ten\n";
  std::filesystem::create_directory("folder.csv");
  std::ofstream("huge.csv") << "0,10\n1,10\n";
  std::filesystem::resize_file("huge.csv", 3000000000);
  for (const char *file :
       {"nowhere.csv", "one.csv", "falls.csv", "words.csv", "folder.csv", "huge.csv"})
    refuse(Of::torque, {{"Table/File", file}});
  refuse(Of::torque, {{"Table/File", "/dev/zero"}});
  std::ofstream("large.csv") << "0,10\n1,2e7\n";
  std::ofstream("close.csv") << "0,10\n1,20\n1.0000001,10\n";
  std::ofstream("far.csv") << "-1e305,10\n1,20\n";
  for (const char *file : {"large.csv", "close.csv", "far.csv"})
    refuse(Of::torque, {{"Table/File", file}});
  refuse(Of::speed, {{"Table/File", "large.csv"}});
  refuse(Of::speed, {{"Table/File", "speed.csv"}, {"Table/Repeats", "true"}});
  refuse(Of::speed, {{"Table/File", "speed.csv"}, {"Table/Variable", "angle in rad"}});
}
