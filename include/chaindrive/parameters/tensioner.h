// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/parameters/choice.h>

#include <array>
#include <optional>

namespace chaindrive::parameters
{
class Declarations;

/// What holds the axis of a wheel.
enum class Holder
{
  bearing,   ///< it stands still
  arm,       ///< it is on an arm that turns about a pivot
  slide,     ///< it moves along a straight line
  eccentric, ///< an arm that is clamped
  slot       ///< a slide that is clamped
};

template <>
inline constexpr Texts<Holder, 5> texts_of<Holder>{{{Holder::bearing, "bearing"},
                                                    {Holder::arm, "arm"},
                                                    {Holder::slide, "slide"},
                                                    {Holder::eccentric, "eccentric"},
                                                    {Holder::slot, "slot"}}};

/// Whether it stands still where the layout has put it, and has no spring.
constexpr bool is_clamped(const Holder holder)
{
  return holder == Holder::eccentric || holder == Holder::slot;
}

/// Whether a spring presses it against the chain, and its axis moves while the drive runs.
constexpr bool is_sprung(const Holder holder)
{
  return holder == Holder::arm || holder == Holder::slide;
}

/// Whether its travel is an angle, and not a way.
constexpr bool turns(const Holder holder)
{
  return holder == Holder::arm || holder == Holder::eccentric;
}

/// What presses a wheel, or a guide, against the chain. Travel, the turn of an arm [rad] or the way
/// of a slide [m], counts from where the wheel's centre, or the guide's line, is given and is
/// positive where it takes up slack; forces are moments [N m] of an arm.
struct Tensioner
{
  double                preload            = 0.; ///< at no travel, N m or N
  double                stiffness          = 0.; ///< N m/rad or N/m
  double                damping            = 0.; ///< N m s/rad or N s/m
  std::optional<double> retracting_damping = {}; ///< while it retracts; empty: the same
  std::optional<double> least = {}, most = {};   ///< of the travel, rad or m; empty: no stop
  double                inertia = 0.; ///< of the arm about its pivot without the wheel, kg m2, or
                                      ///< of the slide, kg
};

/// Sections `Arm` and `Slide` of a wheel or a guide, of which Holder says which one is there.
struct Holders
{
  Holder                               holder    = Holder::bearing;
  std::optional<std::array<double, 2>> pivot     = {}; ///< of the arm, m
  double                               direction = 0.; ///< of the slide's line, rad
  Tensioner                            arm{}, slide{};

  /// That of the two which is there.
  const Tensioner &tensioner() const { return turns(holder) ? arm : slide; }

  /// Declares an entry for each member, which takes every value that is set. The object must
  /// outlive @p declarations.
  void declare(Declarations &declarations);

  /// The same of a guide, which is fixed, on an arm, or on a slide.
  void declare_of_guide(Declarations &declarations);
};
} // namespace chaindrive::parameters
