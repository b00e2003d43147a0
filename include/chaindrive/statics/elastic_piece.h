// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/material/material.h>

#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace chaindrive::statics
{
/// Boundary ids of planes of symmetry, after those of mesh::Surface.
enum Plane : dealii::types::boundary_id
{
  plane_x = 100, ///< x = 0, where u_x = 0
  plane_y,
  plane_z
};

/// What symmetry leaves of a part, as a coarse mesh that knows its curved sides.
struct Piece
{
  std::string                               name;
  std::unique_ptr<dealii::Triangulation<3>> mesh;

  std::set<dealii::types::boundary_id> held; ///< sides on which nothing moves

  /// A direction in which nothing holds the piece: it is then in equilibrium by its inertia, and
  /// displacements are those relative to its centre of mass.
  std::optional<unsigned int> free;

  /// Displacements on the two sides of the plane z = 0 are the opposite of mirror images, as those
  /// of a link are that is bent about y: there u_x = u_y = 0.
  bool odd_in_z = false;
};

/// Linear elastostatics of a Piece: quadratic hexahedra on a mesh that is distributed by p4est over
/// the ranks and refined where the estimated error is, CG with algebraic multigrid. Small
/// displacements, Hooke's law.
class ElasticPiece
{
public:
  using Vector = dealii::TrilinosWrappers::MPI::Vector;

  /// Cells to refine, one set after the other; each rank has its own.
  using Refinements = std::vector<std::set<dealii::CellId>>;

  /// The mesh is that of @p piece with those @p refinements.
  ElasticPiece(const Piece       &piece,
               const Material    &material,
               MPI_Comm           comm,
               const Refinements &refinements = {});

  unsigned long n_cells() const { return mesh_.n_global_active_cells(); }
  unsigned long n_unknowns() const { return dofs_.n_dofs(); }

  /// Where a pressure acts on the side @p side: the number of the patch at a point, which need not
  /// follow the mesh, or none.
  struct Patches
  {
    static constexpr unsigned int none = static_cast<unsigned int>(-1);

    std::set<dealii::types::boundary_id>                          sides;
    unsigned int                                                  n;
    std::function<unsigned int(const dealii::Point<3> &)>         number;
    std::function<dealii::Tensor<1, 3>(const dealii::Point<3> &)> direction; ///< of the load, unit
  };

  /// Forces of one newton on each of the @p patches, evenly over its area.
  std::vector<Vector> loads(const Patches &patches) const;

  /// Area of each patch, m2, of the last loads().
  const std::vector<double> &areas() const { return areas_; }

  /// The displacement under the @p load. Of a piece that is free, the load is first balanced by its
  /// inertia.
  Vector solve(const Vector &load) const;

  /// The displacement in the sense of @p load, m: of its patch on the average.
  double displacement(const Vector &u, const Vector &load) const;

  /// The largest principal stress on the side @p side, Pa.
  double largest_stress(const Vector &u, dealii::types::boundary_id side) const;

  /// The @p fraction of cells with the largest estimated error in @p u (Kelly et al. 1983): a
  /// further refinement.
  std::set<dealii::CellId> worst_cells(const Vector &u, double fraction);

  unsigned int iterations() const { return iterations_; } ///< of CG, in all solutions

  const dealii::DoFHandler<3> &dofs() const { return dofs_; }
  const dealii::MappingQ<3>   &mapping() const { return mapping_; }
  const Material              &material() const { return material_; }
  Vector                       ghosted(const Vector &u) const;

private:
  void assemble();
  void constrain(dealii::AffineConstraints<double> &constraints) const;

  const Piece   &piece_;
  const Material material_;
  const MPI_Comm comm_;

  dealii::parallel::distributed::Triangulation<3> mesh_;
  const dealii::MappingQ<3>                       mapping_;
  const dealii::FESystem<3>                       element_;
  dealii::DoFHandler<3>                           dofs_;
  dealii::IndexSet                                owned_, relevant_;
  dealii::AffineConstraints<double>               constraints_;
  dealii::TrilinosWrappers::SparseMatrix          matrix_;
  dealii::TrilinosWrappers::PreconditionAMG       preconditioner_;
  Vector                      inertia_; ///< a unit acceleration's force, 1/volume
  mutable std::vector<double> areas_;
  mutable unsigned int        iterations_ = 0;
};
} // namespace chaindrive::statics
