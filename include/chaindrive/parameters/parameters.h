// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/parameters/acoustics.h>
#include <chaindrive/parameters/contact.h>
#include <chaindrive/parameters/drive.h>
#include <chaindrive/parameters/loads.h>
#include <chaindrive/parameters/model.h>
#include <chaindrive/parameters/run.h>
#include <chaindrive/parameters/sections.h>

#include <string>
#include <utility>
#include <vector>

namespace chaindrive
{
/// Everything a .prm file says, in SI units, one member per section.
struct Parameters
{
  parameters::Drive     drive;
  parameters::Model     model;
  parameters::Material  material;
  parameters::Mesh      mesh;
  parameters::Elements  elements;
  parameters::Reduction reduction;
  parameters::Contact   contact;
  parameters::Effects   effects;
  parameters::Loads     loads;
  parameters::Time      time;
  parameters::Output    output;
  parameters::Acoustics acoustics;
  parameters::Sections  sections; ///< of what registers itself

  /// Where files that entries name are looked for, one after the other.
  std::vector<std::string> folders = {"."};

  /// Declares an entry for each member, which takes every value that is set. The object must
  /// outlive @p declarations.
  void declare(parameters::Declarations &declarations);
};
} // namespace chaindrive
