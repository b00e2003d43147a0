// SPDX-License-Identifier: LGPL-2.1-or-later
// The solver of linear complementarity problems: Hertz' contact of a line in a half-plane; random
// problems, well and ill conditioned, also degenerate ones, against Lemke's method, which is
// another one; the search ends for a hundred thousand of them; where it begins changes nothing;
// eight in the lanes and one alone, and all widths of the kernels agree; factors are made only
// where sets change.
#include <chaindrive/utilities/complementarity.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/simd.h>

#include <deal.II/base/numbers.h>
#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <limits>
#include <optional>
#include <random>

using namespace chaindrive;
using dealii::numbers::PI;

namespace
{
const char *yes(const bool good) { return good ? "yes" : "NO"; }

/// A problem with its numbers.
struct Problem
{
  unsigned int                  n = 0;
  dealii::AlignedVector<double> matrix, gap;

  explicit Problem(const unsigned int size)
      : n(size)
      , matrix(std::size_t(size) * ComplementaritySolver::padded(size), 0.)
      , gap(ComplementaritySolver::padded(size), 0.)
  {
  }
  double &at(const unsigned int i, const unsigned int j)
  {
    return matrix[std::size_t(i) * ComplementaritySolver::padded(n) + j];
  }
  double at(const unsigned int i, const unsigned int j) const
  {
    return matrix[std::size_t(i) * ComplementaritySolver::padded(n) + j];
  }
  ComplementarityProblem view() const
  {
    return {n, matrix.begin(), ComplementaritySolver::padded(n), gap.begin(), false};
  }
};

/// Rows of a problem that are made when they are needed; before they hold nothing that could be
/// used.
struct MadeRows : LazyRows
{
  explicit MadeRows(const Problem &of) : problem(of), made(of), is_made(of.n, 0)
  {
    made.matrix.fill(std::numeric_limits<double>::quiet_NaN());
  }

  void need(const unsigned int row) override
  {
    is_made[row] = 1;
    for (unsigned int j = 0; j < ComplementaritySolver::padded(problem.n); ++j)
      made.at(row, j) = problem.at(row, j);
  }

  const Problem    &problem;
  Problem           made;
  std::vector<char> is_made;
};

std::vector<double> pressures(const ClosedSet &set, const unsigned int n)
{
  std::vector<double> p(n, 0.);
  for (unsigned int a = 0; a < set.number.size(); ++a)
    p[set.number[a]] = set.pressure[a];
  return p;
}

/// Of one problem in a lane of its own.
std::vector<double> solve(ComplementaritySolver          &solver,
                          const Problem                  &problem,
                          const double                    tolerance,
                          const std::vector<unsigned int> start = {})
{
  std::array<ComplementarityProblem, n_lanes> problems;
  std::array<ClosedSet, n_lanes>              sets;
  problems[3]    = problem.view();
  sets[3].number = start;
  solver.solve(problems, tolerance, sets);
  return pressures(sets[3], problem.n);
}

/// How far @p p is from a solution: of what should not be negative and of the product, relative to
/// the largest numbers.
double residual(const Problem &problem, const std::vector<double> &p)
{
  double largest_gap = 0., largest_p = 0., worst = 0.;
  for (unsigned int i = 0; i < problem.n; ++i)
    {
      largest_gap = std::max(largest_gap, std::abs(problem.gap[i]));
      largest_p   = std::max(largest_p, p[i]);
    }
  for (unsigned int i = 0; i < problem.n; ++i)
    {
      double gap = problem.gap[i];
      for (unsigned int j = 0; j < problem.n; ++j)
        gap += problem.at(i, j) * p[j];
      worst =
          std::max({worst, -gap / largest_gap, p[i] > 0. ? std::abs(gap) / largest_gap : -p[i]});
    }
  return worst;
}

/// p by Lemke's method (Cottle, Pang, Stone, The Linear Complementarity Problem, 4.4): a tableau of
/// w - C z - d z0 = g0, in which the complement of what has left enters.
std::optional<std::vector<double>> lemke(const Problem &problem)
{
  const unsigned int               n = problem.n, n_columns = 2 * n + 2;
  std::vector<std::vector<double>> t(n, std::vector<double>(n_columns, 0.));
  std::vector<unsigned int>        basis(n);
  for (unsigned int i = 0; i < n; ++i)
    {
      t[i][i] = 1.;
      for (unsigned int j = 0; j < n; ++j)
        t[i][n + j] = -problem.at(i, j);
      t[i][2 * n]     = -1.;
      t[i][2 * n + 1] = problem.gap[i];
      basis[i]        = i;
    }
  const auto pivot = [&](const unsigned int row, const unsigned int column) {
    const double by = t[row][column];
    for (double &x : t[row])
      x /= by;
    for (unsigned int i = 0; i < n; ++i)
      if (i != row && t[i][column] != 0.)
        {
          const double times = t[i][column];
          for (unsigned int j = 0; j < n_columns; ++j)
            t[i][j] -= times * t[row][j];
        }
    const unsigned int left = basis[row];
    basis[row]              = column;
    return left;
  };
  unsigned int row = 0;
  for (unsigned int i = 1; i < n; ++i)
    if (t[i][2 * n + 1] < t[row][2 * n + 1])
      row = i;
  if (t[row][2 * n + 1] < 0.)
    for (unsigned int left = pivot(row, 2 * n), step = 0; left != 2 * n; ++step)
      {
        if (step > 50 * n)
          return {};
        const unsigned int enters = left < n ? left + n : left - n;
        double             least  = std::numeric_limits<double>::max();
        row                       = n;
        for (unsigned int i = 0; i < n; ++i)
          if (t[i][enters] > 1e-11)
            {
              const double ratio = t[i][2 * n + 1] / t[i][enters];
              if (ratio < least - 1e-13 || (ratio < least + 1e-13 && basis[i] == 2 * n))
                {
                  least = ratio;
                  row   = i;
                }
            }
        if (row == n)
          return {};
        left = pivot(row, enters);
      }
  std::vector<double> p(n, 0.);
  for (unsigned int i = 0; i < n; ++i)
    if (basis[i] >= n && basis[i] < 2 * n)
      p[basis[i] - n] = t[i][2 * n + 1];
  return p;
}

/// Of @p n unknowns; the condition of the matrix grows with @p stiff, and with @p degenerate some
/// gaps just close by themselves.
Problem random_problem(std::mt19937      &random,
                       const unsigned int n,
                       const double       stiff,
                       const bool         degenerate)
{
  std::normal_distribution<double>            normal;
  std::uniform_int_distribution<unsigned int> pick(0, 2);
  Problem                                     problem(n);
  dealii::FullMatrix<double>                  b(n, n);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      b(i, j) = normal(random) * std::pow(10., -stiff * j / n);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      {
        for (unsigned int k = 0; k < n; ++k)
          problem.at(i, j) += b(i, k) * b(j, k);
        if (i == j)
          problem.at(i, j) += 1e-6;
      }
  if (!degenerate)
    for (unsigned int i = 0; i < n; ++i)
      problem.gap[i] = normal(random);
  else
    {
      std::vector<double> p(n, 0.);
      for (unsigned int i = 0; i < n; ++i)
        {
          const unsigned int kind = pick(random);
          p[i]                    = kind == 0 ? 1. : 0.;
          problem.gap[i]          = kind == 1 ? 1. : 0.; // else neither force nor gap
        }
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          problem.gap[i] -= problem.at(i, j) * p[j];
    }
  return problem;
}

/// A cylinder pressed into a half-plane by a given approach: strips of equal width, whose mutual
/// displacements are Flamant's but for a constant (Johnson, Contact Mechanics, 2.3). The width of
/// the contact and the force determine each other by Hertz' theory.
void hertz(ComplementaritySolver &solver)
{
  const double       modulus = 1e11, radius = 5e-3, width = 4e-6;
  const unsigned int n = 201;
  Problem            problem(n);
  const auto         part = [](const double x) { return x == 0. ? 0. : x * std::log(std::abs(x)); };
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      {
        const double d   = width * (double(i) - double(j));
        problem.at(i, j) = // against a datum at 50 mm
            -2. / (PI * modulus) *
            (part(d + 0.5 * width) - part(d - 0.5 * width) - width * (1. + std::log(0.05)));
      }
  for (const double approach : {2e-6, 5e-6})
    {
      for (unsigned int i = 0; i < n; ++i)
        problem.gap[i] = std::pow(width * (i - 0.5 * (n - 1)), 2) / (2. * radius) - approach;
      const std::vector<double> p     = solve(solver, problem, 1e-15);
      double                    force = 0.;
      unsigned int              touch = 0;
      for (const double x : p)
        {
          force += width * x;
          touch += x > 0. ? 1 : 0;
        }
      const double half = 2. * std::sqrt(force * radius / (PI * modulus)),
                   peak = 2. * force / (PI * half);
      std::cout << "Hertz: peak pressure to 1 percent "
                << yes(std::abs(p[n / 2] / peak - 1.) < 0.01) << ", half width to a strip "
                << yes(std::abs(0.5 * touch * width - half) < width) << ", "
                << (touch < n ? "open at the ends" : "all closed") << '\n';
    }
}
} // namespace

int main()
{
  ComplementaritySolver solver(simd_width());
  hertz(solver);

  std::mt19937 random(1);
  double       worst = 0., difference = 0.;
  unsigned int compared = 0;
  for (unsigned int k = 0; k < 4000; ++k)
    {
      const Problem problem = random_problem(random, 1 + k % 12, k % 3, k % 2 == 1);
      const auto    p       = solve(solver, problem, 1e-11);
      worst                 = std::max(worst, residual(problem, p));
      if (k % 2 == 1 || k % 3 == 2)
        continue;
      const auto other = lemke(problem);
      if (!other)
        continue;
      ++compared;
      for (unsigned int i = 0; i < problem.n; ++i)
        difference =
            std::max(difference, std::abs(p[i] - (*other)[i]) / (1. + std::abs((*other)[i])));
    }
  std::cout << "random problems: solved to 1e-9 " << yes(worst < 1e-9) << ", compared with Lemke's "
            << (compared > 1300 ? "method" : "NOTHING") << ", the same to 1e-6 "
            << yes(difference < 1e-6) << '\n';

  // eight at a time, many
  worst = 0.;
  for (unsigned int k = 0; k < 100000 / n_lanes; ++k)
    {
      std::vector<Problem>                        all;
      std::array<ComplementarityProblem, n_lanes> problems;
      std::array<ClosedSet, n_lanes>              sets;
      for (unsigned int lane = 0; lane < n_lanes; ++lane)
        all.push_back(random_problem(random, 2 + (k + lane) % 19, lane % 3, lane % 4 == 3));
      for (unsigned int lane = 0; lane < n_lanes; ++lane)
        problems[lane] = all[lane].view();
      solver.solve(problems, 1e-11, sets);
      for (unsigned int lane = 0; lane < n_lanes; ++lane)
        worst = std::max(worst, residual(all[lane], pressures(sets[lane], all[lane].n)));
    }
  const auto &count = solver.statistics();
  std::cout << "a hundred thousand problems: all end, solved to 1e-9 " << yes(worst < 1e-9)
            << ", systems for one on the average below 4 "
            << yes(count.solutions < 4 * count.problems) << ", Murty's rule was needed "
            << yes(count.singly > 0) << '\n';

  // starts, lanes, widths
  bool   same  = true;
  double lanes = 0., widths = 0.;
  for (unsigned int k = 0; k < 300; ++k)
    {
      const unsigned int        n       = 5 + k % 20;
      const Problem             problem = random_problem(random, n, 1., false);
      const std::vector<double> cold    = solve(solver, problem, 1e-11);
      for (unsigned int start = 0; start < 4; ++start)
        {
          std::vector<unsigned int> set;
          for (unsigned int i = 0; i < n; ++i)
            if (start == 0 || random() % 2 == 0)
              set.push_back(i);
          same = same && solve(solver, problem, 1e-11, set) == cold;
        }
      std::vector<Problem>                        all(n_lanes, problem);
      std::array<ComplementarityProblem, n_lanes> problems;
      std::array<ClosedSet, n_lanes>              sets;
      for (unsigned int lane = 0; lane < n_lanes; ++lane)
        {
          if (lane != 5)
            all[lane] = random_problem(random, 3 * lane + 1, 1., false);
          problems[lane] = all[lane].view();
        }
      solver.solve(problems, 1e-11, sets);
      const auto packed = pressures(sets[5], n);
      for (unsigned int i = 0; i < n; ++i)
        lanes = std::max(lanes, std::abs(packed[i] - cold[i]) / (1. + cold[i]));
      for (const int width : {1, 2, 4, 8})
        if (has_simd_width(width))
          {
            ComplementaritySolver other(width);
            const auto            p = solve(other, problem, 1e-11);
            for (unsigned int i = 0; i < n; ++i)
              widths = std::max(widths, std::abs(p[i] - cold[i]) / (1. + cold[i]));
          }
    }
  std::cout << "any start gives the same numbers: " << yes(same)
            << ", alone and beside others to 1e-9: " << yes(lanes < 1e-9)
            << ", all widths to 1e-9: " << yes(widths < 1e-9) << '\n';

  // rows that are made when they are needed
  bool         alike = true;
  unsigned int rows = 0, made = 0;
  for (unsigned int k = 0; k < 300; ++k)
    {
      const Problem problem = random_problem(random, 5 + k % 20, 1., false);
      MadeRows      lazy(problem);
      std::array<ComplementarityProblem, n_lanes> problems;
      std::array<ClosedSet, n_lanes>              sets;
      problems[3]      = lazy.made.view();
      problems[3].rows = &lazy;
      solver.solve(problems, 1e-11, sets);
      alike = alike && pressures(sets[3], problem.n) == solve(solver, problem, 1e-11);
      rows += problem.n;
      made += static_cast<unsigned int>(std::count(lazy.is_made.begin(), lazy.is_made.end(), 1));
    }
  std::cout << "rows made when needed: the same numbers " << yes(alike) << ", fewer of them "
            << yes(made < rows) << '\n';

  // the same set again needs no factors, another one, matrix or lane does
  {
    ComplementaritySolver                       fresh(simd_width());
    Problem                                     problem = random_problem(random, 12, 0., false);
    std::array<ComplementarityProblem, n_lanes> problems;
    std::array<ClosedSet, n_lanes>              sets;
    problems[0] = problem.view();
    fresh.solve(problems, 1e-11, sets);
    const unsigned long before = fresh.statistics().factorisations;
    problems[0].same           = true;
    for (unsigned int i = 0; i < problem.n; ++i)
      problem.gap[i] *= 1.1;
    fresh.solve(problems, 1e-11, sets);
    const auto warm = pressures(sets[0], problem.n);
    std::cout << "factors kept: " << yes(fresh.statistics().factorisations == before);
    ComplementaritySolver cold(simd_width());
    std::cout << ", the same as without " << yes(solve(cold, problem, 1e-11) == warm);
    for (unsigned int i = 0; i < problem.n; ++i)
      problem.at(i, i) *= 2.;
    problems[0].same = false;
    fresh.solve(problems, 1e-11, sets);
    std::cout << ", not of another matrix "
              << yes(residual(problem, pressures(sets[0], problem.n)) < 1e-12 &&
                     fresh.statistics().factorisations > before)
              << '\n';
    for (unsigned int i = 0; i < problem.n; ++i)
      for (unsigned int j = 0; j < problem.n; ++j)
        problem.at(i, j) = i == j ? -1. : 0.;
    try
      {
        problem.gap[0] = -1.;
        fresh.solve(problems, 1e-11, sets);
        std::cout << "NOT REFUSED\n";
      }
    catch (const RunError &error)
      {
        std::cout << error.what() << '\n';
      }
  }
}
