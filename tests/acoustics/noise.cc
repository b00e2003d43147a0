// SPDX-License-Identifier: LGPL-2.1-or-later
// The noise of rollers whose motion is known: levels of one that oscillates against the closed form
// of its dipole, its image in a floor, what each roller and each sprocket contributes, the peaks of
// pitch periods, and what is refused.
#include <chaindrive/acoustics/noise.h>
#include <chaindrive/utilities/errors.h>

#include <deal.II/base/numbers.h>

#include <array>
#include <cmath>
#include <complex>
#include <iostream>
#include <string>
#include <vector>

using namespace chaindrive;
using namespace chaindrive::acoustics;

namespace
{
using Vector3       = dealii::Tensor<1, 3>;
using Point         = std::array<double, 3>;
constexpr double pi = dealii::numbers::PI, pitch_time = 3.469e-3;

Vector3 vector(const double x, const double y, const double z = 0.)
{
  Vector3 v;
  v[0] = x;
  v[1] = y;
  v[2] = z;
  return v;
}

void verdict(const std::string &what, const bool holds)
{
  std::cout << what << ": " << (holds ? "yes" : "NO") << '\n';
}

Site make_site()
{
  Site site{};
  site.engagement    = vector(0., 0.04);
  site.along         = vector(1., 0.);
  site.outward       = vector(0., 1.);
  site.sprockets     = {{"driver", "driver", vector(0., 0.), 0.03},
                        {"driven", "driven sprocket", vector(0.64, 0.), 0.03}};
  site.extent        = 0.8;
  site.lowest        = -0.15;
  site.pitch         = 15.875e-3;
  site.roller_radius = 5.08e-3;
  site.roller_length = 7e-3;
  site.pitch_time    = pitch_time;
  return site;
}

/// Rollers that stay at @p places and oscillate along y with amplitudes [m/s2] at twice the tooth
/// frequency; samples @p step [s] apart.
Motion make_motion(const std::vector<Vector3> &places,
                   const std::vector<double>  &amplitudes,
                   const double                step     = 20e-6,
                   const double                duration = 30e-3)
{
  const double omega = 2. * pi * 2. / pitch_time;
  Motion       motion;
  for (std::size_t i = 0; i * step < duration; ++i)
    motion.time.push_back(i * step);
  const std::size_t         n = motion.time.size();
  const std::vector<double> rest(n, 0.);
  for (std::size_t k = 0; k < places.size(); ++k)
    {
      motion.velocity[0].push_back(rest);
      motion.velocity[1].push_back(rest);
      for (std::size_t i = 0; i < n; ++i)
        motion.velocity[1].back()[i] = amplitudes[k] / omega * std::sin(omega * motion.time[i]);
      for (unsigned int d = 0; d < 2; ++d)
        motion.position[d].emplace_back(n, places[k][d]);
    }
  return motion;
}

/// Complex amplitude [Pa] of such a roller at @p at, and of its image in a floor at y = @p floor.
std::complex<double> dipole(const Vector3 &place, const Vector3 &at, const double amplitude)
{
  const Air                  air;
  const double               omega = 2. * pi * 2. / pitch_time, r = (at - place).norm();
  const std::complex<double> s(0., omega);
  const double               mass = dipole_mass(air, 5.08e-3, 7e-3);
  return mass / (4. * pi) * amplitude * (at[1] - place[1]) / (r * r) * (s / air.speed + 1. / r) *
         std::exp(-s * r / air.speed);
}

double level_of(const std::complex<double> &amplitude) { return level(0.5 * std::norm(amplitude)); }

Noise listen_to(const Motion                &motion,
                const parameters::Acoustics &settings,
                const Site                  &site = make_site())
{
  return compute_noise(motion, site, settings, 10e-3, 30e-3, "histories.h5");
}

template <typename Function>
void refusal(const Function &function)
{
  try
    {
      function();
      std::cout << "NOT refused\n";
    }
  catch (const InputError &error)
    {
      std::cout << error.what() << '\n';
    }
}

void one_roller()
{
  parameters::Acoustics settings;
  const Vector3         place = vector(0.01, 0.04);
  const Noise           noise = listen_to(make_motion({place}, {100.}), settings);
  std::cout << noise.periods << " periods, " << noise.observers.size() << " observers from "
            << noise.observers.front().observer.name << " to "
            << noise.observers.back().observer.name << ", up to " << noise.bands.back().name
            << " Hz\n";
  double worst = 0., orders = 0., largest_other = -1e3;
  for (const ReceivedSound &received : noise.observers)
    {
      const double exact = level_of(dipole(place, received.observer.position, 100.));
      worst              = std::max(worst, std::abs(received.level - exact));
      orders             = std::max(orders, std::abs(received.orders[1] - exact));
      for (std::size_t i = 0; i < received.orders.size(); ++i)
        if (i != 1)
          largest_other = std::max(largest_other, received.orders[i] - exact);
    }
  verdict("levels at all observers to 0.02 dB", worst < 0.02);
  verdict("all of it at the second order, to 0.02 dB", orders < 0.02);
  verdict("others are 60 dB below", largest_other < -60.);
  const ReceivedSound &first = noise.observers.front();
  std::cout << "peak over amplitude "
            << std::round(100. * first.peak /
                          std::abs(dipole(place, first.observer.position, 100.))) /
                   100.
            << ", in " << first.engagement_peaks.size() << " periods\n";
  double off = 0.;
  for (std::size_t i = 0; i < noise.angles.size(); ++i)
    {
      const Vector3 at =
          vector(0., 0.04) + 0.4 * vector(std::cos(noise.angles[i]), std::sin(noise.angles[i]));
      off = std::max(off, std::abs(noise.directivity[i] - level_of(dipole(place, at, 100.))));
    }
  verdict("directivity to 0.02 dB", off < 0.02 && noise.angles.size() == 17);
}

void floor_and_contributions()
{
  parameters::Acoustics settings;
  settings.observers  = {Point{{0.1, 0.5, 0.2}}, Point{{-0.3, 0.1, 0.}}};
  settings.floor      = -0.4;
  const Vector3 place = vector(0.01, 0.04), image = vector(0.01, -0.84);
  const Vector3 other_place = vector(0.6, 0.1), other_image = vector(0.6, -0.9);
  const Noise   noise = listen_to(make_motion({place, other_place}, {100., -50.}), settings);
  double        worst = 0.;
  const auto pair = [](const Vector3 &a, const Vector3 &b, const Vector3 &at, const double size) {
    return dipole(a, at, size) - dipole(b, at, size);
  };
  for (const ReceivedSound &received : noise.observers)
    {
      const Vector3 &at = received.observer.position;
      worst =
          std::max(worst,
                   std::abs(received.level - level_of(pair(place, image, at, 100.) +
                                                      pair(other_place, other_image, at, -50.))));
    }
  verdict("two rollers over a floor to 0.02 dB", worst < 0.02);
  const Vector3 at     = noise.observers.front().observer.position;
  const double  driver = level_of(pair(place, image, at, 100.));
  const double  driven = level_of(pair(other_place, other_image, at, -50.));
  verdict("contributions of rollers and sprockets to 0.02 dB",
          std::abs(noise.rollers[0] - driver) < 0.02 &&
              std::abs(noise.rollers[1] - driven) < 0.02 &&
              std::abs(noise.contributions[0] - driver) < 0.02 &&
              std::abs(noise.contributions[1] - driven) < 0.02);
}

/// Rollers beside each of three sprockets; one where the lines midway between two of them meet, a
/// third of which is each one's; one midway between the first two and far from the third.
void three_sprockets()
{
  Site          site  = make_site();
  const Vector3 third = vector(0.32, 0.4);
  site.sprockets.insert(site.sprockets.begin() + 1, Site::Sprocket{"idler", "idler", third, 0.03});
  parameters::Acoustics settings;
  settings.observers                = {Point{{0.1, 0.5, 0.2}}};
  const std::vector<Vector3> places = {vector(0.01, 0.04), vector(0.35, 0.44), vector(0.6, 0.1)};
  const std::vector<double>  amplitudes = {100., 60., -50.};
  const Vector3              at         = vector(0.1, 0.5, 0.2);
  double                     worst      = 0.;
  const Noise                apart = listen_to(make_motion(places, amplitudes), settings, site);
  for (std::size_t s = 0; s < 3; ++s)
    worst = std::max(
        worst, std::abs(apart.contributions[s] - level_of(dipole(places[s], at, amplitudes[s]))));
  verdict("three sprockets: each has its own roller, to 0.02 dB",
          apart.contributions.size() == 3 && worst < 0.02);

  const Vector3 amid = vector(0.32, 0.5 * (0.4 - 0.32 * 0.32 / 0.4));
  const Noise   even = listen_to(make_motion({amid}, {100.}), settings, site);
  worst              = 0.;
  for (const double level : even.contributions)
    worst = std::max(worst, std::abs(level - level_of(dipole(amid, at, 100. / 3.))));
  verdict("a third of a roller amid them is each one's, to 0.02 dB", worst < 0.02);

  const Vector3 between = vector(0.32, -0.1);
  const Noise   halves  = listen_to(make_motion({between}, {100.}), settings, site);
  const double  half    = level_of(dipole(between, at, 50.));
  verdict("half of one between two is either one's, to 0.02 dB, and nothing the third one's",
          std::abs(halves.contributions[0] - half) < 0.02 &&
              std::abs(halves.contributions[2] - half) < 0.02 &&
              halves.contributions[1] < half - 100.);
}

void refusals()
{
  parameters::Acoustics settings;
  const Motion          motion = make_motion({vector(0.01, 0.04)}, {100.});
  settings.floor               = -0.1;
  refusal([&] { listen_to(motion, settings); });
  settings.floor.reset();
  settings.highest_frequency = 30e3;
  refusal([&] { listen_to(motion, settings); });
  settings.highest_frequency.reset();
  settings.observers = {Point{{0.02, 0.04, 0.}}};
  refusal([&] { listen_to(motion, settings); });
  settings.observers.clear();
  Motion shifted = motion;
  shifted.time[50] += 3e-6;
  refusal([&] { listen_to(shifted, settings); });
  refusal([&] { compute_noise(motion, make_site(), settings, 27e-3, 30e-3, "histories.h5"); });
  refusal([&] { listen_to(make_motion({vector(0.01, 0.04)}, {100.}, 1.7e-3), settings); });
  refusal([&] { listen_to(make_motion({vector(0.01, 0.04)}, {100.}, 1.8e-3, 60e-3), settings); });
  for (const std::string &note :
       listen_to(make_motion({vector(0.01, 0.04)}, {100.}, 50e-6), settings).notes)
    std::cout << note << '\n';
}
} // namespace

int main()
{
  one_roller();
  floor_and_contributions();
  three_sprockets();
  refusals();
}
