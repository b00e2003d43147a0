// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/closed_window.h>
#include <chaindrive/stability/closed_modes.h>
#include <chaindrive/stability/closed_windows.h>
#include <chaindrive/stability/coupled_modes.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace chaindrive::stability
{
namespace
{
using contact::ClosedWindow;
using dealii::numbers::PI;

/// What @p bodies are held by where the columns of a @p window about the direction @p i are closed,
/// 1/s2. A column counts that is nearer than half a column beyond the window's end. Of two bodies
/// that stick to each other by springs across each one feels at most twice these, with its other
/// end at rest: (u - v)^2 <= 2 u^2 + 2 v^2.
Matrix held_by(const ModalGroup &bodies, const ClosedWindow &window, const unsigned int i)
{
  std::vector<unsigned int> columns;
  for (unsigned int c = 0; c < window.n_columns; ++c)
    {
      const double apart = std::abs(std::remainder(
          2. * PI * (double(c) / window.n_columns - double(i) / n_directions), 2. * PI));
      if (apart <= window.half_angle + PI / window.n_columns)
        columns.push_back(c);
    }
  const unsigned int m = window.n_rings, n = static_cast<unsigned int>(columns.size()) * m;
  const auto         motions = static_cast<unsigned int>(bodies.motions_of(0).size());
  Matrix flexibility(n, n), rows(n, motions), held(n, motions), result(motions, motions);
  Matrix across(2 * n, motions); // by square roots of springs
  const dealii::Tensor<1, 3> axis = dealii::Point<3>(0., 0., 1.);
  for (unsigned int a = 0; a < n; ++a)
    {
      const double angle                = 2. * PI * columns[a / m] / window.n_columns,
                   root                 = std::sqrt(2. * window.across[a % m]);
      const dealii::Tensor<1, 3> normal = dealii::Point<3>(std::cos(angle), std::sin(angle), 0.),
                                 round  = cross_product_3d(axis, normal);
      const std::vector<dealii::Tensor<1, 3>> moved =
          bodies.motions_of(window.node[(a % m) * window.n_columns + columns[a / m]]);
      for (unsigned int j = 0; j < motions; ++j)
        {
          rows(a, j)           = normal * moved[j];
          across(2 * a, j)     = root * (round * moved[j]);
          across(2 * a + 1, j) = root * (axis * moved[j]);
        }
      for (unsigned int b = 0; b < n; ++b)
        flexibility(a, b) =
            window.flexibility[(std::size_t(a % m) * m + b % m) * window.n_columns +
                               (columns[b / m] + window.n_columns - columns[a / m]) %
                                   window.n_columns];
    }
  if (n > 0)
    {
      flexibility.gauss_jordan();
      flexibility.mmult(held, rows);
      rows.Tmmult(result, held);
      across.Tmmult(result, across, true);
    }
  return result;
}

/// One body of a group with all that holds it.
class HeldBody
{
public:
  explicit HeldBody(const ModalGroup &bodies) : bodies_(bodies), free_(bodies.modal_matrix({})) {}

  void add(const ClosedWindow &window)
  {
    if (!sides_.insert(window.surface).second)
      return; // it meets several kinds of bodies, alike
    ways_.emplace_back();
    const bool all = window.half_angle >= PI;
    for (unsigned int i = 0; i < (all ? 1 : n_directions); ++i)
      ways_.back().push_back(held_by(bodies_, window, i));
  }

  void add(const contact::ClosedSide &side, const ClosedKind &kind)
  {
    springs_[side.surface].update_largest(added_to_modes(bodies_, side, kind.law), 1., kind.time);
  }

  bool is_held() const { return !ways_.empty(); }

  /// The smallest limit found, s.
  double critical_time_step() const
  {
    double step = std::numeric_limits<double>::infinity();
    for (unsigned int first = 0; first < n_directions; first += n_directions / 4)
      {
        std::vector<unsigned int> chosen(ways_.size(), first);
        for (unsigned int w = 0; w < ways_.size(); ++w)
          chosen[w] = std::min<unsigned int>(first, ways_[w].size() - 1);
        double best = step_with(chosen);
        for (bool changed = true; changed;)
          {
            changed = false;
            for (unsigned int w = 0; w < ways_.size(); ++w)
              for (unsigned int i = 0; i < ways_[w].size(); ++i)
                {
                  std::vector<unsigned int> other = chosen;
                  other[w]                        = i;
                  const double of_other           = step_with(other);
                  if (of_other < best * (1. - 1e-9))
                    {
                      best    = of_other;
                      chosen  = other;
                      changed = true;
                    }
                }
          }
        step = std::min(step, best);
      }
    return step;
  }

private:
  double step_with(const std::vector<unsigned int> &chosen) const
  {
    ModalBodies modal;
    modal.free = free_;
    for (unsigned int w = 0; w < ways_.size(); ++w)
      modal.free.add(1., ways_[w][chosen[w]]);
    modal.sides = springs_;
    return modal.sides.empty() ? 2. / std::sqrt(largest(modal.free)) : modal.critical_time_step();
  }

  const ModalGroup                         &bodies_;
  Matrix                                    free_;
  std::set<unsigned int>                    sides_;
  std::vector<std::vector<Matrix>>          ways_; ///< [side][direction]
  std::map<unsigned int, ModalBodies::Side> springs_;
};
} // namespace

double closed_windows_time_step(const World                                &world,
                                const std::vector<const contact::Family *> &families)
{
  std::vector<ClosedWindow> windows;
  for (const contact::Family *family : families)
    if (const auto *exact = dynamic_cast<const contact::HasClosedWindows *>(family))
      for (const ClosedWindow &window : exact->closed_windows())
        windows.push_back(window);
  double step = std::numeric_limits<double>::infinity();
  if (windows.empty())
    return step;
  std::map<unsigned int, HeldBody> held; // by group
  for (const ModalGroup *group : world.groups.modal())
    held.emplace(group->copies(), *group);
  for (const ClosedWindow &window : windows)
    held.at(window.group).add(window);
  for (const contact::Family *family : families)
    for (const ClosedKind &kind : closed_kinds(world, *family))
      for (const contact::ClosedSide &side : kind.sides)
        if (const auto body = held.find(side.group); body != held.end())
          body->second.add(side, kind);
  for (const auto &[group, body] : held)
    if (body.is_held())
      step = std::min(step, body.critical_time_step());
  return step;
}
} // namespace chaindrive::stability
