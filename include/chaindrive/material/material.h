// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>

namespace chaindrive
{
/// A linear elastic, isotropic material and what follows from its three numbers: the one place for
/// these formulas (Timoshenko and Goodier, Theory of Elasticity, ch. 1 and 2). Steel by default.
struct Material
{
  double youngs_modulus = 210e9; ///< E, Pa
  double poissons_ratio = 0.3;   ///< nu
  double density        = 7600.; ///< kg/m3

  /// Lamé's constants of S = lambda tr(E) 1 + 2 mu E, Pa; mu is the shear modulus.
  double lambda() const
  {
    return youngs_modulus * poissons_ratio / ((1. + poissons_ratio) * (1. - 2. * poissons_ratio));
  }
  double mu() const { return 0.5 * youngs_modulus / (1. + poissons_ratio); }

  /// lambda + 2 mu, Pa: stress over strain where the sides cannot deflect.
  double constrained_modulus() const { return lambda() + 2. * mu(); }

  /// Pressure over compression, Pa.
  double bulk_modulus() const { return youngs_modulus / (3. * (1. - 2. * poissons_ratio)); }

  /// E / (1 - nu^2), Pa: stress over strain in plane strain, and the factor of Hooke's law in plane
  /// stress, E / (1 - nu^2) ((1 - nu) E + nu tr(E) 1).
  double plane_modulus() const { return youngs_modulus / (1. - poissons_ratio * poissons_ratio); }

  /// E* of two bodies of this material that touch, 1/E* = 2 (1 - nu^2)/E, Pa (Johnson, Contact
  /// Mechanics, 4.1).
  double contact_modulus() const { return 0.5 * plane_modulus(); }

  /// Speed of waves along a thin bar, and of dilatation in the bulk, m/s.
  double bar_wave_speed() const { return std::sqrt(youngs_modulus / density); }
  double bulk_wave_speed() const { return std::sqrt(constrained_modulus() / density); }
};
} // namespace chaindrive
