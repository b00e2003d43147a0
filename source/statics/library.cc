// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/statics/library.h>
#include <chaindrive/statics/pieces.h>
#include <chaindrive/utilities/ranks.h>
#include <chaindrive/utilities/text.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace chaindrive::statics
{
namespace
{
using dealii::Point;
using dealii::numbers::PI;

/// Of what is kept: to be raised with every change that changes results.
constexpr unsigned int version = 1;

/// Of a flexibility. Stiffnesses of two parts with their contact are known four times as well: the
/// contact is much of them.
constexpr double tolerance = 0.02;

constexpr double patch_width = 2. * PI / n_around; // patches follow the cells

std::string numbers(const std::vector<double> &values)
{
  std::string text;
  for (const double value : values)
    text += " " + to_text(value, 12);
  return text;
}

/// All dimensions that the parts of a chain depend on.
std::string text_of_chain(const drive::ChainDimensions &c)
{
  return numbers({c.roller_diameter,
                  c.roller_bore,
                  c.roller_length,
                  c.bush_diameter,
                  c.bush_bore,
                  c.bush_length,
                  c.pin_diameter,
                  c.pin_bore,
                  c.pin_length,
                  c.inner_plate_height,
                  c.inner_plate_thickness,
                  c.outer_plate_height,
                  c.outer_plate_thickness,
                  c.waist_ratio,
                  c.inner_hole_pitch,
                  c.outer_hole_pitch});
}

nlohmann::json to_json(const PieceFlexibility &result)
{
  nlohmann::json values = nlohmann::json::array();
  for (unsigned int i = 0; i < result.values.m(); ++i)
    for (unsigned int j = 0; j < result.values.n(); ++j)
      values.push_back(to_text(1e12 * result.values(i, j), 7)); // the same for any number of ranks
  return {{"cells", result.n_cells}, {"error", to_text(result.error, 3)}, {"um/MPa", values}};
}

/// Of @p n patches. Throws what nlohmann::json throws for what it does not expect.
PieceFlexibility from_json(const nlohmann::json &json, const unsigned int n)
{
  PieceFlexibility result;
  result.n_cells = json.at("cells");
  result.error   = std::stod(json.at("error").get<std::string>());
  result.values.reinit(n, n);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      result.values(i, j) = 1e-12 * std::stod(json.at("um/MPa").at(i * n + j).get<std::string>());
  return result;
}

Interface cylinders(const PatchGrid &grid, const double clearance)
{
  return {grid, [clearance](const double angle) { return clearance * (1. - std::cos(angle)); }};
}

void add(Flexibility &sum, const Flexibility &part, const unsigned int first)
{
  for (unsigned int i = 0; i < part.m(); ++i)
    for (unsigned int j = 0; j < part.n(); ++j)
      sum(first + i, first + j) += part(i, j);
}
} // namespace

Library::Library(const Material &material, const std::string &cache_folder, const MPI_Comm comm)
    : material_(material), comm_(comm), cache_(rank_in(comm) == 0 ? cache_folder : "")
{
}

Flexibility Library::flexibility_of(const std::string            &name,
                                    const std::string            &geometry,
                                    const std::function<Piece()> &make,
                                    const std::vector<Side>      &sides)
{
  std::string  key = name + geometry;
  unsigned int n   = 0;
  for (const Side &side : sides)
    {
      n += side.grid.n();
      key += "; side " + std::to_string(side.id) + " of" +
             numbers({side.grid.radius, side.grid.width, double(side.grid.n_angles)}) + " at" +
             numbers(side.grid.z) + " about" + numbers({side.axis[0], side.axis[1], side.angle});
    }
  key += "; material" + numbers({material_.youngs_modulus, material_.poissons_ratio}) +
         "; tolerance" + numbers({tolerance}) + "; version " + std::to_string(version);

  if (const auto known = known_.find(key); known != known_.end())
    return known->second;

  // the first rank has the cache, all have the same answer
  std::string kept;
  if (const auto found = cache_.find(key))
    kept = found->dump();
  if (n_ranks_in(comm_) > 1)
    kept = dealii::Utilities::MPI::broadcast(comm_, kept);
  const auto start  = std::chrono::steady_clock::now();
  const bool is_new = kept.empty();
  if (is_new)
    {
      const nlohmann::json json =
          to_json(statics::flexibility(make(), sides, material_, tolerance, comm_));
      cache_.keep(key, json);
      kept = json.dump();
    }
  const PieceFlexibility              result = from_json(nlohmann::json::parse(kept), n);
  const std::chrono::duration<double> time   = std::chrono::steady_clock::now() - start;
  entries_.push_back({name, result.n_cells, result.error, is_new ? time.count() : 0.});
  known_.emplace(key, result.values);
  return result.values;
}

Press Library::pulled_links(const drive::ChainDimensions &chain, const unsigned int n_angles)
{
  const double    plate = chain.inner_plate_thickness, inside = 0.5 * (chain.bush_length - plate);
  const PatchGrid grid{
      0.5 * chain.pin_diameter,
      patch_width,
      n_angles,
      {0., inside / 3., 2. * inside / 3., inside, inside + 0.5 * plate, inside + plate}};
  const double bush = 0.5 * chain.inner_hole_pitch, pin = 0.5 * chain.outer_hole_pitch;
  Flexibility  both = flexibility_of("inner link, pulled",
                                    text_of_chain(chain),
                                    [&] { return link_eighth(chain, true); },
                                    {{mesh::bush_bore_second, grid, Point<2>(bush, 0.), 0., true}});
  add(both,
      flexibility_of("outer link, pulled",
                     text_of_chain(chain),
                     [&] { return link_eighth(chain, false); },
                     {{mesh::pin_outside_second, grid, Point<2>(pin, 0.), PI, false}}),
      0);
  return Press({cylinders(grid, chain.pin_clearance())}, both, material_);
}

Press Library::pressed_roller(const drive::ChainDimensions &chain,
                              const drive::Sprocket        &sprocket,
                              const double                  width,
                              const unsigned int            n_angles)
{
  const double              half_width = 0.5 * std::min(chain.roller_length, width);
  const std::vector<double> z          = {0., half_width / 3., 2. * half_width / 3., half_width};
  const PatchGrid           outside{0.5 * chain.roller_diameter, patch_width, n_angles, z},
      inside{0.5 * chain.bush_diameter, patch_width, n_angles, z};
  const drive::Segment &seat = sprocket.form.half_profile.front();

  Flexibility all = flexibility_of("roller",
                                   text_of_chain(chain),
                                   [&] { return roller_quarter(chain); },
                                   {{mesh::roller_outside, outside, Point<2>(), 0., false},
                                    {mesh::roller_bore, inside, Point<2>(), 0., true}});
  add(all,
      flexibility_of("inner link, pressed",
                     text_of_chain(chain),
                     [&] { return link_quarter(chain); },
                     {{mesh::bush_outside_second,
                       inside,
                       Point<2>(0.5 * chain.inner_hole_pitch, 0.),
                       -0.5 * PI,
                       false}}),
      outside.n());

  // the rigid zone of a rim that has hardly any is made smaller, so that there is something to mesh
  const double root = sprocket.form.root_diameter,
               hub  = std::min(sprocket.hub_diameter, root - 0.4 * sprocket.form.pitch);
  const mesh::SprocketShape shape{std::min(sprocket.bore, 0.9 * hub), hub, width};
  std::string profile = numbers({double(sprocket.form.teeth), shape.hub_diameter, width});
  for (const drive::Segment &s : sprocket.form.half_profile)
    profile += numbers({s.begin[0], s.begin[1], s.end[0], s.end[1], s.radius});
  add(all,
      flexibility_of("rim with " + std::to_string(sprocket.form.teeth) + " teeth",
                     profile,
                     [&] { return rim_sector(sprocket.form, shape); },
                     {{mesh::tooth_flanks, outside, seat.centre, PI, true}}),
      0);
  return Press({cylinders(outside, seat.radius - outside.radius),
                cylinders(inside, chain.roller_clearance())},
               all,
               material_);
}
} // namespace chaindrive::statics
