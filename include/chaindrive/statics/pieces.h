// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/chain.h>
#include <chaindrive/drive/tooth_form.h>
#include <chaindrive/mesh/generate/sprocket.h>
#include <chaindrive/statics/elastic_piece.h>

namespace chaindrive::statics
{
/// Cells about the axis of a roller or hole.
constexpr unsigned int n_around = 32;

/// The eighth x, y, z >= 0 of a link with the halves of its tubes about the joint at positive x.
Piece link_eighth(const drive::ChainDimensions &chain, bool inner);

/// The inside of the hole of plate_eighth().
constexpr dealii::types::boundary_id hole_side = 110;

/// The eighth x, y, z >= 0 of a side plate by itself, z from its own middle plane.
Piece plate_eighth(const drive::ChainDimensions &chain, bool inner);

/// The quarter x, z >= 0 of an inner link, free along y.
Piece link_quarter(const drive::ChainDimensions &chain);

/// The quarter y, z >= 0 of a roller, free along x.
Piece roller_quarter(const drive::ChainDimensions &chain);

/// The half z >= 0 of @p n_sectors (odd) of the rim about tooth gap 0, held by the hub.
Piece rim_sector(const drive::ToothForm         &form,
                 const mesh::SprocketDimensions &dimensions,
                 unsigned int                    n_sectors);
} // namespace chaindrive::statics
