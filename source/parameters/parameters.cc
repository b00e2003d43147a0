// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/parameters/parameters.h>

namespace chaindrive
{
void Parameters::declare(dealii::ParameterHandler &prm)
{
  drive.declare(prm);
  model.declare(prm);
  material.declare(prm);
  mesh.declare(prm);
  elements.declare(prm);
  contact.declare(prm);
  effects.declare(prm);
  loads.declare(prm);
  time.declare(prm);
  output.declare(prm);
}
} // namespace chaindrive
