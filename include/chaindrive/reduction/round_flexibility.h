// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/mesh/part.h>
#include <chaindrive/reduction/free_part.h>

#include <cstddef>
#include <string>
#include <vector>

namespace chaindrive::reduction
{
struct Basis;

/// What a basis lacks of the flexibility of a cylindrical side, as that of a side that is alike all
/// round: by how much a node moves away from the axis under a force of one newton away from it on
/// another one, which depends on their rings and on how many columns lie between them.
///
/// It is the mean of the flexibility that the part has over all turns of both nodes about the axis,
/// so positive semidefinite as this one is. That of rollers is round; of pins and bushes, beside
/// natural modes up to 120 kHz, it is to a few percent: plates and waists are about as stiff to
/// what does not reach them. One that is round is the same for links at any angle.
struct RoundFlexibility
{
  mesh::Surface             surface = mesh::other_surface;
  std::vector<double>       rings;     ///< z of the rings of nodes in the part's frame, m
  unsigned int              n_columns; ///< at equal angles from the x axis on
  std::vector<unsigned int> node;      ///< [ring][column]
  std::vector<double>       value;     ///< [ring][ring][columns between], m/N

  /// Of the outside of a roller: the same between its nodes and those of the bore, whose columns
  /// are as many, [ring][ring of the bore][columns between], m/N.
  std::vector<double> to_bore = {};

  unsigned int n_rings() const { return static_cast<unsigned int>(rings.size()); }

  /// Of nodes in the rings @p r and @p s, @p columns apart, at most a round.
  double at(const unsigned int r, const unsigned int s, const unsigned int columns) const
  {
    return value[(std::size_t(r) * n_rings() + s) * n_columns + columns % n_columns];
  }

  /// f C f [J N^0], twice the energy [J] of the @p forces on the nodes of the part, N: what they
  /// displace nodes of this side away from its axis, beside the basis.
  double compliance(const Vector &forces) const;
};

/// Those of the sides in joints, which is all that touch but the outside of rollers, of @p part
/// with @p nodes, beside the @p basis; last that of the outside of a roller if it is wanted
/// @p outside as well. InputError if a side has no equal columns.
std::vector<RoundFlexibility> round_flexibilities(const FreePart    &free,
                                                  const mesh::Part  &part,
                                                  const mesh::Nodes &nodes,
                                                  const Basis       &basis,
                                                  bool               outside = false);
} // namespace chaindrive::reduction
