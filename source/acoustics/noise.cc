// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/acoustics/noise.h>
#include <chaindrive/acoustics/record.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace chaindrive::acoustics
{
namespace
{
using Vector3       = dealii::Tensor<1, 3>;
constexpr double pi = dealii::numbers::PI;

/// Upper edge of the last band of a third octave that is asked for, that of 20 kHz.
double edge_of_hearing() { return third_octaves(20e3, 20e3).front().high; }

constexpr double roll_off = 1.1; ///< nothing is left at so many times the highest frequency

Vector3 at_angle(const Site &site, const double radius, const double angle)
{
  return site.engagement + radius * (std::cos(angle) * site.along + std::sin(angle) * site.outward);
}

/// Angles of the directivity: outside of the drive, and not in the chain's way.
std::vector<double> angles_of_directivity()
{
  std::vector<double> angles;
  for (int degrees = 10; degrees <= 170; degrees += 10)
    angles.push_back(degrees * pi / 180.);
  return angles;
}

double lowest_of(const std::vector<Observer> &observers)
{
  double lowest = std::numeric_limits<double>::infinity();
  for (const Observer &observer : observers)
    lowest = std::min(lowest, observer.position[1]);
  return lowest;
}

/// The highest frequency that samples @p step [s] apart tell of, Hz.
double possible_frequency(const double step) { return 0.5 / (step * roll_off); }

/// InputError where samples @p step [s] apart do not tell of the highest frequency that is asked
/// for. @p samples: which they are, in words.
void check_highest_frequency(const parameters::Acoustics &settings,
                             const double                 step,
                             const std::string           &samples)
{
  const double possible = possible_frequency(step);
  const double highest  = settings.highest_frequency.value_or(0.);
  if (highest > possible * (1. + 1e-9))
    throw InputError("Acoustics/Highest frequency in kHz = " + to_text(1e-3 * highest) +
                     " is too high: " + samples + " are " + to_text(1e6 * step, 4) +
                     " us apart, which tells of " + to_text_at_most(1e-3 * possible, 4) +
                     " kHz at most. Choose a lower one, or run with a shorter Output/History "
                     "interval in us.");
}

/// The highest frequency that samples @p step [s] apart tell of, or the one asked for.
double
highest_frequency(const parameters::Acoustics &settings, const double step, const std::string &name)
{
  check_highest_frequency(settings, step, "the samples of '" + name + "', dataset /time,");
  return settings.highest_frequency.value_or(std::min(possible_frequency(step), edge_of_hearing()));
}

/// Says which bands are missing.
std::string
missing_bands(const std::vector<Band> &bands, const Spectrum &spectrum, const double step)
{
  std::string low, high;
  for (const Band &band : third_octaves(20., 20e3))
    {
      const auto is_same = [&band](const Band &b) { return b.name == band.name; };
      if (std::any_of(bands.begin(), bands.end(), is_same))
        continue;
      std::string &list = band.low < 0.5 * spectrum.spacing ? low : high;
      list += (list.empty() ? "" : ", ") + band.name;
    }
  std::string sentence;
  if (!low.empty())
    sentence = "The record of " + to_text(1e3 / spectrum.spacing, 4) +
               " ms is too short for the third octaves " + low + " Hz; they are left out.";
  if (!high.empty())
    sentence += (sentence.empty() ? "" : " ") + ("The third octaves " + high) +
                " Hz lie above the highest frequency, with samples " + to_text(1e6 * step, 4) +
                " us apart; they are left out.";
  return sentence;
}

/// Rollers as sources of sound.
class Sources
{
public:
  /// @p regular is of the times of @p motion.
  Sources(const Motion                &motion,
          const Regular               &regular,
          const Site                  &site,
          const parameters::Acoustics &settings,
          const double                 highest)
      : motion_(motion)
      , regular_(regular)
      , strands_(site.strands)
      , mass_(dipole_mass({settings.air_density, settings.speed_of_sound},
                          site.roller_radius,
                          site.roller_length))
  {
    const double step = regular_.grid().step;
    // forty times in the shortest period: what add_pressure() then takes away is 0.05 dB
    refinement_ = static_cast<std::size_t>(std::ceil(40. * step * highest));
    // a sphere of the same dipole: 2 pi rho a^3
    const double radius = std::cbrt(mass_ / (2. * pi * settings.air_density));
    response_           = [=, sound = settings.speed_of_sound, finite = settings.finite_rollers](
                    const double frequency) -> std::complex<double> {
      const double pass = passed(frequency, highest, step);
      return finite && pass > 0. ? pass * sphere_response(frequency, radius, sound) : pass;
    };
  }

  Source source(const std::size_t k) const
  {
    const Grid       &coarse = regular_.grid();
    const double      step   = coarse.step / static_cast<double>(refinement_);
    const std::size_t size   = (coarse.size - 2) * refinement_ + 1;
    // strands move alike, side by side, and their pressures add up
    Source source{{coarse.start + 0.5 * coarse.step, step, size}, {}, {}, strands_ * mass_};
    source.position.resize(size);
    source.acceleration.resize(size);
    for (unsigned int d = 0; d < 2; ++d)
      {
        const auto a = refine(differences(regular_(motion_.velocity[d][k]), coarse.step),
                              coarse.step,
                              refinement_,
                              response_);
        for (std::size_t i = 0; i < size; ++i)
          source.acceleration[i][d] = a[i];
        place(source, d, motion_.position[d][k]);
      }
    return source;
  }

private:
  /// Straight between samples: wrong by an eighth of the acceleration times the square of their
  /// distance, less than a micrometre.
  void place(Source &source, const unsigned int d, const std::vector<double> &x) const
  {
    std::size_t j = 0;
    for (std::size_t i = 0; i < source.grid.size; ++i)
      {
        const double t = source.grid.time(i);
        while (j + 2 < motion_.time.size() && motion_.time[j + 1] < t)
          ++j;
        const double share    = (t - motion_.time[j]) / (motion_.time[j + 1] - motion_.time[j]);
        source.position[i][d] = x[j] + share * (x[j + 1] - x[j]);
      }
  }

  const Motion  &motion_;
  const Regular &regular_;
  const double   strands_;
  const double   mass_;
  std::size_t    refinement_;
  Response       response_;
};

/// The image in a rigid floor: at the mirrored place with the mirrored motion.
Source mirrored(Source source, const double floor)
{
  for (Vector3 &x : source.position)
    x[1] = 2. * floor - x[1];
  for (Vector3 &a : source.acceleration)
    a[1] = -a[1];
  return source;
}

/// How much of a roller at @p x is each sprocket's; the sum is one. Of two sprockets it is all that
/// of the nearer one, and half of it midway between them. Of several, each takes the product of
/// what would be its own beside each of the others: the nearest one has at least half of every
/// factor.
void share_out(const Vector3 &x, const Site &site, std::vector<double> &shares)
{
  const std::size_t n = site.sprockets.size();
  shares.assign(n, 1.);
  double sum = 0.;
  for (std::size_t s = 0; s < n; ++s)
    {
      for (std::size_t other = 0; other < n; ++other)
        if (other != s)
          {
            const Vector3 &own = site.sprockets[s].centre, &far = site.sprockets[other].centre;
            const double   inside = (0.5 * (own + far) - x) * (far - own) / (far - own).norm();
            shares[s] *= std::clamp(0.5 + inside / site.pitch, 0., 1.);
          }
      sum += shares[s];
    }
  for (double &share : shares)
    share /= sum;
}

/// The parts of @p source for which the sprockets stand, but for the last one, whose part is the
/// rest.
std::vector<Source> parts_of(const Source &source, const Site &site)
{
  std::vector<Source> parts(site.sprockets.size() - 1, source);
  std::vector<double> shares;
  for (std::size_t i = 0; i < source.grid.size; ++i)
    {
      share_out(source.position[i], site, shares);
      for (std::size_t s = 0; s < parts.size(); ++s)
        parts[s].acceleration[i] *= shares[s];
    }
  return parts;
}

void check_distance(const Observer &observer, const Source &source, const Site &site)
{
  for (const Vector3 &x : source.position)
    if (const double distance = (observer.position - x).norm(); distance < site.pitch)
      throw InputError("Acoustics/Observers: the observer " + observer.name + " at " +
                       to_text(observer.position[0]) + " " + to_text(observer.position[1]) + " " +
                       to_text(observer.position[2]) + " m comes within " +
                       to_text(1e3 * distance, 3) +
                       " mm of a roller; sound is computed from one pitch on, " +
                       to_text(1e3 * site.pitch, 4) + " mm.");
}

void check_floor(const parameters::Acoustics &settings,
                 const Site                  &site,
                 const std::vector<Observer> &observers)
{
  const double lowest = std::min(site.lowest, lowest_of(observers));
  if (settings.floor && *settings.floor >= lowest)
    throw InputError("Acoustics/Floor height in m = " + to_text(*settings.floor) +
                     " must lie below the drive and all observers, whose lowest is at y = " +
                     to_text_at_most(lowest, 4) + " m.");
}

void check_rollers(const parameters::Acoustics &settings, const Site &site)
{
  if (site.roller_length < 2. * shortest_cylinder * site.roller_radius)
    throw InputError(
        "Acoustics/Noise: the rollers are " + to_text(1e3 * site.roller_length, 4) +
        " mm long and " + to_text(2e3 * site.roller_radius, 4) +
        " mm in diameter; the sound of cylinders is known from a length of a quarter of "
        "the diameter on. Choose a longer Drive/Chain/Roller length in mm, or no noise.");
  constexpr double fastest = 0.8; // parts of the chain run faster than the whole
  if (const double speed = site.pitch / site.pitch_time; speed > fastest * settings.speed_of_sound)
    throw InputError("Acoustics/Speed of sound in m/s = " + to_text(settings.speed_of_sound, 4) +
                     ": the chain runs at " + to_text(speed, 4) +
                     " m/s; sound is computed of chains slower than " + to_text(fastest) +
                     " of that.");
}

void check_observers(const Site &site, const std::vector<Observer> &observers)
{
  for (const Observer &observer : observers)
    for (const Site::Sprocket &sprocket : site.sprockets)
      {
        const double  radius = sprocket.tip_radius;
        const Vector3 arm    = observer.position - sprocket.centre;
        if (std::hypot(arm[0], arm[1]) < radius && std::abs(arm[2]) < site.pitch)
          throw InputError("Acoustics/Observers: the observer " + observer.name + " at " +
                           to_text(observer.position[0]) + " " + to_text(observer.position[1]) +
                           " " + to_text(observer.position[2]) +
                           " m lies in a sprocket: at least a pitch of " +
                           to_text_at_least(1e3 * site.pitch, 4) +
                           " mm before or behind its plane, or outside of its radius of " +
                           to_text_at_least(1e3 * radius, 4) + " mm, is allowed.");
      }
}

void check_samples(const Regular &regular, const std::string &name)
{
  if (regular.largest_shift() > 0.1)
    throw InputError("'" + name +
                     "', dataset /time: the samples are not equally far apart; one is " +
                     to_text(100. * regular.largest_shift(), 3) +
                     " % of their distance out of place, and 10 % are accepted. Run with an "
                     "Output/History interval in us of ten steps or more, or of whole steps.");
}

/// The times at which sound is received: whole pitch periods, the last ones.
Noise prepare(const Motion                &motion,
              const Site                  &site,
              const parameters::Acoustics &settings,
              const double                 start,
              const double                 end,
              const double                 highest,
              const std::string           &name)
{
  const double step  = (motion.time.back() - motion.time.front()) / (motion.time.size() - 1.);
  const double last  = std::min(end, motion.time.back() - step);
  const double first = std::max(start, motion.time.front() + step + longest_delay(settings, site));
  const double periods = std::floor((last - first) / site.pitch_time + 1e-6);
  if (!(periods >= 1.))
    throw InputError("'" + name + "': there is no whole pitch time of " +
                     to_text(1e3 * site.pitch_time, 4) + " ms to be received between " +
                     to_text(1e3 * first, 4) + " and " + to_text(1e3 * last, 4) +
                     " ms. Choose a longer window, or run longer.");
  if (highest < 1. / site.pitch_time)
    throw InputError("'" + name + "', dataset /time: the samples are " + to_text(1e6 * step, 4) +
                     " us apart, which tells nothing of the tooth frequency of " +
                     to_text(1. / site.pitch_time, 4) +
                     " Hz. Run with a shorter Output/History interval in us.");
  Noise noise{};
  noise.highest = highest;
  noise.periods = static_cast<unsigned int>(std::min(periods, 1e6));
  // four and a half samples in the shortest period
  const auto   per_period = static_cast<std::size_t>(std::ceil(4.5 * highest * site.pitch_time));
  const double length     = noise.periods * site.pitch_time;
  noise.grid = {last - length, site.pitch_time / per_period, per_period * noise.periods};
  return noise;
}

/// All that is said of a pressure.
void judge(ReceivedSound &received, const Noise &noise, const Site &site)
{
  const auto levels = [](std::vector<double> squares) {
    std::transform(squares.begin(), squares.end(), squares.begin(), level);
    return squares;
  };
  const auto magnitude   = [](const double a, const double b) { return std::max(a, std::abs(b)); };
  received.spectrum      = make_spectrum(received.pressure, noise.grid.step);
  received.level         = level(mean_square(received.spectrum, noise.highest));
  received.level_a       = level(a_weighted_mean_square(received.spectrum, noise.highest));
  received.third_octaves = levels(in_bands(received.spectrum, noise.bands));
  received.orders        = levels(order_lines(received.spectrum, noise.periods, noise.highest));
  const auto around      = [&](const Weighting weighting) {
    return level_uncertainty(
        mean_squares_of_parts(
            received.pressure, noise.grid.step, noise.periods, noise.highest, weighting),
        site.pitches_per_period);
  };
  received.level_uncertainty   = around(Weighting::none);
  received.level_a_uncertainty = around(Weighting::a);
  const auto period            = static_cast<std::ptrdiff_t>(noise.grid.size / noise.periods);
  for (auto begin = received.pressure.begin(); begin != received.pressure.end(); begin += period)
    received.engagement_peaks.push_back(std::accumulate(begin, begin + period, 0., magnitude));
  received.peak =
      *std::max_element(received.engagement_peaks.begin(), received.engagement_peaks.end());
}
} // namespace

std::vector<Observer> make_observers(const parameters::Acoustics &settings, const Site &site)
{
  std::vector<Observer> observers;
  for (const auto &point : settings.observers)
    {
      Vector3 position;
      std::copy(point.begin(), point.end(), position.begin_raw());
      observers.push_back({"point " + std::to_string(observers.size() + 1), position});
    }
  if (!observers.empty())
    return observers;
  observers.push_back({"microphone", at_angle(site, settings.radius, 0.5 * pi)});
  for (const double degrees : {22.5, 67.5, 112.5, 157.5})
    for (const double axial : {-0.5, 0., 0.5})
      {
        Vector3 position = at_angle(site, settings.radius, degrees * pi / 180.);
        position[2] += axial * settings.radius;
        observers.push_back({"point " + std::to_string(observers.size()), position});
      }
  return observers;
}

void check_site(const parameters::Acoustics &settings, const Site &site)
{
  const std::vector<Observer> observers = make_observers(settings, site);
  check_rollers(settings, site);
  check_observers(site, observers);
  check_floor(settings, site, observers);
}

void check_interval(const parameters::Acoustics &settings, const Site &site, const double interval)
{
  check_highest_frequency(settings, interval, "samples of the run");
  if (possible_frequency(interval) * site.pitch_time < 1.)
    throw InputError("Acoustics/Noise: samples by Output/History interval in us, " +
                     to_text(1e6 * interval, 4) +
                     " us apart, tell nothing of the tooth frequency of " +
                     to_text(1. / site.pitch_time, 4) + " Hz. Run with an interval of at most " +
                     to_text_at_most(0.5e6 * site.pitch_time / roll_off, 3) + ".");
}

double longest_delay(const parameters::Acoustics &settings, const Site &site)
{
  double farthest = settings.radius;
  for (const Observer &observer : make_observers(settings, site))
    {
      farthest = std::max(farthest, (observer.position - site.engagement).norm());
      if (settings.floor)
        {
          Vector3 image = observer.position;
          image[1]      = 2. * *settings.floor - image[1];
          farthest      = std::max(farthest, (image - site.engagement).norm());
        }
    }
  return (farthest + site.extent) / settings.speed_of_sound;
}

Noise compute_noise(const Motion                &motion,
                    const Site                  &site,
                    const parameters::Acoustics &settings,
                    const double                 start,
                    const double                 end,
                    const std::string           &name)
{
  check_site(settings, site);
  const std::vector<Observer> observers = make_observers(settings, site);
  if (motion.time.size() < 20)
    throw InputError("'" + name + "', dataset /time: there are only " +
                     std::to_string(motion.time.size()) +
                     " samples in the window and before; 20 are needed.");
  const Regular regular(motion.time);
  check_samples(regular, name);
  const double step    = regular.grid().step;
  const double highest = highest_frequency(settings, step, name);
  Noise        noise   = prepare(motion, site, settings, start, end, highest, name);

  const std::vector<double> silence(noise.grid.size, 0.);
  const Spectrum            of_silence = make_spectrum(silence, noise.grid.step);
  noise.bands                          = bands_within(of_silence, highest);
  if (const std::string sentence = missing_bands(noise.bands, of_silence, step); !sentence.empty())
    noise.notes.push_back(sentence);
  noise.angles = angles_of_directivity();
  std::vector<ReceivedSound> arc, parts;
  for (const double angle : noise.angles)
    arc.push_back(
        {{"", at_angle(site, settings.radius, angle)}, silence, {}, 0., 0., 0., {}, {}, {}});
  for (const Observer &observer : observers)
    noise.observers.push_back({observer, silence, {}, 0., 0., 0., {}, {}, {}});

  const Air                        air{settings.air_density, settings.speed_of_sound};
  const Sources                    sources(motion, regular, site, settings, highest);
  std::vector<std::vector<double>> of_sprocket(site.sprockets.size() - 1, silence);
  const auto                       level_of = [&noise](const std::vector<double> &pressure) {
    return level(mean_square(make_spectrum(pressure, noise.grid.step), noise.highest));
  };
  const auto add_received_pressure =
      [&](const Source &source, const Vector3 &at, std::vector<double> &pressure) {
        add_pressure(air, source, at, noise.grid, pressure);
        if (settings.floor)
          add_pressure(air, mirrored(source, *settings.floor), at, noise.grid, pressure);
      };
  for (std::size_t k = 0; k < motion.n_rollers(); ++k)
    {
      const Source source = sources.source(k);
      for (ReceivedSound &received : noise.observers)
        {
          check_distance(received.observer, source, site);
          std::vector<double> own = silence;
          add_received_pressure(source, received.observer.position, own);
          for (std::size_t i = 0; i < own.size(); ++i)
            received.pressure[i] += own[i];
          if (&received == &noise.observers.front())
            noise.rollers.push_back(level_of(own));
        }
      for (ReceivedSound &received : arc)
        add_received_pressure(source, received.observer.position, received.pressure);
      const std::vector<Source> own_parts = parts_of(source, site);
      for (std::size_t s = 0; s < own_parts.size(); ++s)
        add_received_pressure(own_parts[s], observers.front().position, of_sprocket[s]);
    }

  for (ReceivedSound &received : noise.observers)
    {
      judge(received, noise, site);
      if (!std::isfinite(received.level))
        noise.notes.push_back("Nothing is received at " + received.observer.name +
                              ": no roller is accelerated in the window. It has no level.");
    }
  std::vector<double> rest = noise.observers.front().pressure;
  for (const std::vector<double> &part : of_sprocket)
    {
      noise.contributions.push_back(level_of(part));
      for (std::size_t i = 0; i < rest.size(); ++i)
        rest[i] -= part[i];
    }
  noise.contributions.push_back(level_of(rest));
  for (const ReceivedSound &received : arc)
    noise.directivity.push_back(level_of(received.pressure));
  return noise;
}
} // namespace chaindrive::acoustics
