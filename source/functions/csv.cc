// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/files/file.h>
#include <chaindrive/functions/csv.h>
#include <chaindrive/utilities/errors.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

namespace chaindrive::functions
{
namespace
{
constexpr std::size_t most_points = 1000000;
constexpr std::size_t most_bytes  = 64000000;

bool is_separator(const char c) { return c == ' ' || c == '\t' || c == ',' || c == ';'; }

/// The numbers of a line; none at all when something else is among them.
std::optional<std::vector<double>> numbers(const char *at, const char *end)
{
  std::vector<double> found;
  while (true)
    {
      while (at != end && is_separator(*at))
        ++at;
      if (at == end)
        return found;
      if (*at == '+')
        ++at;
      double value             = 0.;
      const auto [stop, error] = std::from_chars(at, end, value);
      if (error != std::errc() || !std::isfinite(value) || (stop != end && !is_separator(*stop)))
        return {};
      found.push_back(value);
      at = stop;
    }
}

/// Whether a line begins with a number, as titles do not; with one that is too large or nan as
/// well.
bool begins_with_number(const char *at, const char *end)
{
  while (at != end && is_separator(*at))
    ++at;
  if (at != end && *at == '+')
    ++at;
  double     value = 0.;
  const auto stop  = std::from_chars(at, end, value).ptr;
  return stop != at && (stop == end || is_separator(*stop));
}
} // namespace

std::shared_ptr<const Table>
read_csv(const std::string &path, const double x_unit, const double y_unit, const double x_zero)
{
  std::error_code error;
  if (std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error))
    throw InputError("'" + path + "' is no table: it is a directory or a device.");
  if (const auto size = std::filesystem::file_size(path, error); !error && size > most_bytes)
    throw InputError("'" + path + "' is larger than 64 MB; a table has at most " +
                     std::to_string(most_points) + " points.");
  const std::string text = files::read_text(path);
  const auto        fail = [&path](const std::size_t line, const std::string &why) {
    throw InputError("'" + path + "', line " + std::to_string(line) + ": " + why + ".");
  };
  std::vector<double> x, y;
  std::size_t         line   = 0;
  bool                titles = true; // may still come
  for (std::size_t begin = text.compare(0, 3, "\xEF\xBB\xBF") == 0 ? 3 : 0; begin < text.size();)
    {
      std::size_t end = text.find_first_of("\r\n", begin);
      if (end == std::string::npos)
        end = text.size();
      ++line;
      const auto found = numbers(text.data() + begin, text.data() + end);
      const bool note  = text[begin] == '#';
      const bool words = !begins_with_number(text.data() + begin, text.data() + end);
      begin            = end + (text.compare(end, 2, "\r\n") == 0 ? 2 : 1);
      if (note || (found && found->empty()))
        continue;
      const bool of_titles = !found && titles && words;
      titles               = false;
      if (of_titles)
        continue;
      if (!found || found->size() != 2)
        fail(line, "two finite numbers are expected, the variable and the value");
      const double at = x_unit * (*found)[0] + x_zero;
      if (!x.empty() && !(at > x.back()))
        fail(line, "the variable must exceed that of the line before");
      if (x.size() == most_points)
        fail(line, "a table has at most " + std::to_string(most_points) + " points");
      x.push_back(at);
      y.push_back(y_unit * (*found)[1]);
    }
  if (x.empty())
    throw InputError("'" + path +
                     "' has no points: on each line two numbers are expected, the "
                     "variable and the value.");
  return std::make_shared<const Table>(std::move(x), std::move(y));
}
} // namespace chaindrive::functions
