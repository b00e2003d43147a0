// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/parameters/parameters.h>

namespace chaindrive
{
void Parameters::declare(parameters::Declarations &declarations)
{
  drive.declare(declarations);
  model.declare(declarations);
  material.declare(declarations);
  mesh.declare(declarations);
  elements.declare(declarations);
  reduction.declare(declarations);
  contact.declare(declarations);
  effects.declare(declarations, drive.sprockets);
  loads.declare(declarations, drive.sprockets);
  time.declare(declarations);
  output.declare(declarations);
  acoustics.declare(declarations);
  sections.declare(declarations);
}
} // namespace chaindrive
