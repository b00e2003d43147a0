// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/mobility.h>
#include <chaindrive/stability/critical_time_step.h>
#include <chaindrive/utilities/eigenvalue.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

namespace chaindrive::stability
{
namespace
{
/// How a unit stretch of a spring pulls one of its two bodies: force and moment.
struct End
{
  unsigned int         body;
  dealii::Tensor<1, 3> force, moment;
};

using Ends = std::array<End, 2>;

Ends ends_of(const Mobility &mobility, const Spring &s)
{
  Ends ends{};
  for (unsigned int i = 0; i < 2; ++i)
    {
      End                       &end  = ends[i];
      const dealii::Tensor<1, 3> pull = i == 0 ? -s.direction : s.direction;
      end.body                        = i == 0 ? s.first : s.second;
      if (end.body == Spring::ground)
        {
          end.body = s.first;
          continue;
        }
      if (s.is_rotational)
        {
          end.moment = pull;
          continue;
        }
      const dealii::Tensor<1, 3> arm =
          (i == 0 ? s.first_at : s.second_at) - mobility.centre(end.body);
      end.force  = pull;
      end.moment = dealii::cross_product_3d(arm, pull);
    }
  return ends;
}

/// The largest eigenvalue of G_ij = sqrt(k_i k_j) b_i^T M^-1 b_j with the stiffnesses @p k.
double largest_of(const World               &world,
                  const Mobility            &mobility,
                  const std::vector<Ends>   &springs,
                  const std::vector<double> &k)
{
  std::vector<dealii::Tensor<1, 3>> force(world.n_bodies()), moment(world.n_bodies());
  std::vector<double>               root(k.size());
  for (std::size_t i = 0; i < k.size(); ++i)
    root[i] = std::sqrt(k[i]);
  return largest_eigenvalue(k.size(), [&](auto &product, const auto &x) {
    std::fill(force.begin(), force.end(), dealii::Tensor<1, 3>());
    std::fill(moment.begin(), moment.end(), dealii::Tensor<1, 3>());
    for (std::size_t i = 0; i < k.size(); ++i)
      for (const End &end : springs[i])
        {
          const double stretch = root[i] * x[i];
          force[end.body] += stretch * end.force;
          moment[end.body] += stretch * end.moment;
        }
    mobility.accelerate(force, moment);
    for (std::size_t i = 0; i < k.size(); ++i)
      {
        double stretch = 0.;
        for (const End &end : springs[i])
          stretch += end.force * force[end.body] + end.moment * moment[end.body];
        product[i] = root[i] * stretch;
      }
  });
}
} // namespace

namespace
{
/// That of the ovals of rollers, whose springs couple with no others.
double critical_time_step_of_ovals(const World &world, const std::vector<Spring> &springs)
{
  struct Sum
  {
    double stiffness, damping;
  };
  std::map<unsigned int, Sum> of_body;
  double                      limit = std::numeric_limits<double>::infinity();
  if (world.planar == nullptr || !world.planar->oval())
    return limit;
  const drive::RollerRing &ring = *world.planar->oval();
  for (const Spring &spring : springs)
    if (spring.is_of_oval)
      {
        Sum &sum = of_body.try_emplace(spring.first, Sum{ring.stiffness, 0.}).first->second;
        sum.stiffness += spring.stiffness;
        sum.damping += spring.damping;
      }
  for (const auto &[body, sum] : of_body)
    limit =
        std::min(limit, critical_time_step_of(sum.stiffness / ring.mass, sum.damping / ring.mass));
  return limit;
}
} // namespace

double critical_time_step(const World &world, const std::vector<Spring> &springs)
{
  std::vector<Spring> others;
  std::copy_if(springs.begin(),
               springs.end(),
               std::back_inserter(others),
               [](const Spring &spring) { return !spring.is_of_oval; });
  if (others.size() < springs.size())
    return std::min(critical_time_step(world, others), critical_time_step_of_ovals(world, springs));
  if (springs.empty())
    return std::numeric_limits<double>::infinity();

  const Mobility      mobility(world);
  std::vector<Ends>   ends;
  std::vector<double> stiffness, damping;
  for (const Spring &spring : springs)
    {
      ends.push_back(ends_of(mobility, spring));
      stiffness.push_back(spring.stiffness);
      damping.push_back(spring.damping);
    }
  const auto largest = [&](const std::vector<double> &k) {
    return largest_of(world, mobility, ends, k);
  };
  double step = critical_time_step_of(largest(stiffness), largest(damping));
  // from a safe step to a larger one that is safe too, since the springs soften as it grows
  for (double before = 0.; std::isfinite(step) && step > 1.0001 * before;)
    {
      before = step;
      std::vector<double> both(stiffness);
      for (unsigned int i = 0; i < both.size(); ++i)
        both[i] += 2. / step * damping[i];
      step = 2. / std::sqrt(largest(both));
    }
  return step;
}

double critical_time_step_of(const double stiffness, const double damping)
{
  return 4. / (damping + std::sqrt(damping * damping + 4. * stiffness));
}
} // namespace chaindrive::stability
