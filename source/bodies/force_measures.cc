// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/force_measures.h>
#include <chaindrive/bodies/modal_kernels.h>

#include <algorithm>

namespace chaindrive
{
ForceMeasures::ForceMeasures(const std::vector<dealii::Vector<double>> &measures,
                             const BodyBatches                         &copies)
    : n_(static_cast<unsigned int>(measures.size()))
    , sum_(std::size_t(copies.n_batches()) * n_ * n_lanes, 0.)
{
  for (unsigned int node = 0; node < copies.n_nodes(); ++node)
    for (const dealii::Vector<double> &measure : measures)
      measure_.insert(measure_.end(), measure.begin() + 3 * node, measure.begin() + 3 * node + 3);
}

void ForceMeasures::measure(const World                     &world,
                            const BodyBatches               &copies,
                            const unsigned int               batch,
                            const std::vector<unsigned int> &nodes)
{
  double *sum = sum_.data() + std::size_t(batch) * n_ * n_lanes;
  std::fill_n(sum, n_ * n_lanes, 0.);
  for (const unsigned int node : nodes)
    {
      if (node == ModalNodes::none)
        continue;
      const double *force = copies.force.begin() + copies.start_of(batch) + node_offset(node);
      if (std::all_of(force, force + 3 * n_lanes, [](const double f) { return f == 0.; }))
        continue;
      copies.for_each_copy_of(batch, [&](const unsigned int copy, const unsigned int lane) {
        dealii::Tensor<1, 3> f;
        for (unsigned int d = 0; d < 3; ++d)
          f[d] = force[d * n_lanes + lane];
        if (f.norm_square() == 0.)
          return;
        f                     = transpose(world.frames[copies.bodies[copy]].rotation) * f;
        const double *measure = &measure_[std::size_t(node) * n_ * 3];
        for (unsigned int k = 0; k < n_; ++k)
          for (unsigned int d = 0; d < 3; ++d)
            sum[k * n_lanes + lane] += measure[3 * k + d] * f[d];
      });
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
