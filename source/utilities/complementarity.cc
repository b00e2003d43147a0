// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/utilities/complementarity.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/simd.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace chaindrive
{
// Each is made in a file of its own, see there.
extern const ComplementarityKernels scalar_complementarity_kernels,
    baseline_complementarity_kernels, avx2_complementarity_kernels, avx512_complementarity_kernels;

const ComplementarityKernels *complementarity_kernels(const int width)
{
  return of_width<ComplementarityKernels>(width,
                                          {&scalar_complementarity_kernels,
                                           &baseline_complementarity_kernels,
#ifdef __x86_64__
                                           &avx2_complementarity_kernels,
                                           &avx512_complementarity_kernels
#endif
                                          });
}

namespace
{
constexpr unsigned int n_tries = 10; ///< of all at once, without fewer of them on the wrong side

/// The unknowns @p wrong change sides; or only the last of them, then it returns true.
bool change_sides(const std::vector<unsigned int> &wrong,
                  unsigned int                    &fewest,
                  unsigned int                    &tries,
                  std::vector<char>               &closed)
{
  const auto change = [&closed](const unsigned int i) { closed[i] = closed[i] != 0 ? 0 : 1; };
  if (wrong.size() < fewest)
    {
      fewest = static_cast<unsigned int>(wrong.size());
      tries  = n_tries;
    }
  else if (tries > 0)
    --tries;
  else
    {
      change(wrong.back());
      return true;
    }
  std::for_each(wrong.begin(), wrong.end(), change);
  return false;
}

/// The numbers of what is @p closed.
void list(const std::vector<char> &closed, ClosedSet &set)
{
  set.clear();
  for (unsigned int i = 0; i < closed.size(); ++i)
    if (closed[i] != 0)
      set.number.push_back(i);
  set.pressure.resize(set.number.size());
}
} // namespace

ComplementaritySolver::ComplementaritySolver(const int width)
    : kernels_(complementarity_kernels(width))
{
}

void ComplementaritySolver::forget() { has_factors_ = false; }

void ComplementaritySolver::factor(const std::array<ComplementarityProblem, n_lanes> &problems,
                                   const std::array<ClosedSet, n_lanes>              &sets)
{
  n_rows_ = 0;
  for (const ClosedSet &set : sets)
    n_rows_ = std::max(n_rows_, static_cast<unsigned int>(set.number.size()));
  if (triangle_row(n_rows_) * n_lanes > matrix_.size())
    matrix_.resize(triangle_row(n_rows_) * n_lanes);
  for (unsigned int lane = 0; lane < n_lanes; ++lane)
    {
      // of a set that is the same, rows of a longer one in another lane may be missing
      const bool         same = has_factors_ && sets[lane].number == factored_[lane];
      const unsigned int from = same ? n_filled_[lane] : 0;
      factored_[lane]         = sets[lane].number;
      n_filled_[lane]         = std::max(from, n_rows_);

      const ComplementarityProblem    &problem = problems[lane];
      const std::vector<unsigned int> &set     = factored_[lane];
      if (problem.rows != nullptr)
        for (const unsigned int row : set)
          problem.rows->need(row);
      double *to = matrix_.begin() + triangle_row(from) * n_lanes + lane;
      for (unsigned int i = from; i < n_rows_; ++i)
        {
          const double *row =
              i < set.size() ? problem.matrix + std::size_t(set[i]) * problem.stride : nullptr;
          for (unsigned int j = 0; j <= i; ++j, to += n_lanes)
            *to = row != nullptr ? row[set[j]] : i == j ? 1. : 0.;
        }
    }
  factor_.resize_fast(triangle_row(n_rows_) * n_lanes);
  std::copy_n(matrix_.begin(), factor_.size(), factor_.begin());
  kernels_->factor(n_rows_, factor_.begin());
  for (unsigned int i = 0; i < n_rows_; ++i)
    for (unsigned int lane = 0; lane < n_lanes; ++lane)
      if (!std::isfinite(factor_[(triangle_row(i) + i) * n_lanes + lane]))
        {
          has_factors_ = false;
          throw RunError("A flexibility of surfaces in contact is not positive definite.");
        }
  has_factors_ = true;
  ++statistics_.factorisations;
}

void ComplementaritySolver::find_wrong(const ComplementarityProblem &problem,
                                       const double                  tolerance,
                                       const ClosedSet              &set,
                                       Search                       &search)
{
  gap_.resize_fast(problem.stride);
  std::copy_n(problem.gap, problem.n, gap_.begin());
  std::fill(gap_.begin() + problem.n, gap_.end(), 0.);
  kernels_->add_rows(problem.stride,
                     problem.matrix,
                     static_cast<unsigned int>(set.number.size()),
                     set.number.data(),
                     set.pressure.data(),
                     gap_.begin());
  for (unsigned int a = 0; a < set.number.size(); ++a)
    gap_[set.number[a]] = set.pressure[a] < 0. ? -std::numeric_limits<double>::max() : 0.;
  search.wrong.clear();
  for (unsigned int i = 0; i < problem.n; ++i)
    if (gap_[i] < -tolerance)
      search.wrong.push_back(i);
}

void ComplementaritySolver::solve(const std::array<ComplementarityProblem, n_lanes> &problems,
                                  const double                                       tolerance,
                                  std::array<ClosedSet, n_lanes>                    &sets)
{
  for (unsigned int lane = 0; lane < n_lanes; ++lane)
    {
      const ComplementarityProblem &problem = problems[lane];
      Search                       &search  = searches_[lane];
      search.is_done                        = problem.n == 0;
      if (search.is_done)
        {
          sets[lane].clear();
          continue;
        }
      ++statistics_.problems;
      std::vector<unsigned int> &number = sets[lane].number;
      while (!number.empty() && number.back() >= problem.n)
        number.pop_back();
      if (number.empty())
        for (unsigned int i = 0; i < problem.n; ++i)
          if (problem.gap[i] < -tolerance)
            number.push_back(i);
      sets[lane].pressure.resize(number.size());
      search.closed.clear();
      search.fewest = problem.n + 1;
      search.tries  = n_tries;
      if (!problem.same)
        factored_[lane] = {std::numeric_limits<unsigned int>::max()}; // no set
    }

  for (unsigned long iteration = 1;; ++iteration)
    {
      bool all_done = true, same = has_factors_;
      for (unsigned int lane = 0; lane < n_lanes; ++lane)
        if (!searches_[lane].is_done)
          {
            all_done = false;
            same     = same && (sets[lane].number.empty() || sets[lane].number == factored_[lane]);
          }
      if (all_done)
        return;
      if (!same)
        factor(problems, sets);
      x_.resize_fast(std::size_t(n_rows_) * n_lanes);
      x_.fill(0.);
      for (unsigned int lane = 0; lane < n_lanes; ++lane)
        if (!searches_[lane].is_done)
          for (unsigned int a = 0; a < sets[lane].number.size(); ++a)
            x_[std::size_t(a) * n_lanes + lane] = -problems[lane].gap[sets[lane].number[a]];
      kernels_->solve(n_rows_, factor_.begin(), x_.begin());
      for (unsigned int lane = 0; lane < n_lanes; ++lane)
        {
          Search &search = searches_[lane];
          if (search.is_done)
            continue;
          ClosedSet &set = sets[lane];
          for (unsigned int a = 0; a < set.number.size(); ++a)
            set.pressure[a] = x_[std::size_t(a) * n_lanes + lane];
          ++statistics_.solutions;
          statistics_.most_solutions = std::max(statistics_.most_solutions, iteration);
          find_wrong(problems[lane], tolerance, set, search);
          search.is_done = search.wrong.empty();
          if (search.is_done)
            continue;
          if (search.closed.empty())
            {
              search.closed.assign(problems[lane].n, 0);
              for (const unsigned int i : set.number)
                search.closed[i] = 1;
            }
          if (change_sides(search.wrong, search.fewest, search.tries, search.closed))
            ++statistics_.singly;
          list(search.closed, set);
        }
    }
}
} // namespace chaindrive
