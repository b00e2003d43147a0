// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/utilities/errors.h>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <string>

/// Prints what was obtained beside what was expected, with @p digits decimals, and whether they
/// agree to half a unit of the last one (and a little, for expected values that were rounded
/// twice).
inline void
compare(const std::string &name, const double obtained, const double expected, const int digits)
{
  const bool same = std::abs(obtained - expected) < 0.51 * std::pow(10., -digits);
  std::cout << name << ": " << std::fixed << std::setprecision(digits) << obtained << " expected "
            << expected << (same ? "" : "  DIFFERS") << '\n';
}

inline void verdict(const std::string &statement, const bool holds)
{
  std::cout << statement << ": " << (holds ? "yes" : "NO") << '\n';
}

/// Runs @p f and prints the message of the InputError that it must throw.
template <typename Function>
void expect_refusal(const std::string &what, const Function &f)
{
  std::cout << what << ":\n  ";
  try
    {
      f();
      std::cout << "NOT REFUSED\n";
    }
  catch (const chaindrive::InputError &error)
    {
      std::cout << error.what() << '\n';
    }
}
