// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/material/material.h>

#include <deal.II/base/parameter_handler.h>

#include <optional>
#include <string>

namespace chaindrive::parameters
{
/// Section `Model`: which bodies there are, how they move, what they weigh and how stiff they are.
struct Model
{
  std::string           fidelity = "simple"; ///< simple | layered | full
  bool                  half     = false;    ///< elastic bodies: only their halves at z >= 0
  std::optional<double> mass_per_pitch;      ///< kg, of the whole chain per pitch
  std::optional<double> stiffness_per_pitch; ///< N/m, of the chain in a pull test, per pitch
  std::optional<double> driven_inertia;      ///< kg m2, of all that turns with the driven hub
  double                chain_damping_ratio = 0.01;  ///< of two lumps on their bar, simple only
  std::string           elastic_links       = "all"; ///< all | arriving: which of full fidelity
  std::string           elastic_sprockets = "auto";  ///< auto | on | off; auto: on in full fidelity

  /// Declares an entry for each member, which takes every value that is set. The object must
  /// outlive @p prm.
  void declare(dealii::ParameterHandler &prm);
};

/// Section `Material`: the same for every part.
struct Material : chaindrive::Material
{
  /// Declares an entry for each member, which takes every value that is set. The object must
  /// outlive @p prm.
  void declare(dealii::ParameterHandler &prm);
};

/// Section `Elements`: how elastic bodies are computed.
struct Elements
{
  std::string formulation           = "enhanced"; ///< one point | enhanced | full
  double      hourglass_coefficient = 0.1;        ///< of one point, after Flanagan and Belytschko

  /// Declares an entry for each member, which takes every value that is set. The object must
  /// outlive @p prm.
  void declare(dealii::ParameterHandler &prm);
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

  unsigned int refinement = 0; ///< 0 (coarse, for pictures) ... 4
  Cells        roller_wall, roller_around, roller_along;
  Link         inner_link, outer_link;
  Cells        sprocket_refinement; ///< 0 ... 4

  /// Declares an entry for each member, which takes every value that is set. The object must
  /// outlive @p prm.
  void declare(dealii::ParameterHandler &prm);
};
} // namespace chaindrive::parameters
