// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/elastic_group.h>
#include <chaindrive/reduction/rim_modes.h>

#include <deal.II/base/tensor.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace chaindrive
{
/// The modes of the rim of a rigid sprocket, by which its teeth move beside it:
///
///   q" + W^2 q = sum Phi^T f,
///
/// f being the forces on points of the profile in the frame of the sprocket. The hub that holds the
/// rim is taken as at rest: what its own acceleration does to the modes and their momentum to it is
/// left out, and so are Coriolis and centrifugal forces. All ranks move them alike by the sum of
/// the forces that each has put on them.
///
/// Central differences as ReducedBodies has them: the first half of a step is in drift(), the
/// second one in advance_shared(), which books the energies of full steps.
class TeethInMotion : public BodyGroup, public SharedGroup
{
public:
  using Points = std::vector<dealii::Tensor<1, 2>>; ///< of the profile about a gap, in its frame

  TeethInMotion(unsigned int body, std::shared_ptr<const reduction::RimModes> modes);

  unsigned int               body() const { return body_; }
  const reduction::RimModes &modes() const { return *modes_; }

  void                                   drift(World &world, const Step &step) override;
  std::vector<dealii::ArrayView<double>> shared_forces(const World &world) override;
  void                                   advance_shared(World &world, const Step &step) override;
  void                                   serialize(const Archive &archive, World &world) override;
  std::size_t                            memory_consumption() const override;

  /// By how much the profile about @p gap is displaced now, m. Returns the most.
  double find_displacements(unsigned int gap, Points &points) const;

  /// Adds forces [N] on that profile.
  void add_forces(unsigned int gap, const Points &forces);

  /// The second kick by the forces of an evaluation in which nothing moved, half of @p dt [s].
  void use_forces(double dt);

  /// All modes come to rest where they are, or where those of @p other are.
  void rest();
  void rest_as(const TeethInMotion &other);

  double modal_energy() const; ///< kinetic, of what is computed, J

  double       &amplitude(const unsigned int m) { return amplitude_[m]; } ///< m sqrt(kg)
  const double &amplitude(const unsigned int m) const { return amplitude_[m]; }

private:
  unsigned int                               body_;
  std::shared_ptr<const reduction::RimModes> modes_;
  std::vector<double>                        cosine_, sine_; ///< [number of waves][gap]
  std::vector<double>                        amplitude_, rate_, acceleration_, force_; ///< per mode
};
} // namespace chaindrive
