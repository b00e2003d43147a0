// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace test
{
/// A CSV file of histories: columns by their names without the unit ("driver_force 17").
class Table
{
public:
  explicit Table(const std::string &file)
  {
    std::ifstream in(file);
    std::string   line, cell;
    std::getline(in, line);
    std::vector<std::string> names;
    for (std::istringstream header(line); std::getline(header, cell, ',');)
      names.push_back(cell.substr(0, cell.find(" [")));
    while (std::getline(in, line))
      {
        std::size_t i = 0;
        for (std::istringstream row(line); std::getline(row, cell, ',');)
          columns_[names.at(i++)].push_back(std::stod(cell));
      }
  }

  const std::vector<double> &operator[](const std::string &name) const
  {
    const auto found = columns_.find(name);
    if (found == columns_.end())
      throw std::runtime_error("no column " + name);
    return found->second;
  }

  bool has(const std::string &name) const { return columns_.count(name) == 1; }

private:
  std::map<std::string, std::vector<double>> columns_;
};
} // namespace test
