// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/drive/drive.h>
#include <chaindrive/drive/outline.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace chaindrive::drive
{
/// The closed outline of a whole sprocket, counter-clockwise from the middle of a tooth's tip on:
/// arcs and straight pieces, those of one centre and radius that follow each other as one.
std::vector<Segment> outline(const ToothForm &form);

/// The distance over two pins of the roller's diameter in opposite gaps of a sprocket, or as nearly
/// opposite as an odd number of teeth has them, which ISO 606 gives for measuring one: M = 2 c +
/// d1, or 2 c cos(90 deg / z) + d1, with the pins' centres c from the axis. [m]
double distance_over_pins(const ToothForm &form);

/// How drawings and solids of sprockets are called: file names that end in one of these.
const std::vector<std::string> &sprocket_file_suffixes();

/// Writes the @p sprocket, with its bore and without teeth of other files, as its profile in the
/// plane or, with the @p width [m], as a solid whose axis is z:
///
///   .csv    the pieces of the profile, from the bottom of the gap on +x to the next tooth's tip:
///   kind,
///           ends, centre, radius, angles; mm and degrees
///   .dxf    drawing in mm: lines and exact arcs on the layer PROFILE, circles BORE and PITCH
///   .svg    the same as a picture
///   .step   solid with exact cylinders, by OpenCASCADE
///   .stl    its surface in triangles that are nowhere farther than 0.01 mm from it, mm
///
/// @p folder is for a file that nobody needs afterwards: OpenCASCADE writes to names only.
/// InputError for other names and where deal.II has no OpenCASCADE; RunError where a file cannot be
/// written.
void write_sprocket(const Sprocket    &sprocket,
                    double             width,
                    const std::string &path,
                    const std::string &folder);
} // namespace chaindrive::drive
