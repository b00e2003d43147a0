// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/parameters/parameter_file.h>
#include <chaindrive/utilities/errors.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace chaindrive::parameters
{
namespace
{
/// Much more than all entries with their documentation; a results file given by mistake is larger.
constexpr std::size_t largest_size = 1 << 20;

bool is_control(const char c)
{
  const auto byte = static_cast<unsigned char>(c);
  return (byte < 0x20 && c != '\n' && c != '\t' && c != '\r') || byte == 0x7f;
}
} // namespace

std::string read_text(const std::string &file)
{
  std::error_code error;
  const auto      status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status))
    {
      const bool meant = std::filesystem::is_regular_file(file + ".prm", error),
                 word  = file.find_first_of("./") == std::string::npos;
      throw InputError("There is no parameter file '" + file + "'. " +
                       (meant ? "Did you mean '" + file + ".prm'?" :
                                std::string("Name an existing .prm file, or write one with: "
                                            "chaindrive template") +
                                    (word ? ". For all commands: chaindrive --help" : "")));
    }
  if (std::filesystem::is_directory(status))
    throw InputError("'" + file + "' is a directory, not a parameter file.");
  std::ifstream in(file, std::ios::binary);
  std::string   text(largest_size + 1, '\0');
  if (in)
    in.read(text.data(), text.size());
  if (in.bad() || !in.is_open())
    throw InputError("The parameter file '" + file +
                     "' cannot be read: its permissions forbid it.");
  text.resize(in.gcount());
  if (text.size() > largest_size)
    throw InputError("'" + file + "' is larger than 1 MB and so is not a parameter file.");
  if (std::any_of(text.begin(), text.end(), is_control))
    throw InputError("'" + file +
                     "' is not a parameter file: it contains bytes that are not text.");
  return text;
}

std::vector<Line> statements(const std::string &text)
{
  std::vector<Line>  lines;
  std::istringstream in(text.substr(text.compare(0, 3, "\xef\xbb\xbf") == 0 ? 3 : 0));
  std::string        physical;
  bool               continued = false;
  for (unsigned int number = 1; std::getline(in, physical); ++number)
    {
      physical = physical.substr(0, physical.find('#'));
      std::replace(physical.begin(), physical.end(), '\t', ' ');
      std::replace(physical.begin(), physical.end(), '\r', ' ');
      physical = dealii::Utilities::trim(physical);
      // comments and empty lines may stand between the parts of a continued statement
      if (physical.empty())
        continue;
      const bool continues = physical.back() == '\\';
      if (continues)
        physical = dealii::Utilities::trim(physical.substr(0, physical.size() - 1));
      if (continued)
        lines.back().text += " " + physical;
      else
        lines.push_back({number, physical});
      continued = continues;
    }
  return lines;
}
} // namespace chaindrive::parameters
