// SPDX-License-Identifier: LGPL-2.1-or-later
// When the energy guard says that a balance does not close: beyond its limit of the energy turned
// over, which is half of the sum of all lines, never falls, and is at least the floor.
#include <chaindrive/dynamics/guard.h>

#include <iostream>
#include <limits>

using namespace chaindrive;

namespace
{
/// A drive that has worked 2 J, of which @p missing [J] are nowhere.
Ledger ledger_of(const double missing)
{
  Ledger ledger;
  ledger.drive_work = 2.;
  ledger.kinetic    = 1.5 - missing;
  ledger.friction   = 0.5;
  return ledger;
}

void judge(dynamics::EnergyGuard &guard, const double missing, const double floor = 0.)
{
  std::cout << "missing " << missing
            << " J: " << (guard.closes(ledger_of(missing), floor) ? "closes" : "does not close")
            << ", turned over " << guard.turned_over() << " J, at most missing "
            << guard.largest_imbalance() << " J\n";
}
} // namespace

int main()
{
  // turned over are (4 J - m) / 2: a tenth of that is missing where m = 0.4 / 2.1 = 0.190476
  std::cout << "limit 0.1\n";
  dynamics::EnergyGuard guard(0.1);
  judge(guard, 0.);
  judge(guard, 0.25);
  std::cout << "what was turned over stays, here 2 J\n";
  judge(guard, 0.199);
  judge(guard, 0.201);

  std::cout << "anew\n";
  dynamics::EnergyGuard other(0.1);
  judge(other, 0.190);
  dynamics::EnergyGuard third(0.1);
  judge(third, 0.191);
  std::cout << "of another sign\n";
  dynamics::EnergyGuard fourth(0.1);
  judge(fourth, -0.210); // 0.4 / 1.9
  dynamics::EnergyGuard fifth(0.1);
  judge(fifth, -0.211);

  std::cout << "a floor of 5 J\n";
  dynamics::EnergyGuard sixth(0.1);
  judge(sixth, 0.499, 5.);
  judge(sixth, 0.501, 5.);
  std::cout << "not a number\n";
  judge(sixth, std::numeric_limits<double>::quiet_NaN(), 5.);
}
