// SPDX-License-Identifier: LGPL-2.1-or-later
// Histories as text: one file per group, columns with labels and units, numbers that read back as
// they were.
#include <chaindrive/files/file.h>
#include <chaindrive/files/histories.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <limits>
#include <sstream>

using namespace chaindrive;

int main()
{
  files::Histories histories("csv", {}, 4, true);
  const auto       speed = histories.add({"driven", "speed", "rad/s", "Speed of the hub"});
  const auto       force = histories.add({"rollers", "force", "N", "On a roller", 2, {"4", "5"}});
  const auto       place = histories.add({"rollers", "position", "m", "Of a roller", 3});
  const double     third = 1. / 3., tiny = std::numeric_limits<double>::denorm_min();
  for (const double time : {0., 2e-5})
    {
      histories.begin_sample(time);
      histories.set(speed, third);
      histories.values(force)[1] = -1500.25;
      histories.values(place)[0] = tiny;
      histories.end_sample();
    }
  histories.close();

  std::string text = files::read_text("csv_driven.csv");
  std::cout << text << files::read_text("csv_rollers.csv");
  text.pop_back();
  std::cout << "number unchanged by the way through text: "
            << (std::strtod(&text[text.rfind(',') + 1], nullptr) == third ? "yes" : "no") << '\n'
            << "files: ";
  unsigned int n = 0;
  for ([[maybe_unused]] const auto &entry : std::filesystem::directory_iterator("."))
    n += entry.path().filename().string().rfind("csv", 0) == 0;
  std::cout << n << std::endl;
}
