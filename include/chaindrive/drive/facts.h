// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/drive.h>
#include <chaindrive/files/described.h>
#include <chaindrive/files/json.h>

#include <array>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace chaindrive::drive
{
/// What a designer wants to know of a drive before it runs: closed forms for steady running at full
/// speed under full load. They know nothing of impacts and swinging. SI units, angles in rad.
///
/// Tensions, mass and strength are those of one strand; torques, inertias, loads of shafts and
/// powers of all.
struct Facts
{
  struct Sprocket
  {
    std::string      name;  ///< of histories
    std::string      title; ///< what sentences call it
    dealii::Point<2> centre;
    int              sense;   ///< of its rotation, +1: counter-clockwise
    double           arrival; ///< polar angle about the centre at which the chain arrives
    unsigned int     teeth;
    double           pitch_diameter;
    double           wrap;   ///< of the chain around it
    double           speed;  ///< mean, rad/s
    double           torque; ///< mean without losses, N m
    double polygon_effect;   ///< 1 - cos(pi / z): rise and fall of the chain's speed over it
    double seating_velocity; ///< pitch times speed: with which a link meets the sprocket, m/s
    double inertia;          ///< of all that turns with it, kg m2
    bool   idle;             ///< neither driven nor loaded by its shaft
    double load = 0.;        ///< resultant of the spans at its two ends on its shaft, N

    /// Of the inertias on both sides of its coupling, and of its mass on its bearing along x and y,
    /// without the chain, Hz; empty: rigid.
    std::optional<double>                coupling_frequency = {};
    std::optional<std::array<double, 2>> bearing_frequency  = {};
  };

  /// What a span is called for the force in it.
  enum class Label
  {
    none,
    tight, ///< none has a greater tension
    slack  ///< none has a smaller one
  };

  struct Span
  {
    std::string      name; ///< of the sprockets between which it is, in the direction of travel
    Label            label = Label::none;
    unsigned int     links;
    double           length;     ///< between the points where it leaves the pitch circles
    double           slack, sag; ///< at the start; of a settled one the sag with all stretch
    double           tension;    ///< mean, with the centrifugal one
    double           frequency;  ///< lowest in the plane, of a string or hanging chain that moves
    double           resonance;  ///< driver speed at which the tooth frequency is that, rad/s
    bool             symmetric;  ///< its mode; one of a chain that sags may be antisymmetric
    dealii::Point<2> begin, end; ///< where its straight line touches the pitch circles
  };

  /// What moves with the travel of a tensioner.
  struct Held
  {
    bool             arm; ///< its travel is a turn about the pivot, else a way along direction
    dealii::Point<2> of;  ///< pivot [m], or direction
    int              sense = 1; ///< of an arm, +1: travel turns it counter-clockwise
    double           travel;    ///< at the start, rad or m
  };

  /// The line of a guide at the start.
  struct Guide
  {
    std::string                   span; ///< name of the one beside which it is
    std::vector<dealii::Point<2>> points;
    std::optional<Held>           held = {}; ///< none: it stands still
  };

  std::string  chain;
  unsigned int strands;
  unsigned int links;
  double       pitch;        ///< nominal
  double       loaded_pitch; ///< mean distance of rollers under load
  double       mass_per_metre;
  double       tensile_strength; ///< least, of the standard's table; 0: not listed there, or the
                                 ///< chain has dimensions of its own
  bool   own_dimensions;         ///< in pitch, plates, pins, bushes or rollers
  double bearing_area;           ///< of a joint: pin diameter times length of the bush

  std::vector<Sprocket> sprockets; ///< in the order in which the chain runs over them: the driver,
  unsigned int          driven;    ///< ... and the number of the first one with a load
  double                ratio;     ///< teeth of that one over those of the driver
  double                centre_distance;
  std::vector<Span>     spans; ///< span i leads from sprocket i to the next one

  std::vector<Guide>  guides;
  std::optional<Held> tensioner = {}; ///< of a wheel
  unsigned int        tensioned = 0;  ///< that wheel, in sprockets

  double power;
  double chain_speed;
  double tooth_frequency; ///< Hz
  double pitch_time;

  double effective_tension;      ///< that does the work: power over chain speed
  double slack_tension_unloaded; ///< of the slack span without a load, without the centrifugal one
  double centrifugal_tension;    ///< loads the chain, but neither teeth nor shafts
  double start_tension;          ///< of the tight span while the speed grows; 0: starts settled
  double full_speed_from;        ///< time from which the driver's speed is steady, s
  double joint_pressure;         ///< of the tight span's tension on the bearing area, Pa
  double safety;                 ///< tensile strength over the tight span's tension; 0: unknown
  double shaft_load;             ///< resultant of both spans on the driven shaft

  double driven_inertia;   ///< of all that turns with the driven sprocket, kg m2
  double driven_frequency; ///< of that on the tight span, the driver or its motor held, Hz
  double driven_resonance; ///< driver speed at which the tooth frequency is that, rad/s

  double rated_power;   ///< usual limit for this size, teeth and speed
  double highest_speed; ///< usual limit of the driver, rad/s

  /// The span that the driver pulls in, and the one that it lets out.
  const Span &tight() const { return spans.back(); }
  const Span &slack() const { return spans.front(); }

  const Sprocket &driver() const { return sprockets.front(); }
  const Sprocket &loaded() const { return sprockets[driven]; } ///< the first one with a load
};

Facts make_facts(const Parameters &parameters, const Drive &drive);

/// Whole pitch times that hold a period of the slowest resonance that everything in the drive takes
/// part in, the driven inertia on the tight span; at least 1.
unsigned int pitches_per_resonance(const Facts &facts);

/// Member `drive` of summary.json: doc/output.md.
files::Json to_json(const Facts &facts);

/// What its members are.
std::vector<files::Described> described_facts();

/// The block at the top of plan and log.
void print(std::ostream &out, const Facts &facts);

/// The lines of that block in which @p facts differ from those @p before, under a heading of their
/// own; nothing if none does.
void print_changes(std::ostream &out, const Facts &before, const Facts &facts);

/// First frequency [Hz] of a string of this @p length [m] and @p mass per metre [kg/m] that moves
/// along itself at @p speed [m/s], under @p tension [N] with the centrifugal one.
double string_frequency(double length, double mass, double tension, double speed);

/// Speed [m/s] at which a chain of this @p pitch [m] meets that frequency with its teeth;
/// @p tension [N] without the centrifugal one, which grows with the speed.
double string_resonance(double length, double mass, double tension, double pitch);

/// Sag [m] of a span of this @p length with this @p slack [m], a flat parabola.
double parabola_sag(double length, double slack);

/// What sentences call a span, such as "tight span".
std::string in_words(const Facts::Span &span);

/// Of a span's lowest mode, in words.
std::string mode_in_words(const Facts::Span &span);
} // namespace chaindrive::drive
