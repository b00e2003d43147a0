// SPDX-License-Identifier: LGPL-2.1-or-later
// What is looked at of elastic joints: of class NodeBores.
#include <chaindrive/contact/cylinder_patches.h>
#include <chaindrive/contact/node_bores.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::contact
{
namespace
{
using dealii::numbers::PI;

constexpr double ring_tolerance = 1e-9; // m, of rings

/// A vertex of a side in the part's frame, on the exact cylinder, m.
dealii::Tensor<1, 3> at_angle(const mesh::CylinderGrid &grid, const double angle, const double z)
{
  return dealii::Tensor<1, 3>({grid.axis[0] + grid.radius * std::cos(angle),
                               grid.axis[1] + grid.radius * std::sin(angle),
                               z});
}

/// Where a point near a cylindrical side, in the part's frame, is on it.
struct PlaceOnSide
{
  /// With columns that are equally far apart, as those of joints are; @p x counts as between @p low
  /// and @p high along the axis [m].
  PlaceOnSide(const mesh::CylinderGrid   &grid,
              const dealii::Tensor<1, 3> &x,
              const double                low,
              const double                high)
      : angle(std::atan2(x[1] - grid.axis[1], x[0] - grid.axis[0]))
  {
    const unsigned int n   = grid.n_circumferential();
    const double       way = (angle - grid.angles[0]) * n / (2. * PI), before = std::floor(way);
    const auto   column = static_cast<unsigned int>(static_cast<int>(before) + static_cast<int>(n));
    const double z      = std::clamp(x[2], low, high);
    unsigned int ring   = 0;
    while (ring + 2 < grid.n_rings() && grid.rings[ring + 1] < z)
      ++ring;
    const double up = (z - grid.rings[ring]) / (grid.rings[ring + 1] - grid.rings[ring]);
    for (unsigned int q = 0; q < 4; ++q)
      {
        vertex[q] = (ring + q / 2) * n + (column + q % 2) % n;
        weight[q] = (q / 2 == 0 ? 1. - up : up) * (q % 2 == 0 ? 1. - way + before : way - before);
      }
  }

  double                      angle;  ///< about the axis, rad
  std::array<unsigned int, 4> vertex; ///< [ring][column], about it
  std::array<double, 4>       weight; ///< sum 1
};
} // namespace

std::array<dealii::Point<3>, 4> corners_of_piece(const mesh::CylinderGrid    &grid,
                                                 const unsigned int           ring,
                                                 const unsigned int           column,
                                                 const Frame                 &frame,
                                                 const std::array<double, 2> &ends)
{
  const unsigned int n      = grid.n_circumferential();
  const auto         middle = [&](const unsigned int first) { // between this column and the next
    const double next = first + 1 < n ? grid.angles[first + 1] : grid.angles[0] + 2. * PI;
    return 0.5 * (grid.angles[first] + next);
  };
  const double angle[2] = {column > 0 ? middle(column - 1) : middle(n - 1) - 2. * PI,
                           middle(column)};
  const double here = grid.rings[ring];
  const double z[2] = {
      std::max(ends[0], ring > 0 ? 0.5 * (grid.rings[ring - 1] + here) : here),
      std::min(ends[1], ring + 1 < grid.n_rings() ? 0.5 * (here + grid.rings[ring + 1]) : here)};
  std::array<dealii::Point<3>, 4> corners;
  for (unsigned int c = 0; c < 4; ++c)
    corners[c] = dealii::Point<3>(
        frame.position + frame.rotation * at_angle(grid, angle[c == 1 || c == 2], z[c / 2]));
  return corners;
}

NodeBores::InBore NodeBores::in_bore(const World       &world,
                                     const Group       &group,
                                     const unsigned int pair,
                                     const unsigned int node) const
{
  const mesh::CylinderGrid &bore = (*group.grids)[0], &cylinder = (*group.grids)[1];
  const unsigned int        columns = cylinder.n_circumferential();
  const Frame              &master  = world.frames[records_[pair].master],
              &slave                = world.frames[records_[pair].slave];
  const dealii::Tensor<1, 3> x =
      transpose(master.rotation) *
      (slave.position - master.position +
       slave.rotation *
           at_angle(cylinder, cylinder.angles[node % columns], cylinder.rings[node / columns]));
  const PlaceOnSide place(bore, x, bore.rings.front(), bore.rings.back());
  const auto        in_world = [&](const double a, const double b, const double c) {
    return master.rotation * dealii::Tensor<1, 3>({a, b, c});
  };
  const double cosine = std::cos(place.angle), sine = std::sin(place.angle);
  return {in_world(cosine, sine, 0.),
          in_world(-sine, cosine, 0.),
          in_world(0., 0., 1.),
          place.vertex,
          place.weight};
}

void NodeBores::raise_pressures(std::vector<double> &largest) const
{
  for_each_touching(
      [&](const Group &, const unsigned int pair, const JointBatch::TouchingNode &at) {
        double &of_joint = largest[records_[pair].joint];
        of_joint         = std::max(of_joint, at.pressure);
      });
}

void NodeBores::add_pressures(const World &world, std::vector<NodePressure> &pressures) const
{
  for (const Group &group : groups_)
    for (unsigned int i = 0; i < group.pairs.size(); ++i)
      {
        const unsigned int  pair = group.pairs[i];
        std::vector<double> on_cylinder((*group.grids)[1].vertex.size(), 0.);
        bool                touches = false;
        group.batches[i / n_lanes]->for_each_touching(
            i % n_lanes, [&](const JointBatch::TouchingNode &at) {
              touches              = true;
              on_cylinder[at.node] = at.pressure;
              pressures.push_back(
                  {records_[pair].slave, group.sides[1].node[at.node], at.pressure});
            });
        if (touches)
          add_bore_pressures(world, group, pair, on_cylinder, pressures);
      }
}

void NodeBores::add_bore_pressures(const World               &world,
                                   const Group               &group,
                                   const unsigned int         pair,
                                   const std::vector<double> &on_cylinder,
                                   std::vector<NodePressure> &pressures) const
{
  const mesh::CylinderGrid &bore = (*group.grids)[0], &cylinder = (*group.grids)[1];
  const Frame              &master = world.frames[records_[pair].master],
              &slave               = world.frames[records_[pair].slave];
  // beyond the last ring that is inside there is no pressure to look at
  std::vector<double> inside;
  for (const double z : cylinder.rings)
    if (z >= bore.rings.front() - ring_tolerance && z <= bore.rings.back() + ring_tolerance)
      inside.push_back(z);
  if (inside.empty())
    return;
  const unsigned int n = bore.n_circumferential();
  for (unsigned int node = 0; node < bore.vertex.size(); ++node)
    {
      const dealii::Tensor<1, 3> x =
          transpose(slave.rotation) *
          (master.position - slave.position +
           master.rotation * at_angle(bore, bore.angles[node % n], bore.rings[node / n]));
      const PlaceOnSide place(cylinder, x, inside.front(), inside.back());
      double            pressure = 0.;
      for (unsigned int q = 0; q < 4; ++q)
        pressure += place.weight[q] * on_cylinder[place.vertex[q]];
      if (pressure > 0.)
        pressures.push_back({records_[pair].master, group.sides[0].node[node], pressure});
    }
}

void NodeBores::add_patches(const World &world, std::vector<PressurePatch> &patches) const
{
  for_each_touching(
      [&](const Group &group, const unsigned int pair, const JointBatch::TouchingNode &at) {
        const mesh::CylinderGrid &bore = (*group.grids)[0], &cylinder = (*group.grids)[1];
        const unsigned int        n = cylinder.n_circumferential();
        patches.push_back({records_[pair].slave,
                           records_[pair].master,
                           records_[pair].joint,
                           corners_of_piece(cylinder,
                                            at.node / n,
                                            at.node % n,
                                            world.frames[records_[pair].slave],
                                            {{bore.rings.front(), bore.rings.back()}}),
                           at.normal,
                           at.pressure});
      });
}

void NodeBores::add_massless_forces(const World &world, std::vector<NodeForce> &forces) const
{
  for_each_touching(
      [&](const Group &group, const unsigned int pair, const JointBatch::TouchingNode &at) {
        if (!group.flexibility)
          return;
        const InBore               in = in_bore(world, group, pair, at.node);
        const dealii::Tensor<1, 3> force =
            -at.normal * in.e + at.tangential[0] * in.round + at.tangential[1] * in.along;
        forces.push_back({records_[pair].slave, group.sides[1].node[at.node], force});
        for (unsigned int q = 0; q < 4; ++q)
          forces.push_back(
              {records_[pair].master, group.sides[0].node[in.place[q]], -in.weight[q] * force});
      });
}
} // namespace chaindrive::contact
