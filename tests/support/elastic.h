// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// A batch of copies of a part, and parts of simple shapes, for the tests of elements.

#include <chaindrive/element/hexahedra.h>
#include <chaindrive/utilities/errors.h>

#include <deal.II/base/aligned_vector.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <array>
#include <cmath>
#include <functional>
#include <iomanip>
#include <iostream>
#include <memory>
#include <random>
#include <string>

namespace test
{
using namespace chaindrive;
using dealii::Point;
using dealii::Tensor;
using element::Formulation;
using element::Hexahedra;

inline const std::array<std::pair<Formulation, std::string>, 3> formulations{
    {{Formulation::one_point, "one point"},
     {Formulation::enhanced, "enhanced"},
     {Formulation::full, "full"}}};

/// A kind of elements: those of formulations, solid-shells and membranes.
struct Kind
{
  Formulation             formulation;
  std::string             name;
  parameters::ElementType element_type = parameters::ElementType::solid;
};

inline const std::array<Kind, 5> kinds{
    {{Formulation::one_point, "one point"},
     {Formulation::enhanced, "enhanced"},
     {Formulation::full, "full"},
     {Formulation::enhanced, "solid-shell", parameters::ElementType::solid_shell},
     {Formulation::enhanced, "membrane", parameters::ElementType::membrane}}};

/// Direction across the walls of a ring about the z axis, and of a plate.
inline Tensor<1, 3> across_ring(const Point<3> &x) { return Point<3>(x[0], x[1], 0.); }
inline Tensor<1, 3> across_plate(const Point<3> &) { return Point<3>(0., 0., 1.); }

/// Elements of a @p kind.
inline Hexahedra elements_of(const mesh::Part    &part,
                             const Material      &material,
                             const Kind          &kind,
                             const element::Shape most_regular = element::Shape::symmetric_prism,
                             Tensor<1, 3> (*across)(const Point<3> &) = across_ring)
{
  element::Selection all;
  all.element_type = kind.element_type;
  all.across       = across;
  return Hexahedra(part, material, kind.formulation, 0.1, most_regular, all);
}

/// A part of the material of section Material with the mesh that @p make fills.
inline mesh::Part part(const std::function<void(dealii::Triangulation<3> &)> &make)
{
  mesh::Part part;
  part.name    = "test part";
  part.density = Material().density;
  part.mesh    = std::make_unique<dealii::Triangulation<3>>();
  make(*part.mesh);
  return part;
}

/// A brick from the origin to @p size [m] of cells[0] x cells[1] x cells[2] cells.
inline mesh::Part brick(const Point<3> &size, const std::vector<unsigned int> &cells)
{
  return part([&](dealii::Triangulation<3> &mesh) {
    dealii::GridGenerator::subdivided_hyper_rectangle(mesh, cells, Point<3>(), size);
  });
}

/// n_lanes copies of a part in the layout of the kernels.
class Batch
{
public:
  Batch(const Hexahedra &reference, const element::Kernels &kernels)
      : kernels(kernels), reference(reference)
  {
    const unsigned int n = 3 * reference.n_nodes() * n_lanes;
    position.resize(n, 0.);
    velocity.resize(n, 0.);
    force.resize(n, 0.);
    energy.resize(9 * n_lanes, 0.); // and two sums of vectors
    for (int lane = 0; lane < n_lanes; ++lane)
      set(position, lane, [](const Point<3> &x, unsigned int) { return Tensor<1, 3>(x); });
  }

  static unsigned int index(const unsigned int node, const unsigned int i, const unsigned int lane)
  {
    return (3 * node + i) * n_lanes + lane;
  }

  /// Sets the values of one lane from a field of the reference position.
  void set(dealii::AlignedVector<double>                                 &values,
           const unsigned int                                             lane,
           const std::function<Tensor<1, 3>(const Point<3> &, unsigned)> &field) const
  {
    for (unsigned int node = 0; node < reference.n_nodes(); ++node)
      {
        const Tensor<1, 3> value = field(reference.position[node], node);
        for (unsigned int i = 0; i < 3; ++i)
          values[index(node, i, lane)] = value[i];
      }
  }

  Tensor<1, 3> get(const dealii::AlignedVector<double> &values,
                   const unsigned int                   node,
                   const unsigned int                   lane) const
  {
    Tensor<1, 3> value;
    for (unsigned int i = 0; i < 3; ++i)
      value[i] = values[index(node, i, lane)];
    return value;
  }

  void add_internal_forces()
  {
    energy.fill(0.);
    element::ForceArguments arg = reference.arguments();
    arg.position                = position.data();
    arg.force                   = force.data();
    arg.strain_energy           = energy.data();
    arg.hourglass_energy        = energy.data() + n_lanes;
    kernels.add_internal_forces[static_cast<int>(reference.formulation)](arg);
  }

  /// One step; velocities are half a step behind.
  void step(const double dt, const std::function<void(Batch &)> &constrain = {})
  {
    add_internal_forces();
    if (constrain)
      constrain(*this);
    update(dt);
  }

  /// The second half of a step, once all forces are there; @p drag as in UpdateArguments, 1/s.
  void update(const double dt, const double drag = 0.)
  {
    kernels.update({reference.n_nodes(),
                    dt,
                    dt,
                    {0., 0., 0.},
                    drag,
                    reference.mass.data(),
                    position.data(),
                    velocity.data(),
                    force.data(),
                    energy.data() + 2 * n_lanes,
                    energy.data() + 3 * n_lanes,
                    energy.data() + 6 * n_lanes});
  }

  double strain_energy(const unsigned int lane) const { return energy[lane]; }
  double hourglass_energy(const unsigned int lane) const { return energy[n_lanes + lane]; }
  double kinetic_energy(const unsigned int lane) const { return energy[2 * n_lanes + lane]; }
  double total_energy(const unsigned int lane) const
  {
    return strain_energy(lane) + hourglass_energy(lane) + kinetic_energy(lane);
  }

  const element::Kernels       &kernels;
  const Hexahedra              &reference;
  dealii::AlignedVector<double> position, velocity, force, energy;
};

/// Turns by @p angle about the axis (1, 2, 3).
inline Tensor<2, 3> turn(const double angle)
{
  Tensor<1, 3> axis;
  axis[0]        = 1. / std::sqrt(14.);
  axis[1]        = 2. / std::sqrt(14.);
  axis[2]        = 3. / std::sqrt(14.);
  const double c = std::cos(angle), s = std::sin(angle);
  Tensor<2, 3> r;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      r[i][j] = (i == j ? c : 0.) + (1. - c) * axis[i] * axis[j];
  r[0][1] -= s * axis[2];
  r[0][2] += s * axis[1];
  r[1][0] += s * axis[2];
  r[1][2] -= s * axis[0];
  r[2][0] -= s * axis[1];
  r[2][1] += s * axis[0];
  return r;
}

/// A ring that is swept along z: cells through the wall, around and along.
inline mesh::Part ring(const double                       inner,
                       const double                       outer,
                       const double                       length,
                       const std::array<unsigned int, 3> &cells)
{
  return part([&](dealii::Triangulation<3> &mesh) {
    dealii::Triangulation<2>         section;
    std::vector<Point<2>>            points;
    std::vector<dealii::CellData<2>> quads;
    for (unsigned int k = 0; k < cells[1]; ++k)
      for (unsigned int w = 0; w <= cells[0]; ++w)
        {
          const double angle = 2. * dealii::numbers::PI * k / cells[1];
          const double r     = inner + (outer - inner) * w / cells[0];
          points.emplace_back(r * std::cos(angle), r * std::sin(angle));
        }
    for (unsigned int k = 0; k < cells[1]; ++k)
      for (unsigned int w = 0; w < cells[0]; ++w)
        {
          const unsigned int here = k * (cells[0] + 1) + w,
                             next = (k + 1) % cells[1] * (cells[0] + 1) + w;
          dealii::CellData<2> quad;
          quad.vertices = {here, here + 1, next, next + 1};
          quads.push_back(quad);
        }
    section.create_triangulation(points, quads, {});
    dealii::GridGenerator::extrude_triangulation(section, cells[2] + 1, length, mesh);
  });
}
} // namespace test
