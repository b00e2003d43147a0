// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/tensor.h>

#include <vector>

namespace chaindrive
{
/// The symmetry of a model about the middle plane z = 0. With it only what lies at z >= 0 is
/// computed: the halves of bodies that deform, with their contacts, and of the contacts of rigid
/// bodies beside them those above the plane. What is below moves as the mirror image, so that
///
/// - forces along the plane, moments about z, masses and energies of whole bodies are twice those
///   that are computed;
/// - forces across the plane and moments about axes in it cancel with those of the image, and
///   nothing moves as a whole across the plane or turns out of it.
///
/// Who deals with halves asks here; nobody else multiplies by two for them. Without the symmetry
/// all of these are as they are computed.
class MirrorSymmetry
{
public:
  constexpr explicit MirrorSymmetry(const bool half = false) : half_(half) {}

  /// Whether only what lies at z >= 0 is computed.
  constexpr bool is_active() const { return half_; }

  /// How many times what is computed makes up the whole: 2 or 1.
  constexpr double multiplicity() const { return half_ ? 2. : 1.; }

  /// A mass, energy, stiffness or moment about z of the whole from that of what is computed.
  constexpr double whole(const double computed) const { return multiplicity() * computed; }

  /// The part of one of the whole that what is computed bears; whole() makes it right again.
  constexpr double share(const double of_whole) const { return of_whole / multiplicity(); }

  /// The force on the whole from that on what is computed.
  dealii::Tensor<1, 3> whole_force(dealii::Tensor<1, 3> computed) const
  {
    computed *= multiplicity();
    cancel_across(computed);
    return computed;
  }

  /// The components of forces, momenta and velocities in which bodies can move as a whole are the
  /// first ones, so many: x and y, and z where there is no plane.
  constexpr unsigned int n_free_directions() const { return half_ ? 2 : 3; }

  /// Takes from a force, a momentum, a velocity or the centre of mass of a whole body what its
  /// mirror image cancels: the component across the plane.
  void cancel_across(double *vector) const
  {
    if (half_)
      vector[2] = 0.;
  }
  void cancel_across(dealii::Tensor<1, 3> &vector) const { cancel_across(vector.begin_raw()); }

  /// The same of a moment: all but its component about z.
  void cancel_tilting(double *moment) const
  {
    if (half_)
      moment[0] = moment[1] = 0.;
  }

  /// Of two places -@p z and @p z those that are computed.
  std::vector<double> axial_positions(const double z) const
  {
    return half_ ? std::vector<double>{z} : std::vector<double>{-z, z};
  }

private:
  bool half_;
};
} // namespace chaindrive
