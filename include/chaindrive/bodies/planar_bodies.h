// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/body_group.h>
#include <chaindrive/bodies/planar_kernels.h>

#include <deal.II/base/aligned_vector.h>

#include <vector>

namespace chaindrive::scene
{
struct Scene;
}

namespace chaindrive
{
/// Rigid and lumped bodies that stay in the plane z = const, in three degrees of freedom: what
/// RigidBodies are where nothing can leave the plane, with the same method. Their state stands
/// here, in arrays along the chain, eight bodies side by side in the lanes of the kernels. Those of
/// one kind follow each other by number; where the chain has links, so do the rollers on the
/// first and those on the second bushes of inner links: what touches or pulls its neighbour is then
/// a run of pairs, in which both slots grow by one.
///
/// World has what others read: frames, displacements, velocities and forces at full steps. Between
/// the halves of a step frames are those of the step before, unless publish() is called.
class PlanarBodies : public BodyGroup
{
public:
  static constexpr unsigned int none = static_cast<unsigned int>(-1);

  /// Takes all free bodies of @p world, which was made from @p scene, at its start. Throws
  /// std::logic_error if one of them is not at rest across the plane or is tilted.
  PlanarBodies(const scene::Scene &scene, const World &world);

  void        kick(World &world, double h) override;
  void        drift(World &world, const Step &step) override;
  void        finish(World &world, const Step &step) override;
  double      kinetic_energy(const World &world) const override;
  void        serialize(const Archive &archive, World &world) override;
  std::size_t memory_consumption() const override;

  /// Where @p body stands, or none of a body that is held.
  unsigned int slot_of(const unsigned int body) const { return slot_of_[body]; }

  PlanarSlots          slots() const { return {const_cast<double *>(state_.begin()), n_slots_}; }
  const PlanarKernels &kernels() const { return kernels_; }

  /// Forces and moments become zero, to be added anew.
  void clear_forces();

  /// Adds those of @p world, which others have added there, and writes the sum to both.
  void complete_forces(World &world);

  /// Takes the forces of @p world, which are those of all ranks.
  void take_forces(const World &world);

  /// Frames of @p world take positions, rotations and velocities.
  void publish(World &world) const;

  /// The largest square of the speed of a body in the last drift, m2/s2.
  double fastest_square() const { return fastest_square_; }

private:
  double       *of(const unsigned int entry) { return state_.begin() + entry * n_slots_; }
  const double *of(const unsigned int entry) const { return state_.begin() + entry * n_slots_; }

  const PlanarKernels          &kernels_;
  unsigned int                  n_slots_;
  std::vector<unsigned int>     slot_of_; ///< by body
  std::vector<unsigned int>     bodies_;  ///< by slot
  dealii::AlignedVector<double> state_;   ///< [PlanarEntry][slot]
  double                        fastest_square_ = 0.;
};
} // namespace chaindrive
