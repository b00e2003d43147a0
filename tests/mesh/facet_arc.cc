// SPDX-License-Identifier: LGPL-2.1-or-later
// The smooth surface over a polygonal tube against the circle: the error of the distance over the
// sagitta of the facets, its order, and the error of the normal. Facets of unequal width too.

#include <chaindrive/mesh/surface/facet_surface.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <random>

using namespace chaindrive;
using dealii::Point;

int main()
{
  const double                           radius = 5e-3;
  std::mt19937                           generator(1);
  std::uniform_real_distribution<double> any(-1., 1.);
  for (const bool bore : {false, true})
    for (const double uneven : {0., 0.25})
      {
        std::cout
            << (bore ? "bore" : "outside") << (uneven > 0. ? ", unequal facets" : "")
            << ": facets, error in nm, error / sagitta below 1e-4, order, normal below 1e-4\n";
        double last = 0.;
        for (const unsigned int n : {12, 24, 48})
          {
            std::vector<Point<3>> vertices;
            for (unsigned int i = 0; i < n; ++i)
              for (const double z : {-1e-3, 0., 1.5e-3})
                {
                  const double a = 2. * dealii::numbers::PI * (i + (i % 2) * uneven) / n;
                  vertices.emplace_back(radius * std::cos(a), radius * std::sin(a), z);
                }
            std::vector<std::array<unsigned int, 4>> quads;
            for (unsigned int i = 0; i < n; ++i)
              for (unsigned int k = 0; k < 2; ++k)
                {
                  const unsigned int a = 3 * i + k, b = 3 * ((i + 1) % n) + k;
                  if (bore)
                    quads.push_back({{b, a, a + 1, b + 1}});
                  else
                    quads.push_back({{a, b, b + 1, a + 1}});
                }
            const mesh::FacetSurface surface(vertices, quads);

            double error = 0., normal_error = 0., weight_error = 0.;
            for (unsigned int i = 0; i < 4000; ++i)
              {
                const double a = dealii::numbers::PI * any(generator),
                             r = radius * (1. + 0.3 * any(generator));
                const Point<3> p(
                    r * std::cos(a), r * std::sin(a), 0.25e-3 + 1.24e-3 * any(generator));
                const auto projection = surface.closest_point(p, radius);
                if (!projection.found)
                  {
                    std::cout << "missed " << p << '\n';
                    continue;
                  }
                const double side = bore ? -1. : 1.;
                error        = std::max(error, std::abs(projection.distance - side * (r - radius)));
                normal_error = std::max(normal_error,
                                        std::hypot(projection.normal[0] - side * std::cos(a),
                                                   projection.normal[1] - side * std::sin(a)));
                // the weights give the point on the facet's chord, at the projection's height
                double z = 0., sum = 0.;
                for (unsigned int v = 0; v < 4; ++v)
                  {
                    z += projection.weights[v] * vertices[surface.vertices(projection.facet)[v]][2];
                    sum += projection.weights[v];
                  }
                weight_error =
                    std::max({weight_error, std::abs(sum - 1.), std::abs(z - p[2]) / radius});
              }
            const double sagitta = radius * (1. - std::cos(dealii::numbers::PI / n));
            std::cout << n << ' ' << std::fixed << std::setprecision(2) << 1e9 * error << ' '
                      << (error < 1e-4 * sagitta ? "yes" : "no");
            if (last > 0.)
              std::cout << ' ' << std::setprecision(1) << std::log2(last / error);
            std::cout << (normal_error < 1e-4 ? " yes" : " no")
                      << (weight_error < 1e-9 ? "" : " weights wrong") << '\n';
            last = error;
          }
      }
}
