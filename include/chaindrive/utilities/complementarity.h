// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/utilities/complementarity_kernels.h>
#include <chaindrive/utilities/pack.h>

#include <deal.II/base/aligned_vector.h>

#include <array>
#include <vector>

namespace chaindrive
{
/// A matrix whose rows are made when a search first needs them: those of unknowns that close.
class LazyRows
{
public:
  virtual ~LazyRows() = default;

  /// Makes @p row, unless it is there.
  virtual void need(unsigned int row) = 0;
};

/// A linear complementarity problem: p >= 0, g = g0 + C p >= 0, p . g = 0. With gaps and the
/// flexibility of what touches it is contact without friction: p are the forces, at most one of
/// force and gap is not zero, and p C p / 2 is the least energy that keeps all gaps open or closed.
struct ComplementarityProblem
{
  unsigned int  n      = 0; ///< unknowns; none: there is no problem
  const double *matrix = nullptr;
  unsigned int  stride = 0;       ///< numbers in a row of the matrix, see padded()
  const double *gap    = nullptr; ///< g0, stride numbers
  bool          same   = false;   ///< the matrix is the same as at the last solution
  LazyRows     *rows   = nullptr; ///< who makes rows of the matrix; null: all are there
};

/// The unknowns whose p is not zero: solved for, and kept for the next problem, which begins with
/// them. Of a positive definite C there is exactly one solution, which does not depend on where the
/// search began.
struct ClosedSet
{
  std::vector<unsigned int> number;   ///< ascending
  std::vector<double>       pressure; ///< p of each

  void clear()
  {
    number.clear();
    pressure.clear();
  }
};

/// Solves up to n_lanes problems with symmetric positive definite matrices at a time, by block
/// principal pivoting (Judice and Pires, Computers & Operations Research 21 (1994) 587-596): all
/// unknowns whose p or g is negative change sides at once; if their number has not fallen for some
/// tries, only the last one of them does, Murty's rule, which always ends. Matrices of the sets
/// that close are factored side by side in the lanes, and not again while neither set nor matrix
/// change.
class ComplementaritySolver
{
public:
  /// @p width as that of complementarity_kernels().
  explicit ComplementaritySolver(int width);

  /// Rows of @p n numbers are this long in memory, where they are aligned to 64 bytes and filled up
  /// with zeros; gaps too, with anything.
  static unsigned int padded(const unsigned int n) { return n_batches_of(n) * n_lanes; }

  /// Makes @p sets the solutions of @p problems. Gaps down to -@p tolerance count as closed. Throws
  /// RunError if a matrix is not positive definite.
  void solve(const std::array<ComplementarityProblem, n_lanes> &problems,
             double                                             tolerance,
             std::array<ClosedSet, n_lanes>                    &sets);

  /// Factors are made anew.
  void forget();

  /// Counted over all problems.
  struct Statistics
  {
    unsigned long problems       = 0;
    unsigned long solutions      = 0; ///< of systems
    unsigned long factorisations = 0; ///< of all lanes at once
    unsigned long most_solutions = 0; ///< for one problem
    unsigned long singly         = 0; ///< times that only one unknown changed sides
  };
  const Statistics &statistics() const { return statistics_; }

private:
  using Numbers = dealii::AlignedVector<double>;

  /// Of one lane.
  struct Search
  {
    std::vector<char>         closed;      ///< once something has been wrong
    std::vector<unsigned int> wrong;       ///< unknowns with a negative p or g
    unsigned int              fewest  = 0; ///< that were wrong at a time
    unsigned int              tries   = 0; ///< left to all at once
    bool                      is_done = true;
  };

  void factor(const std::array<ComplementarityProblem, n_lanes> &problems,
              const std::array<ClosedSet, n_lanes>              &sets);

  /// Unknowns of the lane's problem that are on the wrong side.
  void find_wrong(const ComplementarityProblem &problem,
                  double                        tolerance,
                  const ClosedSet              &set,
                  Search                       &search);

  const ComplementarityKernels                  *kernels_;
  std::array<Search, n_lanes>                    searches_;
  std::array<std::vector<unsigned int>, n_lanes> factored_;        ///< the sets
  std::array<unsigned int, n_lanes>              n_filled_{};      ///< rows of matrix_
  unsigned int                                   n_rows_      = 0; ///< of the factors
  bool                                           has_factors_ = false;
  Numbers                                        matrix_, factor_, x_, gap_; ///< C of the sets, ...
  Statistics                                     statistics_;
};
} // namespace chaindrive
