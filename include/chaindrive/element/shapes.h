// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Which numbers of an element vanish for regular shapes. Plain functions and arrays only, see
// kernels.h.

#include <chaindrive/utilities/pack.h>

namespace chaindrive::element
{
/// How regular all the elements of a part are, in axes of each element that Hexahedra chooses (see
/// there): the z axis along a prism, the x axis normal to its plane of symmetry.
enum class Shape
{
  general,
  prism,          ///< the upper four vertices are the lower ones moved along z
  symmetric_prism ///< and the section is an isosceles trapezium, as in a ring
};
constexpr int n_shapes = 3;

/// Vertices are in deal.II's order: vertex v of the unit cell has the coordinates s_x, s_y, s_z = 1
/// where bits 0, 1, 2 of v are set and -1 where they are not.
///
///        6---------7        z
///       /|        /|        |  y
///      4---------5 |        | /
///      | 2-------|-3        |/
///      |/        |/         +---- x
///      0---------1
///
/// A trilinear field x is sum_m h_m x_m / 8 with the amplitudes x_m = h_m . x of eight base
/// vectors; with the coordinates s_d = -1 or 1 of a vertex h_m is 1, then in this order s_x, s_y,
/// s_z, s_x s_y, s_y s_z, s_z s_x, s_x s_y s_z. The constant one is left out: neither gradients nor
/// forces have a part in it. The last four are the hourglass modes.
enum BaseVector
{
  base_x,
  base_y,
  base_z,
  base_xy,
  base_yz,
  base_zx,
  base_xyz,
  n_base_vectors
};

/// The entries of a matrix that do not vanish; the kernels read one number for each.
struct NonZeros
{
  int size    = 0;
  int row[78] = {}, column[78] = {};

  constexpr void add(const int r, const int c)
  {
    row[size]    = r;
    column[size] = c;
    ++size;
  }
};

/// Where the mean gradient has numbers: row j for the derivative along axis j, column for a base
/// vector. The first two rows of a prism are those of its section's Jacobian; the base vectors
/// beside z belong to a section that grows across.
constexpr NonZeros gradient_entries(const Shape shape)
{
  constexpr bool present[n_shapes][3][n_base_vectors] = {
      {{true, true, true, true, true, true, true},
       {true, true, true, true, true, true, true},
       {true, true, true, true, true, true, true}},
      {{true, false, false, false, false, false, false},
       {true, true, false, false, false, false, false},
       {false, false, true, false, true, true, false}},
      {{true, false, false, false, false, false, false},
       {false, true, false, false, false, false, false},
       {false, false, true, false, true, false, false}}};
  NonZeros entries;
  for (int j = 0; j < 3; ++j)
    for (int m = 0; m < n_base_vectors; ++m)
      if (present[static_cast<int>(shape)][j][m])
        entries.add(j, m);
  return entries;
}

/// Which hourglass vectors, rows, have a linear part along which axis.
constexpr NonZeros shift_entries(const Shape shape)
{
  NonZeros entries;
  for (int alpha = 0; alpha < 4; ++alpha)
    for (int j = 0; j < 3; ++j)
      if (shape == Shape::general || (alpha == 0 && (j == 0 || (j == 1 && shape == Shape::prism))))
        entries.add(alpha, j);
  return entries;
}

/// An hourglass amplitude: component @p k of base vector @p alpha, counted from base_xy.
struct Amplitude
{
  int alpha, k;
};

/// The twelve amplitudes in four blocks: those that are even or odd about the middle plane of a
/// prism, and about its plane of symmetry.
constexpr Amplitude amplitudes[12] = {{0, 0},
                                      {1, 2}, // even in z and x
                                      {0, 1},
                                      {2, 2},
                                      {3, 2}, // even in z, odd in x
                                      {1, 1},
                                      {2, 0},
                                      {3, 0}, // odd in z, even in x
                                      {0, 2},
                                      {1, 0},
                                      {2, 1},
                                      {3, 1}}; // odd in both

/// The block of each of them in a matrix: that of a regular element does not couple even ones with
/// odd ones.
constexpr int block_of_amplitude[n_shapes][12] = {{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0},
                                                  {0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1},
                                                  {0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3, 3}};

/// The lower triangle of the hourglass matrix, whose rows and columns are these amplitudes. A
/// general element has one block of 12 x 12, 78 numbers; a prism 5 + 7, 43; a symmetric prism 2 + 3
/// + 3 + 4, 25.
constexpr NonZeros hourglass_entries(const Shape shape)
{
  const int *block = block_of_amplitude[static_cast<int>(shape)];
  NonZeros   entries;
  for (int m = 0; m < 12; ++m)
    for (int n = 0; n <= m; ++n)
      if (block[m] == block[n])
        entries.add(m, n);
  return entries;
}

/// Which mean strains of a solid-shell, rows xx, yy, zz, xy, yz, zx, follow from which amplitudes:
/// those of the block that is even or odd as they are.
constexpr NonZeros coupling_entries(const Shape shape)
{
  constexpr int block_of_strain[n_shapes][6] = {
      {0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 1, 1}, {0, 0, 0, 1, 2, 3}};
  NonZeros entries;
  for (int r = 0; r < 6; ++r)
    for (int n = 0; n < 12; ++n)
      if (block_of_strain[static_cast<int>(shape)][r] ==
          block_of_amplitude[static_cast<int>(shape)][n])
        entries.add(r, n);
  return entries;
}

/// Which coordinates of the unit cell, rows, change along which axis.
constexpr NonZeros jacobian_entries(const Shape shape)
{
  NonZeros entries;
  for (int d = 0; d < 3; ++d)
    for (int j = 0; j < 3; ++j)
      if (shape == Shape::general || (d == 2) == (j == 2))
        entries.add(d, j);
  return entries;
}
} // namespace chaindrive::element
