// SPDX-License-Identifier: LGPL-2.1-or-later
// summary.json: order of the members, all digits of a number, no invalid JSON.
#include <chaindrive/files/file.h>
#include <chaindrive/files/json.h>
#include <chaindrive/observe/summary.h>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <limits>

using namespace chaindrive;

int main()
{
  const double third = 1. / 3.;
  files::Json  summary;
  summary["driven_speed_mean"] = third;
  summary["a_mean_of_nothing"] = std::nan("");
  summary["ratio"]             = std::numeric_limits<double>::infinity();
  summary["steps"]             = 120000;
  summary["name"]              = "not UTF-8: \xff";
  summary["engagements"]       = files::Json::array({{{"roller", 3}, {"time", 1e-3}}});
  files::write_json("summary.json", summary);
  files::write_json("summary.json", summary); // replaces the first

  const std::string text = files::read_text("summary.json");
  std::cout << text;
  std::cout << "number unchanged: "
            << (files::Json::parse(text)["driven_speed_mean"] == third ? "yes" : "no") << std::endl
            << "temporary file left behind: " << std::filesystem::exists("summary.json.part")
            << std::endl;

  PhaseTimer timer;
  timer.add("Internal force");
  timer.add("Contact algorithm");
  double     sum    = 0.;
  const auto phases = observe::cpu_seconds(timer.rows());
  for (const auto &[name, seconds] : phases.items())
    {
      std::cout << name << (seconds >= 0. ? "" : " negative") << std::endl;
      if (name != "total")
        sum += seconds.get<double>();
    }
  std::cout << "phases / total: " << sum / phases["total"].get<double>() << std::endl;
}
