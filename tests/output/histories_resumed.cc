// SPDX-License-Identifier: LGPL-2.1-or-later
// Histories that were killed after two checkpoints, and whose open files were then spoilt, are made
// anew up to either checkpoint and go on: every row is there once, in HDF5 and CSV. So are those of
// a run that had come to its end and is made longer.
#include <chaindrive/output/file.h>
#include <chaindrive/output/histories.h>
#include <chaindrive/utilities/errors.h>

#include <deal.II/base/hdf5.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <map>
#include <sys/wait.h>
#include <unistd.h>

using namespace chaindrive;

namespace fs = std::filesystem;

using Items = std::map<std::string, Archive::Bytes>;

Archive reader(const Items &items)
{
  return Archive([&items](const std::string &name) { return std::optional(items.at(name)); });
}

/// A checkpoint after so many rows.
Items items_at(const std::size_t rows)
{
  Items         items;
  const Archive archive([&items](const std::string &name, const char *bytes, const std::size_t n) {
    items[name].assign(bytes, bytes + n);
  });
  std::size_t   number = rows;
  archive("rows", number);
  return items;
}

struct Run
{
  Run() : histories("resumed", {}, 300, true)
  {
    value = histories.add({"group", "value", "1", "Number of the sample"});
  }

  void sample(const unsigned int from, const unsigned int to)
  {
    for (unsigned int i = from; i < to; ++i)
      {
        histories.begin_sample(i);
        histories.set(value, i);
        histories.end_sample();
      }
  }

  output::Histories         histories;
  output::Histories::Handle value;
};

[[noreturn]] void run_and_be_killed()
{
  Run           run;
  const Archive nowhere([](const std::string &, const char *, std::size_t) {});
  run.sample(0, 300);
  run.histories.exchange(nowhere);
  run.histories.exchange(nowhere); // twice at one instant
  run.sample(300, 700);
  run.histories.exchange(nowhere);
  run.sample(700, 1100);
  std::raise(SIGKILL);
  std::exit(1);
}

void check(const std::string &what)
{
  dealii::HDF5::File file("resumed.h5", dealii::HDF5::File::FileAccessMode::open);
  const auto         values = file.open_dataset("group/value").read<dealii::Vector<double>>();
  const auto         times  = file.open_dataset("time").read<dealii::Vector<double>>();
  unsigned int       right  = 0;
  for (unsigned int i = 0; i < values.size(); ++i)
    right += values[i] == i && times[i] == i;
  const std::string csv = output::read_text("resumed_group.csv");
  std::cout << what << ": rows " << values.size() << ", right " << right << ", lines of CSV "
            << std::count(csv.begin(), csv.end(), '\n') << ", last "
            << csv.substr(csv.rfind('\n', csv.size() - 2) + 1);
}

unsigned int n_saved_files()
{
  unsigned int n = 0;
  for (const auto &entry : fs::directory_iterator("."))
    n += entry.path().filename().string().rfind("resumed-", 0) == 0;
  return n;
}

/// Goes on after @p rows rows and has @p end in the end.
void resume(const unsigned int rows, const unsigned int end, const bool finished)
{
  Run run;
  run.histories.exchange(reader(items_at(rows)));
  run.sample(rows, end);
  run.histories.close();
  if (finished)
    run.histories.remove_saved();
}

int main()
{
  for (const auto &entry : fs::directory_iterator("."))
    if (entry.path().filename().string().rfind("resumed", 0) == 0)
      fs::remove(entry.path());
  const pid_t child = fork();
  if (child == 0)
    run_and_be_killed();
  waitpid(child, nullptr, 0);
  std::cout << "saved files: " << n_saved_files() << std::endl;
  output::write_text("resumed.h5", "spoilt");
  output::write_text("resumed_group.csv", "time [s],val");

  resume(700, 1000, false);
  check("from the newer checkpoint");
  resume(300, 800, false);
  check("from the older checkpoint");
  std::cout << "saved files: " << n_saved_files() << std::endl;
  resume(300, 900, true);
  check("once more, to the end");
  std::cout << "saved files: " << n_saved_files() << std::endl;
  resume(900, 1200, true);
  check("and longer");
  resume(850, 1300, true);
  check("from before the end, and longer");

  fs::remove("resumed.h5");
  try
    {
      resume(900, 1000, true);
    }
  catch (const InputError &error)
    {
      std::cout << error.what() << std::endl;
    }
}
