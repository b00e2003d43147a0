// SPDX-License-Identifier: LGPL-2.1-or-later
// Speed of the element kernels: nanoseconds per element and copy, on one core and on all, beside
// deal.II's own FEEvaluation on the same mesh and beside what the machine can do at best.
//
// usage: kernel_benchmark [COPIES]
#include <chaindrive/element/reference.h>
#include <chaindrive/mesh/links.h>

#include <deal.II/base/aligned_vector.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/matrix_free/fe_evaluation.h>
#include <deal.II/matrix_free/matrix_free.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <ctime>
#include <functional>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

using namespace chaindrive;
using element::Formulation;

namespace
{
double cpu_seconds()
{
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return t.tv_sec + 1e-9 * t.tv_nsec;
}

double wall_seconds()
{
  timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
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
struct Copies
{
  Copies(const element::Reference &reference, const unsigned int n_batches)
      : reference(reference), n_batches(n_batches), stride(3 * reference.n_nodes() * n_lanes)
  {
    position.resize(n_batches * stride, 0.);
    velocity.resize(n_batches * stride, 0.);
    force.resize(stride, 0.);
    energy.resize(3 * n_lanes, 0.);
    for (unsigned int i = 0; i < position.size(); ++i)
      position[i] = reference.position[i % stride / (3 * n_lanes)][i % stride / n_lanes % 3] +
                    1e-7 * std::sin(1. + i);
  }

  void forces(const element::Kernels &kernels, const unsigned int batch)
  {
    element::ForceArguments arg = reference.arguments();
    arg.position                = position.data() + batch * stride;
    arg.force                   = force.data();
    arg.strain_energy           = energy.data();
    arg.hourglass_energy        = energy.data() + n_lanes;
    kernels.add_internal_forces[static_cast<int>(reference.formulation)](arg);
  }

  void step(const element::Kernels &kernels, const unsigned int batch)
  {
    forces(kernels, batch);
    kernels.update({reference.n_nodes(),
                    1e-9,
                    reference.mass.data(),
                    position.data() + batch * stride,
                    velocity.data() + batch * stride,
                    force.data(),
                    energy.data() + 2 * n_lanes});
  }

  const element::Reference     &reference;
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
    const int n = 2000000;                                                                         \
    for (int i = 0; i < 12; ++i)                                                                   \
      x[i] = P(1. + i);                                                                            \
    const P      a(0.999), b(1e-3);                                                                \
    const double start = cpu_seconds();                                                            \
    for (int k = 0; k < n; ++k)                                                                    \
      for (int i = 0; i < 12; ++i)                                                                 \
        {                                                                                          \
          x[i] = x[i] * a + b;                                                                     \
          asm volatile("" : "+x"(x[i].v));                                                         \
        }                                                                                          \
    return 24. * width * n / (cpu_seconds() - start);                                              \
  }
PEAK(peak_2, 2, )
#ifdef __x86_64__
PEAK(peak_4, 4, __attribute__((target("arch=x86-64-v3"))))
PEAK(peak_8, 8, __attribute__((target("arch=x86-64-v4"))))
#endif

int main(int argc, char **argv)
{
  const unsigned int n_copies  = argc > 1 ? std::stoi(argv[1]) : 110;
  const unsigned int n_batches = (n_copies + n_lanes - 1) / n_lanes;
  const unsigned int n_threads = std::max(1u, std::thread::hardware_concurrency());

  const parameters::Material material;
  const auto                 chain = drive::make_chain(parameters::Chain());
  std::printf("best kernels here: %s\n", element::best_kernels().name);
  std::printf("fused multiply-add peak of a core, GF/s: 2 lanes %.1f", 1e-9 * peak_2());
#ifdef __x86_64__
  if (element::kernels(4) != nullptr)
    std::printf(", 4 lanes %.1f", 1e-9 * peak_4());
  if (element::kernels(8) != nullptr)
    std::printf(", 8 lanes %.1f", 1e-9 * peak_8());
#endif
  {
    std::vector<double> a(40000000, 1.), b(a), c(a);
    const double        seconds = time_of([&] {
      for (std::size_t i = 0; i < a.size(); ++i)
        a[i] = b[i] + 3. * c[i];
    });
    std::printf("\nmemory bandwidth of a core (triad): %.1f GB/s\n", 24e-9 * a.size() / seconds);
  }

  for (const auto &[wall, around, along] :
       {std::array<unsigned int, 3>{{1, 24, 4}}, {{2, 32, 6}}, {{3, 48, 10}}})
    {
      const mesh::Part part =
          mesh::make_roller(chain, material.density, mesh::RollerGrid(wall, around, along));
      std::printf("\nroller %u x %u x %u, %u elements, %u copies; ns per element and copy\n",
                  wall,
                  around,
                  along,
                  part.mesh->n_active_cells(),
                  n_copies);

      const element::Reference full(part, material, Formulation::full);
      FEEvaluationOperator     reference_operator(part, full.lambda, full.mu);
      const double             fe_evaluation =
          1e9 * time_of([&] { reference_operator.forces(); }) / part.mesh->n_active_cells();
      std::printf("%-22s %6s %10.1f\n", "deal.II FEEvaluation", "", fe_evaluation);
      std::printf("%-12s%6s%12s%12s%16s%20s\n",
                  "element",
                  "width",
                  "force",
                  "step",
                  "FEEval/force",
                  ("step, " + std::to_string(n_threads) + " threads").c_str());

      for (const auto &[formulation, name] : {std::make_pair(Formulation::one_point, "one point"),
                                              std::make_pair(Formulation::enhanced, "enhanced"),
                                              std::make_pair(Formulation::full, "full")})
        {
          const element::Reference reference(part, material, formulation);
          for (const int width : {1, 2, 4, 8})
            {
              const element::Kernels *kernels = element::kernels(width);
              if (kernels == nullptr)
                continue;
              const double per = 1e9 / (n_batches * n_lanes * reference.n_elements());
              Copies       copies(reference, n_batches);
              const double force = per * time_of([&] {
                                     for (unsigned int b = 0; b < n_batches; ++b)
                                       copies.forces(*kernels, b);
                                   });
              const double step  = per * time_of([&] {
                                    for (unsigned int b = 0; b < n_batches; ++b)
                                      copies.step(*kernels, b);
                                  });

              // All cores together, each with the share of the batches that it gets done.
              std::vector<double> walls;
              for (unsigned int repetition = 0; repetition < 5; ++repetition)
                {
                  std::atomic<int>         ready{0};
                  std::vector<std::thread> threads;
                  std::vector<double>      seconds(n_threads);
                  const unsigned int       rounds =
                      1 + static_cast<unsigned int>(3e7 / (step / per * 1e9));
                  for (unsigned int t = 0; t < n_threads; ++t)
                    threads.emplace_back([&, t] {
                      Copies mine(reference, (n_batches + n_threads - 1) / n_threads);
                      ++ready;
                      while (ready < static_cast<int>(n_threads))
                        std::this_thread::yield();
                      const double start = wall_seconds();
                      for (unsigned int r = 0; r < rounds; ++r)
                        for (unsigned int b = 0; b < mine.n_batches; ++b)
                          mine.step(*kernels, b);
                      seconds[t] = (wall_seconds() - start) / (rounds * mine.n_batches) / n_threads;
                    });
                  for (std::thread &thread : threads)
                    thread.join();
                  walls.push_back(*std::max_element(seconds.begin(), seconds.end()));
                }
              std::printf("%-12s%6d%12.1f%12.1f%16.1f%20.1f\n",
                          name,
                          width,
                          force,
                          step,
                          fe_evaluation / force,
                          1e9 * median(walls) / (n_lanes * reference.n_elements()));
            }
        }
    }
}
