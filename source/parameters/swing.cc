// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/parameters/entries.h>
#include <chaindrive/parameters/swing.h>

namespace chaindrive::parameters
{
void Swing::declare(Declarations &declarations)
{
  const Subsection section(declarations, "Swing");
  add_point(declarations,
            "Pivot in mm",
            pivot,
            "The axis of this wheel is on an arm that turns about this point, x and y as in Centre "
            "in mm, as the entries below prescribe, such as the swing arm of a motorcycle. auto: "
            "there is no arm.");
  add(declarations,
      "Times in ms",
      times,
      unit::milli,
      between(0., 1e9),
      "After the start, rising, when the arm has each of the angles below. In between it turns "
      "along half a cosine wave, so that it is at rest at each of these times.");
  add_angles(declarations,
             "Angles in degrees",
             angles,
             between(-180., 180.),
             "From where the layout puts the wheel, counter-clockwise in a drive that turns "
             "counter-clockwise; with Layout/Tight span = lower mirrored. Before the first time it "
             "does not turn.");
  add_text(declarations,
           "File",
           file,
           "a file name or nothing",
           "Table of the angle in place of times and angles: on each line the time after the start "
           "in ms and the angle in degrees, apart by a comma, a semicolon or blanks; a first line "
           "of titles and lines that begin with # are left out. Between points a monotone cubic. "
           "Empty: none.");
}
} // namespace chaindrive::parameters
