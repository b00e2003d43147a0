// SPDX-License-Identifier: LGPL-2.1-or-later
// The uncertainty of a mean: four values by hand; no batches, no number; the share of intervals
// that contain the true mean, for independent values and for some that remember the last three;
// means over whole revolutions without what recurs in each.
#include <chaindrive/utilities/batch_means.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <random>
#include <string>

using namespace chaindrive;

namespace
{
/// A normal sequence of mean 0 and variance 1 whose correlation falls by exp(-1/memory) per value.
class Sequence
{
public:
  Sequence(const unsigned int seed, const double memory)
      : random_(seed), factor_(memory > 0. ? std::exp(-1. / memory) : 0.), last_(normal_(random_))
  {
  }

  double next()
  {
    return last_ = factor_ * last_ + std::sqrt(1. - factor_ * factor_) * normal_(random_);
  }

private:
  std::mt19937                     random_;
  std::normal_distribution<double> normal_;
  double                           factor_, last_;
};

constexpr unsigned int n_draws = 4000;

void show(const std::string &what, const unsigned int contained)
{
  const double share = double(contained) / n_draws;
  std::cout << "  " << what << ": ";
  if (share > 0.93 && share < 0.99)
    std::cout << "yes\n";
  else
    std::cout << "NO, in " << share << '\n';
}

double mean_of(const std::vector<double> &values)
{
  double sum = 0.;
  for (const double value : values)
    sum += value;
  return sum / double(values.size());
}

unsigned int contained(const unsigned int n, const double memory, const unsigned int least)
{
  unsigned int found = 0;
  for (unsigned int seed = 0; seed < n_draws; ++seed)
    {
      Sequence            sequence(seed, memory);
      std::vector<double> values;
      for (unsigned int i = 0; i < n; ++i)
        values.push_back(sequence.next());
      found += std::abs(mean_of(values)) <= uncertainty_of_mean(values, least) ? 1 : 0;
    }
  return found;
}
} // namespace

int main()
{
  std::cout << std::setprecision(7) << "1, 2, 3, 4: "
            << uncertainty_of_mean({1., 2., 3., 4.}) /
                   (3.182446305 * std::sqrt(5. / 3. / 4. * 1.6875 / 0.3125))
            << '\n'
            << "pairs: "
            << uncertainty_of_mean({9., 1., 1., 2., 2., 1., 1., 2., 2.}, 2) /
                   (3.182446305 * std::sqrt(1. / 3. / 4.))
            << '\n'
            << "too few: " << (std::isnan(uncertainty_of_mean({1., 2., 3.})) ? "none" : "SOME")
            << ", " << (std::isnan(uncertainty_of_mean({1., 2., 3., 4.}, 2)) ? "none" : "SOME")
            << ", " << (std::isnan(uncertainty_of_mean({})) ? "none" : "SOME") << '\n'
            << "all the same: " << uncertainty_of_mean({2., 2., 2., 2., 2.}) << '\n';

  std::cout << "95 % intervals contain the mean in 93 to 99 % of all cases\n";
  show("12 independent values", contained(12, 0., 1));
  show("200 independent values", contained(200, 0., 1));
  show("200 with a memory of 3, in batches of 10", contained(200, 3., 10));
  show("60 with a memory of 3, in batches of 10", contained(60, 3., 10));

  // the phase goes round in steps that do not divide a revolution
  constexpr double n_per_turn = 1000.3;
  for (const double order : {1., 3.})
    {
      WholeRevolutions revolutions(0., 1e9);
      RevolutionMeans  means;
      double           worst = 0.;
      for (unsigned int step = 0; step < 20000; ++step)
        {
          const double phase = 2. * dealii::numbers::PI * step / n_per_turn;
          means.add(5. + 2. * std::cos(order * phase), revolutions.next(step, 1., phase));
        }
      for (const double mean : means.values())
        worst = std::max(worst, std::abs(mean - 5.));
      std::cout << "revolutions: " << means.values().size() << ", order " << order
                << ", error of their means below 1e-4: " << (worst < 1e-4 ? "yes" : "NO") << '\n';
    }
}
