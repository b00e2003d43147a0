// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/bodies/force_measures.h>
#include <chaindrive/bodies/modal_kernels.h>

namespace chaindrive
{
// With the signs s_ci of class c at image i, forces are known as F_c = sum_i s_ci f_i. Since s s^T
// is n times the identity, g f = sum_c (sum_i s_ci g_i / n) F_c.
ForceMeasures::ForceMeasures(const std::vector<std::vector<double>> &measures,
                             const BodyBatches                      &copies,
                             const reduction::Symmetry              &symmetry,
                             const std::vector<unsigned int>        &node)
    : n_(static_cast<unsigned int>(measures.size()))
    , table_(3 * node.size() * n_, 0.)
    , sum_(start_of(copies.n_batches()), 0.)
{
  const unsigned int n_images = symmetry.n_classes();
  for (std::size_t i = 0; i < node.size(); ++i)
    if (node[i] != ModalNodes::none)
      for (unsigned int c = 0; c < n_images; ++c)
        for (unsigned int k = 0; k < n_; ++k)
          for (unsigned int d = 0; d < 3; ++d)
            table_[((i / n_images * n_images + c) * n_ + k) * 3 + d] +=
                symmetry.sign(i % n_images, c, d) * measures[k][3 * node[i] + d] / n_images;
}

std::vector<double> ForceMeasures::of(const unsigned int batch, const unsigned int lane) const
{
  std::vector<double> measures(n_);
  for (unsigned int k = 0; k < n_; ++k)
    measures[k] = sum_[start_of(batch) + k * n_lanes + lane];
  return measures;
}
} // namespace chaindrive
