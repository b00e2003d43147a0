// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/elastic_bodies.h>
#include <chaindrive/bodies/rim.h>

namespace chaindrive
{
/// The sectors of a Rim. They move as elastic bodies do, but neighbours pull at each other and the
/// hub holds them. The forces of their elements are therefore added before contacts are found, so
/// that what neighbours exchange travels with the forces of contacts. Gravity and drag act on no
/// sprocket.
class ElasticRim : public ElasticBodies, public ForceGroup
{
public:
  /// The rim number @p rim in World::rims.
  ElasticRim(const scene::Scene &scene, const World &world, unsigned int rim);

  /// Places the nodes that the hub holds where the hub is now.
  void drift(World &world, const Step &step) override;

  /// Adds the internal forces, books their energies, and gives the hub what pulls at it.
  void add_forces(World &world, const ForceTimer &timer) override;

  void start(World &world, const Step &step, const ForceTimer &timer) override;
  void advance(World &world, const Step &step, const ForceTimer &timer) override;
  void use_forces(World &world, const Step &step) override;

private:
  unsigned int rim_;
};
} // namespace chaindrive
