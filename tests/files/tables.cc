// SPDX-License-Identifier: LGPL-2.1-or-later
// Tables in an HDF5 file: what is written is read again, in whole or in part, each with rows of its
// own; a file that is missing, none, or without a table is refused by its name.
#include <chaindrive/files/file.h>
#include <chaindrive/files/tables.h>
#include <chaindrive/utilities/errors.h>

#include <filesystem>
#include <functional>
#include <iostream>
#include <string>

using namespace chaindrive;

namespace
{
void print(const files::Table &table)
{
  std::cout << table.info.path << ", " << table.n_rows() << " rows:";
  for (const double value : table.values)
    std::cout << ' ' << value;
  for (const std::string &label : table.info.labels)
    std::cout << " [" << label << ']';
  std::cout << '\n';
}

void refusal(const std::function<void()> &function)
{
  try
    {
      function();
      std::cout << "NOT refused\n";
    }
  catch (const InputError &error)
    {
      std::cout << error.what() << '\n';
    }
  catch (const RunError &error)
    {
      std::cout << "failed: " << error.what() << '\n';
    }
}
} // namespace

int main()
{
  files::write_tables("tables.h5",
                      {{"program", "a test"}},
                      {{{"/time", 1, {{"unit", "s"}}, {}}, {0.5, 1., 1.5}},
                       {{"/group/one", 1, {}, {"point 1"}}, {7., 8.}},
                       {{"/group/values", 2, {{"unit", "Pa"}}, {"left", "right µ"}},
                        {1., 2., 3., 4., 5., 6., 7., 8.}}});
  std::cout << "no part is left: " << (std::filesystem::exists("tables.h5.part") ? "NO" : "yes")
            << '\n';
  const files::TableFile file("tables.h5");
  print(file.read("/time"));
  print(file.read("/group/one"));
  print(file.read("/group/values"));
  print(file.read("/group/values", 1, 2));
  print(file.read("/group/values", 3, 5));
  print(file.read("/group/values", 9, 1));
  std::cout << "has " << file.has("/time") << file.has("/none") << file.has("/group") << '\n';

  refusal([&] { file.read("/none"); });
  refusal([&] { file.read("/group"); });
  refusal([] { files::TableFile("nowhere.h5"); });
  files::write_text("text.h5", "no table\n");
  refusal([] { files::TableFile("text.h5"); });
  refusal([] { files::write_tables("nowhere/tables.h5", {}, {}); });
}
