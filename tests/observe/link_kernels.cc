// SPDX-License-Identifier: LGPL-2.1-or-later
// What is done with all links at every step, with the kernels of every width of this machine and by
// plain loops: the same numbers, also where they do not fill a pack.
#include <chaindrive/observe/link_kernels.h>
#include <chaindrive/utilities/simd.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>
#include <vector>

using namespace chaindrive;

namespace
{
struct Links
{
  std::vector<double> tension, last, way, sense, most;

  bool operator==(const Links &other) const
  {
    return last == other.last && way == other.way && most == other.most;
  }
};

Links random_links(const unsigned int n, std::mt19937 &generator)
{
  std::uniform_real_distribution<double> force(-1., 1.);
  std::uniform_int_distribution<int>     sense(-1, 1);
  Links                                  links;
  for (unsigned int k = 0; k < n; ++k)
    {
      links.last.push_back(force(generator));
      // some as before: neither on nor back
      links.tension.push_back(k % 5 == 0 ? links.last.back() : force(generator));
      links.way.push_back(k);
      links.sense.push_back(sense(generator));
      links.most.push_back(force(generator));
    }
  return links;
}

/// Returns whether one has turned.
bool follow_plainly(Links &links, const double at, const double smallest)
{
  bool turned = false;
  for (std::size_t k = 0; k < links.tension.size(); ++k)
    {
      const double change = links.tension[k] - links.last[k];
      if (change * links.sense[k] > 0.)
        {
          links.last[k] = links.tension[k];
          links.way[k]  = at;
        }
      else
        turned = turned || std::abs(change) > smallest;
    }
  return turned;
}
} // namespace

int main()
{
  std::mt19937 generator(1);
  unsigned int n_widths = 0, n_cases = 0, n_turned = 0, n_above = 0, n_wrong = 0;
  for (const int width : {1, 2, 4, 8})
    {
      if (!has_simd_width(width))
        continue;
      ++n_widths;
      const observe::LinkKernels &kernels = *observe::link_kernels(width);
      n_wrong += kernels.width != width;
      for (unsigned int n = 0; n <= 40; ++n)
        for (const double smallest : {0.01, 1.2, 1.9})
          {
            Links      links = random_links(n, generator), plain = links;
            const bool turned      = kernels.follow({links.tension.data(),
                                                     links.last.data(),
                                                     links.way.data(),
                                                     links.sense.data(),
                                                     n,
                                                     1e3,
                                                     smallest});
            const bool turned_also = follow_plainly(plain, 1e3, smallest);
            kernels.raise(links.most.data(), links.tension.data(), n);
            for (unsigned int k = 0; k < n; ++k)
              plain.most[k] = std::max(plain.most[k], plain.tension[k]);
            const double limit      = 0.5 * smallest;
            const bool   above      = kernels.any_above(links.tension.data(), n, limit);
            const bool   above_also = std::any_of(plain.tension.begin(),
                                                plain.tension.end(),
                                                [limit](const double x) { return x > limit; });
            n_wrong += !(links == plain) + (turned != turned_also) + (above != above_also);
            ++n_cases;
            n_turned += turned;
            n_above += above;
          }
    }
  // of every width a third or more of the cases each way
  const auto some = [n_cases](const unsigned int n) {
    return 3 * n > n_cases && 3 * (n_cases - n) > n_cases / 2;
  };
  std::cout << (n_widths >= 2 ? "two widths or more" : "too few widths") << std::endl;
  std::cout << "turned " << (some(n_turned) ? "in some" : "in too few or many") << std::endl;
  std::cout << "above  " << (some(n_above) ? "in some" : "in too few or many") << std::endl;
  std::cout << "wrong: " << n_wrong << std::endl;
}
