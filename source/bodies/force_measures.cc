// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/force_measures.h>
#include <chaindrive/bodies/modal_kernels.h>

#include <algorithm>
#include <cmath>

namespace chaindrive
{
namespace
{
/// Whether one of the components [component][lane] of a force is not zero.
bool any(const double *force)
{
  double size[n_lanes];
  for (unsigned int lane = 0; lane < n_lanes; ++lane)
    size[lane] = std::abs(force[lane]) + std::abs(force[n_lanes + lane]) +
                 std::abs(force[2 * n_lanes + lane]);
  for (unsigned int half = n_lanes / 2; half > 0; half /= 2)
    for (unsigned int lane = 0; lane < half; ++lane)
      size[lane] += size[lane + half];
  return size[0] > 0.;
}
} // namespace

ForceMeasures::ForceMeasures(const std::vector<std::vector<double>> &measures,
                             const BodyBatches                      &copies)
    : n_(static_cast<unsigned int>(measures.size()))
    , sum_(std::size_t(copies.n_batches()) * n_ * n_lanes, 0.)
{
  for (unsigned int node = 0; node < copies.n_nodes(); ++node)
    for (const std::vector<double> &measure : measures)
      measure_.insert(measure_.end(), measure.begin() + 3 * node, measure.begin() + 3 * node + 3);
}

void ForceMeasures::measure(const World                     &world,
                            const BodyBatches               &copies,
                            const unsigned int               batch,
                            const std::vector<unsigned int> &nodes)
{
  double turn[3][3][n_lanes] = {}; // into body axes
  copies.for_each_copy_of(batch, [&](const unsigned int copy, const unsigned int lane) {
    for (unsigned int d = 0; d < 3; ++d)
      for (unsigned int e = 0; e < 3; ++e)
        turn[d][e][lane] = world.frames[copies.bodies[copy]].rotation[e][d];
  });
  double *sum = sum_.data() + std::size_t(batch) * n_ * n_lanes;
  std::fill_n(sum, n_ * n_lanes, 0.);
  for (const unsigned int node : nodes)
    {
      if (node == ModalNodes::none)
        continue;
      const double *force = copies.force.begin() + copies.start_of(batch) + node_offset(node);
      if (!any(force))
        continue;
      double in_body[3][n_lanes];
      for (unsigned int d = 0; d < 3; ++d)
        for (unsigned int lane = 0; lane < n_lanes; ++lane)
          in_body[d][lane] = turn[d][0][lane] * force[lane] +
                             turn[d][1][lane] * force[n_lanes + lane] +
                             turn[d][2][lane] * force[2 * n_lanes + lane];
      const double *measure = &measure_[std::size_t(node) * n_ * 3];
      for (unsigned int k = 0; k < n_; ++k, measure += 3)
        for (unsigned int lane = 0; lane < n_lanes; ++lane)
          sum[k * n_lanes + lane] += measure[0] * in_body[0][lane] + measure[1] * in_body[1][lane] +
                                     measure[2] * in_body[2][lane];
    }
}

std::vector<double> ForceMeasures::of(const unsigned int batch, const unsigned int lane) const
{
  std::vector<double> measures(n_);
  for (unsigned int k = 0; k < n_; ++k)
    measures[k] = sum_[(std::size_t(batch) * n_ + k) * n_lanes + lane];
  return measures;
}
} // namespace chaindrive
