// SPDX-License-Identifier: LGPL-2.1-or-later
// Pieces of a chain shared out among ranks: each has whole batches, the last one the last piece,
// the first one less by what observing costs; and of any stretch of the chain, such as what lies on
// a sprocket, each has its share within a piece or two.
#include <chaindrive/bodies/partition.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

using namespace chaindrive;

namespace
{
void show(const std::string &what, const bool holds)
{
  std::cout << what << ": " << (holds ? "yes" : "no") << '\n';
}
} // namespace

int main()
{
  // the drive of the paper: 110 pitches are 14 pieces, 7 units, the last one short by a roller pair
  for (const unsigned int rank : spread_pieces(14, 7, 2, 0.065 * 7))
    std::cout << rank << ' ';
  std::cout << '\n';

  bool whole = true, last = true, balanced = true, spread = true;
  for (unsigned int n_ranks = 2; n_ranks <= 9; ++n_ranks)
    for (unsigned int n_units = n_ranks; n_units <= 40; ++n_units)
      for (const unsigned int n_pieces : {2 * n_units - 1, 2 * n_units})
        for (const double observing : {0., 0.065 * n_units})
          {
            const std::vector<unsigned int> ranks =
                spread_pieces(n_pieces, n_units, n_ranks, observing);
            std::vector<unsigned int> count(n_ranks, 0);
            for (const unsigned int rank : ranks)
              ++count.at(rank);
            for (unsigned int rank = 0; rank + 1 < n_ranks; ++rank)
              whole = whole && count[rank] % 2 == 0;
            last = last && ranks.size() == n_pieces && ranks.back() == n_ranks - 1;

            // no other numbers of units per rank have a lower peak than one unit of it moved
            std::vector<double> load;
            for (unsigned int rank = 0; rank < n_ranks; ++rank)
              load.push_back((count[rank] + 1) / 2 + (rank == 0 ? observing : 0.));
            balanced = balanced && *std::max_element(load.begin(), load.end()) <=
                                       *std::min_element(load.begin(), load.end()) + 1. +
                                           (count[0] == 0 ? observing : 0.);

            // of any run of neighbours round the closed chain
            for (unsigned int first = 0; first < n_pieces; ++first)
              {
                std::vector<unsigned int> of_run(n_ranks, 0);
                for (unsigned int length = 1; length <= n_pieces / 2; ++length)
                  {
                    ++of_run[ranks[(first + length - 1) % n_pieces]];
                    for (unsigned int rank = 0; rank < n_ranks; ++rank)
                      spread = spread && std::abs(of_run[rank] -
                                                  length * count[rank] / double(n_pieces)) < 2.5;
                  }
              }
          }
  show("whole batches", whole);
  show("the last piece is the last rank's", last);
  show("no unit moved lowers the largest load", balanced);
  show("each has its share of any stretch", spread);
}
