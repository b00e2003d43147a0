// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/chain.h>
#include <chaindrive/drive/guide.h>
#include <chaindrive/drive/layout.h>
#include <chaindrive/drive/link_pitches.h>
#include <chaindrive/drive/programs.h>
#include <chaindrive/drive/solids.h>
#include <chaindrive/drive/sprocket.h>
#include <chaindrive/drive/stiffness.h>
#include <chaindrive/drive/swing.h>
#include <chaindrive/drive/tooth_form.h>
#include <chaindrive/parameters/parameters.h>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace chaindrive::drive
{
/// The geometry of a whole drive with what follows from it. SI units.
///
/// Of a chain of several strands it is that of one, with its share of torques, inertias and springs
/// of tensioners.
struct Drive
{
  unsigned int                  strands = 1; ///< that share equally
  ChainDimensions               chain;       ///< with the mean pitches of its links
  LinkPitches                   links;
  std::vector<Sprocket>         sprockets; ///< in the order in which the chain runs over them
  double                        sprocket_width;
  double                        side_relief, side_radius; ///< of the sides of teeth at their tips
  Layout                        layout;
  std::vector<Guide>            guides;
  std::map<unsigned int, Swing> swings; ///< by the number of the wheel

  MassProperties roller_solid, inner_link_solid, outer_link_solid;
  double         mass_per_pitch; ///< of these: a roller and half of either link, kg

  double stiffness_per_pitch;    ///< of the chain, given or auto, N/m
  double roller_tooth_stiffness; ///< of the contact, given or auto: up to the roller's centre where
                                 ///< rollers are bodies of their own, else up to the link's, N/m
  double          roller_bush_stiffness; ///< of the contact, given or auto, N/m
  double          reference_load;        ///< at which those are taken that are auto, N
  StiffnessCurves curves;           ///< of those that are auto, if they are wanted, instead of them
  std::optional<HoleFactors> holes; ///< of plates that are solved
  double nominal_tension; ///< of the tight span: sum of resisting torque / pitch radius, N

  std::vector<std::string> notes; ///< sentences for the log: choices made and values derived

  const Sprocket &driver() const { return sprockets.front(); }
};

/// Tells the stiffness of the parts of a drive, which has all but its layout, at a load [N].
using StiffnessOf = std::function<PartStiffness(const Drive &drive, double load)>;

/// Stiffnesses that are auto are those of @p stiffness_of at the nominal tension; without it they
/// are estimated from dimensions.
/// @throws InputError as make_chain(), make_tooth_form() and make_layout() do, and for a bore, hub
/// or width that does not fit the sprocket. @p shifts serve a settled start.
Drive make_drive(const Parameters  &parameters,
                 const StiffnessOf &stiffness_of = {},
                 const JointShifts &shifts       = {});

/// Refuses (InputError) a Contact/Tooth stiffness with which the load would press rollers deep into
/// the teeth: for a model in which teeth deflect, else the entry has no effect.
void refuse_soft_teeth(const Parameters &parameters, const Drive &drive);
} // namespace chaindrive::drive
