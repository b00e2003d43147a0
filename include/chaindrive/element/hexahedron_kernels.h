// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// The formulas of doc/theory.md, section "Elastic bodies", for P::width copies at a time.

#include <chaindrive/element/kernels.h>

namespace chaindrive::element::bodies
{
/// A symmetric tensor: xx, yy, zz, xy, yz, zx.
template <typename P>
struct Symmetric
{
  P xx, yy, zz, xy, yz, zx;
};

/// Green's strain E = (F^T F - 1) / 2.
template <typename P>
CHAINDRIVE_ALWAYS_INLINE Symmetric<P> green_strain(const P (&F)[3][3])
{
  const P half(0.5), one(1.);
  return {half * (F[0][0] * F[0][0] + F[1][0] * F[1][0] + F[2][0] * F[2][0] - one),
          half * (F[0][1] * F[0][1] + F[1][1] * F[1][1] + F[2][1] * F[2][1] - one),
          half * (F[0][2] * F[0][2] + F[1][2] * F[1][2] + F[2][2] * F[2][2] - one),
          half * (F[0][0] * F[0][1] + F[1][0] * F[1][1] + F[2][0] * F[2][1]),
          half * (F[0][1] * F[0][2] + F[1][1] * F[1][2] + F[2][1] * F[2][2]),
          half * (F[0][2] * F[0][0] + F[1][2] * F[1][0] + F[2][2] * F[2][0])};
}

/// The second Piola-Kirchhoff stress S = lambda tr(E) 1 + 2 mu E of St. Venant and Kirchhoff; adds
/// the energy S : E / 2 times @p volume to @p energy.
template <typename P>
CHAINDRIVE_ALWAYS_INLINE Symmetric<P>
stress(const Symmetric<P> &E, const P lambda, const P mu, const P volume, P &energy)
{
  const P            pressure = lambda * (E.xx + E.yy + E.zz), twice = mu + mu;
  const Symmetric<P> S{pressure + twice * E.xx,
                       pressure + twice * E.yy,
                       pressure + twice * E.zz,
                       twice * E.xy,
                       twice * E.yz,
                       twice * E.zx};
  energy += volume * (P(0.5) * (S.xx * E.xx + S.yy * E.yy + S.zz * E.zz) + S.xy * E.xy +
                      S.yz * E.yz + S.zx * E.zx);
  return S;
}

/// Row i of F S times @p factor.
template <typename P>
CHAINDRIVE_ALWAYS_INLINE void
times(const P (&F)[3], const Symmetric<P> &S, const P factor, P (&T)[3])
{
  T[0] = factor * (F[0] * S.xx + F[1] * S.xy + F[2] * S.zx);
  T[1] = factor * (F[0] * S.xy + F[1] * S.yy + F[2] * S.yz);
  T[2] = factor * (F[0] * S.zx + F[1] * S.yz + F[2] * S.zz);
}

/// The four hourglass sums h_alpha . x of eight numbers.
template <typename P>
CHAINDRIVE_ALWAYS_INLINE void hourglass_sums(const P (&x)[8], P (&q)[4])
{
  // differences and sums along x, at y and z
  const P d0 = x[1] - x[0], d1 = x[3] - x[2], d2 = x[5] - x[4], d3 = x[7] - x[6];
  const P s0 = x[1] + x[0], s1 = x[3] + x[2], s2 = x[5] + x[4], s3 = x[7] + x[6];
  const P low = d1 - d0, high = d3 - d2;
  q[0] = high + low;
  q[1] = (s3 - s2) - (s1 - s0);
  q[2] = (d3 + d2) - (d1 + d0);
  q[3] = high - low;
}

/// Subtracts sum_alpha h_alpha r_alpha from eight numbers, the transpose of hourglass_sums().
template <typename P>
CHAINDRIVE_ALWAYS_INLINE void subtract_hourglass(const P (&r)[4], P (&x)[8])
{
  const P p = r[0] + r[2], m = r[0] - r[2];
  const P d0 = r[3] - p, d1 = m - r[3], d2 = P(0.) - m - r[3], d3 = p + r[3];
  x[0] -= r[1] - d0;
  x[1] -= r[1] + d0;
  x[2] += r[1] + d1;
  x[3] += r[1] - d1;
  x[4] += r[1] + d2;
  x[5] += r[1] - d2;
  x[6] -= r[1] - d3;
  x[7] -= r[1] + d3;
}

/// Component @p i of the positions of an element's vertices.
template <typename P, int width>
CHAINDRIVE_ALWAYS_INLINE void
gather(const unsigned int (&node)[8], const int i, const double *from, P (&x)[8])
{
  for (int a = 0; a < 8; ++a)
    x[a] = P::load(from + (3 * node[a] + i) * n_lanes);
}

/// Elements with one point: the mean gradient, and a stiffness of the hourglass amplitudes.
template <int width, Formulation formulation>
CHAINDRIVE_ALWAYS_INLINE void add_mean_forces(const ForceArguments &arg, const int lane)
{
  using P            = Pack<double, width>;
  P strain_energy    = P::load(arg.strain_energy + lane);
  P hourglass_energy = P::load(arg.hourglass_energy + lane);

  for (unsigned int e = 0; e < arg.n_elements; ++e)
    {
      const Hexahedron &element = arg.elements[e];

      P F[3][3], q[3][4]; // q: component, amplitude
      for (int i = 0; i < 3; ++i)
        {
          P x[8];
          gather<P, width>(element.node, i, arg.position + lane, x);
          hourglass_sums(x, q[i]);
          for (int j = 0; j < 3; ++j)
            {
              F[i][j] = x[0] * P(element.gradient[j][0]);
              for (int a = 1; a < 8; ++a)
                F[i][j] += x[a] * P(element.gradient[j][a]);
              for (int alpha = 0; alpha < 4; ++alpha)
                q[i][alpha] -= F[i][j] * P(element.shift[alpha][j]);
            }
        }

      const Symmetric<P> S =
          stress(green_strain(F), P(arg.lambda), P(arg.mu), P(element.volume), strain_energy);
      P T[3][3]; // V F S and what follows: the force on vertex a is -T B_a - h r
      for (int i = 0; i < 3; ++i)
        times(F[i], S, P(element.volume), T[i]);

      P r[3][4]; // force of the amplitudes
      if constexpr (formulation == Formulation::enhanced)
        {
          // Amplitudes in the part's axes: F^T q is the same however the element has turned.
          P pulled[12], s[12];
          for (int alpha = 0; alpha < 4; ++alpha)
            for (int k = 0; k < 3; ++k)
              pulled[3 * alpha + k] =
                  F[0][k] * q[0][alpha] + F[1][k] * q[1][alpha] + F[2][k] * q[2][alpha];
          const HourglassStiffness &K = arg.hourglass[e];
          P                         twice_energy(0.);
          for (int m = 0; m < 12; ++m)
            {
              s[m] = P(K.k[m][0]) * pulled[0];
              for (int n = 1; n < 12; ++n)
                s[m] += P(K.k[m][n]) * pulled[n];
              twice_energy += s[m] * pulled[m];
            }
          hourglass_energy += P(0.5) * twice_energy;
          for (int i = 0; i < 3; ++i)
            for (int alpha = 0; alpha < 4; ++alpha)
              {
                r[i][alpha] = F[i][0] * s[3 * alpha] + F[i][1] * s[3 * alpha + 1] +
                              F[i][2] * s[3 * alpha + 2];
                for (int k = 0; k < 3; ++k)
                  T[i][k] += q[i][alpha] * s[3 * alpha + k];
              }
        }
      else
        {
          const P k(arg.hourglass_stiffness[e]);
          P       twice_energy(0.);
          for (int i = 0; i < 3; ++i)
            for (int alpha = 0; alpha < 4; ++alpha)
              {
                r[i][alpha] = k * q[i][alpha];
                twice_energy += r[i][alpha] * q[i][alpha];
              }
          hourglass_energy += P(0.5) * twice_energy;
        }

      for (int i = 0; i < 3; ++i)
        {
          for (int j = 0; j < 3; ++j)
            for (int alpha = 0; alpha < 4; ++alpha)
              T[i][j] -= r[i][alpha] * P(element.shift[alpha][j]);
          P f[8];
          gather<P, width>(element.node, i, arg.force + lane, f);
          subtract_hourglass(r[i], f);
          for (int a = 0; a < 8; ++a)
            {
              f[a] -= T[i][0] * P(element.gradient[0][a]) + T[i][1] * P(element.gradient[1][a]) +
                      T[i][2] * P(element.gradient[2][a]);
              f[a].store(arg.force + (3 * element.node[a] + i) * n_lanes + lane);
            }
        }
    }
  strain_energy.store(arg.strain_energy + lane);
  hourglass_energy.store(arg.hourglass_energy + lane);
}

/// Elements with 2 x 2 x 2 points.
template <int width>
CHAINDRIVE_ALWAYS_INLINE void add_full_forces(const ForceArguments &arg, const int lane)
{
  using P         = Pack<double, width>;
  P strain_energy = P::load(arg.strain_energy + lane);

  for (unsigned int e = 0; e < arg.n_elements; ++e)
    {
      const Hexahedron &element = arg.elements[e];
      P                 x[3][8], f[3][8];
      for (int i = 0; i < 3; ++i)
        {
          gather<P, width>(element.node, i, arg.position + lane, x[i]);
          gather<P, width>(element.node, i, arg.force + lane, f[i]);
        }
#pragma GCC unroll 1
      for (int point = 0; point < 8; ++point)
        {
          const double(&gradient)[3][8] = arg.points[e].gradient[point];
          const P volume(arg.points[e].volume[point]);
          P       F[3][3];
          for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
              {
                F[i][j] = x[i][0] * P(gradient[j][0]);
                for (int a = 1; a < 8; ++a)
                  F[i][j] += x[i][a] * P(gradient[j][a]);
              }
          const Symmetric<P> S =
              stress(green_strain(F), P(arg.lambda), P(arg.mu), volume, strain_energy);
          for (int i = 0; i < 3; ++i)
            {
              P T[3];
              times(F[i], S, volume, T);
              for (int a = 0; a < 8; ++a)
                f[i][a] -=
                    T[0] * P(gradient[0][a]) + T[1] * P(gradient[1][a]) + T[2] * P(gradient[2][a]);
            }
        }
      for (int i = 0; i < 3; ++i)
        for (int a = 0; a < 8; ++a)
          f[i][a].store(arg.force + (3 * element.node[a] + i) * n_lanes + lane);
    }
  strain_energy.store(arg.strain_energy + lane);
}

template <int width, Formulation formulation>
CHAINDRIVE_ALWAYS_INLINE void add_internal_forces(const ForceArguments &arg)
{
  for (int lane = 0; lane < n_lanes; lane += width)
    if constexpr (formulation == Formulation::full)
      add_full_forces<width>(arg, lane);
    else
      add_mean_forces<width, formulation>(arg, lane);
}

template <int width>
CHAINDRIVE_ALWAYS_INLINE void update(const UpdateArguments &arg)
{
  using P = Pack<double, width>;
  const P half(0.5), drag(arg.kick * arg.drag);
  for (int lane = 0; lane < n_lanes; lane += width)
    {
      P energy = P::load(arg.kinetic_energy + lane), moment[3], momentum[3];
      for (int i = 0; i < 3; ++i)
        {
          moment[i]   = P::load(arg.first_moment + i * n_lanes + lane);
          momentum[i] = P::load(arg.momentum + i * n_lanes + lane);
        }
      for (unsigned int node = 0; node < arg.n_nodes; ++node)
        {
          const P mass(arg.mass[node]), factor(arg.kick / arg.mass[node]);
          P       square(0.);
          for (int i = 0; i < 3; ++i)
            {
              const unsigned int at = (3 * node + i) * n_lanes + lane;
              const P before = P::load(arg.velocity + at), x = P::load(arg.position + at);
              const P velocity = before + factor * P::load(arg.force + at) +
                                 P(arg.kick * arg.gravity[i]) - drag * before;
              const P mean = half * (before + velocity);
              square += mean * mean;
              moment[i] += mass * x;
              momentum[i] += mass * mean;
              velocity.store(arg.velocity + at);
              (x + P(arg.drift) * velocity).store(arg.position + at);
              P(0.).store(arg.force + at);
            }
          energy += P(0.5 * arg.mass[node]) * square;
        }
      energy.store(arg.kinetic_energy + lane);
      for (int i = 0; i < 3; ++i)
        {
          moment[i].store(arg.first_moment + i * n_lanes + lane);
          momentum[i].store(arg.momentum + i * n_lanes + lane);
        }
    }
}
} // namespace chaindrive::element::bodies
