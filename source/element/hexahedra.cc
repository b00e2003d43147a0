// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/element/hexahedra.h>
#include <chaindrive/element/hexahedron_stiffness.h>
#include <chaindrive/element/solid_shell_stiffness.h>
#include <chaindrive/element/solid_shell_stresses.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

namespace chaindrive::element
{
using dealii::Tensor;

// From a cell to what the kernels read of it:
//
//   place()               turns the unit cell, in six ways, and gives the element axes of its own
//   shape_of()            what is regular in those axes; the way that is most so is taken
//   geometry_of()         elements that are alike share their numbers
//   mesh::gauss_points()  gradients and volumes at 2 x 2 x 2 points
//   make_hexahedron()     mean gradient and linear parts of the hourglass modes, by base vectors
//   hourglass_stiffness_of(), condense() what holds the hourglass amplitudes
//   (solid_shell_stiffness()) for_each_number()     writes down those numbers that do not vanish,
//   in the kernels' order
//
// element_stiffness() goes the other way, from the numbers to a matrix: what it gives is what the
// kernels compute with. Base vectors, amplitudes and which numbers vanish are in shapes.h, the
// formulas above hexahedron_kernels.h.

namespace
{
/// h_m at a vertex: the base vectors of shapes.h.
double h(const unsigned int base, const unsigned int vertex)
{
  const double x = (vertex & 1) ? 1. : -1., y = (vertex & 2) ? 1. : -1.,
               z = (vertex & 4) ? 1. : -1.;
  const std::array<double, n_base_vectors> values{{x, y, z, x * y, y * z, z * x, x * y * z}};
  return values[base];
}

/// The amplitude of @p base in coordinate @p j of the vertices.
double amplitude(const mesh::Corners &corners, const unsigned int j, const unsigned int base)
{
  double sum = 0.;
  for (unsigned int a = 0; a < 8; ++a)
    sum += h(base, a) * corners[a][j];
  return sum;
}

/// A vertex of a hexahedron whose unit cell is turned: by @p axis the local axes are renumbered in
/// a cycle, so that this one becomes the third, and @p quarter turns them about it.
unsigned int turned(const unsigned int vertex, const unsigned int axis, const bool quarter)
{
  std::array<unsigned int, 3> s{{vertex & 1, vertex >> 1 & 1, vertex >> 2}};
  if (quarter)
    s = {{1 - s[1], s[0], s[2]}};
  unsigned int result = 0;
  for (unsigned int d = 0; d < 3; ++d)
    result |= s[d] << (d + axis + 1) % 3;
  return result;
}

/// An element in axes of its own.
struct Placed
{
  std::array<unsigned int, 8> order; ///< vertex of the cell for each of the element's
  Tensor<2, 3>                axes;  ///< see Hexahedra
  mesh::Corners               corners;
};

/// The hexahedron @p corners with its unit cell turned in one of six ways and axes along its edges.
Placed place(const mesh::Corners &corners, const unsigned int way)
{
  Placed placed;
  for (unsigned int a = 0; a < 8; ++a)
    {
      placed.order[a]   = turned(a, (way / 2 + 2) % 3, way % 2 == 1);
      placed.corners[a] = corners[placed.order[a]];
    }
  Tensor<1, 3> x, z;
  for (unsigned int j = 0; j < 3; ++j)
    {
      x[j] = amplitude(placed.corners, j, base_x);
      z[j] = amplitude(placed.corners, j, base_z);
    }
  z /= z.norm();
  x -= (x * z) * z;
  x /= x.norm();
  placed.axes[0] = x;
  placed.axes[1] = cross_product_3d(z, x);
  placed.axes[2] = z;
  for (dealii::Point<3> &corner : placed.corners)
    corner = dealii::Point<3>(placed.axes * (corner - corners[0]));
  return placed;
}

/// The same as it is.
Placed place_as_is(const mesh::Corners &corners)
{
  Placed placed;
  for (unsigned int a = 0; a < 8; ++a)
    placed.order[a] = a;
  placed.axes    = dealii::unit_symmetric_tensor<3>();
  placed.corners = corners;
  return placed;
}

/// The most regular shape that these vertices have to a billionth.
Shape shape_of(const mesh::Corners &corners)
{
  double largest = 0.;
  for (unsigned int j = 0; j < 3; ++j)
    for (unsigned int m = 0; m < n_base_vectors; ++m)
      largest = std::max(largest, std::abs(amplitude(corners, j, m)));

  // which base vectors may be in each coordinate
  const auto only = [&](const std::array<std::array<bool, n_base_vectors>, 3> &allowed) {
    for (unsigned int j = 0; j < 3; ++j)
      for (unsigned int m = 0; m < n_base_vectors; ++m)
        if (!allowed[j][m] && std::abs(amplitude(corners, j, m)) > 1e-9 * largest)
          return false;
    return true;
  };
  if (only({{{{true, false, false, true, false, false, false}},
             {{false, true, false, false, false, false, false}},
             {{false, false, true, false, false, false, false}}}}))
    return Shape::symmetric_prism;
  if (only({{{{true, true, false, true, false, false, false}},
             {{false, true, false, true, false, false, false}},
             {{false, false, true, false, false, false, false}}}}))
    return Shape::prism;
  return Shape::general;
}

/// All that the kernels could need of an element; see n_numbers().
struct Hexahedron
{
  double volume;
  double gradient[3][n_base_vectors];
  double shift[4][3];
  double hourglass_stiffness;
  double hourglass[12][12]; ///< in the order of the amplitudes
  double coupling[6][12]; ///< of a solid-shell: twice the mean strain per amplitude, angles as such
  double point_volume[8];
  double point_inverse[8][3][3]; ///< an eighth of d xi_d / dX_j
};

/// What elements have in common that differ by no more than round-off: where the corners are as
/// seen from the first one, in femtometres. In metres round-off is some 1e-18.
/// The last number is the axis through the thickness.
using Geometry = std::array<std::int64_t, 25>;

Geometry geometry_of(const mesh::Corners &corners, const unsigned int across)
{
  Geometry geometry;
  geometry[24] = across;
  for (unsigned int a = 0; a < 8; ++a)
    for (unsigned int d = 0; d < 3; ++d)
      geometry[3 * a + d] = std::llround((corners[a][d] - corners[0][d]) * 1e15);
  return geometry;
}

/// Calls @p visit with every number that the kernels read, in their order.
template <typename Element, typename Visit>
void for_each_number(const Shape       shape,
                     const Formulation formulation,
                     Element          &element,
                     const Visit      &visit)
{
  const auto visit_places = [&](const NonZeros &places, auto &matrix) {
    for (int n = 0; n < places.size; ++n)
      visit(matrix[places.row[n]][places.column[n]]);
  };
  if (formulation == Formulation::full)
    {
      for (unsigned int q = 0; q < (shape == Shape::general ? 8 : 4); ++q)
        {
          visit(element.point_volume[q]);
          visit_places(jacobian_entries(shape), element.point_inverse[q]);
        }
      return;
    }
  visit(element.volume);
  visit_places(gradient_entries(shape), element.gradient);
  visit_places(shift_entries(shape), element.shift);
  if (formulation == Formulation::one_point)
    visit(element.hourglass_stiffness);
  else
    visit_places(hourglass_entries(shape), element.hourglass);
  if (formulation == Formulation::solid_shell)
    visit_places(coupling_entries(shape), element.coupling);
}

/// The element that these numbers describe.
Hexahedron unpack(const Shape shape, const Formulation formulation, const double *number)
{
  Hexahedron element{};
  for_each_number(shape, formulation, element, [&](double &value) { value = *number++; });
  for (unsigned int m = 0; m < 12; ++m)
    for (unsigned int n = 0; n < m; ++n)
      element.hourglass[n][m] = element.hourglass[m][n];
  if (shape != Shape::general) // the points above each other are alike
    for (unsigned int q = 0; q < 4; ++q)
      {
        element.point_volume[q + 4] = element.point_volume[q];
        for (unsigned int d = 0; d < 3; ++d)
          for (unsigned int j = 0; j < 3; ++j)
            element.point_inverse[q + 4][d][j] = element.point_inverse[q][d][j];
      }
  return element;
}

using Gradient = double[3][8];

/// Gradients of the shape functions, from what base vectors have part in the mean ones.
void vertex_gradient(const Hexahedron &element, Gradient &B)
{
  for (unsigned int j = 0; j < 3; ++j)
    for (unsigned int a = 0; a < 8; ++a)
      {
        B[j][a] = 0.;
        for (unsigned int m = 0; m < n_base_vectors; ++m)
          B[j][a] += element.gradient[j][m] * h(m, a);
      }
}

/// Gradients of the shape functions prod_d (1 + h_d xi_d) / 8 at point @p q.
void point_gradient(const Hexahedron &element, const unsigned int q, Gradient &B)
{
  const double g = 1. / std::sqrt(3.);
  for (unsigned int a = 0; a < 8; ++a)
    {
      const auto derivative = [&](const unsigned int d) {
        double product = h(d, a);
        for (unsigned int other = 0; other < 3; ++other)
          if (other != d)
            product *= 1. + g * h(other, q) * h(other, a);
        return product;
      };
      for (unsigned int j = 0; j < 3; ++j)
        {
          B[j][a] = 0.;
          for (unsigned int d = 0; d < 3; ++d)
            B[j][a] += derivative(d) * element.point_inverse[q][d][j];
        }
    }
}

/// The mean gradient and what of the hourglass vectors is linear.
Hexahedron make_hexahedron(const mesh::Corners                   &corners,
                           const std::array<mesh::GaussPoint, 8> &points)
{
  Hexahedron element{};
  for (const mesh::GaussPoint &point : points)
    element.volume += point.volume;
  for (unsigned int j = 0; j < 3; ++j)
    for (unsigned int m = 0; m < n_base_vectors; ++m)
      for (const mesh::GaussPoint &point : points)
        for (unsigned int a = 0; a < 8; ++a)
          element.gradient[j][m] +=
              0.125 * point.volume / element.volume * point.gradient[a][j] * h(m, a);
  for (unsigned int alpha = 0; alpha < 4; ++alpha)
    for (unsigned int j = 0; j < 3; ++j)
      element.shift[alpha][j] = amplitude(corners, j, base_xy + alpha);

  for (unsigned int q = 0; q < 8; ++q)
    {
      // xi_d is itself a trilinear field, -1 and 1 at the vertices
      element.point_volume[q] = points[q].volume;
      for (unsigned int d = 0; d < 3; ++d)
        for (unsigned int j = 0; j < 3; ++j)
          for (unsigned int a = 0; a < 8; ++a)
            element.point_inverse[q][d][j] += 0.125 * h(d, a) * points[q].gradient[a][j];
    }
  return element;
}

/// gamma_alpha = h_alpha - B_j (h_alpha . X_j): linear displacements have no part in it.
dealii::FullMatrix<double> hourglass_vectors(const Hexahedron &element)
{
  Gradient B;
  vertex_gradient(element, B);
  dealii::FullMatrix<double> gamma(4, 8);
  for (unsigned int alpha = 0; alpha < 4; ++alpha)
    for (unsigned int a = 0; a < 8; ++a)
      {
        gamma(alpha, a) = h(base_xy + alpha, a);
        for (unsigned int j = 0; j < 3; ++j)
          gamma(alpha, a) -= B[j][a] * element.shift[alpha][j];
      }
  return gamma;
}

/// Displacements of the vertices, rows, of a unit of each hourglass amplitude. An element that
/// passes the patch test is K = V B^T C B + Gamma^T K_h Gamma. Displacements G_alpha with
/// gamma_alpha . G_beta = 1 or 0 and no mean gradient, one for each amplitude, therefore give K_h =
/// G K G^T. They are found in two steps: G = (gamma gamma^T)^-1 gamma has the amplitudes, and what
/// it has of mean gradient is taken away by a linear field, which has no amplitude.
dealii::FullMatrix<double> amplitude_fields(const Hexahedron &element, const mesh::Corners &corners)
{
  Gradient B;
  vertex_gradient(element, B);
  const dealii::FullMatrix<double> gamma = hourglass_vectors(element);
  dealii::FullMatrix<double>       products(4, 4), inverse(4, 4), g(4, 8);
  gamma.mTmult(products, gamma);
  inverse.invert(products);
  inverse.mmult(g, gamma);
  for (unsigned int alpha = 0; alpha < 4; ++alpha)
    for (unsigned int j = 0; j < 3; ++j)
      {
        double gradient = 0.;
        for (unsigned int a = 0; a < 8; ++a)
          gradient += B[j][a] * g(alpha, a);
        for (unsigned int a = 0; a < 8; ++a) // a linear field changes no amplitude
          g(alpha, a) -= gradient * (corners[a][j] - corners[0][j]);
      }
  return g;
}

void condense(const dealii::FullMatrix<double> &k,
              const mesh::Corners              &corners,
              Hexahedron                       &element)
{
  const dealii::FullMatrix<double> g = amplitude_fields(element, corners);
  for (unsigned int m = 0; m < 12; ++m)
    for (unsigned int n = 0; n < 12; ++n)
      for (unsigned int a = 0; a < 8; ++a)
        for (unsigned int b = 0; b < 8; ++b)
          element.hourglass[m][n] += g(amplitudes[m].alpha, a) *
                                     k(3 * a + amplitudes[m].k, 3 * b + amplitudes[n].k) *
                                     g(amplitudes[n].alpha, b);
}

/// The same of a solid-shell, whose amplitudes have a mean strain D p where its strains are
/// sampled: K_h = G K G^T - V D^T C D, since the mean strain has its own stiffness.
void condense(const SolidShellStiffness &shell,
              const mesh::Corners       &corners,
              const Material            &material,
              Hexahedron                &element)
{
  condense(shell.stiffness, corners, element);
  const dealii::FullMatrix<double> g = amplitude_fields(element, corners);
  dealii::FullMatrix<double>       D(n_strains, 12), stress(n_strains, 12), energy(12, 12);
  for (unsigned int r = 0; r < n_strains; ++r)
    for (unsigned int m = 0; m < 12; ++m)
      for (unsigned int a = 0; a < 8; ++a)
        D(r, m) += shell.mean_strain(r, 3 * a + amplitudes[m].k) * g(amplitudes[m].alpha, a);
  elasticity(material.lambda(), material.mu()).mmult(stress, D);
  D.Tmmult(energy, stress);
  for (unsigned int m = 0; m < 12; ++m)
    {
      for (unsigned int n = 0; n < 12; ++n)
        element.hourglass[m][n] -= element.volume * energy(m, n);
      for (unsigned int r = 0; r < n_strains; ++r)
        element.coupling[r][m] = (r < 3 ? 2. : 1.) * D(r, m);
    }
}

/// The same stiffness of every amplitude, after Flanagan and Belytschko (1981):
/// coefficient (lambda + 2 mu) V B_ja B_ja / gamma . gamma.
double
hourglass_stiffness_of(const Hexahedron &element, const double coefficient, const double modulus)
{
  double gradients = 0.;
  for (const auto &row : element.gradient)
    for (const double b : row)
      gradients += 8. * b * b; // h_m . h_m = 8
  const double norm = hourglass_vectors(element).frobenius_norm();
  return coefficient * modulus * element.volume * gradients / (0.25 * norm * norm);
}
} // namespace

bool Selection::has(const dealii::types::material_id component) const
{
  return component != mesh::hub_zone &&
         (components.empty() ||
          std::find(components.begin(), components.end(), component) != components.end());
}

Hexahedra::Hexahedra(const mesh::Part  &part,
                     const mesh::Nodes &nodes,
                     const Material    &material,
                     const Formulation  chosen_formulation,
                     const double       hourglass_coefficient,
                     const Shape        most_regular,
                     const Selection   &selection)
    : formulation(selection.element_type == parameters::ElementType::solid ?
                      chosen_formulation :
                      Formulation::solid_shell)
    , shape(most_regular)
    , lambda(material.lambda())
    , mu(material.mu())
    , mass(nodes.mass)
    , position(nodes.position)
    , selection_(selection)
    , kernels_(best_kernels())
{
  const bool is_solid_shell = selection.element_type != parameters::ElementType::solid;
  std::vector<std::pair<mesh::Corners, std::array<unsigned int, 8>>> cells;
  std::vector<unsigned int>                                          across; // axis of the cell
  unsigned int                                                       n_elastic = 0;
  for (const auto &cell : part.mesh->active_cell_iterators())
    {
      if (cell->material_id() == mesh::hub_zone)
        continue;
      const unsigned int elastic = n_elastic++;
      if (!selection.has(cell->material_id()))
        continue;
      const mesh::Corners corners = mesh::corners_of(cell);
      cells.push_back({corners, nodes.cells[elastic]});
      across.push_back(is_solid_shell ? nearest_axis(corners, selection.across(cell->center())) :
                                        0);
    }

  // each element as it is most regular; the part is as its least regular element
  std::vector<Placed> placed;
  for (const auto &[corners, unused] : cells)
    {
      Placed best       = place_as_is(corners);
      Shape  best_shape = Shape::general;
      for (unsigned int way = 0; way < 6 && best_shape < shape; ++way)
        {
          const Placed here       = place(corners, way);
          const Shape  shape_here = std::min(shape, shape_of(here.corners));
          if (shape_here > best_shape)
            {
              best       = here;
              best_shape = shape_here;
            }
        }
      placed.push_back(best);
      shape = best_shape;
    }

  std::map<Geometry, std::size_t> numbers_of;
  for (unsigned int e = 0; e < cells.size(); ++e)
    {
      if (shape == Shape::general)
        placed[e] = place_as_is(cells[e].first);
      const Placed &here = placed[e];
      vertices.push_back({});
      axes.push_back(here.axes);
      for (unsigned int a = 0; a < 8; ++a)
        vertices.back().node[a] = cells[e].second[here.order[a]];

      // the axis of the element that is that of the cell
      unsigned int thickness_axis = 0;
      while (is_solid_shell &&
             (here.order[0] ^ here.order[1U << thickness_axis]) != 1U << across[e])
        ++thickness_axis;

      const auto [found, is_new] =
          numbers_of.emplace(geometry_of(here.corners, thickness_axis), numbers.size());
      vertices.back().numbers = static_cast<unsigned int>(found->second);
      if (!is_new)
        continue;

      const auto gauss   = mesh::gauss_points(here.corners);
      Hexahedron element = make_hexahedron(here.corners, gauss);
      if (formulation == Formulation::one_point)
        element.hourglass_stiffness =
            hourglass_stiffness_of(element, hourglass_coefficient, material.constrained_modulus());
      if (formulation == Formulation::enhanced)
        condense(stiffness(gauss, material, true), here.corners, element);
      if (is_solid_shell)
        condense(stiffness_of_type(here.corners, thickness_axis, material, selection.element_type),
                 here.corners,
                 material,
                 element);
      for_each_number(
          shape, formulation, element, [&](const double number) { numbers.push_back(number); });
    }
}

ForceArguments Hexahedra::arguments() const
{
  ForceArguments arg{};
  arg.n_elements = n_elements();
  arg.shape      = shape;
  arg.vertices   = vertices.data();
  arg.numbers    = numbers.data();
  arg.lambda     = lambda;
  arg.mu         = mu;
  return arg;
}

dealii::FullMatrix<double> Hexahedra::element_stiffness(const unsigned int e) const
{
  const Hexahedron element = unpack(shape, formulation, numbers.data() + vertices[e].numbers);
  dealii::FullMatrix<double> k(24, 24);

  const auto add_point = [&](const Gradient &gradient, const double volume) {
    for (unsigned int a = 0; a < 8; ++a)
      for (unsigned int b = 0; b < 8; ++b)
        {
          double product = 0.;
          for (const auto &row : gradient)
            product += row[a] * row[b];
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int j = 0; j < 3; ++j)
              k(3 * a + i, 3 * b + j) +=
                  volume * (lambda * gradient[i][a] * gradient[j][b] +
                            mu * gradient[j][a] * gradient[i][b] + (i == j ? mu * product : 0.));
        }
  };
  // the mean strain with what the amplitudes add to it
  const auto add_solid_shell = [&](const Hexahedron                 &shell,
                                   const Gradient                   &gradient,
                                   const dealii::FullMatrix<double> &gamma) {
    dealii::FullMatrix<double> strain(n_strains, 24), stress(n_strains, 24), product(24, 24);
    for (unsigned int r = 0; r < n_strains; ++r)
      {
        const unsigned int i = strain_pair[r][0], j = strain_pair[r][1];
        for (unsigned int a = 0; a < 8; ++a)
          {
            strain(r, 3 * a + i) += gradient[j][a];
            if (i != j)
              strain(r, 3 * a + j) += gradient[i][a];
            for (unsigned int m = 0; m < 12; ++m)
              strain(r, 3 * a + amplitudes[m].k) +=
                  (r < 3 ? 0.5 : 1.) * shell.coupling[r][m] * gamma(amplitudes[m].alpha, a);
          }
      }
    elasticity(lambda, mu).mmult(stress, strain);
    strain.Tmmult(product, stress);
    k.add(shell.volume, product);
  };
  Gradient B;
  if (formulation == Formulation::full)
    for (unsigned int q = 0; q < 8; ++q)
      {
        point_gradient(element, q, B);
        add_point(B, element.point_volume[q]);
      }
  else
    {
      vertex_gradient(element, B);
      const dealii::FullMatrix<double> gamma = hourglass_vectors(element);
      if (formulation == Formulation::solid_shell)
        add_solid_shell(element, B, gamma);
      else
        add_point(B, element.volume);
      for (unsigned int m = 0; m < 12; ++m)
        for (unsigned int n = 0; n < 12; ++n)
          {
            const double stiffness = formulation == Formulation::one_point ?
                                         (m == n ? element.hourglass_stiffness : 0.) :
                                         element.hourglass[m][n];
            for (unsigned int a = 0; a < 8; ++a)
              for (unsigned int b = 0; b < 8; ++b)
                k(3 * a + amplitudes[m].k, 3 * b + amplitudes[n].k) +=
                    gamma(amplitudes[m].alpha, a) * stiffness * gamma(amplitudes[n].alpha, b);
          }
    }

  // from the element's axes to those of the part
  for (unsigned int a = 0; a < 8; ++a)
    for (unsigned int b = 0; b < 8; ++b)
      {
        Tensor<2, 3> block;
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            block[i][j] = k(3 * a + i, 3 * b + j);
        block = transpose(axes[e]) * block * axes[e];
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            k(3 * a + i, 3 * b + j) = block[i][j];
      }
  return k;
}

void Hexahedra::add_forces(const BatchState &batch) const
{
  ForceArguments internal   = arguments();
  internal.position         = batch.position;
  internal.force            = batch.force;
  internal.strain_energy    = batch.strain_energy;
  internal.hourglass_energy = batch.hourglass_energy;
  internal.next             = batch.next;
  internal.n_next           = batch.n_next;
  kernels_.add_internal_forces[static_cast<int>(formulation)](internal);
}

std::unique_ptr<const StressRecovery> Hexahedra::make_stress_recovery(
    const mesh::Part &part, const mesh::Nodes &nodes, const Material &material) const
{
  if (selection_.element_type != parameters::ElementType::solid)
    return std::make_unique<SolidShellStresses>(part, nodes, material, selection_);
  return std::make_unique<CellStresses>(part, nodes, material, selection_.components);
}

std::size_t Hexahedra::memory_consumption() const
{
  return vertices.size() * sizeof(Vertices) + numbers.size() * sizeof(double) +
         axes.size() * sizeof(Tensor<2, 3>) +
         mass.size() * (sizeof(double) + sizeof(dealii::Point<3>));
}
} // namespace chaindrive::element
