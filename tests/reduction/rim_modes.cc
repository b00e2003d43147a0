// SPDX-License-Identifier: LGPL-2.1-or-later
// Natural modes of toothed rims. Of a ring that is held inside, which has no teeth, those without
// waves round it, twisting and swelling, have the frequencies of closed forms by Bessel functions.
// Of a rim with teeth all modes of its mesh move a point of the profile, by a force of one newton
// on it, as freely in all directions, alone and as its lumped mass alone tells, and all other
// points of all gaps by nothing; and what they deflect under pressure is that of a mesh twice as
// fine.
#include "../support/basics.h"

#include <chaindrive/drive/tooth_form.h>
#include <chaindrive/reduction/rim_modes.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/std_cxx17/cmath.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

using namespace chaindrive;
using namespace test;
using dealii::numbers::PI;
using reduction::RimModes;

namespace
{
bool with_numbers = false; ///< behind the verdicts: if there is an argument

constexpr double all = std::numeric_limits<double>::infinity();

bool near(const std::string &what, const double is, const double wanted, const double tolerance)
{
  if (with_numbers)
    std::cerr << what << ": " << is << " for " << wanted << " (" << is / wanted - 1. << ")\n";
  return std::abs(is / wanted - 1.) < tolerance;
}

double j(const double n, const double x) { return dealii::std_cxx17::cyl_bessel_j(n, x); }
double y(const double n, const double x) { return std::cyl_neumann(n, x); }

/// The first @p n zeros of @p f above zero, from steps of @p step.
std::vector<double>
zeros(const std::function<double(double)> &f, const double step, const unsigned int n)
{
  std::vector<double> found;
  for (double x = step; found.size() < n; x += step)
    if (f(x) * f(x + step) < 0.)
      {
        double low = x, high = x + step;
        for (unsigned int i = 0; i < 60; ++i)
          {
            const double middle                     = 0.5 * (low + high);
            (f(low) * f(middle) <= 0. ? high : low) = middle;
          }
        found.push_back(low);
      }
  return found;
}

drive::ChainDimensions chain(const std::string &designation = "525")
{
  parameters::Chain entries;
  entries.designation = designation;
  return drive::make_chain(entries);
}

void check_ring()
{
  const Material        steel;
  parameters::Sprockets sprockets;
  sprockets.list.push_back({"ring", parameters::Role::idler});
  sprockets.list.back().flat.diameter = 80e-3;
  const drive::ToothForm form         = drive::make_drum(chain(), sprockets, 2);
  const double           outer = 0.5 * form.root_diameter, inner = 0.6 * outer;
  const RimModes         modes =
      reduction::make_rim_modes(form, {0.5 * inner, 2. * inner, 7e-3}, steel, 2e3 * PI * 220., 3);

  // u = J1 + c Y1 of b r: zero inside; outside no shear stress, u' - u / r, or no radial stress,
  // u' + nu u / r (Timoshenko and Goodier, Theory of Elasticity, in plane stress)
  const double twisting = std::sqrt(steel.mu() / steel.density),
               swelling = std::sqrt(steel.plane_modulus() / steel.density);
  const auto of_ring    = [&](const double b, const double nu) {
    const double r    = b * outer;
    const auto   edge = [&](double (*f)(double, double)) {
      return b * f(0., r) - f(1., r) / outer + nu * f(1., r) / outer; // f1' = f0 - f1 / r
    };
    return edge(j) * y(1., b * inner) - edge(y) * j(1., b * inner);
  };
  std::vector<double> wanted;
  for (const double b : zeros([&](const double b) { return of_ring(b, -1.); }, 2., 2))
    wanted.push_back(twisting * b);
  for (const double b :
       zeros([&](const double b) { return of_ring(b, steel.poissons_ratio); }, 2., 1))
    wanted.push_back(swelling * b);
  std::vector<double> found;
  for (unsigned int m = 0; m < modes.n_modes(); ++m)
    if (modes.waves[m] == 0)
      found.push_back(modes.omega[m]);
  std::cout << "a ring\n";
  verdict("  twists at 36 kHz and swells at 86 kHz by closed forms to 1 %",
          found.size() > 2 && near("twisting", found[0], wanted[0], 0.01) &&
              near("swelling", found[1], wanted[2], 0.01));
  // cells on the hub are as large as a fifth of such a wave
  verdict("  twists in the second mode, at 149 kHz, to 4 %",
          found.size() > 2 && near("twisting", found[2], wanted[1], 0.04));
}

/// A force on a place of the profile, across it and along it.
std::vector<double>
force_at(const RimModes &modes, const double along, const double x, const double y)
{
  const RimModes::Place place = modes.place_at(along);
  std::vector<double>   force(2 * modes.n_points(), 0.);
  force[2 * place.first]     = (1. - place.part) * x;
  force[2 * place.first + 1] = (1. - place.part) * y;
  force[2 * place.first + 2] = place.part * x;
  force[2 * place.first + 3] = place.part * y;
  return force;
}

void check_rim()
{
  const Material                 steel;
  const drive::ChainDimensions   size = chain();
  const drive::ToothForm         form = drive::make_tooth_form(9, size, parameters::Sprockets(), 0);
  const double                   hub  = form.root_diameter - 0.9 * form.pitch;
  const mesh::SprocketDimensions dimensions{0.5 * hub, hub, 7e-3};
  const RimModes                 modes = reduction::make_rim_modes(form, dimensions, steel, all, 1);

  // sums over all modes of what they move points by
  const unsigned int n = modes.n_points(), z = modes.teeth;
  double             uneven = 0., elsewhere = 0.;
  for (const unsigned int p : {n / 2, n / 2 + 2, n - 3})
    {
      double alone = 0.;
      for (unsigned int gap = 0; gap < z; ++gap)
        for (const unsigned int q : {p, n / 2 + 1})
          {
            double sum[2][2] = {};
            for (unsigned int m = 0; m < modes.n_modes(); ++m)
              {
                const double angle = 2. * PI * modes.waves[m] * gap / z;
                for (unsigned int d = 0; d < 2; ++d)
                  for (unsigned int e = 0; e < 2; ++e)
                    sum[d][e] += modes.cosine[2 * (m * n + p) + d] *
                                 (modes.cosine[2 * (m * n + q) + e] * std::cos(angle) -
                                  modes.sine[2 * (m * n + q) + e] * std::sin(angle));
              }
            if (gap == 0 && q == p)
              {
                alone  = sum[0][0];
                uneven = std::max(
                    {uneven, std::abs(sum[0][0] - sum[1][1]) / alone, std::abs(sum[0][1]) / alone});
              }
            else if (q != p || gap > 0)
              for (const auto &row : sum)
                for (const double moved : row)
                  elsewhere = std::max(elsewhere, std::abs(moved) / alone);
          }
    }
  std::cout << "a rim with teeth\n";
  verdict("  all modes: a point moves alike in all directions to 1e-9", uneven < 1e-9);
  verdict("  and no other point of any gap", elsewhere < 1e-9);

  const RimModes fine = reduction::make_rim_modes(form, dimensions, steel, all, 3);
  const double   seat = form.half_profile.front().length(), flank = seat + 0.1 * form.pitch;
  // across the profile pressure in 0.3 of a pitch, at the bottom and the end of the seat
  const auto pressed = [&](const RimModes &of, const double at, const double x, const double y) {
    std::vector<double> sum(2 * of.n_points(), 0.);
    for (unsigned int i = 0; i < 40; ++i)
      {
        const auto part =
            force_at(of, at + 0.3 * form.pitch * ((i + 0.5) / 40. - 0.5), x / 40., y / 40.);
        for (std::size_t k = 0; k < sum.size(); ++k)
          sum[k] += part[k];
      }
    return of.compliance(sum);
  };
  const bool alike =
      near("bottom", pressed(modes, 0., -1., 0.), pressed(fine, 0., -1., 0.), 0.03) &&
      near(
          "end of the seat", pressed(modes, seat, -0.6, 0.8), pressed(fine, seat, -0.6, 0.8), 0.03);
  verdict("  deflects under pressure in the seat as on twice as fine a mesh to 3 %", alike);
  verdict("  on the flank to 5 %",
          near("flank", pressed(modes, flank, 0., 1.), pressed(fine, flank, 0., 1.), 0.05));
}
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  with_numbers = argc > 1;
  check_ring();
  check_rim();
}
