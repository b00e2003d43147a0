// SPDX-License-Identifier: LGPL-2.1-or-later
// The stiffness of a drive's parts with and without a cache: found again, damaged, in a folder that
// cannot be written, of another material. Values are the same each time.

#include <chaindrive/drive/drive.h>
#include <chaindrive/statics/part_stiffness.h>
#include <chaindrive/utilities/checksum.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

using namespace chaindrive;
using namespace statics;

namespace
{
constexpr const char *folder = "kept";

/// Extension per pitch at 1 kN [m], and whether all of it was found in the cache: of one row of
/// patches, which takes the least to solve.
double pull(const Material &material, const std::string &cache, const std::string &what)
{
  Library      library(material, cache, MPI_COMM_WORLD);
  const auto   chain    = drive::make_chain(parameters::Chain());
  const double approach = library.pulled_links(chain, 1).at(1e3).approach[0];
  bool         found    = true;
  for (const Library::Entry &entry : library.entries())
    found = found && entry.seconds == 0.;
  std::cout << what << ": " << (found ? "found" : "computed") << ", " << library.notes().size()
            << " notes\n";
  return approach;
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::filesystem::remove_all(folder);

  Material     steel;
  const double first = pull(steel, folder, "empty");
  const double again = pull(steel, folder, "kept");
  std::cout << "the same: " << (first == again ? "yes" : "NO") << '\n';

  // one of the two files in a number, the other cut off
  std::vector<std::filesystem::path> files;
  for (const auto &file : std::filesystem::directory_iterator(folder))
    files.push_back(file.path());
  std::string text;
  std::getline(std::ifstream(files.at(0)), text);
  text[text.find("um/MPa") + 20] = '#';
  std::ofstream(files.at(0)) << text;
  std::filesystem::resize_file(files.at(1), 100);
  const double damaged = pull(steel, folder, "damaged and cut off");
  std::cout << "the same: " << (first == damaged ? "yes" : "NO") << '\n';
  pull(steel, folder, "repaired");

  // values of other forms, whose checksum is right
  const auto change = [&](const unsigned int n, const std::function<void(nlohmann::json &)> &how) {
    nlohmann::json all = nlohmann::json::parse(std::ifstream(files.at(n)));
    how(all["value"]);
    all["checksum"] = checksum(all["value"].dump());
    std::ofstream(files.at(n)) << all << '\n';
  };
  change(0, [](nlohmann::json &value) { value = nlohmann::json::array(); });
  change(1, [](nlohmann::json &value) { value["um/MPa"].erase(3); });
  const double other = pull(steel, folder, "a list, and a value less");
  std::cout << "the same: " << (other == first ? "yes" : "NO") << '\n';

  // compliances are inverse to the modulus; the contact is wider in a softer material
  steel.youngs_modulus *= 0.5;
  const double softer = pull(steel, folder, "softer");
  std::cout << "twice as soft, but for the contact: "
            << (softer / first > 1.85 && softer / first < 2. ? "yes" : "NO") << '\n';

  std::ofstream("no folder") << "a file";
  pull(steel, "no folder/chaindrive", "a folder that cannot be");
}
