// SPDX-License-Identifier: LGPL-2.1-or-later
// Nodes of other ranks. Three ranks own a batch each of two groups of bodies. What a rank always
// wants is there after a fetch; of what it may want only what it wants now, and the rest is no
// number. Forces on ghosts are added to those of their owners, and are gone. Each rank prints to a
// text that the first one shows.
#include "../support/scenes.h"

#include <chaindrive/bodies/node_exchange.h>
#include <chaindrive/mesh/generate/links.h>

#include <deal.II/base/mpi.h>

#include <sstream>

using namespace test;

namespace
{
constexpr unsigned int n_bodies = 3 * n_lanes - 2;

/// A number of its own for each node.
double number_of(const unsigned int group, const unsigned int copy, const unsigned int node)
{
  return 1e4 * (group + 1) + 100. * copy + node;
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const MPI_Comm                                 comm = MPI_COMM_WORLD;
  const unsigned int rank = dealii::Utilities::MPI::this_mpi_process(comm), next = (rank + 1) % 3,
                     last = (rank + 2) % 3;
  const auto part         = std::make_shared<const mesh::Part>(
      mesh::make_roller(drive::make_chain(parameters::Chain()), 7850., mesh::RollerGrid(1, 12, 1)));

  std::vector<BodyBatches> copies;
  for (unsigned int group = 0; group < 2; ++group)
    copies.emplace_back(part,
                        std::vector<unsigned int>(n_bodies, 0),
                        std::vector<Frame>(n_bodies),
                        std::vector<unsigned int>{0, 1, 2, 3},
                        comm);
  for (unsigned int group = 0; group < 2; ++group)
    {
      copies[group].want(next, {2, 3, 7}); // copy k is in batch k modulo 3
      copies[group].may_want(last, {5});
      copies[group].may_want(last + 3, {6});
      copies[group].make_ghosts();
    }
  NodeExchange exchange(comm);
  exchange.connect(copies);

  std::ostringstream text;
  const auto         show = [&](const std::string &what) {
    for (unsigned int group = 0; group < 2; ++group)
      for (unsigned int copy = rank; copy < n_bodies; copy += 3)
        for (unsigned int node = 0; node < copies[group].n_nodes(); ++node)
          {
            const Vector3 x = vector(number_of(group, copy, node), 0., -1.);
            NodeView(copies[group].position).set(copies[group].index(copy, node), x);
            NodeView(copies[group].velocity).set(copies[group].index(copy, node), 2. * x);
          }
    exchange.fetch(copies);
    unsigned int n_present = 0, not_a_number = 0, wrong = 0;
    const auto   look = [&](const unsigned int copy, const unsigned int node) {
      for (unsigned int group = 0; group < 2; ++group)
        {
          const std::size_t at   = copies[group].index(copy, node);
          const Vector3     x    = NodeView(copies[group].position)[at],
                        v        = NodeView(copies[group].velocity)[at],
                        expected = vector(number_of(group, copy, node), 0., -1.);
          (std::isnan(x[0])                    ? not_a_number :
                     x == expected && v == 2. * expected ? n_present :
                                                           wrong) += 1;
        }
    };
    for (const unsigned int node : {2, 3, 7})
      for (unsigned int copy = next; copy < n_bodies; copy += 3)
        look(copy, node);
    const unsigned int always = n_present;
    for (unsigned int copy = last; copy < n_bodies; copy += 3)
      for (const unsigned int node : {5, 6})
        look(copy, node);
    text << what << ": always " << always << ", now " << n_present - always << ", not "
         << not_a_number << ", wrong " << wrong << '\n';
  };
  const auto want = [&](const std::vector<BodyBatches::Place> &places) {
    for (BodyBatches &c : copies)
      c.want_now(places);
    exchange.connect(copies);
  };
  show("nothing now");
  want({{last + 3, 5}, {last, 6}, {rank, 1}});
  show("two now, and one of its own");
  // only the first rank goes on
  want(rank == 0 ? std::vector<BodyBatches::Place>{{last, 5}} : std::vector<BodyBatches::Place>());
  show("one of the first rank's");

  const auto add = [&](const unsigned int copy, const unsigned int node, const double f) {
    for (BodyBatches &c : copies)
      NodeView(c.force).add(c.index(copy, node), vector(f, 0., 1.));
  };
  add(next, 3, 10. * (rank + 1));
  add(rank, 3, 0.5);
  add(rank, 5, 0.25);
  if (rank == 0)
    add(last, 5, 7.);
  exchange.send_forces(copies);
  for (const unsigned int node : {3, 5})
    for (unsigned int group = 0; group < 2; ++group)
      {
        const Vector3 f = NodeView(copies[group].force)[copies[group].index(rank, node)];
        text << "force on its node " << node << ": " << f[0] << ", " << f[2] << '\n';
      }
  double left = 0.;
  for (const BodyBatches &c : copies)
    for (std::size_t i = 0; i < c.force.get_partitioner()->n_ghost_indices(); ++i)
      left += std::abs(c.force.begin()[c.force.locally_owned_size() + i]);
  text << "left on ghosts: " << left << '\n';

  const auto texts = dealii::Utilities::MPI::gather(comm, text.str());
  for (unsigned int r = 0; r < texts.size(); ++r)
    std::cout << "rank " << r << '\n' << texts[r];
}
