// SPDX-License-Identifier: LGPL-2.1-or-later
// A disk that fills up, here a limit on the size of files: a clear message, earlier data intact, no
// crash and no hang, whatever is being written. An alarm ends a hang.
#include <chaindrive/files/file.h>
#include <chaindrive/files/histories.h>
#include <chaindrive/files/json.h>
#include <chaindrive/files/log.h>
#include <chaindrive/utilities/errors.h>

#include <deal.II/base/hdf5.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <sstream>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace chaindrive;
namespace fs = std::filesystem;

void limit_file_size(const rlim_t bytes)
{
  const rlimit limit{bytes, RLIM_INFINITY};
  setrlimit(RLIMIT_FSIZE, &limit);
}

/// Runs @p write with files of at most @p bytes and prints what it complains about.
void with_limit(const rlim_t bytes, const std::function<void()> &write)
{
  std::string message = "no complaint";
  limit_file_size(bytes);
  try
    {
      write();
    }
  catch (const RunError &error)
    {
      message = error.what();
    }
  limit_file_size(RLIM_INFINITY);
  std::cout << "  " << message << std::endl;
}

void add_samples(files::Histories &histories, const unsigned int n)
{
  for (unsigned int i = 0; i < n; ++i)
    {
      histories.begin_sample(histories.n_samples());
      histories.set(1, 1. / histories.n_samples());
      histories.end_sample();
    }
}

files::Histories new_histories(const std::string &prefix, const unsigned int rows, const bool csv)
{
  files::Histories histories(prefix, {}, rows, csv);
  histories.add({"group", "value", "1", "One by the number of the sample"});
  return histories;
}

void print_rows(const std::string &prefix)
{
  dealii::HDF5::File file(prefix + ".h5", dealii::HDF5::File::FileAccessMode::open);
  const auto         values = file.open_dataset("group/value").read<dealii::Vector<double>>();
  unsigned int       right  = 0;
  for (unsigned int i = 0; i < values.size(); ++i)
    right += values[i] == 1. / i;
  std::cout << "  rows right: " << right << std::endl;
}

int main()
{
  std::signal(SIGXFSZ, SIG_IGN);
  alarm(60);

  std::cout << "Histories that will not fit are refused at their first sample" << std::endl;
  for (const rlim_t bytes : {0, 100, 2000, 5000, 10000, 20480, 100000, 600000})
    with_limit(bytes, [] {
      auto histories = new_histories("too_large", 100000, false);
      add_samples(histories, 1);
    });
  std::cout << "  file left behind: " << std::filesystem::exists("too_large.h5") << std::endl;

  std::cout << "Histories that cannot grow" << std::endl;
  {
    auto histories = new_histories("growing", 512, false);
    add_samples(histories, 512);
    histories.flush();
    with_limit(std::filesystem::file_size("growing.h5"), [&] {
      add_samples(histories, 1000);
      histories.close();
    });
  }
  print_rows("growing");

  std::cout << "Histories whose space is taken away while they are written" << std::endl;
  {
    auto histories = new_histories("half_way", 20480, false);
    add_samples(histories, 10240);
    with_limit(std::filesystem::file_size("half_way.h5") / 2, [&] {
      add_samples(histories, 9000);
      histories.close();
    });
  }
  print_rows("half_way");

  std::cout << "The same at closing" << std::endl;
  {
    auto histories = new_histories("closing", 20480, false);
    add_samples(histories, 10240);
    histories.flush();
    with_limit(100, [&] { histories.close(); });
  }
  print_rows("closing");

  std::cout << "CSV keeps whole blocks of lines" << std::endl;
  {
    auto histories = new_histories("text", 20480, true);
    with_limit(450000, [&] {
      add_samples(histories, 20480);
      histories.close();
    });
    const std::string csv   = files::read_text("text_group.csv");
    const auto        lines = std::count(csv.begin(), csv.end(), '\n');
    std::cout << "  complete to the end: " << (csv.back() == '\n' ? "yes" : "no") << ", blocks "
              << (lines - 1) / 256 << " and lines " << (lines - 1) % 256 << std::endl;
  }
  print_rows("text");

  std::cout << "Files written at once stay as they were" << std::endl;
  files::write_json("numbers.json", {{"a", 1}});
  with_limit(3, [] { files::write_json("numbers.json", {{"a", 2}}); });
  std::cout << "  " << files::Json::parse(files::read_text("numbers.json")).dump()
            << ", temporary file left behind: " << std::filesystem::exists("numbers.json.part")
            << std::endl;

  std::cout << "A log goes on without its file and says so when closed" << std::endl;
  std::ostringstream console; // standard output may be a file and limited as well
  files::Log         log(&console);
  log.open("log.txt");
  log << "  first line" << std::endl;
  limit_file_size(13);
  log << "  second line" << std::endl;
  with_limit(13, [&] { log.close(); });
  std::cout << console.str() << "  in the file:" << std::endl << files::read_text("log.txt");

  std::cout << "A pipe is written into, not replaced" << std::endl;
  fs::remove("pipe");
  fs::remove("link");
  ::mkfifo("pipe", 0600);
  const int reader = ::open("pipe", O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  files::write_text("pipe", "text");
  std::array<char, 8> text;
  const ssize_t       read = ::read(reader, text.data(), text.size());
  std::cout << "  read: " << std::string(text.data(), std::max<ssize_t>(0, read))
            << ", still a pipe: " << (fs::is_fifo("pipe") ? "yes" : "NO") << std::endl;
  ::close(reader);
  fs::create_symlink("pipe", "link");
  try
    {
      files::write_text("link", "text");
    }
  catch (const RunError &error)
    {
      std::cout << "  " << error.what()
                << " Still there: " << (fs::is_symlink("link") ? "yes" : "NO") << std::endl;
    }

  std::cout << "A device without space" << std::endl;
  try
    {
      files::File file("/dev/full");
      file << "text";
      file.close();
    }
  catch (const RunError &error)
    {
      std::cout << "  " << error.what() << std::endl;
    }
}
