// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/surface/cylinder_grid.h>
#include <chaindrive/mesh/surface/surface_nodes.h>
#include <chaindrive/reduction/tractions.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::reduction
{
namespace
{
using dealii::numbers::PI;

/// A cylindrical side that touches another part.
struct Side
{
  mesh::Surface surface;
  bool          of_pin;
  unsigned int  power;  ///< highest of zeta: a pin bends, and presses on the ends of its bush
  double        pulled; ///< angle of the middle of the pressure when the chain is pulled, rad
  int           joint;  ///< of a link, 0 or 1; none: -1
};

/// The two joints of a link one after the other.
constexpr Side all_sides[] = {{mesh::roller_outside, false, 2, 0., -1},
                              {mesh::roller_bore, false, 2, 0., -1},
                              {mesh::bush_outside_first, false, 2, PI, 0},
                              {mesh::bush_outside_second, false, 2, 0., 1},
                              {mesh::bush_bore_first, false, 4, PI, 0},
                              {mesh::bush_bore_second, false, 4, 0., 1},
                              {mesh::pin_outside_first, true, 6, 0., 0},
                              {mesh::pin_outside_second, true, 6, PI, 1}};

bool has(const mesh::Part &part, const mesh::Surface surface)
{
  const auto ids = part.mesh->get_boundary_ids();
  return std::find(ids.begin(), ids.end(), surface) != ids.end();
}

/// Pressure or friction over the angle about the axis [rad] and zeta.
using Traction = std::function<double(double theta, double zeta)>;

/// Where forces on a side point.
enum class Towards
{
  outside, ///< away from its axis
  around   ///< along its circumference, as friction of turning joints
};

/// Adds the forces of a @p traction on a side.
void add(const mesh::CylinderGrid &grid,
         const mesh::Nodes        &nodes,
         const Traction           &traction,
         Vector                   &force,
         const Towards             towards = Towards::outside)
{
  const double length = std::max(std::abs(grid.rings.front()), std::abs(grid.rings.back()));
  for (unsigned int s = 0; s < grid.n_rings(); ++s)
    for (unsigned int c = 0; c < grid.n_circumferential(); ++c)
      {
        const unsigned int node  = nodes.of_vertex[grid.vertex_at(s, c)];
        const double       theta = grid.angles[c];
        const double       f     = grid.area(s, c) * traction(theta, grid.rings[s] / length);
        const double       x = std::cos(theta), y = std::sin(theta);
        force[3 * node] += f * (towards == Towards::outside ? x : -y);
        force[3 * node + 1] += f * (towards == Towards::outside ? y : x);
      }
}

/// Adds to @p forces those of even pressures on flat faces of plates: see tractions().
void add_on_faces(const mesh::Part &part, const mesh::Nodes &nodes, std::vector<Vector> &forces)
{
  const bool          inner = has(part, mesh::bush_outside_first);
  const mesh::Surface about_joints =
      inner ? mesh::plate_outer_faces : mesh::plate_inner_faces; // what touches the next plate
  const auto press = [&](const mesh::Surface surface, const auto &is_pressed) {
    const mesh::SurfaceNodes side(part, nodes, surface);
    double                   length = 0., radius = 0.; // of a plate with round ends
    for (const unsigned int node : side.node)
      {
        length = std::max(length, nodes.position[node][0]);
        radius = std::max(radius, nodes.position[node][1]);
      }
    Vector force(3 * nodes.size());
    for (unsigned int s = 0; s < side.size(); ++s)
      if (is_pressed(nodes.position[side.node[s]], length - radius, radius))
        force[3 * side.node[s] + 2] = side.area[s];
    if (force.l2_norm() > 0.)
      forces.push_back(force);
  };
  for (const double upper : {-1., 1.})
    for (const double second : {-1., 1.})
      {
        press(about_joints, [&](const dealii::Point<3> &x, const double hole, const double radius) {
          return upper * x[2] > 0. && std::hypot(x[0] - second * hole, x[1]) < 1.01 * radius;
        });
        if (inner)
          press(mesh::plate_inner_faces,
                [&](const dealii::Point<3> &x, const double hole, const double) {
                  return upper * x[2] > 0. && second * x[1] > 0. && std::abs(x[0]) < 0.25 * hole;
                });
      }
}
} // namespace

std::vector<mesh::Surface> joint_sides(const mesh::Part &part)
{
  std::vector<mesh::Surface> sides;
  for (const Side &side : all_sides)
    if (has(part, side.surface) && side.surface != mesh::roller_outside)
      sides.push_back(side.surface);
  return sides;
}

std::vector<Vector>
tractions(const mesh::Part &part, const mesh::Nodes &nodes, const Orders &orders)
{
  std::vector<Vector> forces;
  for (const Side &side : all_sides)
    {
      if (!has(part, side.surface))
        continue;
      const mesh::CylinderGrid grid(part, side.surface);
      const unsigned int       highest =
          std::min(side.of_pin ? orders.pin : orders.tube, (grid.n_circumferential() - 1) / 2);
      const bool pressed =
          side.surface == mesh::roller_outside ? orders.on_teeth : orders.in_joints;
      for (unsigned int power = 0; pressed && power <= side.power; power += part.half ? 2 : 1)
        for (unsigned int n = 0; n <= highest; ++n)
          for (const bool sine : {false, true})
            {
              if (sine && n == 0)
                continue;
              forces.emplace_back(3 * nodes.size());
              add(
                  grid,
                  nodes,
                  [&](const double theta, const double zeta) {
                    return std::pow(zeta, power) *
                           (sine ? std::sin(n * theta) : std::cos(n * theta));
                  },
                  forces.back());
            }
      if (side.joint >= 0)
        for (unsigned int power = 0; power <= (part.half ? 0 : 1); ++power)
          {
            forces.emplace_back(3 * nodes.size());
            add(
                grid,
                nodes,
                [power](double, const double zeta) { return std::pow(zeta, power); },
                forces.back(),
                Towards::around);
          }
    }
  if (orders.on_faces && has(part, mesh::plate_inner_faces))
    add_on_faces(part, nodes, forces);
  return forces;
}

std::vector<Load> contact_loads(const mesh::Part &part, const mesh::Nodes &nodes)
{
  const auto pressed = [](const double angle) {
    return [angle](const double theta, double) { return std::max(0., std::cos(theta - angle)); };
  };
  const auto ends = [](const double angle) {
    return [angle](const double theta, const double zeta) {
      const double beyond = std::abs(zeta) - 0.5; // a node on the border is half in it
      const double share  = beyond > 1e-9 ? 1. : beyond > -1e-9 ? 0.5 : 0.;
      return share * std::max(0., std::cos(theta - angle));
    };
  };
  const auto patch = [](const double angle) {
    return [angle](const double theta, double) {
      return std::cos(theta - angle) > std::cos(PI / 8.) - 1e-9 ? 1. : 0.;
    };
  };

  std::vector<Load> loads;
  for (const Side &side : all_sides)
    {
      if (!has(part, side.surface))
        continue;
      const mesh::CylinderGrid grid(part, side.surface);
      const auto               begin = [&](const std::string &what) -> Vector               &{
        loads.push_back(
            {what + " of " + mesh::surface_name(side.surface), Vector(3 * nodes.size())});
        return loads.back().force;
      };
      const auto pull = [&](const std::string &what, const auto &pressure) {
        Vector &force = begin(what);
        add(grid, nodes, pressure(side.pulled), force);
        if (side.joint == 0)
          {
            const Side &other = (&side)[1];
            add(mesh::CylinderGrid(part, other.surface), nodes, pressure(other.pulled), force);
          }
      };
      if (side.joint == 1)
        continue;
      pull("pull", pressed);
      pull("pull at the ends", ends);
      add(grid, nodes, pressed(0.5 * PI), begin("side"));
      add(grid, nodes, patch(0.), begin("patch along"));
      add(grid, nodes, patch(0.5 * PI), begin("patch across"));
      if (side.joint == 0)
        add(
            grid, nodes, [](double, double) { return 1.; }, begin("turn"), Towards::around);
    }
  return loads;
}
} // namespace chaindrive::reduction
