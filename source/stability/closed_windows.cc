// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/contact/closed_window.h>
#include <chaindrive/stability/closed_modes.h>
#include <chaindrive/stability/closed_windows.h>
#include <chaindrive/stability/coupled_modes.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace chaindrive::stability
{
namespace
{
using contact::ClosedStrips;
using dealii::numbers::PI;

/// A window of one of the families.
struct ClosedWindow : contact::ClosedWindow
{
  unsigned int family;
  /// By how much more its body alone feels the springs of friction of nodes, see Shares.
  double springs = 2.;
};

/// A window that is closed: about a direction, or in one of its sets of strips.
struct Closed
{
  const ClosedWindow *window;
  unsigned int        number; ///< of that

  const ClosedStrips *strips() const
  {
    return window->strips.empty() ? nullptr : &window->strips[number];
  }

  /// A column counts that is nearer than half a column beyond the window's end.
  std::vector<unsigned int> columns() const
  {
    std::vector<unsigned int> found;
    for (unsigned int c = 0; c < window->n_columns; ++c)
      if (from_middle(c) <= window->half_angle + PI / window->n_columns)
        found.push_back(c);
    return found;
  }

private:
  double from_middle(const unsigned int c) const
  {
    return std::abs(std::remainder(
        2. * PI * (double(c) / window->n_columns - double(number) / n_directions), 2. * PI));
  }
};

/// What is closed in a window: a node, or a place in strips.
struct ClosedPlace
{
  unsigned int closed; ///< the window, by its place among all that are closed
  unsigned int place;  ///< or ring * n_columns + column
  double       angle;
  double       across; ///< springs of friction, N/m
  double       shared; ///< its part of the slip of the window's one spring of friction

  unsigned int                n_nodes;
  std::array<unsigned int, 4> node;
  std::array<double, 4>       weight;

  /// What it moves by the motions of @p bodies.
  std::vector<dealii::Tensor<1, 3>> moved(const ModalGroup &bodies) const
  {
    std::vector<dealii::Tensor<1, 3>> sum = bodies.motions_of(node[0]);
    for (dealii::Tensor<1, 3> &motion : sum)
      motion *= weight[0];
    for (unsigned int k = 1; k < n_nodes; ++k)
      {
        const std::vector<dealii::Tensor<1, 3>> of_node = bodies.motions_of(node[k]);
        for (unsigned int j = 0; j < sum.size(); ++j)
          sum[j] += weight[k] * of_node[j];
      }
    return sum;
  }
};

/// All places of @p closed.
std::vector<ClosedPlace> places_of(const std::vector<Closed> &closed)
{
  std::vector<ClosedPlace> places;
  for (unsigned int i = 0; i < closed.size(); ++i)
    {
      const ClosedWindow &window = *closed[i].window;
      if (const ClosedStrips *strips = closed[i].strips())
        for (unsigned int p = 0; p < strips->places.size(); ++p)
          {
            const ClosedStrips::Place &place = strips->places[p];
            const bool in_middle = p / window.n_rings == strips->places.size() / window.n_rings / 2;
            places.push_back({i,
                              p,
                              place.angle,
                              0.,
                              in_middle ? 1. / window.n_rings : 0.,
                              4,
                              place.node,
                              place.weight});
          }
      else
        for (const unsigned int column : closed[i].columns())
          for (unsigned int ring = 0; ring < window.n_rings; ++ring)
            {
              const unsigned int number = ring * window.n_columns + column;
              places.push_back({i,
                                number,
                                2. * PI * column / window.n_columns,
                                window.across[ring],
                                0.,
                                1,
                                {{window.node[number]}},
                                {{1.}}});
            }
    }
  return places;
}

/// What one of @p places moves away from the axis under one newton on another one, m/N.
double flexibility_of(const std::vector<Closed> &closed, const ClosedPlace &a, const ClosedPlace &b)
{
  const ClosedWindow &window = *closed[a.closed].window, &other = *closed[b.closed].window;
  const ClosedStrips *strips = closed[a.closed].strips();
  const unsigned int  n      = window.n_columns;
  if (a.closed == b.closed)
    return strips != nullptr ? strips->flexibility[a.place * strips->places.size() + b.place] :
                               window.flexibility[(a.place / n * window.n_rings + b.place / n) * n +
                                                  (b.place % n + n - a.place % n) % n];
  if (strips == nullptr)
    return closed[b.closed].strips() == nullptr ? 0. : flexibility_of(closed, b, a);
  return strips->through[(std::size_t(a.place) * n + b.place % n) * window.n_rings_of_through +
                         other.first_ring + b.place / n];
}

/// What bodies are held by, 1/s2, and how stiff that is in any direction of the plane at most, N/m.
struct Hold
{
  Matrix              matrix;
  Matrix              across; ///< by the springs of friction of the nodes of one window
  const ClosedWindow *nodes     = nullptr; ///< that window
  double              stiffness = 0.;

  Matrix all() const
  {
    Matrix sum = matrix;
    if (nodes != nullptr)
      sum.add(nodes->springs, across);
    return sum;
  }
};

/// What @p bodies are held by where these windows, of nodes at most one, are @p closed.
Hold held_by(const ModalGroup &bodies, const std::vector<Closed> &closed)
{
  const std::vector<ClosedPlace> places  = places_of(closed);
  const auto                     n       = static_cast<unsigned int>(places.size());
  const auto                     motions = static_cast<unsigned int>(bodies.motions_of(0).size());
  Hold                           hold{Matrix(motions, motions), Matrix(motions, motions)};
  for (const Closed &window : closed)
    if (window.strips() == nullptr)
      hold.nodes = window.window;
  if (n == 0)
    return hold;
  dealii::LAPACKFullMatrix<double> flexibility(n, n);
  dealii::LAPACKFullMatrix<double> held(n, motions + 2); // and strips by a shift in the plane
  Matrix                           rows(n, motions);
  // by square roots of springs: of nodes, and of strips, which share one
  Matrix                     across(2 * n, motions), in_strips(2 * closed.size(), motions);
  const dealii::Tensor<1, 3> axis = dealii::Point<3>(0., 0., 1.);
  for (unsigned int a = 0; a < n; ++a)
    {
      const dealii::Tensor<1, 3> normal = dealii::Point<3>(
                                     std::cos(places[a].angle), std::sin(places[a].angle), 0.),
                                 round = cross_product_3d(axis, normal);
      const unsigned int one           = 2 * places[a].closed;
      const double       root          = std::sqrt(places[a].across),
                   of_one =
                       places[a].shared * std::sqrt(closed[places[a].closed].window->across_middle);
      const std::vector<dealii::Tensor<1, 3>> moved = places[a].moved(bodies);
      for (unsigned int j = 0; j < motions; ++j)
        {
          rows(a, j)           = normal * moved[j];
          across(2 * a, j)     = root * (round * moved[j]);
          across(2 * a + 1, j) = root * (axis * moved[j]);
          in_strips(one, j) += of_one * (round * moved[j]);
          in_strips(one + 1, j) += of_one * (axis * moved[j]);
        }
      for (unsigned int j = 0; j < motions; ++j)
        held(a, j) = rows(a, j);
      for (unsigned int d = 0; d < 2 && closed[places[a].closed].strips() != nullptr; ++d)
        held(a, motions + d) = normal[d];
      for (unsigned int b = 0; b < n; ++b)
        flexibility(a, b) = flexibility_of(closed, places[a], places[b]);
    }
  flexibility.set_property(dealii::LAPACKSupport::symmetric);
  flexibility.compute_cholesky_factorization();
  flexibility.solve(held);
  for (unsigned int a = 0; a < n; ++a)
    {
      for (unsigned int i = 0; i < motions; ++i)
        for (unsigned int j = 0; j < motions; ++j)
          hold.matrix(i, j) += rows(a, i) * held(a, j);
      if (closed[places[a].closed].strips() != nullptr)
        hold.stiffness += std::cos(places[a].angle) * held(a, motions) +
                          std::sin(places[a].angle) * held(a, motions + 1);
    }
  in_strips.Tmmult(hold.matrix, in_strips, true);
  across.Tmmult(hold.across, across);
  for (const Closed &window : closed)
    if (window.strips() != nullptr)
      hold.stiffness += window.window->across_middle;
  return hold;
}

/// One body of a group with all that holds it.
class HeldBody
{
public:
  explicit HeldBody(const ModalGroup &bodies) : bodies_(bodies), free_(bodies.modal_matrix({})) {}

  /// Windows must outlive this. What a side of nodes meets, of several kinds of bodies, is alike.
  void add(const ClosedWindow &window)
  {
    std::vector<const ClosedWindow *> &windows = window.strips.empty() ? windows_ : in_strips_;
    if (!window.strips.empty() ||
        std::none_of(windows.begin(), windows.end(), [&window](const ClosedWindow *other) {
          return other->surface == window.surface;
        }))
      windows.push_back(&window);
  }

  /// After all windows.
  void close()
  {
    // outside and inside of a roller: how far apart the directions are is all that counts
    const bool with_inside = !in_strips_.empty() && windows_.size() == 1;
    if (!in_strips_.empty())
      ways_.emplace_back();
    for (const ClosedWindow *outside : in_strips_)
      for (unsigned int set = 0; set < outside->strips.size(); ++set)
        for (unsigned int i = 0; i < (with_inside ? n_directions : 1); ++i)
          with_inside ? add_way({{outside, set}, {windows_.front(), i}}) :
                        add_way({{outside, set}});
    for (const ClosedWindow *window : windows_)
      if (!with_inside)
        {
          ways_.emplace_back();
          for (unsigned int i = 0; i < (window->half_angle >= PI ? 1 : n_directions); ++i)
            add_way({{window, i}});
        }
  }

  void add(const contact::ClosedSide &side, const ClosedKind &kind)
  {
    springs_[side.surface].update_largest(added_to_modes(bodies_, side, kind.law), 1., kind.time);
  }

  bool is_held() const { return !ways_.empty(); }

  /// Takes the springs that windows now have.
  void take_springs()
  {
    held_.clear();
    for (const std::vector<Hold> &ways : ways_)
      {
        held_.emplace_back();
        for (const Hold &way : ways)
          held_.back().push_back(way.all());
      }
  }

  /// The smallest limit found, s, from several ways to close.
  double critical_time_step()
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

  /// The limit, s, from that way alone which was found last: nearly the smallest one.
  double near_critical_time_step()
  {
    last_.resize(ways_.size(), 0);
    return step_from(last_);
  }

private:
  /// Of ways that differ by one side the worst is chosen until none is worse.
  double step_from(std::vector<unsigned int> chosen)
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
    return 2. / std::sqrt(4. / (best * best) + of_others_);
  }

  double step_with(const std::vector<unsigned int> &chosen) const
  {
    ModalBodies modal;
    modal.free = free_;
    for (unsigned int w = 0; w < ways_.size(); ++w)
      modal.free.add(1., held_[w][chosen[w]]);
    modal.sides = springs_;
    return modal.sides.empty() ? 2. / std::sqrt(largest(modal.free)) : modal.critical_time_step();
  }

  void add_way(const std::vector<Closed> &closed)
  {
    ways_.back().push_back(held_by(bodies_, closed));
    const Hold &hold = ways_.back().back();
    for (const Closed &window : closed)
      of_others_ = std::max(of_others_, hold.stiffness * window.window->mobility);
  }

  const ModalGroup                         &bodies_;
  Matrix                                    free_;
  std::vector<const ClosedWindow *>         windows_, in_strips_;
  std::vector<std::vector<Hold>>            ways_; ///< [side][direction]
  std::vector<std::vector<Matrix>>          held_; ///< by these, 1/s2
  std::vector<unsigned int>                 last_; ///< the way found last
  std::map<unsigned int, ModalBodies::Side> springs_;
  double of_others_ = 0.; ///< squared frequency of the rigid bodies that strips meet, 1/s2
};

constexpr unsigned int n_rounds = 6; ///< of balancing bodies, after which their steps hardly change

/// Of two bodies that stick to each other by springs each one alone, with its other end at rest,
/// feels as much of them as it takes: (u - v)^2 <= (1 + t) u^2 + (1 + 1/t) v^2. The t of a family,
/// of its cylinders, is chosen so that bodies are about equally fast.
class Shares
{
public:
  Shares(std::vector<ClosedWindow>        &windows,
         const unsigned int                n_families,
         std::map<unsigned int, HeldBody> &held)
      : windows_(windows), held_(held), t_(n_families, 1.)
  {
  }

  /// The smallest limit, s, with the best t that were found.
  double critical_time_step()
  {
    std::vector<double> best = t_;
    double              most = 0.;
    for (unsigned int round = 0; round < n_rounds; ++round)
      {
        apply();
        std::map<unsigned int, double> step; // of groups
        double                         least = infinity;
        for (auto &[group, body] : held_)
          {
            step[group] = body.is_held() ? body.near_critical_time_step() : infinity;
            least       = std::min(least, step[group]);
          }
        if (least > most)
          {
            most = least;
            best = t_;
          }
        const std::vector<double> before = t_;
        balance(step);
        if (t_ == before) // nothing sticks
          break;
      }
    t_ = best;
    apply();
    double least = infinity;
    for (auto &[group, body] : held_)
      if (body.is_held())
        least = std::min(least, body.critical_time_step());
    return least;
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  void apply()
  {
    for (ClosedWindow &window : windows_)
      window.springs = 1. + (window.in_bore ? 1. / t_[window.family] : t_[window.family]);
    for (auto &[group, body] : held_)
      body.take_springs();
  }

  /// Of the groups that meet the faster one gets less.
  void balance(const std::map<unsigned int, double> &step)
  {
    for (unsigned int f = 0; f < t_.size(); ++f)
      {
        std::array<double, 2> least{{infinity, infinity}}; // of cylinders, of bores
        bool                  sticks = false;
        for (const ClosedWindow &window : windows_)
          if (window.family == f && window.strips.empty())
            {
              double &of_side = least[window.in_bore ? 1 : 0];
              of_side         = std::min(of_side, step.at(window.group));
              sticks          = sticks || window.across.front() > 0.;
            }
        if (sticks)
          t_[f] = std::clamp(t_[f] * std::pow(least[0] / least[1], 2), 0.1, 10.);
      }
  }

  std::vector<ClosedWindow>        &windows_;
  std::map<unsigned int, HeldBody> &held_;
  std::vector<double>               t_;
};
} // namespace

double closed_windows_time_step(const World                                &world,
                                const std::vector<const contact::Family *> &families)
{
  std::vector<ClosedWindow> windows;
  for (unsigned int f = 0; f < families.size(); ++f)
    if (const auto *exact = dynamic_cast<const contact::HasClosedWindows *>(families[f]))
      for (const contact::ClosedWindow &window : exact->closed_windows())
        windows.push_back({window, f});
  if (windows.empty())
    return std::numeric_limits<double>::infinity();
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
        if (const auto body = held.find(side.group); body != held.end() && !side.flat)
          body->second.add(side, kind);

  return Shares(windows, static_cast<unsigned int>(families.size()), held).critical_time_step();
}
} // namespace chaindrive::stability
