// SPDX-License-Identifier: LGPL-2.1-or-later
// Strips under a solid disc of 10.16 mm in plane strain, whose harmonics from the second on are
// those of the closed form for a disc, on a tooth that is a half-space in its short waves.
//
// On flats and convex flanks it is Hertz' line contact: with the load q per length, E' = E / (1 -
// nu^2), the relative radius R and the half width b = sqrt(8 q R / (pi E')), an ellipse of pressure
// of the half angle h = b / r about the axis has harmonics of 2 J1(k h) / (k h), so that disc and
// tooth deflect at its middle by the sums of their harmonics with these. In the seat, 1 % wider
// than the disc, peaks of pressure are those of a pin in a hole [Persson 1964], from where three
// strips touch on; a tooth has no waves that are longer than a quarter of the round, and a hole
// has. It is so wherever on the strips the middle of the contact is. A strip whose middle the disc
// misses by half of its width h meets it later by h^2 / 8 R. Teeth that are softer higher up yield
// at three places by what is given, and between as a ground that moves as a whole.
#include "../support/scenes.h"

#include <chaindrive/contact/tooth_strips.h>
#include <chaindrive/drive/stiffness.h>
#include <chaindrive/utilities/complementarity.h>
#include <chaindrive/utilities/simd.h>

#include <deal.II/base/std_cxx17/cmath.h>

#include <algorithm>
#include <map>

using namespace test;
using dealii::numbers::PI;

namespace
{
bool with_numbers = false; ///< behind the verdicts: if there is an argument

constexpr double       R = 5.08e-3, length = 7e-3; // m
constexpr unsigned int n_columns = 32, first_of_tooth = 4;

/// What the harmonic @p k of a load per length of 1 N/m moves the outside of a disc by, m.
double of_disc(const Material &steel, const unsigned int k)
{
  const double nu = steel.poissons_ratio, four_g = 2. * steel.youngs_modulus / (1. + nu);
  return ((3. - 4. * nu) / (k + 1.) + 1. / (k - 1.)) / (PI * four_g);
}

double of_half_space(const Material &steel, const unsigned int k)
{
  return 2. / (PI * steel.plane_modulus() * k);
}

/// The disc's outside as a mesh has it.
reduction::RoundFlexibility disc(const Material &steel)
{
  reduction::RoundFlexibility outside;
  outside.rings     = {0.};
  outside.n_columns = n_columns;
  outside.node.resize(n_columns);
  for (unsigned int d = 0; d < n_columns; ++d)
    {
      double sum = 0.;
      for (unsigned int k = 2; k <= n_columns / 2; ++k)
        sum += of_disc(steel, k) / length * std::cos(2. * PI * k * d / n_columns);
      outside.value.push_back(sum);
    }
  return outside;
}

struct Contact
{
  double load = 0., peak = 0.; ///< N; Pa
};

/// Strips that are pressed by @p approach [m] where the disc touches at the angle @p middle, with
/// the @p curvature of the gap, 1/m.
Contact press(const contact::StripFlexibility &strips,
              const double                     middle,
              const double                     curvature,
              const double                     approach)
{
  const contact::StripGrid     &grid   = strips.grid();
  const unsigned int            n      = grid.size();
  const unsigned int            stride = ComplementaritySolver::padded(n);
  dealii::AlignedVector<double> matrix(std::size_t(n) * stride), gap(stride);
  for (unsigned int i = 0; i < n; ++i)
    {
      const double x = R * (grid.middle[i] - middle), w = R * grid.half_width[i];
      gap[i] = 0.5 * curvature * (x * x + w * w / 3.) - approach;
      for (unsigned int j = 0; j < n; ++j)
        matrix[std::size_t(i) * stride + j] = strips.at(i, j);
    }
  std::array<ComplementarityProblem, n_lanes> problems;
  problems[0] = {n, matrix.data(), stride, gap.data(), false};
  std::array<ClosedSet, n_lanes> sets;
  ComplementaritySolver          solver(simd_width());
  solver.solve(problems, 1e-14, sets);
  Contact found;
  for (unsigned int a = 0; a < sets[0].number.size(); ++a)
    {
      const double width = 2. * R * grid.half_width[sets[0].number[a]];
      found.load += sets[0].pressure[a];
      found.peak = std::max(found.peak, sets[0].pressure[a] / (width * length));
    }
  return found;
}

/// The approach [m] at the @p load [N], and the peak of pressure.
std::pair<double, double> at_load(const contact::StripFlexibility &strips,
                                  const double                     middle,
                                  const double                     curvature,
                                  const double                     load)
{
  double low = 0., high = 1e-3;
  for (unsigned int i = 0; i < 50; ++i)
    {
      const double approach                                                 = 0.5 * (low + high);
      (press(strips, middle, curvature, approach).load < load ? low : high) = approach;
    }
  return {high, press(strips, middle, curvature, high).peak};
}

/// Hertz: by how much disc and tooth come nearer.
double approach_of_hertz(const Material &steel, const double curvature, const double load)
{
  const double q    = load / length;
  const double half = std::sqrt(8. * q / (curvature * PI * steel.plane_modulus())) / R;
  double       sum  = 0.;
  for (unsigned int k = 2; k < 200000; ++k)
    {
      const double x = k * half, mean = 2. * dealii::std_cxx17::cyl_bessel_j(1., x) / x;
      // beyond the mesh's waves a disc is a half-space
      const double of_roller =
          k <= n_columns / 2 ?
              std::max(of_disc(steel, k), k >= n_columns / 4 ? of_half_space(steel, k) : 0.) :
              of_half_space(steel, k);
      sum += q * mean * (of_roller + (k < first_of_tooth ? 0. : of_half_space(steel, k)));
    }
  return sum;
}

void check(const std::string &where, const bool within, const double error)
{
  if (with_numbers)
    std::cerr << where << ": " << error << '\n';
  verdict(where, within);
}

/// What a tooth of @p stiffness [N/m] deflects under a load in the seat beside its dents there,
/// over that load, m/N; the pressure is half of an ellipse up to @p half_angle [rad].
double beside_dents(const Material &steel,
                    const double    stiffness,
                    const double    half_angle,
                    const double    on = length)
{
  double dents = 0.;
  for (unsigned int k = first_of_tooth; k < 1000; ++k)
    {
      const double x = k * half_angle, mean = 2. * dealii::std_cxx17::cyl_bessel_j(1., x) / x;
      dents += of_half_space(steel, k) / on * mean * mean;
    }
  return 1. / stiffness - dents;
}

/// A tooth that is softer higher up: the pressure of conforming contact moves it at each of three
/// places, on either side of the bottom, by what their numbers say. One that is as soft everywhere
/// in the seat moves as a ring on an elastic ground: by the same along both axes. A force at one
/// side of the gap moves the other side away from the disc.
void check_places(const reduction::RoundFlexibility &outside,
                  const contact::ToothStrips        &profile,
                  const drive::ToothForm            &form,
                  const Material                    &steel)
{
  std::cout << "teeth that are softer higher up\n";
  const contact::StripGrid &grid = profile.grid();
  const double              load = 1412., play = form.seat_radius - R,
               curvature  = 1. / R - 1. / form.seat_radius,
               half_angle = drive::conforming_contact(R, play, load / length, steel).half_angle;
  const auto with         = [&](const std::vector<drive::PlacedStiffness> &places) {
    contact::StripFlexibility::Tooth tooth{1e20, half_angle};
    tooth.places = places;
    tooth.slopes = profile.slopes();
    return contact::StripFlexibility(outside, grid, {0}, {length}, steel, tooth);
  };
  const contact::StripFlexibility none = with({});
  // angles about the centre of the seat; those of the grid are about the roller's
  const double scale = form.seat_radius / R;
  const auto   more  = [&](const contact::StripFlexibility &strips, const double angle) {
    return at_load(strips, scale * angle, curvature, load).first -
           at_load(none, scale * angle, curvature, load).first;
  };
  const std::vector<drive::PlacedStiffness> places = {{0., 6.4e8}, {0.6, 4e8}, {0.85, 2.7e8}};
  const contact::StripFlexibility           strips = with(places);
  double                                    worst  = 0.;
  for (const drive::PlacedStiffness &place : places)
    for (const double side : {-1., 1.})
      {
        // the shares of strips in the pressure, and what these move each other by
        std::vector<double> share;
        for (unsigned int i = 0; i < grid.size(); ++i)
          {
            const auto below = [&](const double end) {
              const double x = std::clamp(
                  (grid.middle[i] + end * grid.half_width[i] - side * scale * place.angle) /
                      half_angle,
                  -1.,
                  1.);
              return (x * std::sqrt(1. - x * x) + std::asin(x)) / PI;
            };
            share.push_back(below(1.) - below(-1.));
          }
        double found = 0.;
        for (unsigned int i = 0; i < grid.size(); ++i)
          for (unsigned int j = 0; j < grid.size(); ++j)
            found += share[i] * (strips.at(i, j) - none.at(i, j)) * share[j];
        found /= beside_dents(steel, place.stiffness, half_angle);
        if (with_numbers)
          std::cerr << "at " << side * place.angle << " rad: " << found << '\n';
        worst = std::max(worst, std::abs(found - 1.));
      }
  check("  they yield by what is given within 1 %", worst < 0.01, worst);

  const contact::StripFlexibility even  = with({{0., 3e8}, {0.6, 3e8}, {0.85, 3e8}});
  double                          least = 1., most = 0.;
  for (const double angle : {0., 0.2, -0.4, 0.6, 0.85})
    {
      const double found = more(even, angle);
      least              = std::min(least, found);
      most               = std::max(most, found);
    }
  check("  as soft everywhere: at any place within 1 %", most < 1.01 * least, most / least);
  const contact::SeatMotion ring({{0., 0.6, 0.85}}, {{2e-9, 2e-9, 2e-9}}, 1e-6, 1.);
  worst = 0.;
  for (const double a : {-0.9, 0., 0.5})
    for (const double b : {-0.3, 0.8})
      worst = std::max(worst, std::abs(ring(a, b) / (2e-9 * std::cos(a - b)) - 1.));
  check("  and as a ring on an elastic ground", worst < 1e-9, worst);

  // tooth and rim of 13 and 19 teeth of 06B at 311 N, as `chaindrive parts` has them: three tell
  // two
  constexpr double degree = PI / 180., on = 5.3e-3, touches = 4.75 * degree;
  worst = 0.;
  for (const auto &stiffness :
       {std::map<double, double>{
            {0., 638.6e6}, {20., 558e6}, {40., 396.8e6}, {55.3, 270.3e6}, {60., 242.5e6}},
        {{0., 554.9e6}, {20., 530.9e6}, {40., 408.3e6}, {56.4, 306.5e6}, {60., 278.5e6}}})
    {
      std::vector<double> at, beside;
      for (const auto &[angle, its] : stiffness)
        {
          at.push_back(angle * degree);
          beside.push_back(beside_dents(steel, its, touches, on));
        }
      const contact::SeatMotion seat(
          {{at[0], at[2], at[3]}}, {{beside[0], beside[2], beside[3]}}, touches, 66. * degree);
      for (const unsigned int i : {1u, 4u})
        {
          const double all  = 1. / std::next(stiffness.begin(), i)->second,
                       more = seat(at[i], at[i]) - beside[i];
          worst             = std::max(worst, std::abs(more / all));
        }
    }
  check("  elastic solutions between and beyond within 4 %", worst < 0.04, worst);

  const auto strip_at = [&](const double angle) {
    return static_cast<unsigned int>(
        std::lower_bound(profile.slopes().begin(), profile.slopes().end(), angle) -
        profile.slopes().begin());
  };
  const unsigned int a = strip_at(0.85), b = strip_at(-0.85);
  check("  the other side of the gap moves away",
        strips.at(a, b) < none.at(a, b),
        strips.at(a, b) - none.at(a, b));
}
} // namespace

int main(int argc, char ** /*argv*/)
{
  with_numbers = argc > 1;
  const Material        steel;
  const auto            chain = drive::make_chain(parameters::Chain());
  parameters::Sprockets sprockets;
  sprockets.driver().outside_diameter  = 81.8e-3;
  const drive::ToothForm          form = drive::make_tooth_form(15, chain, sprockets, 0);
  const contact::ToothStrips      profile(form, R);
  const contact::StripGrid       &grid = profile.grid();
  const contact::StripFlexibility strips(disc(steel), grid, {0}, {length}, steel, {1e20, 0.2});

  // on the flank, in the middle of a strip and where two meet
  const unsigned int on_flank = grid.size() * 4 / 5;
  const double       middle = grid.middle[on_flank], end = middle + grid.half_width[on_flank];
  for (const double radius : {1e3, form.flank_radius})
    {
      std::cout << (radius > 1. ? "a flat" : "a convex flank") << '\n';
      const double curvature = 1. / R + 1. / radius;
      for (const double load : {100., 500., 1412., 5000.})
        {
          const double hertz = approach_of_hertz(steel, curvature, load);
          double       worst = 0.;
          for (const double at : {middle, end})
            {
              const double found = at_load(strips, at, curvature, load).first / hertz - 1.;
              if (with_numbers)
                std::cerr << load << " N, " << 1e6 * hertz << " um: " << found << '\n';
              worst = std::max(worst, std::abs(found));
            }
          check("  approach under " + std::to_string(int(load)) + " N within 3 % and 0.05 um",
                worst < 0.03 + 0.05e-6 / hertz,
                worst);
        }
    }
  std::cout << "the seat\n";
  const double play = form.seat_radius - R, curvature = 1. / R - 1. / form.seat_radius;
  for (const double load : {100., 500., 1412., 5000.})
    {
      const auto hole  = drive::conforming_contact(R, play, load / length, steel);
      double     worst = 0., least = 1., most = 0.;
      for (const double at :
           {0., grid.half_width[grid.size() / 2], 2. * grid.half_width[grid.size() / 2], 0.5, 0.57})
        {
          const auto found = at_load(strips, at, curvature, load);
          if (with_numbers)
            std::cerr << load << " N at " << at << " rad, half angle " << hole.half_angle
                      << ": peak " << found.second / hole.peak_pressure << ", approach "
                      << 1e6 * found.first << '\n';
          worst = std::max(worst, std::abs(found.second / hole.peak_pressure - 1.));
          least = std::min(least, found.first);
          most  = std::max(most, found.first);
        }
      if (load > 100.)
        check("  peak under " + std::to_string(int(load)) + " N within 6 %", worst < 0.06, worst);
      check("  approach at any place under " + std::to_string(int(load)) + " N within 0.05 um",
            most - least < 0.05e-6,
            1e6 * (most - least));
    }

  check_places(disc(steel), profile, form, steel);

  // strips near a roller's centre, from the seat out to the tips and far away, one by one
  unsigned int n_found = 0, n_wrong = 0;
  for (const double x : {0.8, 0.95, 1., 1.02, 1.2})
    for (const double y : {-0.1, -0.01, 0., 0.03})
      for (const double distance : {0.5 * R, R, 1.001 * R, 1.1 * R, 3. * R})
        {
          dealii::Tensor<1, 2> centre;
          centre[0] = x * 0.5 * form.pitch_diameter;
          centre[1] = y * 0.5 * form.pitch_diameter;
          std::vector<unsigned int> found, near = {7};
          for (unsigned int s = 0; s < profile.strips().size(); ++s)
            if ((profile.strips()[s].middle - centre).norm() <= distance)
              found.push_back(s);
          profile.find_near(centre, distance, near);
          n_found += found.size();
          n_wrong += near == found ? 0 : 1;
        }
  verdict("strips near a point, several thousand of 100 points", n_wrong == 0 && n_found > 2000);
}
