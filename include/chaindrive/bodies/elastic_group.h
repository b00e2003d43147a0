// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/body_group.h>
#include <chaindrive/element/element_block.h>

#include <deal.II/base/array_view.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>
#include <deal.II/lac/full_matrix.h>

#include <memory>
#include <vector>

namespace chaindrive
{
/// Bodies of one part with nodes that vibrate and strains between them. They move by their nodes
/// (NodalGroup) or by modes (ModalGroup).
class ElasticGroup : public BodyGroup
{
public:
  /// @p copies: their number in World::copies.
  explicit ElasticGroup(const unsigned int copies) : group_(copies) {}

  unsigned int copies() const { return group_; }

  /// Uses the forces on nodes, which are complete now, while the numbers of a batch are in the
  /// cache: nodal bodies get their internal forces, a kick by a whole step and a
  /// drift, modes of batches that no other rank touches their second kick. Books energies and
  /// momenta of the present instant. With Step::moves false nothing moves, and the forces, now
  /// complete, stay on the nodes.
  virtual void advance(World &world, const Step &step, const ForceTimer &timer) = 0;

  /// The kick of advance() by the forces of an evaluation in which nothing moved: those on nodes
  /// become zero. Positions stay.
  virtual void use_forces(World &world, const Step &step) = 0;

  /// Critical time step [s] of these bodies without contacts.
  virtual double critical_time_step() const = 0;

  /// Where a node of a copy of this rank is now, m, and its velocity, m/s; of nodes that move by
  /// themselves, half a step before.
  virtual dealii::Tensor<1, 3>
  position_now(const World &world, unsigned int copy, unsigned int node) const = 0;
  virtual dealii::Tensor<1, 3>
  velocity_now(const World &world, unsigned int copy, unsigned int node) const = 0;

  /// Both of all nodes of a copy at once.
  virtual void nodes_now(const World                       &world,
                         unsigned int                       copy,
                         std::vector<dealii::Tensor<1, 3>> &position,
                         std::vector<dealii::Tensor<1, 3>> &velocity) const = 0;

  /// What finds stresses in the cells of the part.
  virtual std::vector<std::unique_ptr<const element::StressRecovery>>
  stress_recoveries(const World &world) const = 0;

protected:
  unsigned int group_; ///< in World::copies
};

/// Elastic bodies each of whose nodes moves by itself: three degrees of freedom per node.
class NodalGroup : public ElasticGroup
{
public:
  using ElasticGroup::ElasticGroup;

  /// Brings nodes, from positions and velocities of the start, to where advance() expects them: a
  /// step ahead, with velocities half a step behind. The forces of the start are in @p world, and
  /// complete on nodes. Called once.
  virtual void start(World &world, const Step &step, const ForceTimer &timer) = 0;

  /// Largest natural frequency [rad/s] of such a body when @p springs [N/m] hold each node.
  virtual double largest_frequency(const std::vector<double> &springs) const = 0;
};

/// Modes that all ranks move alike.
class SharedGroup
{
public:
  virtual ~SharedGroup() = default;

  /// Forces on these modes: each rank adds its own until World::sum_over_ranks() makes them the
  /// forces of all. The same numbers on each rank.
  virtual std::vector<dealii::ArrayView<double>> shared_forces(const World &world) = 0;

  /// Their second kick, when the sums are there. Energies are booked on each rank, those of whole
  /// bodies.
  virtual void advance_shared(World &world, const Step &step) = 0;
};

/// Elastic bodies that move as rigid ones do and by modes of unit mass besides,
/// whose amplitudes q [m sqrt(kg)] and rates q' are their state. The modes of batches that several
/// ranks touch are moved by all of them.
class ModalGroup : public ElasticGroup, public SharedGroup
{
public:
  using ElasticGroup::ElasticGroup;

  /// How many modes a body has beside its rigid motions.
  virtual unsigned int n_modes() const = 0;

  /// Squared frequencies [1/s2] as a matrix in terms of modes and rigid motions of unit mass, in
  /// this order, when @p springs [N/m, body axes] hold the nodes; without any, of free bodies.
  virtual dealii::FullMatrix<double>
  modal_matrix(const std::vector<dealii::SymmetricTensor<2, 3>> &springs) const = 0;

  /// How unit amplitudes of the modes and of the rigid motions, in the order of
  /// modal_matrix(), move @p node, body axes, 1/sqrt(kg).
  virtual std::vector<dealii::Tensor<1, 3>> motions_of(unsigned int node) const = 0;

  /// The present amplitudes of a copy that this rank moves, m sqrt(kg), in that order; and new
  /// ones, the same on all ranks that move it, with which its modes are at rest.
  virtual std::vector<double> amplitudes_of(const World &world, unsigned int copy) const = 0;
  virtual void
  rest_at(const World &world, unsigned int copy, const std::vector<double> &amplitudes) = 0;

  /// The accelerations of the modes of a copy that this rank moves, m sqrt(kg)/s2, in that order.
  virtual std::vector<double> accelerations_of(const World &world, unsigned int copy) const = 0;

  /// The measures of a copy, see scene::Scene::measures: the part of the forces that this rank has
  /// put on its nodes.
  virtual std::vector<double> measures_of(const World &world, unsigned int copy) const = 0;

  /// Kinetic energy [J] of the modes that this rank owns at the last advance().
  virtual double modal_energy(const World &world) const = 0;

  /// All modes come to rest where they are.
  virtual void rest() = 0;

  /// The rates of a copy are multiplied by @p factor, on all ranks alike.
  virtual void slow_modes(const World &world, unsigned int copy, double factor) = 0;
};
} // namespace chaindrive
