// SPDX-License-Identifier: LGPL-2.1-or-later
// Joints of a chain shared out among ranks: each rank has whole batches at first and at second
// bushes, and as few as balance the load, of which observing is the first rank's; no more links
// than a batch have joints of two ranks, which follow each other; and of any stretch of the chain,
// such as what lies on a sprocket, each rank has its share within eight joints: two pieces.
#include <chaindrive/bodies/chain_shares.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

using namespace chaindrive;

namespace
{
void show(const std::string &what, const bool holds)
{
  std::cout << what << ": " << (holds ? "yes" : "no") << '\n';
}

/// Joints of each rank at first and at second bushes.
std::vector<std::array<unsigned int, 2>> count(const std::vector<JointRanks> &ranks,
                                               const unsigned int             n_ranks)
{
  std::vector<std::array<unsigned int, 2>> n(n_ranks, {{0, 0}});
  for (const JointRanks &of_link : ranks)
    for (unsigned int end = 0; end < 2; ++end)
      ++n.at(of_link[end])[end];
  return n;
}
} // namespace

int main()
{
  // the drive of the paper: 55 inner links, 7 batches of joints on each rank, none of them half
  // empty
  const std::vector<JointRanks> paper = share_joints(55, 2, 0.42);
  for (const JointRanks &of_link : paper)
    std::cout << of_link[0] << of_link[1] << ' ';
  std::cout << '\n';
  for (const auto &[first, second] : count(paper, 2))
    std::cout << first << " + " << second << '\n';

  bool all = true, whole = true, even = true, few = true, balanced = true, spread = true;
  for (unsigned int n_ranks = 2; n_ranks <= 9; ++n_ranks)
    for (unsigned int n_batches = n_ranks; n_batches <= 40; n_batches += 3)
      for (const unsigned int n_links : {8 * n_batches - 6, 8 * n_batches})
        for (const double observing : {0., 0.065 * n_batches})
          {
            const std::vector<JointRanks> ranks = share_joints(n_links, n_ranks, observing);
            all                                 = all && ranks.size() == n_links;
            const auto          n               = count(ranks, n_ranks);
            std::vector<double> load;
            for (unsigned int rank = 0; rank < n_ranks; ++rank)
              {
                const auto [first, second] = n[rank];
                if (n_links % 8 == 0)
                  whole = whole && first % 8 == 0 && second % 8 == 0;
                even = even && std::max(first, second) - std::min(first, second) <= 8;
                load.push_back((first + 7) / 8 + (second + 7) / 8 + (rank == 0 ? observing : 0.));
              }

            // no other numbers of batches per rank have a lower peak than one of them moved
            balanced = balanced && *std::max_element(load.begin(), load.end()) <=
                                       *std::min_element(load.begin(), load.end()) + 1. +
                                           (n[0][0] + n[0][1] == 0 ? observing : 0.);

            std::vector<unsigned int> between(n_ranks, 0); // a rank and the next one
            for (const JointRanks &of_link : ranks)
              if (of_link[0] != of_link[1])
                {
                  few = few && of_link[1] == of_link[0] + 1;
                  ++between[of_link[0]];
                }
            few = few && *std::max_element(between.begin(), between.end()) <= 8;

            // of any run of neighbours round the closed chain
            for (unsigned int first = 0; first < n_links; ++first)
              {
                std::vector<unsigned int> of_run(n_ranks, 0);
                for (unsigned int length = 1; length <= n_links / 2; ++length)
                  {
                    for (const unsigned int rank : ranks[(first + length - 1) % n_links])
                      ++of_run[rank];
                    for (unsigned int rank = 0; rank < n_ranks; ++rank)
                      spread =
                          spread && std::abs(of_run[rank] - length * (n[rank][0] + n[rank][1]) /
                                                                double(n_links)) < 8.;
                  }
              }
          }
  show("every link has ranks", all);
  show("whole batches", whole);
  show("as many at first as at second bushes, within a batch", even);
  show("no batch moved lowers the largest load", balanced);
  show("a rank shares at most a batch with the next one", few);
  show("each has its share of any stretch", spread);
}
