// SPDX-License-Identifier: LGPL-2.1-or-later
// A run that is killed, without a chance to close anything, leaves all rows written by then.
#include <chaindrive/files/file.h>
#include <chaindrive/files/histories.h>

#include <deal.II/base/hdf5.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <iostream>
#include <sys/wait.h>
#include <unistd.h>

using namespace chaindrive;

[[noreturn]] void run_and_be_killed(const unsigned int expected)
{
  files::Histories histories("killed", {}, expected, true);
  const auto       value = histories.add({"group", "value", "1", "Number of the sample"});
  for (unsigned int i = 0;; ++i)
    {
      if (i == 700) // 2 blocks of 256 are written, the rest is in memory
        std::raise(SIGKILL);
      histories.begin_sample(i);
      histories.set(value, i);
      histories.end_sample();
    }
}

int main()
{
  for (const unsigned int expected : {2048u, 300u}) // with the room for 300 the file has grown
    {
      const pid_t child = fork();
      if (child == 0)
        run_and_be_killed(expected);
      int status;
      waitpid(child, &status, 0);
      std::cout << "expected " << expected << ", killed: "
                << (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL ? "yes" : "no");

      dealii::HDF5::File file("killed.h5", dealii::HDF5::File::FileAccessMode::open);
      const auto         values = file.open_dataset("group/value").read<dealii::Vector<double>>();
      unsigned int       right = 0, unwritten = 0;
      for (unsigned int i = 0; i < values.size(); ++i)
        if (std::isnan(values[i]))
          ++unwritten;
        else
          right += values[i] == i;
      const std::string csv = files::read_text("killed_group.csv");
      std::cout << ", rows " << values.size() << ", right " << right << ", not written "
                << unwritten << ", lines of CSV " << std::count(csv.begin(), csv.end(), '\n')
                << std::endl;
    }
}
