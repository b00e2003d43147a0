// SPDX-License-Identifier: LGPL-2.1-or-later
// Every width of the kernels gives the forces and energies of the scalar ones, each lane its own;
// forces have no resultant and no moment; the energy's derivative is the force.
#include "../support/elastic.h"

#include <cstdlib>

using namespace test;

int main()
{
  const parameters::Material material;
  mesh::Part                 body = ring(3.76e-3, 5.08e-3, 7e-3, {{1, 8, 2}});
  dealii::GridTools::distort_random(0.2, *body.mesh, true, 7);

  for (const auto &formulation : formulations)
    {
      const Reference reference(body, material, formulation.first);
      const auto      fill = [&](Batch &batch) {
        std::mt19937                           random(1);
        std::uniform_real_distribution<double> uniform(-1., 1.);
        for (int lane = 0; lane < n_lanes; ++lane)
          {
            const Tensor<2, 3> turned = turn(0.7 * lane);
            // a turned body, with noise of a micrometre
            batch.set(batch.position, lane, [&](const Point<3> &x, unsigned int) {
              Tensor<1, 3> u = turned * x;
              for (unsigned int i = 0; i < 3; ++i)
                u[i] += 1e-6 * uniform(random);
              return u;
            });
            batch.set(batch.velocity, lane, [&](const Point<3> &, unsigned int) {
              Tensor<1, 3> v;
              v[0] = uniform(random);
              v[2] = uniform(random);
              return v;
            });
          }
      };

      Batch scalar(reference, *element::kernels(1));
      fill(scalar);
      scalar.add_internal_forces();
      double scale = 0.;
      for (const double f : scalar.force)
        scale = std::max(scale, std::abs(f));

      double resultant = 0., moment = 0.;
      for (int lane = 0; lane < n_lanes; ++lane)
        {
          Tensor<1, 3> sum, turning;
          for (unsigned int node = 0; node < reference.n_nodes(); ++node)
            {
              const Tensor<1, 3> f = scalar.get(scalar.force, node, lane);
              sum += f;
              turning += cross_product_3d(scalar.get(scalar.position, node, lane), f);
            }
          resultant = std::max(resultant, sum.norm() / scale);
          moment    = std::max(moment, turning.norm() / (scale * 5e-3));
        }

      // dW = -f . du by central differences, for one lane and a direction of all nodes
      Batch        forth(reference, *element::kernels(1)), back(reference, *element::kernels(1));
      const double step = 1e-9;
      double       work = 0.;
      fill(forth);
      fill(back);
      for (unsigned int i = 0; i < forth.position.size(); ++i)
        {
          const double direction = std::sin(1. + i);
          forth.position[i] += step * direction;
          back.position[i] -= step * direction;
          if (i % n_lanes == 3)
            work -= scalar.force[i] * direction;
        }
      forth.add_internal_forces();
      back.add_internal_forces();
      const double derivative = (forth.strain_energy(3) + forth.hourglass_energy(3) -
                                 back.strain_energy(3) - back.hourglass_energy(3)) /
                                (2. * step);

      std::cout << formulation.second << ": resultant and moment vanish to 1e-12: "
                << (resultant < 1e-12 && moment < 1e-12 ? "yes" : "NO")
                << "; derivative of the energy over -f: " << std::fixed << std::setprecision(5)
                << derivative / work << std::defaultfloat << '\n';

      for (const int width : {2, 4, 8})
        {
          double difference = 0.;
          if (const element::Kernels *kernels = element::kernels(width)) // else nothing to compare
            {
              Batch packed(reference, *kernels);
              fill(packed);
              packed.add_internal_forces();
              for (unsigned int i = 0; i < packed.force.size(); ++i)
                difference =
                    std::max(difference, std::abs(packed.force[i] - scalar.force[i]) / scale);
              for (unsigned int i = 0; i < 2 * n_lanes; ++i)
                difference = std::max(difference,
                                      std::abs(packed.energy[i] - scalar.energy[i]) /
                                          std::max(scalar.energy[i % n_lanes], 1e-30));
              Batch whole(reference, *element::kernels(1));
              fill(whole);
              Batch wide(reference, *kernels);
              fill(wide);
              for (unsigned int n = 0; n < 10; ++n)
                {
                  whole.step(1e-8);
                  wide.step(1e-8);
                }
              for (unsigned int i = 0; i < wide.velocity.size(); ++i)
                difference =
                    std::max(difference, 1e-3 * std::abs(wide.velocity[i] - whole.velocity[i]));
            }
          std::cout << formulation.second << ", width " << width
                    << ": as scalar to 1e-12: " << (difference < 1e-12 ? "yes" : "NO") << '\n';
        }
    }

  for (const char *asked : {"1", "2", "3", "16", "wide"})
    {
      setenv("CHAINDRIVE_SIMD_WIDTH", asked, 1);
      try
        {
          const std::string name = element::best_kernels().name;
          std::cout << "asked for " << asked << ": " << name << '\n';
        }
      catch (const InputError &)
        {
          std::cout << "asked for " << asked << ": refused\n";
        }
    }
}
