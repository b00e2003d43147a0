// SPDX-License-Identifier: LGPL-2.1-or-later
// Speed of the kernels of reduced bodies: nanoseconds of one core per body, node and mode for
// placing nodes, with velocities from rates or from the step, and for taking forces to modes.
#include <chaindrive/bodies/modal_kernels.h>
#include <chaindrive/utilities/pack.h>

#include <deal.II/base/aligned_vector.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

using namespace chaindrive;

namespace
{
double cpu_seconds()
{
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return t.tv_sec + 1e-9 * t.tv_nsec;
}

/// Median seconds of CPU time of one call of @p work.
double time_of(const std::function<void()> &work)
{
  work();
  std::vector<double> times;
  for (unsigned int repetition = 0; repetition < 9; ++repetition)
    {
      const double start = cpu_seconds();
      for (unsigned int i = 0; i < 200; ++i)
        work();
      times.push_back((cpu_seconds() - start) / 200);
    }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}
} // namespace

int main(int argc, char **argv)
{
  const unsigned int n_nodes  = argc > 1 ? std::stoi(argv[1]) : 500,
                     n_modes  = argc > 2 ? std::stoi(argv[2]) : 80,
                     n_images = argc > 3 ? std::stoi(argv[3]) : 4;
  using Numbers               = dealii::AlignedVector<double>;
  const auto numbers          = [](const std::size_t n) {
    Numbers x(n);
    for (std::size_t i = 0; i < n; ++i)
      x[i] = 1e-3 * std::sin(1. + i);
    return x;
  };
  const unsigned int        n_orbits = n_nodes / n_images;
  const std::size_t         field = 3 * n_nodes * n_lanes, modes = n_modes * n_lanes;
  std::vector<unsigned int> orbit(n_orbits), node(n_orbits * n_images), found(n_orbits), first_mode;
  std::iota(orbit.begin(), orbit.end(), 0u);
  std::iota(node.begin(), node.end(), 0u);
  for (unsigned int c = 0; c <= n_images; ++c)
    first_mode.push_back(c * n_modes / n_images);
  const Numbers reference = numbers(3 * n_nodes), mode_shape = numbers(3 * n_orbits * n_modes),
                rigid = numbers(n_rigid_entries * n_lanes), amplitude = numbers(modes),
                rate = numbers(modes), pushed = numbers(field);
  Numbers position = numbers(field), velocity = numbers(field), force = numbers(field),
          modal_force = numbers(modes), moment = numbers(3 * n_lanes), in_body = numbers(field);
  std::vector<char> pressed_nodes(n_nodes);
  std::printf("%u nodes, %u images each, %u modes; ns per body, node and mode\n%6s%14s%14s%14s\n",
              n_nodes,
              n_images,
              n_modes,
              "width",
              "place, rates",
              "place, step",
              "gather");
  for (const int width : {1, 2, 4, 8})
    {
      const ModalKernels *kernels = modal_kernels(width);
      if (kernels == nullptr)
        continue;
      const ModalNodes nodes{n_orbits,
                             orbit.data(),
                             n_images,
                             node.data(),
                             {1u % n_images, 2u % n_images, 4u % n_images},
                             n_modes,
                             first_mode.data(),
                             reference.data(),
                             mode_shape.data(),
                             rigid.data()};
      PlaceArguments   place{
          nodes, amplitude.data(), rate.data(), 5e-8, position.data(), velocity.data()};
      const double with_rates = time_of([&] { kernels->place(place); });
      place.rate              = nullptr;
      const double with_step  = time_of([&] { kernels->place(place); });
      const double gather     = time_of([&] {
        std::copy(pushed.begin(), pushed.end(), force.begin());
        std::fill(pressed_nodes.begin(), pressed_nodes.end(), 1);
        kernels->gather({nodes,
                         position.data(),
                         force.data(),
                         pressed_nodes.data(),
                         modal_force.data(),
                         moment.data(),
                         0,
                         nullptr,
                         nullptr,
                         in_body.data(),
                         found.data()});
      });
      const double per        = 1e9 / (double(n_nodes) * n_modes * n_lanes);
      std::printf(
          "%6d%14.3f%14.3f%14.3f\n", width, per * with_rates, per * with_step, per * gather);
    }
}
