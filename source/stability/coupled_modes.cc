// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/stability/closed_modes.h>
#include <chaindrive/stability/coupled_modes.h>
#include <chaindrive/stability/critical_time_step.h>
#include <chaindrive/utilities/eigenvalue.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace chaindrive::stability
{
namespace
{
using contact::ClosedSide;
using Vector  = dealii::Vector<double>;
using Matrix  = dealii::FullMatrix<double>;
using Tensor  = dealii::Tensor<1, 3>;
using Motions = std::vector<Tensor>;

/// Damping time c/k [s] of a contact that sticks or slides.
double damping_time(const scene::ContactLaw &law)
{
  const double normal = law.damping / law.stiffness;
  if (law.friction > 0. && law.tangential_stiffness > 0.)
    return std::max(normal, law.tangential_damping / law.tangential_stiffness);
  return normal;
}

/// The product @p y of a symmetric matrix and @p x: of columns, which compilers make four of at a
/// time, and not of rows, whose sums have an order.
void multiply(const Matrix &matrix, const Vector &x, Vector &y)
{
  const std::size_t n  = matrix.m();
  double           *to = y.begin();
  std::fill(to, to + n, 0.);
  std::size_t j = 0;
  for (; j + 4 <= n; j += 4)
    {
      const double *a = &matrix(j, 0), *b = &matrix(j + 1, 0), *c = &matrix(j + 2, 0),
                   *d = &matrix(j + 3, 0);
      const double xa = x[j], xb = x[j + 1], xc = x[j + 2], xd = x[j + 3];
      for (std::size_t i = 0; i < n; ++i)
        to[i] += (xa * a[i] + xb * b[i]) + (xc * c[i] + xd * d[i]);
    }
  for (; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i)
      to[i] += x[j] * matrix(j, i);
}

/// The groups of modal bodies by their number in World::copies, others nullptr.
std::vector<const ModalGroup *> groups_of(const World &world)
{
  std::vector<const ModalGroup *> groups(world.copies.size(), nullptr);
  for (const ModalGroup *group : world.groups.modal())
    groups[group->copies()] = group;
  return groups;
}

/// Sums of springs, apart by their normals: sector 2 i is the direction i 2 pi / n_directions, 2 i
/// + 1 all between it and the next.
class Sectors
{
public:
  /// Of @p n motions; @p across: stiffness across the normals over that along them.
  Sectors(const std::size_t n, const double across) : n_(n), across_(across), row_(n) {}

  /// Adds a spring @p k [N/m] that @p motions stretch, along @p normal and across; if this is zero,
  /// in all directions alike.
  void add(const double k, const Tensor &normal, const Motions &motions)
  {
    const bool   all    = normal.norm_square() == 0.;
    const double across = all ? k : across_ * k;
    const Tensor axis   = dealii::Point<3>(0., 0., 1.),
                 along  = all ? Tensor(dealii::Point<3>(1., 0., 0.)) : normal;
    Matrix &sum         = sums_[sector(along)];
    if (sum.empty())
      sum.reinit(n_, n_);
    add_row(k, along, motions, sum);
    if (across > 0.)
      {
        add_row(across, dealii::cross_product_3d(axis, along), motions, sum);
        add_row(across, axis, motions, sum);
      }
  }

  /// All springs whose normals, or those of the middle of their sector, are at most @p half_angle
  /// [rad] from direction @p i.
  Matrix about(const unsigned int i, const double half_angle) const
  {
    Matrix matrix(n_, n_);
    for (const auto &[sector, sum] : sums_)
      {
        const unsigned int ahead = (sector + 4 * n_directions - 2 * i) % (2 * n_directions),
                           apart = std::min(ahead, 2 * n_directions - ahead);
        if (apart * dealii::numbers::PI / n_directions < half_angle + 1e-9)
          matrix.add(1., sum);
      }
    return matrix;
  }

  Matrix all() const
  {
    Matrix matrix(n_, n_);
    for (const auto &[sector, sum] : sums_)
      matrix.add(1., sum);
    return matrix;
  }

private:
  static unsigned int sector(const Tensor &normal)
  {
    constexpr int n     = 2 * n_directions;
    const double  place = std::atan2(normal[1], normal[0]) * n_directions / dealii::numbers::PI;
    const int     near  = static_cast<int>(std::round(place));
    // in an even place or else in the odd one next to it
    const int found = std::abs(place - near) < 1e-6 || near % 2 != 0 ? near :
                      place > near                                   ? near + 1 :
                                                                       near - 1;
    return static_cast<unsigned int>((found + n) % n);
  }

  void add_row(const double k, const Tensor &along, const Motions &motions, Matrix &sum)
  {
    for (unsigned int i = 0; i < n_; ++i)
      row_[i] = along * motions[i];
    for (unsigned int i = 0; i < n_; ++i)
      {
        const double force = k * row_[i];
        double      *into  = &sum(i, 0);
        for (unsigned int j = 0; j < n_; ++j)
          into[j] += force * row_[j];
      }
  }

  std::size_t                    n_;
  double                         across_;
  std::vector<double>            row_;
  std::map<unsigned int, Matrix> sums_; ///< by sector
};

/// The motions of the point of a bore that @p spring meets, times @p sign.
void add_point(const std::vector<Motions>  &motions,
               const contact::ClosedSpring &spring,
               const double                 sign,
               Motions                     &sum)
{
  const std::size_t first = sum.size();
  sum.resize(first + motions[spring.bore_nodes[0]].size());
  for (unsigned int i = 0; i < 4; ++i)
    for (std::size_t m = first; m < sum.size(); ++m)
      sum[m] += sign * spring.weights[i] * motions[spring.bore_nodes[i]][m - first];
}

std::vector<Motions> motions_of(const ModalGroup &group, const unsigned int n_nodes)
{
  std::vector<Motions> motions(n_nodes);
  for (unsigned int node = 0; node < n_nodes; ++node)
    motions[node] = group.motions_of(node);
  return motions;
}

const ModalGroup *group_of(const std::vector<const ModalGroup *> &groups, const ClosedSide &side)
{
  return side.group == ClosedSide::none ? nullptr : groups[side.group];
}
using Side = std::pair<unsigned int, unsigned int>; // group and surface

/// The kinds of contact that bodies by modes have.
struct Sorted
{
  std::vector<const ClosedKind *> joints;  ///< between two of them
  std::vector<const ClosedKind *> grounds; ///< with the ground
  std::map<Side, unsigned int>    n_kinds; ///< of the joints of a side
};

/// Sorts @p kinds; false if CoupledModes::make() makes nothing of them.
bool sort(const std::vector<ClosedKind>         &kinds,
          const std::vector<const ModalGroup *> &groups,
          Sorted                                &sorted)
{
  std::map<unsigned int, std::set<unsigned int>> surfaces; // of a group that have joints
  for (const ClosedKind &kind : kinds)
    {
      const auto &[master, slave] = kind.sides;
      const bool is_modal[2]      = {group_of(groups, master) != nullptr,
                                     group_of(groups, slave) != nullptr};
      if (is_modal[0] && is_modal[1] && !slave.springs.empty())
        {
          sorted.joints.push_back(&kind);
          for (const ClosedSide &side : kind.sides)
            {
              ++sorted.n_kinds[{side.group, side.surface}];
              surfaces[side.group].insert(side.surface);
            }
        }
      else if (is_modal[1] && master.group == ClosedSide::none)
        sorted.grounds.push_back(&kind);
      else if (is_modal[0] || is_modal[1])
        return false;
    }
  for (const auto &[side, n] : sorted.n_kinds)
    if (n > 1 && surfaces[side.first].size() > 1)
      return false;
  return !sorted.joints.empty() || !sorted.grounds.empty();
}
} // namespace

std::vector<ClosedKind> closed_kinds(const World &world, const contact::Family &family)
{
  std::vector<ClosedKind> kinds;
  for (contact::ClosedPair &sides : family.closed_pairs(world))
    kinds.push_back({std::move(sides), family.law(), damping_time(family.law())});
  return kinds;
}

unsigned int CoupledModes::add_body(const ModalGroup &group)
{
  const Matrix free  = group.modal_matrix({});
  const auto   first = static_cast<unsigned int>(free_.size());
  for (unsigned int m = 0; m < free.m(); ++m)
    free_.push_back(free(m, m));
  return first;
}

std::optional<CoupledModes> CoupledModes::make(const World                   &world,
                                               const std::vector<ClosedKind> &kinds)
{
  const std::vector<const ModalGroup *> groups = groups_of(world);
  Sorted                                sorted;
  if (!sort(kinds, groups, sorted))
    return {};

  CoupledModes                                      system;
  std::map<unsigned int, std::vector<unsigned int>> bodies; // of a group: their first motions
  const auto                                        body = [&](const ClosedSide &side) {
    std::vector<unsigned int> &of_group = bodies[side.group];
    if (of_group.empty() || sorted.n_kinds[{side.group, side.surface}] > 1)
      of_group.push_back(system.add_body(*groups[side.group]));
    return of_group.back();
  };
  std::set<std::array<unsigned int, 2>> joined;
  for (const ClosedKind *kind : sorted.joints)
    {
      const std::array<unsigned int, 2> first{{body(kind->sides[0]), body(kind->sides[1])}};
      Interface                         interface;
      system.add_ways(world, *kind, first, !joined.insert(first).second, interface);
      system.interfaces_.push_back(std::move(interface));
    }
  std::map<Side, std::vector<const ClosedKind *>> on_ground;
  for (const ClosedKind *kind : sorted.grounds)
    {
      if (bodies[kind->sides[1].group].empty())
        body(kind->sides[1]);
      on_ground[{kind->sides[1].group, kind->sides[1].surface}].push_back(kind);
    }
  for (const auto &[side, of_side] : on_ground)
    for (const unsigned int first : bodies[side.first])
      {
        Interface interface;
        for (const ClosedKind *kind : of_side)
          system.add_ways(world, *kind, {{first, first}}, false, interface);
        system.interfaces_.push_back(std::move(interface));
      }
  return system;
}

void CoupledModes::add_ways(const World                       &world,
                            const ClosedKind                  &kind,
                            const std::array<unsigned int, 2> &first,
                            const bool                         closes_pitch,
                            Interface                         &interface)
{
  const std::vector<const ModalGroup *> groups = groups_of(world);
  const ClosedSide                     &slave  = kind.sides[1];
  const double                          across =
      kind.law.friction > 0. ? kind.law.tangential_stiffness / kind.law.stiffness : 0.;
  const auto moved = motions_of(*groups[slave.group], world.copies[slave.group].n_nodes());
  const auto close = [&](const Sectors &sectors) {
    if (slave.touches_in_part())
      for (unsigned int i = 0; i < n_directions; ++i)
        interface.ways.push_back({sectors.about(i, slave.half_angle), kind.time});
    else
      interface.ways.push_back({sectors.all(), kind.time});
  };
  interface.motions.clear();
  interface.n_slave_motions = static_cast<unsigned int>(moved.front().size());
  interface.closes_pitch    = closes_pitch;
  const auto take_part      = [&](const unsigned int from, const std::size_t n) {
    for (unsigned int i = 0; i < n; ++i)
      interface.motions.push_back(from + i);
  };
  take_part(first[1], moved.front().size());
  if (kind.sides[0].group == ClosedSide::none)
    {
      Sectors sectors(interface.motions.size(), across);
      for (unsigned int node = 0; node < slave.stiffness.size(); ++node)
        if (slave.stiffness[node] > 0.)
          sectors.add(slave.stiffness[node],
                      slave.normal.empty() ? Tensor() : slave.normal[node],
                      moved[node]);
      close(sectors);
      return;
    }
  const unsigned int master = kind.sides[0].group;
  const auto         bore   = motions_of(*groups[master], world.copies[master].n_nodes());
  take_part(first[0], bore.front().size());
  for (const double sign : {-1., 1.})
    {
      if (sign > 0. && !closes_pitch)
        continue;
      Sectors sectors(interface.motions.size(), across);
      for (const contact::ClosedSpring &spring : slave.springs)
        {
          Motions stretch = moved[spring.node];
          add_point(bore, spring, sign, stretch);
          sectors.add(spring.stiffness, spring.normal, stretch);
        }
      close(sectors);
    }
}

void CoupledModes::assemble(const Ways &ways, const double dt, Matrix &matrix) const
{
  matrix.reinit(free_.size(), free_.size());
  for (unsigned int m = 0; m < free_.size(); ++m)
    matrix(m, m) = free_[m];
  for (std::size_t k = 0; k < interfaces_.size(); ++k)
    {
      const Interface &interface = interfaces_[k];
      const Closed    &closed    = interface.ways[ways[k]];
      const double     factor    = 1. + 2. * closed.time / dt;
      for (unsigned int i = 0; i < interface.motions.size(); ++i)
        for (unsigned int j = 0; j < interface.motions.size(); ++j)
          matrix(interface.motions[i], interface.motions[j]) += factor * closed.matrix(i, j);
    }
}

CoupledModes::Ways CoupledModes::find_worst(const double dt) const
{
  constexpr unsigned int n_rounds = 6, n_steps = 8;
  const std::size_t      n = free_.size();
  Matrix                 matrix;
  Vector                 x(n), y(n), part, product;
  double                 fastest = 0.;
  Ways                   ways(interfaces_.size(), 0), worst(ways);
  for (unsigned int start = 0; start < n_directions; start += 2) // every other one suffices
    {
      for (std::size_t k = 0; k < ways.size(); ++k)
        ways[k] = start % interfaces_[k].ways.size();
      for (std::size_t i = 0; i < n; ++i)
        x[i] = std::sin(1. + 12.9898 * double(i) * double(i));
      x /= x.l2_norm();
      double value = 0.;
      for (unsigned int round = 0; round < n_rounds; ++round)
        {
          assemble(ways, dt, matrix);
          for (unsigned int step = 0; step < n_steps; ++step)
            {
              multiply(matrix, x, y);
              value = x * y;
              x.equ(1. / y.l2_norm(), y);
            }
          if (value > fastest)
            {
              fastest = value;
              worst   = ways;
            }
          for (std::size_t k = 0; k < ways.size(); ++k)
            {
              const Interface &interface = interfaces_[k];
              part.reinit(interface.motions.size());
              product.reinit(interface.motions.size());
              for (unsigned int i = 0; i < interface.motions.size(); ++i)
                part[i] = x[interface.motions[i]];
              double most = -1.;
              for (unsigned int w = 0; w < interface.ways.size(); ++w)
                {
                  multiply(interface.ways[w].matrix, part, product);
                  const double quotient =
                      (1. + 2. * interface.ways[w].time / dt) * (product * part);
                  if (quotient > most)
                    {
                      most    = quotient;
                      ways[k] = w;
                    }
                }
            }
        }
    }
  return worst;
}

double CoupledModes::eigenvalue(const Ways &ways, const double dt) const
{
  Matrix matrix;
  assemble(ways, dt, matrix);
  return largest_eigenvalue(matrix.m(),
                            [&](auto &product, const auto &x) { multiply(matrix, x, product); });
}

double CoupledModes::free_step() const
{
  return 2. / std::sqrt(*std::max_element(free_.begin(), free_.end()));
}

double CoupledModes::critical_time_step() const
{
  double time = 0.;
  for (const Interface &interface : interfaces_)
    for (const Closed &closed : interface.ways)
      time = std::max(time, closed.time);
  const Ways       worst           = find_worst(free_step());
  constexpr double without_dampers = 1e300;
  const double     springs         = eigenvalue(worst, without_dampers);
  // from a safe step to a larger one that is safe too, since the dampers soften as it grows
  double step = critical_time_step_of(springs, springs * time);
  for (double before = 0.; step > 1.0001 * before;)
    {
      before = step;
      step   = 2. / std::sqrt(eigenvalue(worst, step));
    }
  return step;
}
} // namespace chaindrive::stability
