// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/acoustics/bands.h>
#include <chaindrive/acoustics/dipole.h>
#include <chaindrive/acoustics/spectrum.h>
#include <chaindrive/parameters/acoustics.h>

#include <deal.II/base/tensor.h>

#include <array>
#include <string>
#include <vector>

namespace chaindrive::acoustics
{
/// How the rollers of a drive moved: their histories, by roller. SI units.
struct Motion
{
  using Records = std::vector<std::vector<double>>;

  std::vector<double>    time; ///< nearly equally far apart
  std::array<Records, 2> position, velocity;

  std::size_t n_rollers() const { return velocity[0].size(); }
};

/// What the noise of a drive asks of its geometry. SI units; the drive lies in the plane z = 0.
struct Site
{
  dealii::Tensor<1, 3> engagement;  ///< where the tight span meets the driver's pitch circle
  dealii::Tensor<1, 3> along;       ///< unit, from there along the tight span
  dealii::Tensor<1, 3> outward;     ///< unit, away from the other span
  double               extent;      ///< no roller is farther from the engagement point
  double               lowest;      ///< y below which there is no roller
  double               pitch;       ///< of the chain
  unsigned int         strands = 1; ///< that move alike
  double               roller_radius, roller_length;
  double               pitch_time; ///< of the driver, s
  /// Pitch times that hold a period of the drive's slowest resonance (drive/facts.h).
  unsigned int pitches_per_period = 1;

  struct Sprocket
  {
    std::string          name, title; ///< in files and in sentences
    dealii::Tensor<1, 3> centre;
    double               tip_radius;
  };
  std::vector<Sprocket> sprockets; ///< at least one
};

struct Observer
{
  std::string          name;
  dealii::Tensor<1, 3> position;
};

/// Those of @p settings, or a microphone at a radius from the engagement point along Site::outward,
/// and twelve points on half a cylinder of that radius about the line through the engagement point
/// that is parallel to the shafts, at 22.5, 67.5, 112.5 and 157.5 degrees from Site::along and half
/// a radius before, in and behind the plane of the drive.
std::vector<Observer> make_observers(const parameters::Acoustics &settings, const Site &site);

/// InputError, with the entry that is to blame, where no sound can be computed whatever the rollers
/// do: rollers that are discs, a chain that runs about as fast as sound, observers in a sprocket, a
/// floor that is not below everything.
void check_site(const parameters::Acoustics &settings, const Site &site);

/// InputError where histories with a sample every @p interval [s] do not tell of the highest
/// frequency that @p settings ask for, or of the tooth frequency.
void check_interval(const parameters::Acoustics &settings, const Site &site, double interval);

/// By how much later than its emission any sound arrives at most, s.
double longest_delay(const parameters::Acoustics &settings, const Site &site);

/// The sound pressure that an observer receives.
struct ReceivedSound
{
  Observer            observer;
  std::vector<double> pressure; ///< Pa
  Spectrum            spectrum;
  double              level, level_a;   ///< dB re 20 uPa
  double              peak;             ///< magnitude of the pressure, Pa
  std::vector<double> third_octaves;    ///< levels by Noise::bands
  std::vector<double> orders;           ///< levels of the lines at 1, 2, ... times tooth frequency
  std::vector<double> engagement_peaks; ///< of the pressure, one for each pitch period
  /// Half of the 95 % intervals of level and level_a, from the pitch periods (level_uncertainty()),
  /// dB; not a number with too few of these.
  double level_uncertainty = 0., level_a_uncertainty = 0.;
};

/// The noise of a drive over whole pitch periods.
struct Noise
{
  Grid                       grid; ///< times at which it is received
  unsigned int               periods;
  double                     highest; ///< frequency, Hz
  std::vector<Band>          bands;
  std::vector<ReceivedSound> observers;
  std::vector<double>        contributions; ///< of Site::sprockets: levels at the first observer
  std::vector<double>        rollers;       ///< levels at the first observer
  std::vector<double>        angles;        ///< of the directivity, from Site::along, rad
  std::vector<double>        directivity;   ///< levels
  std::vector<std::string>   notes;         ///< what is to be said of it, a sentence each
};

/// The sound of all rollers as compact dipoles that move (dipole.h), received within [@p start, @p
/// end] (s), of which the last whole pitch periods count that can be received from the first sample
/// of @p motion on.
///
/// Accelerations are means over the samples, never picked ones: differences of velocities, made
/// good for the mean, limited to the highest frequency and refined before sound arrives. Each
/// roller is attributed to the sprocket that it is nearest to, gradually over a pitch.
///
/// @throws InputError, calling the histories @p name, for samples that are not equally far apart,
/// too few for a pitch period or too far apart for the highest frequency, and for an observer or a
/// floor that is in the chain's way.
Noise compute_noise(const Motion                &motion,
                    const Site                  &site,
                    const parameters::Acoustics &settings,
                    double                       start,
                    double                       end,
                    const std::string           &name);
} // namespace chaindrive::acoustics
