// SPDX-License-Identifier: LGPL-2.1-or-later
// Bases that were kept in other forms, though their checksums are right: each is computed anew, the
// same to the last bit, and said; the next run finds it.
#include <chaindrive/drive/chain.h>
#include <chaindrive/mesh/generate/links.h>
#include <chaindrive/reduction/kept_basis.h>
#include <chaindrive/utilities/checksum.h>

#include <deal.II/base/mpi.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

using namespace chaindrive;
using nlohmann::json;

namespace
{
constexpr const char *folder = "kept";

reduction::Basis find(const mesh::Part &part)
{
  statics::Cache cache(folder);
  return reduction::kept_basis(part, Material(), parameters::Elements(), {}, cache, MPI_COMM_SELF);
}

bool same(const reduction::Basis &a, const reduction::Basis &b)
{
  return a.n_natural == b.n_natural && a.omega == b.omega && a.modes == b.modes &&
         a.reflections == b.reflections && a.symmetry == b.symmetry;
}

/// Changes what is kept and makes its checksum right.
void change(const std::function<void(json &)> &how)
{
  for (const auto &file : std::filesystem::directory_iterator(folder))
    {
      json all = json::parse(std::ifstream(file.path()));
      how(all["value"]);
      all["checksum"] = checksum(all["value"].dump());
      std::ofstream(file.path()) << all << '\n';
    }
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::filesystem::remove_all(folder);
  const auto       chain = drive::make_chain(parameters::Chain());
  const mesh::Part part  = mesh::make_roller(chain, 7600., mesh::RollerGrid(1, 16, 2));

  const reduction::Basis first = find(part);
  std::cout << "kept: " << (same(first, find(part)) && find(part).notes.empty() ? "yes" : "NO")
            << '\n';
  const std::vector<std::pair<std::string, std::function<void(json &)>>> forms = {
      {"a number", [](json &value) { value = 7; }},
      {"nothing", [](json &value) { value = nullptr; }},
      {"a list", [](json &value) { value = json::array(); }},
      {"no modes", [](json &value) { value["shapes"] = ""; }},
      {"modes that are cut off",
       [](json &value) {
         const std::string text = value["shapes"];
         value["shapes"]        = text.substr(0, text.size() / 8 * 4);
       }},
      {"modes that are a list", [](json &value) { value["shapes"] = json::array(); }},
      {"a frequency less", [](json &value) { value["rad/s"].erase(0); }},
      {"no frequencies", [](json &value) { value["rad/s"] = json::array(); }},
      {"a negative frequency", [](json &value) { value["rad/s"][0] = -1.; }},
      {"too many natural modes", [](json &value) { value["natural"] = 1000000; }},
      {"a class that is none", [](json &value) { value["symmetry"][0] = 99; }},
      {"an axis that is none", [](json &value) { value["reflections"] = {5}; }},
      {"errors of another kind", [](json &value) { value["errors"] = json::array({7}); }},
      {"no natural modes", [](json &value) { value.erase("natural"); }}};
  for (const auto &[what, how] : forms)
    {
      change(how);
      const reduction::Basis anew = find(part);
      std::cout << what << ": " << (same(first, anew) ? "the same" : "ANOTHER") << ", "
                << anew.notes.size() << " note, then " << find(part).notes.size() << '\n';
    }
}
