// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/material/material.h>
#include <chaindrive/mesh/part.h>

#include <ostream>
#include <string>
#include <vector>

namespace chaindrive::element
{
/// What a user should know about a mesh before trusting it.
struct PartReport
{
  std::string  name;
  unsigned int n_cells, n_elastic_cells, n_vertices;
  double       smallest_edge;   ///< of elastic cells, m
  double       scaled_jacobian; ///< worst corner: determinant of its unit edges, 1 for a brick
  double       aspect_ratio;    ///< worst elastic cell: longest / shortest edge

  double               exact_mass;    ///< of the solid, kg
  double               mass_error;    ///< of the mesh with its density factors, relative
  dealii::Tensor<1, 3> exact_inertia; ///< of the solid about x, y and z, kg m2
  dealii::Tensor<1, 3> meshed_error;  ///< of the mesh's inertia, relative
  dealii::Tensor<1, 3> lumped_error;  ///< of the inertia of the lumped masses, relative

  /// 2 / (largest natural frequency of a single elastic cell), s: a step below it is stable for the
  /// whole mesh. Of the fully integrated trilinear element with lumped masses.
  double       critical_time_step;
  unsigned int n_distinct_cells; ///< of elastic cells that differ by more than a motion

  struct Factor
  {
    std::string component;
    double      density_factor;
  };
  std::vector<Factor> factors;

  struct Side
  {
    std::string  name;
    unsigned int n_faces;
    double       area; ///< m2
  };
  std::vector<Side> sides; ///< named surfaces
};

PartReport make_report(const mesh::Part &part, const Material &material);

/// Prints a table for people, a line for each part: smallest edge, worst scaled Jacobian and aspect
/// ratio, error of the mesh's mass, largest error of the lumped masses' inertia, critical time
/// step.
void print(std::ostream &out, const std::vector<PartReport> &reports);
} // namespace chaindrive::element
