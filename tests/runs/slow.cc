// SPDX-License-Identifier: LGPL-2.1-or-later
// The simple model at 6 rad/s without friction against theories without inertia: the mean speed
// ratio is 15/42; its ripple with the pitch is that of the rigid four-bar linkage; every roller
// that sits on the driver hands on the part sin(phi) / sin(phi + alpha) of its link's tension, phi
// the pressure angle of its own contact and alpha the pitch angle (Naji and Marshek 1983).
#include "../support/ranges.h"
#include "../support/table.h"

#include <chaindrive/drive/drive.h>
#include <chaindrive/drive/four_bar.h>
#include <chaindrive/model/reading.h>

#include <algorithm>
#include <cmath>
#include <complex>

using namespace chaindrive;

int main()
{
  test::run("prm/verification/slow.prm", {"Output/CSV=true", "Output/History interval in us=500"});
  const std::string  file  = std::string(SOURCE_DIR) + "/../../prm/verification/slow.prm";
  const drive::Drive drive = drive::make_drive(model::read_parameters(file).parameters);
  const test::Table  hubs("results/histories_hubs.csv"), rollers("results/histories_rollers.csv"),
      links("results/histories_links.csv");
  const std::vector<double> &driver = hubs["driver_angle"], &driven = hubs["driven_angle"];
  const std::size_t          last        = driver.size() - 1;
  const double               pitch_angle = drive.sprockets[0].form.pitch_angle();

  // the last ten whole pitches; the sample where they begin lies between two
  const double begin = driver[last] - 10. * pitch_angle;
  std::size_t  first = 0;
  while (driver[first] < begin)
    ++first;
  const double prescribed = 6. * (hubs["time"][last] - 0.5 * 0.15); // a ramp of 150 ms
  test::range(
      "driver's angle at the end / prescribed", driver[last] / prescribed, 1. - 1e-6, 1. + 1e-6);

  // Mean ratio: how far the driven sprocket is ahead of 15/42 of the driver's angle, averaged over
  // the first and over the last of the pitches, since the driven inertia rings on the tight span.
  const auto ahead = [&](const double from) {
    double sum = 0., n = 0.;
    for (std::size_t i = 0; i <= last; ++i)
      if (driver[i] >= from && driver[i] < from + pitch_angle)
        {
          sum += driven[i] - 15. / 42. * driver[i];
          n += 1.;
        }
    return sum / n;
  };
  const double mean =
      15. / 42. + (ahead(driver[last] - pitch_angle) - ahead(begin)) / (9. * pitch_angle);
  test::range("mean speed ratio / (15/42)", mean / (15. / 42.), 1. - 1e-4, 1. + 1e-4);

  // First harmonic of the ratio from the angle between them: its derivative by the driver's angle.
  const double         rest     = driven[first] - mean * driver[first];
  std::complex<double> harmonic = 0.;
  for (std::size_t i = first; i <= last; ++i)
    {
      const double weight = i == last  ? 0.5 * (driver[i] - driver[i - 1]) :
                            i == first ? 0.5 * (driver[i + 1] - driver[i]) + (driver[i] - begin) :
                                         0.5 * (driver[i + 1] - driver[i - 1]);
      const double ripple = driven[i] - mean * driver[i] - rest;
      harmonic += weight * ripple * std::polar(1., -15. * driver[i]);
    }
  const double measured = 15. * 2. * std::abs(harmonic) / (10. * pitch_angle);

  const unsigned int   n     = 360;
  std::complex<double> rigid = 0.;
  unsigned int         k     = 0;
  for (const double ratio : drive::four_bar_ratios(
           drive.layout.centre_distance(), drive.chain.loaded_pitch(), 15, 42, n))
    rigid += ratio * std::polar(1., -2. * M_PI * k++ / n);
  test::range("first pitch harmonic / that of the rigid four-bar",
              measured / (2. * std::abs(rigid) / n),
              0.97,
              1.03);

  // Tooth loads, by the place of the roller on the wrap: means over all samples of the window.
  std::vector<double> load(16, 0.), theory(16, 0.), count(16, 0.);
  for (std::size_t i = first; i <= last; ++i)
    for (unsigned int roller = 0; roller < drive.layout.joints.size(); ++roller)
      {
        const std::string name  = " " + std::to_string(roller);
        const double      force = rollers["driver_force" + name][i];
        if (force == 0.)
          continue;
        const dealii::Point<2> at(rollers["position_x" + name][i], rollers["position_y" + name][i]);
        const double           turned = drive.layout.sprockets[0].angle + driver[i];
        const dealii::Point<2> local(std::cos(turned) * at[0] + std::sin(turned) * at[1],
                                     -std::sin(turned) * at[0] + std::cos(turned) * at[1]);
        const auto             contact = drive.sprockets[0].form.closest_point(local);
        dealii::Tensor<1, 2>   normal;
        normal[0] = std::cos(turned) * contact.normal[0] - std::sin(turned) * contact.normal[1];
        normal[1] = std::sin(turned) * contact.normal[0] + std::cos(turned) * contact.normal[1];

        // links towards the tight span and onwards, and the angle between them
        const unsigned int N      = static_cast<unsigned int>(drive.layout.joints.size());
        const auto         centre = [&](const unsigned int r) {
          const std::string other = " " + std::to_string(r % N);
          return dealii::Point<2>(rollers["position_x" + other][i],
                                  rollers["position_y" + other][i]);
        };
        const dealii::Tensor<1, 2> tight =
            (centre(roller + N - 1) - at) / (centre(roller + N - 1) - at).norm();
        const dealii::Tensor<1, 2> on =
            (centre(roller + 1) - at) / (centre(roller + 1) - at).norm();
        const double tension = links["tension " + std::to_string((roller + N - 1) % N)][i];
        const double alpha   = std::acos(std::clamp(-(tight * on), -1., 1.));
        const double phi     = std::acos(std::clamp(-(tight * normal), -1., 1.));
        // places counted from the first gap in which the chain bends
        const double   angle = std::atan2(at[1], at[0]);
        const unsigned place = static_cast<unsigned>(
            std::lround(((angle < 0 ? angle + 2 * M_PI : angle) - M_PI / 2) / pitch_angle + 0.5));
        if (place >= load.size() || tension < 50.)
          continue;
        load[place] += force;
        theory[place] += tension * std::sin(alpha) / std::sin(phi + alpha);
        count[place] += 1.;
      }
  unsigned int places = 0;
  for (unsigned int p = 0; p < load.size(); ++p)
    if (count[p] > 0.5 * (last - first)) // always occupied
      test::range("tooth load / Naji-Marshek, roller " + std::to_string(++places),
                  load[p] / theory[p],
                  0.95,
                  1.05);
}
