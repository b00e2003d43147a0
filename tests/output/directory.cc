// SPDX-License-Identifier: LGPL-2.1-or-later
// The output directory: made with its parents, old results replaced, all else left alone, refused
// with a reason.
#include <chaindrive/output/directory.h>
#include <chaindrive/output/file.h>
#include <chaindrive/utilities/errors.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

using namespace chaindrive;
namespace fs = std::filesystem;

void attempt(const std::string &path)
{
  try
    {
      output::prepare_directory(path);
      std::cout << path << ": ready" << std::endl;
    }
  catch (const InputError &error)
    {
      std::cout << error.what() << std::endl;
    }
}

int main()
{
  fs::remove_all("results");
  fs::remove("a_file");

  attempt("results/deep/run");
  for (const char *name : {"histories.h5",
                           "histories_rollers.csv",
                           "bodies.pvd",
                           "bars.pvd",
                           "summary.json",
                           "summary.json.part",
                           "fields/bodies_000000.vtu",
                           "fields/bars_000012.vtu.part", // all these are replaced
                           "my histories.h5",
                           "histories.h5.old",
                           "fields/bodies_old.vtu",
                           "bodies_000000.vtu",
                           "drive.prm",
                           "parameters.prm",
                           "folder/log.txt"})
    {
      const fs::path file = fs::path("results/deep/run") / name;
      fs::create_directories(file.parent_path());
      output::write_text(file.string(), "text");
    }
  fs::create_directory("results/deep/run/histories_all.csv"); // a directory is not ours
  attempt("results/deep/run/");

  std::vector<std::string> left;
  for (const auto &entry : fs::recursive_directory_iterator("results/deep/run"))
    left.push_back(fs::relative(entry.path(), "results/deep/run").string());
  std::sort(left.begin(), left.end());
  for (const std::string &name : left)
    std::cout << "  " << name << std::endl;

  output::write_text("a_file", "");
  attempt("a_file");
  attempt("a_file/below/it");
  attempt("results/../a_file/below");
  attempt("/proc/chaindrive"); // nobody may write there
  attempt("");
}
