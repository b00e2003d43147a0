// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/body_group.h>
#include <chaindrive/bodies/planar_kernels.h>
#include <chaindrive/drive/roller_ring.h>

#include <deal.II/base/aligned_vector.h>
#include <deal.II/base/array_view.h>
#include <deal.II/base/tensor.h>

#include <optional>
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
/// World has what others read, frames, displacements, velocities and forces at full steps, once
/// update() has been called. Until then, and between the halves of a step, they are those of an
/// earlier step; publish() writes frames alone.
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

  /// Forces and moments become zero, to be added anew; after drift(), which has begun them, those
  /// of the loads.
  void clear_forces();

  /// Adds the forces of @p gravity [m/s2] and @p drag [1/s], those of the step, unless drift() has
  /// done so. Returns what they come to.
  PlanarLoads add_loads(double gravity, double drag);

  /// Whether others than this class and contact::PlanarContact add forces on these bodies to World,
  /// or change how they move; until told otherwise, yes. Then complete_forces() has something to
  /// do. If not, the first kick() of a step waits for drift(), which needs one pass for both.
  void set_others_act(const bool others_act) { others_act_ = others_act; }
  bool others_act() const { return others_act_; }

  /// Adds those of @p world, which others have added there, and writes the sum to both.
  void complete_forces(World &world);

  /// Those of @p world become what they are here, on which nobody else adds.
  void write_forces(World &world) const;

  /// Brings @p world up to the present, at full steps, unless it is.
  void update(World &world);

  /// Takes the forces of @p world, which are those of all ranks.
  void take_forces(const World &world);

  /// How rollers become ovals, if they do.
  const std::optional<drive::RollerRing> &oval() const { return oval_; }

  /// Adds the elastic forces on ovals, and their energy to the ledger of @p world.
  void bend_ovals(World &world);

  /// The forces on ovals, to be summed over ranks; empty without ovals.
  dealii::ArrayView<double> forces_on_ovals();

  /// The oval of the body in @p slot, a and b of drive::RollerRing, m.
  dealii::Tensor<1, 2> oval_of(const unsigned int slot) const { return two_of(planar_ring, slot); }

  /// Frames of @p world take positions, rotations and velocities.
  void publish(World &world) const;

  /// The largest square of the speed of a body in the last drift, m2/s2.
  double fastest_square() const { return fastest_square_; }

  /// No body has gone farther than this since this was made, m.
  double travelled() const { return travelled_; }

  dealii::Tensor<1, 2> position(const unsigned int slot) const
  {
    return two_of(planar_position, slot);
  }
  dealii::Tensor<1, 2> velocity(const unsigned int slot) const
  {
    return two_of(planar_velocity, slot);
  }
  /// Cosine and sine of the angle of a body that has one.
  dealii::Tensor<1, 2> rotation(const unsigned int slot) const
  {
    return two_of(planar_rotation, slot);
  }
  double spin(const unsigned int slot) const { return of(planar_spin)[slot]; } ///< rad/s

private:
  double       *of(const unsigned int entry) { return state_.begin() + entry * n_slots_; }
  const double *of(const unsigned int entry) const { return state_.begin() + entry * n_slots_; }

  dealii::Tensor<1, 2> two_of(const unsigned int entry, const unsigned int slot) const
  {
    dealii::Tensor<1, 2> both;
    both[0] = of(entry)[slot];
    both[1] = of(entry + 1)[slot];
    return both;
  }

  const PlanarKernels             &kernels_;
  unsigned int                     n_slots_;
  std::vector<unsigned int>        slot_of_; ///< by body
  std::vector<unsigned int>        bodies_;  ///< in the order of slots
  dealii::AlignedVector<double>    state_;   ///< [PlanarEntry][slot]
  double                           fastest_square_ = 0., travelled_ = 0.;
  bool                             others_act_ = true;
  bool                             is_behind_  = false; ///< World, since the last update()
  bool                             has_moved_  = true;  ///< drift() has been the last to move them
  bool                             begun_      = false; ///< forces, by drift()
  double                           waits_      = 0.;    ///< a kick, for drift(), s
  std::optional<double>            kinetic_energy_;     ///< as the last kick() left it, J
  std::optional<PlanarLoads>       loads_;              ///< that forces begin with
  std::optional<drive::RollerRing> oval_;
};
} // namespace chaindrive
