// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/output/file.h>
#include <chaindrive/output/summary.h>

#include <algorithm>
#include <cctype>

namespace chaindrive::output
{
void write_json(const std::string &path, const Json &content)
{
  write_file(path, [&content](std::ostream &out) {
    // texts may come from file names, which need not be UTF-8
    out << content.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
  });
}

Json cpu_seconds(const PhaseTimer &timer)
{
  Json   result = Json::object();
  double total  = 0.;
  for (const PhaseTimer::Row &row : timer.rows())
    {
      std::string name = row.name;
      std::transform(name.begin(), name.end(), name.begin(), [](const unsigned char c) {
        return std::isalnum(c) ? static_cast<char>(std::tolower(c)) : '_';
      });
      result[name] = row.cpu_seconds;
      total += row.cpu_seconds;
    }
  result["total"] = total;
  return result;
}
} // namespace chaindrive::output
