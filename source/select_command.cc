// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/commands.h>
#include <chaindrive/drive/selection.h>
#include <chaindrive/files/file.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/numbers.h>

#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

// Which chain: what a designer asks before there is a parameter file.

namespace chaindrive
{
namespace
{
/// The value that the text of @p option names.
template <typename Enum>
std::optional<Enum> choice(const char *option, const std::optional<std::string> &text)
{
  if (!text)
    return {};
  if (const std::optional<Enum> value = parameters::value_of<Enum>(*text))
    return value;
  std::vector<std::string> all;
  for (const auto &entry : parameters::texts_of<Enum>)
    all.emplace_back(entry.text);
  throw InputError(std::string("The option ") + option + " = " + *text +
                   " must be one of: " + join(all) + ".");
}

drive::Demand demand_of(const CommandLine::Design &design)
{
  if (!(design.rpm && design.ratio && design.centre && (design.kilowatt || design.torque)))
    throw InputError(
        "A selection takes all of --kW (or --Nm), --rpm, --ratio and --centre, such as: "
        "chaindrive select --kW 5 --rpm 1400 --ratio 3 --centre 500 --shock moderate.");
  drive::Demand demand;
  demand.speed           = *design.rpm * dealii::numbers::PI / 30.;
  demand.power           = 1e3 * design.power();
  demand.ratio           = *design.ratio;
  demand.centre_distance = 1e-3 * *design.centre;
  demand.hours           = design.hours.value_or(demand.hours);
  demand.motor           = choice<drive::Motor>("--motor", design.motor).value_or(demand.motor);
  demand.shock           = choice<drive::Shock>("--shock", design.shock).value_or(demand.shock);
  demand.lubrication     = choice<drive::Lubrication>("--lubrication", design.lubrication);
  demand.strands         = design.strands.value_or(demand.strands);
  return demand;
}

/// The parameter file of @p best.
std::string file_of(const drive::Candidate &best, const drive::Demand &demand)
{
  CommandLine          command_line;
  CommandLine::Design &design = command_line.design;
  design.chain                = best.chain;
  design.strands              = best.strands;
  design.teeth    = std::to_string(best.driver_teeth) + "/" + std::to_string(best.driven_teeth);
  design.centre   = 1e3 * demand.centre_distance;
  design.rpm      = demand.speed * 30. / dealii::numbers::PI;
  design.kilowatt = 1e-3 * demand.power;
  std::ostringstream text;
  template_command(command_line, text);
  return text.str();
}
} // namespace

void select_command(const CommandLine &command_line, std::ostream &out)
{
  const drive::Demand demand = demand_of(command_line.design);
  const auto          found  = drive::select_drives(demand);
  if (found.empty())
    throw InputError(
        "No sprockets of up to 120 teeth fit the options --ratio and --centre: choose a "
        "larger --centre or a --ratio nearer to 1.");
  const bool meets = found.front().faults.empty();
  print(out, demand, found, meets ? 12 : 4);
  out << (meets ? "" : "None does: with each is what speaks against it.\n")
      << "power, break, plates: safety of the rated power, against breaking, of the plates' "
         "endurance;\nwear h: Archard's law, within a factor of "
      << to_text(drive::wear_scatter)
      << "; frame h: 15,000 h of 3 % at the rated power; dB(A): at 0.3 m,\nscaled from one "
         "measured "
         "level. Sources of all figures: doc/theory.md, section 9.\n";
  if (!command_line.chart.empty())
    {
      std::ostringstream chart;
      draw(chart, demand, found, meets ? 12 : 4);
      files::write_text(command_line.chart, chart.str());
      out << "The chart is in " << command_line.chart << '\n';
    }
  const std::string &path = command_line.output_directory;
  if (path.empty())
    return;
  if (!meets)
    throw InputError(
        "There is no drive for --output = " + path +
        ": none of the table meets the demand. Choose fewer --hours, more --strands or "
        "less power.");
  files::write_text(path, file_of(found.front(), demand));
  out << "The first is in " << path << ": chaindrive plan " << path << '\n';
}
} // namespace chaindrive
