// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/material/material.h>

#include <deal.II/lac/full_matrix.h>

#include <functional>
#include <string>
#include <vector>

namespace chaindrive::statics
{
/// Patches of a cylindrical side about the line along which it is pressed, on one side of that line
/// and of the middle plane: a quarter of the contact. Patch (angle a, ring s) has the number
/// a * n_rings() + s.
struct PatchGrid
{
  double              radius;   ///< m
  double              width;    ///< of a patch, rad
  unsigned int        n_angles; ///< on one side of the line
  std::vector<double> z;        ///< bounds of the rings, from 0 outwards, m

  unsigned int n_rings() const { return static_cast<unsigned int>(z.size() - 1); }
  unsigned int n() const { return n_angles * n_rings(); }

  static constexpr unsigned int none = static_cast<unsigned int>(-1);

  /// The patch at @p angle [rad] from the line and @p height [m] of either sign, or none.
  unsigned int number(double angle, double height) const;

  /// Area of a quarter's patch at ring @p s, m2.
  double area(const unsigned int s) const { return radius * width * (z[s + 1] - z[s]); }
};

/// Two cylindrical sides that are pressed together.
struct Interface
{
  PatchGrid                     grid;
  std::function<double(double)> gap; ///< over the angle [rad], at the first touch, m
};

/// Displacements per pressure of all patches of all interfaces, both sides added, m/Pa: positive
/// where sides move apart.
using Flexibility = dealii::FullMatrix<double>;

/// A part that deflects, of the patches from @p first on.
struct CompliantPart
{
  std::string  name;
  unsigned int first;
  Flexibility  values;
};

/// What a force presses together.
struct ContactSolution
{
  std::vector<double>              approach;   ///< of each interface's two bodies, m
  std::vector<std::vector<double>> pressure;   ///< of each interface's patches, on the average, Pa
  std::vector<double>              on_line;    ///< largest pressure on each interface's line, Pa
  std::vector<double>              half_angle; ///< up to which each interface touches, rad
  std::vector<double>              given_way;  ///< by each part along the force, m: the approaches
                                               ///< are these, gaps that close and what happens
                                               ///< within patches
  bool reaches_the_end;                        ///< of the patches: more angles are needed
};

/// Frictionless contact of elastic cylinders in one or more interfaces that bear the same force.
///
/// Patches are as wide as elements of the parts; their flexibility is that of the parts. Each is
/// divided further along the circumference, and what happens inside of a patch is that of the
/// half-space: a rectangle of half widths a and b under the pressure p moves the surface at (x, y)
/// from its middle by
///   u = (1 - nu^2)/(pi E) p sum of +- (x +- a) arsinh((y +- b)/|x +- a|) and the same with x and
///   y, a and b exchanged
/// (Love 1929; Johnson, Contact Mechanics, 3.5), of which the mean over patches is left out since
/// it is in the parts' flexibility. With that of the half-plane, whose rings along the axis know
/// nothing of each other, the flexibility of narrow rings would not be positive definite.
class ContactProblem
{
public:
  ContactProblem(std::vector<Interface>     interfaces,
                 std::vector<CompliantPart> parts,
                 const Material            &material);

  /// Pressure >= 0, gap >= 0, one of them zero, at a @p force [N] in each interface.
  ContactSolution at(double force) const;

private:
  std::vector<Interface>     interfaces_;
  std::vector<CompliantPart> parts_;
  dealii::FullMatrix<double> fine_;                      ///< m/Pa
  std::vector<double>        gap_;                       ///< m
  std::vector<double>        share_;                     ///< of the force, per pressure, m2
  std::vector<double>        along_;                     ///< cosine of the angle
  std::vector<unsigned int>  interface_, patch_, strip_; ///< strips count from the line outwards
};
} // namespace chaindrive::statics
