// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/stiffness_fit.h>
#include <chaindrive/statics/stiffness_curves.h>
#include <chaindrive/utilities/text.h>

#include <cmath>

namespace chaindrive::statics
{
namespace
{
/// A number rounded to six digits, the same for any number of ranks.
double to_six_digits(const double value) { return std::stod(to_text(value, 6)); }

/// The approaches of a contact at one place.
struct OverLoads
{
  std::vector<double>          force; ///< N
  std::vector<ContactSolution> at;    ///< each

  /// Of interface number @p i.
  drive::Approaches of(const unsigned int i, const double place) const
  {
    drive::Approaches result{place, force, {}};
    for (const ContactSolution &solution : at)
      result.approach.push_back(to_six_digits(solution.approach[i]));
    return result;
  }
};

/// Pressure over the projection of a joint up to which impacts of light drives go, Pa: that of
/// chains at their rating.
constexpr double rated_pressure = 20e6;

/// The contact of @p make (see at_force()) at a tenth, a third and all of the @p load [N], and as
/// far as the patches that it needs there leave room for up to three times that and at @p most [N].
OverLoads over_loads(const std::function<ContactProblem(unsigned int)> &make,
                     const double                                       load,
                     const double                                       most)
{
  OverLoads result;
  at_force(
      [&](const unsigned int n_angles) {
        ContactProblem problem = make(n_angles);
        result                 = {};
        for (const double force : {0.1 * load, 0.3 * load, load, 2. * load, 3. * load, most})
          if (result.force.empty() || force > 1.2 * result.force.back())
            if (ContactSolution pressed = problem.at(force);
                force <= load || !pressed.reaches_the_end)
              {
                result.force.push_back(force);
                result.at.push_back(std::move(pressed));
              }
        return problem;
      },
      load);
  return result;
}

/// In N/um, from the smallest approach to the largest.
std::string in_words(const drive::StiffnessCurve &curve, const double place)
{
  const double small = 1e-3 * curve.depth, large = curve.depth;
  const auto   tangent = [&](const double d) {
    const double step = 1e-3 * curve.depth;
    return (drive::force_of(curve, place, d + step) - drive::force_of(curve, place, d)) / step;
  };
  return to_text(1e-6 * tangent(small), 3) + " to " + to_text(1e-6 * tangent(large), 3);
}
} // namespace

drive::StiffnessCurves
stiffness_curves(Library &library, const drive::Drive &drive, const double load, std::string &note)
{
  const double           most = rated_pressure * drive.chain.pin_diameter * drive.chain.bush_length;
  drive::StiffnessCurves curves;
  curves.per_pitch = drive::fit_stiffness(
      {over_loads(
           [&](const unsigned int n) { return library.pulled_links(drive.chain, n); }, load, most)
           .of(0, 0.)},
      true);
  note = "Stiffness curves, tangents from the first touch to high loads in N/um: a pitch " +
         in_words(*curves.per_pitch, 0.);
  std::string of_teeth;
  for (const drive::Sprocket &sprocket : drive.sprockets)
    {
      if (sprocket.form.flat)
        {
          curves.roller_tooth.emplace_back();
          continue;
        }
      const double                   end = 1. - std::cos(seat_end(sprocket.form));
      std::vector<drive::Approaches> places;
      for (const double place : {0., end})
        {
          const OverLoads pressed = over_loads(
              [&](const unsigned int n) {
                return library.pressed_roller(
                    drive.chain, sprocket, drive.sprocket_width, n, std::acos(1. - place));
              },
              load,
              most);
          places.push_back(pressed.of(0, place));
          // the bush knows nothing of the tooth behind the roller
          if (drive.chain.has_rollers && !curves.roller_bush)
            {
              curves.roller_bush = drive::fit_stiffness({pressed.of(1, 0.)});
              note += ", roller and bush " + in_words(*curves.roller_bush, 0.);
            }
        }
      drive::StiffnessCurve curve = drive::fit_stiffness(places);
      curve.bottom                = 0.5 * sprocket.form.root_diameter;
      curve.unit                  = sprocket.form.seat_radius;
      curves.roller_tooth.push_back(curve);
      of_teeth += ", " + to_text(sprocket.form.teeth) + " teeth " + in_words(curve, 0.) +
                  " at the bottom of a gap, " + in_words(curve, end) + " at the end of the seat";
    }
  note += of_teeth + ".";
  return curves;
}
} // namespace chaindrive::statics
