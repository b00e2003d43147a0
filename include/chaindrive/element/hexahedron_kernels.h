// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Forces of trilinear hexahedra and the step of their nodes, for P::width copies at a time. A
// number of an element is the same for all copies; what varies from copy to copy is a pack.
//
// An element is the amplitudes x_m = h_m . x of seven base vectors of its eight vertices
// (shapes.h), not the vertices: sums and differences find them, and most numbers of regular
// elements vanish. The numbers (kernels.h) are G, the mean gradient in terms of base vectors; H_aj
// = h_a . X_j, what of the hourglass vectors is linear; and K, the hourglass stiffness. Components
// of positions are i, axes of the element j and k, hourglass modes a, and W is the energy
// (doc/theory.md, section 3).
//
// Mean gradient, add_mean_forces(), Formulation::one_point and enhanced:
//
//   x_im  = h_m . x_i                    amplitudes of positions                gather_amplitudes()
//   F_ij  = sum_m G_jm x_im                 deformation gradient, mean over the element
//   q_ia  = x_ia - sum_j H_aj F_ij          hourglass amplitudes gamma_a . x_i: as
//                                           gamma_a = h_a - sum_j H_aj B_j and F_ij = B_j . x_i
//   E     = (F^T F - 1) / 2,  S = lambda tr(E) 1 + 2 mu E                              stress()
//   one point: dW/dq_ia = K q_ia,  dW/dF = V F S
//   enhanced:  p_ak = sum_i F_ik q_ia       amplitudes turned back into the element's axes
//              s = K p                      12 of them, in the blocks of shapes.h
//              dW/dq_ia = sum_k F_ik s_ak,  dW/dF_ik = (V F S)_ik + sum_a q_ia s_ak
//   solid-shell: as enhanced with the mean strain E + D p in the place of E: what amplitudes strain
//              where a solid-shell's strains are sampled; then s = K p + V D^T S
//   then back by the transposes of all that led here, T = dW/dF and r = dW/dx_m:
//   T_ij -= sum_a H_aj dW/dq_ia             q depends on F
//   r_im  = sum_j G_jm T_ij  (+ dW/dq_ia where m is an hourglass mode a)
//   f_i  -= sum_m h_m r_im                                                     scatter_amplitudes()
//
// Eight points, add_full_forces(): derivatives of x along the axes of the unit cell at the points
// from the amplitudes, F with the inverse Jacobian of each point, its stress, and the same way
// back.

#include <chaindrive/element/kernels.h>

namespace chaindrive::element::packed
{
/// A symmetric tensor: xx, yy, zz, xy, yz, zx.
template <typename P>
struct Symmetric
{
  P xx, yy, zz, xy, yz, zx;
};

/// Twice Green's strain, F^T F - 1.
template <typename P>
CHAINDRIVE_ALWAYS_INLINE Symmetric<P> twice_green_strain(const P (&F)[3][3])
{
  const P one(1.);
  return {F[0][0] * F[0][0] - one + F[1][0] * F[1][0] + F[2][0] * F[2][0],
          F[0][1] * F[0][1] - one + F[1][1] * F[1][1] + F[2][1] * F[2][1],
          F[0][2] * F[0][2] - one + F[1][2] * F[1][2] + F[2][2] * F[2][2],
          F[0][0] * F[0][1] + F[1][0] * F[1][1] + F[2][0] * F[2][1],
          F[0][1] * F[0][2] + F[1][1] * F[1][2] + F[2][1] * F[2][2],
          F[0][2] * F[0][0] + F[1][2] * F[1][0] + F[2][2] * F[2][0]};
}

/// Volume times the second Piola-Kirchhoff stress S = lambda tr(E) 1 + 2 mu E of St. Venant and
/// Kirchhoff, from C = 2 E; adds the energy S : E / 2 times the volume, times 4, to @p energy.
template <typename P>
CHAINDRIVE_ALWAYS_INLINE Symmetric<P>
stress(const Symmetric<P> &C, const double lambda, const double mu, const double volume, P &energy)
{
  const P            mu_V(mu * volume);
  const P            pressure = P(0.5 * lambda * volume) * (C.xx + C.yy + C.zz);
  const P            xy = mu_V * C.xy, yz = mu_V * C.yz, zx = mu_V * C.zx;
  const Symmetric<P> S{
      pressure + mu_V * C.xx, pressure + mu_V * C.yy, pressure + mu_V * C.zz, xy, yz, zx};
  energy += S.xx * C.xx + S.yy * C.yy + S.zz * C.zz;
  energy += (xy + xy) * C.xy + (yz + yz) * C.yz + (zx + zx) * C.zx;
  return S;
}

/// Row i of F S.
template <typename P>
CHAINDRIVE_ALWAYS_INLINE void times(const P (&F)[3], const Symmetric<P> &S, P (&T)[3])
{
  T[0] = F[0] * S.xx + F[1] * S.xy + F[2] * S.zx;
  T[1] = F[0] * S.xy + F[1] * S.yy + F[2] * S.yz;
  T[2] = F[0] * S.zx + F[1] * S.yz + F[2] * S.zz;
}

/// The amplitudes of the base vectors of eight numbers.
template <typename P>
CHAINDRIVE_ALWAYS_INLINE void to_amplitudes(const P (&x)[8], P (&amplitude)[n_base_vectors])
{
  // differences and sums along x, at y and z
  const P d0 = x[1] - x[0], d1 = x[3] - x[2], d2 = x[5] - x[4], d3 = x[7] - x[6];
  const P s0 = x[1] + x[0], s1 = x[3] + x[2], s2 = x[5] + x[4], s3 = x[7] + x[6];
  // then along y, at z
  const P dd0 = d1 - d0, dd1 = d3 - d2, ds0 = d1 + d0, ds1 = d3 + d2;
  const P sd0 = s1 - s0, sd1 = s3 - s2, ss0 = s1 + s0, ss1 = s3 + s2;
  amplitude[base_x]   = ds1 + ds0;
  amplitude[base_y]   = sd1 + sd0;
  amplitude[base_z]   = ss1 - ss0;
  amplitude[base_xy]  = dd1 + dd0;
  amplitude[base_yz]  = sd1 - sd0;
  amplitude[base_zx]  = ds1 - ds0;
  amplitude[base_xyz] = dd1 - dd0;
}

/// Subtracts sum_m h_m r_m from eight numbers, the transpose of to_amplitudes().
template <typename P>
CHAINDRIVE_ALWAYS_INLINE void subtract_amplitudes(const P (&r)[n_base_vectors], P (&x)[8])
{
  // what differs along x and what does not, at z = -1 and 1
  const P ds0 = r[base_x] - r[base_zx], ds1 = r[base_x] + r[base_zx];
  const P dd0 = r[base_xy] - r[base_xyz], dd1 = r[base_xy] + r[base_xyz];
  const P sd0 = r[base_y] - r[base_yz], sd1 = r[base_y] + r[base_yz];
  // at y and z
  const P d0 = ds0 - dd0, d1 = ds0 + dd0, d2 = ds1 - dd1, d3 = ds1 + dd1;
  const P s0 = sd0 + r[base_z], s1 = sd0 - r[base_z], s2 = sd1 - r[base_z], s3 = sd1 + r[base_z];
  x[0] += s0 + d0;
  x[1] += s0 - d0;
  x[2] -= s1 - d1;
  x[3] -= s1 + d1;
  x[4] += s2 + d2;
  x[5] += s2 - d2;
  x[6] -= s3 - d3;
  x[7] -= s3 + d3;
}

/// The amplitudes of component @p i of an element's positions.
template <typename P>
CHAINDRIVE_ALWAYS_INLINE void gather_amplitudes(const Vertices &vertices,
                                                const int       i,
                                                const double   *from,
                                                P (&amplitude)[n_base_vectors])
{
  P x[8];
  for (int a = 0; a < 8; ++a)
    x[a] = P::load(from + (3 * vertices.node[a] + i) * n_lanes);
  to_amplitudes(x, amplitude);
}

/// Subtracts what has the amplitudes @p r from component @p i of the forces of an element.
template <typename P>
CHAINDRIVE_ALWAYS_INLINE void
scatter_amplitudes(const P (&r)[n_base_vectors], const Vertices &vertices, const int i, double *to)
{
  P f[8];
  for (int a = 0; a < 8; ++a)
    f[a] = P::load(to + (3 * vertices.node[a] + i) * n_lanes);
  subtract_amplitudes(r, f);
  for (int a = 0; a < 8; ++a)
    f[a].store(to + (3 * vertices.node[a] + i) * n_lanes);
}

/// Elements with one point: the mean gradient, and a stiffness of the hourglass amplitudes.
template <int width, Formulation formulation, Shape shape>
CHAINDRIVE_ALWAYS_INLINE void add_mean_forces(const ForceArguments &arg, const int lane)
{
  using P                        = Pack<double, width>;
  constexpr NonZeros gradient    = gradient_entries(shape);
  constexpr NonZeros shift       = shift_entries(shape);
  constexpr NonZeros stiffness   = hourglass_entries(shape);
  constexpr NonZeros coupling    = coupling_entries(shape);
  constexpr bool     pulls       = formulation != Formulation::one_point;
  constexpr bool     solid_shell = formulation == Formulation::solid_shell;
  P                  strain_energy_4(0.), hourglass_energy_2(0.); // times four, times two
  const double      *position = arg.position + lane;
  double            *force    = arg.force + lane;

  P amplitude[3][n_base_vectors]; // component, base vector
  for (int i = 0; i < 3; ++i)
    gather_amplitudes(arg.vertices[0], i, position, amplitude[i]);
  // while elements keep the arithmetic busy memory has time: a share of the lines with each of them
  constexpr unsigned int line    = 8;
  const unsigned int     share   = 1 + arg.n_next / (line * arg.n_elements);
  const double          *fetch   = arg.next;
  const double *const    fetched = arg.next + (lane == 0 ? arg.n_next : 0);
  for (unsigned int e = 0; e < arg.n_elements; ++e)
    {
      for (unsigned int i = 0; i < share && fetch < fetched; ++i, fetch += line)
        __builtin_prefetch(fetch, 0, 2);
      const Vertices     &next    = arg.vertices[e + 1 < arg.n_elements ? e + 1 : e];
      const double *const numbers = arg.numbers + arg.vertices[e].numbers;
      const double *const G       = numbers + 1;
      const double *const H       = G + gradient.size;
      const double *const K       = H + shift.size;

      P F[3][3] = {};
#pragma GCC unroll 78
      for (int n = 0; n < gradient.size; ++n)
        for (int i = 0; i < 3; ++i)
          F[i][gradient.row[n]] += P(G[n]) * amplitude[i][gradient.column[n]];

      P q[3][4]; // component, amplitude
      for (int i = 0; i < 3; ++i)
        for (int alpha = 0; alpha < 4; ++alpha)
          q[i][alpha] = amplitude[i][base_xy + alpha];
#pragma GCC unroll 78
      for (int n = 0; n < shift.size; ++n)
        for (int i = 0; i < 3; ++i)
          q[i][shift.row[n]] -= P(H[n]) * F[i][shift.column[n]];

      P s[12] = {}; // forces of the amplitudes in the element's axes
      P pulled[12]; // these amplitudes: F^T q is the same however the element has turned
      if constexpr (pulls)
        {
#pragma GCC unroll 78
          for (int n = 0; n < 12; ++n)
            {
              const int alpha = amplitudes[n].alpha, k = amplitudes[n].k;
              pulled[n] = F[0][k] * q[0][alpha] + F[1][k] * q[1][alpha] + F[2][k] * q[2][alpha];
            }
#pragma GCC unroll 78
          for (int n = 0; n < stiffness.size; ++n)
            {
              s[stiffness.row[n]] += P(K[n]) * pulled[stiffness.column[n]];
              if (stiffness.row[n] != stiffness.column[n])
                s[stiffness.column[n]] += P(K[n]) * pulled[stiffness.row[n]];
            }
          for (int n = 0; n < 12; ++n)
            hourglass_energy_2 += s[n] * pulled[n];
        }

      Symmetric<P> C = twice_green_strain(F);
      if constexpr (solid_shell)
        {
          P *const strain[6] = {&C.xx, &C.yy, &C.zz, &C.xy, &C.yz, &C.zx};
#pragma GCC unroll 78
          for (int n = 0; n < coupling.size; ++n)
            *strain[coupling.row[n]] += P(K[stiffness.size + n]) * pulled[coupling.column[n]];
        }
      const Symmetric<P> S = stress(C, arg.lambda, arg.mu, numbers[0], strain_energy_4);
      if constexpr (solid_shell)
        {
          const P half(0.5);
          const P along[6] = {half * S.xx, half * S.yy, half * S.zz, S.xy, S.yz, S.zx};
#pragma GCC unroll 78
          for (int n = 0; n < coupling.size; ++n)
            s[coupling.column[n]] += P(K[stiffness.size + n]) * along[coupling.row[n]];
        }

      for (int i = 0; i < 3; ++i)
        {
          // dW/dF and dW/dq
          P T[3];
          times(F[i], S, T);
          // additions for the next element, beside multiplications of this one
          gather_amplitudes(next, i, position, amplitude[i]);
          P r[n_base_vectors] = {};
          if constexpr (pulls)
            {
#pragma GCC unroll 78
              for (int n = 0; n < 12; ++n)
                {
                  r[base_xy + amplitudes[n].alpha] += F[i][amplitudes[n].k] * s[n];
                  T[amplitudes[n].k] += q[i][amplitudes[n].alpha] * s[n];
                }
            }
          else
            for (int alpha = 0; alpha < 4; ++alpha)
              {
                r[base_xy + alpha] = P(K[0]) * q[i][alpha];
                hourglass_energy_2 += r[base_xy + alpha] * q[i][alpha];
              }

              // the transposes of q and of F
#pragma GCC unroll 78
          for (int n = 0; n < shift.size; ++n)
            T[shift.column[n]] -= P(H[n]) * r[base_xy + shift.row[n]];
#pragma GCC unroll 78
          for (int n = 0; n < gradient.size; ++n)
            r[gradient.column[n]] += P(G[n]) * T[gradient.row[n]];
          scatter_amplitudes(r, arg.vertices[e], i, force);
        }
    }
  (P::load(arg.strain_energy + lane) + P(0.25) * strain_energy_4).store(arg.strain_energy + lane);
  (P::load(arg.hourglass_energy + lane) + P(0.5) * hourglass_energy_2)
      .store(arg.hourglass_energy + lane);
}

/// Elements with 2 x 2 x 2 points, at xi_d = -g or g. The derivative along an axis d of the unit
/// cell is the same at both points of a line along d, so that there are four of it: with the
/// coordinates of the line along the two axes after d, in a cycle, as the bits of its number.
constexpr int line_through(const int point, const int d)
{
  return (point >> (d + 1) % 3 & 1) | (point >> (d + 2) % 3 & 1) << 1;
}

template <int width, Shape shape>
CHAINDRIVE_ALWAYS_INLINE void add_full_forces(const ForceArguments &arg, const int lane)
{
  using P                     = Pack<double, width>;
  constexpr NonZeros jacobian = jacobian_entries(shape);
  constexpr int      n_points = shape == Shape::general ? 8 : 4; // with numbers of their own
  const P            g(0.57735026918962576451), g_squared(1. / 3.);
  P                  strain_energy_4(0.); // times four
  const double      *position = arg.position + lane;
  double            *force    = arg.force + lane;

  for (unsigned int e = 0; e < arg.n_elements; ++e)
    {
      const double *const numbers = arg.numbers + arg.vertices[e].numbers;

      P derivative[3][3][4], sum[3][3][4]; // component, axis, line
      for (int i = 0; i < 3; ++i)
        {
          P amplitude[n_base_vectors];
          gather_amplitudes(arg.vertices[e], i, position, amplitude);
          const P product = g_squared * amplitude[base_xyz];
          for (int d = 0; d < 3; ++d)
            {
              // s_d s_d1 and s_d s_d2
              const P first  = g * amplitude[base_xy + d],
                      second = g * amplitude[base_xy + (d + 2) % 3];
              const P low = amplitude[d] - second, high = amplitude[d] + second;
              derivative[i][d][0] = low - (first - product);
              derivative[i][d][1] = low + (first - product);
              derivative[i][d][2] = high - (first + product);
              derivative[i][d][3] = high + (first + product);
              for (int line = 0; line < 4; ++line)
                sum[i][d][line] = P(0.);
            }
        }

#pragma GCC unroll 8
      for (int point = 0; point < 8; ++point)
        {
          const double *const volume  = numbers + point % n_points * (1 + jacobian.size);
          const double *const inverse = volume + 1;

          P F[3][3] = {};
#pragma GCC unroll 78
          for (int n = 0; n < jacobian.size; ++n)
            for (int i = 0; i < 3; ++i)
              {
                const int d = jacobian.row[n];
                F[i][jacobian.column[n]] +=
                    P(inverse[n]) * derivative[i][d][line_through(point, d)];
              }
          const Symmetric<P> S =
              stress(twice_green_strain(F), arg.lambda, arg.mu, *volume, strain_energy_4);
          for (int i = 0; i < 3; ++i)
            {
              P T[3];
              times(F[i], S, T);
#pragma GCC unroll 78
              for (int n = 0; n < jacobian.size; ++n)
                {
                  const int d = jacobian.row[n];
                  sum[i][d][line_through(point, d)] += P(inverse[n]) * T[jacobian.column[n]];
                }
            }
        }

      for (int i = 0; i < 3; ++i)
        {
          P r[n_base_vectors] = {};
          for (int d = 0; d < 3; ++d)
            {
              const P(&line)[4] = sum[i][d];
              const P low = line[1] - line[0], high = line[3] - line[2];
              const P second = line[2] + line[3], none = line[0] + line[1];
              r[d] = none + second;
              r[base_xy + d] += low + high;
              r[base_xy + (d + 2) % 3] += second - none;
              r[base_xyz] += high - low;
            }
          for (int m = base_xy; m < base_xyz; ++m)
            r[m] = g * r[m];
          r[base_xyz] = g_squared * r[base_xyz];
          scatter_amplitudes(r, arg.vertices[e], i, force);
        }
    }
  (P::load(arg.strain_energy + lane) + P(0.25) * strain_energy_4).store(arg.strain_energy + lane);
}
template <int width, Formulation formulation, Shape shape>
CHAINDRIVE_ALWAYS_INLINE void add_forces(const ForceArguments &arg)
{
  for (int lane = 0; lane < n_lanes; lane += width)
    if constexpr (formulation == Formulation::full)
      add_full_forces<width, shape>(arg, lane);
    else
      add_mean_forces<width, formulation, shape>(arg, lane);
}

template <int width, Formulation formulation>
void add_internal_forces(const ForceArguments &arg)
{
  switch (arg.shape)
    {
    case Shape::general:
      return add_forces<width, formulation, Shape::general>(arg);
    case Shape::prism:
      return add_forces<width, formulation, Shape::prism>(arg);
    case Shape::symmetric_prism:
      return add_forces<width, formulation, Shape::symmetric_prism>(arg);
    }
}

template <int width>
void update(const UpdateArguments &arg)
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

template <int width>
void apply_selective_masses(const SelectiveMassArguments &arg)
{
  using P = Pack<double, width>;
  const P half_kick(0.5 * arg.kick), kept(1. - 0.5 * arg.kick * arg.drag);
  for (int lane = 0; lane < n_lanes; lane += width)
    {
      P energy = P::load(arg.kinetic_energy + lane);
      for (unsigned int c = 0; c < arg.n_columns; ++c)
        for (int d = 0; d < 3; ++d)
          {
            const auto place = [&](const unsigned int i) {
              return (3 * arg.node[i] + d) * n_lanes + lane;
            };
            const unsigned int first = arg.begin[c], last = arg.begin[c + 1] - 1;
            P                  y = P::load(arg.force + place(first));
            for (unsigned int i = first + 1; i <= last; ++i)
              {
                y = P::load(arg.force + place(i)) - P(arg.lower[i]) * y;
                y.store(arg.force + place(i));
              }
            P a = P(arg.pivot[last]) * y, v = P::load(arg.velocity + place(last));
            (P(arg.mass[arg.node[last]]) * a).store(arg.force + place(last));
            for (unsigned int i = last; i-- > first;)
              {
                const P before = P::load(arg.velocity + place(i));
                const P here =
                    P(arg.pivot[i]) * P::load(arg.force + place(i)) - P(arg.lower[i + 1]) * a;
                const P difference = kept * (v - before) + half_kick * (a - here);
                energy += P(0.5 * arg.added[i]) * difference * difference;
                (P(arg.mass[arg.node[i]]) * here).store(arg.force + place(i));
                a = here;
                v = before;
              }
          }
      energy.store(arg.kinetic_energy + lane);
    }
}

template <int width>
constexpr Kernels make_kernels(const char *name)
{
  return {name,
          width,
          {add_internal_forces<width, Formulation::one_point>,
           add_internal_forces<width, Formulation::enhanced>,
           add_internal_forces<width, Formulation::full>,
           add_internal_forces<width, Formulation::solid_shell>},
          update<width>,
          apply_selective_masses<width>};
}
} // namespace chaindrive::element::packed
