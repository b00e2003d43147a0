// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/body_batches.h>
#include <chaindrive/bodies/elastic_group.h>
#include <chaindrive/bodies/force_measures.h>
#include <chaindrive/bodies/ledger.h>
#include <chaindrive/bodies/modal_kernels.h>

#include <chaindrive/reduction/basis.h>

#include <deal.II/base/aligned_vector.h>
#include <deal.II/lac/full_matrix.h>

#include <cmath>
#include <vector>

namespace chaindrive
{
/// The modes of the reduced bodies of one part: rigid motion and a basis,
///
///   x_a = x_c + R (X_a + Phi_a q),   q" + W^2 q = sum Phi_a^T R^T f_a.
///
/// The rigid motion is that of RigidBodies, with mass and inertia of the nodes. This group has q,
/// which the rank that owns a batch computes, or all do for a shared one, places the nodes of sides
/// that touch, and takes the forces on them to q and, as moments, to the bodies. Forces act at
/// displaced nodes, so that their power is that on R, x_c and q; momentum and angular momentum
/// are those of a rigid body. What is left out is the inertia that comes from q itself: its part in
/// the inertia tensor, and Coriolis and centrifugal forces on it, of the order of the speed of
/// turning over the lowest frequency.
///
/// Central differences in the halves of Newmark's method: the first one is in drift(), the second
/// in advance(), which books the energies of full steps.
class ReducedBodies : public ModalGroup, public SurfaceGroup
{
public:
  /// Moves the nodes of @p world's copies number @p group, which are of the basis in @p scene.
  ReducedBodies(const scene::Scene &scene, World &world, unsigned int group);

  void kick(World &world, double h) override;
  void drift(World &world, const Step &step) override;
  void place_surface(World &world, double earlier) override;

  /// Adds the moments of the forces on nodes, which become zero, to those on their bodies. The
  /// resultant forces are the contact's to add.
  void gather_forces(World &world) override;

  void advance(World &world, const Step &step, const ForceTimer &timer) override;
  std::vector<dealii::ArrayView<double>> shared_forces(const World &world) override;
  void                                   advance_shared(World &world, const Step &step) override;
  void                                   use_forces(World &world, const Step &step) override;

  dealii::Tensor<1, 3>
  position_now(const World &world, unsigned int copy, unsigned int node) const override;
  dealii::Tensor<1, 3>
       velocity_now(const World &world, unsigned int copy, unsigned int node) const override;
  void nodes_now(const World                       &world,
                 unsigned int                       copy,
                 std::vector<dealii::Tensor<1, 3>> &position,
                 std::vector<dealii::Tensor<1, 3>> &velocity) const override;

  double modal_energy(const World &world) const override;
  void   rest() override;
  void   slow_modes(const World &world, unsigned int copy, double factor) override;

  double critical_time_step() const override;
  dealii::FullMatrix<double>
  modal_matrix(const std::vector<dealii::SymmetricTensor<2, 3>> &springs) const override;
  std::vector<dealii::Tensor<1, 3>> motions_of(unsigned int node) const override;
  std::vector<double> amplitudes_of(const World &world, unsigned int copy) const override;
  std::vector<double> accelerations_of(const World &world, unsigned int copy) const override;
  std::vector<double> measures_of(const World &world, unsigned int copy) const override;
  void
  rest_at(const World &world, unsigned int copy, const std::vector<double> &amplitudes) override;
  std::vector<std::unique_ptr<const element::StressRecovery>>
  stress_recoveries(const World &world) const override;

  void        serialize(const Archive &archive, World &world) override;
  std::size_t memory_consumption() const override;

  unsigned int n_modes() const override { return static_cast<unsigned int>(square_.size()); }

  double omega(const unsigned int m) const { return std::sqrt(square_[m]); } ///< rad/s

  /// q [m sqrt(kg)] and q' of mode @p m of a copy that this rank owns; of shared batches to be
  /// changed on all ranks alike.
  double &amplitude(const World &world, unsigned int copy, unsigned int m);
  double &rate(const World &world, unsigned int copy, unsigned int m);

private:
  using Numbers = dealii::AlignedVector<double>;

  /// The modes of @p basis, which are those of a part with @p nodes, and the orbits, first those
  /// with nodes of which @p touches is not 0.
  void take_basis(const mesh::Nodes       &nodes,
                  const reduction::Basis  &basis,
                  const std::vector<char> &touches);

  /// Numbers of a batch in arrays [batch][mode][lane], and where there that of a mode of a copy is.
  std::size_t per_batch() const { return std::size_t(n_modes()) * n_lanes; }
  std::size_t place_of(const BodyBatches &copies, unsigned int copy, unsigned int mode) const;

  /// The second kick of the modes of @p batch, or with Step::moves false only its accelerations.
  /// Adds @p share of their energies to @p ledger.
  void kick_again(unsigned int batch, const Step &step, double share, Ledger &ledger);

  /// Phi of mode @p m at @p node, body axes.
  dealii::Tensor<1, 3> mode_at(unsigned int node, unsigned int m) const;

  /// Sum over the modes at @p node of what @p numbers say of a copy, body axes.
  dealii::Tensor<1, 3> sum_of_modes(const World   &world,
                                    const Numbers &numbers,
                                    unsigned int   copy,
                                    unsigned int   node) const;

  /// The frames of the bodies of @p batch side by side.
  void take_frames(const World &world, unsigned int batch);

  /// The nodes of a batch that somebody reads (BodyBatches::is_read()), and their orbits.
  struct ReadNodes
  {
    std::vector<unsigned int> node;   ///< as in ModalNodes, [orbit that may touch][image]
    std::vector<char>         placed; ///< of these: last time, and read since; it tells the speed
    std::vector<unsigned int> known;  ///< orbits all of whose nodes were placed
    std::vector<unsigned int> fresh;  ///< other orbits
    unsigned long             changes = 0; ///< BodyBatches::reader_changes() of these lists
  };

  /// Brings the lists of @p batch up to date.
  void update_read(const BodyBatches &copies, unsigned int batch);

  /// Amplitudes have changed by themselves: where nodes were tells no speed.
  void forget_places();

  /// Some @p orbits with the @p nodes that are read, moved as the frames taken last and the modes
  /// say.
  ModalNodes modal_nodes(const std::vector<unsigned int> &orbits, const ReadNodes &nodes) const;

  Material             material_;
  parameters::Elements elements_;
  const ModalKernels  &kernels_;

  // in the order of classes of the part's symmetry
  std::vector<unsigned int> class_;      ///< of each mode
  std::vector<unsigned int> first_mode_; ///< as in ModalNodes
  std::vector<double>       square_;     ///< W^2 per mode, 1/s2

  reduction::Symmetry       symmetry_;
  std::vector<unsigned int> orbit_, image_;  ///< of each node
  unsigned int              n_touching_ = 0; ///< orbits with nodes that may touch, the first ones
  std::vector<unsigned int> node_;           ///< of these, as in ModalNodes
  Numbers                   mode_shape_, reference_;

  std::vector<reduction::Vector> rigid_motions_; ///< of unit mass, 1/sqrt(kg)

  // [batch][mode][lane], of batches that this rank owns and of shared ones
  Numbers amplitude_, rate_, acceleration_; ///< q, q', q"
  Numbers modal_force_;                     ///< Q of contacts; of shared ones this rank's, or all

  std::vector<ReadNodes> read_; ///< of each batch

  Numbers                   rigid_;            ///< the frames of a batch, see ModalNodes
  Numbers                   in_body_, moment_; ///< room for the kernels
  ForceMeasures             measures_;
  std::vector<double>       farthest_; ///< per mode, the most that it moves such a node, 1/sqrt(kg)
  std::vector<unsigned int> found_;
};
} // namespace chaindrive
