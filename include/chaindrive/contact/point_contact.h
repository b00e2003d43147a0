// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/bodies/mobility.h>
#include <chaindrive/contact/surface_contact.h>

#include <string>
#include <vector>

namespace chaindrive::contact
{
/// Points of rigid bodies, each with a radius, on surfaces: cylinders in bores, rollers on teeth.
/// Where a point is beside a surface's width, it does not touch.
class PointContact : public SurfaceContact
{
public:
  explicit PointContact(const scene::SurfaceFamily &scene);
  explicit PointContact(const scene::BoreFamily &scene); ///< each slave has its own bore
  explicit PointContact(const scene::SideFamily &scene); ///< each slave has its own face
  explicit PointContact(const scene::ToothSideFamily &scene);

  void add_forces(World &world, double dt) override;
  void add_springs(const World &world, std::vector<Spring> &springs) const override;
  void serialize(const Archive &archive, unsigned int rank) override;

protected:
  double closed_stiffness_; ///< the largest tangent stiffness of a pair, N/m

private:
  PointContact(const std::string        &name,
               const scene::InterfaceOf &interface,
               const scene::ContactLaw  &law,
               std::vector<Pair>         pairs);

  /// add_forces() where all surfaces are of one class: the compiler then knows what they do, which
  /// halves the time of bores. SurfaceType is Surface where they differ.
  template <typename SurfaceType>
  void add_forces_of(World &world, double dt);

  /// Contact of pair @p i with its record.
  template <typename SurfaceType>
  void add_force(World                     &world,
                 unsigned int               i,
                 const SurfaceType         &surface,
                 const Surface::Projection &projection,
                 const Touch               &touch,
                 double                     dt);

  /// Springs that are no softer than pair @p i, closed along any normal across the master's z axis:
  /// @p centre [m, world] is the slave's axis, @p radius [m] how far from it friction acts; @p
  /// along is some direction across z.
  void add_closed(const World                &world,
                  const Mobility             &mobility,
                  unsigned int                i,
                  const dealii::Tensor<1, 3> &along,
                  const dealii::Tensor<1, 3> &centre,
                  double                      radius,
                  std::vector<Spring>        &springs) const;

  /// The same of pair @p i closed at @p point [m, world] on a surface that does not look across its
  /// axis @p z.
  void add_closed_side(const World                &world,
                       unsigned int                i,
                       const dealii::Tensor<1, 3> &z,
                       const dealii::Tensor<1, 3> &point,
                       std::vector<Spring>        &springs) const;

  void (PointContact::*add_forces_)(World &, double) = &PointContact::add_forces_of<Surface>;

  std::vector<unsigned int> hints_; ///< per pair, see Surface::project()
};
} // namespace chaindrive::contact
