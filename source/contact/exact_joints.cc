// SPDX-License-Identifier: LGPL-2.1-or-later
// Joints without penalty: the problems of class JointBatch.
#include <chaindrive/contact/joints.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace chaindrive::contact
{
void JointBatch::recall_touching(const int lane)
{
  const std::vector<unsigned int> &rings   = exact_->flexibility.rings();
  const auto                       n_rings = static_cast<unsigned int>(rings.size());
  ClosedSet                       &set     = exact_->sets[lane];
  set.clear();
  for (unsigned int i = 0; i < window_.count[lane] * n_rings; ++i)
    {
      const unsigned int column = (window_.first[lane] + i / n_rings) % grid_.slave_circumferential;
      const std::size_t  node =
          std::size_t(rings[i % n_rings]) * grid_.slave_circumferential + column;
      if (state_[(node * n_touch_entries + touch_penetration) * n_lanes + lane] > 0.)
        set.number.push_back(i);
    }
}

void JointBatch::couple(const int              lane,
                        StripProblem          *strips,
                        const WallFlexibility *wall,
                        const double           angle)
{
  Exact::Coupled &coupled = exact_->coupled[lane];
  coupled.strips          = strips != nullptr && strips->n() > 0 ? strips : nullptr;
  coupled.wall            = wall;
  coupled.angle           = angle;
}

double JointBatch::column_angle(const int lane, const unsigned int place) const
{
  return exact_->coupled[lane].angle +
         2. * dealii::numbers::PI * (window_.first[lane] + place) / grid_.slave_circumferential;
}

ComplementarityProblem JointBatch::problem_of(const int                       lane,
                                              const JointFlexibility::Matrix &matrix)
{
  Exact          &e       = *exact_;
  Exact::Coupled &coupled = e.coupled[lane];
  if (coupled.strips == nullptr)
    {
      const bool same = e.matrix[lane] == &matrix;
      e.matrix[lane]  = &matrix;
      return {matrix.n, matrix.number.data(), matrix.stride, e.gap[lane].data(), same};
    }

  const StripProblem &strips = *coupled.strips;
  const unsigned int  m = matrix.n, k = strips.n();
  coupled.joint   = &matrix;
  coupled.first   = column_angle(lane, 0);
  coupled.column  = 2. * dealii::numbers::PI / grid_.slave_circumferential;
  coupled.n_rings = e.flexibility.n_rings();
  coupled.stride  = ComplementaritySolver::padded(m + k);
  coupled.matrix.resize_fast(std::size_t(m + k) * coupled.stride);
  coupled.is_there.assign(m + k, 0);
  coupled.of_strip = Exact::Coupled::no_strip;
  e.gap[lane].resize(coupled.stride, 0.);
  for (unsigned int a = 0; a < k; ++a)
    {
      e.gap[lane][m + a] = strips.gap[a];
      if (strips.force[a] > 0.)
        e.sets[lane].number.push_back(m + a);
    }
  e.matrix[lane] = nullptr;
  return {m + k, coupled.matrix.data(), coupled.stride, e.gap[lane].data(), false, &coupled};
}

void JointBatch::Exact::Coupled::need(const unsigned int row)
{
  if (is_there[row] != 0)
    return;
  const unsigned int m = joint->n, k = strips->n();
  // the bush presses the bore outwards, the tooth the outside inwards
  if (row < m) // of a column that touches all rings will
    {
      const unsigned int place = row / n_rings, begin = place * n_rings;
      const double       angle = first + place * column;
      for (unsigned int r = begin; r < begin + n_rings; ++r)
        {
          double *number = matrix.data() + std::size_t(r) * stride;
          std::copy_n(joint->number.data() + std::size_t(r) * joint->stride, m, number);
          std::fill(number + m + k, number + stride, 0.);
          is_there[r] = 1;
        }
      double            *number = matrix.data() + std::size_t(begin) * stride + m;
      const unsigned int of     = wall->n_rings();
      unsigned int       known  = no_strip;
      of_place.resize(std::size_t(of) * n_rings);
      for (unsigned int a = 0; a < k; ++a)
        {
          const unsigned int strip = strips->unknown[a] / of;
          if (strip != known)
            wall->at(strip, angle - strips->direction[a], of_place.data());
          known = strip;

          const double *of_ring = of_place.data() + std::size_t(strips->unknown[a] % of) * n_rings;
          for (unsigned int q = 0; q < n_rings; ++q)
            number[q * stride + a] = -of_ring[q];
        }
      return;
    }
  is_there[row]             = 1;
  double            *number = matrix.data() + std::size_t(row) * stride;
  const unsigned int a      = row - m;
  std::fill(number + m + k, number + stride, 0.);
  const unsigned int of = wall->n_rings(), strip = strips->unknown[a] / of,
                     in_row = of * n_rings; // rings of a strip mostly touch together
  if (strip != of_strip)
    {
      of_columns.resize(std::size_t(m) * of);
      wall->at(strip, first - strips->direction[a], column, m / n_rings, of_columns.data());
      of_strip = strip;
    }
  const double *of_ring = of_columns.data() + std::size_t(strips->unknown[a] % of) * n_rings;
  for (unsigned int i = 0; i < m; i += n_rings, of_ring += in_row)
    for (unsigned int q = 0; q < n_rings; ++q)
      number[i + q] = -of_ring[q];
  const float *const of_others = strips->flexibility->row(strips->unknown[a]);
  for (unsigned int b = 0; b < k; ++b)
    number[m + b] = of_others[strips->unknown[b]];
}

double JointBatch::take_strips(const int lane, const unsigned int n)
{
  Exact        &e      = *exact_;
  StripProblem *strips = e.coupled[lane].strips;
  if (strips == nullptr)
    return 0.;
  std::fill(strips->force.begin(), strips->force.end(), 0.);
  ClosedSet &set    = e.sets[lane];
  double     stored = 0.;
  for (; !set.number.empty() && set.number.back() >= n; set.number.pop_back())
    {
      const unsigned int a = set.number.back() - n;
      strips->force[a]     = set.pressure.back();
      stored -= 0.5 * set.pressure.back() * strips->gap[a];
      set.pressure.pop_back();
    }
  strips->couple.assign(strips->n(), 0.);
  Exact::Coupled        &coupled = e.coupled[lane];
  const WallFlexibility &wall    = *coupled.wall;
  const unsigned int     n_rings = e.flexibility.n_rings(), of = wall.n_rings();
  unsigned int           known = Exact::Coupled::no_strip;
  for (unsigned int a = 0; a < strips->n(); ++a)
    if (strips->force[a] > 0.)
      {
        // slopes at the columns that touch, one after the other; rings mostly touch together
        const unsigned int strip = strips->unknown[a] / of, ring = strips->unknown[a] % of;
        const std::size_t  in_row  = std::size_t(of) * n_rings;
        std::size_t        n_found = 0;
        for (unsigned int b = 0; b < set.number.size(); ++b)
          {
            const unsigned int column = set.number[b] / n_rings;
            if (b == 0 || column != set.number[b - 1] / n_rings)
              {
                n_found += in_row;
                if (strip != known)
                  {
                    coupled.slopes.resize(n_found);
                    wall.slope(strip,
                               column_angle(lane, column) - strips->direction[a],
                               &coupled.slopes[n_found - in_row]);
                  }
              }
            strips->couple[a] +=
                strips->force[a] * set.pressure[b] *
                coupled.slopes[n_found - in_row + ring * n_rings + set.number[b] % n_rings];
          }
        known = strip;
      }
  return stored;
}

void JointBatch::order_visits()
{
  Exact                           &e       = *exact_;
  const std::vector<unsigned int> &rings   = e.flexibility.rings();
  const auto                       n_rings = static_cast<unsigned int>(rings.size());
  const unsigned int               n       = grid_.slave_circumferential;
  const unsigned int n_nodes = n_rings * *std::max_element(window_.count, window_.count + n_lanes);
  e.order.assign(std::size_t(n_nodes) * n_lanes, WindowNodes::none);
  e.visit_of.assign(e.order.size(), WindowNodes::none);
  e.nearest.assign(n_nodes, std::numeric_limits<double>::max());
  std::vector<unsigned int> order;
  std::vector<double>       gap;
  for (int lane = 0; lane < n_lanes; ++lane)
    {
      order.resize(std::size_t(window_.count[lane]) * n_rings);
      gap.resize(order.size());
      for (unsigned int i = 0; i < order.size(); ++i)
        gap[i] = gap_[(rings[i % n_rings] * n + (window_.first[lane] + i / n_rings) % n) * n_lanes +
                      lane];
      std::iota(order.begin(), order.end(), 0u);
      std::stable_sort(
          order.begin(), order.end(), [&gap](const unsigned int a, const unsigned int b) {
            return gap[a] < gap[b];
          });
      for (unsigned int v = 0; v < order.size(); ++v)
        {
          e.order[v * n_lanes + lane]           = order[v];
          e.visit_of[order[v] * n_lanes + lane] = v;
          e.nearest[v] = std::min(e.nearest[v], gap[order[v]] - deflection_[lane]);
        }
    }
}

unsigned int JointBatch::n_visits() const
{
  const Exact &e = *exact_;
  if (reach_[0] == 0.) // not by distance: nobody knows how far they have come
    return static_cast<unsigned int>(e.nearest.size());
  double nearer = 0.;
  for (int lane = 0; lane < n_lanes; ++lane)
    nearer = std::max(nearer, used(lane) + use_);
  auto visits = static_cast<unsigned int>(
      std::upper_bound(e.nearest.begin(), e.nearest.end(), nearer) - e.nearest.begin());
  for (int lane = 0; lane < n_lanes; ++lane) // what touched lets go
    for (const unsigned int i : e.sets[lane].number)
      visits = std::max(visits, e.visit_of[i * n_lanes + lane] + 1);
  return visits;
}

void JointBatch::press()
{
  constexpr double                 tolerance = 1e-14; // m, of positions up to a metre
  Exact                           &e         = *exact_;
  const std::vector<unsigned int> &rings     = e.flexibility.rings();
  const auto                       n_rings   = static_cast<unsigned int>(rings.size());
  if (e.new_windows)
    {
      order_visits();
      e.known.resize_fast(kernels_.known_room(e.nearest.size()));
      std::fill(e.known.begin(), e.known.end(), 0);
      for (int lane = 0; lane < n_lanes; ++lane)
        recall_touching(lane);
      e.new_windows = false;
    }
  const unsigned int visits = n_visits();
  const std::size_t  n      = std::size_t(visits) * n_lanes;
  JointRoom         &room   = *e.room;
  room.gaps.resize_fast(n);
  room.forces.resize_fast(n);
  std::fill(room.forces.begin(), room.forces.end(), 0.);
  room.met.resize_fast(kernels_.room(visits));
  WindowNodes nodes{n_rings,
                    rings.data(),
                    visits,
                    e.order.data(),
                    room.gaps.data(),
                    room.forces.data(),
                    e.known.data(),
                    room.met.data(),
                    0,
                    nullptr};
  kernels_.measure_window(arguments_, nodes);

  e.is_pressed.assign(visits, 0);
  const auto mark_pressed = [&e](const int lane) {
    for (const unsigned int i : e.sets[lane].number)
      e.is_pressed[e.visit_of[i * n_lanes + lane]] = 1;
  };
  std::array<ComplementarityProblem, n_lanes> problems;
  for (int lane = 0; lane < n_lanes; ++lane)
    {
      const unsigned int count = window_.count[lane];
      if (arguments_.master_position[lane] == nullptr ||
          (count == 0 && e.coupled[lane].strips == nullptr))
        {
          e.sets[lane].clear();
          continue;
        }
      const JointFlexibility::Matrix &matrix = e.flexibility.of_columns(count);
      e.gap[lane].resize_fast(matrix.stride);
      std::fill_n(e.gap[lane].begin(), matrix.n, 1.); // those that are not visited are far away
      for (unsigned int v = 0; v < std::min(visits, matrix.n); ++v)
        e.gap[lane][e.order[v * n_lanes + lane]] = room.gaps[v * n_lanes + lane];
      mark_pressed(lane); // the search begins with what touched last time
      problems[lane] = problem_of(lane, matrix);
    }
  e.solver.solve(problems, tolerance, e.sets);
  deflected_.fill(0.);
  std::array<double, n_lanes> stored{};
  for (int lane = 0; lane < n_lanes; ++lane)
    {
      stored[lane] = take_strips(lane, window_.count[lane] * n_rings);
      mark_pressed(lane);
    }
  e.pressed.clear();
  for (unsigned int i = 0; i < e.is_pressed.size(); ++i)
    if (e.is_pressed[i] != 0)
      e.pressed.push_back(i);
  nodes.n_pressed = static_cast<unsigned int>(e.pressed.size());
  nodes.pressed   = e.pressed.data();
  for (int lane = 0; lane < n_lanes; ++lane)
    for (unsigned int a = 0; a < e.sets[lane].number.size(); ++a)
      {
        const unsigned int i                                         = e.sets[lane].number[a];
        room.forces[e.visit_of[i * n_lanes + lane] * n_lanes + lane] = e.sets[lane].pressure[a];
        stored[lane] -= 0.5 * e.sets[lane].pressure[a] * e.gap[lane][i]; // p C p / 2
        deflected_[lane] = std::max(deflected_[lane], -e.gap[lane][i]);
      }
  kernels_.press(arguments_, nodes);
  for (int lane = 0; lane < n_lanes; ++lane)
    {
      sums_.stored[lane] += stored[lane];
      if (arguments_.dt == 0.) // how bodies have been placed, before their walls deflect
        sums_.largest_penetration[lane] =
            std::max(sums_.largest_penetration[lane], deflected_[lane]);
    }
}
} // namespace chaindrive::contact
