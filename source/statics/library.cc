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
constexpr unsigned int version = 3;

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

std::string end_of_key(const Material &material, const double tolerance)
{
  return "; material" + numbers({material.youngs_modulus, material.poissons_ratio}) +
         "; tolerance" + numbers({tolerance}) + "; version " + std::to_string(version);
}

nlohmann::json to_json(const PieceFlexibility &result)
{
  nlohmann::json values = nlohmann::json::array();
  for (unsigned int i = 0; i < result.values.m(); ++i)
    for (unsigned int j = 0; j < result.values.n(); ++j)
      values.push_back(to_text(1e12 * result.values(i, j), 7)); // the same for any number of ranks
  return {{"cells", result.n_cells},
          {"unknowns", result.n_unknowns},
          {"error", to_text(result.error, 3)},
          {"um/MPa", values}};
}

double number_of(const nlohmann::json &text) { return std::stod(text.get<std::string>()); }

/// Of @p n patches.
Flexibility values_of(const nlohmann::json &json, const unsigned int n)
{
  Flexibility result(n, n);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      result(i, j) = 1e-12 * number_of(json.at("um/MPa").at(i * n + j));
  return result;
}

/// Whether a result says what it was solved with.
bool is_of_solution(const nlohmann::json &json)
{
  return json.at("cells").is_number_unsigned() && json.at("unknowns").is_number_unsigned() &&
         number_of(json.at("error")) >= 0.;
}

/// Whether a result is that of @p n patches, as to_json() writes it.
bool is_of_patches(const nlohmann::json &json, const unsigned int n)
{
  const nlohmann::json &values = json.at("um/MPa");
  return is_of_solution(json) && values.is_array() && values.size() == std::size_t(n) * n &&
         std::all_of(values.begin(), values.end(), [](const nlohmann::json &value) {
           return std::isfinite(number_of(value));
         });
}

Interface cylinders(const PatchGrid &grid, const double clearance)
{
  return {grid, [clearance](const double angle) { return clearance * (1. - std::cos(angle)); }};
}

} // namespace

Library::Library(const Material    &material,
                 const std::string &cache_folder,
                 const MPI_Comm     comm,
                 const Announce    &announce)
    : material_(material)
    , comm_(comm)
    , announce_(announce)
    , cache_(rank_in(comm) == 0 ? cache_folder : "")
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
  key += end_of_key(material_, tolerance);

  if (const auto known = known_.find(key); known != known_.end())
    return known->second;
  const nlohmann::json json = result_of(
      name,
      key,
      [n](const nlohmann::json &kept) { return is_of_patches(kept, n); },
      [&] { return to_json(statics::flexibility(make(), sides, material_, tolerance, comm_)); });
  return known_.emplace(key, values_of(json, n)).first->second;
}

nlohmann::json Library::result_of(const std::string                     &name,
                                  const std::string                     &key,
                                  const Cache::Fits                     &fits,
                                  const std::function<nlohmann::json()> &compute)
{
  // the first rank has the cache, all have the same answer
  std::string kept;
  if (const auto found = cache_.find(key, fits))
    kept = found->dump();
  if (n_ranks_in(comm_) > 1)
    kept = dealii::Utilities::MPI::broadcast(comm_, kept);
  const auto start  = std::chrono::steady_clock::now();
  const bool is_new = kept.empty();
  if (is_new)
    {
      if (announce_)
        announce_("Solving the " + name + ", whose solution is kept for later runs ...");
      const nlohmann::json json = compute();
      cache_.keep(key, json);
      kept = json.dump();
    }
  nlohmann::json                      result = nlohmann::json::parse(kept);
  const std::chrono::duration<double> time   = std::chrono::steady_clock::now() - start;
  entries_.push_back({name,
                      result.at("cells"),
                      result.at("unknowns"),
                      number_of(result.at("error")),
                      is_new ? time.count() : 0.});
  return result;
}

double seat_end(const drive::ToothForm &form)
{
  return std::max(0., form.seat_half_angle - patch_width);
}

ContactProblem Library::pulled_links(const drive::ChainDimensions &chain,
                                     const unsigned int            n_angles)
{
  const double    plate = chain.inner_plate_thickness, inside = 0.5 * (chain.bush_length - plate);
  const PatchGrid grid{
      0.5 * chain.pin_diameter,
      patch_width,
      n_angles,
      {0., inside / 3., 2. * inside / 3., inside, inside + 0.5 * plate, inside + plate}};
  const double      bush = 0.5 * chain.inner_hole_pitch, pin = 0.5 * chain.outer_hole_pitch;
  const std::string wide = n_angles > 4 ? ", wide contact" : "";
  std::vector<CompliantPart> parts;
  parts.push_back({"inner link",
                   0,
                   flexibility_of("inner link, pulled" + wide,
                                  text_of_chain(chain),
                                  [&] { return link_eighth(chain, true); },
                                  {{mesh::bush_bore_second, grid, Point<2>(bush, 0.), 0., true}})});
  parts.push_back(
      {"outer link",
       0,
       flexibility_of("outer link, pulled" + wide,
                      text_of_chain(chain),
                      [&] { return link_eighth(chain, false); },
                      {{mesh::pin_outside_second, grid, Point<2>(pin, 0.), PI, false}})});
  return ContactProblem({cylinders(grid, chain.pin_clearance())}, std::move(parts), material_);
}

ContactProblem Library::pressed_roller(const drive::ChainDimensions &chain,
                                       const drive::Sprocket        &sprocket,
                                       const double                  width,
                                       const unsigned int            n_angles,
                                       const double                  position)
{
  const double              half_width = 0.5 * std::min(chain.roller_length, width);
  const std::vector<double> z          = {0., half_width / 3., 2. * half_width / 3., half_width};
  const PatchGrid           outside{0.5 * chain.roller_diameter, patch_width, n_angles, z},
      inside{0.5 * chain.bush_diameter, patch_width, n_angles, z};
  const drive::Segment &seat = sprocket.form.half_profile.front();

  const PatchGrid           &on_bush = chain.has_rollers ? inside : outside;
  std::vector<CompliantPart> parts;
  if (chain.has_rollers)
    parts.push_back({"roller",
                     0,
                     flexibility_of("roller",
                                    text_of_chain(chain),
                                    [&] { return roller_quarter(chain); },
                                    {{mesh::roller_outside, outside, Point<2>(), 0., false},
                                     {mesh::roller_bore, inside, Point<2>(), 0., true}})});
  parts.push_back({"inner link",
                   chain.has_rollers ? outside.n() : 0,
                   flexibility_of("inner link, pressed",
                                  text_of_chain(chain),
                                  [&] { return link_quarter(chain); },
                                  {{mesh::bush_outside_second,
                                    on_bush,
                                    Point<2>(0.5 * chain.inner_hole_pitch, 0.),
                                    -0.5 * PI,
                                    false,
                                    true}})});

  // the rigid zone of a rim that has hardly any is made smaller, so that there is something to mesh
  const double root = sprocket.form.root_diameter,
               hub  = std::min(sprocket.hub_diameter, root - 0.4 * sprocket.form.pitch);
  const mesh::SprocketDimensions dimensions{std::min(sprocket.bore, 0.9 * hub), hub, width};
  std::string profile = numbers({double(sprocket.form.teeth), dimensions.hub_diameter, width});
  for (const drive::Segment &s : sprocket.form.half_profile)
    profile += numbers({s.begin[0], s.begin[1], s.end[0], s.end[1], s.radius});
  // A force beside the radius bends and shears the sector, whose ends are free: it has to be as
  // wide on either side as it is high.
  unsigned int n_sectors = 3;
  if (position != 0.)
    n_sectors = std::min(
        1 + 2 * static_cast<unsigned int>(std::ceil(0.5 * (root - hub) / sprocket.form.pitch)),
        (sprocket.form.teeth - 1) / 2 * 2 + 1);
  profile += "; sectors " + std::to_string(n_sectors);
  std::string name = "rim with " + std::to_string(sprocket.form.teeth) + " teeth";
  if (position != 0.)
    name += ", " + to_text(position * 180. / PI, 3) + " degrees off";
  parts.push_back(
      {"rim",
       0,
       flexibility_of(name,
                      profile,
                      [&] { return rim_sector(sprocket.form, dimensions, n_sectors); },
                      {{mesh::tooth_flanks, outside, seat.centre, PI - position, true, true}})});
  std::vector<Interface> interfaces = {cylinders(outside, seat.radius - outside.radius)};
  if (chain.has_rollers)
    interfaces.push_back(cylinders(inside, chain.roller_clearance()));
  return ContactProblem(std::move(interfaces), std::move(parts), material_);
}

PeakStress Library::pulled_plate(const drive::ChainDimensions &chain, const bool inner)
{
  constexpr double  accuracy = 0.02;
  const std::string name     = inner ? "inner plate" : "outer plate";
  const double      middle   = 0.5 * (inner ? chain.inner_hole_pitch : chain.outer_hole_pitch);
  const ElasticPiece::Patches load{
      {hole_side},
      1,
      [middle](const Point<3> &x) { return x[0] > middle ? 0U : ElasticPiece::Patches::none; },
      [middle](const Point<3> &x) {
        dealii::Tensor<1, 3> r;
        r[0] = x[0] - middle;
        r[1] = x[1];
        // like the cosine, of which the mean along x is 1/2
        return 2. * r[0] / r.norm_square() * r;
      }};
  const auto fits = [](const nlohmann::json &kept) {
    return is_of_solution(kept) && number_of(kept.at("1/mm2")) > 0.;
  };
  const nlohmann::json json =
      result_of(name, name + text_of_chain(chain) + end_of_key(material_, accuracy), fits, [&] {
        const PeakStress peak =
            peak_stress(plate_eighth(chain, inner), load, hole_side, material_, accuracy, comm_);
        return nlohmann::json{{"cells", peak.n_cells},
                              {"unknowns", peak.n_unknowns},
                              {"error", to_text(peak.error, 3)},
                              {"1/mm2", to_text(1e-6 * peak.per_force, 7)}};
      });
  PeakStress result;
  result.per_force  = 1e6 * number_of(json.at("1/mm2"));
  result.n_cells    = json.at("cells");
  result.n_unknowns = json.at("unknowns");
  result.error      = number_of(json.at("error"));
  return result;
}
} // namespace chaindrive::statics
