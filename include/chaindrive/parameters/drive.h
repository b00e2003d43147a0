// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/parameters/choice.h>
#include <chaindrive/parameters/flat.h>
#include <chaindrive/parameters/guide.h>
#include <chaindrive/parameters/sections.h>
#include <chaindrive/parameters/shaft.h>
#include <chaindrive/parameters/swing.h>
#include <chaindrive/parameters/tensioner.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace chaindrive::parameters
{
class Declarations;

/// Distance of the holes in the plates; see drive::make_chain().
enum class PitchSet
{
  standard,
  paper_literal,
  nominal
};

template <>
inline constexpr Texts<PitchSet, 3> texts_of<PitchSet>{{{PitchSet::standard, "standard"},
                                                        {PitchSet::paper_literal, "paper literal"},
                                                        {PitchSet::nominal, "nominal"}}};

/// Shape of the tooth gap that a standard describes; see drive::make_tooth_form().
enum class StandardForm
{
  iso_min,
  iso_mid,
  iso_max,
  ansi
};

template <>
inline constexpr Texts<StandardForm, 4> texts_of<StandardForm>{{{StandardForm::iso_min, "iso min"},
                                                                {StandardForm::iso_mid, "iso mid"},
                                                                {StandardForm::iso_max, "iso max"},
                                                                {StandardForm::ansi, "ansi"}}};

/// Where the seat of a tooth gap lies; see drive::make_tooth_form().
enum class SeatCentre
{
  iso,
  pitch,
  bottom_diameter
};

template <>
inline constexpr Texts<SeatCentre, 3> texts_of<SeatCentre>{
    {{SeatCentre::iso, "iso"},
     {SeatCentre::pitch, "pitch"},
     {SeatCentre::bottom_diameter, "bottom diameter"}}};

/// Which entry decides the centre distance.
enum class CentreDistanceFrom
{
  given,
  slack,
  sag,
  pretension
};

template <>
inline constexpr Texts<CentreDistanceFrom, 4> texts_of<CentreDistanceFrom>{
    {{CentreDistanceFrom::given, "given"},
     {CentreDistanceFrom::slack, "slack"},
     {CentreDistanceFrom::sag, "sag"},
     {CentreDistanceFrom::pretension, "pretension"}}};

/// Which of the two spans is tight.
enum class TightSide
{
  upper,
  lower
};

template <>
inline constexpr Texts<TightSide, 2> texts_of<TightSide>{
    {{TightSide::upper, "upper"}, {TightSide::lower, "lower"}}};

/// Where the parts of the joints are at the start, and how they move.
enum class Start
{
  taut,       ///< at rest, clearances taken up
  concentric, ///< at rest, pins and bushes centred
  settled     ///< at full speed under full load, all in balance
};

template <>
inline constexpr Texts<Start, 3> texts_of<Start>{
    {{Start::taut, "taut"}, {Start::concentric, "concentric"}, {Start::settled, "settled"}}};

/// What has been done about the wear of the chain.
enum class WornChain
{
  adjusted, ///< the shafts have been moved: what is asked of slack holds for the worn chain
  shafts_kept
};

template <>
inline constexpr Texts<WornChain, 2> texts_of<WornChain>{
    {{WornChain::adjusted, "adjusted"}, {WornChain::shafts_kept, "shafts kept"}}};

/// The chain of the drive in prm/paper, of which most is known (drive/chain.cc).
inline constexpr const char *reference_chain = "525";

/// Section `Drive/Chain`. An empty optional means `auto`: from the designation, or derived from it.
struct Chain
{
  std::string  designation = reference_chain;
  unsigned int strands     = 1;             ///< side by side on common pins
  Switch       rollers = Switch::automatic; ///< automatic: as the designation has them; off: a bush
                                            ///< chain, whose bushes meet the teeth
  PitchSet            pitch_set       = PitchSet::standard;
  double              elongation      = 0.; ///< of the loaded pitch, wear: 0.01 is one percent
  double              pitch_tolerance = 0.; ///< largest random deviation of a link's pitch from it
  unsigned int        pitch_seed      = 1;
  std::vector<double> pitch_deviations; ///< m, of one link after the other, again and again
  std::optional<double> pitch, roller_diameter, roller_bore, roller_length; ///< m
  std::optional<double> bush_diameter, bush_bore, bush_length;              ///< m
  std::optional<double> pin_diameter, pin_bore, pin_length;                 ///< m
  std::optional<double> inner_plate_height, inner_plate_thickness;          ///< m
  std::optional<double> outer_plate_height, outer_plate_thickness;          ///< m
  double                waist_ratio = 0.7; ///< plate height at mid-pitch / plate height
  std::optional<double> transverse_pitch;  ///< of the middle planes of two strands, m

  /// Part of a strand in what all carry.
  double share() const { return 1. / strands; }

  /// Declares an entry for each member, which takes every value that is set. The object must
  /// outlive @p declarations.
  void declare(Declarations &declarations);
};

/// What a sprocket does.
enum class Role
{
  driver, ///< turns as the speed program says
  driven, ///< turns as the chain pulls it against the load
  idler   ///< turns as the chain pulls it, without a load
};

template <>
inline constexpr Texts<Role, 3> texts_of<Role>{
    {{Role::driver, "driver"}, {Role::driven, "driven"}, {Role::idler, "idler"}}};

/// On which side of the chain's loop a wheel is.
enum class Side
{
  inside,
  outside
};

template <>
inline constexpr Texts<Side, 2> texts_of<Side>{
    {{Side::inside, "inside"}, {Side::outside, "outside"}}};

/// What the user says of one sprocket.
struct Sprocket
{
  std::string           name; ///< of histories and entries, in small letters
  Role                  role             = Role::idler;
  unsigned int          teeth            = 17;
  std::optional<double> outside_diameter = {};       ///< m
  std::optional<double> bottom_diameter  = {};       ///< m, for SeatCentre::bottom_diameter
  std::optional<double> bore             = {};       ///< m
  std::optional<double> hub_diameter     = {};       ///< m, of the rigid zone
  std::string           mesh             = {};       ///< a Gmsh file; empty: generated
  Switch                elastic = Switch::automatic; ///< its rim; automatic: where it is needed
  int                   turn    = 1; ///< +1: the chain runs round it in the sense of the drive
  /// Of its axis, m; empty: of the first one the origin, of one other what the layout finds.
  std::optional<std::array<double, 2>> centre    = {};
  double                               direction = 0.; ///< from the first one to what is found, rad
  Holders                              held{};         ///< what holds its axis
  Swing                                swing{};        ///< the arm that moves its axis
  Bearing                              bearing{};      ///< how its shaft yields
  Coupling                             coupling{};     ///< between it and what is behind it
  Guide                                guide{};        ///< of the span behind it
  Flat                                 flat{};         ///< in the place of teeth
  double                               runout          = 0.; ///< total indicator reading, m
  double                               runout_phase    = 0.; ///< rad
  double                               axial_offset    = 0.; ///< of its plane, along z, m
  double                               tilt            = 0.; ///< of its axis from z, rad
  double                               tilt_direction  = 0.; ///< to which its axis leans, rad
  double                               index_tolerance = 0.; ///< of gaps along the pitch circle, m
  unsigned int                         index_seed      = 1;
  std::vector<double>                  index_deviations{}; ///< m, of one gap after the other

  std::optional<double> resisting_torque = {}; ///< N m, of a driven one; empty: that of Loads
  std::optional<double> inertia          = {}; ///< kg m2, of all that turns with it, or
                                               ///< is behind its coupling; empty: its own

  /// What its shaft is given besides what section Loads says: its speed where it is a driver, and
  /// the torque that resists it where it is driven. functions/terms.h knows what they are.
  Sections speed_terms = Sections("speed"), torque_terms = Sections("torque");

  /// Whether its plane is not that of the drive.
  bool is_out_of_line() const { return axial_offset != 0. || tilt != 0.; }
  bool is_flat() const { return flat.diameter.has_value(); }

  std::string in_words() const;   ///< what sentences call it
  std::string in_entries() const; ///< what names of entries begin with
};

/// Section `Drive/Sprockets`.
struct Sprockets
{
  StandardForm          tooth_form  = StandardForm::iso_min;
  SeatCentre            seat_centre = SeatCentre::iso;
  std::optional<double> width;                    ///< m
  std::optional<double> side_relief, side_radius; ///< of the sides of teeth at their tips, m
  unsigned int          facets = 0;               ///< chords of a rigid tooth, even; 0: smooth
  /// In the order in which the chain runs over them; the first one is the driver, from which the
  /// slack span leads to the second one.
  std::vector<Sprocket> list{{"driver", Role::driver, 15}, {"driven", Role::driven, 42}};

  /// Makes the list that of wheels of these @p names, all but driver and driven sprocket idlers
  /// that entries are yet to describe. InputError unless the first one is the driver, the driven
  /// one is among them, and names are different words.
  void set_order(const std::vector<std::string> &names);

  Sprocket       &driver() { return list.front(); }
  const Sprocket &driver() const { return list.front(); }
  Sprocket       &driven(); ///< the first one with a load
  const Sprocket &driven() const;

  /// Declares an entry for each member but the numbers of teeth and what is elastic, which takes
  /// every value that is set. The object, and its list, must outlive @p declarations.
  void declare(Declarations &declarations);

  /// The same for section `Drive/Wheels`: which wheels there are, and where.
  void declare_wheels(Declarations &declarations);
};

/// The entry that says which wheels there are, with each of which come entries of its own.
inline const std::string order_entry = "Drive/Wheels/Order of travel";

/// Section `Drive/Layout`.
struct Layout
{
  CentreDistanceFrom centre_distance_from = CentreDistanceFrom::slack;
  double             centre_distance      = 0.643038; ///< m, when given
  double             slack                = 0.5e-3; ///< m, total excess length of the chain as laid
  double             sag                  = 0.01;   ///< of the slack span's length
  double             pretension           = 100.;   ///< N, in both spans
  WornChain          worn_chain           = WornChain::adjusted;
  TightSide          tight_span           = TightSide::upper;
  double             start_phase          = 0.; ///< of a driver pitch, 0 <= phase < 1
  Start              start                = Start::taut;

  /// Declares an entry for each member, which takes every value that is set. The object must
  /// outlive @p declarations.
  void declare(Declarations &declarations);
};

/// Section `Drive`: the geometry of the whole drive.
struct Drive
{
  unsigned int n_links = 110; ///< 0: auto, which whoever reads the entries resolves
  Chain        chain;
  Sprockets    sprockets;
  Layout       layout;

  /// Where the wheels are, in words: what a number of links is found for.
  std::string places() const;

  /// Declares an entry for each member, which takes every value that is set. The object must
  /// outlive @p declarations.
  void declare(Declarations &declarations);
};
} // namespace chaindrive::parameters
