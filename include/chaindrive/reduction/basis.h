// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/reduction/free_modes.h>
#include <chaindrive/reduction/round_flexibility.h>
#include <chaindrive/reduction/tractions.h>

#include <limits>
#include <string>
#include <vector>

namespace chaindrive::reduction
{
/// How much of a part's elasticity a basis keeps.
struct BasisOptions
{
  double modes_up_to = 2. * dealii::numbers::PI * 60e3;  ///< all free modes below, rad/s
  double cap         = 2. * dealii::numbers::PI * 300e3; ///< attachment modes are no faster, rad/s
  Orders orders;
  double negligible = 3e-3; ///< of the compliance under a traction: what deflects less is left out

  /// All modes of rollers, and of other parts, are slowed to these, rad/s: slower_modes.h.
  double fastest_of_rollers = std::numeric_limits<double>::infinity(),
         fastest_of_links   = std::numeric_limits<double>::infinity();
};

/// Displacements that stand for the elasticity of a part: u = Phi q with q" + W^2 q = Phi^T f.
/// First natural modes, then attachment modes. These are made of what tractions on sides that
/// touch displace beside the natural modes, so that the statics of such tractions are those of the
/// mesh; they vibrate, and those that would be faster than the cap do so with its frequency and a
/// mass to match, without a change of their compliance.
struct Basis
{
  unsigned int        n_natural = 0; ///< of the modes; the rest are attachments
  unsigned int        n_slowed  = 0; ///< of the modes, by slower_modes.h
  std::vector<double> omega; ///< W: of each mode, ascending among natural ones and others, rad/s
  std::vector<Vector> modes; ///< Phi: of each, 1/sqrt(kg)

  std::vector<unsigned int> reflections; ///< the axes of the part's Symmetry
  std::vector<unsigned int> symmetry;    ///< the class of each mode

  /// The part of the compliance under a load that the basis lacks.
  struct Error
  {
    std::string load;
    double      relative; ///< from 0 to 1
  };
  std::vector<Error> errors; ///< for contact_loads()

  /// Of sides in joints, and of the outside of rollers, if no pressures there are among the
  /// tractions: what they deflect without inertia.
  std::vector<RoundFlexibility> joints;

  std::vector<std::string> notes; ///< what was wrong with one that was kept

  unsigned int size() const { return static_cast<unsigned int>(omega.size()); }
};

/// The basis of @p part for some @p tractions, without errors.
///
/// With u_j what the traction j displaces beside the natural modes and C_ij = f_i . u_j, vectors U
/// V L^-1/2 with the eigenpairs C = V L V^T have unit stiffness; the eigenpairs of their masses, of
/// values 1/omega^2, are the Ritz vectors of both K and M. The tractions are scaled to unit
/// compliance before; eigenvectors of C whose value is negligible are left out. All of this is done
/// for each class of the part's symmetry apart, with the parts of tractions and natural modes that
/// are of this class, so that every mode is of one.
Basis make_basis(const FreePart            &part,
                 const std::vector<Vector> &tractions,
                 const BasisOptions        &options);

/// The compliance f . u [J, twice the energy] under the @p force [N] that the @p basis has, with
/// Basis::joints.
double static_compliance(const Basis &basis, const Vector &force);

/// What the modes of the @p basis leave of the displacement under each of the @p forces [N] on the
/// nodes of @p part, relative to the motion of a rigid body, m: C_r f = G f - Phi W^-2 Phi^T f,
/// with G of FreePart::displacements(). It follows forces without inertia.
std::vector<Vector>
massless_displacements(const FreePart &part, const Basis &basis, const std::vector<Vector> &forces);

/// The part of the compliance f . u under the @p force that the @p basis, with Basis::joints,
/// lacks.
double static_error(const FreePart &part, const Basis &basis, const Vector &force);
} // namespace chaindrive::reduction
