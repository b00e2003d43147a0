// SPDX-License-Identifier: LGPL-2.1-or-later
// Tooth gaps that do not stand in their places: distances are those of a profile that has been
// turned gap by gap, deviations are the same for the same seed, and a chain is laid on such teeth
// without stretching or overlapping.
#include "compare.h"
#include "slack_drive.h"

#include <chaindrive/drive/drive.h>
#include <chaindrive/drive/tooth_index.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace chaindrive;
using dealii::Point;
using dealii::Tensor;
using dealii::numbers::PI;

namespace
{
/// The distance of @p p from a gap with the @p half profile on either side, turned by @p angle, m.
double distance_from_gap(const std::vector<Point<2>> &half, const double angle, const Point<2> &p)
{
  double       least = 1.;
  const double c = std::cos(angle), s = std::sin(angle);
  for (const double side : {-1., 1.})
    for (std::size_t i = 1; i < half.size(); ++i)
      {
        const auto turned = [&](const Point<2> &q) {
          return Point<2>(c * q[0] - s * side * q[1], s * q[0] + c * side * q[1]);
        };
        const Point<2>     a = turned(half[i - 1]), b = turned(half[i]);
        const Tensor<1, 2> along = b - a;
        const double       part  = std::clamp(along * (p - a) / along.norm_square(), 0., 1.);
        least                    = std::min(least, p.distance(a + part * along));
      }
  return least;
}

/// Largest error [m] of distances of points outside of @p form, whose gaps are off by @p index.
double error_of_distances(const drive::ToothForm &form, const std::vector<double> &index)
{
  const std::vector<Point<2>>            half = form.half_polyline(400);
  std::mt19937                           random(3);
  std::uniform_real_distribution<double> part(-0.45, 0.45), off(0., 1.);
  double                                 error = 0.;
  for (unsigned int i = 0; i < 300; ++i)
    {
      const unsigned int k     = i % form.teeth;
      const double       angle = 2. * PI * (k + part(random)) / form.teeth;
      const double       r =
          0.5 * form.root_diameter + off(random) * (form.outside_diameter - form.root_diameter);
      const Point<2> p(r * std::cos(angle), r * std::sin(angle));
      const auto     found = form.closest_point(p);
      double         least = 1.;
      for (const unsigned int gap : {k + form.teeth - 1, k, k + 1})
        {
          const unsigned int g = gap % form.teeth;
          least                = std::min(
              least,
              distance_from_gap(
                  half, 2. * PI * g / form.teeth + 2. * index[g] / form.pitch_diameter, p));
        }
      error = std::max(error, std::abs(std::abs(found.distance) - least));
    }
  return error;
}

/// Whether in a drive without load no roller overlaps a tooth, and all links have their lengths.
bool lies_freely(const drive::Drive &d, const bool lumped)
{
  double most = std::max(0., deepest(d)); // m
  for (unsigned int k = 0; k < d.layout.joints.size(); ++k)
    most = std::max(most, std::abs(length(d, k) - own_length(d, lumped, k)));
  return most < 1e-8;
}
} // namespace

int main()
{
  parameters::Sprocket wheel{"driver", parameters::Role::driver, 17};
  wheel.index_tolerance = 40e-6;
  const auto random     = drive::index_deviations(wheel);
  wheel.index_seed      = 2;
  const auto other      = drive::index_deviations(wheel);
  wheel.index_seed      = 1;
  verdict("the same seed is the same wheel, another is another one",
          random == drive::index_deviations(wheel) && random != other);
  const auto [least, most] = std::minmax_element(random.begin(), random.end());
  verdict("all within the tolerance, and not far",
          *least > -40e-6 && *most < 40e-6 && *most - *least > 40e-6);
  compare("the first, um", 1e6 * random[0], 6.912308, 6);
  std::cout << drive::in_words("driver", {10e-6, -5e-6, 2e-6}) << '\n';

  Parameters p     = slack_drive("simple");
  auto       chain = drive::make_chain(p.drive.chain);
  for (const auto standard : {parameters::StandardForm::iso_mid, parameters::StandardForm::ansi})
    {
      p.drive.sprockets.tooth_form = standard;
      drive::ToothForm form        = drive::make_tooth_form(17, chain, p.drive.sprockets, 0);
      std::cout << "distances in place and off it within 10 nm: "
                << (error_of_distances(form, std::vector<double>(17, 0.)) < 1e-8 ? "yes" : "NO");
      form.shift_gaps(random);
      std::cout << ", " << (error_of_distances(form, random) < 1e-8 ? "yes" : "NO") << '\n';
    }

  for (const std::string fidelity : {"simple", "layered"})
    {
      std::cout << "== " << fidelity << '\n';
      const bool         lumped = fidelity == "simple";
      const drive::Drive plain  = drive::make_drive(slack_drive(fidelity));
      const double       radius = 0.5 * plain.sprockets[1].form.pitch_diameter;
      for (const auto tight : {parameters::TightSide::upper, parameters::TightSide::lower})
        {
          Parameters q              = slack_drive(fidelity);
          q.drive.layout.tight_span = tight;
          q.drive.layout.start      = parameters::Start::settled;
          q.loads.driver_speed      = 1.;
          const double from         = drive::make_drive(q).layout.sprockets[1].angle;
          q.drive.sprockets.list[0].index_deviations = {20e-6};
          compare("all gaps of the driver 20 um counter-clockwise: the loaded sprocket too, um",
                  1e6 * radius * (drive::make_drive(q).layout.sprockets[1].angle - from),
                  20.,
                  0);
        }
      unsigned int n = 0;
      for (unsigned int seed = 0; seed < 10; ++seed)
        {
          Parameters q = slack_drive(fidelity);
          for (parameters::Sprocket &one : q.drive.sprockets.list)
            {
              one.index_tolerance = 30e-6;
              one.index_seed      = seed;
            }
          n += lies_freely(drive::make_drive(q), lumped) ? 1 : 0;
        }
      std::cout << "of ten random drives free and unstretched: " << n << '\n';
    }

  wheel.index_deviations = {1e-6};
  expect_refusal("both", [&]() { drive::index_deviations(wheel); });
  wheel.index_tolerance  = 0.;
  wheel.index_deviations = {1e-6, 2e-6};
  expect_refusal("a list that does not go", [&]() { drive::index_deviations(wheel); });
  wheel.index_deviations = {1e-6};
  wheel.mesh             = "wheel.msh";
  expect_refusal("a mesh", [&]() { drive::index_deviations(wheel); });
}
