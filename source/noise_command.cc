// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/acoustics/noise.h>
#include <chaindrive/commands.h>
#include <chaindrive/drive/drive.h>
#include <chaindrive/drive/facts.h>
#include <chaindrive/files/console.h>
#include <chaindrive/files/directory.h>
#include <chaindrive/files/file.h>
#include <chaindrive/files/json.h>
#include <chaindrive/files/log.h>
#include <chaindrive/files/tables.h>
#include <chaindrive/model/reading.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>
#include <chaindrive/version.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <limits>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

// The noise of a run that has ended, from what it has left behind: parameters.prm, summary.json and
// histories.h5.

namespace chaindrive
{
namespace
{
namespace fs = std::filesystem;
using files::Json;
using Vector3 = dealii::Tensor<1, 3>;

/// The window of the run in @p directory: begin and end, s.
std::pair<double, double> read_window(const std::string &directory)
{
  const std::string file = directory + "/summary.json";
  if (!fs::exists(file))
    throw InputError("'" + directory +
                     "' has no summary.json: the run there has not come to its "
                     "end. Resume it with --resume auto.");
  const Json  summary = Json::parse(files::read_text(file), nullptr, false);
  const Json *window =
      summary.is_object() && summary.contains("window") ? &summary["window"] : nullptr;
  if (window == nullptr || !window->is_object() || !window->contains("start") ||
      !window->contains("end"))
    throw InputError("'" + file + "' is damaged, or no summary of chaindrive: it has no window.");
  const Json &start = window->at("start"), &end = window->at("end");
  if (start.is_null() || end.is_null())
    throw InputError("'" + file +
                     "': the run has no window, since the drive had not settled at its "
                     "end. Run longer, or give Output/Window start in ms a time.");
  if (!start.is_number() || !end.is_number() || !(end.get<double>() > start.get<double>()))
    throw InputError("'" + file + "' is damaged: its window is not from a time to a time.");
  return {start.get<double>(), end.get<double>()};
}

Vector3 in_space(const dealii::Tensor<1, 2> &v)
{
  Vector3 result;
  result[0] = v[0];
  result[1] = v[1];
  return result;
}

acoustics::Site make_site(const drive::Drive &drive, const drive::Facts &facts)
{
  const drive::Layout       &layout = drive.layout;
  const drive::Layout::Span &tight  = layout.tight();
  acoustics::Site            site{};
  site.outward    = in_space(tight.normal);
  site.along      = -in_space(tight.direction); // the driver pulls it in
  site.engagement = in_space(layout.sprockets.front().centre) +
                    0.5 * facts.driver().pitch_diameter * site.outward;
  site.strands            = drive.strands;
  site.pitch              = drive.chain.pitch;
  site.roller_radius      = 0.5 * drive.chain.roller_diameter;
  site.roller_length      = drive.chain.roller_length;
  site.pitch_time         = facts.pitch_time;
  site.pitches_per_period = drive::pitches_per_resonance(facts);
  site.lowest             = std::numeric_limits<double>::infinity();
  for (std::size_t s = 0; s < layout.sprockets.size(); ++s)
    site.sprockets.push_back({drive.sprockets[s].name,
                              drive.sprockets[s].title,
                              in_space(layout.sprockets[s].centre),
                              0.5 * drive.sprockets[s].form.outside_diameter});
  for (const drive::Layout::Joint &joint : layout.joints)
    {
      const Vector3 place = in_space(joint.roller);
      site.extent = std::max(site.extent, (place - site.engagement).norm() + 2. * site.pitch);
      site.lowest = std::min(site.lowest, place[1] - 2. * site.pitch);
    }
  return site;
}

/// Where the samples at or after @p time begin, or that before. @p times grow.
std::size_t sample_before(const std::vector<double> &times, const double time)
{
  const auto after = std::upper_bound(times.begin(), times.end(), time);
  return after == times.begin() ? 0 : static_cast<std::size_t>(after - times.begin()) - 1;
}

/// Refuses a channel that is not that of @p n rollers over all times.
void check_channel(const std::string  &file,
                   const files::Table &table,
                   const std::size_t   n_rows,
                   const unsigned int  n)
{
  const auto refuse = [&](const std::string &why) {
    throw InputError("'" + file + "': the dataset " + table.info.path + " " + why);
  };
  if (table.info.columns != n)
    refuse("has " + std::to_string(table.info.columns) + " of the " + std::to_string(n) +
           " rollers, but the noise is that of all. Run with Output/Rollers = all.");
  for (unsigned int k = 0; k < table.info.labels.size(); ++k)
    if (table.info.labels[k] != std::to_string(k))
      refuse("calls its column " + std::to_string(k) + " roller " + table.info.labels[k] +
             ": it was not written by this program.");
  if (table.n_rows() != n_rows)
    refuse("has " + std::to_string(table.n_rows()) + " rows where /time has " +
           std::to_string(n_rows) + ".");
  if (!std::all_of(table.values.begin(), table.values.end(), [](const double value) {
        return std::isfinite(value);
      }))
    refuse("has rows that were not written.");
}

/// The motion of all rollers from the last sample before @p from to the first after @p to (s).
acoustics::Motion
read_motion(const files::TableFile &file, const unsigned int n, const double from, const double to)
{
  const std::vector<double> times  = file.read("/time").values;
  const auto                growth = [](const double a, const double b) { return !(b > a); };
  if (times.empty() || !std::isfinite(times.back()) ||
      std::adjacent_find(times.begin(), times.end(), growth) != times.end())
    throw InputError("'" + file.path() + "': the dataset /time does not grow from row to row.");
  const std::size_t first = sample_before(times, from);
  const std::size_t rows  = std::min(sample_before(times, to) + 3, times.size()) - first;
  acoustics::Motion motion;
  motion.time.assign(times.begin() + first, times.begin() + first + rows);
  const auto read = [&](const std::string &name, acoustics::Motion::Records &records) {
    const files::Table table = file.read("/rollers/" + name, first, rows);
    check_channel(file.path(), table, rows, n);
    records.assign(n, std::vector<double>(rows));
    for (std::size_t i = 0; i < rows; ++i)
      for (unsigned int k = 0; k < n; ++k)
        records[k][i] = table.values[n * i + k];
  };
  for (const unsigned int d : {0U, 1U})
    {
      const std::string axis = d == 0 ? "x" : "y";
      read("position_" + axis, motion.position[d]);
      read("velocity_" + axis, motion.velocity[d]);
    }
  return motion;
}

Json to_json(const acoustics::Noise &noise,
             const acoustics::Site  &site,
             const double            tooth_frequency)
{
  Json json = Json::object(), observers = Json::array(), bands = Json::array(),
       rollers = Json::array(), contributions = Json::object();
  for (const acoustics::ReceivedSound &received : noise.observers)
    {
      const Vector3 &x = received.observer.position;
      observers.push_back({{"name", received.observer.name},
                           {"position", {x[0], x[1], x[2]}},
                           {"level", received.level},
                           {"level_uncertainty", received.level_uncertainty},
                           {"level_a", received.level_a},
                           {"level_a_uncertainty", received.level_a_uncertainty},
                           {"peak_pressure", received.peak},
                           {"third_octaves", received.third_octaves},
                           {"orders", received.orders},
                           {"engagement_peaks", received.engagement_peaks}});
    }
  for (const acoustics::Band &band : noise.bands)
    bands.push_back(band.middle);
  for (std::size_t k = 0; k < noise.rollers.size(); ++k)
    rollers.push_back({{"roller", k}, {"level", noise.rollers[k]}});
  for (std::size_t s = 0; s < site.sprockets.size(); ++s)
    contributions[site.sprockets[s].name] = noise.contributions[s];
  const double start        = noise.grid.start;
  json["observers"]         = observers;
  json["third_octaves"]     = bands;
  json["tooth_frequency"]   = tooth_frequency;
  json["highest_frequency"] = noise.highest;
  json["periods"]           = noise.periods;
  json["window"]        = {{"start", start}, {"end", start + noise.grid.step * noise.grid.size}};
  json["contributions"] = contributions;
  json["rollers"]       = rollers;
  json["directivity"]   = {{"angle", noise.angles}, {"level", noise.directivity}};
  return json;
}

void write_pressures(const std::string &file, const acoustics::Noise &noise)
{
  using files::Table;
  const auto columns = static_cast<unsigned int>(noise.observers.size());
  const auto lines   = noise.observers.front().spectrum.lines.size();
  Table      time{{"/time", 1, {{"unit", "s"}, {"description", "When it is received"}}, {}}, {}};
  Table      frequency{{"/frequency", 1, {{"unit", "Hz"}, {"description", "Of a line"}}, {}}, {}};
  Table pressure{{"/pressure", columns, {}, {}}, {}}, spectrum{{"/spectrum", columns, {}, {}}, {}};
  pressure.info.attributes = {{"unit", "Pa"}, {"description", "Sound pressure at the observers"}};
  spectrum.info.attributes = {{"unit", "Pa2"},
                              {"description", "What the line adds to the mean square pressure"}};
  for (const acoustics::ReceivedSound &received : noise.observers)
    {
      pressure.info.labels.push_back(received.observer.name);
      spectrum.info.labels.push_back(received.observer.name);
    }
  for (std::size_t i = 0; i < noise.grid.size; ++i)
    {
      time.values.push_back(noise.grid.time(i));
      for (const acoustics::ReceivedSound &received : noise.observers)
        pressure.values.push_back(received.pressure[i]);
    }
  for (std::size_t i = 0; i < lines; ++i)
    {
      frequency.values.push_back(noise.observers.front().spectrum.frequency(i));
      for (const acoustics::ReceivedSound &received : noise.observers)
        spectrum.values.push_back(received.spectrum.lines[i]);
    }
  files::write_tables(file,
                      {{"program", std::string("chaindrive ") + version}},
                      {time, pressure, frequency, spectrum});
}

void print(std::ostream           &out,
           const acoustics::Noise &noise,
           const acoustics::Site  &site,
           const double            tooth_frequency)
{
  out << "Noise of the rollers over " << noise.periods
      << (noise.periods == 1 ? " pitch time" : " pitch times") << ", from "
      << to_text(1e3 * noise.grid.start, 5) << " to "
      << to_text(1e3 * (noise.grid.start + noise.grid.step * noise.grid.size), 5)
      << " ms; tooth frequency " << to_text(tooth_frequency, 5) << " Hz, up to "
      << to_text(1e-3 * noise.highest, 3) << " kHz\n"
      << "  observer         x, m    y, m    z, m"
      << "   level, dB  95 % +-   dB(A)       +-   peak, Pa\n";
  const std::ios_base::fmtflags flags = out.flags();
  out << std::fixed;
  const auto around = [](const double half) {
    return std::isfinite(half) ? to_text(half, 2) : std::string("-");
  };
  for (const acoustics::ReceivedSound &received : noise.observers)
    {
      out << "  " << std::left << std::setw(13) << received.observer.name << std::right
          << std::setprecision(3);
      for (unsigned int d = 0; d < 3; ++d)
        out << std::setw(8) << received.observer.position[d];
      out << std::setprecision(1) << std::setw(12) << received.level << std::setw(9)
          << around(received.level_uncertainty) << std::setw(8) << received.level_a << std::setw(9)
          << around(received.level_a_uncertainty) << std::setprecision(3) << std::setw(11)
          << received.peak << '\n';
    }
  out << std::setprecision(1) << "  at " << noise.observers.front().observer.name << ": rollers";
  for (std::size_t s = 0; s < site.sprockets.size(); ++s)
    out << (s == 0 ? "" : ",") << " at the " << site.sprockets[s].title << ' '
        << noise.contributions[s] << " dB";
  out << '\n';
  out.flags(flags);
  for (const std::string &note : noise.notes)
    out << "  " << note << '\n';
}

/// InputError where nothing can be received at the site.
acoustics::Site
checked_site(const drive::Drive &drive, const drive::Facts &facts, const Parameters &parameters)
{
  if (parameters.loads.driver_speed == 0.)
    throw InputError(
        "Acoustics/Noise: the driver stands still, with Loads/Driver speed in rad/s = 0: "
        "there are no pitch times.");
  acoustics::Site site = make_site(drive, facts);
  acoustics::check_site(parameters.acoustics, site);
  return site;
}
} // namespace

void check_noise(const drive::Drive &drive, const drive::Facts &facts, const Parameters &parameters)
{
  acoustics::check_interval(parameters.acoustics,
                            checked_site(drive, facts, parameters),
                            parameters.output.history_interval);
}

void write_noise(const std::string &directory, const Parameters &parameters, std::ostream &out)
{
  const drive::Drive    drive = drive::make_drive(parameters);
  const drive::Facts    facts = drive::make_facts(parameters, drive);
  const acoustics::Site site  = checked_site(drive, facts, parameters);
  const auto [start, end]     = read_window(directory);
  const files::TableFile file(directory + "/histories.h5");
  // before the window what is received at its begin, and some samples more for the filter
  const double before = acoustics::longest_delay(parameters.acoustics, site) +
                        100. * parameters.output.history_interval;
  const acoustics::Motion motion = read_motion(file, parameters.drive.n_links, start - before, end);
  const acoustics::Noise  noise =
      acoustics::compute_noise(motion, site, parameters.acoustics, start, end, file.path());
  write_pressures(directory + "/acoustics.h5", noise);
  files::write_json(directory + "/acoustics.json", to_json(noise, site, facts.tooth_frequency));
  print(out, noise, site, facts.tooth_frequency);
}

void noise_command(const CommandLine &command_line)
{
  std::string directory = command_line.parameter_file;
  while (directory.size() > 1 && directory.back() == '/')
    directory.pop_back();
  if (!fs::is_directory(directory))
    throw InputError("'" + directory +
                     "' is no directory: chaindrive noise takes that of a run "
                     "that has ended, such as results/simple.");
  if (!fs::exists(directory + "/parameters.prm"))
    throw InputError("'" + directory +
                     "' has no parameters.prm: it is not the directory of a run.");
  for (const std::string &text : command_line.overrides)
    if (text.compare(0, 10, "Acoustics/") != 0)
      throw InputError("--set \"" + text +
                       "\": the run is over; only entries of section Acoustics "
                       "can be changed.");
  files::Console          out(STDOUT_FILENO), err(STDERR_FILENO);
  files::Log              log(command_line.quiet ? nullptr : &out, &err);
  const parameters::Input input =
      model::read_parameters(directory + "/parameters.prm", command_line.overrides);
  files::Directory claimed(directory);
  if (const std::string sentence = claimed.claim(); !sentence.empty())
    log.warn(sentence);
  write_noise(directory, input.parameters, log);
  log << "Results: " << directory << "/acoustics.json\n";
}
} // namespace chaindrive
