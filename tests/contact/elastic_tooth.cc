// SPDX-License-Identifier: LGPL-2.1-or-later
// An elastic roller on the elastic teeth of a sprocket. Undeformed teeth give the forces of a rigid
// sprocket, displaced and turned ones those of a rigid one displaced and turned with them; on
// strained ones the force is the derivative of the contact's energy. Forces cancel in sum and
// moment. A roller pressed into its seat from 5 um above it keeps its energy, and
// with soft contact springs, under which nothing else yields, its force is that of a rigid
// sprocket.
#include "../support/tooth.h"

using namespace test;

int main()
{
  check_geometry(Sprocket::generated);
  check_balance(Sprocket::generated);

  Tooth elastic, rigid;
  rigid.elastic         = false;
  const Outcome pressed = press(elastic), on_rigid = press(rigid);
  verdict("imbalance below 0.5 % of the energy", pressed.worst < 5e-3);
  std::cout << "peak force over that on a rigid sprocket: " << std::fixed << std::setprecision(1)
            << pressed.peak / on_rigid.peak << "; rebound at " << pressed.speed << " of the speed, "
            << on_rigid.speed << " from a rigid one\n";

  elastic.softness = rigid.softness = 1e-3;
  const Outcome soft = press(elastic), soft_rigid = press(rigid);
  verdict("soft springs: peak force and impulse of a rigid sprocket to 1 %",
          std::abs(soft.peak / soft_rigid.peak - 1.) < 1e-2 &&
              std::abs(soft.impulse / soft_rigid.impulse - 1.) < 1e-2);
}
