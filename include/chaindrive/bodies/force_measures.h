// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/world.h>
#include <chaindrive/reduction/symmetry.h>

#include <deal.II/base/aligned_vector.h>

#include <vector>

namespace chaindrive
{
/// What observers ask for of the forces f on the nodes of reduced bodies of one part: g f, the sum
/// over all nodes, of some g in body axes (scene::Scene::measures).
class ForceMeasures
{
public:
  ForceMeasures() = default; ///< nobody asks

  /// Of @p copies, each of the @p measures with three components for each node. Node [orbit][image]
  /// is that with this number in the part, or ModalNodes::none, by a @p symmetry.
  ForceMeasures(const std::vector<std::vector<double>> &measures,
                const BodyBatches                      &copies,
                const reduction::Symmetry              &symmetry,
                const std::vector<unsigned int>        &node);

  unsigned int  size() const { return n_; }
  const double *table() const { return table_.data(); } ///< as GatherArguments::measure
  double       *of_batch(const unsigned int batch) { return sum_.data() + start_of(batch); }

  /// Those measured last, of a lane of a batch.
  std::vector<double> of(unsigned int batch, unsigned int lane) const;

private:
  std::size_t start_of(const unsigned int batch) const { return std::size_t(batch) * n_ * n_lanes; }

  unsigned int                  n_ = 0;
  std::vector<double>           table_;
  dealii::AlignedVector<double> sum_; ///< [batch][measure][lane]
};
} // namespace chaindrive
