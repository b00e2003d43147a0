// SPDX-License-Identifier: LGPL-2.1-or-later
// Speed of the element kernels: nanoseconds per element and copy, on one core and on all, beside
// deal.II's own FEEvaluation on the same mesh and beside what the machine can do at best.
//
// kernel_benchmark --help lists the options.
#include <chaindrive/element/hexahedra.h>
#include <chaindrive/mesh/generate/links.h>

#include <deal.II/base/aligned_vector.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/matrix_free/fe_evaluation.h>
#include <deal.II/matrix_free/matrix_free.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <ctime>
#include <functional>
#include <iostream>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

using namespace chaindrive;
using element::Formulation;
using element::Shape;

namespace
{
double cpu_seconds()
{
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return t.tv_sec + 1e-9 * t.tv_nsec;
}

double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Median seconds of CPU time of one call of @p work in this thread.
double time_of(const std::function<void()> &work)
{
  work();
  unsigned int calls = 1;
  for (;; calls *= 2)
    {
      const double start = cpu_seconds();
      for (unsigned int i = 0; i < calls; ++i)
        work();
      if (cpu_seconds() - start > 0.05)
        break;
    }
  std::vector<double> times;
  for (unsigned int repetition = 0; repetition < 9; ++repetition)
    {
      const double start = cpu_seconds();
      for (unsigned int i = 0; i < calls; ++i)
        work();
      times.push_back((cpu_seconds() - start) / calls);
    }
  return median(times);
}

/// Batches of copies of one part.
struct BodyBatches
{
  BodyBatches(const element::Hexahedra &reference, const unsigned int n_batches)
      : reference(reference), n_batches(n_batches), stride(3 * reference.n_nodes() * n_lanes)
  {
    position.resize(n_batches * stride, 0.);
    velocity.resize(n_batches * stride, 0.);
    force.resize(stride, 0.);
    energy.resize(9 * n_lanes, 0.);
    for (unsigned int i = 0; i < position.size(); ++i)
      position[i] = reference.position[i % stride / (3 * n_lanes)][i % stride / n_lanes % 3] +
                    1e-7 * std::sin(1. + i);
  }

  void forces(const element::Kernels &kernels, const unsigned int batch, const bool moves = false)
  {
    element::ForceArguments arg = reference.arguments();
    arg.position                = position.data() + batch * stride;
    arg.force                   = force.data();
    arg.strain_energy           = energy.data();
    arg.hourglass_energy        = energy.data() + n_lanes;
    if (moves)
      {
        arg.next   = velocity.data() + batch * stride;
        arg.n_next = stride;
      }
    kernels.add_internal_forces[static_cast<int>(reference.formulation)](arg);
  }

  void step(const element::Kernels &kernels, const unsigned int batch)
  {
    forces(kernels, batch, true);
    kernels.update({reference.n_nodes(),
                    1e-9,
                    1e-9,
                    {0., 0., 0.},
                    0.,
                    reference.mass.data(),
                    position.data() + batch * stride,
                    velocity.data() + batch * stride,
                    force.data(),
                    energy.data() + 2 * n_lanes,
                    energy.data() + 3 * n_lanes,
                    energy.data() + 6 * n_lanes});
  }

  const element::Hexahedra     &reference;
  unsigned int                  n_batches, stride;
  dealii::AlignedVector<double> position, velocity, force, energy;
};

/// deal.II's matrix-free evaluation of the same internal forces, fully integrated.
class FEEvaluationOperator
{
public:
  explicit FEEvaluationOperator(const mesh::Part &part, const double lambda, const double mu)
      : fe_(dealii::FE_Q<3>(1), 3), dof_handler_(*part.mesh), lambda_(lambda), mu_(mu)
  {
    dof_handler_.distribute_dofs(fe_);
    dealii::AffineConstraints<double> constraints;
    constraints.close();
    dealii::MatrixFree<3, double>::AdditionalData data;
    data.tasks_parallel_scheme = dealii::MatrixFree<3, double>::AdditionalData::none;
    data.mapping_update_flags  = dealii::update_gradients | dealii::update_JxW_values;
    matrix_free_.reinit(
        dealii::MappingQ1<3>(), dof_handler_, constraints, dealii::QGauss<1>(2), data);
    matrix_free_.initialize_dof_vector(displacement_);
    matrix_free_.initialize_dof_vector(force_);
    for (unsigned int i = 0; i < displacement_.locally_owned_size(); ++i)
      displacement_.local_element(i) = 1e-7 * std::sin(1. + i);
  }

  void forces()
  {
    using Vector = dealii::LinearAlgebra::distributed::Vector<double>;
    force_       = 0.;
    matrix_free_.cell_loop<Vector, Vector>(
        [this](const auto &data, auto &to, const auto &from, const auto &range) {
          dealii::FEEvaluation<3, 1, 2, 3, double> values(data);
          for (unsigned int cell = range.first; cell < range.second; ++cell)
            {
              values.reinit(cell);
              values.gather_evaluate(from, dealii::EvaluationFlags::gradients);
              for (unsigned int q = 0; q < values.n_q_points; ++q)
                {
                  auto F = values.get_gradient(q);
                  for (unsigned int d = 0; d < 3; ++d)
                    F[d][d] += 1.;
                  auto E = transpose(F) * F;
                  for (unsigned int d = 0; d < 3; ++d)
                    E[d][d] -= 1.;
                  E *= dealii::VectorizedArray<double>(0.5);
                  auto S = 2. * mu_ * E;
                  for (unsigned int d = 0; d < 3; ++d)
                    S[d][d] += lambda_ * trace(E);
                  values.submit_gradient(F * S, q);
                }
              values.integrate_scatter(dealii::EvaluationFlags::gradients, to);
            }
        },
        force_,
        displacement_);
  }

private:
  dealii::FESystem<3>                                fe_;
  dealii::DoFHandler<3>                              dof_handler_;
  dealii::MatrixFree<3, double>                      matrix_free_;
  dealii::LinearAlgebra::distributed::Vector<double> displacement_, force_;
  double                                             lambda_, mu_;
};
} // namespace

/// Fused multiply-adds per second of one core, as numbers computed, times two.
#define PEAK(name, width, attributes)                                                              \
  attributes double name()                                                                         \
  {                                                                                                \
    using P = Pack<double, width>;                                                                 \
    P         x[12];                                                                               \
    const int n                                                = 2000000;                          \
    _Pragma("GCC unroll 12") for (int i = 0; i < 12; ++i) x[i] = P(1. + i);                        \
    const P      a(0.999), b(1e-3);                                                                \
    const double start = cpu_seconds();                                                            \
    for (int k = 0; k < n; ++k)                                                                    \
      _Pragma("GCC unroll 12") for (int i = 0; i < 12; ++i)                                        \
      {                                                                                            \
        x[i] = x[i] * a + b;                                                                       \
        asm volatile("" : "+x"(x[i].v));                                                           \
      }                                                                                            \
    return 24. * width * n / (cpu_seconds() - start);                                              \
  }
PEAK(peak_1, 1, )
PEAK(peak_2, 2, )
#ifdef __x86_64__
PEAK(peak_4, 4, __attribute__((target("arch=x86-64-v3"))))
PEAK(peak_8, 8, __attribute__((target("arch=x86-64-v4"))))
#endif

namespace
{
struct Options
{
  std::string      mesh, formulation, shape;
  std::vector<int> widths;
  unsigned int     copies, threads;
  bool             fe_evaluation;
};

/// Additions and multiplications per element in the formulas of hexahedron_kernels.h.
double n_operations(const Formulation formulation, const Shape shape)
{
  const double modes  = 3 * (23 + 30); // to_modes(), subtract_modes()
  const double strain = 2 * 18 + 3, stress = 30, product = 2 * 27 - 9;
  if (formulation == Formulation::full)
    return modes + 3 * 25 + 3 * (3 * 9 + 4) +
           8 * (2 * 6 * element::jacobian_entries(shape).size + strain + stress + product);
  const double gradient_and_shift =
      2 * 6 * (element::gradient_entries(shape).size + element::shift_entries(shape).size);
  const double hourglass = formulation == Formulation::one_point ?
                               3 * 12 :
                               2 * (3 * 36 + 12) + 4 * element::hourglass_entries(shape).size - 24;
  const double coupling =
      formulation == Formulation::solid_shell ? 4 * element::coupling_entries(shape).size + 3 : 0;
  return modes + gradient_and_shift + hourglass + coupling + strain + stress + product;
}

/// What a core does at best.
struct Machine
{
  double peak[n_lanes + 1] = {}; ///< per width: operations per second
  double bandwidth         = 0.; ///< B/s
};

/// Nanoseconds per element and copy of a step on all cores together: CPU time of the slowest
/// thread, so that other programs on the machine count for little.
double step_on_threads(const element::Hexahedra &reference,
                       const element::Kernels   &kernels,
                       const Options            &options,
                       const double              expected_ns)
{
  const unsigned int n_batches  = (options.copies + n_lanes - 1) / n_lanes;
  const unsigned int per_thread = (n_batches + options.threads - 1) / options.threads;
  const double       per_round  = per_thread * n_lanes * reference.n_elements();
  const unsigned int rounds     = 1 + static_cast<unsigned int>(3e7 / (expected_ns * per_round));

  std::vector<double> slowest;
  for (unsigned int repetition = 0; repetition < 5; ++repetition)
    {
      std::atomic<unsigned int> ready{0};
      std::vector<std::thread>  threads;
      std::vector<double>       seconds(options.threads);
      for (unsigned int t = 0; t < options.threads; ++t)
        threads.emplace_back([&, t] {
          BodyBatches mine(reference, per_thread);
          ++ready;
          while (ready < options.threads)
            std::this_thread::yield();
          const double start = cpu_seconds();
          for (unsigned int r = 0; r < rounds; ++r)
            for (unsigned int b = 0; b < per_thread; ++b)
              mine.step(kernels, b);
          seconds[t] = cpu_seconds() - start;
        });
      for (std::thread &thread : threads)
        thread.join();
      slowest.push_back(*std::max_element(seconds.begin(), seconds.end()));
    }
  return 1e9 * median(slowest) / (rounds * per_round * options.threads);
}

Machine measure_machine()
{
  Machine machine;
  machine.peak[1] = peak_1();
  machine.peak[2] = peak_2();
#ifdef __x86_64__
  if (element::kernels(4) != nullptr)
    machine.peak[4] = peak_4();
  if (element::kernels(8) != nullptr)
    machine.peak[8] = peak_8();
#endif
  std::printf("best kernels here: %s\nfused multiply-add peak of a core, GF/s:",
              element::best_kernels().name);
  for (const int width : {1, 2, 4, 8})
    if (machine.peak[width] > 0.)
      std::printf(" %d lanes %.1f", width, 1e-9 * machine.peak[width]);
  std::vector<double> a(40000000, 1.), b(a), c(a);
  const double        seconds = time_of([&] {
    for (std::size_t i = 0; i < a.size(); ++i)
      a[i] = b[i] + 3. * c[i];
  });
  machine.bandwidth           = 24. * a.size() / seconds;
  std::printf("\nmemory bandwidth of a core (triad): %.1f GB/s\n", 1e-9 * machine.bandwidth);
  return machine;
}

void measure(const mesh::RollerGrid &grid, const Options &options, const Machine &machine)
{
  const Material   material;
  const mesh::Part part =
      mesh::make_roller(drive::make_chain(parameters::Chain()), material.density, grid);
  std::printf("\nroller %u x %u x %u, %u elements, %u copies; ns per element and copy\n",
              grid.wall,
              grid.around,
              grid.along,
              part.mesh->n_active_cells(),
              options.copies);
  if (options.fe_evaluation)
    {
      const element::Hexahedra full(part, material, Formulation::full);
      FEEvaluationOperator     reference_operator(part, full.lambda, full.mu);
      std::printf("deal.II FEEvaluation: %.1f\n", 1e9 * time_of([&] {
                                                    reference_operator.forces();
                                                  }) / part.mesh->n_active_cells());
    }
  std::printf("%-12s%-18s%6s%10s%10s%20s%12s%14s\n",
              "element",
              "shape",
              "width",
              "force",
              "step",
              ("step, " + std::to_string(options.threads) + " threads").c_str(),
              "% of peak",
              "% of triad");

  for (const auto &[formulation, name] : {std::make_pair(Formulation::one_point, "one-point"),
                                          std::make_pair(Formulation::enhanced, "enhanced"),
                                          std::make_pair(Formulation::full, "full"),
                                          std::make_pair(Formulation::solid_shell, "solid-shell")})
    for (const auto &[shape, shape_name] :
         {std::make_pair(Shape::symmetric_prism, "symmetric-prism"),
          std::make_pair(Shape::prism, "prism"),
          std::make_pair(Shape::general, "general")})
      {
        if ((options.formulation != "all" && options.formulation != name) ||
            (options.shape != "all" && options.shape != shape_name))
          continue;
        element::Selection all;
        if (formulation == Formulation::solid_shell)
          {
            all.element_type = parameters::ElementType::solid_shell;
            all.across = [](const dealii::Point<3> &x) { return dealii::Point<3>(x[0], x[1], 0.); };
          }
        const element::Hexahedra reference(part, material, formulation, 0.1, shape, all);
        for (const int width : options.widths)
          {
            const element::Kernels *kernels = element::kernels(width);
            if (kernels == nullptr || reference.shape != shape)
              continue;
            BodyBatches  copies(reference, (options.copies + n_lanes - 1) / n_lanes);
            const double per   = 1e9 / (copies.n_batches * n_lanes * reference.n_elements());
            const double force = per * time_of([&] {
                                   for (unsigned int b = 0; b < copies.n_batches; ++b)
                                     copies.forces(*kernels, b);
                                 });
            const double step  = per * time_of([&] {
                                  for (unsigned int b = 0; b < copies.n_batches; ++b)
                                    copies.step(*kernels, b);
                                });
            // a step reads and writes positions and velocities of the nodes
            const double bytes = 96. * reference.n_nodes() / reference.n_elements();
            std::printf("%-12s%-18s%6d%10.1f%10.1f%20.1f%12.0f%14.0f\n",
                        name,
                        shape_name,
                        width,
                        force,
                        step,
                        step_on_threads(reference, *kernels, options, step),
                        1e11 * n_operations(formulation, shape) / force / machine.peak[width],
                        1e11 * bytes / step / machine.bandwidth);
            std::fflush(stdout);
          }
      }
}
} // namespace

int main(int argc, char **argv)
{
  namespace po = boost::program_options;
  Options                 options;
  po::options_description description(
      "Speed of the element kernels on rollers: nanoseconds of one core per element and copy for\n"
      "the internal forces and for a whole step, and for a step on all cores at once; operations "
      "of\n"
      "the forces over the core's peak for as many lanes; memory that a step moves over what the\n"
      "core can");
  // clang-format off
  description.add_options()
    ("help", "print this and stop")
    ("mesh", po::value(&options.mesh)->default_value("3x48x10"),
     "cells through the wall, around and along the roller, or all of three meshes")
    ("formulation", po::value(&options.formulation)->default_value("all"),
     "one-point, enhanced, full, solid-shell, or all; a bush of one layer is --mesh 1x24x6")
    ("shape", po::value(&options.shape)->default_value("all"),
     "kernels for general, prism or symmetric-prism elements, or all that fit the mesh")
    ("width", po::value(&options.widths)->multitoken()->default_value({1, 2, 4, 8}, "1 2 4 8"),
     "numbers computed at a time")
    ("copies", po::value(&options.copies)->default_value(110), "how many rollers")
    ("threads", po::value(&options.threads)
       ->default_value(std::max(1u, std::thread::hardware_concurrency())),
     "how many threads for the last column")
    ("fe-evaluation", po::value(&options.fe_evaluation)->default_value(true),
     "measure deal.II's FEEvaluation beside");
  // clang-format on
  try
    {
      po::variables_map values;
      po::store(po::parse_command_line(argc, argv, description), values);
      po::notify(values);
      if (values.count("help"))
        {
          std::cout << description;
          return 0;
        }
      std::vector<mesh::RollerGrid> grids;
      if (options.mesh == "all")
        grids = {{1, 24, 4}, {2, 32, 6}, {3, 48, 10}};
      else
        {
          unsigned int wall, around, along;
          if (std::sscanf(options.mesh.c_str(), "%ux%ux%u", &wall, &around, &along) != 3)
            throw po::error("the mesh is given as 3x48x10");
          grids = {{wall, around, along}};
        }
      const Machine machine = measure_machine();
      for (const mesh::RollerGrid &grid : grids)
        measure(grid, options, machine);
    }
  catch (const po::error &error)
    {
      std::cerr << error.what() << '\n';
      return 1;
    }
}
