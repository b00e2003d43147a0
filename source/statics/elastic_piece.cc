// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/statics/elastic_piece.h>
#include <chaindrive/utilities/errors.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/distributed/grid_refinement.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>
#include <deal.II/lac/trilinos_solver.h>
#include <deal.II/numerics/error_estimator.h>
#include <deal.II/numerics/vector_tools.h>

#include <cmath>

namespace chaindrive::statics
{
namespace
{
constexpr unsigned int degree = 2;
} // namespace

ElasticPiece::ElasticPiece(const Piece       &piece,
                           const Material    &material,
                           const MPI_Comm     comm,
                           const Refinements &refinements)
    : piece_(piece)
    , material_(material)
    , comm_(comm)
    , mesh_(comm)
    , mapping_(degree)
    , element_(dealii::FE_Q<3>(degree), 3)
    , dofs_(mesh_)
{
  mesh_.copy_triangulation(*piece.mesh);
  for (const std::set<dealii::CellId> &chosen : refinements)
    {
      for (const auto &cell : mesh_.active_cell_iterators())
        if (cell->is_locally_owned() && chosen.count(cell->id()) > 0)
          cell->set_refine_flag();
      mesh_.execute_coarsening_and_refinement();
    }
  assemble();
}

void ElasticPiece::constrain(dealii::AffineConstraints<double> &constraints) const
{
  const dealii::Functions::ZeroFunction<3> zero(3);
  for (unsigned int d = 0; d < 3; ++d)
    {
      std::vector<bool> zero_there(3);
      for (unsigned int c = 0; c < 3; ++c)
        zero_there[c] = (c == d) != (d == 2 && piece_.odd_in_z);
      dealii::VectorTools::interpolate_boundary_values(
          mapping_,
          dofs_,
          static_cast<dealii::types::boundary_id>(plane_x + d),
          zero,
          constraints,
          dealii::ComponentMask(zero_there));
    }
  for (const dealii::types::boundary_id side : piece_.held)
    dealii::VectorTools::interpolate_boundary_values(mapping_, dofs_, side, zero, constraints);
}

void ElasticPiece::assemble()
{
  dofs_.distribute_dofs(element_);
  owned_ = dofs_.locally_owned_dofs();
  dealii::DoFTools::extract_locally_relevant_dofs(dofs_, relevant_);
  constraints_.clear();
  constraints_.reinit(relevant_);
  dealii::DoFTools::make_hanging_node_constraints(dofs_, constraints_);
  constrain(constraints_);
  constraints_.close();

  dealii::TrilinosWrappers::SparsityPattern pattern(owned_, owned_, relevant_, comm_);
  dealii::DoFTools::make_sparsity_pattern(
      dofs_, pattern, constraints_, false, dealii::Utilities::MPI::this_mpi_process(comm_));
  pattern.compress();
  matrix_.reinit(pattern);
  inertia_.reinit(owned_, comm_);

  const dealii::QGauss<3>                      quadrature(degree + 1);
  dealii::FEValues<3>                          values(mapping_,
                             element_,
                             quadrature,
                             dealii::update_values | dealii::update_gradients |
                                 dealii::update_JxW_values);
  const unsigned int                           n = element_.n_dofs_per_cell();
  dealii::FullMatrix<double>                   local(n, n);
  dealii::Vector<double>                       local_inertia(n);
  std::vector<dealii::types::global_dof_index> indices(n);
  std::vector<unsigned int>                    component(n);
  for (unsigned int i = 0; i < n; ++i)
    component[i] = element_.system_to_component_index(i).first;
  const double lambda = material_.lambda(), mu = material_.mu();
  double       volume = 0.;
  for (const auto &cell : dofs_.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        values.reinit(cell);
        local         = 0.;
        local_inertia = 0.;
        for (const unsigned int q : values.quadrature_point_indices())
          {
            const double w = values.JxW(q);
            volume += w;
            for (unsigned int i = 0; i < n; ++i)
              {
                const dealii::Tensor<1, 3> &a = values.shape_grad(i, q);
                const unsigned int          c = component[i];
                for (unsigned int j = 0; j <= i; ++j)
                  {
                    const dealii::Tensor<1, 3> &b = values.shape_grad(j, q);
                    const unsigned int          d = component[j];
                    // e(u):C:e(v) of single components
                    double energy = lambda * a[c] * b[d] + mu * a[d] * b[c];
                    if (c == d)
                      energy += mu * (a * b);
                    local(i, j) += energy * w;
                  }
                if (piece_.free && c == *piece_.free)
                  local_inertia[i] += values.shape_value(i, q) * w;
              }
          }
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = i + 1; j < n; ++j)
            local(i, j) = local(j, i);
        cell->get_dof_indices(indices);
        constraints_.distribute_local_to_global(local, local_inertia, indices, matrix_, inertia_);
      }
  if (piece_.free)
    {
      // A spring at any one vertex of the coarse mesh: loads are in equilibrium, it feels nothing.
      const dealii::Point<3>          corner = piece_.mesh->get_vertices().front();
      dealii::types::global_dof_index spring = dealii::numbers::invalid_dof_index;
      for (const auto &cell : dofs_.active_cell_iterators())
        if (cell->is_locally_owned())
          for (const unsigned int v : cell->vertex_indices())
            if (cell->vertex(v).distance(corner) < 1e-9 * cell->diameter() &&
                owned_.is_element(cell->vertex_dof_index(v, *piece_.free)))
              spring = cell->vertex_dof_index(v, *piece_.free);
      if (spring != dealii::numbers::invalid_dof_index)
        matrix_.add(spring, spring, material_.youngs_modulus * std::cbrt(volume));
    }
  matrix_.compress(dealii::VectorOperation::add);
  inertia_.compress(dealii::VectorOperation::add);
  inertia_ /= dealii::Utilities::MPI::sum(volume, comm_);

  dealii::TrilinosWrappers::PreconditionAMG::AdditionalData multigrid;
  dealii::DoFTools::extract_constant_modes(
      dofs_, dealii::ComponentMask(), multigrid.constant_modes);
  multigrid.elliptic              = true;
  multigrid.higher_order_elements = true;
  multigrid.smoother_sweeps       = 2;
  multigrid.aggregation_threshold = 0.02;
  preconditioner_.initialize(matrix_, multigrid);
}

std::vector<ElasticPiece::Vector> ElasticPiece::loads(const Patches &patches) const
{
  std::vector<Vector> result(patches.n);
  for (Vector &load : result)
    load.reinit(owned_, comm_);
  areas_.assign(patches.n, 0.);

  // patches need not follow the mesh: many points
  const dealii::QIterated<2>                     quadrature(dealii::QGauss<1>(2), 6);
  dealii::FEFaceValues<3>                        values(mapping_,
                                 element_,
                                 quadrature,
                                 dealii::update_values | dealii::update_quadrature_points |
                                     dealii::update_JxW_values);
  const unsigned int                             n = element_.n_dofs_per_cell();
  std::vector<dealii::types::global_dof_index>   indices(n);
  std::map<unsigned int, dealii::Vector<double>> local;
  for (const auto &cell : dofs_.active_cell_iterators())
    if (cell->is_locally_owned())
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary() && patches.sides.count(cell->face(f)->boundary_id()) > 0)
          {
            values.reinit(cell, f);
            local.clear();
            for (const unsigned int q : values.quadrature_point_indices())
              {
                const unsigned int p = patches.number(values.quadrature_point(q));
                if (p == Patches::none)
                  continue;
                areas_[p] += values.JxW(q);
                dealii::Vector<double> &force = local[p];
                if (force.size() == 0)
                  force.reinit(n);
                const dealii::Tensor<1, 3> pull =
                    values.JxW(q) * patches.direction(values.quadrature_point(q));
                for (unsigned int i = 0; i < n; ++i)
                  force[i] +=
                      values.shape_value(i, q) * pull[element_.system_to_component_index(i).first];
              }
            cell->get_dof_indices(indices);
            for (const auto &[p, force] : local)
              constraints_.distribute_local_to_global(force, indices, result[p]);
          }
  for (unsigned int p = 0; p < patches.n; ++p)
    {
      result[p].compress(dealii::VectorOperation::add);
      areas_[p] = dealii::Utilities::MPI::sum(areas_[p], comm_);
      if (areas_[p] > 0.)
        result[p] /= areas_[p];
    }
  return result;
}

ElasticPiece::Vector ElasticPiece::solve(const Vector &load) const
{
  Vector force(load);
  if (piece_.free)
    {
      // sum of the load along the free direction, with u = 1 there
      Vector     one(owned_, comm_);
      const auto mask = dealii::DoFTools::extract_dofs(
          dofs_, element_.component_mask(dealii::FEValuesExtractors::Scalar(*piece_.free)));
      for (const auto i : mask)
        one[i] = 1.;
      one.compress(dealii::VectorOperation::insert);
      force.add(-(one * load), inertia_);
    }
  for (const auto i : owned_)
    if (constraints_.is_constrained(i)) // their diagonals are any number, their solution is zero
      force[i] = 0.;
  force.compress(dealii::VectorOperation::insert);

  Vector                             u(owned_, comm_);
  dealii::SolverControl              control(500, 1e-7 * force.l2_norm());
  dealii::TrilinosWrappers::SolverCG solver(control);
  solver.solve(matrix_, u, force, preconditioner_);
  iterations_ += control.last_step();
  constraints_.distribute(u);
  if (piece_.free)
    {
      const double mean = u * inertia_;
      const auto   mask = dealii::DoFTools::extract_dofs(
          dofs_, element_.component_mask(dealii::FEValuesExtractors::Scalar(*piece_.free)));
      for (const auto i : mask)
        u[i] -= mean;
      u.compress(dealii::VectorOperation::add);
    }
  return u;
}

double ElasticPiece::displacement(const Vector &u, const Vector &load) const { return u * load; }

double ElasticPiece::largest_stress(const Vector &u, const dealii::types::boundary_id side) const
{
  const dealii::QIterated<2> nodes(dealii::QTrapezoid<1>(), 2 * degree);
  dealii::FEFaceValues<3>    values(mapping_, element_, nodes, dealii::update_gradients);
  const dealii::FEValuesExtractors::Vector   displacement(0);
  const Vector                               all = ghosted(u);
  std::vector<dealii::SymmetricTensor<2, 3>> strain(nodes.size());
  double                                     largest = 0.;
  for (const auto &cell : dofs_.active_cell_iterators())
    if (cell->is_locally_owned())
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary() && cell->face(f)->boundary_id() == side)
          {
            values.reinit(cell, f);
            values[displacement].get_function_symmetric_gradients(all, strain);
            for (const auto &e : strain)
              largest = std::max(largest,
                                 material_.lambda() * dealii::trace(e) +
                                     2. * material_.mu() * dealii::eigenvalues(e)[0]);
          }
  return dealii::Utilities::MPI::max(largest, comm_);
}

ElasticPiece::Vector ElasticPiece::ghosted(const Vector &u) const
{
  Vector result(owned_, relevant_, comm_);
  result = u;
  return result;
}

std::set<dealii::CellId> ElasticPiece::worst_cells(const Vector &u, const double fraction)
{
  dealii::Vector<float> errors(mesh_.n_active_cells());
  dealii::KellyErrorEstimator<3>::estimate(
      mapping_, dofs_, dealii::QGauss<2>(degree + 1), {}, ghosted(u), errors);
  dealii::parallel::distributed::GridRefinement::refine_and_coarsen_fixed_number(
      mesh_, errors, fraction, 0.);
  std::set<dealii::CellId> chosen;
  for (const auto &cell : mesh_.active_cell_iterators())
    if (cell->refine_flag_set())
      {
        chosen.insert(cell->id());
        cell->clear_refine_flag();
      }
  return chosen;
}
} // namespace chaindrive::statics
