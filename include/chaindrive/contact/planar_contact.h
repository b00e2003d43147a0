// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/contact/forces_in_places.h>
#include <chaindrive/contact/planar_contact_kernels.h>
#include <chaindrive/contact/point_contact.h>

#include <deal.II/base/aligned_vector.h>

#include <memory>
#include <optional>
#include <vector>

namespace chaindrive::contact
{
/// PointContact of bodies that stay in the plane (PlanarBodies): points of a body that differ in
/// their axial position alone touch alike, and are one contact with the law of all of them. These
/// stand side by side in places; records and states of the points follow from them when somebody
/// asks.
class PlanarContact : public PointContact
{
public:
  void   serialize(const Archive &archive, unsigned int rank) override;
  bool   reads_frames() const override { return false; }
  void   add_joint_forces(std::vector<dealii::Tensor<1, 3>> &forces) const override;
  double add_normal_forces(std::vector<double> &forces) const override;
  double deepest() const override;

  const std::vector<Press> &presses() const override;

protected:
  /// @p family is a scene::SurfaceFamily or a scene::BoreFamily; @p curve see PlanarContacts.
  template <typename SceneFamily>
  PlanarContact(const SceneFamily                          &family,
                const World                                &world,
                const std::optional<drive::StiffnessCurve> &curve);

  /// Makes places for contacts, of which each begins with pair @p first, and has the next ones up
  /// to multiplicity() as well; none: a place without a contact. They take over what the pairs
  /// remember. @p room as planar_touch_room, [m].
  void make_places(std::vector<unsigned int> first, const std::vector<double> &room);

  void update_records() const override;

  /// Forces have been evaluated: what is made on demand is so anew.
  void forces_are_new()
  {
    records_are_stale();
    presses_are_known_ = false;
  }

  /// How many points touch alike: the same number in all contacts, or 0 if they differ.
  unsigned int multiplicity() const { return multiplicity_; }

  /// The first pair of each contact among @p pairs, which are as many for each.
  std::vector<unsigned int> contacts_among(const std::vector<unsigned int> &pairs) const;

  /// Evaluates with @p dt [s].
  PlanarContacts arguments(double dt);

  /// Books @p energies, since the last evaluation of what is stored, in the ledger of @p world.
  static void book(const PlanarEnergies &energies, World &world);

  /// [place], the gap between two teeth that the contact is in; null: there are none.
  virtual const unsigned int *features() const { return nullptr; }

  /// See ForcesInPlaces.
  ForcesInPlaces::View      view() const;
  std::vector<unsigned int> joints() const;

  static constexpr unsigned int none = static_cast<unsigned int>(-1);

  const PlanarContactKernels                &kernels_;
  const double                               oval_;       ///< see PlanarContacts
  const std::optional<drive::StiffnessCurve> curve_;      ///< likewise
  std::vector<unsigned int>                  first_pair_; ///< of each place, or none

private:
  double       *of(const unsigned int entry) { return touch_.begin() + entry * n_places(); }
  const double *of(const unsigned int entry) const { return touch_.begin() + entry * n_places(); }
  unsigned int  n_places() const { return static_cast<unsigned int>(first_pair_.size()); }

  /// What pairs remember goes to their places.
  void take_states();

  unsigned int                  multiplicity_;
  std::vector<unsigned int>     joint_, slave_; ///< [place], 0 of a place without a contact
  std::vector<unsigned int>     in_order_;      ///< places with a contact, as in near()
  mutable bool                  presses_are_known_ = false;
  dealii::AlignedVector<double> touch_; ///< [PlanarTouchEntry][place]
};

/// Cylinders in bores.
class PlanarBores : public PlanarContact, public ForcesInPlaces
{
public:
  /// Null if not all of them are on bodies that move in the plane, or not as many points of each.
  static std::unique_ptr<PlanarBores> make(const scene::BoreFamily &family, const World &world);

  void add_forces(World &world, double dt) override;

  View                      forces_in_places() const override { return view(); }
  std::vector<unsigned int> joints_of_places() const override { return joints(); }

private:
  PlanarBores(const scene::BoreFamily &family, const World &world);

  std::vector<PlanarRun> runs_;
};

/// Rollers on the arcs of rigid teeth.
class PlanarFlanks : public PlanarContact
{
public:
  /// Null if not all rollers move in the plane, with as many points each, or the flanks are those
  /// of a mesh. @p on_flanks is the same family as one of a surface.
  static std::unique_ptr<PlanarFlanks>
  make(const scene::ToothFamily &teeth, const scene::SurfaceFamily &on_flanks, const World &world);

  void search(const World &world, double reach) override;
  void add_forces(World &world, double dt) override;
  void serialize(const Archive &archive, unsigned int rank) override;

private:
  PlanarFlanks(const scene::ToothFamily   &teeth,
               const scene::SurfaceFamily &on_flanks,
               const World                &world);

  const unsigned int *features() const override { return gap_.data(); }

  /// Makes places for the pairs that are near.
  void place_near();

  /// What kernels are told, but for the sprocket's motion.
  PlanarTeeth arguments_of_teeth();

  const PlanarBodies           &bodies_;
  std::vector<PlanarSegment>    segments_;
  std::vector<double>           turns_;      ///< cosine and sine of the angle of each gap's sector
  std::vector<double>           shifted_;    ///< of the gaps themselves, if others
  std::vector<unsigned int>     slot_, gap_; ///< see PlanarTeeth
  dealii::AlignedVector<double> known_;      ///< likewise
};
} // namespace chaindrive::contact
