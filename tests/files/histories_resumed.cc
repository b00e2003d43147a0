// SPDX-License-Identifier: LGPL-2.1-or-later
// Histories that were killed after two checkpoints, and whose open files were then spoilt, are made
// anew up to either checkpoint and go on: every row is there once, in HDF5 and CSV. So are those of
// a run that had come to its end and is made longer. Rows that a checkpoint counts on are on the
// disk before it; what is cut off or damaged is noticed, and an older checkpoint is not touched.
#include <chaindrive/files/file.h>
#include <chaindrive/files/histories.h>
#include <chaindrive/utilities/errors.h>

#include <deal.II/base/hdf5.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <string>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

using namespace chaindrive;

namespace fs = std::filesystem;

namespace
{
std::vector<std::string> events; ///< of the disk

constexpr const char *saved = "resumed.saved", *whole = "resumed.h5";
} // namespace

// in place of the system's, which they call
// NOLINTBEGIN(readability-inconsistent-declaration-parameter-name)
extern "C" int fsync(const int descriptor)
{
  const fs::path path = fs::read_symlink("/proc/self/fd/" + std::to_string(descriptor));
  events.push_back("sync " + (fs::is_directory(path) ? "directory" : path.filename().string()));
  return static_cast<int>(::syscall(SYS_fsync, descriptor));
}

extern "C" int rename(const char *from, const char *to) noexcept
{
  events.push_back("rename " + fs::path(to).filename().string());
  return static_cast<int>(::syscall(SYS_rename, from, to));
}
// NOLINTEND(readability-inconsistent-declaration-parameter-name)

namespace
{
void verdict(const std::string &what, const bool yes)
{
  std::cout << what << ": " << (yes ? "yes" : "no") << std::endl;
}

/// A checkpoint: a folder with a file for each item.
Archive writer(const std::string &name)
{
  fs::create_directory(name);
  return Archive([name](const std::string &item, const char *bytes, const std::size_t n) {
    std::ofstream(name + "/" + item, std::ios::binary).write(bytes, std::streamsize(n));
  });
}

Archive reader(const std::string &name)
{
  return Archive([name](const std::string &item) -> std::optional<Archive::Bytes> {
    const std::string bytes = files::read_text(name + "/" + item);
    return Archive::Bytes(bytes.begin(), bytes.end());
  });
}

struct Run
{
  Run() : histories("resumed", {}, 300, true)
  {
    value = histories.add({"group", "value", "1", "Number of the sample"});
    pair  = histories.add({"group", "pair", "1", "Its negative and its half", 2});
  }

  void sample(const unsigned int from, const unsigned int to)
  {
    for (unsigned int i = from; i < to; ++i)
      {
        histories.begin_sample(i);
        histories.set(value, i);
        histories.values(pair)[0] = -double(i);
        histories.values(pair)[1] = 0.5 * i;
        histories.end_sample();
      }
  }

  files::Histories         histories;
  files::Histories::Handle value, pair;
};

[[noreturn]] void run_and_be_killed()
{
  Run run;
  run.sample(0, 300);
  run.histories.serialize(writer("resumed_at_300"));
  run.histories.serialize(writer("resumed_at_300")); // twice at one instant
  run.sample(300, 700);
  run.histories.serialize(writer("resumed_at_700"));
  run.sample(700, 1100);
  std::raise(SIGKILL);
  std::exit(1);
}

unsigned int n_rows()
{
  dealii::HDF5::File file(whole, dealii::HDF5::File::FileAccessMode::open);
  return static_cast<unsigned int>(file.open_dataset("time").read<dealii::Vector<double>>().size());
}

unsigned int n_right()
{
  dealii::HDF5::File file(whole, dealii::HDF5::File::FileAccessMode::open);
  const auto         values = file.open_dataset("group/value").read<dealii::Vector<double>>();
  const auto         pairs  = file.open_dataset("group/pair").read<dealii::FullMatrix<double>>();
  const auto         times  = file.open_dataset("time").read<dealii::Vector<double>>();
  unsigned int       right  = 0;
  for (unsigned int i = 0; i < values.size(); ++i)
    right += values[i] == i && times[i] == i && pairs[i][0] == -double(i) && pairs[i][1] == 0.5 * i;
  return right;
}

void check(const std::string &what)
{
  const std::string csv = files::read_text("resumed_group.csv");
  std::cout << what << ": rows " << n_rows() << ", right " << n_right() << ", lines of CSV "
            << std::count(csv.begin(), csv.end(), '\n') << ", last "
            << csv.substr(csv.rfind('\n', csv.size() - 2) + 1);
}

/// Goes on from @p checkpoint, after @p rows rows, and has @p end in the end.
void resume(const unsigned int rows, const unsigned int end, const bool finished)
{
  Run run;
  run.histories.serialize(reader("resumed_at_" + std::to_string(rows)));
  run.sample(rows, end);
  run.histories.serialize(writer("resumed_at_" + std::to_string(end)));
  run.histories.close();
  if (finished)
    run.histories.remove_saved();
}

/// Whether the checkpoint after @p rows rows is refused; if not, whether its rows come back wrong.
void attempt(const unsigned int rows, unsigned int &refused, unsigned int &wrong)
{
  try
    {
      Run run;
      run.histories.serialize(reader("resumed_at_" + std::to_string(rows)));
      run.histories.close();
      wrong += n_rows() != rows || n_right() != rows;
    }
  catch (const InputError &)
    {
      ++refused;
    }
}

/// One bit of @p file after the other, @p n of them all over it, is turned round.
void turn_bits(const std::string &file, const unsigned int rows, const unsigned int n)
{
  const std::string content = files::read_text(file);
  unsigned int      refused = 0, wrong = 0;
  for (unsigned int i = 0; i < n; ++i)
    {
      for (const char *name : {saved, whole})
        fs::remove(name);
      std::string spoilt = content;
      spoilt[(2 * i + 1) * content.size() / (2 * n)] ^= char(1 << i % 8);
      files::write_text(file, spoilt);
      attempt(rows, refused, wrong);
    }
  std::cout << n << " bits of " << file << ": wrong rows " << wrong
            << " times, refused often: " << (10 * refused > 5 * n ? "yes" : "no") << std::endl;
  for (const char *name : {saved, whole})
    fs::remove(name);
  files::write_text(file, content);
}
} // namespace

int main()
{
  for (const auto &entry : fs::directory_iterator("."))
    if (entry.path().filename().string().rfind("resumed", 0) == 0)
      fs::remove_all(entry.path());
  const pid_t child = fork();
  if (child == 0)
    run_and_be_killed();
  waitpid(child, nullptr, 0);
  std::cout << "numbers kept: " << fs::file_size(saved) / sizeof(double) << " of " << 4 * 700
            << std::endl;
  files::write_text(whole, "spoilt");
  files::write_text("resumed_group.csv", "time [s],val");

  const std::string rows_of_both = files::read_text(saved);
  turn_bits(saved, 700, 40);
  files::write_text(saved, rows_of_both.substr(0, rows_of_both.size() - 1));
  unsigned int refused = 0, wrong = 0;
  attempt(700, refused, wrong);
  verdict("one byte less: the newer checkpoint is refused", refused == 1);
  attempt(300, refused, wrong);
  verdict("and the older one not touched", refused == 1 && wrong == 0);
  files::write_text(saved, rows_of_both);
  fs::remove(whole);

  resume(700, 1000, false);
  check("from the newer checkpoint");
  resume(300, 800, false);
  check("from the older checkpoint");
  fs::remove(saved);
  resume(300, 900, true);
  check("from what the run had written, to the end");
  verdict("nothing is kept any more", !fs::exists(saved));
  turn_bits(whole, 900, 40);
  resume(900, 1200, true);
  check("and longer");
  resume(900, 1300, true);
  check("from before the end, and longer");

  events.clear();
  {
    Run run;
    run.sample(0, 10);
    run.histories.serialize(writer("resumed_at_10"));
    run.sample(10, 20);
    run.histories.serialize(writer("resumed_at_20"));
    fs::remove(saved);
    run.sample(20, 30);
    run.histories.serialize(writer("resumed_at_30")); // somebody has removed it
    run.histories.close();
    run.histories.remove_saved();
  }
  files::write_file(
      "resumed.text", [](std::ostream &out) { out << "text"; }, true);
  for (const std::string &event : events)
    std::cout << "  " << event << std::endl;

  fs::remove(whole);
  try
    {
      files::Histories::check("resumed", reader("resumed_at_30"));
    }
  catch (const InputError &error)
    {
      std::cout << error.what() << std::endl;
    }
}
