// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/commands.h>
#include <chaindrive/drive/centre_distance.h>
#include <chaindrive/drive/drive.h>
#include <chaindrive/drive/facts.h>
#include <chaindrive/drive/ratings.h>
#include <chaindrive/model/reading.h>
#include <chaindrive/parameters/reader.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/option_range.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <ostream>
#include <string>

// A .prm file from what a designer begins with: chain, teeth, centre distance, speed and power.

namespace chaindrive
{
namespace
{
using Values = std::map<std::string, std::string>;

/// The two numbers of "21/63".
std::pair<unsigned int, unsigned int> read_teeth(const std::string &text)
{
  const char  *end    = text.data() + text.size();
  unsigned int driver = 0, driven = 0;
  const auto   first = std::from_chars(text.data(), end, driver);
  if (first.ptr != end && *first.ptr == '/')
    if (const auto second = std::from_chars(first.ptr + 1, end, driven);
        second.ec == std::errc() && second.ptr == end && driver > 0 && driven > 0)
      return {driver, driven};
  throw InputError("The option --teeth = " + text +
                   " is not understood: it takes the teeth of driver and driven sprocket, such as "
                   "21/63.");
}

/// The entries of the drive, which must be one that runs.
Parameters read(const Values &values)
{
  try
    {
      return model::read_entries(values).parameters;
    }
  catch (const InputError &error)
    {
      throw InputError(std::string("There is no template for this drive, which cannot run: ") +
                       error.what());
    }
}
} // namespace

void template_command(const CommandLine &command_line, std::ostream &out)
{
  const CommandLine::Design &design = command_line.design;
  const std::string         &file   = command_line.parameter_file;
  const auto                 form   = parameters::value_of<parameters::Form>(command_line.kind);
  if (!command_line.kind.empty() && !form)
    throw InputError("The option --as = " + command_line.kind +
                     " of a template must be prm, xml "
                     "or json.");
  if (!file.empty() && (!form || design.is_given()))
    throw InputError("The command template takes no file but with --as and without --chain and "
                     "the like, for another form of it: chaindrive template " +
                     file + " --as xml.");
  if (!file.empty())
    return void(out << parameters::in_form(file, *form));
  if (!design.is_given())
    return !form || *form == parameters::Form::prm ?
               parameters::write_template(out) :
               void(out << parameters::in_form(Values(), *form));
  if (!design.is_complete())
    throw InputError(
        "A template for a drive takes all of --chain, --teeth, --centre, --rpm and "
        "--kW or --Nm, such as: chaindrive template --chain 10B --teeth 21/63 --centre 500 "
        "--rpm 1450 --kW 3.");
  const std::string chain  = *design.chain;
  const double      centre = *design.centre, rpm = *design.rpm;
  const double      kilowatt = design.power();
  const std::string fidelity = design.fidelity.value_or("simple");
  if (chain.empty())
    throw InputError("The option --chain needs the name of a chain after it, such as 10B; it is "
                     "empty.");
  check_option("--centre", centre, 1., 1e5);
  check_option("--rpm", rpm, 0.01, 9e5); // all times and speeds that entries take
  if (design.torque)
    check_option("--Nm", *design.torque, 1e-3, 1e6);
  check_option("--kW", kilowatt, 1e-3, 1e6);
  const auto [driver, driven] = read_teeth(*design.teeth);
  parameters::Drive  drive;
  const unsigned int strands = design.strands.value_or(1);
  check_option("--strands", strands, 1, drive::most_strands);
  drive.chain.designation           = chain;
  drive.sprockets.driver().teeth    = driver;
  drive.sprockets.driven().teeth    = driven;
  drive.layout.centre_distance      = 1e-3 * centre;
  drive.layout.centre_distance_from = parameters::CentreDistanceFrom::sag;

  const std::string links    = std::to_string(drive::number_of_links(drive));
  const double      pitch_ms = 6e4 / (rpm * driver);
  const auto        pitches  = [pitch_ms](const double n) { return to_text(n * pitch_ms, 4); };
  Values            values   = {{"Drive/Number of links", links},
                                {"Drive/Driver teeth", std::to_string(driver)},
                                {"Drive/Driven teeth", std::to_string(driven)},
                                {"Drive/Chain/Designation", chain},
                                {"Drive/Chain/Strands", std::to_string(strands)},
                                {"Drive/Layout/Centre distance from", "sag"},
                                {"Drive/Layout/Sag in percent", "1"},
                                {"Drive/Layout/Start", "settled"},
                                {"Loads/Driver speed in rpm", to_text(rpm, 10)},
                                {"Loads/Power in kW", to_text(kilowatt, 10)},
                                {"Model/Fidelity", fidelity},
                                {"Time/End time in ms", pitches(40.)},
                                {"Output/Window start in ms", pitches(20.)}};
  // means are to hold three periods of the slowest resonance that everything takes part in
  const Parameters   parameters = read(values);
  const drive::Drive laid       = drive::make_drive(parameters);
  const unsigned int window =
      std::max(20U, 4U * drive::pitches_per_resonance(drive::make_facts(parameters, laid)));
  values["Time/End time in ms"] = pitches(20. + window);
  const double found            = 1e3 * laid.layout.centre_distance();

  if (form && *form != parameters::Form::prm)
    return void(out << parameters::in_form(values, *form));
  const auto set = [&values](const std::string &path) {
    return "set " + path.substr(path.rfind('/') + 1) + " = " + values.at(path) + "\n";
  };
  out << "# SPDX-License-Identifier: LGPL-2.1-or-later\n#\n# A " << chain
      << (strands == 1 ? "" : "-" + std::to_string(strands)) << " chain on sprockets of " << driver
      << " and " << driven << " teeth, " << to_text(kilowatt) << " kW at " << to_text(rpm)
      << " rpm.\n"
      << "# Lines with CHECK are assumptions; chaindrive document lists all entries.\n\n"
      << "subsection Drive\n"
      << "  # the even number for a centre distance of " << to_text(centre)
      << " mm: with the sag below it is " << to_text(found, 6) << " mm\n"
      << "  " << set("Drive/Number of links") << "  " << set("Drive/Driver teeth") << "  "
      << set("Drive/Driven teeth") << "\n  subsection Chain\n    " << set("Drive/Chain/Designation")
      << (strands == 1 ? "" : "    " + set("Drive/Chain/Strands"))
      << "  end\n\n  subsection Layout\n    # CHECK: 1 % of the slack span, as makers recommend\n"
      << "    " << set("Drive/Layout/Centre distance from") << "    set Sag in percent = 1\n"
      << "    " << set("Drive/Layout/Start") << "  end\nend\n\n"
      << "subsection Model\n  # CHECK: layered adds the clearance of the joints, full elastic "
         "bodies\n"
      << "  " << set("Model/Fidelity")
      << "  # CHECK: of all that turns with the driven sprocket; auto is the sprocket alone\n"
      << "  set Driven inertia in kg m2 = auto\nend\n\n";
  out << "subsection Loads\n  " << set("Loads/Driver speed in rpm") << "  "
      << set("Loads/Power in kW") << "end\n\nsubsection Time\n  # " << 20 + window << " pitches\n  "
      << set("Time/End time in ms") << "end\n\nsubsection Output\n  # means over the last "
      << window << " pitches, three periods of the driven inertia or more\n  "
      << set("Output/Window start in ms") << "end\n";
}
} // namespace chaindrive
