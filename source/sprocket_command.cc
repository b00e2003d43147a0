// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/commands.h>
#include <chaindrive/drive/sprocket_files.h>
#include <chaindrive/files/temporary_directory.h>
#include <chaindrive/model/reading.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

// A sprocket for those who draw, make and measure it.

namespace chaindrive
{
namespace
{
const drive::Sprocket &wheel_of(const drive::Drive &drive, const std::string &name)
{
  std::vector<std::string> names;
  for (const drive::Sprocket &sprocket : drive.sprockets)
    if (sprocket.name == name)
      return sprocket;
    else
      names.push_back(sprocket.name);
  throw InputError("The option --wheel = " + name + " must be one of: " + join(names) + ".");
}
} // namespace

void sprocket_command(const CommandLine &command_line, std::ostream &out)
{
  const Parameters parameters =
      model::read_parameters(command_line.parameter_file, command_line.overrides).parameters;
  const drive::Drive     drive = drive::make_drive(parameters);
  const drive::Sprocket &wheel =
      command_line.wheel.empty() ? drive.driver() : wheel_of(drive, command_line.wheel);
  if (!wheel.mesh.empty())
    throw InputError("The teeth of the " + wheel.title + " are those of the file '" + wheel.mesh +
                     "', which is a drawing already; only teeth of a standard form can be drawn.");
  const drive::ToothForm &form = wheel.form;
  const auto              mm = [](const double length) { return to_text(1e3 * length, 8) + " mm"; };
  out << wheel.title << ": " << form.teeth << " teeth, pitch " << mm(form.pitch) << ", width "
      << mm(drive.sprocket_width) << '\n'
      << "  pitch diameter     " << mm(form.pitch_diameter) << '\n'
      << "  root diameter      " << mm(form.root_diameter) << '\n'
      << "  outside diameter   " << mm(form.outside_diameter) << '\n'
      << "  bore               " << mm(wheel.bore) << '\n'
      << "  seat radius        " << mm(form.seat_radius) << ", over "
      << to_text(2. * form.seat_half_angle * 180. / dealii::numbers::PI, 5) << " deg\n"
      << "  flank radius       " << mm(form.flank_radius) << '\n'
      << "  over pins of " << mm(form.roller_diameter) << ": "
      << mm(drive::distance_over_pins(form)) << '\n';
  if (command_line.output_directory.empty())
    return;
  const files::TemporaryDirectory folder(MPI_COMM_SELF);
  drive::write_sprocket(wheel, drive.sprocket_width, command_line.output_directory, folder.path());
  out << "It is in " << command_line.output_directory << ".\n";
}
} // namespace chaindrive
