// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/parameters/choice.h>

#include <optional>

namespace chaindrive::parameters
{
class Declarations;

/// When surfaces that may touch are searched for anew.
enum class Search
{
  displacement, ///< after anything has moved far enough
  every_step
};

template <>
inline constexpr Texts<Search, 2> texts_of<Search>{
    {{Search::displacement, "displacement"}, {Search::every_step, "every step"}}};

/// How elastic bodies are kept from overlapping.
enum class Enforcement
{
  automatic,    ///< exactly where it can be
  penalty,      ///< by springs between nodes and surfaces
  exact_joints, ///< in joints of reduced bodies exactly, elsewhere by springs
  exact         ///< in joints and on teeth
};

template <>
inline constexpr Texts<Enforcement, 4> texts_of<Enforcement>{
    {{Enforcement::automatic, "auto"},
     {Enforcement::penalty, "penalty"},
     {Enforcement::exact_joints, "exact joints"},
     {Enforcement::exact, "exact"}}};

/// Section `Contact`: penalty law, friction law and search of every interface.
struct Contact
{
  std::optional<double> roller_tooth_stiffness;     ///< N/m; auto: Model/Stiffness from
  std::optional<double> roller_bush_stiffness;      ///< N/m; auto: Model/Stiffness from
  std::optional<double> tooth_stiffness;            ///< N/m; auto: Model/Stiffness from
  double                damping_ratio        = 0.1; ///< of the two bodies on the penalty spring
  double                friction_coefficient = 0.1; ///< of every interface not named below
  std::optional<double> roller_tooth_friction, roller_bush_friction, bush_pin_friction;
  double                tangential_ratio = 0.8; ///< sticking over normal stiffness
  Enforcement           enforcement      = Enforcement::automatic;
  double                penalty_factor   = 0.5; ///< of elastic bodies
  Switch                plate_faces      = Switch::automatic;
  std::optional<double> side_stiffness;     ///< N/m, of rigid plates across their planes
  double                oil_viscosity = 0.; ///< Pa s, of the film between rollers, bushes and teeth
  Search                search        = Search::displacement;

  /// Declares an entry for each member, which takes every value that is set. The object must
  /// outlive @p declarations.
  void declare(Declarations &declarations);
};
} // namespace chaindrive::parameters
