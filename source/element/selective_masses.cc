// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/element/selective_masses.h>

#include <cmath>
#include <utility>

namespace chaindrive::element
{
SelectiveMasses::SelectiveMasses(std::vector<double> mass) : mass_(std::move(mass))
{
  for (const double m : mass_)
    scale_.push_back(1. / std::sqrt(m));
}

SelectiveMasses::SelectiveMasses(const mesh::Nodes                            &nodes,
                                 const std::vector<std::vector<unsigned int>> &columns,
                                 const double                                  factor)
    : SelectiveMasses(nodes.mass)
{
  begin_.push_back(0);
  for (const std::vector<unsigned int> &column : columns)
    {
      double mass = 0., length = 0.;
      for (std::size_t i = 0; i < column.size(); ++i)
        {
          mass += mass_[column[i]];
          length += i == 0 ? 0. : nodes.position[column[i]].distance(nodes.position[column[i - 1]]);
        }
      double before = 0.; // off the diagonal of M'
      for (std::size_t i = 0; i < column.size(); ++i)
        {
          const bool   last = i + 1 == column.size();
          const double after =
              last ? 0. :
                     factor * mass *
                         nodes.position[column[i + 1]].distance(nodes.position[column[i]]) / length;
          lower_.push_back(i == 0 ? 0. : -before * pivot_.back()); // pivot of the row before
          const double pivot = mass_[column[i]] + before + after + lower_.back() * before;
          node_.push_back(column[i]);
          added_.push_back(after);
          pivot_.push_back(1. / pivot);
          scale_[column[i]] = 1. / std::sqrt(pivot);
          before            = after;
        }
      begin_.push_back(static_cast<unsigned int>(node_.size()));
    }
}

void SelectiveMasses::apply(const Kernels &kernels,
                            const double   kick,
                            const double   drag,
                            const double  *velocity,
                            double        *force,
                            double        *kinetic_energy) const
{
  kernels.apply_selective_masses({static_cast<unsigned int>(begin_.size()) - 1,
                                  begin_.data(),
                                  node_.data(),
                                  mass_.data(),
                                  added_.data(),
                                  lower_.data(),
                                  pivot_.data(),
                                  kick,
                                  drag,
                                  velocity,
                                  force,
                                  kinetic_energy});
}

void SelectiveMasses::solve_lower(dealii::Vector<double> &x) const
{
  for (std::size_t c = 0; c + 1 < begin_.size(); ++c)
    for (unsigned int i = begin_[c] + 1; i < begin_[c + 1]; ++i)
      for (unsigned int d = 0; d < 3; ++d)
        x[3 * node_[i] + d] -= lower_[i] * x[3 * node_[i - 1] + d];
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] *= scale_[i / 3];
}

void SelectiveMasses::solve_upper(dealii::Vector<double> &x) const
{
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] *= scale_[i / 3];
  for (std::size_t c = 0; c + 1 < begin_.size(); ++c)
    for (unsigned int i = begin_[c + 1] - 1; i > begin_[c]; --i)
      for (unsigned int d = 0; d < 3; ++d)
        x[3 * node_[i - 1] + d] -= lower_[i] * x[3 * node_[i] + d];
}

double SelectiveMasses::added(const dealii::Vector<double> &a) const
{
  double sum = 0.;
  for (std::size_t c = 0; c + 1 < begin_.size(); ++c)
    for (unsigned int i = begin_[c]; i + 1 < begin_[c + 1]; ++i)
      for (unsigned int d = 0; d < 3; ++d)
        {
          const double difference = a[3 * node_[i + 1] + d] - a[3 * node_[i] + d];
          sum += added_[i] * difference * difference;
        }
  return sum;
}

std::size_t SelectiveMasses::memory_consumption() const
{
  return (mass_.size() + added_.size() + lower_.size() + pivot_.size()) * sizeof(double) +
         (begin_.size() + node_.size()) * sizeof(unsigned int);
}
} // namespace chaindrive::element
