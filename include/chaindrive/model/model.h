// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/drive.h>
#include <chaindrive/drive/life.h>
#include <chaindrive/model/effects.h>
#include <chaindrive/parameters/parameters.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace chaindrive::model
{
/// A number that the user gives, or else the one that is found for it.
struct Value
{
  double value = 0.;
  bool   given = false;
};

/// What all contacts have in common; coefficients of effects that are off are zero.
struct Contact
{
  double damping_ratio         = 0.; ///< of the two bodies on the penalty spring
  double roller_tooth_friction = 0., roller_bush_friction = 0., bush_pin_friction = 0.,
         plate_friction    = 0.;
  double tangential_ratio  = 0.;    ///< sticking over normal stiffness
  double penalty_factor    = 0.;    ///< of elastic bodies
  double oil_viscosity     = 0.;    ///< Pa s; 0: dry
  bool   search_every_step = false; ///< else after anything has moved far enough
};

/// Which part of the run the averages are of.
struct Window
{
  bool         waits   = false; ///< it begins when the drive has settled, else at its start
  double       start   = 0.;    ///< s; infinite if it waits
  double       end     = std::numeric_limits<double>::infinity(); ///< s; infinite: that of the run
  unsigned int pitches = 0;                                       ///< length of a window that waits
};

/// From what the meshes of parts are made.
struct Meshes
{
  parameters::Mesh cells;
  double           density = 0.;    ///< kg/m3
  bool             half    = false; ///< only what is at z >= 0
  /// Bushes and pins have nodes at the ends of what bears on them: contact without penalty is right
  /// on few cells if it reaches to these ends, where pressure is largest.
  bool exact_joints = false;
};

/// A run, decided: what a Parameters leaves open is settled here and nowhere else, and who comes
/// after it (scene, observers) gets this or a member of it. Nothing in it is `auto`.
struct Model
{
  Effects     effects;
  std::string fidelity = "simple"; ///< name of the builder of the scene

  // bodies
  bool reduced        = false; ///< elastic bodies move by modes, else by their nodes
  bool others_reduced = false; ///< bodies outside the region of interest: else rigid
  std::vector<char>
      elastic_joints; ///< per joint, whether its roller and bush arrive where elastic
                      ///< bodies must be; all, unless Elastic links = region of interest
  Value                mass_per_pitch; ///< of the whole chain, kg
  Material             material;
  parameters::Elements elements;
  Meshes               meshes;
  unsigned int         tooth_facets = 0; ///< chords of a rigid tooth; 0: smooth

  // what acts between them
  Contact             contact;
  Value               roller_tooth_stiffness, roller_bush_stiffness; ///< N/m
  Value               side_stiffness;  ///< N/m, of rigid plates; acts with misalignment
  std::vector<Value>  tooth_stiffness; ///< of each sprocket, N/m; acts with tooth compliance
  double              stiffness_per_pitch = 0.; ///< of the chain, N/m
  double              chain_damping_ratio = 0.; ///< of two lumps on their bar; 0: off
  parameters::Loads   loads; ///< with coefficients of effects that are off set to zero
  double              tensile_strength = 0.;       ///< of one strand, N; 0: not known
  drive::PlateFatigue plates           = {0., 0.}; ///< what its plates endure

  // what the run is, and what is observed of it
  parameters::Time     time;
  parameters::Output   output;
  Window               window;
  double               field_interval = 0.; ///< between field output, s; 0: none are written
  parameters::Sections sections;            ///< entries of what registers itself

  std::vector<std::string> notes; ///< what the log must say about decisions
};

/// Decides the model of the @p drive of @p parameters, in which @p effects are decided already:
/// stiffnesses that are auto are those of the drive. Throws InputError for links that arrive in a
/// window so long that they are the whole chain, and for teeth that deflect too much.
Model make_model(const Parameters &parameters, const drive::Drive &drive, const Effects &effects);

/// The same with decide_effects() of @p parameters.
Model make_model(const Parameters &parameters, const drive::Drive &drive);

/// From what the meshes of the parts of a model are made whose @p effects are decided.
Meshes meshes_of(const Parameters &parameters, const Effects &effects);

/// Which stiffnesses of a drive come from elastic solutions of its parts: those that are auto and
/// that something deflects by.
struct PartStiffnesses
{
  bool per_pitch;            ///< of the chain
  bool rollers;              ///< between teeth and bushes
  bool teeth;                ///< of rigid sprockets under a roller
  bool curves       = false; ///< and the first two over load and place
  bool tooth_places = false; ///< and the third over place
};

/// Empty if no solution is asked for: the estimates from dimensions serve. It is decided before
/// there is a drive, which has these stiffnesses.
std::optional<PartStiffnesses> part_stiffnesses(const Parameters &parameters,
                                                const Effects    &effects);
} // namespace chaindrive::model
