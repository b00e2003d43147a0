// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/drive/tooth_index.h>
#include <chaindrive/utilities/errors.h>
#include <chaindrive/utilities/random.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace chaindrive::drive
{
namespace
{
std::string tolerance_of(const parameters::Sprocket &wheel)
{
  return "Index tolerance in um = " + to_text(1e6 * wheel.index_tolerance);
}
} // namespace

std::vector<double> index_deviations(const parameters::Sprocket &wheel)
{
  const std::vector<double> &listed = wheel.index_deviations;
  if (listed.empty() && wheel.index_tolerance == 0.)
    return {};
  const std::string section = "Drive/Wheels/" + wheel.name + "/";
  const std::string entry   = section + (listed.empty() ? tolerance_of(wheel) :
                                                          "Index deviations in um, a list of " +
                                                            std::to_string(listed.size()) + ",");
  if (!listed.empty() && wheel.index_tolerance > 0.)
    throw InputError(entry + " and " + tolerance_of(wheel) +
                     " both say where the teeth stand; choose 0 for the tolerance, or no list.");
  if (!listed.empty() && wheel.teeth % listed.size() != 0)
    throw InputError(entry + " does not go into the " + std::to_string(wheel.teeth) +
                     " teeth a whole number of times; give one for each gap, or for a part of the "
                     "wheel that repeats.");
  if (!wheel.mesh.empty())
    throw InputError(entry + " is for teeth of arcs, but the " + wheel.in_words() +
                     " has the flanks of its mesh; choose 0 and no list.");
  std::seed_seq       seeds{wheel.index_seed, wheel.teeth};
  std::mt19937_64     generator(seeds);
  std::vector<double> deviations;
  for (unsigned int k = 0; k < wheel.teeth; ++k)
    deviations.push_back(listed.empty() ?
                             wheel.index_tolerance * (2. * even_random(generator) - 1.) :
                             listed[k % listed.size()]);
  return deviations;
}

std::string in_words(const std::string &title, const std::vector<double> &deviations)
{
  const auto [least, most] = std::minmax_element(deviations.begin(), deviations.end());
  double single            = 0.;
  for (std::size_t k = 0; k < deviations.size(); ++k)
    single = std::max(single, std::abs(deviations[(k + 1) % deviations.size()] - deviations[k]));
  return "Gaps of the " + title + " stand " + to_text(1e6 * *least, 4) + " to " +
         to_text(1e6 * *most, 4) + " um off their places, and neighbours up to " +
         to_text(1e6 * single, 4) + " um too near or too far.";
}
} // namespace chaindrive::drive
