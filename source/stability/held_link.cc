// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/stability/held_bodies.h>
#include <chaindrive/utilities/eigenvalue.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace chaindrive::stability
{
namespace
{
constexpr unsigned int n_ring_ways = 24; ///< in which a ring alone is fastest, tried with a link

/// x M x with these entries of x.
double square_by(const Matrix                    &matrix,
                 const std::vector<unsigned int> &motions,
                 const dealii::Vector<double>    &x)
{
  double sum = 0.;
  for (unsigned int i = 0; i < motions.size(); ++i)
    {
      double row = 0.;
      for (unsigned int j = 0; j < motions.size(); ++j)
        row += matrix(i, j) * x[motions[j]];
      sum += row * x[motions[i]];
    }
  return sum;
}

void add_to(const Matrix                    &matrix,
            const double                     factor,
            const std::vector<unsigned int> &motions,
            Matrix                          &sum)
{
  for (unsigned int i = 0; i < motions.size(); ++i)
    for (unsigned int j = 0; j < motions.size(); ++j)
      sum(motions[i], motions[j]) += factor * matrix(i, j);
}
} // namespace

HeldLink::HeldLink(const HeldBody &link) : link_(link)
{
  const Matrix free = link.bodies().modal_matrix({});
  for (unsigned int m = 0; m < free.m(); ++m)
    {
      of_link_.push_back(m);
      free_.push_back(free(m, m));
    }
}

void HeldLink::add(const HeldBody &ring, const ClosedWindow &bore, const ClosedWindow &cylinder)
{
  Side         side;
  const Matrix free = ring.bodies().modal_matrix({});
  for (unsigned int m = 0; m < free.m(); ++m)
    {
      side.motions.push_back(static_cast<unsigned int>(free_.size()));
      free_.push_back(free(m, m));
    }
  side.motions.insert(side.motions.end(), of_link_.begin(), of_link_.end());
  side.ring        = &ring;
  side.joint       = {&ring.bodies(), &link_.bodies(), &bore, &cylinder};
  side.ways        = ring.fastest_ways(n_ring_ways);
  side.direction.n = n_directions;
  side.ring_way.n  = static_cast<unsigned int>(side.ways.size());
  of_others_.update_largest(ring.of_others());
  sides_.push_back(std::move(side));
}

void HeldLink::close()
{
  for (const ClosedWindow *window : link_.windows())
    if (std::none_of(sides_.begin(), sides_.end(), [window](const Side &side) {
          return side.joint.cylinder != nullptr && side.joint.cylinder->surface == window->surface;
        }))
      {
        Side side;
        side.motions     = of_link_;
        side.window      = window;
        side.direction.n = window->half_angle >= dealii::numbers::PI ? 1 : n_directions;
        sides_.push_back(std::move(side));
      }
  add_springs(link_, of_link_);
  for (const Side &side : sides_)
    if (side.ring != nullptr)
      add_springs(*side.ring, side.motions);
}

void HeldLink::add_springs(const HeldBody &body, const std::vector<unsigned int> &motions)
{
  for (const auto &[surface, of_body] : body.springs())
    {
      ModalBodies::Side &side = springs_[static_cast<unsigned int>(springs_.size())];
      side                    = of_body;
      side.springs.reinit(free_.size(), free_.size());
      for (unsigned int i = 0; i < of_body.springs.m(); ++i)
        for (unsigned int j = 0; j < of_body.springs.n(); ++j)
          side.springs(motions[i], motions[j]) = of_body.springs(i, j);
    }
}

const Hold &
HeldLink::closed_at(Side &side, const unsigned int direction, const unsigned int ring_way)
{
  const auto [found, is_new] = side.made.try_emplace({direction, ring_way});
  if (is_new && side.ring != nullptr)
    found->second.matrix = held_together(side.joint, direction, side.ways[ring_way]);
  else if (is_new)
    found->second = held_by(link_.bodies(), {{side.window, direction}});
  return found->second;
}

Matrix HeldLink::matrix()
{
  Matrix sum(free_.size(), free_.size());
  for (unsigned int i = 0; i < free_.size(); ++i)
    sum(i, i) = free_[i];
  for (Side &side : sides_)
    {
      const Hold &held = closed_at(side, side.direction.now, side.ring_way.now);
      add_to(held.matrix, 1., side.motions, sum);
      if (held.nodes != nullptr)
        add_to(held.across, held.nodes->springs, side.motions, sum);
    }
  return sum;
}

double HeldLink::step_of(Matrix &&matrix) const
{
  ModalBodies modal;
  modal.free  = std::move(matrix);
  modal.sides = springs_;
  return modal.sides.empty() ? 2. / std::sqrt(largest(modal.free)) : modal.critical_time_step();
}

double HeldLink::step_from_here()
{
  double best = std::numeric_limits<double>::infinity();
  for (;;)
    {
      Matrix now = matrix();
      for (const auto &[number, side] : springs_)
        now.add(side.stiffness, side.springs);
      const Eigenpairs pairs = eigenpairs(now);
      const double     step  = 2. / std::sqrt(pairs.values[free_.size() - 1]);
      if (step >= best * (1. - 1e-9))
        return best;
      best = step;
      dealii::Vector<double> fastest(free_.size());
      for (unsigned int i = 0; i < free_.size(); ++i)
        fastest[i] = pairs.vectors(i, free_.size() - 1);
      for (Side &side : sides_)
        {
          const auto stiffness = [&]() {
            const Hold &held = closed_at(side, side.direction.now, side.ring_way.now);
            return square_by(held.matrix, side.motions, fastest) +
                   (held.nodes != nullptr ?
                        held.nodes->springs * square_by(held.across, side.motions, fastest) :
                        0.);
          };
          double stiffest = stiffness();
          for (Number *number : {&side.ring_way, &side.direction})
            {
              unsigned int found = number->now;
              for (unsigned int i = 0; i < number->n; ++i)
                {
                  number->now = i;
                  if (const double of_this = stiffness(); of_this > stiffest * (1. + 1e-9))
                    {
                      stiffest = of_this;
                      found    = i;
                    }
                }
              number->now = found;
            }
        }
    }
}

double HeldLink::step_among_neighbours(double best)
{
  for (bool changed = true; changed;)
    {
      changed = false;
      for (Side &side : sides_)
        for (Number *number : {&side.ring_way, &side.direction})
          {
            unsigned int found = number->now;
            for (unsigned int i = 0; i < number->n; ++i)
              {
                number->now = i;
                if (const double step = step_of(matrix()); step < best * (1. - 1e-9))
                  {
                    best    = step;
                    found   = i;
                    changed = true;
                  }
              }
            number->now = found;
          }
    }
  return best;
}

double HeldLink::near_critical_time_step()
{
  step_from_here();
  const double step = step_of(matrix());
  return of_others_.with(step);
}

double HeldLink::critical_time_step()
{
  constexpr unsigned int n_starts = 4;
  double                 best     = std::numeric_limits<double>::infinity();
  const auto             start    = [this](const unsigned int number) {
    for (Side &side : sides_)
      for (Number *of : {&side.direction, &side.ring_way})
        of->now = number * of->n / n_starts;
  };
  unsigned int from = 0;
  for (unsigned int number = 0; number < n_starts; ++number)
    {
      start(number);
      if (const double step = step_from_here(); step < best)
        {
          best = step;
          from = number;
        }
    }
  start(from);
  step_from_here();
  const double step = step_among_neighbours(step_of(matrix()));
  return of_others_.with(step);
}
} // namespace chaindrive::stability
