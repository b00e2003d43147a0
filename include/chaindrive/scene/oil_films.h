// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/tooth_form.h>

#include <vector>

namespace chaindrive::scene
{
/// Whose gaps are full of oil. SI units.
struct OilFilms
{
  struct Roller
  {
    unsigned int roller, link; ///< bodies; the link has the bush
    double       bush_x;       ///< of the bush's axis in the link's frame, m
  };
  struct Wheel
  {
    unsigned int     body;
    double           length; ///< of the gap between roller and tooth, m
    drive::ToothForm form;
  };

  double              viscosity;                               ///< Pa s
  double              roller_radius, bore_radius, bush_radius; ///< m
  double              length;                                  ///< of a roller, m
  double              bush_stiffness, tooth_stiffness;         ///< of their contacts, N/m
  std::vector<Roller> rollers;
  std::vector<Wheel>  wheels;
};
} // namespace chaindrive::scene
