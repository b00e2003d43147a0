// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/mesh/mass.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <functional>

namespace chaindrive::mesh
{
namespace
{
/// Calls @p visit (component, position, volume) for points whose sums integrate polynomials of
/// degree 5 in each direction of the reference cell exactly: second moments of trilinear cells.
void for_each_point(
    const dealii::Triangulation<3>                                                      &mesh,
    const std::function<void(unsigned int component, const dealii::Point<3> &, double)> &visit)
{
  const dealii::FE_Nothing<3> fe;
  const dealii::QGauss<3>     quadrature(3);
  dealii::FEValues<3>         values(
      fe, quadrature, dealii::update_quadrature_points | dealii::update_JxW_values);
  for (const auto &cell : mesh.active_cell_iterators())
    {
      values.reinit(cell);
      for (const unsigned int q : values.quadrature_point_indices())
        visit(cell->material_id(), values.quadrature_point(q), values.JxW(q));
    }
}

/// Sums of point masses.
class PointMasses
{
public:
  /// Each point of a half part stands for its mirror image, too.
  explicit PointMasses(const Part &part) : symmetry_(part.symmetry()) {}

  void add(const dealii::Point<3> &x, const double mass)
  {
    add_one(x, mass);
    if (symmetry_.is_active())
      add_one(dealii::Point<3>(x[0], x[1], -x[2]), mass);
  }

  drive::MassProperties properties() const
  {
    drive::MassProperties result;
    result.mass   = mass_;
    result.centre = dealii::Point<3>(first_ / mass_);
    // second moments about the centre of mass, then the inertia tensor
    const dealii::Tensor<2, 3> central = second_ - outer_product(first_, first_) / mass_;
    for (unsigned int d = 0; d < 3; ++d)
      result.inertia[d][d] = trace(central);
    result.inertia -= central;
    return result;
  }

private:
  void add_one(const dealii::Point<3> &x, const double mass)
  {
    mass_ += mass;
    first_ += mass * x;
    second_ += mass * outer_product(dealii::Tensor<1, 3>(x), dealii::Tensor<1, 3>(x));
  }

  MirrorSymmetry       symmetry_;
  double               mass_ = 0.;
  dealii::Tensor<1, 3> first_;
  dealii::Tensor<2, 3> second_;
};
} // namespace

std::array<double, n_components> component_volumes(const dealii::Triangulation<3> &mesh)
{
  std::array<double, n_components> volumes{};
  for_each_point(mesh, [&](const unsigned int component, const dealii::Point<3> &, double volume) {
    volumes[component] += volume;
  });
  return volumes;
}

drive::MassProperties meshed_properties(const Part &part)
{
  PointMasses masses(part);
  for_each_point(*part.mesh,
                 [&](const unsigned int component, const dealii::Point<3> &x, double volume) {
                   masses.add(x, part.density_of(component) * volume);
                 });
  return masses.properties();
}

drive::MassProperties lumped_properties(const Part &part)
{
  const dealii::FE_Q<3>   fe(1);
  const dealii::QGauss<3> quadrature(2);
  dealii::FEValues<3>     values(fe, quadrature, dealii::update_values | dealii::update_JxW_values);
  PointMasses             masses(part);
  for (const auto &cell : part.mesh->active_cell_iterators())
    {
      values.reinit(cell);
      for (const unsigned int v : cell->vertex_indices())
        {
          double volume = 0.;
          for (const unsigned int q : values.quadrature_point_indices())
            volume += values.shape_value(v, q) * values.JxW(q);
          masses.add(cell->vertex(v), part.density_of(cell->material_id()) * volume);
        }
    }
  return masses.properties();
}

void match_masses(Part &part, const std::array<double, n_components> &masses)
{
  const auto volumes = component_volumes(*part.mesh);
  for (unsigned int c = 0; c < n_components; ++c)
    if (masses[c] > 0.)
      part.density_factor[c] = masses[c] / (part.density * part.symmetry().whole(volumes[c]));
  part.meshed = meshed_properties(part);
}
} // namespace chaindrive::mesh
