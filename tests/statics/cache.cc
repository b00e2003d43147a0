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
#include <utility>
#include <vector>

using namespace chaindrive;
using namespace statics;

namespace
{
constexpr const char *folder = "kept";

/// Extension per pitch at 1 kN [m], and whether all of it was found in the cache.
double pull(const Material &material, const std::string &cache, const std::string &what)
{
  Library      library(material, cache, MPI_COMM_WORLD);
  const auto   chain    = drive::make_chain(parameters::Chain());
  const double approach = library.pulled_links(chain, 4).at(1e3).approach[0];
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

  for (const auto &file : std::filesystem::directory_iterator(folder))
    {
      std::string text;
      std::getline(std::ifstream(file.path()), text);
      text[text.find("um/MPa") + 20] = '#'; // in a number
      std::ofstream(file.path()) << text;
    }
  const double damaged = pull(steel, folder, "damaged");
  for (const auto &file : std::filesystem::directory_iterator(folder))
    std::filesystem::resize_file(file.path(), 100);
  const double cut = pull(steel, folder, "cut off");
  std::cout << "the same: " << (first == damaged && first == cut ? "yes" : "NO") << '\n';
  pull(steel, folder, "repaired");

  // values of other forms, whose checksum is right
  const auto change = [](const std::function<void(nlohmann::json &)> &how) {
    for (const auto &file : std::filesystem::directory_iterator(folder))
      {
        nlohmann::json all = nlohmann::json::parse(std::ifstream(file.path()));
        how(all["value"]);
        all["checksum"] = checksum(all["value"].dump());
        std::ofstream(file.path()) << all << '\n';
      }
  };
  const std::vector<std::pair<std::string, std::function<void(nlohmann::json &)>>> forms = {
      {"a list", [](nlohmann::json &value) { value = nlohmann::json::array(); }},
      {"a value less", [](nlohmann::json &value) { value["um/MPa"].erase(3); }}};
  bool same = true;
  for (const auto &[what, how] : forms)
    {
      change(how);
      same = pull(steel, folder, what) == first && same;
    }
  std::cout << "the same: " << (same ? "yes" : "NO") << '\n';

  // compliances are inverse to the modulus; the contact is wider in a softer material
  steel.youngs_modulus *= 0.5;
  const double softer = pull(steel, folder, "softer");
  std::cout << "twice as soft, but for the contact: "
            << (softer / first > 1.85 && softer / first < 2. ? "yes" : "NO") << '\n';

  std::ofstream("no folder") << "a file";
  pull(steel, "no folder/chaindrive", "a folder that cannot be");
}
