// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/reduction/factored_stiffness.h>
#include <chaindrive/utilities/pack.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <limits>
#include <trilinos_klu_decl.h>
#include <utility>

namespace chaindrive::reduction
{
namespace
{
/// KLU's factors, which it frees with the settings that it made them with.
struct Klu
{
  trilinos_klu_common    settings{};
  trilinos_klu_symbolic *order   = nullptr;
  trilinos_klu_numeric  *factors = nullptr;

  Klu() = default;
  ~Klu()
  {
    trilinos_klu_free_numeric(&factors, &settings);
    trilinos_klu_free_symbolic(&order, &settings);
  }
  Klu(const Klu &)            = delete;
  Klu &operator=(const Klu &) = delete;
};

void check(const bool done)
{
  AssertThrow(done, dealii::ExcMessage("KLU cannot solve for displacements of a part"));
}
} // namespace

FactoredStiffness::FactoredStiffness(const dealii::SparseMatrix<double> &matrix, const int width)
    : n_(matrix.m())
    , row_(n_)
    , column_(n_)
    , room_(std::size_t(n_) * n_lanes)
    , kernels_(*substitution_kernels(width))
{
  std::vector<int>    first = {0}, number; // rows, which are columns as well
  std::vector<double> entry;
  for (unsigned int i = 0; i < n_; ++i)
    {
      for (auto at = matrix.begin(i); at != matrix.end(i); ++at)
        if (at->value() != 0.)
          {
            number.push_back(static_cast<int>(at->column()));
            entry.push_back(at->value());
          }
      first.push_back(static_cast<int>(number.size()));
    }

  Klu       klu;
  const int n = static_cast<int>(n_);
  trilinos_klu_defaults(&klu.settings);
  klu.settings.btf   = 0; // a symmetric matrix that is irreducible is one block
  klu.settings.scale = -1;
  klu.order          = trilinos_klu_analyze(n, first.data(), number.data(), &klu.settings);
  check(klu.order != nullptr);
  klu.factors =
      trilinos_klu_factor(first.data(), number.data(), entry.data(), klu.order, &klu.settings);
  check(klu.factors != nullptr && klu.settings.status == TRILINOS_KLU_OK);

  struct Factor
  {
    std::vector<int>    first, row;
    std::vector<double> entry;

    Factor(const int n, const int n_entries) : first(n + 1), row(n_entries), entry(n_entries) {}
  };
  Factor l(n, klu.factors->lnz), u(n, klu.factors->unz);
  check(trilinos_klu_extract(klu.factors,
                             klu.order,
                             l.first.data(),
                             l.row.data(),
                             l.entry.data(),
                             u.first.data(),
                             u.row.data(),
                             u.entry.data(),
                             nullptr,
                             nullptr,
                             nullptr,
                             row_.data(),
                             column_.data(),
                             nullptr,
                             nullptr,
                             &klu.settings) != 0);

  double smallest = std::numeric_limits<double>::max(),
         largest  = 0.; // pivots, all of them positive
  inverse_.resize(n_);
  for (const auto &[from, to] : {std::pair(&l, &lower_), std::pair(&u, &upper_)})
    for (int k = 0; k < n; ++k)
      {
        for (int p = from->first[k]; p < from->first[k + 1]; ++p)
          if (from->row[p] != k)
            {
              to->row.push_back(static_cast<unsigned int>(from->row[p]));
              to->entry.push_back(from->entry[p]);
            }
          else if (to == &upper_)
            {
              inverse_[k] = 1. / from->entry[p];
              smallest    = std::min(smallest, from->entry[p]);
              largest     = std::max(largest, from->entry[p]);
            }
        to->first.push_back(static_cast<unsigned int>(to->row.size()));
      }
  check(smallest > 1e-13 * largest); // of parts as stiff as thin plates it is 1e-8 of it
}

void FactoredStiffness::solve(std::vector<dealii::Vector<double>> &f)
{
  for (std::size_t begin = 0; begin < f.size(); begin += n_lanes)
    {
      const std::size_t n = std::min<std::size_t>(n_lanes, f.size() - begin);
      std::fill(room_.begin(), room_.end(), 0.);
      for (std::size_t lane = 0; lane < n; ++lane)
        for (unsigned int k = 0; k < n_; ++k)
          room_[std::size_t(k) * n_lanes + lane] = f[begin + lane][row_[k]];
      kernels_.solve(n_, lower_.view(), upper_.view(), inverse_.data(), room_.data());
      for (std::size_t lane = 0; lane < n; ++lane)
        for (unsigned int k = 0; k < n_; ++k)
          f[begin + lane][column_[k]] = room_[std::size_t(k) * n_lanes + lane];
    }
}
} // namespace chaindrive::reduction
