// SPDX-License-Identifier: LGPL-2.1-or-later
// The output directory: made with its parents, old results replaced, all else left alone, refused
// with a reason.
#include <chaindrive/files/directory.h>
#include <chaindrive/files/file.h>
#include <chaindrive/utilities/errors.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <unistd.h>

using namespace chaindrive;
namespace fs = std::filesystem;

void attempt(const std::string &path)
{
  try
    {
      files::Directory directory(path);
      directory.claim();
      directory.take_over();
      std::cout << path << ": ready" << std::endl;
    }
  catch (const InputError &error)
    {
      std::cout << error.what() << std::endl;
    }
}

/// What lies there.
void print_contents(const std::string &path)
{
  std::vector<std::string> names;
  for (const auto &entry : fs::recursive_directory_iterator(path))
    names.push_back(fs::relative(entry.path(), path).string());
  std::sort(names.begin(), names.end());
  for (const std::string &name : names)
    std::cout << "  " << name << std::endl;
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
                           "contacts.pvd",
                           "summary.json",
                           "summary.json.part",
                           "fields/bodies_000000.vtu",
                           "fields/bars_000012.vtu.part",
                           "fields/contacts_000012.1.vtu",
                           "checkpoint-000000012.ckpt", // all these are replaced
                           "histories_mine.csv",
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
      files::write_text(file.string(), "text");
    }
  fs::create_directory("results/deep/run/histories_all.csv"); // a directory is not ours
  attempt("results/deep/run/");

  print_contents("results/deep/run");

  {
    files::Directory first("results/deep/run");
    first.claim();
    files::write_text("results/deep/run/summary.json", "");
    files::write_text("results/deep/run/histories_hubs.csv", "");
    files::write_text("results/deep/run/checkpoint-000000012.ckpt", "");
    files::write_text("results/deep/run/bodies.pvd.part", "");
    try
      {
        files::Directory("results/deep/../deep/run").claim();
      }
    catch (const InputError &error)
      {
        const std::string said = error.what();
        std::cout << "a second run is refused: " << said.substr(0, said.find(": process")) << "; "
                  << (said.find(std::to_string(::getpid())) != std::string::npos ? "names it" :
                                                                                   said)
                  << std::endl;
      }
    first.take_over(true, false);
    std::cout << "a run that goes on, without CSV:" << std::endl;
    print_contents("results/deep/run");
  }
  attempt("results/deep/run"); // the lock is gone with its owner
  files::write_text("results/deep/run/chaindrive.lock", "of a run that was killed");
  attempt("results/deep/run");
  fs::create_directory("results/deep/run/summary.json");
  attempt("results/deep/run");
  fs::remove("results/deep/run/summary.json");
  fs::remove_all("results/deep/run/fields");
  files::write_text("results/deep/run/fields", "");
  attempt("results/deep/run");

  files::write_text("a_file", "");
  attempt("a_file");
  attempt("a_file/below/it");
  attempt("results/../a_file/below");
  attempt("/proc/chaindrive"); // nobody may write there
  attempt("");
}
