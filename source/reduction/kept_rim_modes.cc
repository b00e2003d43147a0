// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/reduction/kept_rim_modes.h>
#include <chaindrive/utilities/first_rank.h>
#include <chaindrive/utilities/ranks.h>
#include <chaindrive/utilities/text.h>
#include <chaindrive/version.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cstring>
#include <string>

namespace chaindrive::reduction
{
namespace
{
/// Of what is kept: to be raised with every change that changes results.
constexpr unsigned int version_of_rims = 1;

std::string key_of(const drive::ToothForm         &form,
                   const mesh::SprocketDimensions &dimensions,
                   const Material                 &material,
                   const double                    modes_up_to)
{
  std::string text = "modes of a rim of " + std::to_string(form.teeth) + " teeth; profile";
  const auto  add  = [&text](const double number) { text += " " + to_text(number, 12); };
  for (const drive::Segment &segment : form.half_profile)
    for (const double number : {segment.point(0.)[0],
                                segment.point(0.)[1],
                                segment.point(0.5)[0],
                                segment.point(0.5)[1],
                                segment.point(1.)[0],
                                segment.point(1.)[1]})
      add(number);
  text += "; bore, hub, width";
  for (const double number : {dimensions.bore, dimensions.hub_diameter, dimensions.width})
    add(number);
  text += "; material";
  for (const double number :
       {material.youngs_modulus, material.poissons_ratio, material.density, modes_up_to})
    add(number);
  return text + "; version " + std::to_string(version_of_rims) + " of " + chaindrive::version;
}

std::string rim_to_base64(const std::vector<double> &numbers)
{
  std::vector<unsigned char> bytes(numbers.size() * sizeof(double));
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return dealii::Utilities::encode_base64(bytes);
}

std::vector<double> rim_from_base64(const std::string &text)
{
  const std::vector<unsigned char> bytes = dealii::Utilities::decode_base64(text);
  std::vector<double>              numbers(bytes.size() / sizeof(double));
  std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(double));
  return numbers;
}

nlohmann::json rim_to_json(const RimModes &modes)
{
  return {{"teeth", modes.teeth},
          {"along", rim_to_base64(modes.along)},
          {"rad/s", rim_to_base64(modes.omega)},
          {"waves", modes.waves},
          {"cosine", rim_to_base64(modes.cosine)},
          {"sine", rim_to_base64(modes.sine)}};
}

RimModes rim_from_json(const nlohmann::json &json)
{
  RimModes modes;
  modes.teeth  = json.at("teeth");
  modes.along  = rim_from_base64(json.at("along"));
  modes.omega  = rim_from_base64(json.at("rad/s"));
  modes.waves  = json.at("waves").get<std::vector<unsigned int>>();
  modes.cosine = rim_from_base64(json.at("cosine"));
  modes.sine   = rim_from_base64(json.at("sine"));
  return modes;
}

/// Whether @p json is what rim_to_json() writes of a rim of so many @p teeth.
bool is_rim(const nlohmann::json &json, const unsigned int teeth)
{
  const RimModes    modes = rim_from_json(json);
  const std::size_t n     = 2 * std::size_t(modes.n_modes()) * modes.n_points();
  return modes.teeth == teeth && modes.n_points() >= 3 && modes.waves.size() == modes.n_modes() &&
         modes.cosine.size() == n && modes.sine.size() == n &&
         std::is_sorted(modes.along.begin(), modes.along.end()) &&
         std::all_of(modes.waves.begin(),
                     modes.waves.end(),
                     [teeth](const unsigned int k) { return 2 * k <= teeth; }) &&
         std::all_of(modes.omega.begin(), modes.omega.end(), [](const double w) { return w > 0.; });
}
} // namespace

RimModes kept_rim_modes(const drive::ToothForm         &form,
                        const mesh::SprocketDimensions &dimensions,
                        const Material                 &material,
                        const double                    modes_up_to,
                        statics::Cache                 &cache,
                        const MPI_Comm                  comm,
                        const Announce                 &announce)
{
  std::string kept;
  on_first_rank(comm, [&] {
    const std::string key = key_of(form, dimensions, material, modes_up_to);
    const auto fits = [&form](const nlohmann::json &json) { return is_rim(json, form.teeth); };
    if (const auto found = cache.find(key, fits))
      {
        kept = found->dump();
        return;
      }
    if (announce)
      announce("Finding the modes of a rim of " + std::to_string(form.teeth) +
               " teeth, which are kept for later runs ...");
    const nlohmann::json json =
        rim_to_json(make_rim_modes(form, dimensions, material, modes_up_to));
    cache.keep(key, json);
    kept = json.dump();
  });
  if (n_ranks_in(comm) > 1)
    kept = dealii::Utilities::MPI::broadcast(comm, kept);
  return rim_from_json(nlohmann::json::parse(kept));
}
} // namespace chaindrive::reduction
