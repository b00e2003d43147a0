// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// What tests of several kinds need.

#include <deal.II/base/tensor.h>

#include <iostream>
#include <string>

namespace test
{
inline dealii::Tensor<1, 3> vector(const double x, const double y, const double z = 0.)
{
  dealii::Tensor<1, 3> v;
  v[0] = x;
  v[1] = y;
  v[2] = z;
  return v;
}

/// Prints whether it holds; NO fails the test.
inline void verdict(const std::string &what, const bool holds)
{
  std::cout << what << ": " << (holds ? "yes" : "NO") << '\n';
}
} // namespace test
