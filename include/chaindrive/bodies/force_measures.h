// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/world.h>

#include <vector>

namespace chaindrive
{
/// What observers ask for of the forces f on the nodes of reduced bodies of one part: g f, the sum
/// over all nodes, of some g in body axes (scene::Scene::measures).
class ForceMeasures
{
public:
  ForceMeasures() = default; ///< nobody asks

  /// Of @p copies, each of the @p measures with three components for each node.
  ForceMeasures(const std::vector<std::vector<double>> &measures, const BodyBatches &copies);

  /// Measures the forces on @p nodes of the bodies in a @p batch; some may be
  /// ModalNodes::none.
  void measure(const World                     &world,
               const BodyBatches               &copies,
               unsigned int                     batch,
               const std::vector<unsigned int> &nodes);

  bool asks() const { return n_ != 0; }

  /// Those measured last, of a lane of a batch.
  std::vector<double> of(unsigned int batch, unsigned int lane) const;

private:
  unsigned int        n_ = 0;
  std::vector<double> measure_; ///< [node][measure][component]
  std::vector<double> sum_;     ///< [batch][measure][lane]
};
} // namespace chaindrive
