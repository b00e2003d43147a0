// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/statics/part_stiffness.h>
#include <chaindrive/statics/pieces.h>
#include <chaindrive/statics/stiffness_curves.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/text.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::statics
{
namespace
{
constexpr const char *until_solved =
    "Stiffnesses are estimated from dimensions until the parts are solved.";

/// Share of the way from the bottom of the seat to its end, at half of 1 - cos of that.
constexpr double between_ends = 0.7;

/// A stiffness rounded to five digits, the same for any number of ranks.
double rounded(const double stiffness) { return std::stod(to_text(stiffness, 5)); }

std::string text_of(const Library::Entry &entry)
{
  return entry.name + " " + std::to_string(entry.n_cells) + " cells, compliance to " +
         to_text(100. * entry.error, 2) + " %" +
         (entry.seconds > 0. ? ", " + to_text(entry.seconds, 2) + " s" : "");
}

/// Where the values come from.
std::string origin(const Library &library, const double load)
{
  std::string parts;
  bool        cached = true;
  for (const Library::Entry &entry : library.entries())
    {
      parts += (parts.empty() ? "" : "; ") + text_of(entry);
      cached = cached && entry.seconds == 0.;
    }
  return "Stiffnesses that are auto are those of the elastic parts at " + to_text(load, 4) +
         " N, " + (cached ? "from the cache (" : "computed (") + parts + ").";
}

/// The factors of the holes of both kinds of plates, and a note on them.
drive::HoleFactors
holes_of(Library &library, const drive::ChainDimensions &chain, std::vector<std::string> &notes)
{
  const auto factor = [&](const bool inner) {
    const drive::Plate plate = inner ? drive::inner_plate(chain) : drive::outer_plate(chain);
    // an eighth of a plate bears a quarter of what the plate does
    return 0.25 * (plate.height - plate.hole_diameter) * plate.thickness *
           library.pulled_plate(chain, inner).per_force;
  };
  const drive::HoleFactors holes = {rounded(factor(true)), rounded(factor(false))};
  notes.push_back("Stresses at the holes of side plates are those of elastic solutions: inside " +
                  to_text(holes.inner, 3) + ", outside " + to_text(holes.outer, 3) +
                  " times the mean beside the hole.");
  return holes;
}

/// Tooth and rim of @p sprocket under a roller, which presses with @p load [N] in the direction
/// @p angle [rad] from the bottom of the seat, N/m.
double tooth_at(Library               &library,
                const drive::Drive    &drive,
                const drive::Sprocket &sprocket,
                const double           angle,
                const double           load)
{
  const ContactSolution pressed = at_force(
      [&](const unsigned int n_angles) {
        return library.pressed_roller(drive.chain, sprocket, drive.sprocket_width, n_angles, angle);
      },
      load);
  return rounded(load / pressed.given_way.back());
}

drive::PartStiffness compute(const model::PartStiffnesses &wanted,
                             const Material               &steel,
                             const drive::Drive           &drive,
                             const double                  load,
                             const MPI_Comm                comm,
                             const Announce               &announce)
{
  drive::PartStiffness result = drive::estimated_stiffness(drive.chain, load, steel);
  result.notes.clear();
  Library library(steel, Cache::usual_folder(), comm, announce);
  if (wanted.per_pitch)
    result.per_pitch = rounded(load / at_force(
                                          [&](const unsigned int n_angles) {
                                            return library.pulled_links(drive.chain, n_angles);
                                          },
                                          load)
                                          .approach[0]);
  if (wanted.rollers)
    {
      // all sprockets have the same roller: the mean of the approaches
      double     tooth = 0., bush = 0.;
      const auto n_toothed =
          std::count_if(drive.sprockets.begin(),
                        drive.sprockets.end(),
                        [](const drive::Sprocket &sprocket) { return !sprocket.form.flat; });
      for (const drive::Sprocket &sprocket : drive.sprockets)
        {
          if (sprocket.form.flat)
            continue;
          const ContactSolution pressed = at_force(
              [&](const unsigned int n_angles) {
                return library.pressed_roller(
                    drive.chain, sprocket, drive.sprocket_width, n_angles);
              },
              load);
          tooth += pressed.approach[0] / n_toothed;
          if (drive.chain.has_rollers)
            bush += pressed.approach[1] / n_toothed;
        }
      result.roller_tooth = rounded(load / tooth);
      if (drive.chain.has_rollers)
        result.roller_bush = rounded(load / bush);
    }
  if (wanted.teeth)
    for (const drive::Sprocket &sprocket : drive.sprockets)
      {
        if (sprocket.form.flat) // it has none that deflect: the driver's, in their place
          {
            result.teeth.push_back(result.teeth.front());
            continue;
          }
        result.teeth.push_back(tooth_at(library, drive, sprocket, seat_end(sprocket.form), load));
      }
  if (wanted.tooth_places)
    for (const drive::Sprocket &sprocket : drive.sprockets)
      {
        std::vector<drive::PlacedStiffness> &places = result.tooth_places.emplace_back();
        for (const double share : {0., between_ends, 1.})
          if (const double angle = share * seat_end(sprocket.form); !sprocket.form.flat)
            places.push_back({angle, tooth_at(library, drive, sprocket, angle, load)});
      }
  std::string of_curves;
  if (wanted.curves)
    result.curves = stiffness_curves(library, drive, load, of_curves);
  if (!library.entries().empty())
    result.notes.push_back(origin(library, load));
  if (!of_curves.empty())
    result.notes.push_back(of_curves);
  result.holes = holes_of(library, drive.chain, result.notes);
  for (const std::string &note : library.notes())
    result.notes.push_back(note);
  return result;
}
} // namespace

ContactSolution at_force(const std::function<ContactProblem(unsigned int)> &make,
                         const double                                       force)
{
  for (unsigned int n_angles = 4;; n_angles *= 2)
    {
      ContactSolution pressed = make(n_angles).at(force);
      if (!pressed.reaches_the_end || n_angles * 4 >= n_around)
        return pressed;
    }
}

drive::StiffnessOf part_stiffness(const std::optional<model::PartStiffnesses> &wanted,
                                  const Material                              &steel,
                                  const MPI_Comm                               comm,
                                  const Announce                              &announce)
{
  if (!wanted)
    return {};
  return [wanted = *wanted, steel, comm, announce](const drive::Drive &drive, const double load) {
    try
      {
        return compute(wanted, steel, drive, load, comm, announce);
      }
    // on all ranks: dimensions that cannot be meshed, contact or solution not found
    catch (const InputError &)
      {
      }
    catch (const RunError &)
      {
      }
    catch (const dealii::ExceptionBase &)
      {
      }
    drive::PartStiffness estimate = drive::estimated_stiffness(drive.chain, load, steel);
    estimate.notes = {"The parts could not be solved with these dimensions: stiffnesses that are "
                      "auto are estimates, see Model/Stiffness from."};
    return estimate;
  };
}

bool is_estimated(const std::vector<std::string> &notes)
{
  return std::find(notes.begin(), notes.end(), until_solved) != notes.end();
}

drive::StiffnessOf quick_part_stiffness(const std::optional<model::PartStiffnesses> &wanted,
                                        const Material                              &steel)
{
  struct NotKept // ends a solution before it begins
  {
  };
  if (!wanted)
    return {};
  const drive::StiffnessOf kept =
      part_stiffness(wanted, steel, MPI_COMM_SELF, [](const std::string &) { throw NotKept(); });
  return [kept, steel](const drive::Drive &drive, const double load) {
    try
      {
        return kept(drive, load);
      }
    catch (const NotKept &)
      {
        drive::PartStiffness estimate = drive::estimated_stiffness(drive.chain, load, steel);
        estimate.notes                = {until_solved};
        return estimate;
      }
  };
}
} // namespace chaindrive::statics
