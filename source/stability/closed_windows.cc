// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/closed_window.h>
#include <chaindrive/stability/closed_modes.h>
#include <chaindrive/stability/closed_windows.h>
#include <chaindrive/stability/coupled_modes.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace chaindrive::stability
{
namespace
{
using contact::ClosedWindow;
using dealii::numbers::PI;

/// A window that is closed about a direction.
struct Closed
{
  const ClosedWindow *window;
  unsigned int        direction;

  /// A column counts that is nearer than half a column beyond the window's end.
  std::vector<unsigned int> columns() const
  {
    std::vector<unsigned int> found;
    for (unsigned int c = 0; c < window->n_columns; ++c)
      if (from_middle(c) <= window->half_angle + PI / window->n_columns)
        found.push_back(c);
    return found;
  }

  /// The column nearest to the direction.
  unsigned int middle() const
  {
    unsigned int nearest = 0;
    for (unsigned int c = 1; c < window->n_columns; ++c)
      if (from_middle(c) < from_middle(nearest))
        nearest = c;
    return nearest;
  }

private:
  double from_middle(const unsigned int c) const
  {
    return std::abs(std::remainder(
        2. * PI * (double(c) / window->n_columns - double(direction) / n_directions), 2. * PI));
  }
};

/// A closed node of a window.
struct ClosedNode
{
  unsigned int        closed; ///< which of those
  const ClosedWindow *window;
  unsigned int        ring, column;

  unsigned int node() const { return window->node[ring * window->n_columns + column]; }
  double       angle() const { return 2. * PI * column / window->n_columns; }

  /// What it moves away from the axis under one newton on another one, m/N.
  double flexibility(const ClosedNode &other) const
  {
    const unsigned int n = window->n_columns, apart = (other.column + n - column) % n;
    if (closed == other.closed)
      return window->flexibility[(std::size_t(ring) * window->n_rings + other.ring) * n + apart];
    if (window->through.empty())
      return other.window->through.empty() ? 0. : other.flexibility(*this);
    return window->through[(std::size_t(ring) * window->n_rings_of_through +
                            other.window->first_ring + other.ring) *
                               n +
                           apart];
  }
};

/// What @p bodies are held by where these windows are @p closed, 1/s2. Of two bodies that stick to
/// each other by springs across each one feels at most twice these, with its other end at rest:
/// (u - v)^2 <= 2 u^2 + 2 v^2.
Matrix held_by(const ModalGroup &bodies, const std::vector<Closed> &closed)
{
  std::vector<ClosedNode> nodes;
  for (unsigned int i = 0; i < closed.size(); ++i)
    for (const unsigned int column : closed[i].columns())
      for (unsigned int ring = 0; ring < closed[i].window->n_rings; ++ring)
        nodes.push_back({i, closed[i].window, ring, column});
  const auto n        = static_cast<unsigned int>(nodes.size()),
             n_closed = static_cast<unsigned int>(closed.size());
  const auto motions  = static_cast<unsigned int>(bodies.motions_of(0).size());
  Matrix     flexibility(n, n), rows(n, motions), held(n, motions), result(motions, motions);
  Matrix     across(2 * (n + n_closed), motions); // by square roots of springs
  const dealii::Tensor<1, 3> axis = dealii::Point<3>(0., 0., 1.);
  for (unsigned int a = 0; a < n; ++a)
    {
      const ClosedWindow        &window = *nodes[a].window;
      const unsigned int         middle = 2 * (n + nodes[a].closed);
      const double               root   = std::sqrt(2. * window.across[nodes[a].ring]);
      const dealii::Tensor<1, 3> normal = dealii::Point<3>(
                                     std::cos(nodes[a].angle()), std::sin(nodes[a].angle()), 0.),
                                 round              = cross_product_3d(axis, normal);
      const std::vector<dealii::Tensor<1, 3>> moved = bodies.motions_of(nodes[a].node());
      const double of_middle = nodes[a].column == closed[nodes[a].closed].middle() ?
                                   std::sqrt(2. * window.across_middle) / window.n_rings :
                                   0.;
      for (unsigned int j = 0; j < motions; ++j)
        {
          rows(a, j)           = normal * moved[j];
          across(2 * a, j)     = root * (round * moved[j]);
          across(2 * a + 1, j) = root * (axis * moved[j]);
          across(middle, j) += of_middle * (round * moved[j]);
          across(middle + 1, j) += of_middle * (axis * moved[j]);
        }
      for (unsigned int b = 0; b < n; ++b)
        flexibility(a, b) = nodes[a].flexibility(nodes[b]);
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

  /// Windows must outlive this.
  void add(const ClosedWindow &window)
  {
    const auto same = [&window](const ClosedWindow *other) {
      return other->surface == window.surface;
    };
    if (std::none_of(
            windows_.begin(), windows_.end(), same)) // it meets several kinds of bodies, alike
      windows_.push_back(&window);
  }

  /// After all windows.
  void close()
  {
    const auto through = std::find_if(windows_.begin(), windows_.end(), [](const auto *window) {
      return !window->through.empty();
    });
    if (through != windows_.end() && windows_.size() == 2)
      {
        // round outside and inside: how far apart the directions are is all that counts
        const ClosedWindow *inside = windows_[through == windows_.begin() ? 1 : 0];
        ways_.emplace_back();
        for (unsigned int i = 0; i < n_directions; ++i)
          ways_.back().push_back(held_by(bodies_, {{*through, 0}, {inside, i}}));
        return;
      }
    for (const ClosedWindow *window : windows_)
      {
        ways_.emplace_back();
        const bool all = window->half_angle >= PI;
        for (unsigned int i = 0; i < (all ? 1 : n_directions); ++i)
          ways_.back().push_back(held_by(bodies_, {{window, i}}));
      }
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
  std::vector<const ClosedWindow *>         windows_;
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
  for (auto &[group, body] : held)
    body.close();
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
