// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/dynamics/system.h>
#include <chaindrive/observe/plate_stress.h>
#include <chaindrive/scene/scene.h>

#include <map>
#include <vector>

namespace chaindrive::observe
{
/// An elastic body at one instant, in the numbering of its part's mesh.
struct ElasticSnapshot
{
  std::vector<dealii::Tensor<1, 3>> displacement; ///< per vertex, world axes, m
  std::vector<dealii::Tensor<1, 3>> velocity;     ///< per vertex, m/s, half a step before
  std::vector<element::Stress>      stress;       ///< per cell
};

/// What results take from elastic bodies, one body at a time.
class ElasticBodies
{
public:
  /// @p cells: the stresses of cells will be asked for.
  ElasticBodies(const scene::Scene &scene, const dynamics::System &system, bool cells);

  bool has_rollers() const { return !surface_nodes_.empty(); } ///< elastic ones
  bool has_links() const { return !plates_.empty(); }          ///< elastic ones

  /// Displacement, velocity and stress everywhere in an elastic body, or in a sector of a rim, that
  /// this rank owns.
  ElasticSnapshot snapshot(const dynamics::System &system, const World::Address &place) const;

  /// Stresses at the waist of the side plate of an elastic link @p body.
  WaistStress waist(const dynamics::System &system, unsigned int body) const;

  /// Velocity [m/s] of the surface node of an elastic roller @p body, half a step before: of the
  /// node in the chain's middle plane that lies farthest along the tight span's normal at the
  /// start.
  dealii::Tensor<1, 3> surface_velocity(const dynamics::System &system, unsigned int body) const;

private:
  std::map<unsigned int, std::vector<std::unique_ptr<const element::StressRecovery>>>
                                       cells_;         ///< by group of copies
  std::map<unsigned int, PlateStress>  plates_;        ///< by group of copies
  std::map<unsigned int, unsigned int> surface_nodes_; ///< by body
};
} // namespace chaindrive::observe
