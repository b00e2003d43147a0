// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/element/solid_shell_stiffness.h>

#include <array>
#include <cmath>
#include <vector>

namespace chaindrive::element
{
namespace
{
using dealii::FullMatrix;
using dealii::Tensor;
using Vector = Tensor<1, 3>;

constexpr unsigned int n_displacements = 24;

/// A point of the unit cell, coordinates from -1 to 1 along xi, eta and zeta.
using Place = std::array<double, 3>;

/// The hexahedron in its convected coordinates: xi, eta and zeta are axes across + 1, across + 2
/// and across of the unit cell, in a cycle.
class Convected
{
public:
  Convected(const mesh::Corners &corners, const unsigned int across)
      : corners_(corners), axis_{{(across + 1) % 3, (across + 2) % 3, across}}
  {
  }

  /// Derivative of the shape function of vertex @p a along @p direction.
  double derivative(const unsigned int a, const unsigned int direction, const Place &at) const
  {
    double product = 0.125;
    for (unsigned int d = 0; d < 3; ++d)
      {
        const double side = (a >> axis_[d] & 1) != 0 ? 1. : -1.;
        product *= d == direction ? side : 1. + side * at[d];
      }
    return product;
  }

  /// Change of position along @p direction, m.
  Vector tangent(const unsigned int direction, const Place &at) const
  {
    Vector sum;
    for (unsigned int a = 0; a < 8; ++a)
      sum += derivative(a, direction, at) * corners_[a];
    return sum;
  }

  /// Adds @p factor times what a unit of each displacement does to strain @p s to row @p s of @p B.
  void add_strain(const unsigned int  s,
                  const Place        &at,
                  const double        factor,
                  FullMatrix<double> &B) const
  {
    const unsigned int i = strain_pair[s][0], j = strain_pair[s][1];
    const Vector       along_i = tangent(i, at), along_j = tangent(j, at);
    for (unsigned int a = 0; a < 8; ++a)
      for (unsigned int k = 0; k < 3; ++k)
        B(s, 3 * a + k) += factor * (i == j ? derivative(a, i, at) * along_i[k] :
                                              derivative(a, j, at) * along_i[k] +
                                                  derivative(a, i, at) * along_j[k]);
  }

  /// Strains at a point, those across the wall from where they are sampled.
  FullMatrix<double> strains(const Place &at) const
  {
    FullMatrix<double> B(n_strains, n_displacements);
    for (const unsigned int in_wall : {0, 1, 3})
      add_strain(in_wall, at, 1., B);
    for (const double side : {-1., 1.})
      {
        for (const double other : {-1., 1.})
          add_strain(2, {{side, other, 0.}}, 0.25 * (1. + side * at[0]) * (1. + other * at[1]), B);
        add_strain(4, {{side, 0., 0.}}, 0.5 * (1. + side * at[0]), B);
        add_strain(5, {{0., side, 0.}}, 0.5 * (1. + side * at[1]), B);
      }
    return B;
  }

  Tensor<2, 3> jacobian(const Place &at) const
  {
    Tensor<2, 3> rows;
    for (unsigned int d = 0; d < 3; ++d)
      rows[d] = tangent(d, at);
    return rows;
  }

private:
  const mesh::Corners        &corners_;
  std::array<unsigned int, 3> axis_;
};

/// From strains along convected coordinates with the Jacobian @p rows to those along x, y and z:
/// E = sum e_ij g^i (x) g^j with the vectors g^i dual to the tangents.
FullMatrix<double> to_axes(const Tensor<2, 3> &rows)
{
  const Tensor<2, 3> dual = invert(rows); // column i
  FullMatrix<double> T(n_strains, n_strains);
  for (unsigned int s = 0; s < n_strains; ++s)
    for (unsigned int r = 0; r < n_strains; ++r)
      {
        const unsigned int i = strain_pair[s][0], j = strain_pair[s][1], k = strain_pair[r][0],
                           l = strain_pair[r][1];
        // an angle is e_ij + e_ji
        const double product = i == j ? dual[k][i] * dual[l][i] :
                                        0.5 * (dual[k][i] * dual[l][j] + dual[k][j] * dual[l][i]);
        T(r, s)              = k == l ? product : 2. * product;
      }
  return T;
}

/// The strains that are added: row of the strain, column of its amplitude.
FullMatrix<double> added_strains(const Place &at, const ThicknessPoints points)
{
  const double       xi = at[0], eta = at[1], zeta = at[2];
  const bool         bends = points == ThicknessPoints::two;
  FullMatrix<double> M(n_strains, bends ? 8 : 4);
  M(0, 0) = xi;
  M(1, 1) = eta;
  M(3, 2) = xi;
  M(3, 3) = eta;
  if (bends)
    {
      M(2, 4) = zeta;
      M(2, 5) = xi * zeta;
      M(2, 6) = eta * zeta;
      M(2, 7) = xi * eta * zeta;
    }
  return M;
}

/// A^T C B, times @p factor added to @p sum.
void add_product(const FullMatrix<double> &A,
                 const FullMatrix<double> &C,
                 const FullMatrix<double> &B,
                 const double              factor,
                 FullMatrix<double>       &sum)
{
  FullMatrix<double> stress(C.m(), B.n()), product(A.n(), B.n());
  C.mmult(stress, B);
  A.Tmmult(product, stress);
  sum.add(factor, product);
}
} // namespace

FullMatrix<double> elasticity(const double lambda, const double mu)
{
  FullMatrix<double> C(n_strains, n_strains);
  for (unsigned int i = 0; i < 3; ++i)
    {
      for (unsigned int j = 0; j < 3; ++j)
        C(i, j) = lambda;
      C(i, i) += 2. * mu;
      C(3 + i, 3 + i) = mu;
    }
  return C;
}

SolidShellStiffness solid_shell_stiffness(const mesh::Corners  &corners,
                                          const unsigned int    across,
                                          const Material       &material,
                                          const ThicknessPoints points)
{
  const Convected           cell(corners, across);
  const FullMatrix<double>  C      = elasticity(material.lambda(), material.mu());
  const Tensor<2, 3>        middle = cell.jacobian({{0., 0., 0.}});
  const FullMatrix<double>  turn   = to_axes(middle);
  const double              g      = 1. / std::sqrt(3.);
  const std::vector<double> heights =
      points == ThicknessPoints::two ? std::vector<double>{-g, g} : std::vector<double>{0.};

  const unsigned int n_added = added_strains({{0., 0., 0.}}, points).n();
  FullMatrix<double> k(n_displacements, n_displacements), coupling(n_displacements, n_added),
      inner(n_added, n_added), mean(n_strains, n_displacements);
  double sum = 0.;
  for (const double zeta : heights)
    for (const double eta : {-g, g})
      for (const double xi : {-g, g})
        {
          const Place        at{{xi, eta, zeta}};
          const Tensor<2, 3> jacobian = cell.jacobian(at);
          const double volume = determinant(jacobian) * 2. / static_cast<double>(heights.size());
          FullMatrix<double> B(n_strains, n_displacements), A(n_strains, n_added);
          to_axes(jacobian).mmult(B, cell.strains(at));
          turn.mmult(A, added_strains(at, points));
          A *= determinant(middle) / determinant(jacobian);
          mean.add(volume, B);
          sum += volume;
          add_product(B, C, B, volume, k);
          add_product(B, C, A, volume, coupling);
          add_product(A, C, A, volume, inner);
        }

  // k_uu - k_ua k_aa^-1 k_au
  FullMatrix<double> inverse(n_added, n_added);
  inverse.invert(inner);
  inverse *= -1.;
  k.triple_product(inverse, coupling, coupling, false, true);
  mean /= sum;
  return {k, mean};
}

SolidShellStiffness stiffness_of_type(const mesh::Corners          &corners,
                                      const unsigned int            across,
                                      const Material               &material,
                                      const parameters::ElementType element_type)
{
  SolidShellStiffness shell =
      solid_shell_stiffness(corners, across, material, ThicknessPoints::two);
  if (element_type == parameters::ElementType::membrane)
    {
      shell.stiffness *= membrane_bending;
      shell.stiffness.add(
          1. - membrane_bending,
          solid_shell_stiffness(corners, across, material, ThicknessPoints::one).stiffness);
    }
  return shell;
}

unsigned int nearest_axis(const mesh::Corners &corners, const Tensor<1, 3> &direction)
{
  const Convected cell(corners, 2); // its directions are the axes
  unsigned int    nearest = 0;
  double          largest = -1.;
  for (unsigned int d = 0; d < 3; ++d)
    {
      const Vector along = cell.tangent(d, {{0., 0., 0.}});
      if (const double part = std::abs(along * direction) / along.norm(); part > largest)
        {
          largest = part;
          nearest = d;
        }
    }
  return nearest;
}
} // namespace chaindrive::element
