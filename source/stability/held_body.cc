// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/stability/held_bodies.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace chaindrive::stability
{
using dealii::numbers::PI;

void HeldBody::add(const ClosedWindow &window)
{
  std::vector<const ClosedWindow *> &windows = window.strips.empty() ? windows_ : in_strips_;
  if (!window.strips.empty() ||
      std::none_of(windows.begin(), windows.end(), [&window](const ClosedWindow *other) {
        return other->surface == window.surface;
      }))
    windows.push_back(&window);
}

void HeldBody::close()
{
  // outside and inside of a roller: how far apart the directions are is all that counts
  const bool with_inside = !in_strips_.empty() && windows_.size() == 1;
  if (!in_strips_.empty())
    ways_.emplace_back();
  for (const ClosedWindow *outside : in_strips_)
    for (unsigned int set = 0; set < outside->strips.size(); ++set)
      for (unsigned int i = 0; i < (with_inside ? n_directions : 1); ++i)
        {
          with_inside ? add_way({{outside, set}, {windows_.front(), i}}) :
                        add_way({{outside, set}});
          ring_ways_.push_back({{outside, set}, i});
        }
  for (const ClosedWindow *window : windows_)
    if (!with_inside)
      {
        ways_.emplace_back();
        for (unsigned int i = 0; i < (window->half_angle >= PI ? 1 : n_directions); ++i)
          add_way({{window, i}});
      }
}

void HeldBody::add(const contact::ClosedSide &side, const ClosedKind &kind)
{
  springs_[side.surface].update_largest(added_to_modes(bodies_, side, kind.law), 1., kind.time);
}

void HeldBody::take_springs()
{
  held_.clear();
  for (const std::vector<Hold> &ways : ways_)
    {
      held_.emplace_back();
      for (const Hold &way : ways)
        held_.back().push_back(way.all());
    }
}

double HeldBody::critical_time_step()
{
  double step = std::numeric_limits<double>::infinity();
  for (unsigned int first = 0; first < n_directions; first += n_directions / 4)
    {
      std::vector<unsigned int> from(ways_.size());
      for (unsigned int w = 0; w < ways_.size(); ++w)
        from[w] = first * static_cast<unsigned int>(ways_[w].size()) / n_directions;
      step = std::min(step, step_from(from));
    }
  return step;
}

double HeldBody::near_critical_time_step()
{
  last_.resize(ways_.size(), 0);
  return step_from(last_);
}

std::vector<RingWay> HeldBody::fastest_ways(const unsigned int most) const
{
  if (ring_ways_.empty())
    return {RingWay()};
  std::vector<std::pair<double, unsigned int>> faster;
  for (unsigned int i = 0; i < ring_ways_.size(); ++i)
    {
      Matrix matrix = free_;
      matrix.add(1., ways_.front()[i].all());
      faster.emplace_back(-largest(matrix), i);
    }
  std::sort(faster.begin(), faster.end());
  std::vector<RingWay> ways;
  for (unsigned int i = 0; i < std::min<std::size_t>(most, faster.size()); ++i)
    ways.push_back(ring_ways_[faster[i].second]);
  return ways;
}

double HeldBody::step_from(std::vector<unsigned int> chosen)
{
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
  last_ = chosen;
  return of_others_.with(best);
}

double HeldBody::step_with(const std::vector<unsigned int> &chosen) const
{
  ModalBodies modal;
  modal.free = free_;
  for (unsigned int w = 0; w < ways_.size(); ++w)
    modal.free.add(1., held_[w][chosen[w]]);
  modal.sides = springs_;
  return modal.sides.empty() ? 2. / std::sqrt(largest(modal.free)) : modal.critical_time_step();
}

void HeldBody::add_way(const std::vector<Closed> &closed)
{
  ways_.back().push_back(held_by(bodies_, closed));
  const Hold &hold = ways_.back().back();
  for (const Closed &window : closed)
    of_others_.update_largest(
        {hold.stiffness * window.window->mobility + hold.of_rim,
         window.window->rim != nullptr ? window.window->rim->highest_frequency() : 0.});
}
} // namespace chaindrive::stability
