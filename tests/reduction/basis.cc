// SPDX-License-Identifier: LGPL-2.1-or-later
// Bases of roller and links: sizes, statics under contact loads against those of the mesh (2 %,
// loads at the ends of an inner link 4 %), Phi^T K Phi = W^2, Phi^T M Phi = 1 but for capped
// vectors, no rigid motion, the cap; a half part's basis is the symmetric part of the whole one's;
// the cache returns it bit by bit, to all ranks, as long as nothing changes.
#include <chaindrive/drive/chain.h>
#include <chaindrive/mesh/generate/links.h>
#include <chaindrive/reduction/kept_basis.h>
#include <chaindrive/utilities/ranks.h>

#include <filesystem>
#include <iomanip>
#include <iostream>

using namespace chaindrive;
using namespace reduction;

namespace
{
const Material             material;
const parameters::Elements elements;
const char                *yes(const bool good) { return good ? "yes" : "NO"; }

mesh::Part part_of(const unsigned int which, const bool half)
{
  const auto chain = drive::make_chain(parameters::Chain());
  if (which == 0)
    return mesh::make_roller(chain, material.density, mesh::RollerGrid(2, 24, 4, half));
  mesh::LinkGrid grid = which == 1 ? mesh::inner_link_grid(1) : mesh::outer_link_grid(1);
  grid.half           = half;
  return which == 1 ? mesh::make_inner_link(chain, material.density, grid) :
                      mesh::make_outer_link(chain, material.density, grid);
}

struct Case
{
  Case(const unsigned int which, const bool half)
      : part(part_of(which, half))
      , nodes(part)
      , free(part, nodes, element::ElasticPart(part, nodes, material, elements))
      , basis(make_basis(free, tractions(part, nodes, options.orders), options))
  {
  }

  BasisOptions options;
  mesh::Part   part;
  mesh::Nodes  nodes;
  FreePart     free;
  Basis        basis;
};

void look_at(const Case &c)
{
  const Basis &basis = c.basis;
  std::cout << c.part.name << (c.part.half ? ", half: " : ", whole: ") << basis.n_natural
            << " natural modes, " << basis.size() - basis.n_natural << " attachments\n";
  double largest = 0., at_ends = 0.;
  for (const Load &load : contact_loads(c.part, c.nodes))
    {
      double &worst = load.name.find("ends") == std::string::npos ? largest : at_ends;
      worst         = std::max(worst, static_error(c.free, basis, load.force));
    }
  std::cout << "  compliance that it lacks, %: " << std::fixed << std::setprecision(2)
            << 100. * largest << ", at the ends " << 100. * at_ends << '\n';

  double stiffness = 0., mass = 0., rigid = 0.;
  Vector image(c.free.n_unknowns());
  for (unsigned int i = 0; i < basis.size(); ++i)
    {
      c.free.stiffness().vmult(image, basis.modes[i]);
      for (unsigned int j = 0; j < basis.size(); ++j)
        {
          const double k = image * basis.modes[j] / (basis.omega[i] * basis.omega[j]),
                       m = c.free.mass_product(basis.modes[i], basis.modes[j]);
          stiffness      = std::max(stiffness, std::abs(k - (i == j)));
          if (i != j || basis.omega[i] < 0.999 * c.options.cap)
            mass = std::max(mass, std::abs(m - (i == j)));
          else if (m > 1.) // a capped one is heavier than it should be, never lighter
            mass = 1.;
        }
      for (const Vector &motion : c.free.rigid())
        rigid = std::max(rigid, std::abs(c.free.mass_product(motion, basis.modes[i])));
    }
  std::cout << "  Phi^T K Phi = W^2: " << yes(stiffness < 1e-10)
            << ", Phi^T M Phi = 1: " << yes(mass < 1e-10)
            << ", no rigid motion: " << yes(rigid < 1e-10) << ", largest frequency over the cap "
            << *std::max_element(basis.omega.begin(), basis.omega.end()) / c.options.cap << '\n';
}

/// Displacement under @p force in the basis.
Vector displacement(const Basis &basis, const Vector &force)
{
  Vector u(force.size());
  for (unsigned int i = 0; i < basis.size(); ++i)
    u.add(force * basis.modes[i] / std::pow(basis.omega[i], 2), basis.modes[i]);
  return u;
}

void compare(const Case &half, const Case &whole)
{
  // the node at the mirror image of each, and the node of the whole part at that of the half
  const auto node_at = [&](const dealii::Point<3> &x) {
    unsigned int a = 0;
    while (whole.nodes.position[a].distance(x) > 1e-9)
      ++a;
    return a;
  };
  std::vector<unsigned int> mirrored, in_whole;
  for (const auto &x : whole.nodes.position)
    mirrored.push_back(node_at({x[0], x[1], -x[2]}));
  for (const auto &x : half.nodes.position)
    in_whole.push_back(node_at(x));

  std::vector<double> symmetric;
  for (unsigned int i = 0; i < whole.basis.size(); ++i)
    {
      const Vector &u     = whole.basis.modes[i];
      Vector        image = u;
      for (unsigned int a = 0; a < mirrored.size(); ++a)
        for (unsigned int d = 0; d < 3; ++d)
          image[3 * a + d] = (d == 2 ? -1. : 1.) * u[3 * mirrored[a] + d];
      if (whole.free.mass_product(u, image) > 0.)
        symmetric.push_back(whole.basis.omega[i]);
    }
  double worst = symmetric.size() == half.basis.size() ? 0. : 1.;
  for (unsigned int i = 0; i < std::min<std::size_t>(symmetric.size(), half.basis.size()); ++i)
    worst = std::max(worst, std::abs(symmetric[i] / half.basis.omega[i] - 1.));

  // the third load is a patch along x, which is not among the tractions
  const Vector of_whole =
                   displacement(whole.basis, contact_loads(whole.part, whole.nodes)[3].force),
               of_half = displacement(half.basis, contact_loads(half.part, half.nodes)[3].force);
  double difference    = 0.;
  for (unsigned int a = 0; a < in_whole.size(); ++a)
    for (unsigned int d = 0; d < 3; ++d)
      difference =
          std::max(difference, std::abs(of_half[3 * a + d] - of_whole[3 * in_whole[a] + d]));
  std::cout << half.part.name << ", half and whole: frequencies " << yes(worst < 1e-8)
            << ", displacements under a load " << yes(difference < 1e-8 * of_half.linfty_norm())
            << '\n';
}

void keep()
{
  const bool        first  = rank_in(MPI_COMM_WORLD) == 0;
  const std::string folder = "kept";
  if (first)
    std::filesystem::remove_all(folder);
  statics::Cache cache(first ? folder : "");
  BasisOptions   options;
  Material       steel = material;
  options.orders       = {2, 2};
  const auto get       = [&](const bool half) {
    return kept_basis(part_of(0, half), steel, elements, options, cache, MPI_COMM_WORLD);
  };
  const auto n_files = [&] {
    return std::distance(std::filesystem::directory_iterator(folder),
                         std::filesystem::directory_iterator());
  };
  const auto written = [&] {
    return std::filesystem::directory_iterator(folder)->last_write_time();
  };

  const Basis computed = get(true);
  const auto  when     = first ? written() : decltype(written())();
  const Basis found    = get(true);
  bool        same     = found.omega == computed.omega && found.n_natural == computed.n_natural &&
              found.errors.size() == computed.errors.size();
  for (unsigned int i = 0; i < computed.size(); ++i)
    same = same && computed.modes[i] == found.modes[i];
  const double sum = computed.modes.back().l1_norm();
  if (n_ranks_in(MPI_COMM_WORLD) > 1)
    same = same && dealii::Utilities::MPI::min(sum, MPI_COMM_WORLD) ==
                       dealii::Utilities::MPI::max(sum, MPI_COMM_WORLD);
  if (first)
    std::cout << "kept: the same " << yes(same) << ", errors " << computed.errors.size()
              << ", not written again " << yes(n_files() == 1 && written() == when) << '\n';

  get(false);
  options.modes_up_to *= 2.;
  get(true);
  options.cap *= 2.;
  get(true);
  options.orders.tube = 1;
  get(true);
  options.negligible = 1e-4;
  get(true);
  steel.poissons_ratio = 0.29;
  get(true);
  if (first)
    std::cout << "files after six changes: " << n_files() << ", notes " << cache.notes().size()
              << '\n';
}

/// Entries tell frequencies in Hz, options in radians per second.
void read_entries()
{
  parameters::Reduction entries;
  entries.modes_up_to                   = 70e3;
  entries.highest                       = 130e3;
  entries.tube_order                    = 5;
  entries.pin_order                     = 3;
  const reduction::BasisOptions options = reduction::options_of(entries, 15.875e-3);
  const double                  turn    = 2. * std::acos(-1.);
  std::cout << "options of entries: modes up to " << options.modes_up_to / turn << ", cap "
            << options.cap / turn << " Hz, orders " << options.orders.tube << ' '
            << options.orders.pin << '\n';
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (rank_in(MPI_COMM_WORLD) == 0)
    for (const unsigned int which : {0, 1, 2})
      {
        const Case whole(which, false), half(which, true);
        look_at(whole);
        look_at(half);
        compare(half, whole);
      }
  keep();
  if (rank_in(MPI_COMM_WORLD) == 0)
    read_entries();
}
