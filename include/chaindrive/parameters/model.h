// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/material/material.h>
#include <chaindrive/parameters/choice.h>
#include <chaindrive/parameters/fidelity.h>
#include <chaindrive/parameters/formulation.h>

#include <optional>
#include <string>

namespace chaindrive::parameters
{
class Declarations;

/// Which rollers and links of an elastic fidelity are elastic.
enum class ElasticLinks
{
  all,
  region_of_interest ///< those that meet the driver in the window of the averages
};

template <>
inline constexpr Texts<ElasticLinks, 2> texts_of<ElasticLinks>{
    {{ElasticLinks::all, "all"}, {ElasticLinks::region_of_interest, "region of interest"}}};

/// What the others are.
enum class OtherLinks
{
  rigid,
  reduced
};

template <>
inline constexpr Texts<OtherLinks, 2> texts_of<OtherLinks>{
    {{OtherLinks::rigid, "rigid"}, {OtherLinks::reduced, "reduced"}}};

/// Whether only the halves of bodies at z >= 0 are computed.
enum class SymmetryModel
{
  automatic,
  no,
  yes
};

template <>
inline constexpr Texts<SymmetryModel, 3> texts_of<SymmetryModel>{
    {{SymmetryModel::automatic, "auto"},
     {SymmetryModel::no, "false"},
     {SymmetryModel::yes, "true"}}};

template <>
inline constexpr Texts<Formulation, 3> texts_of<Formulation>{{{Formulation::one_point, "one point"},
                                                              {Formulation::enhanced, "enhanced"},
                                                              {Formulation::full, "full"}}};

/// What the walls of a component consist of (element/solid_shell_stiffness.h).
enum class ElementType
{
  solid,
  solid_shell,
  membrane
};

template <>
inline constexpr Texts<ElementType, 3> texts_of<ElementType>{
    {{ElementType::solid, "solid"},
     {ElementType::solid_shell, "solid-shell"},
     {ElementType::membrane, "membrane"}}};

/// Where stiffnesses that are `auto` come from.
enum class StiffnessFrom
{
  parts,     ///< elastic solutions of the parts
  dimensions ///< formulas
};

template <>
inline constexpr Texts<StiffnessFrom, 2> texts_of<StiffnessFrom>{
    {{StiffnessFrom::parts, "parts"}, {StiffnessFrom::dimensions, "dimensions"}}};

/// Where the mass of the chain comes from, where none is given.
enum class MassFrom
{
  catalogue, ///< a maker's, where the tables have it; else the dimensions
  dimensions ///< the volumes of the parts
};

template <>
inline constexpr Texts<MassFrom, 2> texts_of<MassFrom>{
    {{MassFrom::catalogue, "catalogue"}, {MassFrom::dimensions, "dimensions"}}};

/// Section `Model`: which bodies there are, how they move, what they weigh and how stiff they are.
struct Model
{
  std::string         fidelity = "simple"; ///< the name of a builder of the scene
  const Capabilities &capabilities() const { return capabilities_of(fidelity); }

  SymmetryModel         half = SymmetryModel::automatic; ///< see model/decide.h
  std::optional<double> mass_per_pitch;                  ///< kg, of one strand per pitch
  MassFrom              mass_from = MassFrom::catalogue; ///< where it is not given
  std::optional<double> stiffness_per_pitch; ///< N/m, of the chain in a pull test, per pitch
  StiffnessFrom         stiffness_from = StiffnessFrom::parts; ///< those that are auto
  std::optional<double> driven_inertia; ///< kg m2, of all that turns with the driven hub
  double                chain_damping_ratio = 0.01; ///< of two lumps on their bar, simple only
  ElasticLinks          elastic_links       = ElasticLinks::all;
  OtherLinks            other_links         = OtherLinks::rigid; ///< outside the region of interest
  Switch elastic_sprockets = Switch::automatic; ///< those on which section Effects does not decide

  /// Declares an entry for each member, which takes every value that is set. The object must
  /// outlive @p declarations.
  void declare(Declarations &declarations);
};

/// Section `Material`: the same for every part.
struct Material : chaindrive::Material
{
  std::optional<double> given_density; ///< kg/m3; empty: what resolve() chooses

  /// Sets #density where it is not given, once all entries are read: that of carbon steel, or of
  /// the reference chain, if @p designation is that, the value of the drive in prm/paper.
  void resolve(const std::string &designation);

  /// Declares an entry for each member, which takes every value that is set. The object must
  /// outlive @p declarations.
  void declare(Declarations &declarations);
};

/// Section `Elements`: how elastic bodies are computed.
struct Elements
{
  Formulation formulation            = Formulation::enhanced;
  double      hourglass_coefficient  = 0.1; ///< of one point, after Flanagan and Belytschko
  double      selective_mass_scaling = 0.;  ///< factor of element::SelectiveMasses, rollers' walls
  ElementType plates                 = ElementType::solid;
  ElementType bushes                 = ElementType::solid;

  /// Declares an entry for each member, which takes every value that is set. The object must
  /// outlive @p declarations.
  void declare(Declarations &declarations);
};

/// Section `Reduction`: the modes of reduced bodies, see reduction::BasisOptions.
struct Reduction
{
  std::optional<double> modes_up_to;        ///< Hz; auto: what contact asks for
  double                highest = 300e3;    ///< frequency of the other shapes, Hz
  std::optional<double> fastest_of_links;   ///< all modes of links are slowed to this, Hz
  std::optional<double> fastest_of_rollers; ///< those of rollers without penalty, Hz
  unsigned int          tube_order = 8;     ///< harmonics about rollers and bushes
  unsigned int          pin_order  = 6;

  /// Declares an entry for each member, which takes every value that is set. The object must
  /// outlive @p declarations.
  void declare(Declarations &declarations);
};

/// Section `Mesh`: of the parts' reference meshes. Numbers of cells left empty follow from the
/// refinement.
struct Mesh
{
  using Cells = std::optional<unsigned int>;

  /// Cells of a link; see mesh::LinkGrid.
  struct Link
  {
    Cells around, wall, rings, plate_layers, along;
  };

  unsigned int refinement = 0; ///< 0 (coarse, for field output) ... 4
  Cells        roller_wall, roller_around, roller_along;
  Link         inner_link, outer_link;
  Cells        sprocket_refinement; ///< 0 ... 4

  /// Declares an entry for each member, which takes every value that is set. The object must
  /// outlive @p declarations.
  void declare(Declarations &declarations);
};
} // namespace chaindrive::parameters
