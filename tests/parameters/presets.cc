// SPDX-License-Identifier: LGPL-2.1-or-later
// Every .prm file that the project ships can be read, has nothing to remark upon, and says in its
// first comment what it is for.
#include <chaindrive/model/reading.h>
#include <chaindrive/utilities/errors.h>

#include <filesystem>
#include <fstream>
#include <iostream>

using namespace chaindrive;

int main()
{
  const std::filesystem::path root = std::filesystem::path(SOURCE_DIR) / ".." / ".." / "prm";
  std::ifstream               readme(root / "README.md");
  const std::string           table((std::istreambuf_iterator<char>(readme)), {});

  unsigned int n_read = 0, n_refused = 0;
  for (const auto &file : std::filesystem::recursive_directory_iterator(root))
    if (file.path().extension() == ".prm")
      {
        const std::string name = file.path().lexically_relative(root).string();
        try
          {
            if (file.path().parent_path().filename() == "studies")
              for (const auto &variant :
                   parameters::read_study(file.path().string(), {}, false).variants)
                parameters::read_entries(variant.values);
            else
              model::read_parameters(file.path().string());
            ++n_read;
          }
        catch (const InputError &error)
          {
            std::cout << name << ": " << error.what() << std::endl;
            ++n_refused;
          }
        if (table.find("(" + name + ")") == std::string::npos)
          std::cout << name << " is not in prm/README.md" << std::endl;
        std::ifstream in(file.path());
        std::string   comment;
        for (std::string line; std::getline(in, line) && line.rfind('#', 0) == 0;)
          comment += line;
        if (comment.find('?') == std::string::npos)
          std::cout << name << " does not begin with the question it answers" << std::endl;
      }
  std::cout << "refused: " << n_refused << ", at least ten are read: " << (n_read >= 10)
            << std::endl;
}
