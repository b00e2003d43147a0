// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/parameter_handler.h>

#include <optional>
#include <string>

namespace chaindrive::parameters
{
/// Section `Contact`: penalty law, friction law and search of every interface.
struct Contact
{
  std::optional<double> roller_tooth_stiffness;     ///< N/m; auto: ring and line contact in series
  std::optional<double> roller_bush_stiffness;      ///< N/m; auto: conforming contact
  double                damping_ratio        = 0.1; ///< of the two bodies on the penalty spring
  double                friction_coefficient = 0.1; ///< of every interface not named below
  std::optional<double> roller_tooth_friction, roller_bush_friction, bush_pin_friction;
  double                tangential_ratio = 0.8;            ///< sticking over normal stiffness
  double                penalty_factor   = 0.5;            ///< of elastic bodies
  std::string           plate_faces      = "off";          ///< off | on
  std::string           search           = "displacement"; ///< displacement | every step

  /// Declares an entry for each member, which takes every value that is set. The object must
  /// outlive @p prm.
  void declare(dealii::ParameterHandler &prm);
};
} // namespace chaindrive::parameters
