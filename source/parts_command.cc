// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/commands.h>
#include <chaindrive/drive/drive.h>
#include <chaindrive/files/console.h>
#include <chaindrive/files/log.h>
#include <chaindrive/model/reading.h>
#include <chaindrive/reduction/kept_basis.h>
#include <chaindrive/scene/build.h>
#include <chaindrive/statics/part_stiffness.h>
#include <chaindrive/utilities/ranks.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <unistd.h>

namespace chaindrive
{
namespace
{
using dealii::numbers::PI;

constexpr double kN_per_mm = 1e-6; // per N/m

/// A column of a table.
std::ostream &column(std::ostream &out, const std::string &text)
{
  return out << std::setw(12) << text;
}
std::ostream &column(std::ostream &out, const double value)
{
  return column(out, to_text(value, 4));
}

void print_masses(std::ostream &out, const drive::Drive &drive)
{
  out << "Masses, and moments of inertia about the centre of mass\n";
  for (const char *head : {"g", "x (g mm2)", "y (g mm2)", "z (g mm2)"})
    column(out, head);
  out << '\n';
  const auto row = [&out](const std::string &name, const drive::MassProperties &solid) {
    column(out, 1e3 * solid.mass);
    for (unsigned int d = 0; d < 3; ++d)
      column(out, 1e9 * solid.inertia[d][d]);
    out << "  " << name << '\n';
  };
  if (drive.chain.has_rollers)
    row("roller", drive.roller_solid);
  row("inner link", drive.inner_link_solid);
  row("outer link", drive.outer_link_solid);
  column(out, 1e3 * drive.mass_per_pitch);
  out << std::setw(36) << ""
      << "  per pitch\n";
}

void print_pull(std::ostream              &out,
                statics::Library          &library,
                const drive::Drive        &drive,
                const std::vector<double> &loads)
{
  out << "\nTwo links pulled, the pin of one in the bush of the other: stiffness per pitch, and "
         "extension of the links alone, the rest is their contact\n";
  for (const char *head :
       {"load (N)", "kN/mm", "total (um)", "inner (um)", "outer (um)", "contact +-"})
    column(out, head);
  out << '\n';
  for (const double load : loads)
    {
      const statics::ContactSolution pressed = statics::at_force(
          [&](const unsigned int n) { return library.pulled_links(drive.chain, n); }, load);
      column(out, load);
      column(out, kN_per_mm * load / pressed.approach[0]);
      column(out, 1e6 * pressed.approach[0]);
      column(out, 1e6 * pressed.given_way[0]);
      column(out, 1e6 * pressed.given_way[1]);
      column(out, to_text(pressed.half_angle[0] * 180. / PI, 3) + " deg");
      out << '\n';
    }
}

void print_roller(std::ostream              &out,
                  statics::Library          &library,
                  const drive::Drive        &drive,
                  const drive::Sprocket     &sprocket,
                  const std::vector<double> &loads)
{
  const double bottom = 90. - 180. / sprocket.form.teeth, end = sprocket.form.seat_half_angle;
  const bool   has_rollers = drive.chain.has_rollers;
  out << (has_rollers ? "\nRoller pressed between the bush in it and the seat of the tooth gap, " :
                        "\nBush pressed on the seat of the tooth gap, ")
      << sprocket.form.teeth << " teeth: stiffness from the hub to the "
      << (has_rollers ? "roller, on to the link" : "link, of a roller none")
      << ", in all, and of teeth and rim alone\n";
  for (const char *head : {"load (N)",
                           "angle deg",
                           "tooth kN/mm",
                           "bush kN/mm",
                           "all kN/mm",
                           "rim kN/mm",
                           "contact +-"})
    column(out, head);
  out << '\n';
  const auto row = [&](const double load, const double position) {
    const statics::ContactSolution pressed = statics::at_force(
        [&](const unsigned int n) {
          return library.pressed_roller(drive.chain, sprocket, drive.sprocket_width, n, position);
        },
        load);
    column(out, load);
    column(out, bottom - position * 180. / PI);
    column(out, kN_per_mm * load / pressed.approach[0]);
    const double bush = has_rollers ? pressed.approach[1] : 0.;
    column(out, has_rollers ? to_text(kN_per_mm * load / bush, 4) : "-");
    column(out, kN_per_mm * load / (pressed.approach[0] + bush));
    column(out, kN_per_mm * load / pressed.given_way.back());
    column(out, to_text(pressed.half_angle[0] * 180. / PI, 3) + " deg");
    if (std::abs(position) + pressed.half_angle[0] > end)
      out << "  leaves the seat: too stiff";
    out << '\n';
  };
  for (const double load : loads)
    row(load, 0.);
  // among them the position of Contact/Tooth stiffness
  std::vector<double> positions = {statics::seat_end(sprocket.form)};
  for (const double degrees : {20., 40., 60.})
    if (degrees * PI / 180. < end)
      positions.push_back(degrees * PI / 180.);
  std::sort(positions.begin(), positions.end());
  for (const double position : positions)
    row(drive.reference_load, position);
}

void print_plates(std::ostream &out, statics::Library &library, const drive::Drive &drive)
{
  out << "\nSide plates pulled at their holes, each by itself: largest stress over that of the net "
         "section, and the same of a strip whose hole bears nothing (Howland, after Heywood); at "
      << to_text(drive.reference_load, 4) << " N\n";
  for (const char *head : {"factor", "Howland", "MPa"})
    column(out, head);
  out << '\n';
  for (const bool inner : {true, false})
    {
      const drive::Plate plate =
          inner ? drive::inner_plate(drive.chain) : drive::outer_plate(drive.chain);
      const double net  = (plate.height - plate.hole_diameter) * plate.thickness,
                   peak = library.pulled_plate(drive.chain, inner).per_force;
      // an eighth of a plate bears a quarter of the plate's load, which is half of the chain's
      column(out, 0.25 * peak * net);
      column(out, 2. + std::pow(1. - plate.hole_diameter / plate.height, 3));
      column(out, 1e-6 * peak * drive.reference_load / 8.);
      out << "  " << (inner ? "inner" : "outer") << " plate\n";
    }
}

/// The natural frequencies of @p basis [kHz], each once with the number of its modes.
void print_frequencies(std::ostream &out, const reduction::Basis &basis)
{
  for (unsigned int i = 0, n = 1; i < basis.n_natural; i += n)
    {
      const auto frequency = [&](const unsigned int mode) {
        return to_text(1e-3 * basis.omega[mode] / (2. * PI), 4);
      };
      for (n = 1; i + n < basis.n_natural && frequency(i + n) == frequency(i);)
        ++n;
      out << "  " << frequency(i) << (n > 1 ? " (" + std::to_string(n) + ")" : "");
    }
}

void print_vibrations(std::ostream       &out,
                      statics::Cache     &cache,
                      const Parameters   &parameters,
                      const drive::Drive &drive,
                      const MPI_Comm      comm)
{
  // with modes that are not symmetric
  const model::Meshes     whole{parameters.mesh, parameters.material.density, false};
  reduction::BasisOptions options = reduction::options_of(parameters.reduction, drive.chain.pitch);
  options.fastest_of_links        = std::numeric_limits<double>::infinity(); // their own ones
  out << "\nVibration of parts as section Mesh divides them, which nothing holds: natural "
         "frequencies up to "
      << to_text(1e-3 * options.modes_up_to / (2. * PI), 4)
      << " kHz, (2) of two modes; number of these modes and of attachment modes, and by how "
         "much all of them are too stiff under contact at most\n";
  for (const char *head : {"natural", "attached", "stiff (%)"})
    column(out, head);
  out << "  kHz\n";
  std::vector<std::shared_ptr<const mesh::Part>> parts = {
      scene::make_link_part(whole, drive, true), scene::make_link_part(whole, drive, false)};
  if (drive.chain.has_rollers)
    parts.insert(parts.begin(), scene::make_roller_part(whole, drive));
  for (const auto &part : parts)
    {
      const reduction::Basis basis = reduction::kept_basis(
          *part, parameters.material, parameters.elements, options, cache, comm);
      double worst = 0.;
      for (const reduction::Basis::Error &error : basis.errors)
        worst = std::max(worst, error.relative);
      column(out, std::to_string(basis.n_natural));
      column(out, std::to_string(basis.size() - basis.n_natural));
      column(out, to_text(100. * worst, 2));
      out << "  " << part->name << ':';
      print_frequencies(out, basis);
      out << '\n';
    }
  for (const std::string &note : cache.notes())
    out << note << '\n';
}

void print_parts(std::ostream &out, const statics::Library &library)
{
  out << "\nElastic solutions: estimated error of the compliance, of plates of the largest "
         "stress\n";
  for (const char *head : {"cells", "unknowns", "error (%)", "s"})
    column(out, head);
  out << '\n';
  for (const statics::Library::Entry &entry : library.entries())
    {
      column(out, std::to_string(entry.n_cells));
      column(out, std::to_string(entry.n_unknowns));
      column(out, to_text(100. * entry.error, 2));
      column(out, entry.seconds > 0. ? to_text(entry.seconds, 2) : "cached");
      out << "  " << entry.name << '\n';
    }
  for (const std::string &note : library.notes())
    out << note << '\n';
}
} // namespace

void parts_command(const CommandLine &command_line, const MPI_Comm comm)
{
  const bool       is_first = rank_in(comm) == 0;
  files::Console   console(STDOUT_FILENO);
  files::Log       out(is_first ? &console : nullptr);
  const Parameters parameters =
      model::read_parameters(command_line.parameter_file, command_line.overrides).parameters;
  const drive::Drive  drive = drive::make_drive(parameters);
  statics::Library    library(parameters.material, statics::Cache::usual_folder(), comm);
  std::vector<double> loads;
  for (const double share : {0.1, 0.3, 1., 3.})
    loads.push_back(share * drive.reference_load);

  print_masses(out, drive);
  print_pull(out, library, drive, loads);
  for (const drive::Sprocket &sprocket : drive.sprockets)
    print_roller(out, library, drive, sprocket, loads);
  print_plates(out, library, drive);
  statics::Cache cache(is_first ? statics::Cache::usual_folder() : "");
  print_vibrations(out, cache, parameters, drive, comm);
  print_parts(out, library);
}
} // namespace chaindrive
