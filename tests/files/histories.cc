// SPDX-License-Identifier: LGPL-2.1-or-later
// What was put into histories is read back through deal.II's HDF5 interface: every number, the
// sizes, the texts. More samples than expected, fewer, and a file that is being written.
#include <chaindrive/files/histories.h>

#include <deal.II/base/hdf5.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <hdf5.h>
#include <iostream>
#include <random>

using namespace chaindrive;
using dealii::HDF5::File;

double speed(const unsigned int i) { return std::sin(0.1 * i); }
double force(const unsigned int i, const unsigned int column) { return 1000. * column + i / 3.; }

struct Run
{
  Run(const std::string &prefix, const unsigned int expected)
      : histories(prefix, {{"program", "chaindrive"}, {"axes", "x to the driven, ä"}}, expected)
      , speed_(histories.add({"driven", "speed", "rad/s", "Speed of the hub"}))
      , force_(histories.add({"rollers", "contact_force", "N", "On a roller", 3, {"4", "5", "9"}}))
      , unset_(histories.add({"rollers", "never_set", "1", "Nothing"}))
  {
  }

  void sample(const unsigned int i)
  {
    histories.begin_sample(i * 20e-6);
    histories.set(speed_, speed(i));
    for (unsigned int c = 0; c < 3; ++c)
      histories.values(force_)[c] = force(i, c);
    histories.end_sample();
  }

  files::Histories               histories;
  const files::Histories::Handle speed_, force_, unset_;
};

/// Reads the file and says how many of its rows are right and how many not written.
void check(const std::string &prefix)
{
  File       file(prefix + ".h5", File::FileAccessMode::open);
  const auto time   = file.open_dataset("time").read<dealii::Vector<double>>();
  const auto speeds = file.open_dataset("driven/speed").read<dealii::Vector<double>>();
  const auto forces = file.open_dataset("rollers/contact_force").read<dealii::FullMatrix<double>>();
  const auto never_set = file.open_dataset("rollers/never_set").read<dealii::Vector<double>>();

  unsigned int right = 0, unwritten = 0;
  for (unsigned int i = 0; i < time.size(); ++i)
    if (std::isnan(time[i]) && std::isnan(speeds[i]) && std::isnan(forces[i][2]))
      ++unwritten;
    else
      right += time[i] == i * 20e-6 && speeds[i] == speed(i) && forces[i][0] == force(i, 0) &&
               forces[i][1] == force(i, 1) && forces[i][2] == force(i, 2) &&
               std::isnan(never_set[i]);
  std::cout << prefix << ": rows " << time.size() << ", columns " << forces.n() << ", right "
            << right << ", not written " << unwritten << std::endl;
}

/// Numbers without a pattern: all of them come through the compression, which they defeat.
/// After every @p flushed of them the file is brought up to date, wherever a block is.
std::uintmax_t n_wrong_after_compression(const std::string &prefix,
                                         const unsigned int n,
                                         const unsigned int flushed)
{
  std::mt19937                           random(3);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  std::vector<double>                    given;
  files::Histories                       histories(prefix, {}, 512);
  const auto noise = histories.add({"noise", "values", "1", "Nothing", 2, {"a", "b"}});
  for (unsigned int i = 0; i < n; ++i)
    {
      histories.begin_sample(i);
      for (unsigned int c = 0; c < 2; ++c)
        {
          given.push_back(std::ldexp(uniform(random), static_cast<int>(random() % 2000) - 1000));
          histories.values(noise)[c] = given.back();
        }
      histories.end_sample();
      if ((i + 1) % flushed == 0)
        histories.flush();
    }
  histories.close();
  histories.compress();
  File           file(prefix + ".h5", File::FileAccessMode::open);
  const auto     values = file.open_dataset("noise/values").read<dealii::FullMatrix<double>>();
  std::uintmax_t wrong  = values.m() == n ? 0 : 1;
  for (unsigned int i = 0; i < values.m(); ++i)
    for (unsigned int c = 0; c < 2; ++c)
      wrong += values(i, c) == given[2 * i + c] ? 0 : 1;
  return wrong;
}

/// The names of the columns of a dataset.
std::vector<std::string> columns_of(const std::string &path, const std::string &dataset)
{
  const hid_t   file  = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t   names = H5Aopen_by_name(file, dataset.c_str(), "columns", H5P_DEFAULT, H5P_DEFAULT);
  const hid_t   type = H5Aget_type(names), space = H5Aget_space(names);
  const hsize_t n = H5Sget_simple_extent_npoints(space);
  std::vector<char *> texts(n);
  H5Aread(names, type, texts.data());
  std::vector<std::string> result(texts.begin(), texts.end());
  H5Dvlen_reclaim(type, space, H5P_DEFAULT, texts.data());
  H5Tclose(type);
  H5Sclose(space);
  H5Aclose(names);
  H5Fclose(file);
  return result;
}

/// As many columns as the longest chain allowed has links.
void check_many_columns()
{
  std::vector<std::string> labels;
  for (unsigned int k = 0; k < 10000; ++k)
    labels.push_back(std::to_string(k));
  files::Histories histories("many", {}, 2);
  const auto       tension = histories.add({"links", "tension", "N", "Of a link", 10000, labels});
  histories.begin_sample(0.);
  histories.values(tension)[9999] = 5.;
  histories.end_sample();
  histories.close();
  File       file("many.h5", File::FileAccessMode::open);
  const auto values = file.open_dataset("links/tension").read<dealii::FullMatrix<double>>();
  std::cout << "columns " << values.n() << ", last " << values(0, 9999) << ", names right: "
            << (columns_of("many.h5", "links/tension") == labels ? "yes" : "no") << std::endl;
}

int main()
{
  for (const unsigned int n : {1u, 300u, 512u, 1000u})
    {
      const std::string prefix = "samples_" + std::to_string(n);
      {
        Run run(prefix, 512);
        for (unsigned int i = 0; i < n; ++i)
          run.sample(i);
        run.histories.close();
        check(prefix);
        const auto plain = std::filesystem::file_size(prefix + ".h5");
        run.histories.compress();
        std::cout << "compressed, smaller: "
                  << (std::filesystem::file_size(prefix + ".h5") < plain ? "yes" : "no")
                  << std::endl;
      }
      check(prefix);
    }

  for (const unsigned int n : {1u, 2u, 700u})
    std::cout << n << " rows of noise compressed: wrong "
              << n_wrong_after_compression("noise", n, n) << std::endl;
  for (const unsigned int flushed : {1u, 100u, 512u, 600u})
    std::cout << "flushed after every " << flushed << ": wrong "
              << n_wrong_after_compression("noise", 700, flushed) << std::endl;

  Run run("being_written", 512);
  for (unsigned int i = 0; i < 300; ++i)
    run.sample(i);
  run.histories.flush();
  for (unsigned int i = 300; i < 310; ++i)
    run.sample(i);
  check("being_written");
  std::cout << "samples given so far: " << run.histories.n_samples() << std::endl;

  check_many_columns();

  File file("samples_300.h5", File::FileAccessMode::open);
  std::cout << file.get_attribute<std::string>("program") << ", "
            << file.get_attribute<std::string>("axes") << std::endl;
  for (const char *name : {"time", "driven/speed", "rollers/contact_force"})
    {
      const auto dataset = file.open_dataset(name);
      std::cout << name << " [" << dataset.get_attribute<std::string>("unit")
                << "]: " << dataset.get_attribute<std::string>("description") << std::endl;
    }
}
